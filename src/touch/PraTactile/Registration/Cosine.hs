{-# OPTIONS_HADDOCK hide #-}

-- | The orthonormal two-dimensional discrete cosine transform (DCT-II; Ahmed, Natarajan and Rao,
-- 1974) of images and of patches of them: its lowest frequencies, without the mean.
module PraTactile.Registration.Cosine
  ( Cosines,
    cosinesUpTo,
    highest,
    cosineTransform,

    -- * Patches of one strip
    Strip,
    strip,
    patchTransform,
  )
where

import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Image (Raster, rasterHeight, rasterValues, rasterWidth)
import PraTactile.Registration.Loops
import PraTactile.Registration.Numbers (highest)

-- | By length, the cosines of each frequency at the first half of the places, frequency by
-- frequency. The other half mirrors them, with the sign of the frequency's parity.
newtype Cosines = Cosines (Boxed.Vector (Vector Double))

-- | The cosines for lengths up to the given one; each is computed on first use.
cosinesUpTo :: Int -> Cosines
cosinesUpTo longest = Cosines (Boxed.generate (longest + 1) halves)
  where
    halves n = V.generate (min highest n * halfOf n) $ \i ->
      let (u, t) = i `quotRem` halfOf n
          scale = if u == 0 then sqrt (1 / size n) else sqrt (2 / size n)
       in scale * cos (pi * fromIntegral u * (fromIntegral t + 0.5) / size n)
    size n = fromIntegral n :: Double

halfOf :: Int -> Int
halfOf n = (n + 1) `quot` 2

-- | The coefficients of a whole image, row by row, at most 'highest' a side, without the mean's.
-- The cosines must reach to the image's longer side.
cosineTransform :: Cosines -> Raster -> Vector Double
cosineTransform known image =
  patchTransform known (strip known image 0 (rasterWidth image)) 0 (rasterHeight image)

-- | Some columns of an image with each row transformed: the number of frequencies, and the
-- coefficients row by row.
data Strip = Strip !Int !(Vector Double)

-- | Transforms the rows of an image within some columns, given the first column and the width.
strip :: Cosines -> Raster -> Int -> Int -> Strip
strip known image from width =
  Strip (min highest width) (halved known width (rasterHeight image) place (rasterValues image))
  where
    place row t = row * rasterWidth image + from + t

-- | The coefficients of a patch: some rows of a strip, given the first row and the height. They
-- come row by row, at most 'highest' a side, without the mean's.
patchTransform :: Cosines -> Strip -> Int -> Int -> Vector Double
patchTransform known (Strip across rows) from height =
  V.generate (V.length columns - 1) (\i -> turned (i + 1))
  where
    columns = halved known height across place rows
    place column t = (from + t) * across + column
    down = min highest height
    -- The columns' transforms are stored column by column.
    turned i = let (v, u) = i `quotRem` across in V.unsafeIndex columns (u * down + v)

-- | The one-dimensional transforms of count lines of n values, line by line. The function gives the
-- index of a line's element among the values.
halved :: Cosines -> Int -> Int -> (Int -> Int -> Int) -> Vector Double -> Vector Double
halved (Cosines known) n count place values = V.generate (count * frequencies) coefficient
  where
    frequencies = min highest n
    half = halfOf n
    cosines = known Boxed.! n
    -- Sums and differences of the values equally far from both ends; the middle one stands alone.
    sums = V.generate (count * half) (both (+))
    differences = V.generate (count * half) (both (-))
    both join i
      | t' == t = here `join` 0
      | otherwise = here `join` V.unsafeIndex values (place line t')
      where
        (line, t) = i `quotRem` half
        t' = n - 1 - t
        here = V.unsafeIndex values (place line t)
    {-# INLINE both #-}
    -- Note [Bounds]
    coefficient i = dotWithin half (cosines, u * half) (folded, line * half)
      where
        (line, u) = i `quotRem` frequencies
        folded = if even u then sums else differences
{-# INLINE halved #-}

{- Note [Bounds] Strips and patches must lie within their images ('strip', 'patchTransform'), so
   that place is an index of the values. A line has half elements in the sums and in the
   differences, and a frequency as many cosines; u < frequencies, and line < count. -}
