-- | Exploring a face with the simulated probe: a region of the face is covered by overlapping
-- presses whose positions the robot knows in its own frame of coordinates only (the paper's section
-- III).
module PraTactile.Explore
  ( -- * Regions
    Region (..),
    regionExtent,
    regionCorner,
    regionTurn,
    regionMotion,
    movedRegion,
    Turns (..),
    drawnRegion,
    randomRegion,
    standardRegionSize,
    regionSizeFor,
    halfTurns,

    -- * Pressing
    explore,
    exploreWith,
    frameSpacing,
    defaultSpacing,

    -- * Polygons
    insidePolygon,
    fillsBox,
  )
where

import Control.Applicative ((<|>))
import Data.Bifunctor (first)
import Data.List (find, sortOn)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Ord (Down (..))
import PraTactile.Geometry (cosineSine)
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Placement (LaidFace (..), spotMillimetres)
import PraTactile.Object.Rims
import PraTactile.Random (uniform)
import PraTactile.Sensor
import PraTactile.Sensor.Frame
  ( Frame,
    Motion (..),
    ProbeError,
    inverse,
    movePoint,
    planScanOf,
    taxelPitch,
  )
import PraTactile.Symmetry
import System.Random (RandomGen)

-- | A rectangle of a face that the probe covers. Where it lies askew, 'regionRight' and
-- 'regionDown' are of the region turned back about its centre by 'regionAngle'.
data Region = Region
  { -- | from the face's upper left vertex to the region's upper left corner, taxels to the right
    regionRight :: !Double,
    -- | and down
    regionDown :: !Double,
    -- | as the robot sees it, taxels
    regionWidth :: !Int,
    -- | likewise
    regionHeight :: !Int,
    -- | the rotation of the face in the robot's frame, to the nearest quarter turn
    regionSymmetry :: !Symmetry,
    -- | by how many degrees clockwise the face is turned further than that
    regionAngle :: !Double
  }
  deriving stock (Eq, Show)

-- | The region's width and height on the face, taxels.
regionExtent :: Region -> (Int, Int)
regionExtent region
  | exchangesAxes (regionSymmetry region) = (regionHeight region, regionWidth region)
  | otherwise = (regionWidth region, regionHeight region)

-- | The region's upper left corner on the face, in millimetres to the right of and below the face's
-- upper left vertex.
regionCorner :: Region -> (Double, Double)
regionCorner region = (taxelPitch * regionRight region, taxelPitch * regionDown region)

-- | The whole rotation of the face in the robot's frame, degrees clockwise in [0, 360).
regionTurn :: Region -> Double
regionTurn region = if turn < 0 then turn + 360 else turn
  where
    turn = degreesClockwise (regionSymmetry region) + regionAngle region

-- | From the robot's frame, whose origin is the region's upper left corner as the robot sees it, to
-- the face's, whose origin is the face's upper left vertex; millimetres.
regionMotion :: Region -> Motion
regionMotion region
  | regionAngle region /= 0 = askew region
  | otherwise =
    Motion
      { motionRotation = degreesClockwise (invert (regionSymmetry region)),
        motionX =
          taxelPitch
            * (regionRight region + fromIntegral (if turns `elem` [2, 3] then wide else 0)),
        motionY =
          taxelPitch * (regionDown region + fromIntegral (if turns `elem` [1, 2] then high else 0))
      }
  where
    turns = quarterTurns (regionSymmetry region)
    (wide, high) = regionExtent region

-- | The motion of a region that lies askew: its centre to its centre.
askew :: Region -> Motion
askew region = turn {motionX = faceX - x, motionY = faceY - y}
  where
    turn = Motion (negate (regionTurn region)) 0 0
    (x, y) = movePoint turn (half (regionWidth region), half (regionHeight region))
    (wide, high) = regionExtent region
    (faceX, faceY) =
      (taxelPitch * regionRight region + half wide, taxelPitch * regionDown region + half high)
    half n = taxelPitch * fromIntegral n / 2

-- | 40 wide, 52 tall, in taxels: enough to hold a whole 2-by-2 window at every phase of the grid.
standardRegionSize :: (Int, Int)
standardRegionSize = (40, 52)

