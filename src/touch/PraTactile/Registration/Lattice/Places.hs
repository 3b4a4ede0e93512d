{-# OPTIONS_HADDOCK hide #-}

-- | The places at which symbols are tried on frames of one size: a grid along the symbols' axes,
-- which may be turned from the frame's. Also the phases of a lattice of cells on this grid.
module PraTactile.Registration.Lattice.Places
  ( -- * Places
    Places (..),
    placesAt,
    cellIndex,
    PlaceAxes,
    axesOf,
    onFrame,

    -- * The padded grid
    paddedWidth,
    paddedHeight,
    areasWidth,

    -- * Lattices
    phaseCount,
    Phases (..),
    phaseTotal,
    phasesOf,
    cellsOfPhase,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Geometry (columnPitch, cosineSine, rotated, rowPitch, symbolHeight, symbolWidth)

-- | The places of symbols on frames of one size: all from which a symbol is felt.
data Places = Places
  { -- | The width and height of the frames.
    placesFrame :: !(Int, Int),
    -- | The angle of the symbols' axes against the frame's, degrees clockwise.
    placesAngle :: !Double,
    -- | Places per taxel.
    placesFineness :: !Int,
    -- | The first column and the first row of places, along the symbols' axes, in taxels from the
    -- centre of the frame's upper left taxel.
    placesFirst :: !(Int, Int),
    -- | The number of places across and down.
    placesGrid :: !(Int, Int)
  }
  deriving stock (Eq, Show)

-- | The places for an angle (degrees clockwise), a frame's width and height, and the number of
-- places per taxel.
placesAt :: Double -> Int -> Int -> Int -> Places
placesAt angle w h q =
  Places
    { placesFrame = (w, h),
      placesAngle = angle,
      placesFineness = q,
      placesFirst = (left - symbolWidth - fringe, top - symbolHeight - fringe),
      placesGrid = ((wide + symbolWidth + 2 * fringe) * q, (high + symbolHeight + 2 * fringe) * q)
    }
  where
    corners =
      [ rotated (negate angle) (fromIntegral x, fromIntegral y)
        | x <- [0, w - 1],
          y <- [0, h - 1]
      ]
    (left, wide) = extent (map fst corners)
    (top, high) = extent (map snd corners)
    -- The first whole number, and how many whole numbers reach to the last.
    extent :: [Double] -> (Int, Int)
    extent ts =
      let first = floor (minimum ts + 1e-9) in (first, ceiling (maximum ts - 1e-9) - first + 1)

-- | How far a symbol is felt beyond its own taxels, in taxels.
fringe :: Int
fringe = 2

-- | The index of a cell in tables, from its orientation (0 upright, 1 half turned), row and column
-- of places. Tables with one number per class multiply it by the number of classes.
cellIndex :: Places -> Int -> Int -> Int -> Int
cellIndex places orientation y x = (orientation * rows + y) * columns + x
  where
    (columns, rows) = placesGrid places
{-# INLINE cellIndex #-}

-- | Maps places to the frame: the first place along the axes, places per taxel, and the cosine and
-- the sine of the axes' angle.
data PlaceAxes = PlaceAxes !Double !Double !Double !Double !Double

-- | The axes of some places.
axesOf :: Places -> PlaceAxes
axesOf places =
  PlaceAxes (fromIntegral x) (fromIntegral y) (fromIntegral (placesFineness places)) c s
  where
    (x, y) = placesFirst places
    (c, s) = cosineSine (placesAngle places)

-- | The place on the frame, taxels, of a column and a row of places.
onFrame :: PlaceAxes -> Int -> Int -> (Double, Double)
onFrame (PlaceAxes firstX firstY q c s) column row = (c * x - s * y, s * x + c * y)
  where
    x = firstX + fromIntegral column / q
    y = firstY + fromIntegral row / q
{-# INLINE onFrame #-}

-- | The width of the grid of places, padded so that a symbol at any place lies on it.
paddedWidth :: Places -> Int
paddedWidth places = fst (placesGrid places) + (symbolWidth - 1) * placesFineness places

-- | The height of the grid of places, padded so that a symbol at any place lies on it.
paddedHeight :: Places -> Int
paddedHeight places = snd (placesGrid places) + (symbolHeight - 1) * placesFineness places

-- | The width of the tables of 'areaSums', which begin a taxel before the padded grid.
areasWidth :: Places -> Int
areasWidth places = paddedWidth places + placesFineness places

-- | The number of phases across and down, given the places per taxel.
phaseCount :: Int -> (Int, Int)
phaseCount q = (columnPitch * q, rowPitch * q)

-- | Some phases of a lattice: their numbers, the beginnings of their cells with a final end, and
-- the cells.
data Phases = Phases
  { phaseNumbers :: !(Vector Int),
    phaseBegins :: !(Vector Int),
    phaseCells :: !(Vector Int)
  }

-- | The number of all phases: orientations, rows and columns of places, modulo the pitch.
phaseTotal :: Places -> Int
phaseTotal places = let (across, down) = phaseCount (placesFineness places) in 2 * across * down

-- | The given phases with their cells, by 'cellIndex'.
phasesOf :: Places -> [Int] -> Phases
phasesOf places phases =
  Phases
    (V.fromList phases)
    (V.fromList (scanl (+) 0 (map length cells)))
    (V.fromList (concat cells))
  where
    cells = map (cellsOfPhase places) phases

-- | The cells of a phase, by 'cellIndex'.
cellsOfPhase :: Places -> Int -> [Int]
cellsOfPhase places phase =
  [ cellIndex places orientation y x
    | y <- [firstY, firstY + down .. rows - 1],
      x <- [firstX, firstX + across .. columns - 1]
  ]
  where
    (columns, rows) = placesGrid places
    (across, down) = phaseCount (placesFineness places)
    (row, firstX) = phase `quotRem` across
    (orientation, firstY) = row `quotRem` down
