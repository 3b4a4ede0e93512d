{-# OPTIONS_HADDOCK hide #-}

-- | From the content of a window to its position, by a memory table (section II of the paper). The
-- function is total: it has an answer or a reason for every patch and every array, even if windows
-- repeat.
module PraTactile.Locate.Decoder.MemoryTable
  ( -- * Tables
    Table,
    buildTable,
    tableSurface,
    tableShape,
    tableMask,
    tablePacking,
    tableSize,
    tableLookup,
    tableEntries,
    tableUnique,
    largestTable,

    -- * Locating
    locatePatch,
  )
where

import Control.Monad (void)
import Control.Monad.ST (ST)
import Data.Int (Int32)
import Data.List (foldl', sort)
import Data.Maybe (isJust)
import Data.Proxy (Proxy (..))
import qualified Data.Set as Set
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid
import PraTactile.Locate.Answer
import PraTactile.Locate.Patch
import PraTactile.Window
import PraTactile.Window.Visit

-- | The memory table of an array on a surface: from packed window to positions.
data Table (k :: Field) = Table
  { -- | The surface whose windows the table holds.
    tableSurface :: !Surface,
    -- | The shape of the windows.
    tableMask :: !Mask,
    -- | How windows are packed.
    tablePacking :: !Packing,
    -- | The array's cells.
    tableGrid :: !Grid,
    -- | The positions sorted by packed window. Those of window w are the entries of
    -- @tablePositions@ from the start of w up to the start of w + 1, exclusive.
    tableStarts :: !(Vector Int32),
    tablePositions :: !(Vector Int32)
  }

type role Table nominal

-- | The most packed windows, and the most positions, of a table: 2^26, with four bytes each.
largestTable :: Natural
largestTable = 2 ^ (26 :: Int)

-- | The table of all windows of the array on the surface. Refuses more than 'largestTable' packed
-- windows or cells, before it allocates memory. O((n + m) N + q^m) for N cells, windows of m cells
-- and a polynomial of degree n. It takes 4 (N + q^m) + N bytes.
buildTable ::
  forall k.
  KnownField k =>
  Packing ->
  ArrayOn k ->
  Mask ->
  Either LocateError (Table k)
buildTable packing (ArrayOn surface array) mask
  | spanned > largestTable = Left (TableTooLarge spanned largestTable)
  | cells > largestTable = Left (TableTooLarge cells largestTable)
  | otherwise = do
    grid <- either (Left . TableArray) Right (toGrid array)
    -- Packed windows below 2^26 can be visited.
    windows <-
      maybe
        (Left (TableTooLarge spanned largestTable))
        Right
        (visit packing surface grid mask)
    let (starts, positions) = sortByWindow (gridWidth grid) windows
    pure (Table surface mask packing grid starts positions)
  where
    spanned = fromIntegral (fieldOrder (Proxy :: Proxy k)) ^ maskSize mask
    cells = area (arrayShape array)

-- | The 'tableStarts' and 'tablePositions' of a table whose array has this many columns, by a
-- counting sort: count each window, compute the starts, then put every position in its place.
sortByWindow :: Int -> Visit -> (Vector Int32, Vector Int32)
sortByWindow width windows = (starts, positions)
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

-- | Adds 1 to an entry and returns its old value.
increment :: Mutable.MVector s Int32 -> Int -> ST s Int32
increment tally i = do
  n <- Mutable.read tally i
  Mutable.write tally i (n + 1)
  pure n

-- | The number of packed windows, q^cells; each is an address of the memory.
tableSize :: Table k -> Natural
tableSize table = fromIntegral (Primitive.length (tableStarts table) - 1)

-- | The positions of a packed window, ascending; empty if it does not occur, or the number is not a
-- packed window. O(p) for p positions.
tableLookup :: Table k -> Natural -> [Position]
tableLookup table packed
  | packed >= tableSize table = []
  | otherwise = map position (Primitive.toList (Primitive.slice from (to - from) positions))
  where
    -- The table has a start for every window and one more.
    window = fromIntegral packed
    from = fromIntegral (tableStarts table Primitive.! window)
    to = fromIntegral (tableStarts table Primitive.! (window + 1))
    positions = tablePositions table
    position = positionAt (tableShape table) . fromIntegral

-- | The packed windows that occur, ascending, each with its positions. O(q^m + N) for N positions
-- of windows of m cells, computed lazily.
tableEntries :: Table k -> [(Natural, [Position])]
tableEntries table =
  [ (packed, positions)
    | packed <- [0 .. tableSize table - 1],
      positions@(_ : _) <- [tableLookup table packed]
  ]

-- | The shape of the array.
tableShape :: Table k -> Shape
tableShape = gridShape . tableGrid

-- | For each packed window in order, its position as row * columns + column. Arguments: the number
-- for a window that does not occur; the number for one with several positions; the table. O(q^m)
-- for windows of m cells.
tableUnique :: Int32 -> Int32 -> Table k -> Vector Int32
tableUnique none several table = Primitive.zipWith unique starts (Primitive.drop 1 starts)
  where
    starts = tableStarts table
    unique from to
      | from == to = none
      -- A window that occurs has a start below the number of positions.
      | from + 1 == to = tablePositions table Primitive.! fromIntegral from
      | otherwise = several

-- | Locates a patch: all its complete windows and all its other observed cells must agree. On the
-- sheet, every observed cell and the patch's upper left cell must lie on it. O(w m log a + p a) for
-- a observed cells with w complete windows of m cells, which have p positions.
locatePatch :: Table k -> Patch (GF k) -> Outcome Position
locatePatch table observed
  | null cells = Refused TooFewCells
  | null windows = Refused NoCompleteWindow
  | otherwise = case originsOfWindows of
    [] -> Refused (if all (all (== zero) . snd) windows then ZeroWindow else NotInArray)
    origins : others ->
      outcome (map (compareAt table cells) (Set.toAscList (foldl' Set.intersection origins others)))
  where
    cells = observedCells observed
    windows = completeWindows (tableMask table) observed
    support = map fst windows
    -- For each window that occurs, the patch's upper left corner for each of its positions.
    originsOfWindows =
      [ Set.fromList (map (origin table offset) positions)
        | (offset, content) <- windows,
          positions@(_ : _) <- [windowPositions table content]
      ]
    outcome fits = case [place | Fits place <- fits] of
      [place] -> Unique place support
      [] -> Refused (if SticksOut `elem` fits then OffSheet else Contradiction)
      places -> Ambiguous (sort places) support

-- | The row and column of the patch's upper left cell when the cell at this offset is at this
-- position; they may be negative on the sheet.
origin :: Table k -> Position -> Position -> (Integer, Integer)
origin table (Position i j) (Position r c) =
  case canonicalPosition (tableSurface table) (gridShape (tableGrid table)) r' c' of
    Just (Position a b) -> (toInteger a, toInteger b)
    Nothing -> (r', c')
  where
    r' = toInteger r - toInteger i
    c' = toInteger c - toInteger j

-- | How a patch compares with the array at a position: it agrees; it agrees as far as it lies on
-- the sheet, but lies partly beyond it; a cell differs.
data Fit = Fits Position | SticksOut | Differs
  deriving stock (Eq)

-- | Compares all observed cells, with the patch's upper left cell at this row and column.
compareAt :: Table k -> [(Position, GF k)] -> (Integer, Integer) -> Fit
compareAt table cells (r, c)
  | or [code /= toCode a | (Just code, a) <- compared] = Differs
  | Just place <- cellOf (Position 0 0), all (isJust . fst) compared = Fits place
  | otherwise = SticksOut
  where
    grid = tableGrid table
    compared = [(cellOf offset >>= codeAt grid, a) | (offset, a) <- cells]
    cellOf (Position i j) =
      canonicalPosition (tableSurface table) (gridShape grid) (r + toInteger i) (c + toInteger j)

-- | The positions of a window with this content.
windowPositions :: Table k -> [GF k] -> [Position]
windowPositions table content =
  tableLookup
    table
    (pack (tablePacking table) (gridAlphabet (tableGrid table)) (map toCode content))
