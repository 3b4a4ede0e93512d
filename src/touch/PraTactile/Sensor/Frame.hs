-- | Presses of the tactile probe (the paper's section III): poses, frames, rigid motions, and the
-- plan of a scan.
--
-- Lengths are millimetres unless a name says taxels. x points right and y down, seen from outside
-- the face. Angles are degrees clockwise.
module PraTactile.Sensor.Frame
  ( -- * The sensor's geometry
    taxelPitch,
    sensorSide,
    taxelPitches,
    isTaxelPitch,

    -- * Frames
    SensorPose (..),
    Frame (..),
    scaledFrame,

    -- * Rigid motions
    Motion (..),
    stay,
    move,
    movePoint,
    andThen,
    inverse,

    -- * Planning a scan
    planScan,
    TaxelGrid (..),
    standardTaxelGrid,
    planScanOf,
    ProbeError (..),
  )
where

import PraTactile.Geometry (rotated, sensorSide, taxelPitch)
import PraTactile.Image (Raster)

-- | The least and the greatest accepted distance of neighbouring taxels, in millimetres.
taxelPitches :: (Double, Double)
taxelPitches = (0.05, 50)

-- | Whether a distance is within 'taxelPitches'.
isTaxelPitch :: Double -> Bool
isTaxelPitch taxel = taxel >= fst taxelPitches && taxel <= snd taxelPitches

-- | The sensor's pose in some coordinates: its centre in millimetres and its rotation in degrees
-- clockwise.
data SensorPose = SensorPose
  { poseX :: !Double,
    poseY :: !Double,
    poseRotation :: !Double
  }
  deriving stock (Eq, Ord, Show)

-- | One press of the probe. Its fields: the kinesthetic pose, which is that of the robot's own
-- position sensors, in the robot's coordinates; the force in newtons, 0 if unknown; the tactile
-- image, of any size; the distance of neighbouring taxels in millimetres; and the row and column
-- (from 0) of each dead element, whose pixel holds a replacement value.
data Frame = Frame
  { framePose :: !SensorPose,
    frameForce :: !Double,
    frameImage :: !Raster,
    frameTaxel :: !Double,
    frameDead :: ![(Int, Int)]
  }
  deriving stock (Eq, Show)

-- | The frame with all its lengths multiplied by a number: its position and its taxels' pitch.
scaledFrame :: Double -> Frame -> Frame
scaledFrame k frame =
  frame
    { framePose = (framePose frame) {poseX = k * poseX pose, poseY = k * poseY pose},
      frameTaxel = k * frameTaxel frame
    }
  where
    pose = framePose frame

-- | A rigid motion of the plane: a rotation about the origin (degrees clockwise), then a
-- translation (millimetres). As a change of coordinates it converts, for example, the robot's
-- coordinates to a face's.
data Motion = Motion
  { motionRotation :: !Double,
    motionX :: !Double,
    motionY :: !Double
  }
  deriving stock (Eq, Show)

-- | The identity motion.
stay :: Motion
stay = Motion 0 0 0

-- | A pose moved by a motion. Its rotation is reduced to [0, 360).
move :: Motion -> SensorPose -> SensorPose
move motion (SensorPose x y r) = SensorPose x' y' (turned (r + motionRotation motion))
  where
    (x', y') = movePoint motion (x, y)

-- | A point moved by a motion. Multiples of 90 degrees are exact.
--
-- >>> movePoint (Motion 90 10 0) (1, 2)
-- (8.0,1.0)
movePoint :: Motion -> (Double, Double) -> (Double, Double)
movePoint (Motion r tx ty) place = (x + tx, y + ty)
  where
    (x, y) = rotated (turned r) place

-- | The first motion followed by the second.
andThen :: Motion -> Motion -> Motion
andThen (Motion r x y) second = Motion (turned (r + motionRotation second)) x' y'
  where
    (x', y') = movePoint second (x, y)

-- | The inverse of a motion.
inverse :: Motion -> Motion
inverse (Motion r x y) = Motion (turned (negate r)) x' y'
  where
    (x', y') = movePoint (Motion (negate r) 0 0) (negate x, negate y)

-- | An angle in degrees reduced to [0, 360); infinities and NaN stay as they are.
turned :: Double -> Double
turned r
  | isNaN r || isInfinite r = r
  | r' >= 360 = 0
  | otherwise = r'
  where
    r' = r - 360 * fromIntegral (floor (r / 360) :: Integer)

-- | Why a scan cannot be planned.
data ProbeError
  = -- | The spacing, this number of taxels, is less than one.
    SpacingTooSmall !Int
  | -- | The region, with this width and height in taxels, is smaller than the standard sensor.
    RegionTooSmall !Int !Int
  | -- | The region is smaller than another sensor: the region's width and height, then the
    -- sensor's, all in taxels of 'taxelPitch'.
    RegionBelowSensor !Int !Int !Double !Double
  | -- | The region, with this width and height in taxels, would take more than 'maxPresses'
    -- presses.
    RegionTooLarge !Int !Int
  deriving stock (Eq, Show)

-- | The greatest number of presses of a plan.
maxPresses :: Double
maxPresses = 100000

-- | The grid of a sensor's elements: columns, rows, and the distance of neighbours in millimetres.
data TaxelGrid = TaxelGrid
  { taxelGridColumns :: !Int,
    taxelGridRows :: !Int,
    taxelGridPitch :: !Double
  }
  deriving stock (Eq, Show)

-- | 'sensorSide' elements along each side, 'taxelPitch' apart.
standardTaxelGrid :: TaxelGrid
standardTaxelGrid = TaxelGrid sensorSide sensorSide taxelPitch

-- | 'planScanOf' for the standard sensor. Arguments: the spacing of presses in taxels; the region's
-- upper left corner in millimetres; its width and height in taxels.
--
-- >>> length <$> planScan 8 (0, 0) (40, 52)
-- Right 24
planScan :: Int -> (Double, Double) -> (Int, Int) -> Either ProbeError [SensorPose]
planScan = planScanOf standardTaxelGrid

-- | The poses (rotation 0) of presses that cover a region exactly, row by row from the upper left.
-- The last row and column are flush with the region's edge. The arguments are the sensor's grid;
-- the spacing of presses in the sensor's own taxels; the region's upper left corner in millimetres;
-- and its width and height in taxels of 'taxelPitch'. Refuses a spacing below 1, a region smaller
-- than the sensor, and more than 'maxPresses' presses.
planScanOf :: TaxelGrid -> Int -> (Double, Double) -> (Int, Int) -> Either ProbeError [SensorPose]
planScanOf grid spacing (left, top) (width, height)
  | spacing < 1 = Left (SpacingTooSmall spacing)
  | wide < across || high < down = Left tooSmall
  | presses wide across * presses high down > maxPresses = Left (RegionTooLarge width height)
  | otherwise =
    Right
      [ SensorPose (centre left across x) (centre top down y) 0
        | y <- offsets high down,
          x <- offsets wide across
      ]
  where
    TaxelGrid columns rows taxel = grid
    (across, down) = (fromIntegral columns, fromIntegral rows) :: (Double, Double)
    -- Converts taxels of 'taxelPitch' to the sensor's own.
    (wide, high) = (own width, own height)
    own n = fromIntegral n * ratio
    ratio = taxelPitch / taxel
    tooSmall
      | grid == standardTaxelGrid = RegionTooSmall width height
      | otherwise = RegionBelowSensor width height (across / ratio) (down / ratio)
    step = fromIntegral spacing :: Double
    -- The number of 'offsets'.
    presses size side = 1 + fromIntegral (max 0 (ceiling (inside size side / step) :: Integer))
    offsets size side =
      takeWhile (< inside size side) (map ((step *) . fromIntegral) [0 :: Int ..]) ++ [size - side]
    inside size side = size - side - 1e-9
    centre edge side offset = edge + taxel * (offset + side / 2)
