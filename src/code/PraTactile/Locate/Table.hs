-- |
-- The memory table of the paper's section II: the packed content of a window leads to the
-- positions where it stands. It holds for any grid, with repeated windows or without.
module PraTactile.Locate.Table
  ( CodeTable,
    buildCodeTable,
    codeTableSize,
    codeTableLookup,
    codeTableUnique,
    largestTable,
  )
where

import Control.Monad (void)
import Control.Monad.ST (ST)
import Data.Int (Int32)
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Grid
import PraTactile.Window
import PraTactile.Window.Visit

-- | Positions sorted by packed window (compressed rows): those of window w are the entries from the
-- start of w up to, not including, the start of w + 1.
data CodeTable = CodeTable
  { tableStarts :: !(Vector Int32),
    tablePositions :: !(Vector Int32),
    tableColumns :: !Int
  }

-- | 2^26: the most packed windows, and the most positions, that a table may have, four bytes each.
largestTable :: Natural
largestTable = 2 ^ (26 :: Int)

-- | The table of all windows of the surface. 'Left' with the number of entries that it would need
-- when that exceeds 'largestTable'.
buildCodeTable :: Packing -> Surface -> Grid -> Mask -> Either Natural CodeTable
buildCodeTable packing surface grid mask
  | spanned > largestTable = Left spanned
  | area (gridShape grid) > largestTable = Left (area (gridShape grid))
  | otherwise =
    maybe (Left spanned) (Right . sortByWindow (gridWidth grid)) (visit packing surface grid mask)
  where
    spanned = fromIntegral (gridAlphabet grid) ^ maskSize mask

-- | A counting sort: how often each window occurs, where each begins, then every position to its
-- place.
sortByWindow :: Int -> Visit -> CodeTable
sortByWindow width windows = CodeTable starts positions width
  where
    counts = Primitive.create $ do
      tally <- Mutable.replicate (visitSpan windows) 0
      forWindows windows $ \_ _ key -> void (increment tally key)
      pure tally
    starts = Primitive.scanl (+) 0 counts
    positions = Primitive.create $ do
      next <- Primitive.thaw (Primitive.take (visitSpan windows) starts)
      sorted <- Mutable.replicate (visitRows windows * visitColumns windows) 0
      forWindows windows $ \r c key -> do
        place <- increment next key
        Mutable.write sorted (fromIntegral place) (fromIntegral (r * width + c))
      pure sorted

-- | Add one to an entry and return what it was.
increment :: Mutable.MVector s Int32 -> Int -> ST s Int32
increment tally i = do
  n <- Mutable.read tally i
  Mutable.write tally i (n + 1)
  pure n

-- | q^cells, the number of packed windows.
codeTableSize :: CodeTable -> Natural
codeTableSize table = fromIntegral (Primitive.length (tableStarts table) - 1)

-- | The positions of a packed window, by row and column; none when it does not occur or is no
-- packed window.
codeTableLookup :: CodeTable -> Natural -> [Position]
codeTableLookup table packed
  | packed >= codeTableSize table = []
  | otherwise =
    map
      position
      (Primitive.toList (Primitive.take (to - from) (Primitive.drop from (tablePositions table))))
  where
    -- The table has a start for every window and one more.
    window = fromIntegral packed
    from = fromIntegral (tableStarts table Primitive.! window)
    to = fromIntegral (tableStarts table Primitive.! (window + 1))
    position i = let (r, c) = fromIntegral i `divMod` tableColumns table in visitPosition r c

-- | The position, row * width + column, of each packed window that has exactly one; the first
-- number where there is none, the second where there are several.
codeTableUnique :: Int32 -> Int32 -> CodeTable -> Vector Int32
codeTableUnique none several table = Primitive.zipWith unique starts (Primitive.drop 1 starts)
  where
    starts = tableStarts table
    unique from to
      | from == to = none
      -- A window that occurs starts at an entry of the positions.
      | from + 1 == to = tablePositions table Primitive.! fromIntegral from
      | otherwise = several
