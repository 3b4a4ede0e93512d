{-# OPTIONS_HADDOCK hide #-}

-- | The angle alpha at which the lattice of cells lies under frames, before any is registered. It
-- is maximised over the sum of log p(z) of a few frames: at whole taxels over the circle, then by
-- steps of two degrees, and by a parabola's vertex. Upright is asked first, unless symbols seem to
-- lie at another angle and five frames at whole taxels show the lattice there and not upright.
--
-- There is a lattice if that sum, less log N of each frame (the gain and the offset, by Schwarz's
-- criterion), is above the same sum of the likeliest normal process by 'sure'.
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

-- | What frames tell at the angle in [-90, 90), in degrees clockwise, at which a lattice lies under
-- them, given what they tell at any angle, and the angles, up to quarter turns, at which symbols
-- seem to lie, the likeliest first: near one of the first three or upright, if the frames show that
-- rather than any other relief, else wherever they make it likeliest. To a degree, by a few of the
-- frames that have the first one's size, which the spectra must be for. 'Nothing' where they are
-- likelier to show something else.
latticeAngle :: (Double -> Fits) -> Spectra -> [Double] -> [Raster] -> Maybe Fits
latticeAngle at processes hints images
  | turned = find shown (angles ++ [upright])
  | shown upright && all (\a -> finely 5 (at a) < finely 5 upright) [-3, 3] = Just upright
  | otherwise = find shown angles
  where
    angles = map (atOrUpright . folded . climbed) [hinted, nearby (likeliest circle)]
    upright = at 0
    hinted = if turned then leading else likeliest (upright : asked)
    -- The likeliest at each hint, and of these the first that five frames show.
    asked = [likeliest [at a, at (a + 90)] | a <- take 3 hints]
    leading = fromMaybe (likeliest asked) (find shownCoarsely asked)
    circle = map at [-90, -81 .. 81]
    -- Before more frames are asked: five do not show it upright, and at a hint's angle show it
    -- rather than upright.
    turned =
      not (shownCoarsely upright || null hints)
        && abs (fitsAngle leading) > 3
        && coarsely 5 leading - coarsely 5 upright > sure
    shownCoarsely = shownBy fitCoarse (take 5 telling)
    atOrUpright angle = if abs angle <= 1 then upright else at angle
    -- At whole taxels only it is told to a few degrees.
    likeliest = maximumOn (\fits -> (coarsely 5 fits, fitsAngle fits))
    nearby fits = foldl' nearer fits [4, 2]
    nearer fits by =
      maximumOn
        (\f -> (coarsely 8 f, fitsAngle f))
        [turnedBy (negate by) fits, fits, turnedBy by fits]
    turnedBy by fits = at (fitsAngle fits + by)
    -- Uphill by two degrees a step, and to a parabola's vertex.
    climbed fits = climb (3 :: Int) (turnedBy (-2) fits) fits (turnedBy 2 fits)
    climb n before here after
      | n > 0 && by before > by here = climb (n - 1) (turnedBy (-2) before) before here
      | n > 0 && by after > by here = climb (n - 1) here after (turnedBy 2 after)
      | otherwise =
        fitsAngle here
          + 2 * maybe 0 (max (-0.5) . min 0.5) (parabolaVertex (by before) (by here) (by after))
      where
        by = finely 8
    -- By so many frames, those that show most.
    coarsely count fits = summed fitCoarse (take count telling) fits
    finely count fits = summed fitLikely (take count telling) fits
    folded angle = angle - 180 * fromIntegral (floor ((angle + 90) / 180) :: Int)
    shown = shownBy fitLikely few
    shownBy told some fits =
      summed told some fits - sum (map (found . snd) some)
        > sum [blind !! k | (k, _) <- some] + sure
    -- The gain and the offset of a frame, which other relief does not have, are found from it: by
    -- Schwarz's criterion they cost half the logarithm of its pixels each.
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
