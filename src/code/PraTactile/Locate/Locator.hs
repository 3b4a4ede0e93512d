-- | The one way from a question to its answer: the patches are joined to one, as
-- "PraTactile.Locate.Joint" has it; in each symmetry in which it may be seen, its upright form goes
-- to the decoder that "PraTactile.Locate.Decoder" chooses; and what these decide is combined, as
-- "PraTactile.Locate.Decision" has it. Patches and symmetries are handled here alone, the same for
-- all decoders.
module PraTactile.Locate.Locator
  ( Locator,
    locator,
    locatorArray,
    locatorMask,
    cellsDistance,
    locate,
    decoderFor,
    agreedSymbols,
    LocatorError (..),
  )
where

import Control.Applicative ((<|>))
import Data.Bifunctor (first)
import Data.List (nub)
import qualified Data.Set as Set
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (displaced, extentOf)
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Chance
import PraTactile.Locate.Checks
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder
import PraTactile.Locate.Decoder.Codebook (observedDistance)
import PraTactile.Locate.Decoder.Posterior
import PraTactile.Locate.Foreign
import PraTactile.Locate.Joint
import PraTactile.Locate.Logarithm
import PraTactile.Locate.OtherArrays
import PraTactile.Locate.Patch
import PraTactile.Locate.Query
import PraTactile.Locate.Separation (candidateDistance)
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
  (alien, found) <- weighedPosterior theLocator query decoder (querySymmetries query) seen
  let outcome = outcomeOf query seen found
  pure
    Answer
      { answerOutcome = outcome,
        answerDecoder = beliefName decoder,
        answerDistances = Nothing,
        answerPosterior = Just found,
        answerDoubts = alien,
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
        (Just . outcomeOf query seen . snd)
        (weighedPosterior theLocator query decoder possible seen)

-- | How likely candidates are in these symmetries, and what makes them wrong if the question weighs
-- that it may be foreign. Where candidates are unlisted, the listed ones alone speak for the array.
weighedPosterior ::
  KnownField k =>
  Locator k ->
  Query k ->
  BeliefDecoder k ->
  [Symmetry] ->
  Patch (Belief k) ->
  Either LocatorError (Maybe PlaceDoubts, Posterior Candidate)
weighedPosterior theLocator query decoder possible seen = do
  found <- beliefPosterior decoder possible seen
  let symbolIn = symbolAt (locatorArray theLocator) (patchShape seen)
      chanceAt candidate (offset, b) =
        let o = candidateSymmetry candidate
            given a = probabilitiesIn o b Primitive.! toCode a / symmetryChance o b
         in maybe 0 given (symbolIn candidate offset)
      alien = do
        best <- posteriorBest found
        foreignGiven
          theLocator
          query {querySymmetries = possible}
          seen
          Expected
            { expectedChances = map (chanceAt best) (observedCells seen),
              expectedSymmetry =
                shownSymmetry possible (map snd (observedCells seen)) (candidateSymmetry best),
              expectedLikeliest =
                maybe (log (1 - posteriorDoubt found)) (const 0) (posteriorUnlisted found),
              expectedShown =
                sum [log (symmetryChance (candidateSymmetry best) b) | (_, b) <- observedCells seen]
            }
      doubts p = PlaceDoubts (Just ((1 - doubtOfForeign p) * posteriorDoubt found)) p
  pure (doubts <$> alien, maybe found ((`weighed` found) . doubtOfForeign) alien)

-- | The probabilities that symbols which are located so are foreign, if the question weighs that.
foreignSymbolsAt ::
  KnownField k =>
  Locator k ->
  Query k ->
  Patch (GF k) ->
  Outcome Candidate ->
  Maybe ForeignDoubts
foreignSymbolsAt theLocator query seen outcome = do
  (expected, count) <- case outcome of
    Unique candidate _ -> Just (map (chanceAt candidate) (observedCells seen), 1)
    Ambiguous candidates@(first' : _) _ ->
      Just (map (chanceAt first') (observedCells seen), fromIntegral (length candidates))
    AmbiguousMany count _ -> Just (map (const 1) (observedCells seen), count)
    _ -> Nothing
  foreignGiven
    theLocator
    query
    (fmap certainly seen)
    (Expected expected 0 (negate (naturalLogarithm count)) 0)
  where
    chanceAt candidate (offset, a) = if symbolIn candidate offset == Just a then 1 else 0
    symbolIn = symbolAt (locatorArray theLocator) (patchShape seen)

-- | The logarithm of how probable cells make a symmetry, as many times as the mean of all that are
-- possible; 0 where none shows how it lies.
shownSymmetry :: [Symmetry] -> [Belief k] -> Symmetry -> Double
shownSymmetry possible cells o = negate (log (sum (map relative possible) / count))
  where
    relative other = exp (shown other - shown o)
    shown one' = sum (map (log . symmetryChance one') cells)
    count = fromIntegral (length possible)

-- | What the likeliest candidate is compared with foreign things by: as 'ForeignComparison' has it.
data Expected = Expected
  { expectedChances :: [Double],
    expectedSymmetry :: Double,
    expectedLikeliest :: Double,
    -- | the logarithm of how probable the cells make the symmetry there
    expectedShown :: Double
  }

-- | The probabilities that a patch is foreign, if the question weighs that.
foreignGiven ::
  KnownField k => Locator k -> Query k -> Patch (Belief k) -> Expected -> Maybe ForeignDoubts
foreignGiven theLocator query seen expected = do
  share <- queryForeign query
  places <- sphereCentres <$> spheresOf theLocator query seen
  Just $
    foreignChances
      ForeignComparison
        { foreignShare = share,
          foreignSymbols = fieldOrder (arrayItself (locatorArray theLocator)),
          foreignPlaces = places,
          foreignExpected = expectedChances expected,
          foreignLikeliest = expectedLikeliest expected,
          foreignSymmetry = expectedSymmetry expected,
          foreignOthers =
            relativeTo (expectedShown expected - expectedSymmetry expected) $
              worthOfOthers (locatorOthers theLocator) (querySymmetries query) seen
        }
  where
    relativeTo mean worth = case worth of
      NoOthers -> NoOthers
      WorthExactly w -> WorthExactly (w - mean)
      WorthAtMost w -> WorthAtMost (w - mean)

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

-- | The candidates of a patch as spheres of radius 0; 'Nothing' where no cell was observed.
spheresOf :: KnownField k => Locator k -> Query k -> Patch a -> Maybe Spheres
spheresOf theLocator query seen =
  spheres
    (locatorArray theLocator)
    (querySymmetries query)
    (patchShape seen)
    (observedOffsets seen)

-- | Where a cell of a patch of this shape is in the upright patch, if the candidate is right.
uprightOffset :: Candidate -> Shape -> Position -> Position
uprightOffset candidate = onPosition (invert (candidateSymmetry candidate))

-- | The array's symbol in a cell of a patch of this shape, as it is seen, if the candidate is
-- right; 'Nothing' beyond the sheet.
symbolAt ::
  KnownField k =>
  ArrayOn k ->
  Shape ->
  Candidate ->
  Position ->
  Maybe (GF k)
symbolAt (ArrayOn surface array) shape candidate offset =
  cellAt array
    <$> displaced
      surface
      (arrayShape array)
      (candidatePosition candidate)
      (uprightOffset candidate shape offset)
