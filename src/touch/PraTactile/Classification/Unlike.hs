{-# OPTIONS_HADDOCK hide #-}

-- | The shape that an image itself draws best, whatever the alphabet.
module PraTactile.Classification.Unlike
  ( freeLikeness,
  )
where

import Data.List (sort)
import qualified Data.Vector.Storable as V
import PraTactile.Image

-- | The greatest correlation coefficient of an 8 x 12 image and any drawing of which a third to two
-- thirds of the blocks are embossed: for each number of them those that are highest in the image.
-- 0 for an image all of whose values are the same, and for one of another size.
--
-- The mean of a block is the correlation with it, but for a factor; so of k blocks the highest are
-- best, and with n blocks in all, of deviations d from the mean of all, they correlate by
--
-- > sum of d over the k highest / root (sum of z^2 / m * k (n - k) / n)    of m taxels a block
--
-- where z are the taxels' deviations.
freeLikeness :: Raster -> Double
freeLikeness image
  | rasterSize image /= (8, 12) || spread <= 0 = 0
  | otherwise =
    maximum
      [ sum (take k highest) / sqrt (spread / taxels * share k)
        | k <- [blocks `div` 3 .. 2 * blocks `div` 3]
      ]
  where
    values = rasterValues image
    average = V.sum values / fromIntegral (V.length values)
    spread = V.sum (V.map (\v -> (v - average) * (v - average)) values)
    blocks = 24 :: Int
    share k = fromIntegral (k * (blocks - k)) / fromIntegral blocks :: Double
    taxels = 4 :: Double
    highest = reverse (sort [meanOf x y - average | y <- [0, 2 .. 10], x <- [0, 2 .. 6]])
    meanOf x y = sum [values V.! (8 * (y + j) + x + i) | j <- [0, 1], i <- [0, 1]] / taxels
