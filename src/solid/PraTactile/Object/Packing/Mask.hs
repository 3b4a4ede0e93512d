{-# OPTIONS_HADDOCK hide #-}

-- | The cells that a face takes of a block, as runs: maximal rows of neighbours.
--
-- A mask is a finite set P of cells in Z^2, by row and column within its block. It is stored as the
-- upper left corner m = (min row, min column) of P, and the size, the number of cells and the runs
-- of P - m. A run (i, j, l) is the cells (i, j) .. (i, j + l - 1); runs are sorted row by row, from
-- left to right.
module PraTactile.Object.Packing.Mask
  ( BlockMask,
    maskOf,
    block,
    maskCells,

    -- * What searches ask
    Figure (..),
    maskFigure,
    maskCorner,
  )
where

import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import qualified Data.Vector.Unboxed as U

-- | The cells that a face takes of a block; at least one.
data BlockMask = BlockMask
  { -- | the upper left corner of the cells' bounding box, within the block
    maskCorner :: !(Int, Int),
    -- | the cells relative to that corner
    maskFigure :: !Figure
  }
  deriving stock (Eq, Ord, Show)

-- | A set of cells whose least row and column are 0.
data Figure = Figure
  { figureCells :: !Int,
    figureRows :: !Int,
    figureColumns :: !Int,
    -- | row, first column and length of each run
    figureRuns :: !(U.Vector (Int, Int, Int))
  }
  deriving stock (Eq, Ord, Show)

-- | The mask with these cells, by row and column within a block with these numbers of rows and
-- columns. Repeated cells count once. 'Nothing' if there is no cell, or one lies outside the block.
-- O(n log n).
--
-- >>> maskCells <$> maskOf (3, 3) [(2, 1), (1, 1), (1, 2)]
-- Just [(1,1),(1,2),(2,1)]
-- >>> maskOf (3, 3) [(0, 3)]
-- Nothing
maskOf :: (Int, Int) -> [(Int, Int)] -> Maybe BlockMask
maskOf (height, width) cells
  | null cells || any outside cells = Nothing
  | otherwise = Just (masked [(r, s, l) | (r, columns) <- inRows, (s, l) <- runs columns])
  where
    outside (r, c) = r < 0 || r >= height || c < 0 || c >= width
    inRows =
      IntMap.toAscList
        (IntSet.toAscList <$> IntMap.fromListWith (<>) [(r, IntSet.singleton c) | (r, c) <- cells])
    runs columns = case columns of
      first : others -> longer first 1 others
      [] -> []
    longer first l (next : others) | next == first + l = longer first (l + 1) others
    longer first l others = (first, l) : runs others

-- | All cells of a block with these numbers of rows and columns. A number below 1 counts as 1,
-- since a mask has a cell.
block :: (Int, Int) -> BlockMask
block (height, width) = masked [(r, 0, max 1 width) | r <- [0 .. max 1 height - 1]]

-- | The cells within the block, row by row.
maskCells :: BlockMask -> [(Int, Int)]
maskCells (BlockMask (top, left) figure) =
  [(top + i, c) | (i, j, l) <- U.toList (figureRuns figure), c <- [left + j .. left + j + l - 1]]

-- | A mask from its runs, row by row; there must be at least one.
masked :: [(Int, Int, Int)] -> BlockMask
masked runs =
  BlockMask
    (top, left)
    Figure
      { figureCells = sum [l | (_, _, l) <- runs],
        figureRows = 1 + maximum [r | (r, _, _) <- runs] - top,
        figureColumns = maximum [c + l | (_, c, l) <- runs] - left,
        figureRuns = U.fromList [(r - top, c - left, l) | (r, c, l) <- runs]
      }
  where
    top = minimum [r | (r, _, _) <- runs]
    left = minimum [c | (_, c, _) <- runs]
