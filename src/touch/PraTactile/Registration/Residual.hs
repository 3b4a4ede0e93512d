{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The differences between frames at their places, in grey values.
module PraTactile.Registration.Residual
  ( residual,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Blend (..), Taxels, blend)
import PraTactile.Image (Raster, rasterHeight, rasterValues, rasterWidth)
import PraTactile.Image.Correlate (Reference, reference, referenceAt)

-- | The standard deviation of one frame from the others, over all pixels that others saw, grey
-- values. Images come with their places, in taxels. 'Nothing' if none overlap.
residual :: [(Taxels, Raster)] -> Maybe Double
residual placed
  | total > 0 = Just (sqrt (sum [s * n | (s, n) <- found] / total))
  | otherwise = Nothing
  where
    found = differencesOf placed
    total = sum (map snd found)

-- | For each frame the mean squared difference from the others, and the number of pixels that
-- others saw. It comes from the blend of all, corrected for the frame's own part and for the
-- others' noise.
differencesOf :: [(Taxels, Raster)] -> [(Double, Double)]
differencesOf placed = map each onGrid
  where
    x0 = floor (minimum (map (fst . fst) placed)) :: Int
    y0 = floor (minimum (map (snd . fst) placed)) :: Int
    wide = maximum [ceiling x - x0 + rasterWidth i + 1 | ((x, _), i) <- placed]
    high = maximum [ceiling y - y0 + rasterHeight i + 1 | ((_, y), i) <- placed]
    onGrid = [((x - fromIntegral x0, y - fromIntegral y0), i) | ((x, y), i) <- placed]
    Blend sums weights = blend wide high onGrid
    each ((x, y), image) = case reference sums weights of
      Right there -> compared there x y image
      Left _ -> (0, 0)

compared :: Reference -> Double -> Double -> Raster -> (Double, Double)
compared there x y image = (if n > 0 then total / n else 0, n)
  where
    w = rasterWidth image
    (total, n) = V.ifoldl' step (0, 0) (rasterValues image)
    step (!s, !k) i f =
      let (v, u) = i `quotRem` w
       in case referenceAt there (x + fromIntegral u) (y + fromIntegral v) of
            Just (c, m) | m > 1.5 -> (s + (f - c) * (f - c) * m / (m - 1), k + 1)
            _ -> (s, k)
