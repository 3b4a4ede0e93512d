{-# OPTIONS_HADDOCK hide #-}

-- | Finds the angle alpha of the lattice of cells under unregistered frames. It maximises the sum
-- of log p(z) over a few frames: at whole taxels over the circle, then by steps of two degrees, and
-- at a parabola's vertex. Upright is tried first, unless symbols seem to lie at another angle, and
-- five frames at whole taxels show the lattice there and not upright.
--
-- There is a lattice if that sum exceeds the same sum of the likeliest normal process by 'sure'.
-- Schwarz's criterion first takes log N of each frame for the gain and the offset.
module PraTactile.Registration.Lattice.Angle
  ( latticeAngle,
  )
where

import Data.List (find, foldl', maximumBy, sortOn)
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..), comparing)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Geometry (parabolaVertex)
import PraTactile.Image (Raster, rasterSize, standardDeviation)
import PraTactile.Registration.Lattice.Fit
import PraTactile.Registration.Numbers (misfit, sure)
import PraTactile.Registration.Spectrum

-- | The fits at the angle in [-90, 90), in degrees clockwise, at which a lattice lies under the
-- frames, to a degree. Given are the fits at any angle, and the spectra for the first frame's size.
-- The hints are the angles, up to quarter turns, at which symbols seem to lie, the likeliest first.
-- The angle is upright or near one of the first three hints if the frames show the lattice there
-- rather than other relief. Otherwise it is the likeliest of all. Only a few frames of the first
-- one's size count. 'Nothing' if the frames are likelier to show something else.
latticeAngle :: (Double -> Fits) -> Spectra -> [Double] -> [Raster] -> Maybe Fits
latticeAngle at processes hints images
  | turned = find shown (angles ++ [upright])
  | shown upright && all (\a -> finely 5 (at a) < finely 5 upright) [-3, 3] = Just upright
  | otherwise = find shown angles
  where
    angles = map (atOrUpright . folded . climbed) [hinted, nearby (likeliest circle)]
    upright = at 0
    hinted = if turned then leading else likeliest (upright : asked)
    -- The likeliest quarter turn of each hint; the first of these that five frames show is taken.
    asked = [likeliest [at a, at (a + 90)] | a <- take 3 hints]
    leading = fromMaybe (likeliest asked) (find shownCoarsely asked)
    circle = map at [-90, -81 .. 81]
    -- Before more frames are tested: five do not show the lattice upright, and they prefer a hint's
    -- angle to upright.
    turned =
      not (shownCoarsely upright || null hints)
        && abs (fitsAngle leading) > 3
        && coarsely 5 leading - coarsely 5 upright > sure
    shownCoarsely = shownBy fitCoarse (take 5 telling)
    atOrUpright angle = if abs angle <= 1 then upright else at angle
    -- Whole taxels determine the angle only to a few degrees.
    likeliest = maximumOn (\fits -> (coarsely 5 fits, fitsAngle fits))
    nearby fits = foldl' nearer fits [4, 2]
    nearer fits by =
      maximumOn
        (\f -> (coarsely 8 f, fitsAngle f))
        [turnedBy (negate by) fits, fits, turnedBy by fits]
    turnedBy by fits = at (fitsAngle fits + by)
    -- Climbs by two degrees a step, then takes a parabola's vertex.
    climbed fits = climb (3 :: Int) (turnedBy (-2) fits) fits (turnedBy 2 fits)
    climb n before here after
      | n > 0 && by before > by here = climb (n - 1) (turnedBy (-2) before) before here
      | n > 0 && by after > by here = climb (n - 1) here after (turnedBy 2 after)
      | otherwise =
        fitsAngle here
          + 2 * maybe 0 (max (-0.5) . min 0.5) (parabolaVertex (by before) (by here) (by after))
      where
        by = finely 8
    -- Sums over count frames, those that vary most.
    coarsely count fits = summed fitCoarse (take count telling) fits
    finely count fits = summed fitLikely (take count telling) fits
    folded angle = angle - 180 * fromIntegral (floor ((angle + 90) / 180) :: Int)
    shown = shownBy fitLikely few
    shownBy told some fits =
      summed told some fits - sum (map (found . snd) some)
        > sum [blind !! k | (k, _) <- some] + sure
    -- A frame's gain and offset are fitted, and other relief has neither. Schwarz's criterion
    -- charges half the log of the number of pixels for each.
    found image = let (w, h) = rasterSize image in log (fromIntegral (w * h))
    summed told some fits = sum [told (fitsFrames fits !! k) | (k, _) <- some]
    few = spacedOut 12 usable
    telling = sortOn (Down . standardDeviation . snd) usable
    usable =
      [(k, i) | one : _ <- [images], (k, i) <- zip [0 ..] images, rasterSize i == rasterSize one]
    blind =
      [ fitShare fit * densityLog (fitTo processes (processOf processes misfit [seen]) seen)
        | (fit, image) <- zip (fitsFrames upright) images,
          let seen = coefficientsOf processes image
      ]
    maximumOn score = maximumBy (comparing score)
