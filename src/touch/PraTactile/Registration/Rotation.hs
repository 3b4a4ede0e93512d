{-# LANGUAGE BangPatterns #-}

-- | How a frame is turned against what it should show: the angle, and what is still wrong with its
-- place, by the method of Gauss and Newton on the squared differences of the grey values.
module PraTactile.Registration.Rotation
  ( Aligned (..),
    aligned,
    smooth,
    valueInside,
    rotationPrior,
    certainDeviation,
    certainRotation,
  )
where

import Data.List (foldl')
import Data.Maybe (mapMaybe)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster, generate, rasterHeight, rasterSize, rasterWidth, sample, toRows)

-- | How a frame lies.
data Aligned = Aligned
  { -- | What is to be added to its place, taxels right and down.
    alignedShift :: !Taxels,
    -- | By how many degrees it is turned about its centre, clockwise.
    alignedRotation :: !Double,
    -- | The standard deviation of that, degrees, with the prior's.
    alignedDeviation :: !Double
  }
  deriving stock (Eq, Show)

-- | How a frame lies against what it should show, which is told at places of a plane (taxels) or is
-- not known there, if its upper left pixel is thought to lie at the given one; its gain and offset
-- are free. Both must be 'smooth': else to move by half a taxel would take noise away between
-- pixels, and seem to fit. The most probable, if the angle is normal about 0 with that standard
-- deviation (degrees), and each coordinate of the place is with that of half a taxel. 'Nothing'
-- where it shares fewer than 12 pixels with what is known, or that is alike everywhere.
aligned :: Double -> (Double -> Double -> Maybe Double) -> Taxels -> Raster -> Maybe Aligned
aligned sigma known (x, y) image = go (8 :: Int) (Rigid 0 0 0)
  where
    (w, h) = rasterSize image
    (cx, cy) = (fromIntegral (w - 1) / 2, fromIntegral (h - 1) / 2)
    -- Those at the edge were not smoothed like the others.
    pixels =
      [ (u - cx, v - cy, value)
        | (v, row) <- inner (zip [0 ..] (toRows image)),
          (u, value) <- inner (zip [0 ..] row)
      ]
    inner = drop 1 . reverse . drop 1 . reverse
    go n now = do
      (step, deviation) <- better (sigma * pi / 180) now (mapMaybe (seen now) pixels)
      let next@(Rigid dx dy angle) = plus now step
      if n <= 1 || small step
        then Just (Aligned (dx, dy) (angle * 180 / pi) (deviation * 180 / pi))
        else go (n - 1) next
    small (Rigid dx dy angle) = max (abs dx) (abs dy) < 1e-4 && abs angle < 1e-5
    seen (Rigid dx dy angle) (u, v, value) = do
      let (c, s) = (cos angle, sin angle)
          (px, py) = (x + cx + dx + c * u - s * v, y + cy + dy + s * u + c * v)
      expected <- known px py
      right <- known (px + 0.5) py
      left <- known (px - 0.5) py
      below <- known px (py + 0.5)
      above <- known px (py - 0.5)
      let (gx, gy) = (right - left, below - above)
      pure (Pixel value expected gx gy (gx * (negate s * u - c * v) + gy * (c * u - s * v)))

-- | The standard deviation of a rotation before anything is known, degrees. Assumption: a little
-- more than that between two presses each of which is turned by 1.
rotationPrior :: Double
rotationPrior = 2

-- | A rotation of a larger standard deviation, degrees, is not told.
certainDeviation :: Double
certainDeviation = rotationPrior / 2

-- | The rotation, degrees clockwise, if its standard deviation is at most 'certainDeviation'.
certainRotation :: Aligned -> Maybe Double
certainRotation lies
  | alignedDeviation lies <= certainDeviation = Just (alignedRotation lies)
  | otherwise = Nothing

-- | An image as 'aligned' takes it: each pixel the mean of those around it with binomial weights,
-- over three along each axis, those beyond the edge as the nearest.
smooth :: Raster -> Raster
smooth image = along (\d -> (0, d)) (along (\d -> (d, 0)) image)
  where
    along towards from =
      generate (rasterWidth from) (rasterHeight from) $ \i j ->
        sum
          [ weight / 4 * sample from (fromIntegral (i + u)) (fromIntegral (j + v))
            | (d, weight) <- zip [-1 ..] [1, 2, 1],
              let (u, v) = towards d
          ]

-- | The sum of the squares of the correlations of a pixel of a 'smooth' image of white noise with
-- all others: as many pixels tell as much as one. Along an axis they are 1, 2/3 and 1/6.
alikeness :: Double
alikeness = alongAxis * alongAxis
  where
    alongAxis = 1 + 2 * (4 / 9 + 1 / 36)

-- | What a 'smooth' image shows at a place, between its pixels' centres but for those at its edge;
-- nothing beyond them.
valueInside :: Raster -> Double -> Double -> Maybe Double
valueInside image x y
  | x >= 1 && y >= 1 && x <= side rasterWidth && y <= side rasterHeight = Just (sample image x y)
  | otherwise = Nothing
  where
    side f = fromIntegral (f image - 2)

-- | A displacement and an angle in radians.
data Rigid = Rigid !Double !Double !Double

plus :: Rigid -> Rigid -> Rigid
plus (Rigid a b c) (Rigid d e f) = Rigid (a + d) (b + e) (c + f)

-- | What the frame reads at a pixel, what it should read, and how that changes with the
-- displacement and the angle.
data Pixel = Pixel !Double !Double !Double !Double !Double

-- | What is to be added to an estimate, and the standard deviation of the angle. The gain and the
-- offset are the best ones; what the slopes have in common with them tells nothing of the place.
better :: Double -> Rigid -> [Pixel] -> Maybe (Rigid, Double)
better sigma (Rigid dx dy angle) pixels
  | length pixels < 12 || ee <= 0 || gain <= 0 || determinant <= 0 = Nothing
  | otherwise = Just (Rigid (solved 0) (solved 1) (solved 2), sqrt (inverse 2 2))
  where
    n = fromIntegral (length pixels)
    mean f = sum (map f pixels) / n
    products f g = foldl' (\ !s p -> s + (f p - mf) * (g p - mg)) 0 pixels
      where
        (mf, mg) = (mean f, mean g)
    value (Pixel v _ _ _ _) = v
    expected (Pixel _ e _ _ _) = e
    slopes = [\(Pixel _ _ a _ _) -> a, \(Pixel _ _ _ b _) -> b, \(Pixel _ _ _ _ c) -> c]
    ee = products expected expected
    ve = products value expected
    gain = ve / ee
    against = map (products expected) slopes
    noise = max 1e-12 (alikeness * (products value value - gain * ve) / n)
    -- The information on the three, with the priors'.
    matrix =
      [ [ gain * gain * (products f g - a * b / ee) / noise + (if i == j then prior i else 0)
          | (j, g, b) <- zip3 [0 :: Int ..] slopes against
        ]
        | (i, f, a) <- zip3 [0 ..] slopes against
      ]
    prior i = if i < 2 then 4 else 1 / (sigma * sigma)
    vector =
      [ gain * (products value f - ve * a / ee) / noise - prior i * now
        | (i, f, a, now) <- zip4' [0 :: Int ..] slopes against [dx, dy, angle]
      ]
    zip4' as bs cs ds = zipWith (\(a, b) (c, d) -> (a, b, c, d)) (zip as bs) (zip cs ds)
    entry i j = matrix !! i !! j
    -- Cofactors of the symmetric matrix of three rows, by its next rows and columns in a circle.
    cofactor i j =
      entry (next i) (next j) * entry (next (next i)) (next (next j))
        - entry (next i) (next (next j)) * entry (next (next i)) (next j)
    next i = (i + 1) `mod` 3
    determinant = sum [entry 0 j * cofactor 0 j | j <- [0 .. 2]]
    inverse i j = cofactor i j / determinant
    solved i = sum (zipWith (\j v -> inverse i j * v) [0 ..] vector)
