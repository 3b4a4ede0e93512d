-- | The box around an embossed symbol, measured to a fraction of a taxel.
module PraTactile.Segmentation.Box
  ( -- * Sides
    Side (..),
    Extent (..),
    extentLength,

    -- * Measuring
    Scene (..),
    horizontalExtent,
    verticalExtent,

    -- * Fitting a known length
    fitted,
  )
where

import Data.Set (Set)
import qualified Data.Set as Set
import PraTactile.Segmentation.Component (Pixel)

-- | One end of an extent: where the intensity passes the threshold, in pixels (a pixel reaches half
-- a pixel to either side of its centre), and whether what lies beyond was not touched, so that the
-- symbol may go on there.
data Side = Side
  { sidePlace :: !Double,
    sideOpen :: !Bool
  }
  deriving stock (Eq, Show)

-- | From one side to the opposite one along x or along y.
data Extent = Extent !Side !Side
  deriving stock (Eq, Show)

-- | The distance between the sides, in pixels.
extentLength :: Extent -> Double
extentLength (Extent from to) = sidePlace to - sidePlace from

-- | What is measured in: the intensity at a pixel, if it was touched, and the threshold.
data Scene = Scene
  { sceneAt :: Pixel -> Maybe Double,
    sceneThreshold :: !Double
  }

-- | A component's extent from left to right. Refuses an empty component.
horizontalExtent :: Scene -> Set Pixel -> Maybe Extent
horizontalExtent scene component =
  measured (sceneAt scene) (sceneThreshold scene) (Set.toList component)

-- | A component's extent from top to bottom: the same with x and y exchanged.
verticalExtent :: Scene -> Set Pixel -> Maybe Extent
verticalExtent scene component =
  measured
    (\(y, x) -> sceneAt scene (x, y))
    (sceneThreshold scene)
    [(y, x) | (x, y) <- Set.toList component]

-- | The extent along the first coordinate. The profile along it is, at each place, the largest mean
-- of two pixels that neighbour across it: a symbol's side is at least two taxels of embossing long,
-- and a noisy pixel, or a line of up to three that sticks out, moves it by half a pixel at most.
measured :: (Pixel -> Maybe Double) -> Double -> [Pixel] -> Maybe Extent
measured at level pixels
  | null pixels = Nothing
  | otherwise =
    Just (Extent (Side (crossing first 1) (open (-1))) (Side (crossing end (-1)) (open 1)))
  where
    first = minimum (map fst pixels)
    end = maximum (map fst pixels)
    low = minimum (map snd pixels)
    high = maximum (map snd pixels)
    profile i =
      maximum
        ( 0 :
            [(a + b) / 2 | j <- [low .. high - 1], Just a <- [at (i, j)], Just b <- [at (i, j + 1)]]
        )
    open direction = or [at (i + direction, j) == Nothing | (i, j) <- pixels]
    -- From one pixel outside the component inwards, to the first place where the profile reaches
    -- the threshold.
    crossing start inward = go (0 :: Int) (profile (start - inward))
      where
        go k before
          | k > 3 = fromIntegral start
          | here >= level = fromIntegral (start + inward * (k - 1)) + fromIntegral inward * share
          | otherwise = go (k + 1) here
          where
            here = profile (start + inward * k)
            share = if here > before then max 0 ((level - before) / (here - before)) else 1

-- | The centre of something of known length that fills an extent, if it can: the extent's length
-- may differ from it by no more than the tolerance. When the extent is too short by more than half
-- a pixel and one side is open, the thing is laid against the other side.
fitted :: Double -> Double -> Extent -> Maybe Double
fitted tolerance size extent@(Extent from to)
  | abs missing > tolerance = Nothing
  | missing > 0.5 && sideOpen from && not (sideOpen to) = Just (sidePlace to - size / 2)
  | missing > 0.5 && sideOpen to && not (sideOpen from) = Just (sidePlace from + size / 2)
  | otherwise = Just ((sidePlace from + sidePlace to) / 2)
  where
    missing = size - extentLength extent
