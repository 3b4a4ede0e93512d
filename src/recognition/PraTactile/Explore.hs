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
    quarterTurns,

    -- * Pressing
    explore,
    frameSpacing,
  )
where

import PraTactile.Object.Placement (LaidFace (..), Spot (..))
import PraTactile.Probe (Frame, Motion (..), ProbeError, planScan, taxelPitch)
import PraTactile.Probe.Sensor (HeightMap, Sensor, scan)
import PraTactile.Random (uniform)
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
    -- | by how many quarter turns clockwise, 0 to 3, the face is turned in the robot's frame
    regionTurns :: !Int
  }
  deriving stock (Eq, Show)

-- | The region's width and height on the face, taxels.
regionExtent :: Region -> (Int, Int)
regionExtent region
  | odd (regionTurns region) = (regionHeight region, regionWidth region)
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
    { motionRotation = 90 * fromIntegral ((4 - turns) `mod` 4),
      motionX =
        taxelPitch * (regionRight region + fromIntegral (if turns `elem` [2, 3] then wide else 0)),
      motionY =
        taxelPitch * (regionDown region + fromIntegral (if turns `elem` [1, 2] then high else 0))
    }
  where
    turns = regionTurns region `mod` 4
    (wide, high) = regionExtent region

-- | 40 wide, 52 tall, in taxels: enough to hold a whole 2-by-2 window at every phase of the grid.
standardRegionSize :: (Int, Int)
standardRegionSize = (40, 52)

-- | A region of this size (width and height in taxels, as the robot sees it) at a uniform,
-- real-valued place on a face, turned by one of these numbers of quarter turns clockwise, all
-- equally likely; @Nothing@ if the face, so turned, is smaller than the region.
randomRegion :: RandomGen g => [Int] -> (Int, Int) -> LaidFace -> g -> Maybe (Region, g)
randomRegion turns (width, height) face generator
  | roomRight < 0 || roomDown < 0 = Nothing
  | otherwise = Just (turned {regionRight = u * roomRight, regionDown = v * roomDown}, generator3)
  where
    turned =
      Region
        { regionRight = 0,
          regionDown = 0,
          regionWidth = width,
          regionHeight = height,
          regionTurns = drawn
        }
    roomRight = room (spotRight (laidExtent face)) (fst (regionExtent turned))
    roomDown = room (spotDown (laidExtent face)) (snd (regionExtent turned))
    room millimetres size = fromRational millimetres / taxelPitch - fromIntegral size :: Double
    drawn = case drop (floor (w * fromIntegral (length turns))) turns of
      turn : _ -> turn `mod` 4
      [] -> 0
    (u, generator1) = uniform generator
    (v, generator2) = uniform generator1
    (w, generator3) = uniform generator2

-- | A face that lies upright or turned by 180 degrees.
halfTurns :: [Int]
halfTurns = [2, 0]

-- | A face that lies in any of its four ways.
quarterTurns :: [Int]
quarterTurns = [0 .. 3]

-- | The distance of neighbouring presses: 8 taxels, half the sensor's width.
frameSpacing :: Int
frameSpacing = 8

-- | The frames of a region, row by row: nominal poses in the robot's frame, images taken at the
-- true ones.
explore :: RandomGen g => Sensor -> HeightMap -> Region -> g -> Either ProbeError ([Frame], g)
explore sensor heights region generator = do
  poses <- planScan frameSpacing (0, 0) (regionWidth region, regionHeight region)
  pure (scan sensor heights (regionMotion region) poses generator)
