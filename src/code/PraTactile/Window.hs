-- | Windows: the few neighbouring cells whose content determines a position (section II of the
-- paper). A window is a set of cells in reading order; a rectangle is read row by row. Its position
-- is the cell from which offsets count, whether or not it is observed: the upper left cell of a
-- rectangle, and for the offset (1, 1) alone the cell one row above and one column to the left.
--
-- The example shows rows 5 to 8 and columns 4 to 8 of the paper's array, with the window of its
-- worked example, of two rows and two columns. Its position is (6, 5), its content A^2 A A^2 1, or
-- 3 2 3 1 as codes:
--
-- >          4   5   6   7   8
-- >   5      3   1   1   1   2
-- >            +-------+
-- >   6      1 | 3   2 | 0   1
-- >   7      3 | 3   1 | 2   1
-- >            +-------+
-- >   8      3   0   1   3   0
module PraTactile.Window
  ( -- * Masks
    Mask,
    rectangle,
    maskFrom,
    maskOffsets,
    maskSize,
    maskExtent,
    maskRectangle,
    maskFromDrawing,
    maskFromRows,
    maskDrawing,
    WindowError (..),

    -- * Contents
    windowAt,

    -- * Packing
    Packing (..),
    pack,
    unpack,
  )
where

import Data.List (foldl', intercalate, unfoldr)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (displaced, extentOf, raggedRow)
import PraTactile.Rows (rowsOf)

-- | Why there is no such window.
data WindowError
  = -- | The window has no cells.
    WindowEmpty
  | -- | The window has this many cells, more than 4096.
    WindowTooLarge Natural
  | -- | The offset occurs twice.
    OffsetRepeated Position
  | -- | The drawing has this character, which is neither # nor .
    DrawingCharacter Char
  | -- | The row of the drawing with this index, from 0, has the second number of cells instead of
    -- the third.
    DrawingRagged Int Int Int
  | -- | The number is not below q^cells, so it is not a packed window.
    PackedOutOfRange Natural
  deriving stock (Eq, Show)

-- | The offsets of a window's cells from its position, in reading order, without repetition: 1 to
-- 4096 cells.
newtype Mask = Mask [Position]
  deriving stock (Eq, Ord, Show)

-- | The full rectangle, read row by row. Refuses no cells and more than 4096. O(m) for m cells.
--
-- >>> map (\(Position i j) -> (i, j)) . maskOffsets <$> rectangle (Shape 2 2)
-- Right [(0,0),(0,1),(1,0),(1,1)]
rectangle :: Shape -> Either WindowError Mask
rectangle shape
  | area shape == 0 = Left WindowEmpty
  | area shape > largestMask = Left (WindowTooLarge (area shape))
  | otherwise = Right (Mask (shapeCells shape))

-- | The cells with these offsets, read in this order. Refuses no cells, more than 4096, and an
-- offset that occurs twice. O(m log m) for m cells.
maskFrom :: [Position] -> Either WindowError Mask
maskFrom offsets
  | null offsets = Left WindowEmpty
  | size > largestMask = Left (WindowTooLarge size)
  | otherwise = go Set.empty offsets
  where
    size = fromIntegral (length offsets)
    go _ [] = Right (Mask offsets)
    go seen (o : rest)
      | o `Set.member` seen = Left (OffsetRepeated o)
      | otherwise = go (Set.insert o seen) rest

largestMask :: Natural
largestMask = 4096

-- | The offsets in reading order.
maskOffsets :: Mask -> [Position]
maskOffsets (Mask offsets) = offsets

-- | The number of cells. O(m).
maskSize :: Mask -> Int
maskSize (Mask offsets) = length offsets

-- | The smallest rectangle that contains the cells and the window's position. O(m).
maskExtent :: Mask -> Shape
maskExtent = extentOf . maskOffsets

-- | The shape of the mask if it is a full rectangle with its upper left cell at the window's
-- position, whatever its reading order; 'Nothing' for others. O(m).
maskRectangle :: Mask -> Maybe Shape
maskRectangle mask
  | area extent == fromIntegral (maskSize mask) = Just extent
  | otherwise = Nothing
  where
    extent = maskExtent mask

-- | The mask of a drawing: # for an observed cell and . for any other. Rows come from the top and
-- are separated by a slash or a line end ('rowsOf'). Refuses what 'maskFromRows' refuses.
--
-- >>> map (\(Position i j) -> (i, j)) . maskOffsets <$> maskFromDrawing "##./.##"
-- Right [(0,0),(0,1),(1,1),(1,2)]
maskFromDrawing :: String -> Either WindowError Mask
maskFromDrawing = maskFromRows . rowsOf

-- | The mask with these rows, from the top. It is read row by row; its position is its upper left
-- corner. Refuses characters other than # and ., rows of different lengths, and what 'maskFrom'
-- refuses. O(a log a) for a characters.
maskFromRows :: [String] -> Either WindowError Mask
maskFromRows drawn
  | c : _ <- filter (`notElem` "#.") (concat drawn) = Left (DrawingCharacter c)
  | Just (i, given, first) <- raggedRow drawn = Left (DrawingRagged i given first)
  | otherwise = maskFrom [Position i j | (i, r) <- zip [0 ..] drawn, (j, '#') <- zip [0 ..] r]

-- | The drawing of a mask, as 'maskFromDrawing' reads it. It does not contain the reading order.
-- O(a log m) for a cells in the extent of the mask.
--
-- >>> maskDrawing <$> maskFromDrawing "##./.##"
-- Right "##./.##"
maskDrawing :: Mask -> String
maskDrawing mask =
  intercalate "/" [[drawn (Position i j) | j <- naturalsBelow width] | i <- naturalsBelow height]
  where
    cells = Set.fromList (maskOffsets mask)
    Shape height width = maskExtent mask
    drawn cell = if cell `Set.member` cells then '#' else '.'

-- | The elements of the window at a position, in reading order. Every position has a window on a
-- torus, which repeats beyond the shape. 'Nothing' exactly when a cell lies beyond the edges of the
-- sheet. The cost is that of 'cellAt' for each of the m cells.
windowAt :: KnownField k => ArrayOn k -> Mask -> Position -> Maybe [GF k]
windowAt (ArrayOn surface array) mask position = traverse cell (maskOffsets mask)
  where
    cell offset = cellAt array <$> displaced surface (arrayShape array) position offset

-- | How a window becomes a number in base q.
data Packing
  = -- | The first cell is the most significant digit.
    MostSignificantFirst
  | -- | The first cell is the least significant digit.
    LeastSignificantFirst
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | @pack packing q codes@ is the number whose base-q digits are the codes. All codes must be from
-- 0 to below q, which is not checked. O(m) operations on numbers up to q^m.
--
-- >>> pack MostSignificantFirst 4 [3, 2, 3, 1]
-- 237
pack :: Packing -> Int -> [Int] -> Natural
pack packing q codes =
  foldl' (\n c -> fromIntegral q * n + fromIntegral c) 0 (ordered packing codes)

-- | @unpack packing q cells n@ undoes 'pack'. Refuses n >= q^cells. O(m) operations on numbers up
-- to q^m.
unpack :: Packing -> Int -> Int -> Natural -> Either WindowError [Int]
unpack packing q cells n
  | n >= base ^ max 0 cells = Left (PackedOutOfRange n)
  | otherwise = Right (ordered packing (reverse (take cells (unfoldr digit n))))
  where
    base = fromIntegral q :: Natural
    digit m = Just (fromIntegral (m `mod` base), m `div` base)

ordered :: Packing -> [a] -> [a]
ordered MostSignificantFirst = id
ordered LeastSignificantFirst = reverse
