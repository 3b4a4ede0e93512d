-- | Frames of a turned sensor, turned back.
module PraTactile.Registration.Turn
  ( turnedBack,
  )
where

import PraTactile.Geometry (cosineSine)
import PraTactile.Image (Raster, generate, rasterHeight, rasterWidth, sample)

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
