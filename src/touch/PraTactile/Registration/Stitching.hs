{-# OPTIONS_HADDOCK hide #-}

-- | Stitches frames, given what is known of the robot and of the sensor.
module PraTactile.Registration.Stitching
  ( Stitching (..),
    standardStitching,
    nominalStitching,
    registrationFor,
    assembledBy,
    stitchedBy,
  )
where

import PraTactile.Registration
import PraTactile.Sensor.Frame (Frame)

-- | The method, and what is known of the robot and of the sensor.
data Stitching = Stitching
  { -- | how frames are registered
    stitchingMethod :: StitchMethod,
    -- | the standard deviation of each frame's position on both axes, in taxels; 'Nothing' if
    -- unknown
    stitchingPositionError :: Maybe Double,
    -- | the standard deviation of the sensor's noise, as a share of full scale; 'Nothing' if it is
    -- to be estimated from the frames
    stitchingNoise :: Maybe Double
  }
  deriving stock (Eq, Show)

-- | The automatic method, an unknown position error, and noise as the frames show it.
standardStitching :: Stitching
standardStitching = Stitching Automatic Nothing Nothing

-- | No correction: every frame lies at its nominal pose.
nominalStitching :: Stitching
nominalStitching =
  Stitching Nominal (registrationSigma known) (Just (registrationNoise known))
  where
    known = standardRegistration

-- | The settings of registration for these frames. A position error below a hundredth of a taxel is
-- raised to that, because a prior without width cannot be searched.
registrationFor :: Stitching -> [Frame] -> Registration
registrationFor known frames = case stitchingNoise known of
  Just noise -> settings {registrationNoise = noise}
  Nothing -> withNoiseOf frames settings
  where
    settings = standardRegistration {registrationSigma = fmap least (stitchingPositionError known)}
    least sigma = if sigma >= 0 then max 0.01 sigma else sigma

-- | Registers and blends frames, given the tables of the symbols that may have been felt. Refuses
-- what 'assemble' refuses.
assembledBy :: LatticeTables -> Stitching -> [Frame] -> Either StitchError Assembly
assembledBy tables known frames =
  assemble tables (stitchingMethod known) (registrationFor known frames) frames

-- | Registers and blends frames, and gives the composite alone.
stitchedBy :: LatticeTables -> Stitching -> [Frame] -> Either StitchError Composite
stitchedBy tables known = fmap assemblyComposite . assembledBy tables known
