-- | Explores a face with the simulated probe: overlapping presses cover a region of the face. The
-- robot knows their positions only in its own frame (the paper's section III).
module PraTactile.Explore
  ( -- * Regions
    ProbedRegion (..),
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

-- | A rectangle of a face that the probe covers. For a rotated region, 'regionRight' and
-- 'regionDown' describe the region turned back about its centre by 'regionAngle'.
data ProbedRegion = ProbedRegion
  { -- | from the face's upper left vertex to the region's upper left corner, in taxels to the right
    regionRight :: !Double,
    -- | from the face's upper left vertex to the region's upper left corner, in taxels down
    regionDown :: !Double,
    -- | the width as the robot sees it, in taxels
    regionWidth :: !Int,
    -- | the height as the robot sees it, in taxels
    regionHeight :: !Int,
    -- | the rotation of the face in the robot's frame, to the nearest quarter turn
    regionSymmetry :: !Symmetry,
    -- | the face's rotation beyond that quarter turn, in degrees clockwise
    regionAngle :: !Double
  }
  deriving stock (Eq, Show)

-- | The region's width and height on the face, in taxels.
regionExtent :: ProbedRegion -> (Int, Int)
regionExtent region
  | exchangesAxes (regionSymmetry region) = (regionHeight region, regionWidth region)
  | otherwise = (regionWidth region, regionHeight region)

-- | The region's upper left corner on the face, in millimetres to the right of and below the face's
-- upper left vertex.
regionCorner :: ProbedRegion -> (Double, Double)
regionCorner region = (taxelPitch * regionRight region, taxelPitch * regionDown region)

-- | The face's total rotation in the robot's frame, in degrees clockwise in [0, 360).
regionTurn :: ProbedRegion -> Double
regionTurn region = if turn < 0 then turn + 360 else turn
  where
    turn = degreesClockwise (regionSymmetry region) + regionAngle region

-- | The motion from the robot's frame to the face's, in millimetres. The robot's origin is the
-- region's upper left corner as the robot sees it; the face's origin is its upper left vertex.
regionMotion :: ProbedRegion -> Motion
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

-- | The motion of a rotated region, which takes its centre to its centre.
askew :: ProbedRegion -> Motion
askew region = turn {motionX = faceX - x, motionY = faceY - y}
  where
    turn = Motion (negate (regionTurn region)) 0 0
    (x, y) = movePoint turn (half (regionWidth region), half (regionHeight region))
    (wide, high) = regionExtent region
    (faceX, faceY) =
      (taxelPitch * regionRight region + half wide, taxelPitch * regionDown region + half high)
    half n = taxelPitch * fromIntegral n / 2

-- | The standard size, 40 taxels wide and 52 tall. It holds a whole 2-by-2 window at every phase of
-- the grid.
standardRegionSize :: (Int, Int)
standardRegionSize = (40, 52)

-- | The default width and height, in taxels, of a region that a sensor explores:
-- 'standardRegionSize', or the sensor's own side where that is longer.
regionSizeFor :: Sensor -> (Int, Int)
regionSizeFor sensor = (max wide (own sensorColumns), max high (own sensorRows))
  where
    (wide, high) = standardRegionSize
    own side = ceiling (fromIntegral (side sensor) * sensorTaxel sensor / taxelPitch - 1e-9)

-- | A region in another frame of the face's plane. The motion leads to that frame, in millimetres.
movedRegion :: Motion -> ProbedRegion -> ProbedRegion
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

-- | The rotations that a face may have in the robot's frame.
data Turns
  = -- | one of these rotations, with equal probabilities
    AmongTurns [Symmetry]
  | -- | this angle in degrees clockwise
    TurnedBy !Double
  | -- | any angle, with uniform density
    AnyAngle
  deriving stock (Eq, Show)

-- | 'drawnRegion' with one of these rotations.
randomRegion :: RandomGen g => [Symmetry] -> (Int, Int) -> LaidFace -> g -> (ProbedRegion, g)
randomRegion = drawnRegion . AmongTurns

-- | Draws a region at a uniform, real-valued place on a face. Arguments: the possible rotations;
-- the region's width and height in taxels as the robot sees it; the face.
--
-- Along each side of the face's bounding box, the shorter of box and region lies within the longer.
-- So a region reaches over an edge only where it must. The corners of a rotated region may reach
-- over an edge too. But where the region fits and its own bounding box does not, it is centred.
--
-- On a face that is not a rectangle, up to 'mostDrawn' regions are drawn, and the first that lies
-- wholly on the face is taken. If there is none, the one with the most of its corners and centre on
-- the face is taken.
drawnRegion :: RandomGen g => Turns -> (Int, Int) -> LaidFace -> g -> (ProbedRegion, g)
drawnRegion turns size face generator
  | fillsBox face = one
  | otherwise = fromMaybe one (find (whollyOn face . fst) found <|> most)
  where
    one = inBox turns size face generator
    found = take mostDrawn (iterate (inBox turns size face . snd) one)
    most = listToMaybe (sortOn (Down . shareOn face . fst) found)

-- | The most regions that are drawn to find one on the face.
mostDrawn :: Int
mostDrawn = 200

-- | Whether a face is a rectangle along its own axes.
fillsBox :: LaidFace -> Bool
fillsBox face = length spots == 4 && all atCorner spots
  where
    spots = map snd (laidCorners face)
    atCorner spot =
      let (x, y) = spotMillimetres spot in x `elem` ends fst && y `elem` ends snd
    ends side = let along = map (side . spotMillimetres) spots in [minimum along, maximum along]

-- | Whether a whole region lies on a face.
whollyOn :: LaidFace -> ProbedRegion -> Bool
whollyOn face region = shareOn face region == 5 && not (any meets (rimPairs corners))
  where
    -- In the robot's frame, the region is upright.
    corners =
      [ movePoint (inverse (regionMotion region)) (spotMillimetres spot)
        | (_, spot) <- laidCorners face
      ]
    (wide, high) = (side (regionWidth region), side (regionHeight region))
    side n = taxelPitch * fromIntegral n
    -- Whether a side has a point within the region: the side from s to t of its length, clipped.
    meets ((x1, y1), (x2, y2)) = from + 1e-9 < to
      where
        (from, to) = clipped (y1, y2 - y1) high (clipped (x1, x2 - x1) wide (0, 1))
    clipped (at, step) end (s, t)
      | step == 0 = if at > 0 && at < end then (s, t) else (1, 0)
      | otherwise =
        let (a, b) = (negate at / step, (end - at) / step) in (max s (min a b), min t (max a b))

-- | How many of a region's four corners and its centre lie on a face.
shareOn :: LaidFace -> ProbedRegion -> Int
shareOn face region =
  length (filter (insidePolygon corners . movePoint (regionMotion region)) points)
  where
    corners = map (spotMillimetres . snd) (laidCorners face)
    points = (wide / 2, high / 2) : [(x, y) | x <- [0, wide], y <- [0, high]]
    (wide, high) = (side (regionWidth region), side (regionHeight region))
    side n = taxelPitch * fromIntegral n

-- | Whether a point lies in a polygon: an odd number of sides is to the right of it.
insidePolygon :: [(Double, Double)] -> (Double, Double) -> Bool
insidePolygon corners (x, y) = odd (length (filter right (cyclicPairs corners)))
  where
    right ((x1, y1), (x2, y2)) =
      (y1 > y) /= (y2 > y) && x < x1 + (y - y1) * (x2 - x1) / (y2 - y1)

-- | Draws a region at a uniform place in a face's bounding box, or around it.
inBox :: RandomGen g => Turns -> (Int, Int) -> LaidFace -> g -> (ProbedRegion, g)
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
      ProbedRegion
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
    -- How far its bounding box extends beyond the region itself, on either side.
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

-- | The rotations of a face that lies upright or upside down.
halfTurns :: [Symmetry]
halfTurns = [turned 2, identity]

-- | The distance between neighbouring presses: 8 taxels, half the sensor's width.
frameSpacing :: Int
frameSpacing = 8

-- | The default distance between a sensor's neighbouring presses, in its own taxels: half its
-- shorter side.
defaultSpacing :: Sensor -> Int
defaultSpacing sensor = max 1 (min (sensorColumns sensor) (sensorRows sensor) `div` 2)

-- | Presses a randomly drawn specimen of the sensor on a region, at 'defaultSpacing'. The frames
-- come row by row. Their poses are nominal, in the robot's frame; their images are taken at the
-- true poses. Refuses what 'planScanOf' refuses.
explore :: RandomGen g => Sensor -> HeightMap -> ProbedRegion -> g -> Either ProbeError ([Frame], g)
explore sensor heights region generator =
  exploreWith sensor (defaultSpacing sensor) specimen heights region generator'
  where
    (specimen, generator') = drawSpecimen sensor generator

-- | Presses this specimen of the sensor on a region. The distance between presses is in the
-- sensor's taxels. Refuses what 'planScanOf' refuses.
exploreWith ::
  RandomGen g =>
  Sensor ->
  Int ->
  Specimen ->
  HeightMap ->
  ProbedRegion ->
  g ->
  Either ProbeError ([Frame], g)
exploreWith sensor spacing specimen heights region generator = do
  poses <-
    planScanOf (sensorTaxelGrid sensor) spacing (0, 0) (regionWidth region, regionHeight region)
  pure (scanWith sensor specimen heights (regionMotion region) poses generator)
