{-# OPTIONS_HADDOCK hide #-}

-- | The probability that a patch was not taken from this array at all.
--
-- The model has these parts. Foreign things are random in half of the cases: every symmetry and
-- every content of the cells is equally probable. In the other half they are another array
-- ('OtherArrays'), in every symmetry and at every position with equal probability; that likelihood
-- is bounded from above. Under the array itself, every symmetry and position is equally probable
-- too. A cell then has its own probability, except that one cell in a hundred is misleading
-- ('misleading'): damaged, soiled, or wrongly made. Bayes' theorem with the prior of foreign things
-- gives the probabilities.
--
-- The query may state how much more probable its observations are under other symbols than the
-- array's. Then there is a third kind of foreign things, as frequent as the other two together.
-- What other symbols are read as is random.
module PraTactile.Locate.Foreign
  ( ForeignComparison (..),
    foreignChances,
    evidence,
    foreignByChance,
    misleading,
    withForeign,
  )
where

import Data.Maybe (isNothing)
import Numeric.Natural (Natural)
import PraTactile.Locate.Answer
import PraTactile.Locate.Logarithm

-- | The quantities by which observed cells are compared with foreign ones.
data ForeignComparison = ForeignComparison
  { -- | the prior probability of being foreign, below 1
    foreignShare :: Double,
    -- | the number of symbols
    foreignSymbols :: Int,
    -- | the number of places in all symmetries
    foreignPlaces :: Natural,
    -- | the probability in each observed cell of the array's symbol at the likeliest place, given
    -- the symmetry there
    foreignExpected :: [Double],
    -- | the log-probability of the likeliest place among all places; with many equal ones it may be
    -- too small for a Double
    foreignLikeliest :: Double,
    -- | the log-ratio of the probability that the cells give the symmetry there to the mean over
    -- all symmetries; 0 if the cells do not show it
    foreignSymmetry :: Double,
    -- | an upper bound on the log-likelihood of another array, summed over symmetries and
    -- positions, relative to the mean probability of the symmetries; 'Nothing' if there is no other
    -- array
    foreignOthers :: Maybe Double,
    -- | the log-likelihood ratio of other symbols than the array's to the array's; minus infinity
    -- if that is not weighed
    foreignShape :: Double
  }
  deriving stock (Eq, Show)

-- | The share of random ones among foreign things, if there are other arrays.
foreignByChance :: Double
foreignByChance = 0.5

-- | The probabilities that observed cells are foreign, by kind.
--
-- Four certain cells leave the prior unchanged, because nearly every content of such a window
-- occurs in the array. Nine do not:
--
-- >>> let comparison cells = ForeignComparison 0.005 4 255 cells 0 0 Nothing (-1 / 0)
-- >>> let chances = foreignChances . comparison
-- >>> round (1000 * doubtOfRandom (chances [1, 1, 1, 1]))
-- 5
-- >>> doubtOfRandom (chances (replicate 9 1)) < 1e-5
-- True
foreignChances :: ForeignComparison -> ForeignDoubts
foreignChances comparison
  | share <= 0 = ForeignDoubts 0 0 alone 0
  | otherwise = ForeignDoubts (part byChance) (part byOthers) alone (part byShapes)
  where
    share = foreignShare comparison
    byChance = log (share * random) + contents
    byShapes = log share + contents + foreignShape comparison
    contents = contentsByChance comparison
    alone = isNothing (foreignOthers comparison)
    random = if alone then 1 else foreignByChance
    byOthers = maybe (-1 / 0) ofOthers (foreignOthers comparison)
    ofOthers worth =
      log (share * (1 - foreignByChance)) + worth - naturalLogarithm (foreignPlaces comparison)
    ours = log (1 - share) + contents + evidence comparison
    -- What is impossible has probability 0, whatever the others are.
    part one'
      | isInfinite one' = 0
      | otherwise = 1 / sum [exp (other - one') | other <- [ours, byChance, byOthers, byShapes]]

-- | The log-probability of observed cells under uniformly random symbols.
contentsByChance :: ForeignComparison -> Double
contentsByChance comparison =
  negate (fromIntegral (length (foreignExpected comparison)))
    * log (fromIntegral (foreignSymbols comparison))

-- | The log-likelihood ratio of the observed cells being the array's, at any place, to their being
-- random. It contains no prior of either.
--
-- >>> let comparison cells = ForeignComparison 0.005 4 255 cells 0 0 Nothing (-1 / 0)
-- >>> round (evidence (comparison (replicate 9 1)))
-- 7
evidence :: ForeignComparison -> Double
evidence comparison =
  sum (map seen (foreignExpected comparison))
    + foreignSymmetry comparison
    - foreignLikeliest comparison
    - naturalLogarithm (foreignPlaces comparison)
    - contentsByChance comparison
  where
    seen chance = log ((1 - misleading) * chance + misleading / q)
    q = fromIntegral (foreignSymbols comparison)

-- | The share of misleading symbols, in comparisons of the array's with foreign ones.
misleading :: Double
misleading = 0.01

-- | A posterior after every place is wrong with this additional probability.
withForeign :: Double -> Posterior place -> Posterior place
withForeign alien found =
  found
    { posteriorDoubt = orForeign (posteriorDoubt found),
      posteriorEqualDoubt = orForeign (posteriorEqualDoubt found),
      posteriorRanking = [(place, ours * chance) | (place, chance) <- posteriorRanking found],
      posteriorUnlisted = (ours *) <$> posteriorUnlisted found
    }
  where
    ours = 1 - alien
    orForeign doubt = alien + ours * doubt
