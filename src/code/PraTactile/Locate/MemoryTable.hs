-- | From the content of a window to its position, by the memory table (section II of the paper).
-- The function is total: it answers, or says why not, for every patch and every array, also those
-- in which windows repeat.
module PraTactile.Locate.MemoryTable
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

import Data.Int (Int32)
import Data.List (foldl', sort)
import Data.Maybe (isJust)
import Data.Proxy (Proxy (..))
import qualified Data.Set as Set
import Data.Vector.Primitive (Vector)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid
import PraTactile.Locate.Answer
import PraTactile.Locate.Patch
import PraTactile.Locate.Table
import PraTactile.Window

-- | The memory table of an array: packed window to positions, on a surface.
data Table (k :: Field) = Table
  { -- | The surface whose windows it holds.
    tableSurface :: !Surface,
    -- | The windows' shape.
    tableMask :: !Mask,
    -- | How windows are packed.
    tablePacking :: !Packing,
    tableGrid :: !Grid,
    tableCodes :: !CodeTable
  }

type role Table nominal

-- | The table of all windows of the array on the surface. Refuses more than 'largestTable' packed
-- windows or cells, before taking memory.
buildTable ::
  forall k.
  KnownField k =>
  Packing ->
  Surface ->
  PseudorandomArray k ->
  Mask ->
  Either LocateError (Table k)
buildTable packing surface array mask
  | spanned > largestTable = Left (TableTooLarge spanned largestTable)
  | cells > largestTable = Left (TableTooLarge cells largestTable)
  | otherwise = do
    grid <- either (Left . TableArray) Right (toGrid array)
    codes <-
      either
        (Left . (`TableTooLarge` largestTable))
        Right
        (buildCodeTable packing surface grid mask)
    pure (Table surface mask packing grid codes)
  where
    spanned = fromIntegral (fieldOrder (Proxy :: Proxy k)) ^ maskSize mask
    cells = area (arrayShape array)

-- | q^cells: the number of packed windows, each an address of the memory.
tableSize :: Table k -> Natural
tableSize = codeTableSize . tableCodes

-- | The positions of a packed window, ascending; none if it does not occur.
tableLookup :: Table k -> Natural -> [Position]
tableLookup = codeTableLookup . tableCodes

-- | The packed windows that occur, ascending, each with its positions.
tableEntries :: Table k -> [(Natural, [Position])]
tableEntries table =
  [ (packed, positions)
    | packed <- [0 .. tableSize table - 1],
      positions@(_ : _) <- [tableLookup table packed]
  ]

-- | The shape of the array.
tableShape :: Table k -> Shape
tableShape = gridShape . tableGrid

-- | Of each packed window, in order, the position row * columns + column where it is; the first
-- number if it does not occur, the second if it is at several positions.
tableUnique :: Int32 -> Int32 -> Table k -> Vector Int32
tableUnique none several = codeTableUnique none several . tableCodes

-- | The place of a patch: all its complete windows and all its other observed cells must agree. On
-- the sheet, every observed cell and the patch's upper left must lie on it.
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
    -- For each window that occurs, where the patch's upper left is if the window is at one of its
    -- positions.
    originsOfWindows =
      [ Set.fromList (map (origin table offset) positions)
        | (offset, content) <- windows,
          positions@(_ : _) <- [windowPositions table content]
      ]
    outcome fits = case [place | Fits place <- fits] of
      [place] -> Unique place support
      [] -> Refused (if SticksOut `elem` fits then OffSheet else Contradiction)
      places -> Ambiguous (sort places) support

-- | The row and column of the patch's upper left when the cell at this offset lies at that
-- position; on the sheet perhaps negative.
origin :: Table k -> Position -> Position -> (Integer, Integer)
origin table (Position i j) (Position r c) =
  case canonicalPosition (tableSurface table) (gridShape (tableGrid table)) r' c' of
    Just (Position a b) -> (toInteger a, toInteger b)
    Nothing -> (r', c')
  where
    r' = toInteger r - toInteger i
    c' = toInteger c - toInteger j

-- | How a patch compares with the array at a place.
data Fit = Fits Position | SticksOut | Differs
  deriving stock (Eq)

-- | Compare all observed cells when the patch's upper left is at this row and column.
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

windowPositions :: Table k -> [GF k] -> [Position]
windowPositions table content =
  tableLookup
    table
    (pack (tablePacking table) (gridAlphabet (tableGrid table)) (map toCode content))