-- | The usual width and height of a region that a sensor explores, taxels: 'standardRegionSize', or
-- along each side the sensor's own where that is longer.
regionSizeFor :: Sensor -> (Int, Int)
regionSizeFor sensor = (max wide (own sensorColumns), max high (own sensorRows))
  where
    (wide, high) = standardRegionSize
    own side = ceiling (fromIntegral (side sensor) * sensorTaxel sensor / taxelPitch - 1e-9)

-- | A region in another frame of the face's plane, to which the motion leads; millimetres.
movedRegion :: Motion -> Region -> Region
movedRegion motion region = sized {regionRight = x - half wide, regionDown = y - half high}
  where
    (symmetry, angle) = nearestQuarter (regionTurn region - motionRotation motion)
    sized = region {regionSymmetry = symmetry, regionAngle = angle}
    (wide, high) = regionExtent sized
    (x, y) =
      let middle = (taxelPitch * half (regionWidth region), taxelPitch * half (regionHeight region))
          (right, down) = movePoint motion (movePoint (regionMotion region) middle)
       in (right / taxelPitch, down / taxelPitch)
    half n = fromIntegral n / 2

-- | How a face may lie in the robot's frame.
data Turns
  = -- | in one of these rotations, all equally likely
    AmongTurns [Symmetry]
  | -- | turned by this many degrees clockwise
    TurnedBy !Double
  | -- | turned by any angle, all equally likely
    AnyAngle
  deriving stock (Eq, Show)

-- | 'drawnRegion' in one of these rotations.
randomRegion :: RandomGen g => [Symmetry] -> (Int, Int) -> LaidFace -> g -> (Region, g)
randomRegion = drawnRegion . AmongTurns

-- | A region of this size (width and height in taxels, as the robot sees it) at a uniform,
-- real-valued place on a face that may lie so. Along each side of the box round the face the
-- shorter of face and region lies within the longer, so that a region reaches over an edge only
-- where it has to. A region that lies askew may do so with its corners, though not further than the
-- face needs to hold it: along a side where the smallest upright rectangle around it is longer than
-- the face's, and the region itself is not, it lies in the middle. On a face that is no rectangle
-- it is the first of 'mostDrawn' such regions of its box that lies wholly on it, or that one with
-- the most of its corners and middle on it.
drawnRegion :: RandomGen g => Turns -> (Int, Int) -> LaidFace -> g -> (Region, g)
drawnRegion turns size face generator
  | fillsBox face = one
  | otherwise = fromMaybe one (find (whollyOn face . fst) found <|> most)
  where
    one = inBox turns size face generator
    found = take mostDrawn (iterate (inBox turns size face . snd) one)
    most = listToMaybe (sortOn (Down . shareOn face . fst) found)

-- | How many regions are drawn at most for one that lies on a face.
mostDrawn :: Int
mostDrawn = 200

-- | Whether a face is the box round it.
fillsBox :: LaidFace -> Bool
fillsBox face = length spots == 4 && all atCorner spots
  where
    spots = map snd (laidCorners face)
    atCorner spot =
      let (x, y) = spotMillimetres spot in x `elem` ends fst && y `elem` ends snd
    ends side = let along = map (side . spotMillimetres) spots in [minimum along, maximum along]

-- | Whether a region lies on a face with all of it.
whollyOn :: LaidFace -> Region -> Bool
whollyOn face region = shareOn face region == 5 && not (any meets (rimPairs corners))
  where
    -- As the robot sees it, the region is upright.
    corners =
      [ movePoint (inverse (regionMotion region)) (spotMillimetres spot)
        | (_, spot) <- laidCorners face
      ]
    (wide, high) = (side (regionWidth region), side (regionHeight region))
    side n = taxelPitch * fromIntegral n
    -- Whether a side has a point within the region: that of its part from s to t of the whole.
    meets ((x1, y1), (x2, y2)) = from + 1e-9 < to
      where
        (from, to) = clipped (y1, y2 - y1) high (clipped (x1, x2 - x1) wide (0, 1))
    clipped (at, step) end (s, t)
      | step == 0 = if at > 0 && at < end then (s, t) else (1, 0)
      | otherwise =
        let (a, b) = (negate at / step, (end - at) / step) in (max s (min a b), min t (max a b))

