{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The set of contents that occur among the windows of a grid, with one bit for each content: the
-- inner loop of the proof by enumeration. Internal; "PraTactile.Window.Enumeration" has the
-- meaning.
module PraTactile.Window.Contents
  ( Contents,
    contents,
    countContents,
    zeroOccurs,
  )
where

import Control.Monad (foldM_, forM_, when)
import Control.Monad.ST (ST)
import Data.Bits (popCount, shiftL, shiftR, (.&.), (.|.))
import Data.List (sort)
import Data.Vector.Primitive (MVector, Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word32, Word64)
import GHC.Conc (numCapabilities, par, pseq)
import PraTactile.Grid
import PraTactile.Window
import PraTactile.Window.Visit

-- | A set of contents: bit c of the vector, with 64 bits a word, is the content numbered c. The
-- numbering is one to one, and 0 is the content of all zeros.
newtype Contents = Contents (Vector Word64)

-- | The contents of all windows of a visit. Their numbers must fit a set in memory.
contents :: Visit -> Contents
contents windows = united (map seen (tiles windows))
  where
    seen tile = Contents $
      Primitive.create $ do
        set <- Mutable.replicate (visitSpan windows `shiftR` 6 + 1) 0
        case maskRectangle (visitMask windows) of
          Just (Shape k1 k2)
            | k1 <= rows shape && k2 <= columns shape ->
              sweep windows (fromIntegral k1, fromIntegral k2) tile set
          _ -> forWindowsWithin windows tile (\_ _ key -> include set key)
        pure set
    shape = gridShape (visitGrid windows)

-- | The number of contents in the set.
countContents :: Contents -> Int
countContents (Contents set) = Primitive.foldl' (\n word -> n + popCount word) 0 set

-- | Whether the content that is all zeros is in the set.
zeroOccurs :: Contents -> Bool
zeroOccurs (Contents set) = Primitive.any odd (Primitive.take 1 set)

-- | Splits all windows into one tile for each processor, if they are many. The result does not
-- depend on it. Each processor has a set of its own, so this is for small sets only.
tiles :: Visit -> [Tile]
tiles windows
  | height <= 0 || width <= 0 = []
  | width >= height = [Tile 0 height c c' | (c, c') <- cut width]
  | otherwise = [Tile r r' 0 width | (r, r') <- cut height]
  where
    height = visitRows windows
    width = visitColumns windows
    parts
      | height * width < 2 ^ (18 :: Int) || visitSpan windows > 2 ^ (26 :: Int) = 1
      | otherwise = max 1 (min 16 numCapabilities)
    cut side = zip (cuts side) (drop 1 (cuts side))
    cuts side = [i * side `div` parts | i <- [0 .. parts]]

-- | The union of sets, which are computed in parallel.
united :: [Contents] -> Contents
united sets = case sets of
  [] -> Contents Primitive.empty
  [only] -> only
  first : others ->
    let rest = united others
     in first `par` (rest `pseq` union first rest)
  where
    union (Contents a) (Contents b) = Contents (Primitive.zipWith (.|.) a b)

