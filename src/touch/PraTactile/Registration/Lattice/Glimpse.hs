{-# OPTIONS_HADDOCK hide #-}

-- | The part of a frame that the lattice's angle is told from.
module PraTactile.Registration.Lattice.Glimpse
  ( glimpse,
    glimpseSize,
  )
where

import Data.Either (rights)
import Data.List (sortOn)
import Data.Ord (Down (..))
import PraTactile.Image

-- | A frame; of a large one the part of 'glimpseSize' that shows most, of parts side by side. A few
-- cells tell the angle as well as hundreds, whose tables take 16 times the time and the room.
glimpse :: Raster -> Raster
glimpse image = case sortOn (Down . standardDeviation) (rights parts) of
  most : _ | size /= rasterSize image -> most
  _ -> image
  where
    size@(w, h) = glimpseSize (rasterSize image)
    parts =
      [ crop (x, y) size image
        | y <- places (rasterHeight image) h,
          x <- places (rasterWidth image) w
      ]
    places whole part = [0, part .. whole - part - 1] ++ [whole - part]

-- | The width and height of the part of a frame of that size: all of up to 1024 pixels.
glimpseSize :: (Int, Int) -> (Int, Int)
glimpseSize (w, h)
  | w * h <= side * side = (w, h)
  | otherwise = (min w side, min h side)
  where
    side = 32
