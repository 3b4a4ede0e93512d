{-# OPTIONS_HADDOCK hide #-}

-- | Locates patches by probabilities: from the probability of each symbol in each cell to the
-- posterior of each position, by Bayes' theorem. The patch is compared with every position, so this
-- is exact.
--
-- A cell's probabilities are those that a classifier gives on seeing its image, with all symbols in
-- all symmetries equally frequent, independently of other cells. The prior of positions and
-- symmetries is uniform. So the posterior of a position in a symmetry is proportional to a product
-- over the observed cells: the probability of the symbol that the cell would hold, jointly with the
-- symmetry.
module PraTactile.Locate.Decoder.Posterior
  ( posterior,
    posteriorAmong,
    likelihoods,
    ranked,
    decide,
  )
where

import Data.List (sortBy)
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Grid
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Patch
import PraTactile.Symmetry

-- | The posterior of each position of the codebook in each of these symmetries, with a uniform
-- prior. On the sheet, only candidates with all observed cells on it count.
posteriorAmong :: Codebook k -> [Symmetry] -> Patch (Belief k) -> Posterior Candidate
posteriorAmong codebook possible observed = case comparisons of
  [(o, only)] -> ranked (Candidate o . comparedPosition only) (comparedTotals only)
  _ ->
    ranked (`candidateIn` comparisons) (Primitive.concat (map (comparedTotals . snd) comparisons))
  where
    -- Every symmetry sums the cells in the same order, so that equal probabilities compare equal.
    comparisons = [(o, likelihoods codebook o (seenCells o)) | o <- possible]
    seenCells o =
      [ (onPosition (invert o) (patchShape observed) offset, b)
        | (offset, b) <- observedCells observed
      ]

-- | The candidate at an index into the concatenated totals of all comparisons.
candidateIn :: Int -> [(Symmetry, Comparison Double)] -> Candidate
candidateIn i comparisons = case comparisons of
  (o, compared) : others
    | i < size || null others -> Candidate o (comparedPosition compared i)
    | otherwise -> candidateIn (i - size) others
    where
      size = Primitive.length (comparedTotals compared)
  -- Without symmetries there are no indices.
  [] -> Candidate identity (Position 0 0)

-- | The posterior of each position of the codebook. On the sheet, only positions with all observed
-- cells on it count.
posterior :: Codebook k -> Patch (Belief k) -> Posterior Position
posterior codebook observed = ranked (comparedPosition comparison) (comparedTotals comparison)
  where
    comparison = likelihoods codebook identity (observedCells observed)

-- | The log-likelihood of each position in a symmetry, up to a constant. Beliefs about cells are
-- given by their offsets in the upright patch.
likelihoods :: Codebook k -> Symmetry -> [(Position, Belief k)] -> Comparison Double
likelihoods codebook o known =
  compareWith codebook [(offset, Primitive.map log (probabilitiesIn o b)) | (offset, b) <- known]

-- | The posterior of places, given by their indices, from their log-likelihoods up to a constant.
ranked :: (Int -> place) -> Primitive.Vector Double -> Posterior place
ranked placeAt logs
  | count == 0 || isInfinite best = impossible
  | otherwise =
    Posterior
      { posteriorBest = Just (placeAt bestIndex),
        posteriorDoubt = others / (1 + others),
        posteriorEqual = map placeAt equal,
        posteriorMany = Nothing,
        posteriorEqualDoubt = less / (fromIntegral (length equal) + less),
        posteriorMargin = if count == 1 then Nothing else Just (best - next),
        -- By their indices, and the likely ones first: there may be a million places.
        posteriorRanking =
          [ (placeAt i, (relative Primitive.! i) / (1 + others))
            | few <- [(>= 1e-60), (< 1e-60)],
              i <- sortBy likeliestFirst (filter (few . (relative Primitive.!)) [0 .. count - 1])
          ],
        posteriorUnlisted = Nothing,
        posteriorWords = 0
      }
  where
    count = Primitive.length logs
    bestIndex = Primitive.maxIndex logs
    best = logs Primitive.! bestIndex
    -- Relative to the best one, so that products of many small numbers do not underflow.
    relative = Primitive.map (\x -> exp (x - best)) logs
    others = Primitive.sum (Primitive.imap (\i x -> if i == bestIndex then 0 else x) relative)
    less = Primitive.sum (Primitive.zipWith (\x y -> if x == best then 0 else y) logs relative)
    equal = [i | (i, x) <- zip [0 ..] (Primitive.toList logs), x == best]
    likeliestFirst i j = compare (relative Primitive.! j) (relative Primitive.! i)
    next = Primitive.maximum (Primitive.imap (\i x -> if i == bestIndex then -1 / 0 else x) logs)

-- | @decide tolerated found@ is the likeliest place, if the probability of all others is at most
-- the tolerated one. If the probabilities are calibrated, at most that share of answers is wrong.
-- Several equally probable places that meet the condition together are ambiguous. Otherwise the
-- reason is 'BelowThreshold', or 'Contradiction' if no place is possible.
decide :: Double -> Posterior place -> Outcome place
decide tolerated found
  | Just place <- posteriorBest found, posteriorDoubt found <= tolerated = Unique place []
  | posteriorEqualDoubt found <= tolerated,
    Just (count, dimension) <-
      posteriorMany found =
    AmbiguousMany count dimension
  | posteriorEqualDoubt found <= tolerated,
    several@(_ : _ : _) <-
      posteriorEqual found =
    Ambiguous several []
  | Nothing <-
      posteriorBest found,
    Nothing <- posteriorMany found,
    maybe True (== 0) (posteriorUnlisted found) =
    Refused Contradiction
  | otherwise = Refused BelowThreshold
