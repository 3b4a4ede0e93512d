-- | Where symbols are tried on frames of one size: places on a grid along the symbols' axes, which
-- may be turned from the frames'; and the phases of a lattice of cells there.
module PraTactile.Registration.Lattice.Layout
  ( -- * Places
    Layout (..),
    layout,
    cellIndex,
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
data Layout = Layout
  { -- | The width and height of the frames.
    layoutFrame :: !(Int, Int),
    -- | By how many degrees, clockwise, the symbols' axes are turned from the frames'.
    layoutAngle :: !Double,
    -- | Places to the taxel.
    layoutPlaces :: !Int,
    -- | The first column and the first row of places, along the symbols' axes, in taxels from the
    -- centre of the frame's upper left taxel.
    layoutFirst :: !(Int, Int),
    -- | The number of places across and down.
    layoutGrid :: !(Int, Int)
  }
  deriving stock (Eq, Show)

-- | The places for axes that are turned by so many degrees clockwise, frames of that width and
-- height, and so many places to the taxel.
layout :: Double -> Int -> Int -> Int -> Layout
layout angle w h q =
  Layout
    { layoutFrame = (w, h),
      layoutAngle = angle,
      layoutPlaces = q,
      layoutFirst = (left - symbolWidth - fringe, top - symbolHeight - fringe),
      layoutGrid = ((wide + symbolWidth + 2 * fringe) * q, (high + symbolHeight + 2 * fringe) * q)
    }
  where
    corners =
      [ rotated (negate angle) (fromIntegral x, fromIntegral y)
        | x <- [0, w - 1],
          y <- [0, h - 1]
      ]
    (left, wide) = extent (map fst corners)
    (top, high) = extent (map snd corners)
    -- The first whole number, and how many reach to the last.
    extent :: [Double] -> (Int, Int)
    extent ts =
      let first = floor (minimum ts + 1e-9) in (first, ceiling (maximum ts - 1e-9) - first + 1)

-- | How far from its own taxels a symbol still counts, in taxels.
fringe :: Int
fringe = 2

-- | Where an orientation (0 upright, 1 half turned), a row and a column of places lie in tables, to
-- be multiplied by the number of classes where these have one number a class.
cellIndex :: Layout -> Int -> Int -> Int -> Int
cellIndex places orientation y x = (orientation * rows + y) * columns + x
  where
    (columns, rows) = layoutGrid places
{-# INLINE cellIndex #-}

-- | Where a column and a row of places lie on the frame, taxels.
onFrame :: Layout -> Int -> Int -> (Double, Double)
onFrame places = \x y -> turned' (firstX + fromIntegral x / q) (firstY + fromIntegral y / q)
  where
    q = fromIntegral (layoutPlaces places)
    (firstX, firstY) = let (x, y) = layoutFirst places in (fromIntegral x, fromIntegral y)
    (c, s) = cosineSine (layoutAngle places)
    turned' x y = (c * x - s * y, s * x + c * y)
{-# INLINE onFrame #-}

-- | The width of the grid of places, padded so that a symbol at any place lies on it.
paddedWidth :: Layout -> Int
paddedWidth places = fst (layoutGrid places) + (symbolWidth - 1) * layoutPlaces places

-- | Its height.
paddedHeight :: Layout -> Int
paddedHeight places = snd (layoutGrid places) + (symbolHeight - 1) * layoutPlaces places

-- | The width of the grid of the sums of areas, which begins a taxel before the padded grid.
areasWidth :: Layout -> Int
areasWidth places = paddedWidth places + layoutPlaces places

-- | The number of phases across and down, places to the taxel given.
phaseCount :: Int -> (Int, Int)
phaseCount q = (columnPitch * q, rowPitch * q)

-- | Some phases of a lattice: their numbers, where the cells of each begin, with an end, and the
-- cells.
data Phases = Phases
  { phaseNumbers :: !(Vector Int),
    phaseBegins :: !(Vector Int),
    phaseCells :: !(Vector Int)
  }

-- | The number of all phases: orientation, row and column of places, modulo the pitch.
phaseTotal :: Layout -> Int
phaseTotal places = let (across, down) = phaseCount (layoutPlaces places) in 2 * across * down

-- | The cells of those phases, by 'cellIndex'.
phasesOf :: Layout -> [Int] -> Phases
phasesOf places phases =
  Phases
    (V.fromList phases)
    (V.fromList (scanl (+) 0 (map length cells)))
    (V.fromList (concat cells))
  where
    cells = map (cellsOfPhase places) phases

-- | The cells of a lattice, by 'cellIndex'.
cellsOfPhase :: Layout -> Int -> [Int]
cellsOfPhase places phase =
  [ cellIndex places orientation y x
    | y <- [firstY, firstY + down .. rows - 1],
      x <- [firstX, firstX + across .. columns - 1]
  ]
  where
    (columns, rows) = layoutGrid places
    (across, down) = phaseCount (layoutPlaces places)
    (row, firstX) = phase `quotRem` across
    (orientation, firstY) = row `quotRem` down
