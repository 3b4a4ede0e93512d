-- | The memory table in bulk: packed windows in, packed positions out, one read of the memory for
-- each, as the paper's section II has it. A packed window is its number under the table's
-- 'Packing'; a packed position is row * columns + column. Both are below 2^26, the limit of a table
-- ('largestTable'), and so fit 32 bits with room for two numbers that are no position:
-- 'notOccurring' and 'notUnique'.
module PraTactile.Locate.Bulk
  ( -- * The memory
    Memory,
    memoryOf,
    memorySize,

    -- * Many windows at once
    locateWindows,
    notOccurring,
    notUnique,

    -- * Packing and unpacking
    packWindow,
    packPosition,
    unpackPosition,
  )
where

import Data.Int (Int32)
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word32)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (positionAt)
import PraTactile.Locate
import PraTactile.Window

-- | A table as one entry a packed window, 4 bytes each. Unlike the 'Table' it does not have the
-- positions of a window that has several.
data Memory (k :: Field) = Memory
  { memoryShape :: !Shape,
    memoryPacking :: !Packing,
    memoryCells :: !Int,
    memoryEntries :: !(Vector Int32)
  }

type role Memory nominal

-- | The memory of a table. O(q^m) for windows of m cells, and 4 q^m bytes.
memoryOf :: Table k -> Memory k
memoryOf table =
  Memory
    (tableShape table)
    (tablePacking table)
    (maskSize (tableMask table))
    (tableUnique notOccurring notUnique table)

-- | q^cells: the number of entries.
memorySize :: Memory k -> Natural
memorySize = fromIntegral . Primitive.length . memoryEntries

-- | -1: the window occurs nowhere, or the number is no packed window at all.
notOccurring :: Int32
notOccurring = -1

-- | -2: the window occurs at more than one position; 'tableLookup' lists them.
notUnique :: Int32
notUnique = -2

-- | The packed position of each packed window, in their order; 'notOccurring' or 'notUnique' where
-- there is not exactly one. Any numbers are taken. One read of the memory each: a memory that the
-- cache holds gives hundreds of millions a second, and a larger one as many as reads at random
-- places allow. O(k) for k windows.
locateWindows :: Memory k -> Vector Word32 -> Vector Int32
locateWindows memory = Primitive.map entry
  where
    entries = memoryEntries memory
    size = fromIntegral (Primitive.length entries) :: Word32
    entry window
      | window < size = Primitive.unsafeIndex entries (fromIntegral window)
      | otherwise = notOccurring

-- | The packed window of a content in reading order; 'Nothing' for another number of cells than the
-- window's. O(m) for m cells.
packWindow :: forall k. KnownField k => Memory k -> [GF k] -> Maybe Word32
packWindow memory content
  | length (take (memoryCells memory + 1) content) == memoryCells memory =
    Just
      ( fromIntegral
          (pack (memoryPacking memory) (fieldOrder (Proxy :: Proxy k)) (map toCode content))
      )
  | otherwise = Nothing

-- | The packed position of a cell of the array; 'Nothing' beyond its edges.
packPosition :: Memory k -> Position -> Maybe Int32
packPosition memory (Position r c)
  | r < rows shape && c < columns shape = Just (fromIntegral (r * columns shape + c))
  | otherwise = Nothing
  where
    shape = memoryShape memory

-- | The position that is packed; 'Nothing' for 'notOccurring', 'notUnique' and every other number
-- that is none.
unpackPosition :: Memory k -> Int32 -> Maybe Position
unpackPosition memory packed
  | packed >= 0 && fromIntegral packed < area shape = Just (positionAt shape (fromIntegral packed))
  | otherwise = Nothing
  where
    shape = memoryShape memory
