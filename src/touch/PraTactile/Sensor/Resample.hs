{-# OPTIONS_HADDOCK hide #-}

-- | Converts frames of any taxel pitch to the canonical one, 'taxelPitch', and images of a rotated
-- sensor to upright ones. All later stages work at one pitch and along the robot's axes.
module PraTactile.Sensor.Resample
  ( atCanonicalPitch,
    isCanonical,
    canonicalSize,
    resampled,
    resampledSize,
    turnedBack,
  )
where

import Data.Bifunctor (bimap)
import Data.Maybe (fromMaybe)
import PraTactile.Geometry (cosineSine)
import PraTactile.Image (Raster, generate, index, rasterHeight, rasterSize, rasterWidth, sample)
import PraTactile.Sensor.Frame (Frame (..), taxelPitch)

-- | A frame resampled to 'taxelPitch' with the same centre. A frame that has that pitch, to a
-- billionth, is unchanged.
atCanonicalPitch :: Frame -> Frame
atCanonicalPitch frame
  | isCanonical frame = frame
  | otherwise =
    frame
      { frameImage = resampled (frameTaxel frame / taxelPitch) (frameImage frame),
        frameTaxel = taxelPitch
      }

-- | The width and height that 'atCanonicalPitch' gives a frame.
canonicalSize :: Frame -> (Int, Int)
canonicalSize frame
  | isCanonical frame = rasterSize (frameImage frame)
  | otherwise = resampledSize (frameTaxel frame / taxelPitch) (rasterSize (frameImage frame))

-- | Whether a frame's pitch is the canonical one, up to rounding.
isCanonical :: Frame -> Bool
isCanonical frame = abs (frameTaxel frame - taxelPitch) < 1e-9 * taxelPitch

-- | An image resampled with the same centre. The ratio is the width of an old pixel in new pixels.
-- The result has as many whole new pixels as the old rectangle holds, at least one. If old pixels
-- are finer, each new pixel is the mean of the area that it covers; otherwise it is interpolated
-- bilinearly.
--
-- >>> import PraTactile.Image (fromRows, toRows)
-- >>> toRows . resampled 0.5 <$> fromRows [[0, 2, 4, 4], [2, 4, 4, 4]]
-- Right [[2.0,4.0]]
resampled :: Double -> Raster -> Raster
resampled ratio image
  | ratio < 1 = generate wide high (\x y -> area (covered w wide x) (covered h high y))
  | otherwise = generate wide high (\x y -> sample image (centre w wide x) (centre h high y))
  where
    (w, h) = rasterSize image
    (wide, high) = resampledSize ratio (w, h)
    -- The centre of a new pixel, in old pixel coordinates.
    centre n new k = start n new k + (1 / ratio - 1) / 2
    -- The beginning of a new pixel, in old pixels from the image's edge.
    start :: Int -> Int -> Int -> Double
    start n new k = (fromIntegral k - fromIntegral new / 2) / ratio + fromIntegral n / 2
    covered n new k =
      [ (i, share)
        | i <- [max 0 (floor from) .. min (n - 1) (floor to)],
          let share = min to (fromIntegral i + 1) - max from (fromIntegral i),
          share > 0
      ]
      where
        from = start n new k
        to = from + 1 / ratio
    area columns rows =
      sum [u * v * at i j | (j, v) <- rows, (i, u) <- columns]
        / max 1e-300 (sum (map snd columns) * sum (map snd rows))
    at i j = fromMaybe 0 (index image i j)

-- | The width and height that 'resampled' gives an image, from the ratio and the image's width and
-- height.
resampledSize :: Double -> (Int, Int) -> (Int, Int)
resampledSize ratio = bimap whole whole
  where
    whole n
      | n == 0 = 0
      | otherwise = max 1 (floor (fromIntegral n * ratio + 1e-9))

-- | The upright image of a sensor that is rotated clockwise by the given degrees: the largest
-- upright part that lies wholly in the image, with its proportions and centre, interpolated
-- bilinearly. 'Nothing' if that part is smaller than 4 x 4.
turnedBack :: Double -> Raster -> Maybe Raster
turnedBack degrees image
  | min wide high < 4 = Nothing
  | otherwise = Just (generate wide high at)
  where
    (c, s) = cosineSine degrees
    (w, h) =
      (fromIntegral (rasterWidth image - 1), fromIntegral (rasterHeight image - 1)) ::
        ( Double,
          Double
        )
    -- The largest factor by which the image can be shrunk so that, when rotated, it still lies
    -- within itself.
    share =
      minimum
        [ 1,
          w / (w * abs c + h * abs s + 1e-12),
          h / (w * abs s + h * abs c + 1e-12)
        ]
    wide = 1 + floor (share * w + 1e-6) :: Int
    high = 1 + floor (share * h + 1e-6) :: Int
    -- The sensor's own axes are turned clockwise from the upright ones.
    at i j =
      let u = fromIntegral i - fromIntegral (wide - 1) / 2
          v = fromIntegral j - fromIntegral (high - 1) / 2
       in sample image (w / 2 + c * u + s * v) (h / 2 - s * u + c * v)