-- | Adds a content to the set. It must be below the span for which the set was made.
include :: MVector s Word64 -> Int -> ST s ()
include set key = do
  word <- Mutable.unsafeRead set (key `shiftR` 6)
  Mutable.unsafeWrite set (key `shiftR` 6) (word .|. (1 `shiftL` (key .&. 63)))
{-# INLINE include #-}

{- Note [Rolling contents]
   ~~~~~~~~~~~~~~~~~~~~~~~
   The windows of k1 x k2 cells are swept row by row, in strips of a few thousand columns. For each
   column of the strip, the number formed by its k1 cells is kept, with the uppermost cell most
   significant. Going down a row, this number is multiplied by q, the new cell is added, and the
   cell that leaves is subtracted with its weight q^k1. The number of a window is formed by its k2
   columns in base q^k1, with the left column most significant. Going right, it is multiplied by
   q^k1, the new column is added, and the column that leaves is subtracted with its weight q^(k1
   k2). So a window costs two cells and two columns, whatever its size, and the columns of a strip
   stay in the fastest memory.

   The digits are in column order instead of reading order. The numbering is still one to one, and
   zero is still zero, which is all that matters here. -}

-- | Windows of k1 x k2 cells, no larger than the grid. See Note [Rolling contents].
sweep :: Visit -> (Int, Int) -> Tile -> MVector s Word64 -> ST s ()
sweep windows (k1, k2) (Tile r0 r1 c0 c1) set = do
  -- Entry t + k2 is column c + t of the strip that begins at c; the first k2 entries stay 0.
  numbers <- Mutable.replicate (width + 2 * k2) 0
  forM_ [c0, c0 + width .. c1 - 1] $ \c -> do
    Mutable.set numbers 0
    let strip =
          Strip
            { stripSurface = visitSurface windows,
              stripGrid = grid,
              stripBase = base,
              stripColumns = k2,
              stripFrom = c,
              stripSize = min width (c1 - c) + k2 - 1
            }
        takeRow = rowOfStrip strip numbers set
    forM_ [r0 .. r0 + k1 - 2] $ \r -> takeRow (Row r r 0) maxBound
    -- The first row of windows leaves no cell behind.
    takeRow (Row (r0 + k1 - 1) (r0 + k1 - 1) 0) (k2 - 1)
    forM_ [r0 + 1 .. r1 - 1] $ \r -> takeRow (Row (r + k1 - 1) (r - 1) base) (k2 - 1)
  where
    width = max 1 (min 4096 (c1 - c0))
    grid = visitGrid windows
    base = gridAlphabet grid ^ k1

-- | Columns of the grid that are swept at once.
data Strip = Strip
  { stripSurface :: !Surface,
    stripGrid :: !Grid,
    -- | q^k1: the numbers of columns are below it.
    stripBase :: !Int,
    -- | k2.
    stripColumns :: !Int,
    -- | The first column.
    stripFrom :: !Int,
    -- | The number of columns; the last may lie beyond the edge by less than a turn.
    stripSize :: !Int
  }

-- | The row that enters the windows, the row that leaves them, and its weight. Rows may lie beyond
-- the edge by less than a turn.
data Row = Row !Int !Int !Int

-- | Adds a row of cells to the numbers of a strip's columns and removes another. Then it includes
-- the windows that end at this column of the strip, counted from 0, or later.
rowOfStrip :: Strip -> MVector s Word32 -> MVector s Word64 -> Row -> Int -> ST s ()
rowOfStrip (Strip surface grid base k2 c size) numbers set (Row new old weight) first =
  foldM_ segment 0 (zip bounds (drop 1 bounds))
  where
    -- Columns beyond the edge, and columns where no window ends yet, are treated separately.
    bounds = [0] ++ sort (filter (\t -> 0 < t && t < size) [first, width - c]) ++ [size]
    segment key (from, to) = roll (from >= first) (origin new past) (origin old past) from to key
      where
        past = c + from >= width
    -- The index of the strip's first column, if it were on the same side of the edge.
    origin i past
      | not past = (i `mod` height) * width + c
      | surface == TwistedTorus = ((i + 1) `mod` height) * width + c - width
      | otherwise = (i `mod` height) * width + c - width
    roll including newest oldest from to = go from
      where
        go !t !key
          | t == to = pure key
          | otherwise = do
            number <- Mutable.unsafeRead numbers (t + k2)
            gone <- Mutable.unsafeRead numbers t
            let number' = fromIntegral number * q + cell (newest + t) - cell (oldest + t) * weight
                key' = key * base + number' - fromIntegral gone * spanned
            Mutable.unsafeWrite numbers (t + k2) (fromIntegral number')
            when including (include set key')
            go (t + 1) key'
    {-# INLINE roll #-}
    cell i = fromIntegral (Primitive.unsafeIndex cells i) :: Int
    cells = gridCells grid
    q = gridAlphabet grid
    spanned = base ^ k2
    height = gridHeight grid
    width = gridWidth grid
