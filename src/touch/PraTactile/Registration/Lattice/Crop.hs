{-# OPTIONS_HADDOCK hide #-}

-- | The crop of a frame from which the lattice's angle is found.
module PraTactile.Registration.Lattice.Crop
  ( variedCrop,
    cropSize,
  )
where

import Data.Either (rights)
import Data.List (sortOn)
import Data.Ord (Down (..))
import PraTactile.Image

-- | A small frame, or the crop of 'cropSize' that varies most, of crops side by side. A few
-- cells determine the angle as well as hundreds, whose tables take 16 times the time and memory.
variedCrop :: Raster -> Raster
variedCrop image = case sortOn (Down . standardDeviation) (rights parts) of
  most : _ | size /= rasterSize image -> most
  _ -> image
  where
    size@(w, h) = cropSize (rasterSize image)
    parts =
      [ crop (x, y) size image
        | y <- places (rasterHeight image) h,
          x <- places (rasterWidth image) w
      ]
    places whole part = [0, part .. whole - part - 1] ++ [whole - part]

-- | The width and height of the crop of a frame of the given size; a frame of up to 1024 pixels
-- stays whole.
cropSize :: (Int, Int) -> (Int, Int)
cropSize (w, h)
  | w * h <= side * side = (w, h)
  | otherwise = (min w side, min h side)
  where
    side = 32
