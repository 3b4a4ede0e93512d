-- | A composite read at one angle and along one axis: its symbols, which of them are neighbours,
-- and how well both agree with that angle.
module PraTactile.Segmentation.Reading
  ( Reading (..),
    readingsAt,
    misfit,
    offAxis,
    cellOffset,
  )
where

import PraTactile.Composite (Composite (..))
import PraTactile.Composite.Blend (minus)
import PraTactile.Composite.Tilt (setUpright)
import PraTactile.Geometry
import PraTactile.Image (rasterHeight, rasterWidth)
import PraTactile.Segmentation
import PraTactile.Segmentation.Lattice
import PraTactile.Symmetry

-- | A composite as it is read at one angle and along one axis.
data Reading = Reading
  { -- | degrees clockwise
    readingAxis :: !Double,
    -- | the composite set upright, and its segmentation
    readingView :: !Composite,
    -- | the same to read parts from
    readingForParts :: Composite,
    readingFound :: !Segmentation,
    -- | each symbol with each of its neighbours, and the cell where that is beside it
    readingSteps :: [(SymbolImage, Cell, SymbolImage)],
    -- | where its pixels are on the composite as given
    readingBack :: !((Double, Double) -> (Double, Double))
  }

-- | A composite, and what parts are read from, read at an angle, along both axes.
readingsAt :: Composite -> Composite -> Double -> [Reading]
readingsAt composite forParts angle =
  [ Reading
      { readingAxis = angle + degreesClockwise axis,
        readingView = view,
        readingForParts = onComposite (invert axis) (fst (atAngle forParts)),
        readingFound = found,
        readingSteps = steps (segmentedSymbols found),
        readingBack = back . onPixel axis (sizeOf view)
      }
    | axis <- [identity, turned 1],
      let (view, found, _) = segmentAlong axis upright
  ]
  where
    (upright, back) = atAngle composite
    atAngle given = if angle == 0 then (given, id) else setUpright angle given
    sizeOf view =
      ( fromIntegral (rasterWidth (compositeImage view)),
        fromIntegral (rasterHeight (compositeImage view))
      )

-- | Each symbol with each of its neighbours, and the cell where that is beside it.
steps :: [SymbolImage] -> [(SymbolImage, Cell, SymbolImage)]
steps symbols =
  [(s, cell, other) | s <- symbols, other <- symbols, Just cell <- [neighbour s other]]

-- | The angle, radians clockwise, that brings the symbols' neighbours closest to where the pitch
-- has them, by least squares, and the sum of the squares of neighbours' distances, in pixels; 0 and
-- 0 without neighbours. In the reading's pixels the symbols are upright.
offAxis :: Reading -> (Double, Double)
offAxis reading = (atan2 (total across) (total along), total expected / 2)
  where
    -- Each pair of neighbours stands there twice.
    total part =
      sum
        [ part (cellOffset cell) (symbolCentre other `minus` symbolCentre s)
          | (s, cell, other) <- readingSteps reading
        ]
    along (x, y) (x', y') = x * x' + y * y'
    across (x, y) (x', y') = x * y' - y * x'
    expected (x, y) _ = x * x + y * y

-- | How little a reading's symbols agree with its angle, as twice the negative logarithm of how
-- many times as likely they are symbols at it as anything else: by how much their neighbours lie
-- off it, and how far their boxes are from a symbol's size, which only along its own axes it has.
-- The standard deviation of a symbol's place is a pixel, as symbols need not stand on the lattice,
-- that of a side half of one; other boxes are of any size to 16 by 16 pixels (assumptions).
-- One that is likelier anything else tells nothing.
misfit :: Reading -> Double
misfit reading = places + sum (map (min 0 . subtract chance . off) sizes)
  where
    off (w, h) = square ((w - wide) / side) + square ((h - high) / side)
    side = 0.5
    chance = 2 * log (square 16 / (2 * pi * square side))
    sizes = map symbolSize (segmentedSymbols (readingFound reading))
    (wide, high) = (fromIntegral symbolWidth, fromIntegral symbolHeight)
    (angle, distances) = offAxis reading
    places = distances * square angle / 2
    square t = t * t

-- | How far a cell lies from the upper left one, in pixels right and down.
cellOffset :: Cell -> (Double, Double)
cellOffset (i, j) = (columnPitch * fromIntegral j, rowPitch * fromIntegral i)
