{-# OPTIONS_HADDOCK hide #-}

-- | The mechanics of a press: which tabs of the elastic overlay meet the face, how far a rigid
-- sensor presses them in, and how their forces spread to the elements below.
--
-- Let x and y go from -1 to 1 between the edges of a rigid sensor. Let its right edge be nearer to
-- the face than its centre by a, and its lower edge by b. Let its centre be z below the plane on
-- which it would rest. Over a height h it is pressed in by
--
-- > d(x, y) = max 0 (z + a x + b y + h)
--
-- so readings are 0 where the tilt lifts it off the face. If forces are modelled, z is such that
-- the tabs carry the force. Otherwise readings are proportional to the height and z is 0, however
-- the sensor is tilted.
module PraTactile.Sensor.Press
  ( -- * What is touched
    HeightMap (..),
    heightMap,
    heightOf,

    -- * Tabs
    TabSupport (..),
    tabSupport,
    tabPoints,

    -- * The rigid press
    tiltRise,
    forceBalance,
    displacements,

    -- * Under the overlay
    pointSpread,
    spreadForces,
  )
where

import Data.List (sortOn)
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import qualified Data.Vector.Storable as V
import PraTactile.Image (Raster, generate, index, raster, rasterSize, rasterValues)
import PraTactile.Sensor.Bend
import PraTactile.Sensor.Frame (Motion (..), SensorPose (..), TaxelGrid (..), movePoint)

-- | The relief of a face, constant on square cells: the cell's side in millimetres, the first
-- cell, the heights in millimetres above the plane on which the probe rests, and the bend. The
-- upper left corner of cell (0, 0) is the origin of the face's coordinates. Outside the map, and
-- where the height is NaN, there is nothing to touch. A bent face is stored unrolled, with arc
-- lengths as coordinates.
data HeightMap = HeightMap
  { heightPitch :: !Double,
    -- | The column and the row of the first cell of the map.
    heightFrom :: !(Int, Int),
    heightValues :: !Raster,
    heightBend :: !(Maybe Bend)
  }
  deriving stock (Eq, Show)

-- | The height map of a flat face that begins at cell (0, 0).
heightMap :: Double -> Raster -> HeightMap
heightMap pitch heights = HeightMap pitch (0, 0) heights Nothing

-- | The height of the cell in a column and a row; 'Nothing' where there is nothing to touch.
heightOf :: HeightMap -> Int -> Int -> Maybe Double
heightOf (HeightMap _ (x0, y0) heights _) x y = case index heights (x - x0) (y - y0) of
  Just h | not (isNaN h) -> Just h
  _ -> Nothing
{-# INLINE heightOf #-}

-- | The ground under each tab of a sensor: the share of the tab's area that is on the face, and
-- the mean height there in millimetres.
data TabSupport = TabSupport
  { supportShare :: !Raster,
    supportHeight :: !Raster
  }
  deriving stock (Eq, Show)

-- | The ground under the tabs of a sensor at a pose in the face's coordinates, evaluated at
-- 'tabPoints'. The number is the tabs' diameter (mm; 0 for squares as wide as the taxel).
tabSupport :: TaxelGrid -> Double -> HeightMap -> SensorPose -> TabSupport
tabSupport (TaxelGrid columns rows taxel) diameter heights (SensorPose x y r) =
  TabSupport (part fst) (part snd)
  where
    part f = generate columns rows (\i j -> f (under i j))
    points = tabPoints taxel diameter
    count = fromIntegral (length points) :: Double
    under i j = case hits of
      [] -> (0, 0)
      _ -> (touched / count, sum hits / touched)
      where
        hits =
          [ h
            | (u, v) <- points,
              Just h <- [at (movePoint turn (place columns i + u, place rows j + v))]
          ]
        touched = fromIntegral (length hits)
    turn = Motion r 0 0
    place n k = taxel * (fromIntegral (k :: Int) - (fromIntegral n - 1) / 2)
    (alongX, alongY) = courses (heightBend heights)
    at (u, v)
      | cell > 0 = subtract (fall alongX u + fall alongY v) <$> heightOf heights column row
      | otherwise = Nothing
      where
        (column, row) = (floor ((x + arc alongX u) / cell), floor ((y + arc alongY v) / cell))
    cell = heightPitch heights

-- | The points at which a tab is evaluated, in millimetres from its centre: those of a 4 x 4 grid
-- that lie within its circle (twelve), or all of them for a square (diameter 0). The arguments are
-- the taxel pitch and the diameter (mm).
tabPoints :: Double -> Double -> [(Double, Double)]
tabPoints taxel diameter
  | diameter <= 0 = [(taxel * a, taxel * b) | b <- along, a <- along]
  | otherwise = [(diameter * a, diameter * b) | b <- along, a <- along, a * a + b * b <= 0.25]
  where
    along = [(fromIntegral (k :: Int) + 0.5) / 4 - 0.5 | k <- [0 .. 3]]

-- | The travel z of a rigid plate at which tabs carry a force: stiffness * sum of share * max 0 (z
-- + height) = force. The arguments are the stiffness (N/mm), the force (N), and each tab's share
-- and height (mm). 'Nothing' if no tab has ground under it. The sum is piecewise linear in z, so z
-- is found exactly, taking tabs in descending order of height.
forceBalance :: Double -> Double -> [(Double, Double)] -> Maybe Double
forceBalance stiffness force tabs =
  go 0 0 (sortOn (Down . snd) (filter ((> 0) . fst) tabs))
  where
    go _ _ [] = Nothing
    go shares moments ((share, height) : others)
      | bears others z = Just z
      | otherwise = go shares' moments' others
      where
        shares' = shares + share
        moments' = moments + share * height
        z = (force / stiffness - moments') / shares'
    -- Whether the next tab is not reached at this z.
    bears others z = case others of
      (_, next) : _ -> z + next <= 0
      [] -> True

-- | How much nearer to the face an element is than the sensor's centre: a x + b y. The arguments
-- are the sensor's width and height, the tilts a and b (mm), and the element's column and row.
tiltRise :: (Int, Int) -> (Double, Double) -> Int -> Int -> Double
tiltRise (w, h) (a, b) i j = a * across w i + b * across h j
  where
    across n k = (2 * fromIntegral k + 1 - fromIntegral n) / fromIntegral n :: Double

-- | The compression of each tab (mm) times its share: share * d(x, y), where z follows from the
-- force. The arguments are the stiffness (N/mm), the force (N), the tilts a and b (mm), and the
-- ground. All 0 where nothing is under the sensor.
displacements :: Double -> Double -> (Double, Double) -> TabSupport -> Raster
displacements stiffness force tilts (TabSupport shares heights) =
  generate w h (\x y -> share x y * max 0 (z + rest x y))
  where
    (w, h) = rasterSize shares
    share x y = fromMaybe 0 (index shares x y)
    rest x y = tiltRise (w, h) tilts x y + fromMaybe 0 (index heights x y)
    -- If no tab is reached, all shares are 0, and so are the compressions.
    z =
      fromMaybe 0 $
        forceBalance stiffness force [(share x y, rest x y) | y <- [0 .. h - 1], x <- [0 .. w - 1]]

-- | What an element feels of a point force at the surface, relative to the element right below the
-- force: (1 + r^2 / t^2)^(-5/2), the normal stress in an elastic half space (Boussinesq). The
-- arguments are the depth t (mm) and the distance along x and y (mm).
pointSpread :: Double -> (Double, Double) -> Double
pointSpread depth (dx, dy) = (1 + (dx * dx + dy * dy) / (depth * depth)) ** (-2.5)

-- | The forces that elements at a depth feel from forces on the tabs above. The arguments are the
-- pitch (mm), the depth (mm) and the forces. A point force's parts add up to the force, except for
-- parts beyond the sensor's edge. Parts beyond 6.2 depths, below 0.0001 of the maximum, are
-- dropped. At depth 0 the forces stay unchanged.
spreadForces :: Double -> Double -> Raster -> Raster
spreadForces taxel depth forces
  | depth <= 0 || reach == 0 = forces
  | otherwise = either (const forces) id (raster w h (V.generate (w * h) felt))
  where
    (w, h) = rasterSize forces
    reach = min (max w h) (floor (6.2 * depth / taxel)) :: Int
    side = 2 * reach + 1
    offsets = [(i, j) | j <- [-reach .. reach], i <- [-reach .. reach]]
    far i j = pointSpread depth (taxel * fromIntegral i, taxel * fromIntegral j)
    kernel = V.map (/ V.sum whole) whole
    whole = V.fromListN (side * side) [far i j | (i, j) <- offsets] :: V.Vector Double
    values = rasterValues forces
    felt k = rowsFrom (max 0 (y - reach)) 0
      where
        (y, x) = k `quotRem` w
        (x0, x1) = (max 0 (x - reach), min (w - 1) (x + reach))
        y1 = min (h - 1) (y + reach)
        rowsFrom v total
          | v > y1 = total
          | otherwise = rowsFrom (v + 1) (total + along v)
        along v =
          V.sum
            ( V.zipWith
                (*)
                (V.slice (v * w + x0) (x1 - x0 + 1) values)
                (V.slice ((v - y + reach) * side + (x0 - x + reach)) (x1 - x0 + 1) kernel)
            )
