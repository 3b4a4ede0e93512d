-- | Probing (the paper's section III): where the tactile probe is pressed down, what it sends back,
-- and the plan of a scan.
--
-- Lengths are millimetres unless a name says taxels; x points right, y down, seen from outside the
-- face; angles are degrees clockwise.
module PraTactile.Sensor.Frame
  ( -- * The sensor's geometry
    taxelPitch,
    sensorSide,
    taxelPitches,
    isTaxelPitch,

    -- * Frames
    Pose (..),
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

-- | The least and the greatest distance of neighbouring taxels that a sensor may have, millimetres.
taxelPitches :: (Double, Double)
taxelPitches = (0.05, 50)

-- | Whether a distance lies between them.
isTaxelPitch :: Double -> Bool
isTaxelPitch taxel = taxel >= fst taxelPitches && taxel <= snd taxelPitches

-- | Where the sensor is: its centre in millimetres, and its rotation in degrees clockwise, in some
-- frame of coordinates.
data Pose = Pose
  { poseX :: !Double,
    poseY :: !Double,
    poseRotation :: !Double
  }
  deriving stock (Eq, Ord, Show)

-- | One press of the probe: the kinesthetic pose (what the robot's own position sensors say, in its
-- own frame of coordinates), the force in newtons, 0 where none is told, the tactile image, of any
-- size, the distance of its neighbouring taxels in millimetres, and which of them felt nothing,
-- because the element is dead: rows and columns from 0 of pixels whose value only stands for one.
data Frame = Frame
  { framePose :: !Pose,
    frameForce :: !Double,
    frameImage :: !Raster,
    frameTaxel :: !Double,
    frameDead :: ![(Int, Int)]
  }
  deriving stock (Eq, Show)

-- | The frame with all its lengths times a number.
scaledFrame :: Double -> Frame -> Frame
scaledFrame k frame =
  frame
    { framePose = (framePose frame) {poseX = k * poseX pose, poseY = k * poseY pose},
      frameTaxel = k * frameTaxel frame
    }
  where
    pose = framePose frame

-- | A rigid motion of the plane: a turn about the origin (degrees clockwise), then a shift
-- (millimetres). As a change of coordinates it carries what is said in one frame of coordinates,
-- such as the robot's, to another, such as a face's.
data Motion = Motion
  { motionRotation :: !Double,
    motionX :: !Double,
    motionY :: !Double
  }
  deriving stock (Eq, Show)

-- | The motion that leaves everything where it is.
stay :: Motion
stay = Motion 0 0 0

-- | A pose carried along by a motion. The rotation is kept in [0, 360).
move :: Motion -> Pose -> Pose
move motion (Pose x y r) = Pose x' y' (turned (r + motionRotation motion))
  where
    (x', y') = movePoint motion (x, y)

-- | A point carried along by a motion. Multiples of 90 degrees are exact.
--
-- >>> movePoint (Motion 90 10 0) (1, 2)
-- (8.0,1.0)
movePoint :: Motion -> (Double, Double) -> (Double, Double)
movePoint (Motion r tx ty) place = (x + tx, y + ty)
  where
    (x, y) = rotated (turned r) place

-- | The one motion followed by the other.
andThen :: Motion -> Motion -> Motion
andThen (Motion r x y) second = Motion (turned (r + motionRotation second)) x' y'
  where
    (x', y') = movePoint second (x, y)

-- | The motion that takes a motion back.
inverse :: Motion -> Motion
inverse (Motion r x y) = Motion (turned (negate r)) x' y'
  where
    (x', y') = movePoint (Motion (negate r) 0 0) (negate x, negate y)

-- | An angle in degrees brought to [0, 360); what is not finite stays as it is.
turned :: Double -> Double
turned r
  | isNaN r || isInfinite r = r
  | r' >= 360 = 0
  | otherwise = r'
  where
    r' = r - 360 * fromIntegral (floor (r / 360) :: Integer)

-- | Why there is no plan.
data ProbeError
  = -- | The spacing is less than one taxel.
    SpacingTooSmall !Int
  | -- | The region (width, height, taxels) is narrower or lower than the sensor.
    RegionTooSmall !Int !Int
  | -- | The same of another sensor, whose width and height follow, in taxels of 'taxelPitch'.
    RegionBelowSensor !Int !Int !Double !Double
  | -- | The region (width, height, taxels) would take more than 100000 presses.
    RegionTooLarge !Int !Int
  deriving stock (Eq, Show)

-- | The most presses a plan may hold.
maxPresses :: Double
maxPresses = 100000

-- | The grid of a sensor's elements: how many columns and rows, and the distance of neighbours in
-- millimetres.
data TaxelGrid = TaxelGrid
  { taxelGridColumns :: !Int,
    taxelGridRows :: !Int,
    taxelGridPitch :: !Double
  }
  deriving stock (Eq, Show)

-- | 'sensorSide' elements along each side, 'taxelPitch' apart.
standardTaxelGrid :: TaxelGrid
standardTaxelGrid = TaxelGrid sensorSide sensorSide taxelPitch

-- | 'planScanOf' the standard sensor.
--
-- >>> length <$> planScan 8 (0, 0) (40, 52)
-- Right 24
planScan :: Int -> (Double, Double) -> (Int, Int) -> Either ProbeError [Pose]
planScan = planScanOf standardTaxelGrid

-- | The poses, rotation 0, of presses of a sensor that cover a region exactly: that many of the
-- sensor's own taxels apart in both directions, row by row from the upper left, the last row and
-- column flush with the region's edge. The region's upper left corner in millimetres, its width and
-- height in taxels of 'taxelPitch', whatever the sensor's are.
planScanOf :: TaxelGrid -> Int -> (Double, Double) -> (Int, Int) -> Either ProbeError [Pose]
planScanOf grid spacing (left, top) (width, height)
  | spacing < 1 = Left (SpacingTooSmall spacing)
  | wide < across || high < down = Left tooSmall
  | presses wide across * presses high down > maxPresses = Left (RegionTooLarge width height)
  | otherwise =
    Right
      [ Pose (centre left across x) (centre top down y) 0
        | y <- offsets high down,
          x <- offsets wide across
      ]
  where
    TaxelGrid columns rows taxel = grid
    (across, down) = (fromIntegral columns, fromIntegral rows) :: (Double, Double)
    -- Taxels of 'taxelPitch' as the sensor's own.
    (wide, high) = (own width, own height)
    own n = fromIntegral n * ratio
    ratio = taxelPitch / taxel
    tooSmall
      | grid == standardTaxelGrid = RegionTooSmall width height
      | otherwise = RegionBelowSensor width height (across / ratio) (down / ratio)
    step = fromIntegral spacing :: Double
    -- As many as there are offsets.
    presses size side = 1 + fromIntegral (max 0 (ceiling (inside size side / step) :: Integer))
    offsets size side =
      takeWhile (< inside size side) (map ((step *) . fromIntegral) [0 :: Int ..]) ++ [size - side]
    inside size side = size - side - 1e-9
    centre edge side offset = edge + taxel * (offset + side / 2)
