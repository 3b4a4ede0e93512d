-- | A composite's pixels with a mask of those that were touched.
module PraTactile.Segmentation.Masked
  ( -- * Masked images
    Masked (..),
    masked,
    smoothed,

    -- * Their values
    valueAt,
    touchedValues,
    touchedWhere,
    pixelNoise,

    -- * Pixels by their numbers
    placeOf,
    beside,
    around,
    grown,
  )
where

import Control.Monad (forM_)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Composite (Composite (..), leastCoverage)
import PraTactile.Composite.Level (noiseFrom)
import PraTactile.Image

-- | An image's pixels, numbered row by row from 0.
data Masked = Masked
  { maskedWidth :: !Int,
    maskedHeight :: !Int,
    -- | whether each was touched
    maskedTouched :: !(Vector Bool),
    maskedValues :: !(Vector Double)
  }

-- | A composite's pixels; touched are those that got at least 'leastCoverage' of a sensor's weight.
masked :: Composite -> Masked
masked Composite {compositeImage = image, compositeCoverage = coverage} =
  Masked
    { maskedWidth = rasterWidth image,
      maskedHeight = rasterHeight image,
      maskedTouched = V.map (>= leastCoverage) (rasterValues coverage),
      maskedValues = rasterValues image
    }

-- | Each pixel as the mean of the touched ones around it, those beside it with half its weight and
-- those across with a quarter; 0 where none was touched.
smoothed :: Masked -> Masked
smoothed pixels = pixels {maskedValues = V.imap (\p _ -> meanAround p) (maskedValues pixels)}
  where
    meanAround p = if total > 0 then sum (map snd near) / total else 0
      where
        total = sum (map fst near)
        near =
          [ (weight, weight * (maskedValues pixels V.! p'))
            | (i, j) <- [(i, j) | j <- [-1, 0, 1], i <- [-1, 0, 1]],
              Just p' <- [beside pixels p (i, j)],
              maskedTouched pixels V.! p',
              let weight = (if i == 0 then 2 else 1) * (if j == 0 then 2 else 1)
          ]

-- | The value at a column and a row, if that was touched.
valueAt :: Masked -> (Int, Int) -> Maybe Double
valueAt pixels (x, y)
  | inside && maskedTouched pixels V.! p = Just (maskedValues pixels V.! p)
  | otherwise = Nothing
  where
    inside = x >= 0 && x < w && y >= 0 && y < maskedHeight pixels
    w = maskedWidth pixels
    p = y * w + x

-- | The values of the touched pixels, in order.
touchedValues :: Masked -> Vector Double
touchedValues pixels = V.ifilter (\p _ -> maskedTouched pixels V.! p) (maskedValues pixels)

-- | The touched pixels whose values are so, in order.
touchedWhere :: (Double -> Bool) -> Masked -> [Int]
touchedWhere test pixels =
  V.toList (V.elemIndices True (V.zipWith (&&) (maskedTouched pixels) (V.map test values)))
  where
    values = maskedValues pixels

-- | The standard deviation of the noise of pixels that are not smoothed: the larger of what changes
-- along the rows and along the columns show, for a row may have noise in common, or a column.
pixelNoise :: Masked -> Double
pixelNoise pixels = max (noiseFrom (differences 1 0)) (noiseFrom (differences 0 1))
  where
    (touched, values) = (maskedTouched pixels, maskedValues pixels)
    differences i j =
      V.fromList
        [ values V.! a - 2 * values V.! p + values V.! b
          | p <- [0 .. V.length values - 1],
            touched V.! p,
            Just a <- [beside pixels p (negate i, negate j)],
            touched V.! a,
            Just b <- [beside pixels p (i, j)],
            touched V.! b
        ]

-- | The column and the row of a pixel.
placeOf :: Masked -> Int -> (Int, Int)
placeOf pixels p = (p `mod` max 1 (maskedWidth pixels), p `div` max 1 (maskedWidth pixels))

-- | The number of the pixel so far right of and below another one.
beside :: Masked -> Int -> (Int, Int) -> Maybe Int
beside pixels p (i, j)
  | x >= 0 && x < w && y >= 0 && y < maskedHeight pixels = Just (y * w + x)
  | otherwise = Nothing
  where
    w = maskedWidth pixels
    (v, u) = p `quotRem` w
    (x, y) = (u + i, v + j)
{-# INLINE beside #-}

-- | The pixels whose distance from some, the larger one of that in columns and that in rows, is at
-- most this. Each once, in order.
grown :: Masked -> Int -> [Int] -> [Int]
grown pixels distance = V.toList . V.elemIndices True . around pixels distance

-- | Whether each pixel is one of them.
around :: Masked -> Int -> [Int] -> Vector Bool
around pixels distance some = V.create $ do
  marks <- M.replicate (maskedWidth pixels * maskedHeight pixels) False
  forM_ some $ \p ->
    forM_ [(i, j) | j <- [-distance .. distance], i <- [-distance .. distance]] $ \by ->
      mapM_ (\p' -> M.write marks p' True) (beside pixels p by)
  pure marks
