{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Two-dimensional normalised cross-correlation of an image with a weighted reference, at whole
-- and at fractional displacements (the paper's section IV: "a 2-D cross-correlation algorithm is
-- used to correct the misalignment errors of successive images").
--
-- At displacement d the image's pixel p lies on the reference's place p + d. With f(p) the image's
-- value, c(p) and m(p) the reference's value and weight there, and n the sum of all m(p),
--
-- > mean f     = sum m f / n
-- > variance f = sum m (f - mean f)^2 / n
-- > covariance = sum m (f - mean f) (c - mean c) / n
-- > zncc       = covariance / sqrt (variance f * variance c)
--
-- The test suite computes these formulas on lists and compares.
module PraTactile.Image.Correlate
  ( -- * References
    Reference,
    reference,
    referenceOf,
    referenceSums,
    referenceWeights,
    referenceAt,

    -- * Correlation
    Overlap (..),
    overlapAt,
    zncc,
  )
where

import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Image
  ( ImageError (..),
    Raster,
    constant,
    index,
    rasterHeight,
    rasterSize,
    rasterValues,
    rasterWidth,
  )

-- | An image with a weight at each pixel, such as the number of frames of which it is the mean.
-- Weight 0 means unknown.
--
-- Between pixels, the weight is the bilinear mean of the weights around, and the value is their
-- mean with those shares times their weights.
data Reference
  = -- | The weight times the value at each pixel, and the weight. Both have one size.
    Weighted !Raster !Raster
  | -- | An image of weight 1 everywhere.
    Whole !Raster
  deriving stock (Show)

-- | The weight times the value at each pixel.
referenceSums :: Reference -> Raster
referenceSums (Weighted sums _) = sums
referenceSums (Whole image) = image

-- | The weight at each pixel.
referenceWeights :: Reference -> Raster
referenceWeights (Weighted _ weights) = weights
referenceWeights (Whole image) = constant (rasterWidth image) (rasterHeight image) 1

-- | A reference from two rasters: the weights times the values, and the weights. Refuses
-- ('SizesDiffer') rasters of different sizes.
reference :: Raster -> Raster -> Either ImageError Reference
reference sums weights
  | rasterSize sums /= rasterSize weights =
    Left (SizesDiffer (rasterSize sums) (rasterSize weights))
  | otherwise = Right (Weighted sums weights)

-- | An image as a reference of weight 1 everywhere.
referenceOf :: Raster -> Reference
referenceOf = Whole

-- | The value and the weight at a place, x and y in pixels. Pixels outside the image have weight
-- 0. 'Nothing' where the weight is 0.
referenceAt :: Reference -> Double -> Double -> Maybe (Double, Double)
referenceAt there x y
  | near x && near y && m > 0 = Just (at sums / m, m)
  | otherwise = Nothing
  where
    bx = floor x :: Int
    by = floor y :: Int
    fx = x - fromIntegral bx
    fy = y - fromIntegral by
    m = at weights
    (sums, weights) = case there of
      Weighted sums' weights' -> (index sums', index weights')
      Whole image -> (index image, \i j -> 1 <$ index image i j)
    at known =
      (1 - fy) * ((1 - fx) * pixel 0 0 + fx * pixel 1 0)
        + fy * ((1 - fx) * pixel 0 1 + fx * pixel 1 1)
      where
        pixel i j = fromMaybe 0 (known (bx + i) (by + j))

-- | The weighted moments of an image and a reference at one displacement, as in the module header.
data Overlap = Overlap
  { -- | n, the sum of the weights; 0 where they do not overlap.
    overlapWeight :: !Double,
    overlapImageVariance :: !Double,
    overlapReferenceVariance :: !Double,
    overlapCovariance :: !Double
  }
  deriving stock (Eq, Show)

-- | The zero-mean normalised cross-correlation, -1 to 1; 'Nothing' if the image or the reference
-- is flat or they do not overlap.
zncc :: Overlap -> Maybe Double
zncc (Overlap n vf vc cov)
  | n > 0 && vf > flat && vc > flat = Just (max (-1) (min 1 (cov / sqrt vf / sqrt vc)))
  | otherwise = Nothing
  where
    -- Rounding errors of this order remain of a constant's variance.
    flat = 1e-12

-- | The overlap of an image with a reference at a displacement, x and y in pixels. An image pixel
-- is left out if one of the reference pixels around it lies outside.
overlapAt :: Reference -> Raster -> Double -> Double -> Overlap
overlapAt there image dx dy
  | not (near dx && near dy) = Overlap 0 0 0 0
  | otherwise = case there of
    Weighted sums weights
      | fx > 0 || fy > 0 -> moments (between weights) (/) (between sums) w meeting image
      | otherwise -> moments (pixel weights) (/) (pixel sums) w meeting image
    Whole sums
      | fx > 0 || fy > 0 -> moments (const 1) const (between sums) w meeting image
      | otherwise -> moments (const 1) const (pixel sums) w meeting image
  where
    pixel = V.unsafeIndex . rasterValues
    between = interpolated fx fy stepX (stepY * w) . rasterValues
    (!w, !h) = rasterSize (referenceSums there)
    bx = floor dx :: Int
    by = floor dy :: Int
    fx = dx - fromIntegral bx
    fy = dy - fromIntegral by
    stepX = if fx > 0 then 1 else 0
    stepY = if fy > 0 then 1 else 0
    meeting =
      Meeting
        { meetingLeft = max 0 (negate bx),
          meetingRight = min (rasterWidth image) (w - stepX - bx),
          meetingTop = max 0 (negate by),
          meetingBottom = min (rasterHeight image) (h - stepY - by),
          meetingStart = by * w + bx
        }

-- | The columns and rows of the image that overlap the reference, as half-open intervals; and the
-- reference's index of the image's pixel (0, 0), which may lie outside. See Note [Bounds].
data Meeting = Meeting
  { meetingLeft :: !Int,
    meetingRight :: !Int,
    meetingTop :: !Int,
    meetingBottom :: !Int,
    meetingStart :: !Int
  }

-- | The bilinear value between four pixels. The arguments are the fractions right and down, the
-- index steps to the next column and to the next row, the values, and the index of the upper left
-- pixel.
interpolated :: Double -> Double -> Int -> Int -> Vector Double -> Int -> Double
interpolated fx fy right below v i =
  (1 - fy) * ((1 - fx) * V.unsafeIndex v i + fx * V.unsafeIndex v (i + right))
    + fy * ((1 - fx) * V.unsafeIndex v (i + below) + fx * V.unsafeIndex v (i + below + right))
{-# INLINE interpolated #-}

-- | The overlap. The arguments are the reference's weight at an index, the division by it, the
-- reference's sum at an index, and the reference's width.
moments ::
  (Int -> Double) ->
  (Double -> Double -> Double) ->
  (Int -> Double) ->
  Int ->
  Meeting ->
  Raster ->
  Overlap
moments weightAt by sumAt w (Meeting x0 x1 y0 y1 start) image = row y0 0 0 0 0 0 0
  where
    !values = rasterValues image
    iw = rasterWidth image
    row !y !n !sf !sc !sff !scc !sfc
      | y >= y1 = overlapOf n sf sc sff scc sfc
      | otherwise = column (y * iw) (y * w + start) y x0 n sf sc sff scc sfc
    column !f0 !r0 !y !x !n !sf !sc !sff !scc !sfc
      | x >= x1 = row (y + 1) n sf sc sff scc sfc
      | m <= 0 = column f0 r0 y (x + 1) n sf sc sff scc sfc
      | otherwise =
        let f = V.unsafeIndex values (f0 + x)
            mf = m * f
            mc = sumAt (r0 + x)
         in column
              f0
              r0
              y
              (x + 1)
              (n + m)
              (sf + mf)
              (sc + mc)
              (sff + mf * f)
              (scc + (mc * mc) `by` m)
              (sfc + mc * f)
      where
        m = weightAt (r0 + x)
{-# INLINE moments #-}

{- Note [Bounds] 0 <= x < iw and 0 <= y < image height, so the image's index y * iw + x is good. x
   >= -bx and x < w - stepX - bx give 0 <= x + bx and x + bx + stepX < w; for y the reference's
   height gives the same bounds. So all four of the reference's indices are good. Where an axis'
   fraction is 0 its step is 0. 'near' bounds displacements, so nothing overflows. -}

-- | The moments from the weighted sums. A tiny negative variance from rounding becomes 0.
overlapOf :: Double -> Double -> Double -> Double -> Double -> Double -> Overlap
overlapOf n sf sc sff scc sfc
  | n <= 0 = Overlap 0 0 0 0
  | otherwise =
    Overlap n (max 0 (sff / n - mf * mf)) (max 0 (scc / n - mc * mc)) (sfc / n - mf * mc)
  where
    mf = sf / n
    mc = sc / n

-- | Whether a coordinate is small enough for arithmetic as an 'Int'.
near :: Double -> Bool
near t = abs t < 1e9
