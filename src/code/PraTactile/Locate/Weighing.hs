{-# OPTIONS_HADDOCK hide #-}

-- | Weighs the candidates of a patch against the patch being foreign ("PraTactile.Locate.Foreign").
module PraTactile.Locate.Weighing
  ( -- * Candidates weighed
    weighedPosterior,
    foreignSymbolsAt,

    -- * Candidates
    spheresOf,
    uprightOffset,
    symbolAt,
  )
where

import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (displaced)
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Chance
import PraTactile.Locate.Decoder
import PraTactile.Locate.Foreign
import PraTactile.Locate.Logarithm
import PraTactile.Locate.OtherArrays
import PraTactile.Locate.Patch
import PraTactile.Locate.Prior
import PraTactile.Locate.Query
import PraTactile.Symmetry

-- | The posterior of candidates in these symmetries. Before it come the doubts, if the query weighs
-- that the patch may be foreign, and the 'evidence' for the array, if any candidate is possible. If
-- candidates are unlisted, only the listed ones count for the array.
weighedPosterior ::
  KnownField k =>
  Locator k ->
  Query k ->
  BeliefDecoder k ->
  [Symmetry] ->
  Patch (Belief k) ->
  Either LocatorError (Maybe PlaceDoubts, Maybe Double, Posterior Candidate)
weighedPosterior theLocator query decoder possible seen = do
  byCells <- beliefPosterior decoder possible seen
  let symbolIn = symbolAt (locatorArray theLocator) (patchShape seen)
      prior = fromMaybe (const uniformPrior) (queryPrior query)
      weight candidate =
        priorWeight (symbolIn candidate) seen candidate (prior candidate)
      found = maybe id (const (reweighed weight)) (queryPrior query) byCells
      asked = query {querySymmetries = possible}
      compared = posteriorBest found >>= comparedAt theLocator asked prior found seen
      alien = foreignChances <$> (queryForeign query *> compared)
      doubts p = PlaceDoubts (Just ((1 - doubtOfForeign p) * posteriorDoubt found)) p
  pure
    ( doubts <$> alien,
      evidence <$> compared,
      maybe found ((`withForeign` found) . doubtOfForeign) alien
    )

-- | The probabilities that symbols with this outcome are foreign, if the query weighs that.
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
  places <- queryForeign query *> spheresOf theLocator query seen
  pure . foreignChances $
    comparedWith
      theLocator
      query
      places
      (fmap certainly seen)
      (Expected expected 0 (negate (naturalLogarithm count)) 0)
  where
    chanceAt candidate (offset, a) = if symbolIn candidate offset == Just a then 1 else 0
    symbolIn = symbolAt (locatorArray theLocator) (patchShape seen)

-- | The log-ratio of the probability that cells give a symmetry to the mean over all possible ones;
-- 0 if no cell shows its symmetry.
shownSymmetry :: [Symmetry] -> [Belief k] -> Symmetry -> Double
shownSymmetry possible cells o = negate (log (sum (map relative possible) / count))
  where
    relative other = exp (shown other - shown o)
    shown one' = sum (map (log . symmetryChance one') cells)
    count = fromIntegral (length possible)

-- | The comparison of a patch with foreign things. The arguments are the array; the query; the
-- candidates' priors; their posterior; the patch as seen; and the likeliest candidate. 'Nothing' if
-- no cell was observed.
comparedAt ::
  KnownField k =>
  Locator k ->
  Query k ->
  (Candidate -> CandidatePrior) ->
  Posterior Candidate ->
  Patch (Belief k) ->
  Candidate ->
  Maybe ForeignComparison
comparedAt theLocator query prior found seen best = do
  places <- spheresOf theLocator query seen
  pure $
    comparedWith
      theLocator
      query
      places
      speaking
      Expected
        { expectedChances = map chanceAt (observedCells speaking),
          expectedSymmetry =
            shownSymmetry (querySymmetries query) (map snd (observedCells speaking)) o,
          expectedLikeliest =
            maybe (log (1 - posteriorDoubt found)) (const 0) (posteriorUnlisted found),
          expectedShown = sum [log (symmetryChance o b) | (_, b) <- observedCells speaking]
        }
  where
    o = candidateSymmetry best
    speaking = withoutCells (candidateSilent (prior best)) seen
    chanceAt (offset, b) =
      let given a = probabilitiesIn o b Primitive.! toCode a / symmetryChance o b
       in maybe 0 given (symbolAt (locatorArray theLocator) (patchShape seen) best offset)

-- | The quantities of the likeliest candidate that 'ForeignComparison' needs.
data Expected = Expected
  { expectedChances :: [Double],
    expectedSymmetry :: Double,
    expectedLikeliest :: Double,
    -- | the log-probability that the cells give the symmetry there
    expectedShown :: Double
  }

-- | The comparison of a patch with foreign things, given its candidates.
comparedWith ::
  KnownField k =>
  Locator k ->
  Query k ->
  Spheres ->
  Patch (Belief k) ->
  Expected ->
  ForeignComparison
comparedWith theLocator query candidates seen expected =
  ForeignComparison
    { foreignShare = fromMaybe 0 (queryForeign query),
      foreignSymbols = fieldOrder (arrayItself (locatorArray theLocator)),
      foreignPlaces = sphereCentres candidates,
      foreignExpected = expectedChances expected,
      foreignLikeliest = expectedLikeliest expected,
      foreignSymmetry = expectedSymmetry expected,
      foreignOthers =
        subtract (expectedShown expected - expectedSymmetry expected)
          <$> evidenceOfOthers (locatorOthers theLocator) (querySymmetries query) seen,
      foreignShape = queryForeignShape query
    }

-- | The candidates of a patch as spheres of radius 0; 'Nothing' if no cell was observed.
spheresOf :: KnownField k => Locator k -> Query k -> Patch a -> Maybe Spheres
spheresOf theLocator query seen =
  spheres
    (locatorArray theLocator)
    (querySymmetries query)
    (patchShape seen)
    (observedOffsets seen)

-- | The offset in the upright patch of a cell of a patch with this shape, if the candidate is
-- right.
uprightOffset :: Candidate -> Shape -> Position -> Position
uprightOffset candidate = onPosition (invert (candidateSymmetry candidate))

-- | The array's symbol in a cell of a patch with this shape, as seen, if the candidate is right;
-- 'Nothing' beyond the sheet.
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
