-- | Two frames registered by what they show alone, whatever it is.
module PraTactile.Stitch.Pair.Blind
  ( blindPosterior,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Image (Raster, mapRaster)
import PraTactile.Stitch.Blend (Place)
import PraTactile.Stitch.Pair.Overlap (displacementGrid, overlapOf)
import PraTactile.Stitch.Posterior
import PraTactile.Stitch.Spectrum

-- | The posterior of the place of the second image's upper left pixel in the first, from the
-- nominal one and how far around it to search, taxels. The process is that of the two frames. Gains
-- may differ: the ratio of the scales that the frames show is put right by a factor that is normal
-- as a logarithm, and summed over.
blindPosterior :: Spectra -> Process -> Place -> Double -> Raster -> Raster -> Posterior
blindPosterior tables process step search a b =
  posterior origin 1 size (V.generate (columns * rows) at)
  where
    (origin@(ox, oy), size@(columns, rows)) = displacementGrid step search
    (scaleA, scaleB) = case processScales process of
      [s, t] -> (s, t)
      _ -> (1, 1)
    scaled scale = mapRaster (* (if scale > 0 then 1 / sqrt scale else 0))
    a' = scaled scaleA a
    b' = scaled scaleB b
    at i = case overlapOf a' b' (round x) (round y) of
      Just (w, h, pa, pb)
        | w * h > 1 ->
          prior
            + fair (w * h)
              * together (shared tables process w h (transform w h pa) (transform w h pb))
      _ -> prior
      where
        (row, column) = i `quotRem` columns
        x = ox + fromIntegral column
        y = oy + fromIntegral row
        prior = priorAround search (x - fst step, y - snd step)
    -- An overlap counts as much as the nominal one, however large: one relief alike everywhere
    -- along an axis must not be drawn to where more of it is seen.
    fair n = max 0.5 (min 2 (nominal / fromIntegral n)) :: Double
    nominal = case overlapOf a b (round (fst step)) (round (snd step)) of
      Just (w, h, _, _) -> fromIntegral (w * h)
      Nothing -> 1
    transform w h p = cosineTransform tables w h p
    together sums = top + log (sum (map (\l -> exp (l - top)) logs) / fromIntegral (length logs))
      where
        logs = [sharedLog r sums + l | (r, l) <- ratios]
        top = maximum logs
    ratios =
      [(exp r, negate (r * r) / (2 * 0.16)) | k <- [-2 .. 2 :: Int], let r = 0.4 * fromIntegral k]
