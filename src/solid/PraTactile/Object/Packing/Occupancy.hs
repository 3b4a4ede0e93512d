{-# OPTIONS_HADDOCK hide #-}

-- | The taken cells of a sheet, with one bit each, and the first place where a figure fits.
--
-- A figure's run (i, j, l) has the l cells from column j on in the figure's row i. Consider it for
-- the figure at (r, c). Let x be the last taken column among c + j to c + j + l - 1 of row r + i,
-- and y > x the next free column of that row. Then the figure fits at no (r, c') with c <= c' < y -
-- j, because x is still in the run, or the run begins on a taken cell. So a search along a row
-- jumps from c to y - j. It costs a step for each run that it tests.
module PraTactile.Object.Packing.Occupancy
  ( Occupancy,
    Still,
    Changing,
    rowsOf,
    columnsOf,

    -- * Laying
    vacant,
    thaw,
    freeze,
    lie,

    -- * Asking
    fitsAt,
    firstFit,
    freeInRow,
  )
where

import Control.Monad (forM_)
import Control.Monad.ST (ST)
import Data.Bits
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Data.Word (Word64)
import PraTactile.Object.Packing.Mask

-- | The cells of a sheet.
data Occupancy cells = Occupancy
  { rowsOf :: !Int,
    columnsOf :: !Int,
    -- | the number of words for each row; the bits after a row's last cell, at least one, count as
    -- taken
    stride :: !Int,
    taken :: !cells
  }

-- | A sheet that does not change.
type Still = Occupancy (U.Vector Word64)

-- | A sheet to which figures can be added.
type Changing s = Occupancy (M.STVector s Word64)

-- | An empty sheet with these numbers of rows and columns, neither negative.
vacant :: Int -> Int -> Still
vacant rows columns = Occupancy rows columns words' (U.concat (replicate rows row))
  where
    words' = columns `div` 64 + 1
    row = U.replicate (words' - 1) 0 `U.snoc` complement (below (columns .&. 63))

-- | A copy of a sheet to which figures can be added.
thaw :: Still -> ST s (Changing s)
thaw it = (\cells -> it {taken = cells}) <$> U.thaw (taken it)

-- | The current state of a sheet.
freeze :: Changing s -> ST s Still
freeze it = (\cells -> it {taken = cells}) <$> U.freeze (taken it)

-- | Takes the cells of a figure whose upper left corner is at this row and column. The figure must
-- fit there, which is not checked.
lie :: Changing s -> Figure -> (Int, Int) -> ST s ()
lie it figure (r, c) = U.forM_ (figureRuns figure) $ \(i, j, l) -> do
  let from = c + j
      to = c + j + l - 1
      row = (r + i) * stride it
  forM_ [from `shiftR` 6 .. to `shiftR` 6] $ \k ->
    M.modify (taken it) (.|. between (from - 64 * k) (to - 64 * k)) (row + k)

-- | Whether a figure fits at a row and column: it lies on the sheet, on free cells.
fitsAt :: Changing s -> Figure -> (Int, Int) -> ST s Bool
fitsAt it figure (r, c)
  | r < 0 || c < 0 || r > lastRow it figure || c > lastColumn it figure = pure False
  | otherwise = (== c) . fst <$> leap it figure r c

-- | The greatest row and column at which a figure stays within the sheet.
lastRow, lastColumn :: Occupancy cells -> Figure -> Int
lastRow it figure = rowsOf it - figureRows figure
lastColumn it figure = columnsOf it - figureColumns figure

-- | The first row and column, row by row from the given ones, at which a figure fits, if any; and
-- the number of steps taken. The figure must have a cell.
firstFit :: forall s. Changing s -> Figure -> (Int, Int) -> ST s (Maybe (Int, Int), Int)
firstFit it figure (row, column) = go 0 row column
  where
    go :: Int -> Int -> Int -> ST s (Maybe (Int, Int), Int)
    go steps r c
      | r > lastRow it figure = pure (Nothing, steps)
      | c > lastColumn it figure = go (steps + 1) (r + 1) 0
      | otherwise = do
        (c', n) <- leap it figure r c
        if c' == c then pure (Just (r, c), steps + n) else go (steps + n) r c'

-- | The given column if the figure fits at the given row and column; else a later column before
-- which it does not fit in this row. Also the number of runs tested.
leap :: Changing s -> Figure -> Int -> Int -> ST s (Int, Int)
leap it figure r c = go 0
  where
    runs = figureRuns figure
    go k
      | k == U.length runs = pure (c, k)
      | otherwise = do
        let (i, j, l) = U.unsafeIndex runs k
            row = (r + i) * stride it
        x <- lastTaken it row (c + j) (c + j + l - 1)
        if x < 0
          then go (k + 1)
          else do
            y <- nextFree it row (x + 1)
            pure (y - j, k + 1)
{-# INLINE leap #-}

-- | The last taken column of a row between two columns, both included; -1 if there is none. The row
-- is given by the index of its first word.
lastTaken :: Changing s -> Int -> Int -> Int -> ST s Int
lastTaken it row from to = go (to `shiftR` 6)
  where
    go k
      | k < from `shiftR` 6 = pure (-1)
      | otherwise = do
        word <- M.unsafeRead (taken it) (row + k)
        let found = word .&. between (from - 64 * k) (to - 64 * k)
        if found == 0 then go (k - 1) else pure (64 * k + 63 - countLeadingZeros found)

-- | The first free column of a row from a column on; a column beyond the sheet if there is none.
-- The row is given by the index of its first word.
nextFree :: Changing s -> Int -> Int -> ST s Int
nextFree it row from = go (from `shiftR` 6)
  where
    go k
      | k >= stride it = pure (64 * stride it)
      | otherwise = do
        word <- M.unsafeRead (taken it) (row + k)
        let free = complement word .&. complement (below (from - 64 * k))
        if free == 0 then go (k + 1) else pure (64 * k + countTrailingZeros free)

-- | The number of free cells in a row.
freeInRow :: Still -> Int -> Int
freeInRow it r = U.foldl' count 0 (U.slice (r * stride it) (stride it) (taken it))
  where
    count n word = n + popCount (complement word)

-- | The word with the bits between two indices set, both included. The range may lie partly or
-- wholly outside the word.
between :: Int -> Int -> Word64
between from to = below (to + 1) .&. complement (below from)

-- | The word with the bits below an index set.
below :: Int -> Word64
below k
  | k <= 0 = 0
  | k >= 64 = maxBound
  | otherwise = bit k - 1
