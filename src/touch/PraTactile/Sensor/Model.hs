{-# OPTIONS_HADDOCK hide #-}

-- | What the simulation needs to know of a sensor and of the robot that carries it.
--
-- A constant that is 0 switches off what it stands for. Lengths are millimetres, forces newtons,
-- shares are of 1. Where each value comes from is said in "PraTactile.Sensor.Constants".
module PraTactile.Sensor.Model
  ( Sensor (..),
    sensorTaxelGrid,
    withTaxel,
  )
where

import PraTactile.Sensor.Frame (TaxelGrid (..))

-- | The constants of a simulated sensor, in the order in which they are listed.
data Sensor = Sensor
  { -- | The elements in a row.
    sensorColumns :: !Int,
    -- | The elements in a column.
    sensorRows :: !Int,
    -- | The distance between neighbouring elements, mm.
    sensorTaxel :: !Double,
    -- | The diameter of an element's round tab, mm; 0 for a square as wide as the taxel.
    sensorTab :: !Double,
    -- | The standard deviation of the robot's position error, in taxels of 1.5875 mm, the same
    -- along x and y.
    sensorPositionError :: !Double,
    -- | The standard deviation of a press's rotation error, degrees.
    sensorRotationError :: !Double,
    -- | The force of a press in newtons, as the frames state it.
    sensorForce :: !Double,
    -- | The standard deviation of a press's force, as a share of it.
    sensorForceSpread :: !Double,
    -- | The standard deviation of each of a press's two tilts: what the edge of the sensor is
    -- nearer than its centre, as a share of a symbol's thickness.
    sensorTiltSpread :: !Double,
    -- | The height in millimetres that gives full scale, where no force is modelled.
    sensorFullScale :: !Double,
    -- | How stiff a tab is, N/mm; 0 where no force is modelled: a reading is proportional to the
    -- height.
    sensorStiffness :: !Double,
    -- | How deep the elements lie under the overlay's surface, mm.
    sensorDepth :: !Double,
    -- | What part of the force of the press before is still felt.
    sensorHysteresis :: !Double,
    -- | The exponent k of the conductance, which is proportional to force ^ k.
    sensorExponent :: !Double,
    -- | The force on an element below which it does not conduct, N.
    sensorBreakForce :: !Double,
    -- | The force on an element that gives full scale, N.
    sensorFullForce :: !Double,
    -- | The standard deviation of the elements' gains.
    sensorGainSpread :: !Double,
    -- | By what share the readings rise for every ten times the time.
    sensorDrift :: !Double,
    -- | What part of a reading comes from the mean of its row, and as much from its column's.
    sensorCrosstalk :: !Double,
    -- | The share of dead elements.
    sensorDead :: !Double,
    -- | The bits of a reading; 0 for a real number.
    sensorBits :: !Int,
    -- | Of its codes, how many of the lowest are read as 0.
    sensorZeroed :: !Int,
    -- | The standard deviation of the noise at a reading of 0, as a share of full scale.
    sensorNoise :: !Double,
    -- | By how much the noise's standard deviation rises from a reading of 0 to full scale.
    sensorNoiseSlope :: !Double,
    -- | The share of the noise's variance that the elements of a row have in common.
    sensorRowNoise :: !Double,
    -- | The same of a column.
    sensorColumnNoise :: !Double
  }
  deriving stock (Eq, Show)

-- | The grid of the sensor's elements.
sensorTaxelGrid :: Sensor -> TaxelGrid
sensorTaxelGrid sensor = TaxelGrid (sensorColumns sensor) (sensorRows sensor) (sensorTaxel sensor)

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
