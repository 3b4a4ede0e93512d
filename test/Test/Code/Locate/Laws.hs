-- | When what a decoder answers is what the definition says.
module Test.Code.Locate.Laws (asDefined, alike, asPromised, asBayes, asSymbols) where

import Data.List (sort, transpose)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Definition
import PraTactile.Locate.Patch (completeWindows, patchOf, uprightAs)
import PraTactile.Locate.Separation
import PraTactile.Symmetry
import PraTactile.Window (maskOffsets)
import Test.Code.Generators
import Test.Code.Locate.Asking
import Test.QuickCheck hiding (elements)

-- | All that an answer says of symbols holds of the comparison with all candidates.
asDefined ::
  KnownField k =>
  Maybe DecoderName ->
  On k ->
  [Symmetry] ->
  Radius ->
  Patches (GF k) ->
  Property
asDefined decoder on@(surface, array, window) asked radius patches =
  case ask decoder on asked radius 0 (symbolsOf patches) of
    -- Where cells that depend on each other leave a coset.
    Left (LocatorDecoding (DecodingTooMany _)) -> property (area (arrayShape array) > 1024)
    answered -> whenRight answered $ \answer ->
      counterexample (show answer) $
        conjoin
          [ answerDisputed answer === [at | (at, several) <- looks, not (agree several)],
            map patchWrong (answerPatches answer)
              === [(`wrongIn` cells) <$> only (answerOutcome answer) | cells <- partsOf patches],
            maybe (property False) (holdOf (answerOutcome answer)) (answerDistances answer),
            case answerOutcome answer of
              Unique candidate support -> support === agreeingWindows candidate
              _ -> property True
          ]
  where
    (shape, looks) = looksByDefinition patches
    agree several = and (zipWith (==) several (drop 1 several))
    known = [(at, a) | (at, several@(a : _)) <- looks, agree several]
    together = patchOf shape known
    -- The table knows complete windows only, and so the symmetries in which a window is complete.
    possible =
      [ o
        | o <- asked,
          decoder /= Just TableDecoder
            || not (null (completeWindows window (uprightAs o together)))
      ]
    every = differencesByDefinition (ArrayOn surface array) possible together
    wrongIn candidate cells =
      length [() | at <- fromMaybe [] (lookup candidate every), at `elem` cells]
    only found = case found of
      Unique candidate _ -> Just candidate
      _ -> Nothing
    windows = [map snd (completeWindows window (uprightAs o together)) | o <- asked]
    -- The complete windows without a wrong cell, each by its upper left cell as it is seen.
    agreeingWindows candidate =
      sort
        [ seenAt corner
          | (corner, _) <- completeWindows window upright,
            all ((`notElem` wrong) . seenAt . from corner) (maskOffsets window)
        ]
      where
        o = candidateSymmetry candidate
        upright = uprightAs o together
        seenAt = onPosition o (patchShape upright)
        from (Position i j) (Position i' j') = Position (i + i') (j + j')
        wrong = fromMaybe [] (lookup candidate every)
    holdOf found distances =
      conjoin
        [ property
            ( radius /= Guaranteed
                || correctionRadius distances <= guaranteedRadius (atLeast (codeDistance distances))
            ),
          property
            ( length asked > 1 || null known
                || distanceHolds
                  decoder
                  (candidateDistance (ArrayOn surface array) asked shape (map fst known))
                  (codeDistance distances)
            ),
          if null known
            then found === Refused TooFewCells
            else outcomeHolds decoder (map snd known) windows every found distances
        ]

-- | The minimum distance: exactly, or as much as is known of it.
distanceHolds :: Maybe DecoderName -> Natural -> Known -> Bool
distanceHolds decoder d known
  | correctsNothing decoder = atLeast known <= d
  | otherwise = known == Exactly d

correctsNothing :: Maybe DecoderName -> Bool
correctsNothing = (`elem` map Just [TableDecoder, AlgebraDecoder, SearchDecoder])

-- | An outcome and its distances, given the observed symbols, the contents of their complete
-- windows in each symmetry, and all candidates with the cells that differ there.
outcomeHolds ::
  Maybe DecoderName ->
  [GF k] ->
  [[[GF k]]] ->
  [(Candidate, [Position])] ->
  Outcome Candidate ->
  Distances ->
  Property
outcomeHolds decoder symbols windows every found distances =
  conjoin
    [ case found of
        Unique candidate _ ->
          conjoin
            [ property reached,
              best === [candidate],
              Just (corrected distances) === fmap sort (lookup candidate every)
            ]
        Ambiguous candidates _ ->
          conjoin [property (reached && length best > 1), candidates === best]
        AmbiguousMany count _ ->
          property (reached && length best > 1 && count >= max 1025 (fromIntegral (length best)))
        Refused why -> counterexample (show counts) (not reached && refuses why),
      holdsOf least (nearestDistance distances) (correctsNothing decoder),
      holdsOf next (runnerUpDistance distances) (correctsNothing decoder || beyond)
    ]
  where
    counts = sort [count | (_, count) <- counted]
    counted = [(candidate, fromIntegral (length wrong) :: Natural) | (candidate, wrong) <- every]
    least = take 1 counts
    next = take 1 (drop 1 counts)
    best = [candidate | (candidate, count) <- counted, [count] == least]
    radius = correctionRadius distances
    reached = any (<= radius) least
    beyond = nearestDistance distances == Just (AtLeast (radius + 1))
    nearZeros = fromIntegral (length (filter (/= zero) symbols)) <= radius
    refuses why = case why of
      TooFewCells -> False
      BelowThreshold -> False
      NoCompleteWindow -> decoder == Just TableDecoder
      BeyondRadius -> radius > 0 && not nearZeros
      -- Where nothing may be corrected, zeros in every complete window are enough.
      ZeroWindow ->
        nearZeros
          || radius == 0 && any (\inOne -> not (null inOne) && all (all (== zero)) inOne) windows
      _ -> radius == 0
    -- What is said of a number is so, or is as much as is known.
    holdsOf true said unknown = case said of
      Just (Exactly e) -> true === [e]
      Just (AtLeast e) ->
        property (all (>= e) true && decoder `notElem` [Nothing, Just NearestDecoder])
      Nothing -> property (null true || unknown)

