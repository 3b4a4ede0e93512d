{-# OPTIONS_HADDOCK hide #-}

-- | A composite's pixels with a mask of those that were touched.
module PraTactile.Segmentation.Masked
  ( -- * Masked images
    Masked (..),
    masked,
    maskedAs,
    smoothed,

    -- * Their values
    isTouched,
    valueOf,
    valueAt,
    touchedWhere,
    pixelNoise,

    -- * Pixels by their numbers
    placeOf,
    beside,
  )
where

import Data.Maybe (isJust)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (Composite (..), leastCoverage)
import PraTactile.Composite.Level (noiseFrom)
import PraTactile.Image
import PraTactile.Image.Ascending (placeIn)

-- | The touched pixels of an image. All pixels are numbered row by row from 0.
data Masked = Masked
  { maskedWidth :: !Int,
    maskedHeight :: !Int,
    -- | the numbers of the touched pixels, ascending
    maskedNumbers :: !(Vector Int),
    -- | the index of a touched pixel's number in that list
    maskedPlace :: Int -> Maybe Int,
    -- | the values of the touched pixels, in the same order
    touchedValues :: !(Vector Double)
  }

-- | A composite's pixels. Pixels with a coverage of at least 'leastCoverage' are touched.
masked :: Composite -> Masked
masked Composite {compositeImage = image, compositeCoverage = coverage} =
  maskedAs (rasterSize image) numbers (valuesAt image numbers)
  where
    numbers = pixelsWhere (>= leastCoverage) coverage

-- | An image with the given width and height, the numbers of its touched pixels (ascending), and
-- their values.
maskedAs :: (Int, Int) -> Vector Int -> Vector Double -> Masked
maskedAs (w, h) numbers = Masked w h numbers (placesOf (w * h) numbers)

-- | The index of a number below @count@ in an ascending vector, if it is there. It uses a table,
-- or a search if the table would be large.
placesOf :: Int -> Vector Int -> Int -> Maybe Int
placesOf count numbers
  | count > 4194304 = placeIn numbers
  | otherwise = \p -> case table V.!? p of
    Just k | k >= 0 -> Just k
    _ -> Nothing
  where
    table =
      V.update_ (V.replicate count (-1)) numbers (V.enumFromN 0 (V.length numbers)) :: Vector Int

-- | Each pixel replaced by the mean of the touched pixels around it: straight neighbours have half
-- its weight, diagonal ones a quarter.
smoothed :: Masked -> Masked
smoothed pixels = pixels {touchedValues = V.map meanAround (maskedNumbers pixels)}
  where
    meanAround p = if total > 0 then sum (map snd near) / total else 0
      where
        total = sum (map fst near)
        near =
          [ (weight, weight * value)
            | (i, j) <- [(i, j) | j <- [-1, 0, 1], i <- [-1, 0, 1]],
              Just p' <- [beside pixels p (i, j)],
              Just value <- [valueOf pixels p'],
              let weight = (if i == 0 then 2 else 1) * (if j == 0 then 2 else 1)
          ]

-- | Whether the pixel with this number was touched.
isTouched :: Masked -> Int -> Bool
isTouched pixels = isJust . maskedPlace pixels

-- | The value of the pixel with this number; 'Nothing' if it was not touched.
valueOf :: Masked -> Int -> Maybe Double
valueOf pixels p = (touchedValues pixels V.!) <$> maskedPlace pixels p

-- | The value at a column and a row; 'Nothing' if that pixel was not touched.
valueAt :: Masked -> (Int, Int) -> Maybe Double
valueAt pixels (x, y)
  | x >= 0 && x < w && y >= 0 && y < maskedHeight pixels = valueOf pixels (y * w + x)
  | otherwise = Nothing
  where
    w = maskedWidth pixels

-- | The numbers of the touched pixels whose values satisfy the test, ascending.
touchedWhere :: (Double -> Bool) -> Masked -> [Int]
touchedWhere test pixels =
  V.toList (V.ifilter (\k _ -> test (touchedValues pixels V.! k)) (maskedNumbers pixels))

-- | The standard deviation of the noise of unsmoothed pixels: the larger of the estimates along
-- rows and along columns, since noise may be common to a row or a column.
pixelNoise :: Masked -> Double
pixelNoise pixels = max (noiseFrom (differences 1 0)) (noiseFrom (differences 0 1))
  where
    differences i j =
      V.fromList
        [ a - 2 * value + b
          | (p, value) <- zip (V.toList (maskedNumbers pixels)) (V.toList (touchedValues pixels)),
            Just a <- [beside pixels p (negate i, negate j) >>= valueOf pixels],
            Just b <- [beside pixels p (i, j) >>= valueOf pixels]
        ]

-- | The column and the row of the pixel with this number.
placeOf :: Masked -> Int -> (Int, Int)
placeOf pixels p = let (y, x) = p `quotRem` max 1 (maskedWidth pixels) in (x, y)
{-# INLINE placeOf #-}

-- | The number of the pixel at an offset (right, down) from another; 'Nothing' outside the image.
beside :: Masked -> Int -> (Int, Int) -> Maybe Int
beside pixels p (i, j)
  | x >= 0 && x < w && y >= 0 && y < maskedHeight pixels = Just (y * w + x)
  | otherwise = Nothing
  where
    w = maskedWidth pixels
    (v, u) = p `quotRem` w
    (x, y) = (u + i, v + j)
{-# INLINE beside #-}
