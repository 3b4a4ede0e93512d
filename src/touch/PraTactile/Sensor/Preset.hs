{-# OPTIONS_HADDOCK hide #-}

-- | Sensors by name.
module PraTactile.Sensor.Preset
  ( Preset (..),
    presetName,
    presetSensor,
    standardSensor,
    idealSensor,
  )
where

import PraTactile.Geometry (sensorSide, symbolThickness, taxelPitch)
import PraTactile.Sensor.Model

-- | A named sensor.
data Preset
  = -- | the paper's sensor without noise or position error
    Ideal
  | -- | the paper's sensor, with white noise
    Paper
  | -- | a typical commercial array
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

-- | The paper's sensor: full scale at a symbol's thickness, noise of 0.1 of full scale, position
-- errors of one taxel, and a force of 10 N, which does not affect the readings.
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

-- | A typical commercial array of force sensing resistors.
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

-- | The area of a tab of 1.1 mm as a share of an FSR 400's, of 5.1 mm.
tabShare :: Double
tabShare = (1.1 / 5.1) * (1.1 / 5.1)
