{-# OPTIONS_HADDOCK hide #-}

-- | Relief that is constant along one direction, as a straight edge is. The frames do not determine
-- a displacement along it: its best fit there only follows the noise.
module PraTactile.Registration.Pair.Straight
  ( alongStraight,
    straightness,
  )
where

import Data.List (foldl')
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Noise (frameNoise)
import PraTactile.Image (Raster, rasterValues)
import PraTactile.Registration.Overlap (patchesAt)
import PraTactile.Registration.Posterior

-- | Replaces the posterior along a direction of constant relief by the prior, given the nominal
-- displacement and the search around it in taxels. Without such a direction the posterior stays.
-- The grid is of whole taxels.
alongStraight :: Taxels -> Double -> (Raster, Raster) -> GridPosterior -> GridPosterior
alongStraight step search (a, b) found = case straightness best a b of
  Just direction -> posterior origin 1 size (V.generate (columns * rows) (along direction))
  Nothing -> found
  where
    GridPosterior origin@(ox, oy) _ size@(columns, rows) masses = found
    best =
      let (row, column) = V.maxIndex masses `quotRem` columns
       in (round ox + column, round oy + row)
    priors = posteriorMasses (priorAlone search step found)
    -- The probability of all displacements along the line, distributed by the prior.
    along (dx, dy) i =
      log (priors V.! i * sum (map (masses V.!) line) / sum (map (priors V.!) line))
      where
        (row, column) = i `quotRem` columns
        reach = max columns rows
        line =
          [ y * columns + x
            | t <- [negate reach .. reach],
              let x = column + round (fromIntegral t * dx)
                  y = row + round (fromIntegral t * dy),
              x >= 0 && x < columns && y >= 0 && y < rows
          ]

-- | The unit vector along which the relief in both frames is constant, if there is one. The
-- displacement is the place of the second's upper left pixel in the first. Along the vector the
-- products of the two frames' slopes stay within noise; across it they exceed noise. Noise is
-- independent in both frames, so that it adds nothing to the products in the mean.
straightness :: (Int, Int) -> Raster -> Raster -> Maybe Taxels
straightness (x, y) a b = do
  ((w, h), pa, pb) <- patchesAt a b (x, y)
  let products = foldl' plus (Products 0 0 0) [between w pa pb i | i <- interior w h]
      count = fromIntegral (length (interior w h))
      (least, most, direction) = axesOf products
      unit = slopeVariance * noiseOf a * noiseOf b * sqrt (count * alikeness)
  if count > 0 && least < telling * unit && most >= 4 * telling * unit
    then Just direction
    else Nothing
  where
    interior w h = [v * w + u | v <- [1 .. h - 2], u <- [1 .. w - 2]]
    telling = 4.5
    noiseOf image =
      let values = rasterValues image
       in max (frameNoise [image]) (0.001 * (V.maximum values - V.minimum values))

-- | Sums of the products of two images' slopes: along x, along both axes, and along y.
data Products = Products !Double !Double !Double

plus :: Products -> Products -> Products
plus (Products a b c) (Products d e f) = Products (a + d) (b + e) (c + f)

-- | The products at an inner pixel, given by index, of two patches of the given width.
between :: Int -> V.Vector Double -> V.Vector Double -> Int -> Products
between w a b i = Products (ax * bx) ((ax * by + ay * bx) / 2) (ay * by)
  where
    (ax, ay) = slopes a
    (bx, by) = slopes b
    slopes v = ((column 1 - column (-1)) / 8, (row w - row (negate w)) / 8)
      where
        column d = v V.! (i + d - w) + 2 * v V.! (i + d) + v V.! (i + d + w)
        row d = v V.! (i + d - 1) + 2 * v V.! (i + d) + v V.! (i + d + 1)

-- | The variance of a slope under white noise of variance 1: the sum of the squared weights.
slopeVariance :: Double
slopeVariance = 12 / 64

-- | The sum of the squared correlations of a slope with all others, under white noise. The
-- smoothing has correlations 1, 2/3 and 1/6, the difference 1 and -1/2.
alikeness :: Double
alikeness = (1 + 2 * (4 / 9 + 1 / 36)) * (1 + 2 / 4)

-- | The least and the most product along any direction, and the direction of the least.
axesOf :: Products -> (Double, Double, Taxels)
axesOf (Products xx xy yy) = (middle - radius, middle + radius, (negate (sin angle), cos angle))
  where
    middle = (xx + yy) / 2
    radius = sqrt ((xx - yy) * (xx - yy) / 4 + xy * xy)
    -- The angle of the most.
    angle = atan2 (2 * xy) (xx - yy) / 2
