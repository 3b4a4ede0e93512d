{-# OPTIONS_HADDOCK hide #-}

-- | The one way from a question to its answer: the patches are joined to one, as
-- "PraTactile.Locate.Joint" has it; in each symmetry in which it may be seen, its upright form goes
-- to the decoder that "PraTactile.Locate.Decoder" chooses; and what these decide is combined, as
-- "PraTactile.Locate.Decision" has it. Patches and symmetries are handled here alone, the same for
-- all decoders.
module PraTactile.Locate.Locator
  ( Locator,
    locator,
    locatorUpTo,
    withListing,
    locatorArray,
    locatorMask,
    cellsDistance,
    locate,
    decoderFor,
    decoderOfProbabilities,
    agreedSymbols,
    LocatorError (..),
  )
where

import Control.Applicative ((<|>))
import Data.Bifunctor (first)
import Data.List (nub)
import qualified Data.Set as Set
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (extentOf)
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Chance
import PraTactile.Locate.Checks
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder
import PraTactile.Locate.Decoder.Codebook (observedDistance)
import PraTactile.Locate.Decoder.Posterior
import PraTactile.Locate.Joint
import PraTactile.Locate.Patch
import PraTactile.Locate.Query
import PraTactile.Locate.Separation (candidateDistance)
import PraTactile.Locate.Weighing
import PraTactile.Symmetry

-- | Where the patches of a question are. If any cell has probabilities, all cells are taken as
-- probabilities. Refuses what the decoder that is asked for cannot do, and where there is none. The
-- costs are those of the decoder, as "PraTactile.Locate" has them.
locate :: KnownField k => Locator k -> Query k -> Either LocatorError Answer
locate theLocator asked
  | null (querySymmetries asked) = Left NoSymmetry
  | otherwise = case traverse (traverse (traverse symbolOf)) (queryPatches query) of
    Just given | not (decodesProbabilities theLocator) -> locateSymbols theLocator query given
    _ -> locateBeliefs theLocator query (map (fmap (fmap cellBelief)) (queryPatches query))
  where
    query = asked {querySymmetries = nub (querySymmetries asked)}

-- | The symbol of a cell, if it is known.
symbolOf :: Cell k -> Maybe (GF k)
symbolOf cell = case cell of
  Symbol a -> Just a
  Probabilities _ -> Nothing

-- | Which decoder answers questions about symbols with this radius; refused where none does. Makes
-- the codebook or the table, if that is the one, once.
decoderFor :: KnownField k => Locator k -> Radius -> Either LocatorError DecoderName
decoderFor theLocator stated = symbolName <$> symbolDecoder theLocator stated

-- | Which decoder answers questions about probabilities, likewise.
decoderOfProbabilities :: KnownField k => Locator k -> Either LocatorError DecoderName
decoderOfProbabilities theLocator = beliefName <$> beliefDecoder theLocator 0

-- | The minimum distance of the cells with these offsets in an upright patch: in how many of them
-- any two positions differ at least, on the array's 'naturalSurface' and the sheet; 0 for no cells,
-- and where no distance is promised. With a codebook O(cells of the array * offsets).
cellsDistance :: KnownField k => Locator k -> [Position] -> Known
cellsDistance theLocator offsets = case locatorCodebook theLocator of
  Right codebook -> Exactly (observedDistance codebook offsets)
  Left _ ->
    AtLeast
      (candidateDistance (locatorArray theLocator) [identity] (extentOf offsets) offsets)

-- | The observed symbols of a question in the rectangle around its patches, without those in
-- dispute; of probabilities none.
agreedSymbols :: Query k -> Either LocatorError (Patch (GF k))
agreedSymbols query =
  first
    LocatorPatch
    (jointPatch <$> joint agreedSymbol [(at, symbols p) | (at, p) <- queryPatches query])
  where
    symbols p =
      patchOf
        (patchShape p)
        [(offset, a) | (offset, cell) <- observedCells p, Just a <- [symbolOf cell]]

-- | Symbols, of which some may be wrong.
locateSymbols ::
  KnownField k =>
  Locator k ->
  Query k ->
  [((Integer, Integer), Patch (GF k))] ->
  Either LocatorError Answer
locateSymbols theLocator query given = do
  joined <- first LocatorPatch (joint agreedSymbol given)
  decoder <- symbolDecoder theLocator (queryRadius query)
  let seen = jointPatch joined
  decision <- decideIn decoder query seen
  let alien = foreignSymbolsAt theLocator query seen (decisionOutcome decision)
      outcome
        | any ((> queryDoubt query) . doubtOfForeign) alien = Refused BelowThreshold
        | otherwise = decisionOutcome decision
      distances = decisionDistances decision
      share = chance . correcting (atLeast (codeDistance distances)) (correctionRadius distances)
  pure
    Answer
      { answerOutcome = outcome,
        answerDecoder = symbolName decoder,
        answerDistances = Just distances,
        answerPosterior = Nothing,
        answerDoubts = PlaceDoubts Nothing <$> alien,
        answerEvidence = Nothing,
        answerChance =
          (if windowless decoder seen then atMost else id) . share
            <$> spheresOf theLocator query seen,
        answerChecks =
          checksGiven
            theLocator
            joined
            (observedOffsets seen)
            (likelySymmetry query (decisionOutcome decision)),
        answerPatches =
          patchVerdicts
            (symbolsBelong theLocator query decoder (patchShape seen))
            joined
            (only outcome),
        answerDisputed = jointDisputed joined
      }
  where
    -- The table knows complete windows only.
    windowless decoder seen =
      symbolName decoder == TableDecoder
        && or
          [ null (completeWindows (locatorMask theLocator) (uprightAs o seen))
            | o <- querySymmetries query
          ]

-- | What the code has checked among cells of which the patches are the sources, if these are seen
-- in this symmetry.
checksGiven ::
  KnownField k => Locator k -> Joint a -> [Position] -> Maybe Symmetry -> Maybe Checks
checksGiven theLocator joined cells seenAs = do
  o <- seenAs
  let upright = onPosition (invert o) (patchShape (jointPatch joined))
  checksAmong
    (locatorArray theLocator)
    [ [upright offset | (offset, _) <- part, offset `Set.member` known]
      | part <- jointParts joined
    ]
  where
    known = Set.fromList cells

-- | The symmetry of all candidates that are left, or the only one that was asked for.
likelySymmetry :: Query k -> Outcome Candidate -> Maybe Symmetry
likelySymmetry query outcome = case (nub (map candidateSymmetry left), querySymmetries query) of
  ([o], _) -> Just o
  (_, [o]) -> Just o
  _ -> Nothing
  where
    left = case outcome of
      Unique candidate _ -> [candidate]
      Ambiguous several _ -> several
      _ -> []

-- | When symbols belong to the others of a patch of this shape.
symbolsBelong ::
  KnownField k => Locator k -> Query k -> SymbolDecoder k -> Shape -> Belonging (GF k)
symbolsBelong theLocator query decoder shape =
  Belonging
    { wrongAt = wrong,
      belongsAt = \candidate cells ->
        fromIntegral (length (filter (wrong candidate) cells))
          <= symbolOwnRadius decoder (map (uprightOffset candidate shape . fst) cells),
      credible = either (const Nothing) promised . decideIn decoder query
    }
  where
    wrong candidate (offset, a) =
      symbolAt (locatorArray theLocator) shape candidate offset /= Just a

-- | Decode a patch in each of the symmetries of the question. 'Guaranteed' is half of the least
-- distance between any two candidates, which several symmetries make smaller, often 0: then only
-- exact agreement is answered.
decideIn ::
  SymbolDecoder k -> Query k -> Patch (GF k) -> Either LocatorError (Decision Candidate)
decideIn decoder query seen
  | null (observedCells seen) = Right (nowhereDecision (radiusFor (queryRadius query) 0))
  | otherwise = case symbolDistance decoder (querySymmetries query) seen of
    Just d -> do
      let radius = radiusFor (queryRadius query) (atLeast d)
      overSymmetries d radius <$> inEach (UpTo radius)
    Nothing -> do
      found <- inEach (queryRadius query)
      -- One symmetry, whose decision has its own distance.
      let own = [decisionDistances decision | (_, _, decision) <- take 1 found]
          d = foldr (const . codeDistance) (Exactly 0) own
      pure (overSymmetries d (sum (map correctionRadius own)) found)
  where
    inEach radius = traverse (decideAs radius) (querySymmetries query)
    decideAs radius o =
      let upright = uprightAs o seen
       in (,,) o (patchShape upright) <$> symbolDecide decoder radius upright

-- | The candidate, if there is only one.
only :: Outcome place -> Maybe place
only outcome = case outcome of
  Unique place _ -> Just place
  _ -> Nothing

-- | The only candidate, if it is within the guaranteed radius.
promised :: Decision place -> Maybe place
promised decision
  | maybe False ((<= guaranteed) . atLeast) (nearestDistance distances) =
    only (decisionOutcome decision)
  | otherwise = Nothing
  where
    distances = decisionDistances decision
    guaranteed = guaranteedRadius (atLeast (codeDistance distances))

-- | Probabilities: those of the same cell are multiplied and made to add up to 1, as independent
-- looks at it.
locateBeliefs ::
  KnownField k =>
  Locator k ->
  Query k ->
  [((Integer, Integer), Patch (Belief k))] ->
  Either LocatorError Answer
locateBeliefs theLocator query given = do
  joined <- first LocatorPatch (joint combined given)
  decoder <- beliefDecoder theLocator (queryDoubt query)
  let seen = jointPatch joined
      certain = [offset | (offset, b) <- observedCells seen, isCertain b]
  (alien, speaking, found) <- weighedPosterior theLocator query decoder (querySymmetries query) seen
  let outcome = outcomeOf query seen found
  pure
    Answer
      { answerOutcome = outcome,
        answerDecoder = beliefName decoder,
        answerDistances = Nothing,
        answerPosterior = Just found,
        answerDoubts = alien,
        answerEvidence = speaking,
        -- Only a cell that leaves no doubt keeps out a position.
        answerChance =
          chance . amongCells (fromIntegral (length certain)) <$> spheresOf theLocator query seen,
        answerChecks =
          checksGiven
            theLocator
            joined
            certain
            ((candidateSymmetry <$> posteriorBest found) <|> likelySymmetry query outcome),
        answerPatches =
          patchVerdicts
            (beliefsBelong theLocator query decoder (patchShape seen))
            joined
            (only outcome),
        answerDisputed = jointDisputed joined
      }

-- | When probabilities belong to the others of a patch of this shape.
beliefsBelong ::
  KnownField k => Locator k -> Query k -> BeliefDecoder k -> Shape -> Belonging (Belief k)
beliefsBelong theLocator query decoder shape =
  Belonging
    { wrongAt = \candidate (offset, b) ->
        let shown = likeliestIn (candidateSymmetry candidate) b
         in null shown || symbolIn candidate offset /= shown,
      belongsAt = \candidate cells ->
        all (allowed candidate) cells
          && maybe
            True
            (allows candidate)
            (decided [candidateSymmetry candidate] (patchOf shape cells)),
      credible = \seen -> decided (querySymmetries query) seen >>= only
    }
  where
    symbolIn = symbolAt (locatorArray theLocator) shape
    allowed candidate (offset, b) =
      any (\a -> possibleIn (candidateSymmetry candidate) a b) (symbolIn candidate offset)
    decided possible seen =
      either
        (const Nothing)
        (\(_, _, found) -> Just (outcomeOf query seen found))
        (weighedPosterior theLocator query decoder possible seen)

-- | What the probabilities of candidates come to, with the doubt that the question tolerates.
outcomeOf :: Query k -> Patch (Belief k) -> Posterior Candidate -> Outcome Candidate
outcomeOf query seen found
  | null (observedCells seen) = Refused TooFewCells
  | otherwise = decide (queryDoubt query) found

-- | Whether an outcome leaves a candidate possible.
allows :: Candidate -> Outcome Candidate -> Bool
allows candidate outcome = case outcome of
  Unique place _ -> place == candidate
  Ambiguous places _ -> candidate `elem` places
  _ -> True
