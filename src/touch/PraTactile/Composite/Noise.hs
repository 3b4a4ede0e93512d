{-# OPTIONS_HADDOCK hide #-}

-- | The noise of frames, found from some of the frames themselves.
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

-- | The standard deviation of the noise of frames, grey values: from the median size of the
-- differences of neighbours' differences, a - b - c + d of the squares of four pixels, in which a
-- relief has little part but at its corners. That of normal white noise of variance s^2 is 0.6745
-- times 2 s. Where readings are clipped, which leaves nothing of half of the noise, it is less. 0
-- where there is no square. By at most 256 of the frames, whatever their order, each that comes
-- again once.
frameNoise :: [Raster] -> Double
frameNoise frames =
  medianSize (V.concat (map squares (spacedOut mostFrames different))) / (0.6745 * 2)
  where
    mostFrames = 256
    different = Map.elems (Map.fromList [(rasterValues frame, frame) | frame <- frames])

-- | The differences of all squares of four pixels.
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

-- | The step of what frames read: the least difference of two different values among some thousand
-- of them, but no more than that of 8 bits, since frames without noise may have two values. 0 for
-- none.
readingStep :: [Raster] -> Double
readingStep frames = minimum (1 / 255 : [b - a | (a, b) <- zip values (drop 1 values)])
  where
    values = Set.toAscList (Set.fromList (concatMap some frames'))
    frames' = spacedOut 64 frames
    some frame =
      let v = rasterValues frame
          apart = max 1 (V.length v * length frames' `quot` 1024)
       in [v V.! k | k <- [0, apart .. V.length v - 1]]

-- | At most so many of a list, evenly.
spacedOut :: Int -> [a] -> [a]
spacedOut most xs
  | n <= most = xs
  | otherwise = [x | (k, x) <- zip [0 ..] xs, (k * most) `div` n /= ((k - 1) * most) `div` n]
  where
    n = length xs
