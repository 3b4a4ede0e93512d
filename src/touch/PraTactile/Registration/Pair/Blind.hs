{-# OPTIONS_HADDOCK hide #-}

-- | Two frames registered by what they show alone, whatever it is: as a normal process, and by the
-- paper's zero-mean normalised cross-correlation, the baseline.
module PraTactile.Registration.Pair.Blind
  ( blindPosterior,
    correlationPosterior,
  )
where

import qualified Data.Vector as Boxed
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster, mapRaster, rasterHeight, rasterWidth)
import PraTactile.Image.Correlate (Overlap (..), overlapAt, referenceOf)
import PraTactile.Registration.Cosine
import PraTactile.Registration.Pair.Overlap
import PraTactile.Registration.Posterior
import PraTactile.Registration.Search (independent)
import PraTactile.Registration.Spectrum

-- | The posterior of the place of the second image's upper left pixel in the first, from the
-- nominal one and how far around it to search, taxels. The process is that of the two frames. Gains
-- may differ: the ratio of the scales that the frames show is put right by a factor that is summed
-- over.
blindPosterior :: Spectra -> Process -> Taxels -> Double -> (Raster, Raster) -> Posterior
blindPosterior tables process step search (a, b) =
  posterior origin 1 size (V.generate (columns * rows) at)
  where
    (origin@(ox, oy), size@(columns, rows)) = displacementGrid step search
    cosines = spectraCosines tables
    (scaleA, scaleB) = case processScales process of
      [s, t] -> (s, t)
      _ -> (1, 1)
    scaled scale = mapRaster (* (if scale > 0 then 1 / sqrt scale else 0))
    a' = scaled scaleA a
    b' = scaled scaleB b
    -- What both have in common at each displacement along x; its rows are transformed once.
    strips = Boxed.generate columns $ \column ->
      let Common xa xb w = across (round ox + column)
       in (w, strip cosines a' xa w, strip cosines b' xb w)
    across = inCommon (rasterWidth a) (rasterWidth b)
    down = inCommon (rasterHeight a) (rasterHeight b)
    at i
      | w * h > 1 =
        prior + fair (w * h) * sharedLog (shared tables process (w, h) (patch ya inA, patch yb inB))
      | otherwise = prior
      where
        (row, column) = i `quotRem` columns
        (w, inA, inB) = strips Boxed.! column
        Common ya yb h = down (round oy + row)
        patch from there = patchTransform cosines there from h
        x = ox + fromIntegral column
        y = oy + fromIntegral row
        prior = priorAround search (x - fst step, y - snd step)
    -- An overlap counts as much as the nominal one, however large: one relief alike everywhere
    -- along an axis must not be drawn to where more of it is seen.
    fair n = max 0.5 (min 2 (nominal / fromIntegral n)) :: Double
    nominal = fromIntegral (max 1 (w * h))
      where
        Common _ _ w = across (round (fst step))
        Common _ _ h = down (round (snd step))

-- | The posterior of the place of the second image's upper left pixel in the first, from the
-- nominal one and how far around it to search, taxels: the profile likelihood of normal pairs of
-- values with correlation rho, -(n/2) ln (1 - rho^2), where neighbouring pixels resemble each other
-- and so count for less than one each.
correlationPosterior :: Taxels -> Double -> Raster -> Raster -> Posterior
correlationPosterior step search a b = posterior origin 1 size (V.generate (columns * rows) at)
  where
    (origin@(ox, oy), size@(columns, rows)) = displacementGrid step search
    there = referenceOf a
    least = overlapWeight (overlapAt there b (fst step) (snd step))
    at i = prior + correlated (overlapAt there b x y)
      where
        (row, column) = i `quotRem` columns
        x = ox + fromIntegral column
        y = oy + fromIntegral row
        prior = priorAround search (x - fst step, y - snd step)
    correlated (Overlap n va vb cov)
      | n <= 1 || cov <= 0 || va <= 1e-12 || vb <= 1e-12 = 0
      | otherwise =
        negate (independent * min least n / 2) * log (1 - min 0.9999 (cov * cov / (va * vb)))
