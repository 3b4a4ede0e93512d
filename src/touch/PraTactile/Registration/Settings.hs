{-# OPTIONS_HADDOCK hide #-}

-- | Assumptions of registration about the robot and the sensor.
module PraTactile.Registration.Settings
  ( Registration (..),
    standardRegistration,
    supposedSigma,
    sigmasFor,
    searchRadius,
    usable,
  )
where

import Data.Maybe (fromMaybe)

-- | Assumptions about the robot and the sensor, and limits of the search.
data Registration = Registration
  { -- | The known standard deviation of the robot's position error along each axis, in taxels;
    -- 'Nothing' if unknown.
    registrationSigma :: !(Maybe Double),
    -- | The standard deviation of the sensor's noise, as a share of full scale.
    registrationNoise :: !Double,
    -- | How far from its expected place a frame is searched, in standard deviations of the position
    -- error.
    registrationReach :: !Double,
    -- | The most sweeps that register each frame against the others.
    registrationSweeps :: !Int
  }
  deriving stock (Eq, Show)

-- | An unknown position error, noise of 0.1, a reach of four and a half standard deviations, and at
-- most five sweeps.
standardRegistration :: Registration
standardRegistration =
  Registration
    { registrationSigma = Nothing,
      registrationNoise = 0.1,
      registrationReach = 4.5,
      registrationSweeps = 5
    }

-- | The standard deviation of the position error to assume, in taxels: the known one, else one
-- taxel.
supposedSigma :: Registration -> Double
supposedSigma = fromMaybe 1 . registrationSigma

-- | The least and the greatest standard deviation, in taxels, that the position error may have.
-- Unknown, it goes from half a taxel to four, a quarter of the pitch. Known, it goes from half of
-- it to twice, but at most to four taxels or the known value, whichever is larger.
sigmasFor :: Registration -> (Double, Double)
sigmasFor = maybe (0.5, 4) near . registrationSigma
  where
    near sigma = (sigma / 2, max sigma (min 4 (2 * sigma)))

-- | How far from its expected place a frame is searched, in taxels.
searchRadius :: Registration -> Double
searchRadius settings = registrationReach settings * supposedSigma settings

-- | Whether the settings make sense: a positive sigma, noise of at least 0, and a search radius of
-- at most 64 taxels.
usable :: Registration -> Bool
usable settings =
  sigma > 0 && noise >= 0 && not (isInfinite noise) && reach >= 0 && searchRadius settings <= 64
  where
    Registration _ noise reach _ = settings
    sigma = supposedSigma settings
