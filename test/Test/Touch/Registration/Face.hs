-- | A face of symbols, all four of the shipped alphabet on their lattice, and frames of it.
module Test.Touch.Registration.Face (frameAt, frameTurned, arranged) where

import Data.Maybe (fromMaybe)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Geometry (rotated)
import PraTactile.Image
import PraTactile.Registration.Arrangement hiding (arrange)
import PraTactile.Registration.Settings (Registration)
import Test.Touch.Paper (arrange)
import Test.Touch.Sensor.MeanHeights (embossing)

-- | A frame of this width and height, whose upper left taxel lies there on the face, in taxels.
frameAt :: (Int, Int) -> (Double, Double) -> Raster
frameAt = frameTurned 0

-- | A frame that is turned about its middle by these degrees clockwise.
frameTurned :: Double -> (Int, Int) -> (Double, Double) -> Raster
frameTurned angle (wide, high) (x, y) =
  generate wide high $ \i j ->
    let (u, v) = rotated angle (fromIntegral i - middle wide, fromIntegral j - middle high)
     in sample face (x + middle wide + u) (y + middle high + v)
  where
    middle side = fromIntegral (side - 1) / 2

face :: Raster
face = generate 96 80 $ \x y ->
  let (c, u) = x `divMod` 16
      (r, v) = y `divMod` 20
      kind = (3 * r + 2 * c + r * c) `mod` 4
   in fromMaybe 0 (index (embossing !! kind) (u - 4) (v - 4))

-- | Few frames, arranged.
arranged :: StitchMethod -> Registration -> [(Taxels, Raster)] -> Arrangement
arranged method settings frames =
  either (error . ("it would take too much: " ++) . show) id $
    arrange method settings frames
