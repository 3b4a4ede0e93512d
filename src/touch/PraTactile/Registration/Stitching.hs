{-# OPTIONS_HADDOCK hide #-}

-- | How frames are put together, by what is known of the robot and of the sensor.
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

-- | What is known beforehand.
data Stitching = Stitching
  { -- | how frames are registered
    stitchingMethod :: StitchMethod,
    -- | the standard deviation of each frame's position on both axes, in taxels; 'Nothing' where it
    -- is not known
    stitchingPositionError :: Maybe Double,
    -- | the standard deviation of the sensor's noise, as a share of full scale; 'Nothing' where it
    -- is not known, and taken as the frames show it
    stitchingNoise :: Maybe Double
  }
  deriving stock (Eq, Show)

-- | Position errors that nobody has told, and whatever noise the frames show.
standardStitching :: Stitching
standardStitching = Stitching Automatic Nothing Nothing

-- | No correction: every frame lies where its pose has it.
nominalStitching :: Stitching
nominalStitching =
  Stitching Nominal (registrationSigma known) (Just (registrationNoise known))
  where
    known = standardRegistration

-- | The settings of registration for these frames. A position error of less than a hundredth of a
-- taxel is taken as that, because a prior without width cannot be searched.
registrationFor :: Stitching -> [Frame] -> Registration
registrationFor known frames = case stitchingNoise known of
  Just noise -> settings {registrationNoise = noise}
  Nothing -> withNoiseOf frames settings
  where
    settings = standardRegistration {registrationSigma = fmap least (stitchingPositionError known)}
    least sigma = if sigma >= 0 then max 0.01 sigma else sigma

-- | Frames put together so, and how, given the tables of the symbols that may have been felt.
-- Refuses what 'assemble' refuses.
assembledBy :: LatticeTables -> Stitching -> [Frame] -> Either StitchError Assembly
assembledBy tables known frames =
  assemble tables (stitchingMethod known) (registrationFor known frames) frames

-- | The composite alone.
stitchedBy :: LatticeTables -> Stitching -> [Frame] -> Either StitchError Composite
stitchedBy tables known = fmap assemblyComposite . assembledBy tables known
