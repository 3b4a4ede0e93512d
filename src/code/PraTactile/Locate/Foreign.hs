{-# OPTIONS_HADDOCK hide #-}

-- | That a patch is nothing of the array's: the doubt that no comparison of positions has.
--
-- Of what is foreign half is taken to be random: every symmetry is equally likely, and in it every
-- content, each cell by itself. The other half is another array ('OtherArrays'), in every symmetry
-- and at every position alike; how likely that is, is bounded from above. Of what is the array's
-- every symmetry and every position is equally likely, too, and there each cell has its
-- probability, but for one cell in a hundred, which is not what it seems ('misleading'): damaged,
-- soiled, or wrongly made. Bayes' theorem with the share of foreign things does the rest.
--
-- Who saw the symbols may say how much likelier they are to be none of the array's: then there is a
-- third kind of foreign things, as frequent as the other two together. What other symbols are taken
-- for is random.
module PraTactile.Locate.Foreign
  ( ForeignComparison (..),
    foreignChances,
    evidence,
    foreignByChance,
    misleading,
    weighed,
  )
where

import Data.Maybe (isNothing)
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
    foreignSymmetry :: Double,
    -- | the logarithm of how likely another array makes the cells, at most: summed over symmetries
    -- and positions, relative to the mean of how probable the cells make all symmetries; 'Nothing'
    -- where there is no other array
    foreignOthers :: Maybe Double,
    -- | the logarithm of how many times as likely what was seen is if it shows other symbols than
    -- the array's; minus infinity where that is not weighed
    foreignUnlike :: Double
  }
  deriving stock (Eq, Show)

-- | The share of foreign things that are random, where there are other arrays.
foreignByChance :: Double
foreignByChance = 0.5

-- | The probabilities that observed cells are foreign, of each kind.
--
-- Four cells beyond doubt, which nearly every content of a window is, leave what was believed
-- beforehand; nine do not:
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
    byShapes = log share + contents + foreignUnlike comparison
    contents = contentsByChance comparison
    alone = isNothing (foreignOthers comparison)
    random = if alone then 1 else foreignByChance
    byOthers = maybe (-1 / 0) ofOthers (foreignOthers comparison)
    ofOthers worth =
      log (share * (1 - foreignByChance)) + worth - naturalLogarithm (foreignPlaces comparison)
    ours = log (1 - share) + contents + evidence comparison
    -- Of what is impossible nothing, whatever the others are.
    part one'
      | isInfinite one' = 0
      | otherwise = 1 / sum [exp (other - one') | other <- [ours, byChance, byOthers, byShapes]]

-- | The logarithm of how probable observed cells are by chance, every content alike.
contentsByChance :: ForeignComparison -> Double
contentsByChance comparison =
  negate (fromIntegral (length (foreignExpected comparison)))
    * log (fromIntegral (foreignSymbols comparison))

-- | The logarithm of how many times as probable the observed cells are if they are the array's,
-- anywhere, as they are by chance. It says nothing of how probable either is beforehand.
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
