-- | What the decoders of symbols find, as the tests compare it.
module Test.Code.Decided
  ( decisionWrong,
    decisionNearest,
    decisionRunnerUp,
    decisionDistance,
    decisionRadius,
    knownNearest,
    knownRunnerUp,
    knownDistance,
    listUpright,

    -- * By the one question
    ask,
    nearestIn,
    boundedIn,
    searchIn,
    posteriorIn,
    nearestJoint,
    posteriorJoint,
    jointDecision,
    jointPosterior,
    jointOffsets,
    jointWrong,
    jointInconsistent,
  )
where

import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field (GF, KnownField)
import PraTactile.Locate
import PraTactile.Locate.Decision (Decision (..))
import PraTactile.Locate.Decoder.Algebra (Algebra, algebraArray, algebraMask, algebraSurface)
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.List (listPatch)
import PraTactile.Symmetry
import PraTactile.Window (Mask, Packing (..))

decisionWrong :: Decision place -> [Position]
decisionWrong = corrected . decisionDistances

decisionNearest, decisionRunnerUp :: Decision place -> Maybe Natural
decisionNearest = fmap atLeast . nearestDistance . decisionDistances
decisionRunnerUp = fmap atLeast . knownRunnerUp

decisionDistance, decisionRadius :: Decision place -> Natural
decisionDistance = atLeast . knownDistance
decisionRadius = correctionRadius . decisionDistances

-- | As much of it as is proved.
knownNearest, knownDistance :: Decision place -> Known
knownNearest = fromMaybe (AtLeast 0) . nearestDistance . decisionDistances
knownDistance = codeDistance . decisionDistances

knownRunnerUp :: Decision place -> Maybe Known
knownRunnerUp = runnerUpDistance . decisionDistances

-- | The list of an upright patch.
listUpright ::
  KnownField k =>
  Int ->
  Double ->
  Algebra k ->
  Patch (Belief k) ->
  Either AlgebraError (Posterior Position)
listUpright most tolerated algebra p =
  fmap candidatePosition <$> listPatch most tolerated algebra [identity] p

-- | The answer of a decoder, on a surface, about patches in these symmetries, of which so many
-- cells may be wrong, or this doubt is tolerated.
ask ::
  KnownField k =>
  Maybe DecoderName ->
  (Surface, PseudorandomArray k, Mask) ->
  [Symmetry] ->
  Radius ->
  Double ->
  [((Integer, Integer), Patch (Cell k))] ->
  Either LocatorError Answer
ask decoder (surface, array, mask) possible radius tolerated given =
  locate
    (locator decoder MostSignificantFirst array mask)
    (Query given possible surface radius tolerated)

alone :: Patch a -> [((Integer, Integer), Patch a)]
alone p = [((0, 0), p)]

ofBook :: Codebook k -> (Surface, PseudorandomArray k, Mask)
ofBook shelf = (codebookSurface shelf, codebookArray shelf, codebookMask shelf)

symbols :: [((Integer, Integer), Patch (GF k))] -> [((Integer, Integer), Patch (Cell k))]
symbols = map (fmap (fmap Symbol))

-- | A patch of symbols by the codebook; an error is a refusal for which it has no reason.
nearestIn ::
  KnownField k =>
  Codebook k ->
  [Symmetry] ->
  Radius ->
  Patch (GF k) ->
  Decision Candidate
nearestIn shelf possible radius p =
  either
    (const (Decision (Refused BelowThreshold) (Distances [] Nothing Nothing (Exactly 0) 0)))
    jointDecision
    (nearestJoint shelf possible radius (alone p))

-- | By information sets.
boundedIn ::
  KnownField k =>
  Algebra k ->
  [Symmetry] ->
  Radius ->
  Patch (GF k) ->
  Either LocatorError (Decision Candidate)
boundedIn algebra possible radius p =
  jointDecision
    <$> ask
      (Just InformationSetDecoder)
      (algebraSurface algebra, algebraArray algebra, algebraMask algebra)
      possible
      radius
      0
      (symbols (alone p))

-- | By the definition.
searchIn ::
  KnownField k =>
  Codebook k ->
  [Symmetry] ->
  Patch (GF k) ->
  Either LocatorError (Outcome Candidate)
searchIn shelf possible p =
  answerOutcome
    <$> ask (Just SearchDecoder) (ofBook shelf) possible Guaranteed 0 (symbols (alone p))

-- | A patch of probabilities by the codebook.
posteriorIn :: KnownField k => Codebook k -> [Symmetry] -> Patch (Belief k) -> Posterior Candidate
posteriorIn shelf possible p =
  either
    (const (Posterior Nothing 0 [] Nothing 0 Nothing [] Nothing 0))
    jointPosterior
    (posteriorJoint shelf possible 0 (alone p))

-- | Several patches of symbols by the codebook.
nearestJoint ::
  KnownField k =>
  Codebook k ->
  [Symmetry] ->
  Radius ->
  [((Integer, Integer), Patch (GF k))] ->
  Either LocatorError Answer
nearestJoint shelf possible radius =
  ask (Just NearestDecoder) (ofBook shelf) possible radius 0 . symbols

-- | And of probabilities.
posteriorJoint ::
  KnownField k =>
  Codebook k ->
  [Symmetry] ->
  Double ->
  [((Integer, Integer), Patch (Belief k))] ->
  Either LocatorError Answer
posteriorJoint shelf possible tolerated =
  ask (Just PosteriorDecoder) (ofBook shelf) possible Guaranteed tolerated
    . map (fmap (fmap Probabilities))

jointDecision :: Answer -> Decision Candidate
jointDecision answer =
  Decision
    (answerOutcome answer)
    (fromMaybe (Distances [] Nothing Nothing (Exactly 0) 0) (answerDistances answer))

jointPosterior :: Answer -> Posterior Candidate
jointPosterior = fromMaybe (Posterior Nothing 1 [] Nothing 1 Nothing [] Nothing 0) . answerPosterior

jointOffsets :: Answer -> [Position]
jointOffsets = map patchOffset . answerPatches

jointWrong :: Answer -> [Int]
jointWrong = map (fromMaybe 0 . patchWrong) . answerPatches

-- | The indices, from 0, of the patches that do not belong.
jointInconsistent :: Answer -> [Int]
jointInconsistent answer =
  [i | (i, verdict) <- zip [0 ..] (answerPatches answer), patchInconsistent verdict]
