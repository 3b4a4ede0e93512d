-- | Two frames registered by the paper's zero-mean normalised cross-correlation: the baseline.
module PraTactile.Registration.Pair.Correlation
  ( correlationPosterior,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Place)
import PraTactile.Image (Raster)
import PraTactile.Image.Correlate (Overlap (..), overlapAt, referenceOf)
import PraTactile.Registration.Pair.Overlap (displacementGrid)
import PraTactile.Registration.Posterior
import PraTactile.Registration.Search (independent)

-- | The posterior of the place of the second image's upper left pixel in the first, from the
-- nominal one and how far around it to search, taxels: the profile likelihood of normal pairs of
-- values with correlation rho, -(n/2) ln (1 - rho^2), where neighbouring pixels resemble each other
-- and so count for less than one each.
correlationPosterior :: Place -> Double -> Raster -> Raster -> Posterior
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
