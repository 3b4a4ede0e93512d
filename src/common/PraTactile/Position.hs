-- |
-- Cells of a rectangle and rectangles of cells: natural numbers of any size, rows downwards and
-- columns to the right, counted from 0.
module PraTactile.Position
  ( Shape (..),
    area,
    Position (..),
  )
where

import Numeric.Natural (Natural)

-- | Numbers of rows and of columns, in cells.
data Shape = Shape
  { rows :: !Natural,
    columns :: !Natural
  }
  deriving stock (Eq, Ord, Show)

-- | The number of cells.
area :: Shape -> Natural
area shape = rows shape * columns shape

-- | A cell: row and column, from 0, rows downwards and columns to the right.
data Position = Position
  { row :: !Natural,
    column :: !Natural
  }
  deriving stock (Eq, Ord, Show)
