{-# OPTIONS_HADDOCK hide #-}

-- | How high the background and the embossing lie in a composite, and whether there is any
-- embossing at all.
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

-- | The background's and the embossing's intensity.
data Levels = Levels
  { levelBackground :: !Double,
    levelEmbossing :: !Double
  }
  deriving stock (Eq, Show)

-- | Halfway between the two.
threshold :: Levels -> Double
threshold (Levels low high) = (low + high) / 2

-- | The embossing above the background.
contrast :: Levels -> Double
contrast (Levels low high) = high - low

-- | The levels of a set of intensities, given the least contrast that is one. The intensities are
-- split in two by Otsu's threshold (IEEE Trans. Syst. Man Cybern. 9, 1979), which makes the
-- variance between the two parts largest; the levels are the parts' medians.
--
-- 'Nothing' when that shows no embossing: less than that between the two.
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

-- | The least contrast of embossing, given the step and the standard deviation of the noise of what
-- is read: two steps, and four times the noise, which is more than the parts differ by into which
-- noise alone is split (1.35 standard deviations of normal noise).
leastContrast :: Double -> Double -> Double
leastContrast step noise = max (2 * step) (4 * noise)

-- | The standard deviation of the noise of an image, given the second differences @a - 2 b + c@ of
-- neighbours a, b, c in it, in which relief has little part: their median size is 0.6745 sqrt 6
-- standard deviations where the noise is normal and white. 0 for none.
noiseFrom :: Vector Double -> Double
noiseFrom differences = medianSize differences / (0.6745 * sqrt 6)

-- | The median of the sizes of numbers, of as many bins as levels have; 0 for none.
medianSize :: Vector Double -> Double
medianSize numbers
  | V.null numbers = 0
  | otherwise = largest * median (histogram 0 largest sizes) / fromIntegral bins
  where
    sizes = V.map abs numbers
    largest = V.maximum sizes

-- | What is left of white noise where each pixel becomes the mean of those around it, those beside
-- it with half its weight and those across with a quarter: the root of the sum of the squared
-- weights.
smoothing :: Double
smoothing = 6 / 16

bins :: Int
bins = 512

-- | How many values lie in each of the equal parts of an interval.
histogram :: Double -> Double -> Vector Double -> Vector Double
histogram low high values
  | high > low = V.accumulate_ (+) empty (V.map bin values) (V.map (const 1) values)
  | otherwise =
    V.accumulate_ (+) empty (V.singleton 0) (V.singleton (fromIntegral (V.length values)))
  where
    empty = V.replicate bins 0
    bin v = max 0 (min (bins - 1) (floor ((v - low) / (high - low) * fromIntegral bins)))

-- | The place of the median on the axis of a histogram, in bins, linearly within its bin.
median :: Vector Double -> Double
median counts = go 0 0
  where
    half = V.sum counts / 2
    go i below = case counts V.!? i of
      Nothing -> fromIntegral (V.length counts)
      Just c
        | c > 0 && below + c >= half -> fromIntegral i + (half - below) / c
        | otherwise -> go (i + 1) (below + c)

-- | The bin at which the upper part begins, so that the variance between the two parts is largest.
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
