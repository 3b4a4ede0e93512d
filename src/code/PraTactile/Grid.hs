-- | Rectangular matrices of symbol codes, whether they are pseudorandom arrays or not, and how rows
-- and columns continue at their edges.
module PraTactile.Grid
  ( -- * Shapes and positions
    Shape (..),
    area,
    Position (..),
    shapeCells,
    positionAt,
    extentOf,
    naturalsBelow,
    raggedRow,
    Surface (..),
    canonicalPosition,
    displaced,
    admissible,

    -- * Grids
    Grid,
    gridFromRows,
    gridFromVector,
    gridShape,
    gridAlphabet,
    gridRows,
    gridCells,
    gridHeight,
    gridWidth,
    codeAt,
    GridError (..),
    largestGrid,
  )
where

import Data.Maybe (listToMaybe)
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word8)
import Numeric.Natural (Natural)
import PraTactile.Position

-- | The cells of a rectangle, row by row. O(N) for N cells, computed lazily.
--
-- >>> [(r, c) | Position r c <- shapeCells (Shape 2 2)]
-- [(0,0),(0,1),(1,0),(1,1)]
shapeCells :: Shape -> [Position]
shapeCells shape = Position <$> naturalsBelow (rows shape) <*> naturalsBelow (columns shape)

-- | The cell with this index, from 0, in a rectangle counted row by row.
--
-- >>> positionAt (Shape 2 3) 4
-- Position {row = 1, column = 1}
positionAt :: Shape -> Int -> Position
positionAt shape i = uncurry Position (fromIntegral i `divMod` max 1 (columns shape))

-- | The smallest rectangle that contains the cells with these offsets and the upper left cell (0,
-- 0). O(m) for m offsets.
--
-- >>> extentOf [Position 2 1, Position 0 4]
-- Shape {rows = 3, columns = 5}
extentOf :: [Position] -> Shape
extentOf offsets = Shape (1 + maximum (0 : map row offsets)) (1 + maximum (0 : map column offsets))

-- | The natural numbers below this one, ascending. @[0 .. n - 1]@ would underflow for 0. O(n),
-- computed lazily.
--
-- >>> naturalsBelow 3
-- [0,1,2]
naturalsBelow :: Natural -> [Natural]
naturalsBelow n = takeWhile (< n) [0 ..]

-- | The first row whose length differs from the first row's: its index from 0, its length, and the
-- first row's length. O(N) for N cells.
--
-- >>> raggedRow ["ab", "cd", "e"]
-- Just (2,1,2)
raggedRow :: [[a]] -> Maybe (Int, Int, Int)
raggedRow given = listToMaybe [(i, n, width) | (i, n) <- zip [0 ..] (map length given), n /= width]
  where
    width = sum (map length (take 1 given))

