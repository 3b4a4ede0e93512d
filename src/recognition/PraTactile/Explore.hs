-- | Exploring a face with the simulated probe: a region of the face is covered by overlapping
-- presses whose positions the robot knows in its own frame of coordinates only (the paper's section
-- III).
module PraTactile.Explore
  ( -- * Regions
    Region (..),
    regionExtent,
    regionCorner,
    regionMotion,
    randomRegion,
    standardRegionSize,
    halfTurns,

    -- * Pressing
    explore,
    frameSpacing,
  )
where

import PraTactile.Object.Placement (LaidFace (..), Spot (..))
import PraTactile.Probe (Frame, Motion (..), ProbeError, planScan, taxelPitch)
import PraTactile.Probe.Sensor (HeightMap, Sensor, scan)
import PraTactile.Random (uniform)
import PraTactile.Symmetry
import System.Random (RandomGen)

-- | A rectangle of a face that the probe covers.
data Region = Region
  { -- | from the face's upper left vertex to the region's upper left corner, taxels to the right
    regionRight :: !Double,
    -- | and down
    regionDown :: !Double,
    -- | as the robot sees it, taxels
    regionWidth :: !Int,
    -- | likewise
    regionHeight :: !Int,
    -- | the rotation of the face in the robot's frame
    regionSymmetry :: !Symmetry
  }
  deriving stock (Eq, Show)

-- | The region's width and height on the face, taxels.
regionExtent :: Region -> (Int, Int)
regionExtent region
  | exchangesAxes (regionSymmetry region) = (regionHeight region, regionWidth region)
  | otherwise = (regionWidth region, regionHeight region)

-- | The region's upper left corner on the face, in millimetres to the right of and below the face's
-- upper left vertex.
regionCorner :: Region -> (Double, Double)
regionCorner region = (taxelPitch * regionRight region, taxelPitch * regionDown region)

-- | From the robot's frame, whose origin is the region's upper left corner as the robot sees it, to
-- the face's, whose origin is the face's upper left vertex; millimetres.
regionMotion :: Region -> Motion
regionMotion region =
  Motion
    { motionRotation = degreesClockwise (invert (regionSymmetry region)),
      motionX =
        taxelPitch * (regionRight region + fromIntegral (if turns `elem` [2, 3] then wide else 0)),
      motionY =
        taxelPitch * (regionDown region + fromIntegral (if turns `elem` [1, 2] then high else 0))
    }
  where
    turns = quarterTurns (regionSymmetry region)
    (wide, high) = regionExtent region

-- | 40 wide, 52 tall, in taxels: enough to hold a whole 2-by-2 window at every phase of the grid.
standardRegionSize :: (Int, Int)
standardRegionSize = (40, 52)

-- | A region of this size (width and height in taxels, as the robot sees it) at a uniform,
-- real-valued place on a face, seen in one of these rotations, all equally likely; @Nothing@ if the
-- face, so turned, is smaller than the region.
randomRegion :: RandomGen g => [Symmetry] -> (Int, Int) -> LaidFace -> g -> Maybe (Region, g)
randomRegion possible (width, height) face generator
  | roomRight < 0 || roomDown < 0 = Nothing
  | otherwise = Just (region {regionRight = u * roomRight, regionDown = v * roomDown}, generator3)
  where
    region =
      Region
        { regionRight = 0,
          regionDown = 0,
          regionWidth = width,
          regionHeight = height,
          regionSymmetry = drawn
        }
    roomRight = room (spotRight (laidExtent face)) (fst (regionExtent region))
    roomDown = room (spotDown (laidExtent face)) (snd (regionExtent region))
    room millimetres size = fromRational millimetres / taxelPitch - fromIntegral size :: Double
    drawn = case drop (floor (w * fromIntegral (length possible))) possible of
      symmetry : _ -> symmetry
      [] -> identity
    (u, generator1) = uniform generator
    (v, generator2) = uniform generator1
    (w, generator3) = uniform generator2

-- | A face that lies upright or turned by 180 degrees.
halfTurns :: [Symmetry]
halfTurns = [turned 2, identity]

-- | The distance of neighbouring presses: 8 taxels, half the sensor's width.
frameSpacing :: Int
frameSpacing = 8

-- | The frames of a region, row by row: nominal poses in the robot's frame, images taken at the
-- true ones.
explore :: RandomGen g => Sensor -> HeightMap -> Region -> g -> Either ProbeError ([Frame], g)
explore sensor heights region generator = do
  poses <- planScan frameSpacing (0, 0) (regionWidth region, regionHeight region)
  pure (scan sensor heights (regionMotion region) poses generator)
