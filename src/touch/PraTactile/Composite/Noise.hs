{-# OPTIONS_HADDOCK hide #-}

-- | The noise of frames and the step of their readings, estimated from the frames.
module PraTactile.Composite.Noise
  ( frameNoise,
    readingStep,
    spacedOut,
  )
where

import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Level (medianSize)
import PraTactile.Image (Raster, rasterSize, rasterValues)

-- | The standard deviation of the noise of frames, in grey values. It is estimated from the median
-- size of a - b - c + d over squares of four pixels, in which relief has a part only at its
-- corners. For normal white noise of standard deviation s that median is 0.6745 times 2 s. Clipped
-- readings lower the estimate, because clipping removes half of the noise. 0 if no frame has a
-- square of pixels. Duplicates count once, and at most 256 frames are used, whatever their order.
frameNoise :: [Raster] -> Double
frameNoise frames =
  medianSize (V.concat (map squares (spacedOut mostFrames different))) / (0.6745 * 2)
  where
    mostFrames = 256
    different = Map.elems (Map.fromList [(rasterValues frame, frame) | frame <- frames])

-- | The difference a - b - c + d of each square of four pixels.
squares :: Raster -> V.Vector Double
squares image
  | w < 2 || h < 2 = V.empty
  | otherwise = V.generate ((w - 1) * (h - 1)) $ \i ->
    let (y, x) = i `quotRem` (w - 1)
        at v u = V.unsafeIndex values (v * w + u) -- v < h, u < w
     in at y x - at y (x + 1) - at (y + 1) x + at (y + 1) (x + 1)
  where
    (w, h) = rasterSize image
    values = rasterValues image

-- | The step of the readings: the least difference of two different values among about a thousand
-- pixels of at most 64 frames. It is at most the step of 8 bits, since frames without noise may
-- have only two values.
readingStep :: [Raster] -> Double
readingStep frames = minimum (1 / 255 : [b - a | (a, b) <- zip values (drop 1 values)])
  where
    values = Set.toAscList (Set.fromList (concatMap some frames'))
    frames' = spacedOut 64 frames
    some frame =
      let v = rasterValues frame
          apart = max 1 (V.length v * length frames' `quot` 1024)
       in [v V.! k | k <- [0, apart .. V.length v - 1]]

-- | At most the given number of elements of a list, evenly spaced.
spacedOut :: Int -> [a] -> [a]
spacedOut most xs
  | n <= most = xs
  | otherwise = [x | (k, x) <- zip [0 ..] xs, (k * most) `div` n /= ((k - 1) * most) `div` n]
  where
    n = length xs
