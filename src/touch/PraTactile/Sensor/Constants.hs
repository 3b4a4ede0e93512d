-- | The constants of the simulated sensor and of the robot that carries it, and the presets.
--
-- A constant that is 0 switches off what it stands for. Lengths are millimetres, forces newtons,
-- shares are of 1. What a source is called an assumption for is the project's own choice.
module PraTactile.Sensor.Constants
  ( -- * The sensor
    Sensor (..),
    sensorLayout,
    withTaxel,

    -- * Presets
    Preset (..),
    presetName,
    presetSensor,
    standardSensor,
    idealSensor,

    -- * Every constant by its name
    Constant (..),
    constants,
    replaced,
  )
where

import Data.List (find)
import PraTactile.Geometry (sensorSide, symbolThickness, taxelPitch)
import PraTactile.Sensor.Frame (Layout (..))

-- | What the simulation needs to know of a sensor and of the robot that carries it.
data Sensor = Sensor
  { -- | The height in millimetres that gives full scale, where no force is modelled.
    sensorFullScale :: !Double,
    -- | The standard deviation of the noise at a reading of 0, as a share of full scale.
    sensorNoise :: !Double,
    -- | The standard deviation of the robot's position error, in taxels of 1.5875 mm, the same
    -- along x and y.
    sensorPositionError :: !Double,
    -- | The force of a press in newtons, as the frames state it.
    sensorForce :: !Double,
    -- | The elements in a row.
    sensorColumns :: !Int,
    -- | The elements in a column.
    sensorRows :: !Int,
    -- | The distance between neighbouring elements, mm.
    sensorTaxel :: !Double,
    -- | The standard deviation of a press's rotation error, degrees.
    sensorRotationError :: !Double,
    -- | The diameter of an element's round tab, mm; 0 for a square as wide as the taxel.
    sensorTab :: !Double,
    -- | How stiff a tab is, N/mm; 0 where no force is modelled: a reading is proportional to the
    -- height.
    sensorStiffness :: !Double,
    -- | The standard deviation of a press's force, as a share of it.
    sensorForceSpread :: !Double,
    -- | The standard deviation of each of a press's two tilts: what the edge of the sensor is
    -- nearer than its centre, as a share of a symbol's thickness.
    sensorTiltSpread :: !Double,
    -- | How deep the elements lie under the overlay's surface, mm.
    sensorDepth :: !Double,
    -- | The exponent k of the conductance, which is proportional to force ^ k.
    sensorExponent :: !Double,
    -- | The force on an element below which it does not conduct, N.
    sensorBreakForce :: !Double,
    -- | The force on an element that gives full scale, N.
    sensorFullForce :: !Double,
    -- | The standard deviation of the elements' gains.
    sensorGainSpread :: !Double,
    -- | The share of dead elements.
    sensorDead :: !Double,
    -- | What part of a reading comes from the mean of its row, and as much from its column's.
    sensorCrosstalk :: !Double,
    -- | What part of the force of the press before is still felt.
    sensorHysteresis :: !Double,
    -- | By what share the readings rise for every ten times the time.
    sensorDrift :: !Double,
    -- | By how much the noise's standard deviation rises from a reading of 0 to full scale.
    sensorNoiseSlope :: !Double,
    -- | The share of the noise's variance that the elements of a row have in common.
    sensorRowNoise :: !Double,
    -- | The same of a column.
    sensorColumnNoise :: !Double,
    -- | The bits of a reading; 0 for a real number.
    sensorBits :: !Int,
    -- | Of its codes, how many of the lowest are read as 0.
    sensorZeroed :: !Int
  }
  deriving stock (Eq, Show)

-- | The grid of the sensor's elements.
sensorLayout :: Sensor -> Layout
sensorLayout sensor = Layout (sensorColumns sensor) (sensorRows sensor) (sensorTaxel sensor)

-- | A sensor of the same kind with another distance between its elements, in mm: the tabs grow with
-- it, and what depends on a tab's area with its square.
withTaxel :: Double -> Sensor -> Sensor
withTaxel taxel sensor =
  sensor
    { sensorTaxel = taxel,
      sensorTab = ratio * sensorTab sensor,
      sensorStiffness = ratio * ratio * sensorStiffness sensor,
      sensorBreakForce = ratio * ratio * sensorBreakForce sensor,
      sensorFullForce = ratio * ratio * sensorFullForce sensor
    }
  where
    ratio = taxel / sensorTaxel sensor

-- | The sensors that are given by name.
data Preset
  = -- | the paper's without noise or position error
    Ideal
  | -- | the paper's: white noise alone
    Paper
  | -- | as arrays on the market are
    Real
  | -- | a bad specimen, badly handled
    Hard
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of a preset.
presetName :: Preset -> String
presetName preset = case preset of
  Ideal -> "ideal"
  Paper -> "paper"
  Real -> "real"
  Hard -> "hard"

