{-# OPTIONS_HADDOCK hide #-}

-- | The box around an embossed symbol, measured to a fraction of a taxel.
module PraTactile.Segmentation.Box
  ( -- * Sides
    Side (..),
    Extent (..),
    extentLength,
    clamped,

    -- * Measuring
    horizontalExtent,
    verticalExtent,

    -- * Fitting a known length
    fitted,
  )
where

import Data.Maybe (isNothing)
import Data.Tuple (swap)
import PraTactile.Segmentation.Masked
import PraTactile.Segmentation.Region (Region)

-- | One end of an extent. The place is where the intensity crosses the threshold, in pixels; a
-- pixel reaches half a pixel to either side of its centre. The side is open if the pixels beyond
-- were not touched, so that the symbol may continue there.
data Side = Side
  { sidePlace :: !Double,
    sideOpen :: !Bool
  }
  deriving stock (Eq, Show)

-- | An extent along x or along y, from the first side to the last.
data Extent = Extent !Side !Side
  deriving stock (Eq, Show)

-- | The distance between the sides, in pixels.
extentLength :: Extent -> Double
extentLength (Extent from to) = sidePlace to - sidePlace from

-- | Moves a place that lies beyond an open side to the last pixel centre before that side, so that
-- untouched pixels repeat the last touched one.
clamped :: Extent -> Double -> Double
clamped (Extent from to) = atMost . atLeast
  where
    atLeast t = if sideOpen from then max (sidePlace from + 0.5) t else t
    atMost t = if sideOpen to then min (sidePlace to - 0.5) t else t

-- | The extent of a region from left to right, where the intensity crosses the threshold.
-- 'Nothing' for an empty region.
horizontalExtent :: Masked -> Double -> Region -> Maybe Extent
horizontalExtent pixels level = measured (valueAt pixels) level . map (placeOf pixels)

-- | The extent of a region from top to bottom, where the intensity crosses the threshold.
-- 'Nothing' for an empty region.
verticalExtent :: Masked -> Double -> Region -> Maybe Extent
verticalExtent pixels level = measured (valueAt pixels . swap) level . map (swap . placeOf pixels)

-- | The extent along the first coordinate. The profile at each place is the largest mean of two
-- neighbouring pixels across. A symbol's side has at least two embossed taxels, so a noisy pixel,
-- or a line of up to three that sticks out, moves the side by half a pixel at most.
measured :: ((Int, Int) -> Maybe Double) -> Double -> [(Int, Int)] -> Maybe Extent
measured at level places
  | null places = Nothing
  | otherwise =
    Just (Extent (Side (crossing first 1) (open (-1))) (Side (crossing end (-1)) (open 1)))
  where
    first = minimum (map fst places)
    end = maximum (map fst places)
    low = minimum (map snd places)
    high = maximum (map snd places)
    profile i =
      maximum
        ( 0 :
            [(a + b) / 2 | j <- [low .. high - 1], Just a <- [at (i, j)], Just b <- [at (i, j + 1)]]
        )
    open direction = or [isNothing (at (i + direction, j)) | (i, j) <- places]
    -- Searches from one pixel outside the component inwards for the first place where the profile
    -- reaches the threshold.
    crossing start inward = go (0 :: Int) (profile (start - inward))
      where
        go k before
          | k > 3 = fromIntegral start
          | here >= level = fromIntegral (start + inward * (k - 1)) + fromIntegral inward * share
          | otherwise = go (k + 1) here
          where
            here = profile (start + inward * k)
            share = if here > before then max 0 ((level - before) / (here - before)) else 1

-- | The centre of an object of known length in an extent, if their lengths differ by at most the
-- tolerance. If the extent is more than half a pixel too short and exactly one side is open, the
-- object is aligned with the other side. The arguments are the tolerance, the length and the
-- extent.
fitted :: Double -> Double -> Extent -> Maybe Double
fitted tolerance size extent@(Extent from to)
  | abs missing > tolerance = Nothing
  | missing > 0.5 && sideOpen from && not (sideOpen to) = Just (sidePlace to - size / 2)
  | missing > 0.5 && sideOpen to && not (sideOpen from) = Just (sidePlace from + size / 2)
  | otherwise = Just ((sidePlace from + sidePlace to) / 2)
  where
    missing = size - extentLength extent
