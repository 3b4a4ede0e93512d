-- | That a patch is nothing of the array's: the doubt that no comparison of positions has.
--
-- Of what is foreign every symmetry is taken to be equally likely, and in it every content, each
-- cell by itself; of what is the array's every symmetry and every position, and there each cell has
-- its probability, but for one cell in a hundred, which is not what it seems ('misleading'):
-- damaged, soiled, or wrongly made. Bayes' theorem with the share of foreign things does the rest.
module PraTactile.Locate.Foreign
  ( ForeignComparison (..),
    foreignChance,
    misleading,
    weighed,
  )
where

import Numeric.Natural (Natural)
import PraTactile.Locate.Answer
import PraTactile.Locate.Logarithm

-- | What observed cells are compared with foreign ones by.
data ForeignComparison = ForeignComparison
  { -- | the probability beforehand that it is foreign, below 1
    foreignShare :: Double,
    -- | how many symbols there are
    foreignSymbols :: Int,
    -- | how many places there are, in all symmetries
    foreignPlaces :: Natural,
    -- | how probable the array's symbol at the likeliest place is in each observed cell, given the
    -- symmetry there
    foreignExpected :: [Double],
    -- | the logarithm of the probability that, among the places, it is the likeliest one: of many
    -- alike that may be too small for a double
    foreignLikeliest :: Double,
    -- | the logarithm of how many times as probable the cells make the symmetry there as the mean
    -- of all: 0 where they do not show how they lie
    foreignSymmetry :: Double
  }
  deriving stock (Eq, Show)

-- | The probability that observed cells are foreign.
--
-- Four cells beyond doubt, which nearly every content of a window is, leave what was believed
-- beforehand; nine do not:
--
-- >>> round (1000 * foreignChance (ForeignComparison 0.005 4 255 [1, 1, 1, 1] 0 0))
-- 5
-- >>> foreignChance (ForeignComparison 0.005 4 255 (replicate 9 1) 0 0) < 1e-5
-- True
foreignChance :: ForeignComparison -> Double
foreignChance (ForeignComparison share symbols places expected likeliest shown)
  | share <= 0 = 0
  | otherwise = 1 / (1 + exp (ours - theirs))
  where
    q = fromIntegral symbols :: Double
    theirs = log share - fromIntegral (length expected) * log q
    ours =
      log (1 - share) + sum (map seen expected)
        + shown
        - likeliest
        - naturalLogarithm places
    seen chance = log ((1 - misleading) * chance + misleading / q)

-- | The share of symbols that are not what they seem, where the array's are compared with foreign
-- ones.
misleading :: Double
misleading = 0.01

-- | How likely places are where all of them are wrong with this probability besides.
weighed :: Double -> Posterior place -> Posterior place
weighed alien found =
  found
    { posteriorDoubt = orForeign (posteriorDoubt found),
      posteriorEqualDoubt = orForeign (posteriorEqualDoubt found),
      posteriorRanking = [(place, ours * chance) | (place, chance) <- posteriorRanking found],
      posteriorUnlisted = (ours *) <$> posteriorUnlisted found
    }
  where
    ours = 1 - alien
    orForeign doubt = alien + ours * doubt