-- | What lies beyond the last row and the last column.
data Surface
  = -- | After the last row comes the first row, and after the last column the first column.
    Torus
  | -- | After the last row comes the first row. After the last column comes column 0 of the next
    -- row.
    TwistedTorus
  | -- | Nothing lies beyond the edges.
    Sheet
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The cell within the shape for a row and a column, which may be negative, on this surface.
-- 'Nothing' exactly if it is beyond the edges of the sheet, or the shape has no cells.
--
-- >>> canonicalPosition TwistedTorus (Shape 3 5) 2 7
-- Just (Position {row = 0, column = 2})
canonicalPosition :: Surface -> Shape -> Integer -> Integer -> Maybe Position
canonicalPosition surface shape r c
  | area shape == 0 = Nothing
  | otherwise = case surface of
    Torus -> Just (position (r `mod` height) (c `mod` width))
    TwistedTorus ->
      let (carry, c') =
            c `divMod` width
       in Just (position ((r + carry) `mod` height) c')
    Sheet
      | 0 <= r && r < height && 0 <= c && c < width -> Just (position r c)
      | otherwise -> Nothing
  where
    height = toInteger (rows shape)
    width = toInteger (columns shape)
    position i j = Position (fromInteger i) (fromInteger j)

-- | The cell at an offset, in rows down and columns to the right, from a position on this surface
-- of this shape. 'Nothing' as for 'canonicalPosition'.
--
-- >>> displaced Torus (Shape 15 17) (Position 14 16) (Position 1 2)
-- Just (Position {row = 0, column = 1})
displaced :: Surface -> Shape -> Position -> Position -> Maybe Position
displaced surface shape (Position r c) (Position i j) =
  canonicalPosition surface shape (toInteger (r + i)) (toInteger (c + j))

-- | The shape of the region of positions, from the upper left, at which a rectangle fits on a
-- surface. The first shape is the surface's, the second the rectangle's, with at least one cell. On
-- a torus it is the whole shape; on the sheet, the positions from which the rectangle does not
-- extend beyond it.
--
-- >>> admissible Sheet (Shape 15 17) (Shape 2 2)
-- Shape {rows = 14, columns = 16}
admissible :: Surface -> Shape -> Shape -> Shape
admissible surface shape extent = case surface of
  Sheet -> Shape (begins (rows shape) (rows extent)) (begins (columns shape) (columns extent))
  _ -> shape
  where
    begins side size = if size > side then 0 else side + 1 - size

-- | Why a matrix is not accepted.
data GridError
  = -- | There are no rows, or the rows have no cells.
    GridEmpty
  | -- | The row with this index, from 0, has the second number of cells instead of the third.
    GridRagged Int Int Int
  | -- | The cell at this position has this code, which is not below the alphabet's size.
    GridCode Position Int
  | -- | The alphabet has this size, not 2 ... 256.
    GridAlphabet Int
  | -- | There are this many cells: more than 'largestGrid', or not as many as the shape has.
    GridCells Natural
  deriving stock (Eq, Show)

-- | The most cells that are held in memory at a time, one byte each: 2^28.
largestGrid :: Natural
largestGrid = 2 ^ (28 :: Int)

-- | A matrix of 1 to 'largestGrid' codes, each below the size of the alphabet.
data Grid = Grid
  { -- | the size q of the alphabet, 2 ... 256
    gridAlphabet :: !Int,
    -- | the number of rows
    gridHeight :: !Int,
    -- | the number of columns
    gridWidth :: !Int,
    -- | the codes, row by row
    gridCells :: !(Vector Word8)
  }
  deriving stock (Eq, Show)

-- | The grid with these rows over an alphabet of this size. Refuses an alphabet outside 2 ... 256,
-- no cells, rows of different lengths, and codes outside the alphabet. O(N) for N cells.
gridFromRows :: Int -> [[Int]] -> Either GridError Grid
gridFromRows q codes
  | q < 2 || q > 256 = Left (GridAlphabet q)
  | width == 0 = Left GridEmpty
  | Just (i, given, first) <- raggedRow codes = Left (GridRagged i given first)
  | (position, c) : _ <- outside = Left (GridCode position c)
  | cells > largestGrid = Left (GridCells cells)
  | otherwise = Right (Grid q height width (Primitive.fromListN (height * width) flat))
  where
    flat = map fromIntegral (concat codes)
    height = length codes
    width = sum (map length (take 1 codes))
    cells = fromIntegral height * fromIntegral width
    outside =
      [(Position i j, c) | (i, r) <- zip [0 ..] codes, (j, c) <- zip [0 ..] r, c < 0 || c >= q]

-- | The grid with q symbols and this shape, with codes given row by row. Refuses what
-- 'gridFromRows' refuses, and a wrong number of codes. O(N) for N cells; the vector is not copied.
gridFromVector :: Int -> Shape -> Vector Word8 -> Either GridError Grid
gridFromVector q shape codes
  | q < 2 || q > 256 = Left (GridAlphabet q)
  | area shape == 0 = Left GridEmpty
  | cells > largestGrid || cells /= area shape = Left (GridCells cells)
  | (i, c) : _ <- outside = Left (GridCode (positionAt shape i) (fromIntegral c))
  | otherwise = Right (Grid q (fromIntegral (rows shape)) width codes)
  where
    cells = fromIntegral (Primitive.length codes)
    outside =
      [(i, codes Primitive.! i) | Just i <- [Primitive.findIndex ((>= q) . fromIntegral) codes]]
    width = fromIntegral (columns shape) :: Int

-- | The numbers of rows and columns.
gridShape :: Grid -> Shape
gridShape grid = Shape (fromIntegral (gridHeight grid)) (fromIntegral (gridWidth grid))

-- | The codes, row by row. O(N) for N cells, computed lazily.
gridRows :: Grid -> [[Int]]
gridRows grid = [map fromIntegral (Primitive.toList (rowAt i)) | i <- [0 .. gridHeight grid - 1]]
  where
    rowAt i = Primitive.take w (Primitive.drop (i * w) (gridCells grid))
    w = gridWidth grid

-- | The code in a cell; 'Nothing' exactly beyond the edges. Use 'canonicalPosition' to bring a
-- position within them.
codeAt :: Grid -> Position -> Maybe Int
codeAt grid (Position r c)
  | r < rows shape && c < columns shape =
    fromIntegral <$> gridCells grid Primitive.!? fromIntegral (r * columns shape + c)
  | otherwise = Nothing
  where
    shape = gridShape grid
