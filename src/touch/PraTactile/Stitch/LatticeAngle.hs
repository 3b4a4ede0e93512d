-- | The angle at which the lattice of cells lies under frames, before any of them is registered.
module PraTactile.Stitch.LatticeAngle
  ( latticeAngle,
  )
where

import Data.List (find, foldl', sortOn)
import Data.Ord (Down (..))
import PraTactile.Image (Raster, standardDeviation)
import PraTactile.Stitch.Evidence
import PraTactile.Stitch.Spaced (spacedOut)
import PraTactile.Stitch.Spectrum
import PraTactile.Stitch.Template

-- | The angle in [-90, 90), in degrees clockwise, at which a lattice lies under frames, given its
-- tables at any angle, those at whole taxels, and perhaps the angle, up to quarter turns, at which
-- symbols seem to lie: near that angle or upright, if the frames are likelier to show that than any
-- other relief, else wherever they make it likeliest. To a degree, by a few of the frames, which
-- must be of the tables' size. 'Nothing' where they are likelier to show something else.
latticeAngle ::
  (Double -> Templates, Double -> Templates) ->
  Spectra ->
  Maybe Double ->
  [Raster] ->
  Maybe Double
latticeAngle (tables, coarse) processes hint images
  | shown 0 && all (\a -> finely a < finelyUpright) [-3, 3] = Just 0
  | otherwise = find shown angles
  where
    angles =
      map
        (upright . folded . settled . nearby . likeliest)
        [0 : concat [[a, a + 90] | Just a <- [hint]], [-90, -81 .. 81]]
    upright angle = if abs angle <= 1 then 0 else angle
    -- At whole taxels only it is told to a few degrees.
    likeliest candidates = snd (maximum [(roughly 5 a, a) | a <- candidates])
    nearby angle = snd (foldl' nearer (roughly 8 angle, angle) [4, 2])
    nearer best@(_, a) step = maximum (best : [(roughly 8 b, b) | b <- [a - step, a + step]])
    settled a = climbed (3 :: Int) (finely (a - 2)) (finely a) (finely (a + 2)) a
    -- The vertex of the parabola through three, of which the middle one is the highest.
    climbed n before here after angle
      | n > 0 && before > here = climbed (n - 1) (finely (angle - 4)) before here (angle - 2)
      | n > 0 && after > here = climbed (n - 1) here after (finely (angle + 4)) (angle + 2)
      | bend > 0 = angle + max (-1) (min 1 ((after - before) / bend))
      | otherwise = angle
      where
        bend = 2 * here - before - after
    -- By so many frames, those that show most.
    roughly count angle = seenBy (take count telling) (coarse angle)
    finely angle = seenBy (take 8 telling) (tables angle)
    finelyUpright = finely 0
    folded angle = angle - 180 * fromIntegral (floor ((angle + 90) / 180) :: Int)
    shown angle = seenBy few (tables angle) > blind
    seenBy some at = sum [evidenceLog (evidence at i) | i <- some]
    few = spacedOut 12 images
    telling = sortOn (Down . standardDeviation) images
    blind = sum (concat [processLogs (processOf processes misfit [coefficients i]) | i <- few])
    coefficients = coefficientsOf processes

-- | The least share of noise that relief of any kind is supposed to have where frames are asked
-- whether they show the lattice: symbols are not felt quite as they are drawn, and a frame without
-- noise would be likelier to show anything smooth than them.
misfit :: Double
misfit = 0.1
