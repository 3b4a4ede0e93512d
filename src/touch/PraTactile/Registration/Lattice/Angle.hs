-- | The angle at which the lattice of cells lies under frames, before any of them is registered.
module PraTactile.Registration.Lattice.Angle
  ( latticeAngle,
  )
where

import Data.List (find, foldl', maximumBy, sortOn)
import Data.Ord (Down (..), comparing)
import qualified Data.Vector as Boxed
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Geometry (parabolaVertex)
import PraTactile.Image (Raster, rasterSize, standardDeviation)
import PraTactile.Registration.Lattice.Fit
import PraTactile.Registration.Spectrum

-- | What frames tell at the angle in [-90, 90), in degrees clockwise, at which a lattice lies under
-- them, given what they tell at any angle, and perhaps the angle, up to quarter turns, at which
-- symbols seem to lie: near that angle or upright, if the frames show that rather than any
-- other relief, else wherever they make it likeliest. To a degree, by a few of the frames that have
-- the first one's size, which the spectra must be for. 'Nothing' where they are likelier to show
-- something else.
latticeAngle :: (Double -> Fits) -> Spectra -> Maybe Double -> [Raster] -> Maybe Fits
latticeAngle at processes hint images
  | shown upright && all (\a -> finely (at a) < finely upright) [-3, 3] = Just upright
  | otherwise = find shown angles
  where
    angles =
      map
        (atOrUpright . folded . refined . likeliest)
        [upright : concat [[at a, at (a + 90)] | Just a <- [hint]], map at [-90, -81 .. 81]]
    upright = at 0
    atOrUpright angle = if abs angle <= 1 then upright else at angle
    -- At whole taxels only it is told to a few degrees.
    likeliest = maximumOn (\fits -> (coarsely 5 fits, fitsAngle fits))
    refined fits = fitsAngle fits + 2 * climbed (3 :: Int) nearby
      where
        -- By two degrees a step, as far as it is looked around.
        step k = steps Boxed.! (k + most)
        steps = Boxed.generate (2 * most + 1) (stepped . subtract most)
        stepped k = if k == 0 then fits else at (fitsAngle fits + 2 * fromIntegral k)
        most = 7
        nearby = foldl' nearer 0 [2, 1]
        nearer k by = maximumOn (\j -> (coarsely 8 (step j), j)) [k, k - by, k + by]
        climbed n k
          | n > 0 && before > here = climbed (n - 1) (k - 1)
          | n > 0 && after > here = climbed (n - 1) (k + 1)
          | otherwise =
            fromIntegral k + maybe 0 (max (-0.5) . min 0.5) (parabolaVertex before here after)
          where
            before = finely (step (k - 1))
            here = finely (step k)
            after = finely (step (k + 1))
    -- By so many frames, those that show most.
    coarsely count fits = summed fitCoarse (take count telling) fits
    finely fits = summed fitLikely (take 8 telling) fits
    folded angle = angle - 180 * fromIntegral (floor ((angle + 90) / 180) :: Int)
    shown fits = summed fitLikely few fits - sum (map (found . snd) few) > blind + sure
    -- The gain and the offset of a frame, which other relief does not have, are found from it: by
    -- Schwarz's criterion they cost half the logarithm of its pixels each.
    found image = let (w, h) = rasterSize image in log (fromIntegral (w * h))
    summed told some fits = sum [told (fitsFrames fits !! k) | (k, _) <- some]
    few = spacedOut 12 usable
    telling = sortOn (Down . standardDeviation . snd) usable
    usable =
      [(k, i) | one : _ <- [images], (k, i) <- zip [0 ..] images, rasterSize i == rasterSize one]
    blind =
      sum
        [ fitShare (fitsFrames upright !! k) * sum (processLogs process)
          | (k, i) <- few,
            let process = processOf processes misfit [coefficients i]
        ]
    coefficients = coefficientsOf processes
    maximumOn score = maximumBy (comparing score)

-- | How much likelier, as a natural logarithm, the lattice must be than other relief, where either
-- is as probable beforehand: for a posterior of 0.99.
sure :: Double
sure = log 99

-- | The least share of noise that relief of any kind is supposed to have where frames are asked
-- whether they show the lattice: symbols are not felt quite as they are drawn, and a frame without
-- noise would be likelier to show anything smooth than them.
misfit :: Double
misfit = 0.1
