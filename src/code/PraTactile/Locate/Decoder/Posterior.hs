{-# OPTIONS_HADDOCK hide #-}

-- | Locates patches by probabilities: from the probability of each symbol in each cell to the
-- posterior of each position, by Bayes' theorem. The patch is compared with every position, so this
-- is exact.
--
-- A cell's probabilities are those that a classifier gives on seeing its image, if all symbols in
-- all symmetries are equally frequent, independently of other cells. The prior of positions and
-- symmetries is uniform. So the posterior of a position in a symmetry is proportional to a product
-- over the observed cells. The factor of a cell is a joint probability: of the symmetry, and of the
-- symbol that the array then has in the cell.
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

-- | The posterior of each candidate, which is one of these symmetries and a position of the upright
-- patch's upper left cell, with a uniform prior. The patch is as seen. On the sheet, only
-- candidates for which all observed cells and the upright patch's upper left cell lie on it count.
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

-- | The candidate at an index into the totals of all comparisons, one comparison after the other.
candidateIn :: Int -> [(Symmetry, Comparison Double)] -> Candidate
candidateIn i comparisons = case comparisons of
  (o, compared) : others
    | i < size || null others -> Candidate o (comparedPosition compared i)
    | otherwise -> candidateIn (i - size) others
    where
      size = Primitive.length (comparedTotals compared)
  -- Without symmetries there are no indices.
  [] -> Candidate identity (Position 0 0)

-- | The posterior of each position of an upright patch's upper left cell, with a uniform prior. On
-- the sheet, only positions for which that cell and all observed cells lie on it count.
posterior :: Codebook k -> Patch (Belief k) -> Posterior Position
posterior codebook observed = ranked (comparedPosition comparison) (comparedTotals comparison)
  where
    comparison = likelihoods codebook identity (observedCells observed)

-- | The log-likelihood of each position of a patch in a symmetry, up to a constant. Each belief
-- comes with its cell's offset in the upright patch: after the symmetry is undone.
likelihoods :: Codebook k -> Symmetry -> [(Position, Belief k)] -> Comparison Double
likelihoods codebook o known =
  compareWith codebook [(offset, Primitive.map log (probabilitiesIn o b)) | (offset, b) <- known]

-- | The posterior of places, given by their indices, from the log-likelihood of each up to a common
-- constant. The prior is uniform.
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
        -- Indices are sorted, not places, and the likely ones apart from the rest: there may be a
        -- million places.
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
--
-- Several equally probable places are ambiguous if the probability of all others is at most the
-- tolerated one: 'AmbiguousMany' if only their number is known, or else 'Ambiguous'. Otherwise the
-- reason is 'Contradiction' if no place is possible, or else 'BelowThreshold'.
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
