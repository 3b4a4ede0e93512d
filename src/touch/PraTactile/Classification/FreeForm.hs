{-# OPTIONS_HADDOCK hide #-}

-- | How well the best free-form drawing, in any alphabet or none, fits an image.
module PraTactile.Classification.FreeForm
  ( freeFormCorrelation,
  )
where

import Data.List (sort)
import qualified Data.Vector.Storable as V
import PraTactile.Image

-- | The greatest correlation coefficient of an 8 x 12 image and any drawing in blocks of 2 x 2
-- taxels with a third to two thirds of the blocks embossed. For each number of embossed blocks the
-- best drawing embosses the blocks with the highest means. 0 for a constant image and for an image
-- of another size.
--
-- The correlation with a single block is proportional to the block's mean, so the k blocks with the
-- highest means are best. Let there be n blocks of m taxels; let d be the deviations of the blocks'
-- means from the overall mean, and z those of the taxels. The correlation is
--
-- > sum of d over the k highest / root (sum of z^2 / m * k (n - k) / n)
freeFormCorrelation :: Raster -> Double
freeFormCorrelation image
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
