{-# LANGUAGE DerivingStrategies #-}
-- | Exploring a face with the simulated probe: a region of the face is covered by overlapping presses whose positions
-- the robot knows in its own frame of coordinates only (the paper's section III).
module PraTactile.Explore
  ( -- * Regions
    Region (..)
  , regionMotion
  , randomRegion
  , standardRegionSize
    -- * Pressing
  , explore
  , frameSpacing
  ) where

import System.Random (RandomGen)

import PraTactile.Object.Placement (LaidFace (..), Spot (..))
import PraTactile.Probe (Frame, Motion (..), ProbeError, planScan, taxelPitch)
import PraTactile.Probe.Sensor (HeightMap, Sensor, scan)
import PraTactile.Random (uniform)

-- | A rectangle of a face that the probe covers.
data Region = Region
  { regionRight :: !Double      -- ^ from the face's upper left vertex to the region's upper left corner, taxels to the right
  , regionDown :: !Double       -- ^ and down
  , regionWidth :: !Int         -- ^ taxels
  , regionHeight :: !Int        -- ^ taxels
  , regionTurned :: !Bool       -- ^ is the face turned by 180 degrees in the robot's frame?
  }
  deriving stock (Eq, Show)

-- | From the robot's frame, whose origin is the region's upper left corner as the robot sees it, to the face's, whose
-- origin is the face's upper left vertex; millimetres.
regionMotion :: Region -> Motion
regionMotion region
  | regionTurned region = Motion
      { motionRotation = 180
      , motionX = taxelPitch * (regionRight region + fromIntegral (regionWidth region))
      , motionY = taxelPitch * (regionDown region + fromIntegral (regionHeight region)) }
  | otherwise = Motion
      { motionRotation = 0
      , motionX = taxelPitch * regionRight region
      , motionY = taxelPitch * regionDown region }

-- | 40 wide, 52 tall, in taxels: enough to hold a whole 2-by-2 window at every phase of the grid.
standardRegionSize :: (Int, Int)
standardRegionSize = (40, 52)

-- | A region of this size (width and height in taxels) at a uniform, real-valued place on a face, turned by 0 or 180
-- degrees with equal chance; @Nothing@ if the face is smaller than the region.
randomRegion :: RandomGen g => (Int, Int) -> LaidFace -> g -> Maybe (Region, g)
randomRegion (width, height) face generator
  | roomRight < 0 || roomDown < 0 = Nothing
  | otherwise = Just
      ( Region { regionRight = u * roomRight, regionDown = v * roomDown, regionWidth = width, regionHeight = height
               , regionTurned = w < 0.5 }
      , generator3 )
  where
    roomRight = room (spotRight (laidExtent face)) width
    roomDown = room (spotDown (laidExtent face)) height
    room millimetres size = fromRational millimetres / taxelPitch - fromIntegral size :: Double
    (u, generator1) = uniform generator
    (v, generator2) = uniform generator1
    (w, generator3) = uniform generator2

-- | The distance of neighbouring presses: 8 taxels, half the sensor's width.
frameSpacing :: Int
frameSpacing = 8

-- | The frames of a region, row by row: nominal poses in the robot's frame, images taken at the true ones.
explore :: RandomGen g => Sensor -> HeightMap -> Region -> g -> Either ProbeError ([Frame], g)
explore sensor heights region generator = do
  poses <- planScan frameSpacing (0, 0) (regionWidth region, regionHeight region)
  pure (scan sensor heights (regionMotion region) poses generator)
