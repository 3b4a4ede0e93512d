{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 #-}

-- | Two-dimensional normalised cross-correlation of an image against a weighted reference, at whole and at fractional displacements (the paper's
-- section IV: "a 2-D cross-correlation algorithm is used to correct the misalignment errors of successive images").
--
-- At displacement d the image's pixel p lies on the reference's place p + d. With w(p) the weight there, c(p) the reference's value there,
-- f(p) the image's, and n the sum of the weights,
--
-- > mean f  = sum w f / n,   variance f = sum w (f - mean f)^2 / n,   covariance = sum w (f - mean f) (c - mean c) / n
-- > zncc    = covariance / sqrt (variance f * variance c)
--
-- The same on lists, straight from this formula, is in the test suite and compared with what stands here.
module PraTactile.Image.Correlate
  ( -- * References
    Reference
  , reference
  , referenceOf
  , referenceAt

    -- * Correlation
  , Overlap (..)
  , overlapAt
  , zncc
  ) where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V

import PraTactile.Image (ImageError (..), Raster, constant, generate, index, rasterHeight, rasterValues, rasterWidth)

-- | An image with a weight at each pixel, 0 where nothing is known; interpolated as a whole: at a fractional place the weight is the bilinear
-- mean of the weights (0 outside the image), and the value the mean of the values with those shares times the weights.
data Reference = Reference
  !Int -- width with one more pixel of weight 0 on each side
  !Int -- height, likewise
  !(Vector Double) -- weight * value
  !(Vector Double) -- weight

-- | A reference from sums and weights: the first raster holds weight times value, the second the weights, which are taken as 0 where they are
-- negative. Refuses ('SizesDiffer') rasters of different size.
reference :: Raster -> Raster -> Either ImageError Reference
reference sums weights
  | size sums /= size weights = Left (SizesDiffer (size sums) (size weights))
  | otherwise = Right (Reference w h (padded sums) (V.map (max 0) (padded weights)))
 where
  size image = (rasterWidth image, rasterHeight image)
  w = rasterWidth sums + 2
  h = rasterHeight sums + 2
  padded image = rasterValues (generate w h (\x y -> maybe 0 id (index image (x - 1) (y - 1))))

-- | A whole image as a reference of weight 1.
referenceOf :: Raster -> Reference
referenceOf image = either (const (Reference 0 0 V.empty V.empty)) id (reference image ones)
 where
  ones = constant (rasterWidth image) (rasterHeight image) 1

-- | The weight and the value of a reference at a place; the value is 0 where the weight is.
referenceAt :: Reference -> Double -> Double -> (Double, Double)
referenceAt (Reference w h sums weights) x y
  | not (abs x < 1e8 && abs y < 1e8) || bx < -1 || by < -1 || bx > w - 3 || by > h - 3 = (0, 0)
  | m <= 0 = (0, 0)
  | otherwise = (m, at sums / m)
 where
  bx = floor x :: Int
  by = floor y :: Int
  fx = x - fromIntegral bx
  fy = y - fromIntegral by
  i = (by + 1) * w + bx + 1
  at v = (1 - fy) * ((1 - fx) * V.unsafeIndex v i + fx * V.unsafeIndex v (i + 1)) + fy * ((1 - fx) * V.unsafeIndex v (i + w) + fx * V.unsafeIndex v (i + w + 1))
  m = at weights

-- | What an image and a reference have in common at one displacement.
data Overlap = Overlap
  { overlapWeight :: !Double
  -- ^ The sum of the weights, n; 0 when they do not meet.
  , overlapImageVariance :: !Double
  , overlapReferenceVariance :: !Double
  , overlapCovariance :: !Double
  }
  deriving stock (Eq, Show)

-- | The zero-mean normalised cross-correlation, -1 to 1, where both the image and the reference vary; 'Nothing' where either is flat.
zncc :: Overlap -> Maybe Double
zncc (Overlap n vf vc cov)
  | n > 0 && vf * vc > 0 = Just (max (-1) (min 1 (cov / sqrt (vf * vc))))
  | otherwise = Nothing

-- | The overlap of an image with a reference at a displacement. Each pixel counts with the weight @m / (1 + m)@, where m is the reference's: that is
-- in proportion to how well the difference of the two is known when the image's noise has variance 1 and the reference's has 1 / m.
overlapAt :: Reference -> Raster -> Double -> Double -> Overlap
overlapAt (Reference w h sums weights) image dx dy = finish (rows y0 (0, 0, 0, 0, 0, 0))
 where
  iw = rasterWidth image
  ih = rasterHeight image
  values = rasterValues image
  bx = floor dx :: Int
  by = floor dy :: Int
  fx = dx - fromIntegral bx
  fy = dy - fromIntegral by
  -- In the padded reference the pixel x of the image lies between columns x + bx + 1 and x + bx + 2, both of which must exist.
  x0 = max 0 (negate bx - 1)
  x1 = min iw (w - bx - 2)
  y0 = max 0 (negate by - 1)
  y1 = min ih (h - by - 2)
  a00 = (1 - fx) * (1 - fy)
  a10 = fx * (1 - fy)
  a01 = (1 - fx) * fy
  a11 = fx * fy
  rows !y acc@(_, _, _, _, _, _)
    | y >= y1 = acc
    | otherwise = rows (y + 1) (columns x0 y acc)
  columns !x !y (!n, !sf, !sc, !sff, !scc, !sfc)
    | x >= x1 = (n, sf, sc, sff, scc, sfc)
    | m <= 0 = columns (x + 1) y (n, sf, sc, sff, scc, sfc)
    | otherwise =
        columns (x + 1) y (n + k, sf + k * f, sc + k * c, sff + k * f * f, scc + k * c * c, sfc + k * f * c)
   where
    i = (y + by + 1) * w + x + bx + 1
    at v = a00 * V.unsafeIndex v i + a10 * V.unsafeIndex v (i + 1) + a01 * V.unsafeIndex v (i + w) + a11 * V.unsafeIndex v (i + w + 1)
    m = at weights
    c = at sums / m
    f = V.unsafeIndex values (y * iw + x)
    k = m / (1 + m)
  finish (n, sf, sc, sff, scc, sfc)
    | n <= 0 = Overlap 0 0 0 0
    | otherwise =
        let mf = sf / n
            mc = sc / n
         in Overlap n (max 0 (sff / n - mf * mf)) (max 0 (scc / n - mc * mc)) (sfc / n - mf * mc)
