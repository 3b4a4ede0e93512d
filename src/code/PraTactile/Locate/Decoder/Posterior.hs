{-# OPTIONS_HADDOCK hide #-}

-- | Locating from probabilities: how likely each symbol is in each cell is given, and what follows
-- is how likely each position is (Bayes' theorem). Exact: the patch is compared with every
-- position.
--
-- A cell's probabilities are those that a classifier gives on seeing its image when all symbols, in
-- all symmetries, are equally frequent, independently of other cells'; all positions in all
-- symmetries are equally likely beforehand. Then the probability of a position in a symmetry is
-- proportional to the product of the probabilities of the symbols that it would have in the
-- observed cells, together with that symmetry.
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

-- | How likely each position of the codebook is in each of these symmetries, all of them being
-- equally likely beforehand; on the sheet those with which all observed cells lie on it.
posteriorAmong :: Codebook k -> [Symmetry] -> Patch (Belief k) -> Posterior Candidate
posteriorAmong codebook possible observed = case comparisons of
  [(o, only)] -> ranked (Candidate o . comparedPosition only) (comparedTotals only)
  _ ->
    ranked (`candidateIn` comparisons) (Primitive.concat (map (comparedTotals . snd) comparisons))
  where
    -- In every symmetry the cells are added up in the same order, so that what is equally likely is
    -- found equal.
    comparisons = [(o, likelihoods codebook o (seenCells o)) | o <- possible]
    seenCells o =
      [ (onPosition (invert o) (patchShape observed) offset, b)
        | (offset, b) <- observedCells observed
      ]

-- | The candidate at an index of the sums of all comparisons, one after the other.
candidateIn :: Int -> [(Symmetry, Comparison Double)] -> Candidate
candidateIn i comparisons = case comparisons of
  (o, compared) : others
    | i < size || null others -> Candidate o (comparedPosition compared i)
    | otherwise -> candidateIn (i - size) others
    where
      size = Primitive.length (comparedTotals compared)
  -- Without symmetries there are no indices.
  [] -> Candidate identity (Position 0 0)

-- | How likely each position of the codebook is; on the sheet those at which all observed cells lie
-- on it.
posterior :: Codebook k -> Patch (Belief k) -> Posterior Position
posterior codebook observed = ranked (comparedPosition comparison) (comparedTotals comparison)
  where
    comparison = likelihoods codebook identity (observedCells observed)

-- | The logarithms of what the probabilities of positions in a symmetry are proportional to, given
-- what is known of cells by their offsets in the upright patch.
likelihoods :: Codebook k -> Symmetry -> [(Position, Belief k)] -> Comparison Double
likelihoods codebook o known =
  compareWith codebook [(offset, Primitive.map log (probabilitiesIn o b)) | (offset, b) <- known]

-- | How likely places are, given by their indices, from the logarithms of what their probabilities
-- are proportional to.
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
    -- Relative to the best one, so that products of many small numbers do not vanish.
    relative = Primitive.map (\x -> exp (x - best)) logs
    others = Primitive.sum (Primitive.imap (\i x -> if i == bestIndex then 0 else x) relative)
    less = Primitive.sum (Primitive.zipWith (\x y -> if x == best then 0 else y) logs relative)
    equal = [i | (i, x) <- zip [0 ..] (Primitive.toList logs), x == best]
    likeliestFirst i j = compare (relative Primitive.! j) (relative Primitive.! i)
    next = Primitive.maximum (Primitive.imap (\i x -> if i == bestIndex then -1 / 0 else x) logs)

-- | @decide tolerated found@: the likeliest place, if the probability that it is another one is at
-- most as large as tolerated; then of many answers at most that share is wrong, if the
-- probabilities are honest. Several places equally likely, of which the same holds jointly, are
-- ambiguous. Else 'BelowThreshold'; 'Contradiction' where no place is possible.
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