-- | The observed cells of each patch in the rectangle around all.
partsOf :: Patches a -> [[Position]]
partsOf patches =
  [ [ Position (i + fromInteger (r - top)) (j + fromInteger (c - left))
      | (Position i j, _) <- observedCells p
    ]
    | ((r, c), p) <- patches
  ]
  where
    top = minimum [r | ((r, _), _) <- patches]
    left = minimum [c | ((_, c), _) <- patches]

-- | The decoders that correct wrong cells have the same outcome, wrong cells and radius; so have
-- those that correct none, and the others if they may not; of one symmetry the table, too, wherever
-- it knows a window.
alike ::
  KnownField k =>
  On k ->
  [Symmetry] ->
  Radius ->
  Patches (GF k) ->
  Property
alike on possible radius patches =
  conjoin
    [ found radius InformationSetDecoder === found radius NearestDecoder,
      exactly AlgebraDecoder === exactly SearchDecoder,
      exactly NearestDecoder === exactly SearchDecoder,
      case exactly TableDecoder of
        Right (Refused NoCompleteWindow) -> property True
        byTable
          | length possible > 1 -> property True
          | otherwise -> byTable === exactly SearchDecoder
    ]
  where
    found allowed decoder =
      (\answer -> (answerOutcome answer, about <$> answerDistances answer))
        <$> ask (Just decoder) on possible allowed 0 (symbolsOf patches)
    about distances = (corrected distances, correctionRadius distances)
    exactly = fmap fst . found (UpTo 0)

-- | Where a patch is, how it is seen, and which of its cells are wrong.
asPromised ::
  KnownField k =>
  DecoderName ->
  On k ->
  [Symmetry] ->
  Candidate ->
  [Position] ->
  Patch (GF k) ->
  Property
asPromised decoder on possible truth wrong seen =
  whenRight (ask (Just decoder) on possible Guaranteed 0 (symbolsOf (alone seen))) $ \answer ->
    counterexample (show answer) $ case answerOutcome answer of
      Unique found _ ->
        (found, corrected <$> answerDistances answer) === (truth, Just (sort wrong))
      Ambiguous found _ ->
        (codeDistance <$> answerDistances answer) `elem` [Just (Exactly 0), Just (AtLeast 0)]
          .&&. truth `elem` found
      _ -> property (null (observedCells seen))

-- | All that an answer says of probabilities holds of Bayes' theorem.
asBayes ::
  KnownField k =>
  Maybe DecoderName ->
  On k ->
  [Symmetry] ->
  Double ->
  Patches (Belief k) ->
  Property
asBayes decoder on@(surface, array, _) possible tolerated patches =
  whenRight (ask decoder on possible Guaranteed tolerated beliefs) $ \answer ->
    counterexample (show answer {answerPosterior = Nothing}) $
      case answerPosterior answer of
        -- Where nothing was observed, nothing says that it would have been probabilities.
        Nothing ->
          answerOutcome answer === if null looks then Refused TooFewCells else Refused Contradiction
        Just found ->
          answerDisputed answer === [at | (at, several) <- looks, disputed several]
            .&&. if null known
              then answerOutcome answer === Refused TooFewCells
              else bayesHolds exact tolerated found (answerOutcome answer)
  where
    beliefs = map (fmap (fmap Probabilities)) patches
    (shape, looks) = looksByDefinition patches
    disputed several =
      and
        [ all ((== 0) . product) (transpose (map (Primitive.toList . probabilitiesIn o) several))
          | o <- symmetries
        ]
    known = [(at, b) | (at, several) <- looks, not (disputed several), b <- several]
    exact = posteriorByDefinition (ArrayOn surface array) possible shape known

-- | Probabilities that leave no doubt have the outcome of symbols, but for support and reason.
asSymbols ::
  KnownField k => DecoderName -> On k -> [Symmetry] -> Patches (GF k) -> Property
asSymbols decoder on possible patches =
  fmap answerOutcome (asked decoder (Probabilities . certainly))
    `same` fmap answerOutcome (asked SearchDecoder Symbol)
  where
    asked name cell = ask (Just name) on possible (UpTo 0) 0 (map (fmap (fmap cell)) patches)
    same soft hard = case (soft, hard) of
      (Right (AmbiguousMany count _), Right (Ambiguous places _)) ->
        property (fromIntegral (length places) <= count)
      _ -> fmap plain soft === fmap plain hard
    plain outcome = case outcome of
      Unique place _ -> ([place], True)
      Ambiguous places _ -> (places, True)
      Refused why -> ([], why /= TooFewCells)
      AmbiguousMany _ _ -> ([], False)
