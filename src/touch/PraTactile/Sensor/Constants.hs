-- | The constants of the simulated sensor by name, each with its unit, its bounds and its source.
-- A source called an assumption is the project's own choice.
module PraTactile.Sensor.Constants
  ( Constant (..),
    constants,
    constantsOf,
    replaced,
  )
where

import Data.Functor.Const (Const (..))
import Data.Functor.Identity (Identity (..))
import Data.List (find)
import PraTactile.Sensor.Frame (taxelPitches)
import PraTactile.Sensor.Model (Sensor (..))
import PraTactile.Sensor.Preset (standardSensor)

-- | The description of a constant.
data Constant = Constant
  { constantName :: String,
    -- | "1" if it has no unit
    constantUnit :: String,
    -- | the least and the greatest value
    constantRange :: (Double, Double),
    -- | whether it is a whole number
    constantWhole :: Bool,
    -- | where it comes from
    constantSource :: String
  }

-- | All constants.
constants :: [Constant]
constants = map fst (constantsOf standardSensor)

-- | All constants with their values in a sensor.
constantsOf :: Sensor -> [(Constant, Double)]
constantsOf = getConst . traversed (\constant value -> Const [(constant, value)])

-- | The sensor with the named constant replaced. Refuses with the constant if the value is out of
-- its range, and with 'Nothing' if there is no such constant.
replaced :: String -> Double -> Sensor -> Either (Maybe Constant) Sensor
replaced name value sensor = case find ((== name) . constantName) constants of
  Nothing -> Left Nothing
  Just constant
    | value >= least && value <= most && (not (constantWhole constant) || integral) ->
      Right (runIdentity (traversed (\c old -> Identity (if here c then value else old)) sensor))
    | otherwise -> Left (Just constant)
    where
      (least, most) = constantRange constant
      integral = value == fromIntegral (round value :: Integer)
      here = (== name) . constantName

-- | Applies the function to each constant of a sensor, in the order of the fields. Only this
-- function assigns constants to fields.
traversed :: Applicative f => (Constant -> Double -> f Double) -> Sensor -> f Sensor
traversed at sensor =
  Sensor
    <$> whole "columns" (4, 256) array sensorColumns
    <*> whole "rows" (4, 256) array sensorRows
    <*> real "taxel_pitch" "mm" taxelPitches array sensorTaxel
    <*> real
      "tab_diameter"
      "mm"
      (0, 50)
      "assumption; 0: a square as wide as the taxel"
      sensorTab
    <*> real
      "position_error"
      "taxel"
      (0, 1000)
      "assumption: standard deviation along each axis, taxels of 1.5875 mm"
      sensorPositionError
    <*> real
      "rotation_error"
      "deg"
      (0, 180)
      "assumption: standard deviation"
      sensorRotationError
    <*> real "force" "N" (0.001, 100000) "assumption" sensorForce
    <*> share
      "force_spread"
      "assumption: standard deviation as a share of the force"
      sensorForceSpread
    <*> real
      "tilt_spread"
      "1"
      (0, 100)
      "assumption: standard deviation of each tilt at the sensor's edge, share of 1.5875 mm"
      sensorTiltSpread
    <*> real
      "full_scale_height"
      "mm"
      (0.0001, 1000)
      "Petriu et al. 2004, section II.B: a symbol's thickness; counts where tab_stiffness is 0"
      sensorFullScale
    <*> real
      "tab_stiffness"
      "N/mm"
      (0, 100000)
      "assumption: 10 N on 38 tabs press 1.4 mm; 0: a reading is proportional to the height"
      sensorStiffness
    <*> real
      "overlay_depth"
      "mm"
      (0, 50)
      "assumption, 1 to 2: point spread t^3 (r^2 + t^2)^(-5/2) of an elastic half space \
      \(Boussinesq)"
      sensorDepth
    <*> share
      "hysteresis"
      "assumption, 0 to 0.1: share of the press before that is still felt"
      sensorHysteresis
    <*> real
      "conductance_exponent"
      "1"
      (0.1, 4)
      "0.8 to 1.0: conductance g0 F^k of force sensing resistors; the value an assumption"
      sensorExponent
    <*> real
      "break_force"
      "N"
      (0, 100000)
      "data sheet FSR 400: 0.2 N of a part of 5.1 mm, scaled by area to the tab"
      sensorBreakForce
    <*> real
      "full_scale_force"
      "N"
      (0.000001, 100000)
      "data sheet FSR 400: 20 N of a part of 5.1 mm, scaled by area to the tab"
      sensorFullForce
    <*> share
      "gain_spread"
      "data sheet FSR 400: standard deviation from part to part, 0.06; to 0.2 in arrays"
      sensorGainSpread
    <*> share "drift" "data sheet FSR 400: under 0.05 a decade of time" sensorDrift
    <*> half
      "crosstalk"
      "assumption, 0.005 to 0.02: share of the row's mean, and of the column's"
      sensorCrosstalk
    <*> share "dead_taxels" "assumption: share of elements that read 0" sensorDead
    <*> whole "adc_bits" (0, 16) "assumption, 8 to 12; 0: readings are real numbers" sensorBits
    <*> whole
      "adc_zeroed"
      (0, 65535)
      "assumption: so many of the lowest codes are read as 0"
      sensorZeroed
    <*> real
      "noise"
      "1"
      (0, 1000)
      "assumption; 0.0002 of full scale in real arrays: standard deviation at a reading of 0"
      sensorNoise
    <*> real
      "noise_slope"
      "1"
      (0, 1000)
      "assumption; real arrays have 0.004 at full scale: what is added from 0 to full scale"
      sensorNoiseSlope
    <*> half
      "noise_row"
      "assumption: share of the variance that a row has in common"
      sensorRowNoise
    <*> half
      "noise_column"
      "assumption: share of the variance that a column has in common"
      sensorColumnNoise
  where
    array = "Petriu et al. 2004, section III: 16 x 16 elements, a sixteenth of an inch apart"
    share name = real name "1" (0, 1)
    half name = real name "1" (0, 0.5)
    real name unit range source field = at (Constant name unit range False source) (field sensor)
    whole name range source field =
      round <$> at (Constant name "1" range True source) (fromIntegral (field sensor))
