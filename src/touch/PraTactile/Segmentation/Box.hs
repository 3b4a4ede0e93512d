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

-- | The place itself, or, where it lies beyond an open side, the last pixel centre before that
-- side: what was not touched is taken to go on as it was seen last.
clamped :: Extent -> Double -> Double
clamped (Extent from to) = atMost . atLeast
  where
    atLeast t = if sideOpen from then max (sidePlace from + 0.5) t else t
    atMost t = if sideOpen to then min (sidePlace to - 0.5) t else t

-- | A region's extent from left to right at a threshold. 'Nothing' for an empty region.
horizontalExtent :: Masked -> Double -> Region -> Maybe Extent
horizontalExtent pixels level = measured (valueAt pixels) level . map (placeOf pixels)

-- | A region's extent from top to bottom: the same with x and y exchanged.
verticalExtent :: Masked -> Double -> Region -> Maybe Extent
verticalExtent pixels level = measured (valueAt pixels . swap) level . map (swap . placeOf pixels)

-- | The extent along the first coordinate. The profile along it is, at each place, the largest mean
-- of two pixels that neighbour across it: a symbol's side is at least two taxels of embossing long,
-- and a noisy pixel, or a line of up to three that sticks out, moves it by half a pixel at most.
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
