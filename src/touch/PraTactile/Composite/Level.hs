{-# OPTIONS_HADDOCK hide #-}

-- | The intensities of background and embossing in a composite, and whether there is any
-- embossing.
module PraTactile.Composite.Level
  ( Levels (..),
    levels,
    leastContrast,
    noiseFrom,
    medianSize,
    smoothing,
    threshold,
    contrast,
  )
where

import Data.List (foldl')
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V

-- | The intensities of the background and of the embossing.
data Levels = Levels
  { levelBackground :: !Double,
    levelEmbossing :: !Double
  }
  deriving stock (Eq, Show)

-- | The intensity halfway between background and embossing.
threshold :: Levels -> Double
threshold (Levels low high) = (low + high) / 2

-- | The difference of embossing and background.
contrast :: Levels -> Double
contrast (Levels low high) = high - low

-- | The levels of a set of intensities, given the least contrast. Otsu's threshold (IEEE Trans.
-- Syst. Man Cybern. 9, 1979) splits the intensities so that the variance between the two parts is
-- largest; the levels are the parts' medians.
--
-- 'Nothing' if the levels differ by less than the least contrast, so that there is no embossing.
levels :: Double -> Vector Double -> Maybe Levels
levels least intensities
  | V.null intensities || high <= low || contrast found < least = Nothing
  | otherwise = Just found
  where
    low = V.minimum intensities
    high = V.maximum intensities
    counts = histogram low high intensities
    split = otsu counts
    found =
      Levels
        (valueAt (median (V.take split counts)))
        (valueAt (fromIntegral split + median (V.drop split counts)))
    valueAt bin = low + (high - low) * bin / fromIntegral bins

-- | The least contrast of embossing, from the step of the readings and the standard deviation of
-- their noise: the greater of two steps and four standard deviations. Otsu's threshold splits pure
-- normal noise into parts that differ by only 1.35 standard deviations.
leastContrast :: Double -> Double -> Double
leastContrast step noise = max (2 * step) (4 * noise)

-- | The standard deviation of the noise of an image, from second differences @a - 2 b + c@ of its
-- neighbouring pixels, in which relief has little part. For normal white noise their median size is
-- 0.6745 sqrt 6 standard deviations. 0 for an empty vector.
noiseFrom :: Vector Double -> Double
noiseFrom differences = medianSize differences / (0.6745 * sqrt 6)

-- | The median of the absolute values, by a histogram of 'bins' bins; 0 for an empty vector.
medianSize :: Vector Double -> Double
medianSize numbers
  | V.null numbers = 0
  | otherwise = largest * median (histogram 0 largest sizes) / fromIntegral bins
  where
    sizes = V.map abs numbers
    largest = V.maximum sizes

-- | The standard deviation of unit white noise after smoothing with the weights 1 2 1 in both
-- directions (sum 1): the root of the sum of the squared weights.
smoothing :: Double
smoothing = 6 / 16

bins :: Int
bins = 512

-- | The number of values in each of 'bins' equal parts of an interval.
histogram :: Double -> Double -> Vector Double -> Vector Double
histogram low high values
  | high > low = V.accumulate_ (+) empty (V.map bin values) (V.map (const 1) values)
  | otherwise =
    V.accumulate_ (+) empty (V.singleton 0) (V.singleton (fromIntegral (V.length values)))
  where
    empty = V.replicate bins 0
    bin v = max 0 (min (bins - 1) (floor ((v - low) / (high - low) * fromIntegral bins)))

-- | The place of the median on the axis of a histogram, in bins, interpolated within its bin.
median :: Vector Double -> Double
median counts = go 0 0
  where
    half = V.sum counts / 2
    go i below = case counts V.!? i of
      Nothing -> fromIntegral (V.length counts)
      Just c
        | c > 0 && below + c >= half -> fromIntegral i + (half - below) / c
        | otherwise -> go (i + 1) (below + c)

-- | The first bin of the upper part for which the variance between the two parts is largest.
otsu :: Vector Double -> Int
otsu counts = best
  where
    total = V.sum counts
    moment = V.sum (V.imap (\i c -> fromIntegral i * c) counts)
    (_, _, _, best) = foldl' step (0, 0, -1, 0) (zip [1 ..] (V.toList counts))
    step :: (Double, Double, Double, Int) -> (Int, Double) -> (Double, Double, Double, Int)
    step (n, m, record, i) (next, c)
      | n' > 0 && n' < total && between > record = (n', m', between, next)
      | otherwise = (n', m', record, i)
      where
        n' = n + c
        m' = m + c * fromIntegral (next - 1)
        apart = m' / n' - (moment - m') / (total - n')
        between = n' * (total - n') * apart * apart
