-- |
-- Visiting every window of a grid as a packed machine integer. Internal: shared by the proof by
-- enumeration and the memory table.
module PraTactile.Window.Visit
  ( Visit (..)
  , visit
  , forWindows
  , packedWindows
  , packedAt
  , visitedShape
  , visitPosition
  ) where

import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Grid
import PraTactile.Window

-- | The windows of a grid: positions (r, c) with 0 <= r < 'visitRows' and 0 <= c < 'visitColumns',
-- and the packed content at each.
data Visit = Visit
  { visitRows :: !Int
  , visitColumns :: !Int
  , visitSpan :: !Int
  -- ^ q^cells: packed contents are below it
  , visitKey :: Int -> Int -> Int
  }

-- | All windows of this shape on the surface. 'Nothing' when q^cells exceeds 2^62, so that a packed
-- window would not fit. On the sheet only windows that lie on it wholly are visited, perhaps none.
visit :: Packing -> Surface -> Grid -> Mask -> Maybe Visit
visit packing surface grid mask
  | spanned > 2 ^ (62 :: Int) = Nothing
  | otherwise = Just (Visit (int visitedRows) (int visitedColumns) (int spanned) key)
 where
  int = fromIntegral :: Natural -> Int
  spanned = fromIntegral q ^ maskSize mask :: Natural
  q = gridAlphabet grid
  height = gridHeight grid
  width = gridWidth grid
  cells = height * width
  codes = gridCells grid
  Shape visitedRows visitedColumns = visitedShape surface (gridShape grid) mask
  -- Offsets reduced to less than one turn, so that one subtraction wraps a coordinate.
  offsets = case packing of
    MostSignificantFirst -> maskOffsets mask
    LeastSignificantFirst -> reverse (maskOffsets mask)
  count = maskSize mask
  modulo side n = fromIntegral (n `mod` fromIntegral side) :: Int
  down = Primitive.fromListN count (map (modulo height . row) offsets)
  right = Primitive.fromListN count (map (modulo width . column) offsets)
  along = Primitive.fromListN count [modulo cells (row o * fromIntegral width + column o) | o <- offsets]
  once side i = if i >= side then i - side else i
  -- j counts the offsets; with r and c among those visited, the index lies within the cells.
  index r c j = case surface of
    TwistedTorus -> once cells (r * width + c + Primitive.unsafeIndex along j)
    _ ->
      once height (r + Primitive.unsafeIndex down j) * width
        + once width (c + Primitive.unsafeIndex right j)
  key r c = go 0 0
   where
    go j acc
      | j == count = acc
      | otherwise = go (j + 1) (acc * q + fromIntegral (codes Primitive.! index r c j))

-- | Run an action for each window in turn, row by row: its coordinates and its packed content. A
-- loop, because a list of millions of positions would be kept in memory between two passes.
forWindows :: Monad m => Visit -> (Int -> Int -> Int -> m ()) -> m ()
forWindows windows act = go 0 0
 where
  go r c
    | r == visitRows windows = pure ()
    | c == visitColumns windows = go (r + 1) 0
    | otherwise = act r c (visitKey windows r c) >> go r (c + 1)
{-# INLINE forWindows #-}

-- | All windows in turn, row by row, when their packed contents may exceed a machine integer.
packedWindows :: Packing -> Surface -> Grid -> Mask -> [(Position, Natural)]
packedWindows packing surface grid mask =
  [(p, content) | r <- counted height, c <- counted width, let p = Position r c, Just content <- [packedAt packing surface grid mask p]]
 where
  Shape height width = visitedShape surface (gridShape grid) mask
  counted n = takeWhile (< n) [0 ..]

-- | The packed content of one window; 'Nothing' where it sticks out of the sheet.
packedAt :: Packing -> Surface -> Grid -> Mask -> Position -> Maybe Natural
packedAt packing surface grid mask (Position r c) =
  pack packing (gridAlphabet grid) <$> traverse cell (maskOffsets mask)
 where
  cell (Position i j) = at (toInteger (r + i)) (toInteger (c + j)) >>= codeAt grid
  at = canonicalPosition surface (gridShape grid)

-- | The rows and columns at which windows are: all of a torus; on the sheet those from which the
-- mask does not stick out.
visitedShape :: Surface -> Shape -> Mask -> Shape
visitedShape surface shape mask = case surface of
  Sheet -> Shape (within (rows shape) (rows extent)) (within (columns shape) (columns extent))
  _ -> shape
 where
  extent = maskExtent mask
  within side size = if size > side then 0 else side - size + 1

-- | The position of visited coordinates.
visitPosition :: Int -> Int -> Position
visitPosition r c = Position (fromIntegral r) (fromIntegral c)
