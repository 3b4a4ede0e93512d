{-# OPTIONS_HADDOCK hide #-}

-- | The constants of a simulated sensor and of the robot that carries it.
--
-- A constant of 0 switches its effect off. Lengths are millimetres, forces newtons, shares are
-- fractions of 1. "PraTactile.Sensor.Constants" gives the source of each value.
module PraTactile.Sensor.Model
  ( Sensor (..),
    sensorTaxelGrid,
    withTaxel,
  )
where

import PraTactile.Sensor.Frame (TaxelGrid (..))

-- | The constants of a simulated sensor, in the order in which they are listed.
data Sensor = Sensor
  { -- | The number of elements in a row.
    sensorColumns :: !Int,
    -- | The number of elements in a column.
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
    -- | The standard deviation of each of a press's two tilts: how much nearer the sensor's edge
    -- is than its centre, as a share of a symbol's thickness.
    sensorTiltSpread :: !Double,
    -- | The height in millimetres that gives full scale, if forces are not modelled.
    sensorFullScale :: !Double,
    -- | The stiffness of a tab, N/mm. With 0, forces are not modelled and a reading is
    -- proportional to the height.
    sensorStiffness :: !Double,
    -- | The depth of the elements under the overlay's surface, mm.
    sensorDepth :: !Double,
    -- | The share of the previous press's force that is still felt.
    sensorHysteresis :: !Double,
    -- | The exponent k of the conductance, which is proportional to force ^ k.
    sensorExponent :: !Double,
    -- | The force on an element below which it does not conduct, N.
    sensorBreakForce :: !Double,
    -- | The force on an element that gives full scale, N.
    sensorFullForce :: !Double,
    -- | The standard deviation of the elements' gains.
    sensorGainSpread :: !Double,
    -- | The share by which readings rise per decade of time.
    sensorDrift :: !Double,
    -- | The share of a reading that comes from the mean of its row; the same share comes from the
    -- mean of its column.
    sensorCrosstalk :: !Double,
    -- | The share of dead elements.
    sensorDead :: !Double,
    -- | The number of bits of a reading; 0 for a real number.
    sensorBits :: !Int,
    -- | The number of lowest codes that are read as 0.
    sensorZeroed :: !Int,
    -- | The standard deviation of the noise at a reading of 0, as a share of full scale.
    sensorNoise :: !Double,
    -- | The increase of the noise's standard deviation from a reading of 0 to full scale.
    sensorNoiseSlope :: !Double,
    -- | The share of the noise's variance that is common to the elements of a row.
    sensorRowNoise :: !Double,
    -- | The share of the noise's variance that is common to the elements of a column.
    sensorColumnNoise :: !Double
  }
  deriving stock (Eq, Show)

-- | The grid of the sensor's elements.
sensorTaxelGrid :: Sensor -> TaxelGrid
sensorTaxelGrid sensor = TaxelGrid (sensorColumns sensor) (sensorRows sensor) (sensorTaxel sensor)

-- | The sensor with another distance between its elements (mm). Tab diameters scale with it;
-- stiffness and forces scale with its square, like a tab's area.
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