-- | How many of a region's corners and its middle lie on a face.
shareOn :: LaidFace -> Region -> Int
shareOn face region =
  length (filter (insidePolygon corners . movePoint (regionMotion region)) points)
  where
    corners = map (spotMillimetres . snd) (laidCorners face)
    points = (wide / 2, high / 2) : [(x, y) | x <- [0, wide], y <- [0, high]]
    (wide, high) = (side (regionWidth region), side (regionHeight region))
    side n = taxelPitch * fromIntegral n

-- | Whether a point lies in a polygon: an odd number of sides lie to the right of it.
insidePolygon :: [(Double, Double)] -> (Double, Double) -> Bool
insidePolygon corners (x, y) = odd (length (filter right (cyclicPairs corners)))
  where
    right ((x1, y1), (x2, y2)) =
      (y1 > y) /= (y2 > y) && x < x1 + (y - y1) * (x2 - x1) / (y2 - y1)

-- | A region at a uniform place in the box round a face, or with that box in it.
inBox :: RandomGen g => Turns -> (Int, Int) -> LaidFace -> g -> (Region, g)
inBox turns (width, height) face generator =
  ( region
      { regionRight = boxRight + offset u roomRight (overhang wide high),
        regionDown = boxDown + offset v roomDown (overhang high wide)
      },
    generator4
  )
  where
    (boxRight, boxDown) =
      let (x, y) = spotMillimetres (laidBox face) in (x / taxelPitch, y / taxelPitch)
    region =
      Region
        { regionRight = 0,
          regionDown = 0,
          regionWidth = width,
          regionHeight = height,
          regionSymmetry = symmetry,
          regionAngle = angle
        }
    (wide, high) = regionExtent region
    roomRight = room (fst extent) wide
    roomDown = room (snd extent) high
    extent = spotMillimetres (laidExtent face)
    room millimetres size = millimetres / taxelPitch - fromIntegral size :: Double
    -- What the rectangle around it has more than the region itself, on either side.
    overhang along across
      | angle == 0 = 0
      | otherwise =
        ( cosine * fromIntegral along + abs sine * fromIntegral across
            - fromIntegral along
        )
          / 2
    (cosine, sine) = cosineSine angle
    offset share space beyond
      | beyond == 0 || space < 0 = share * space
      | space - 2 * beyond <= 0 = space / 2
      | otherwise = beyond + share * (space - 2 * beyond)
    ((symmetry, angle), generator4) = case turns of
      AmongTurns possible -> ((drawnOf possible, 0), generator3)
      TurnedBy degrees -> (nearestQuarter degrees, generator3)
      AnyAngle -> first (nearestQuarter . (360 *)) (uniform generator3)
    drawnOf possible = case drop (floor (w * fromIntegral (length possible))) possible of
      one : _ -> one
      [] -> identity
    (u, generator1) = uniform generator
    (v, generator2) = uniform generator1
    (w, generator3) = uniform generator2

-- | A face that lies upright or turned by 180 degrees.
halfTurns :: [Symmetry]
halfTurns = [turned 2, identity]

-- | The distance of neighbouring presses: 8 taxels, half the sensor's width.
frameSpacing :: Int
frameSpacing = 8

-- | The distance of a sensor's neighbouring presses, in its own taxels: half of its shorter side.
defaultSpacing :: Sensor -> Int
defaultSpacing sensor = max 1 (min (sensorColumns sensor) (sensorRows sensor) `div` 2)

-- | The frames of a region, row by row, of a specimen by chance at 'defaultSpacing': nominal poses
-- in the robot's frame, images taken at the true ones.
explore :: RandomGen g => Sensor -> HeightMap -> Region -> g -> Either ProbeError ([Frame], g)
explore sensor heights region generator =
  exploreWith sensor (defaultSpacing sensor) specimen heights region generator'
  where
    (specimen, generator') = drawSpecimen sensor generator

-- | The same of this specimen, with presses so many of the sensor's taxels apart.
exploreWith ::
  RandomGen g =>
  Sensor ->
  Int ->
  Specimen ->
  HeightMap ->
  Region ->
  g ->
  Either ProbeError ([Frame], g)
exploreWith sensor spacing specimen heights region generator = do
  poses <-
    planScanOf (sensorTaxelGrid sensor) spacing (0, 0) (regionWidth region, regionHeight region)
  pure (scanWith sensor specimen heights (regionMotion region) poses generator)
