-- | The memory table in bulk: it maps packed windows to packed positions, with one read of memory
-- for each, as in the paper's section II. A packed window is its number under the table's
-- 'Packing'; a packed position is row * columns + column. Both are below 2^26, the limit of a table
-- ('largestTable'). So both fit 32 bits, with room for 'notOccurring' and 'notUnique', which are
-- not positions.
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

-- | A table with one entry of 4 bytes for each packed window. Unlike 'Table' it does not list
-- several positions of a window.
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

-- | The number of entries, q^cells.
memorySize :: Memory k -> Natural
memorySize = fromIntegral . Primitive.length . memoryEntries

-- | -1: the window occurs nowhere, or the number is not a packed window.
notOccurring :: Int32
notOccurring = -1

-- | -2: the window occurs at more than one position; 'tableLookup' lists them.
notUnique :: Int32
notUnique = -2

-- | The packed position of each packed window, in order; 'notOccurring' or 'notUnique' if there is
-- not exactly one. Any numbers are accepted. A memory that fits the cache gives hundreds of
-- millions of positions a second; a larger one is limited by random reads. O(k) for k windows.
locateWindows :: Memory k -> Vector Word32 -> Vector Int32
locateWindows memory = Primitive.map entry
  where
    entries = memoryEntries memory
    size = fromIntegral (Primitive.length entries) :: Word32
    entry window
      | window < size = Primitive.unsafeIndex entries (fromIntegral window)
      | otherwise = notOccurring

-- | The packed window with this content in reading order; 'Nothing' if the number of cells is
-- wrong. O(m) for m cells.
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

-- | The position for a packed position; 'Nothing' for 'notOccurring', 'notUnique' and any other
-- number that is not one.
unpackPosition :: Memory k -> Int32 -> Maybe Position
unpackPosition memory packed
  | packed >= 0 && fromIntegral packed < area shape = Just (positionAt shape (fromIntegral packed))
  | otherwise = Nothing
  where
    shape = memoryShape memory
