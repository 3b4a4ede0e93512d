-- | Whether an image of a symbol is one of the alphabet's shapes, or of a shape that is none of
-- them.
--
-- Noise and blur make an image unlike its shape, but not like another one. So two likenesses are
-- compared, each a correlation coefficient: s with the likeliest of the alphabet's shapes
-- ('match'), and u with the shape that the image itself draws best on the 4 x 6 blocks of 2 x 2
-- taxels from which shapes are made, the same for every alphabet. With noise of any variance, found
-- from what either leaves over, the image is likelier by that free shape by the logarithm
--
-- > n / 2 log ((1 - s^2) / (1 - u^2))    of n independent taxels
--
-- which an image of the alphabet's shapes makes small, since the free shape is then nearly the
-- same. How likely it is that small of images of the alphabet's and of others is a matter of
-- sensors; a logistic regression on it and on s tells it. Note [Unlikeness]
module PraTactile.Classification.Unlike
  ( Unlikeness (..),
    standardUnlikeness,
    unlikeAny,
    freeLikeness,
  )
where

import Data.List (sort)
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Templates
import PraTactile.Image
import PraTactile.Symmetry

-- | The log odds of another shape against one of the alphabet's, both equally likely beforehand:
-- the first number, and the second times the logarithm of (1 - s^2) / (1 - u^2), less the third
-- times s.
data Unlikeness = Unlikeness
  { unlikeIntercept :: !Double,
    unlikePerRatio :: !Double,
    unlikePerLikeness :: !Double
  }
  deriving stock (Eq, Show)

-- | That of Note [Unlikeness].
standardUnlikeness :: Unlikeness
standardUnlikeness = Unlikeness 8.4 5.66 16.2

-- | The logarithm of how many times as likely an 8 x 12 image is of another shape as of the
-- alphabet's, the likeliest of which, and how it is turned, is given; from -6 to 4: no sensor is
-- known so well, and of the alphabet's own symbols one in a hundred is cut at an edge of what was
-- felt, which makes it unlike any.
unlikeAny :: Unlikeness -> Templates -> (Int, Symmetry) -> Raster -> Double
unlikeAny (Unlikeness intercept perRatio perLikeness) shapesSeen likeliest image =
  max (-6) (min 4 (intercept + perRatio * log (left s / left u) - perLikeness * s))
  where
    s = match shapesSeen (fst likeliest) (onRaster (snd likeliest) image)
    u = freeLikeness image
    -- A hundredth of the variance is never explained.
    left r = max 0.01 (1 - r * r)

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

{- Note [Unlikeness] The regression was fitted to 2400 symbols of GF(4)'s and as many of shapes
   drawn by the rules of the shipped ones, at least 24 taxels from each of them: all from presses of
   `images --set press --any-angle` by the sensors `real` and `hard`, seeds 11 and 12, by
   bench/peers/unlikeness.py. docs/network.md has what it lets pass. -}