-- | The sensor of a preset.
presetSensor :: Preset -> Sensor
presetSensor preset = case preset of
  Ideal -> idealSensor
  Paper -> standardSensor
  Real -> realSensor
  Hard ->
    realSensor
      { sensorPositionError = 2,
        sensorRotationError = 3,
        sensorForceSpread = 0.3,
        sensorGainSpread = 0.2,
        sensorDead = 0.01,
        sensorCrosstalk = 0.02,
        sensorHysteresis = 0.1
      }

-- | The paper's: full scale at a symbol's thickness, noise of 0.1 of full scale, position errors of
-- one taxel, 10 N, of which the readings do not depend.
standardSensor :: Sensor
standardSensor =
  Sensor
    { sensorFullScale = symbolThickness,
      sensorNoise = 0.1,
      sensorPositionError = 1,
      sensorForce = 10,
      sensorColumns = sensorSide,
      sensorRows = sensorSide,
      sensorTaxel = taxelPitch,
      sensorRotationError = 0,
      sensorTab = 0,
      sensorStiffness = 0,
      sensorForceSpread = 0,
      sensorTiltSpread = 0,
      sensorDepth = 0,
      sensorExponent = 1,
      sensorBreakForce = 0,
      sensorFullForce = 20 * tabShare,
      sensorGainSpread = 0,
      sensorDead = 0,
      sensorCrosstalk = 0,
      sensorHysteresis = 0,
      sensorDrift = 0,
      sensorNoiseSlope = 0,
      sensorRowNoise = 0,
      sensorColumnNoise = 0,
      sensorBits = 0,
      sensorZeroed = 0
    }

-- | 'standardSensor' without noise or position error.
idealSensor :: Sensor
idealSensor = standardSensor {sensorNoise = 0, sensorPositionError = 0}

realSensor :: Sensor
realSensor =
  standardSensor
    { sensorNoise = 0.0002,
      sensorNoiseSlope = 0.0038,
      sensorRowNoise = 0.1,
      sensorColumnNoise = 0.1,
      sensorRotationError = 1.5,
      sensorTab = 1.1,
      sensorStiffness = 0.19,
      sensorForceSpread = 0.15,
      sensorTiltSpread = 0.1,
      sensorDepth = 1.5,
      sensorExponent = 0.9,
      sensorBreakForce = 0.2 * tabShare,
      sensorGainSpread = 0.06,
      sensorCrosstalk = 0.01,
      sensorHysteresis = 0.05,
      sensorDrift = 0.05,
      sensorBits = 8,
      sensorZeroed = 2
    }

-- | The area of a tab of 1.1 mm as a share of a whole FSR 400's, of 5.1 mm.
tabShare :: Double
tabShare = (1.1 / 5.1) * (1.1 / 5.1)

-- | One constant: its name, its unit ("1" for a share or a number), where it comes from, how it is
-- read from a sensor and replaced in one, and what it may be.
data Constant = Constant
  { constantName :: String,
    constantUnit :: String,
    constantSource :: String,
    constantValue :: Sensor -> Double,
    constantReplace :: Double -> Sensor -> Sensor,
    -- | the least and the greatest value
    constantRange :: (Double, Double),
    constantWhole :: Bool
  }

-- | The sensor with the named constant replaced; 'Left' tells the constant if the value is out of
-- its range, and nothing if there is no such constant.
replaced :: String -> Double -> Sensor -> Either (Maybe Constant) Sensor
replaced name value sensor = case find ((== name) . constantName) constants of
  Nothing -> Left Nothing
  Just constant
    | value >= least && value <= most && (not (constantWhole constant) || integral) ->
      Right (constantReplace constant value sensor)
    | otherwise -> Left (Just constant)
    where
      (least, most) = constantRange constant
      integral = value == fromIntegral (round value :: Integer)

-- | All constants of a sensor.
constants :: [Constant]
constants = grid ++ robot ++ mechanics ++ electrics ++ noises

grid :: [Constant]
grid =
  [ whole "columns" paper (4, 256) sensorColumns (\v s -> s {sensorColumns = v}),
    whole "rows" paper (4, 256) sensorRows (\v s -> s {sensorRows = v}),
    real "taxel_pitch" "mm" paper (0.05, 50) sensorTaxel (\v s -> s {sensorTaxel = v}),
    real "tab_diameter" "mm" "assumption; 0: a square as wide as the taxel" (0, 50) sensorTab $
      \v s -> s {sensorTab = v}
  ]
  where
    paper = "Petriu et al. 2004, section III: 16 x 16 elements, a sixteenth of an inch apart"

