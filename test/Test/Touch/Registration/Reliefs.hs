-- | Pairs of frames of relief of all kinds.
module Test.Touch.Registration.Reliefs (genFrames) where

import Data.Maybe (fromMaybe)
import PraTactile.Image
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Sensor.MeanHeights (embossing)

-- | Two frames cut out of relief of some kind, the second this far right and down of the first.
genFrames :: Int -> Int -> Gen ((Raster, Raster), (Int, Int))
genFrames w h = do
  dx <- choose (-3, 7)
  dy <- choose (-3, 3)
  rough <- elements [0, 0, 0.01, 0.05, 0.3]
  noiseA <- genRasterOf w h
  noiseB <- genRasterOf w h
  texture <- genRasterOf 9 9
  angle <- elements [0, pi / 2, 0.6, 2]
  edge <- choose (3, 9)
  gain <- elements [1, 1, 0.7, 2]
  kind <- choose (0, 6 :: Int)
  cell <- choose (0, 3)
  let smooth' :: Int -> Int -> Double
      smooth' x y = sample texture ((fromIntegral x + 8) / 3) ((fromIntegral y + 8) / 3)
      symbols, relief :: Int -> Int -> Double
      symbols x y =
        let (j, u) = (x + 5) `divMod` 16
            (i, v) = (y + 23) `divMod` 20
         in fromMaybe 0 (index (embossing !! ((j + 2 * i + cell) `mod` 4)) (u - 4) (v - 4))
      relief x y = case kind of
        0 -> 0
        1 -> 1 / (1 + exp (-2 * (cos angle * fromIntegral x + sin angle * fromIntegral y - edge)))
        2 -> if even (x `div` 2 + y `div` 2) then 0 else 1
        3 -> fromIntegral (x `mod` 4) / 4 + smooth' 0 y
        4 -> symbols x y
        _ -> smooth' x y
      with noise image =
        generate w h (\x y -> image x y + rough * (fromMaybe 0 (index noise x y) - 0.5))
  pure
    ( ( with noiseA relief,
        with noiseB (\x y -> gain * relief (x + dx) (y + dy))
      ),
      (dx, dy)
    )
