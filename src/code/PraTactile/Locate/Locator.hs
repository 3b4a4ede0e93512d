{-# OPTIONS_HADDOCK hide #-}

-- | From a query to its answer. "PraTactile.Locate.Joint" joins the patches into one. That patch is
-- set upright for each queried symmetry, and goes to the decoder that "PraTactile.Locate.Decoder"
-- chooses. "PraTactile.Locate.Decision" combines the decisions of several symmetries. Only this
-- module handles patches and symmetries, in the same way for all decoders.
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

-- | Answers a query. If any cell has probabilities, or if the requested decoder treats symbols as
-- probabilities, all cells are treated as probabilities. Refuses what the requested decoder cannot
-- do, arrays without a decoder, and a query without symmetries ('NoSymmetry'). The costs are those
-- of the decoder, listed in "PraTactile.Locate".
locate :: KnownField k => Locator k -> Query k -> Either LocatorError Answer
locate theLocator asked
  | null (querySymmetries asked) = Left NoSymmetry
  | otherwise = case traverse (traverse (traverse symbolOf)) (queryPatches query) of
    Just given | not (decodesProbabilities theLocator) -> locateSymbols theLocator query given
    _ -> locateBeliefs theLocator query (map (fmap (fmap cellBelief)) (queryPatches query))
  where
    query = asked {querySymmetries = nub (querySymmetries asked)}

-- | The symbol of a cell; 'Nothing' for probabilities.
symbolOf :: Cell k -> Maybe (GF k)
symbolOf cell = case cell of
  Symbol a -> Just a
  Probabilities _ -> Nothing

-- | The decoder that answers queries about symbols with this radius. Refuses if there is none. If
-- it needs the codebook or the table, that is computed, once.
decoderFor :: KnownField k => Locator k -> Radius -> Either LocatorError DecoderName
decoderFor theLocator stated = symbolName <$> symbolDecoder theLocator stated

-- | The decoder that answers queries about probabilities. Refuses if there is none. If it needs the
-- codebook, that is computed, once.
decoderOfProbabilities :: KnownField k => Locator k -> Either LocatorError DecoderName
decoderOfProbabilities theLocator = beliefName <$> beliefDecoder theLocator 0

-- | The minimum distance of the cells with these offsets in an upright patch: the least number of
-- them in which two positions differ, on the array's 'naturalSurface' and the sheet. 0 for no
-- cells, and if no distance is guaranteed. With a codebook it takes O(cells of the array *
-- offsets).
cellsDistance :: KnownField k => Locator k -> [Position] -> Known
cellsDistance theLocator offsets = case locatorCodebook theLocator of
  Right codebook -> Exactly (observedDistance codebook offsets)
  Left _ ->
    AtLeast
      (candidateDistance (locatorArray theLocator) [identity] (extentOf offsets) offsets)

-- | The observed symbols of a query in the rectangle around its patches. Left out are cells with
-- probabilities, and disputed cells: those that two patches show with different symbols.
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

-- | Locates symbols, some of which may be wrong.
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
    -- The table uses complete windows only.
    windowless decoder seen =
      symbolName decoder == TableDecoder
        && or
          [ null (completeWindows (locatorMask theLocator) (uprightAs o seen))
            | o <- querySymmetries query
          ]

-- | The parity checks among cells, with the patches as sources, if the patches are seen in this
-- symmetry.
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

-- | The common symmetry of all remaining candidates, or the only one in the query.
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

-- | How to decide whether the symbols of one patch belong to the other patches. The shape is that
-- of the rectangle around all patches.
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

-- | Decodes a patch in each symmetry of the query. 'Guaranteed' is less than half the minimum
-- distance between any two candidates. Several symmetries make that distance smaller, often 0; then
-- only exact agreement is an answer.
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
      -- A single symmetry, whose decision has its own distance.
      let own = [decisionDistances decision | (_, _, decision) <- take 1 found]
          d = foldr (const . codeDistance) (Exactly 0) own
      pure (overSymmetries d (sum (map correctionRadius own)) found)
  where
    inEach radius = traverse (decideAs radius) (querySymmetries query)
    decideAs radius o =
      let upright = uprightAs o seen
       in (,,) o (patchShape upright) <$> symbolDecide decoder radius upright

-- | The place, if there is only one.
only :: Outcome place -> Maybe place
only outcome = case outcome of
  Unique place _ -> Just place
  _ -> Nothing

-- | The only place, if it is within the guaranteed radius.
promised :: Decision place -> Maybe place
promised decision
  | maybe False ((<= guaranteed) . atLeast) (nearestDistance distances) =
    only (decisionOutcome decision)
  | otherwise = Nothing
  where
    distances = decisionDistances decision
    guaranteed = guaranteedRadius (atLeast (codeDistance distances))

-- | Locates probabilities. Several observations of a cell count as independent: their probabilities
-- are multiplied and normalised.
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
        -- Only a cell without doubt excludes a position.
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

-- | How to decide whether the probabilities of one patch belong to the other patches. The shape is
-- that of the rectangle around all patches.
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

-- | The outcome of a posterior with the query's tolerated doubt.
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