robot :: [Constant]
robot =
  [ real
      "position_error"
      "taxel"
      "assumption: standard deviation along each axis, taxels of 1.5875 mm"
      (0, 1000)
      sensorPositionError
      (\v s -> s {sensorPositionError = v}),
    real "rotation_error" "deg" "assumption: standard deviation" (0, 180) sensorRotationError $
      \v s -> s {sensorRotationError = v},
    real "force" "N" "assumption" (0.001, 100000) sensorForce (\v s -> s {sensorForce = v}),
    share
      "force_spread"
      "assumption: standard deviation as a share of the force"
      sensorForceSpread
      $ \v s -> s {sensorForceSpread = v},
    share
      "tilt_spread"
      "assumption: standard deviation of each tilt at the sensor's edge, share of 1.5875 mm"
      sensorTiltSpread
      (\v s -> s {sensorTiltSpread = v})
  ]

mechanics :: [Constant]
mechanics =
  [ real
      "full_scale_height"
      "mm"
      "Petriu et al. 2004, section II.B: a symbol's thickness; counts where tab_stiffness is 0"
      (0.0001, 1000)
      sensorFullScale
      (\v s -> s {sensorFullScale = v}),
    real
      "tab_stiffness"
      "N/mm"
      "assumption: 10 N on 38 tabs press 1.4 mm; 0: a reading is proportional to the height"
      (0, 100000)
      sensorStiffness
      (\v s -> s {sensorStiffness = v}),
    real
      "overlay_depth"
      "mm"
      "assumption, 1 to 2: point spread t^3 (r^2 + t^2)^(-5/2) of an elastic half space \
      \(Boussinesq)"
      (0, 50)
      sensorDepth
      (\v s -> s {sensorDepth = v}),
    share
      "hysteresis"
      "assumption, 0 to 0.1: share of the press before that is still felt"
      sensorHysteresis
      (\v s -> s {sensorHysteresis = v})
  ]

electrics :: [Constant]
electrics =
  [ real
      "conductance_exponent"
      "1"
      "0.8 to 1.0: conductance g0 F^k of force sensing resistors; the value an assumption"
      (0.1, 4)
      sensorExponent
      (\v s -> s {sensorExponent = v}),
    real
      "break_force"
      "N"
      "data sheet FSR 400: 0.2 N of a part of 5.1 mm, scaled by area to the tab"
      (0, 100000)
      sensorBreakForce
      (\v s -> s {sensorBreakForce = v}),
    real
      "full_scale_force"
      "N"
      "data sheet FSR 400: 20 N of a part of 5.1 mm, scaled by area to the tab"
      (0.000001, 100000)
      sensorFullForce
      (\v s -> s {sensorFullForce = v}),
    share
      "gain_spread"
      "data sheet FSR 400: standard deviation from part to part, 0.06; to 0.2 in arrays"
      sensorGainSpread
      (\v s -> s {sensorGainSpread = v}),
    share "drift" "data sheet FSR 400: under 0.05 a decade of time" sensorDrift $
      \v s -> s {sensorDrift = v},
    real
      "crosstalk"
      "1"
      "assumption, 0.005 to 0.02: share of the row's mean, and of the column's"
      (0, 0.5)
      sensorCrosstalk
      (\v s -> s {sensorCrosstalk = v}),
    share "dead_taxels" "assumption: share of elements that read 0" sensorDead $
      \v s -> s {sensorDead = v},
    whole "adc_bits" "assumption, 8 to 12; 0: readings are real numbers" (0, 16) sensorBits $
      \v s -> s {sensorBits = v},
    whole
      "adc_zeroed"
      "assumption: so many of the lowest codes are read as 0"
      (0, 65535)
      sensorZeroed
      $ \v s -> s {sensorZeroed = v}
  ]

noises :: [Constant]
noises =
  [ real
      "noise"
      "1"
      "assumption; 0.0002 of full scale in real arrays: standard deviation at a reading of 0"
      (0, 1000)
      sensorNoise
      (\v s -> s {sensorNoise = v}),
    real
      "noise_slope"
      "1"
      "assumption; real arrays have 0.004 at full scale: what is added from 0 to full scale"
      (0, 1000)
      sensorNoiseSlope
      (\v s -> s {sensorNoiseSlope = v}),
    half "noise_row" "assumption: share of the variance that a row has in common" sensorRowNoise $
      \v s -> s {sensorRowNoise = v},
    half
      "noise_column"
      "assumption: share of the variance that a column has in common"
      sensorColumnNoise
      (\v s -> s {sensorColumnNoise = v})
  ]
  where
    half name source = real name "1" source (0, 0.5)

-- | A constant that is a real number.
real ::
  String ->
  String ->
  String ->
  (Double, Double) ->
  (Sensor -> Double) ->
  (Double -> Sensor -> Sensor) ->
  Constant
real name unit source range value replace = Constant name unit source value replace range False

-- | The same of a share.
share :: String -> String -> (Sensor -> Double) -> (Double -> Sensor -> Sensor) -> Constant
share name source = real name "1" source (0, 1)

-- | A constant that counts something.
whole ::
  String ->
  String ->
  (Double, Double) ->
  (Sensor -> Int) ->
  (Int -> Sensor -> Sensor) ->
  Constant
whole name source range value replace =
  Constant name "1" source (fromIntegral . value) (replace . round) range True
