{-# OPTIONS_HADDOCK hide #-}

-- | Frames of any taxel pitch at the canonical one, 'taxelPitch', and frames of a turned sensor
-- turned back, so that everything after it works at one pitch and along the robot's axes.
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

-- | A frame of any pitch as one of 'taxelPitch' with the same centre; one that has it already, to
-- a billionth, comes back as it is.
atCanonicalPitch :: Frame -> Frame
atCanonicalPitch frame
  | isCanonical frame = frame
  | otherwise =
    frame
      { frameImage = resampled (frameTaxel frame / taxelPitch) (frameImage frame),
        frameTaxel = taxelPitch
      }

-- | The width and height of a frame once it is 'atCanonicalPitch'.
canonicalSize :: Frame -> (Int, Int)
canonicalSize frame
  | isCanonical frame = rasterSize (frameImage frame)
  | otherwise = resampledSize (frameTaxel frame / taxelPitch) (rasterSize (frameImage frame))

-- | Whether a frame's taxels are of the canonical pitch, to rounding.
isCanonical :: Frame -> Bool
isCanonical frame = abs (frameTaxel frame - taxelPitch) < 1e-9 * taxelPitch

-- | An image whose pixels are that many new pixels wide, in new pixels, as many as its rectangle
-- holds whole, at least one, with the same centre. Where the old pixels are the finer ones each new
-- one is the mean of the area it covers, else the value between the old ones' centres, bilinearly.
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
    -- Where the centre of a new pixel lies among the centres of the old ones.
    centre n new k = start n new k + (1 / ratio - 1) / 2
    -- Where a new pixel begins, in old pixels from the image's edge.
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

-- | The width and height of what 'resampled' makes of an image of this width and height.
resampledSize :: Double -> (Int, Int) -> (Int, Int)
resampledSize ratio = bimap whole whole
  where
    whole n
      | n == 0 = 0
      | otherwise = max 1 (floor (fromIntegral n * ratio + 1e-9))

-- | The image of a sensor that is turned by that many degrees clockwise, as it would be if the
-- sensor were not turned: the largest upright part, of the image's proportions and with the same
-- centre, that lies wholly in it, bilinearly between its pixels. Nothing where that is smaller than
-- 4 x 4.
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
    -- A part of the image's proportions, of this share of its sides, is still within it when
    -- turned.
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
