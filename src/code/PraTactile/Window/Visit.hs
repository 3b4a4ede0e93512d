{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Visits every window of a grid as a packed machine integer. Internal: used by the proof by
-- enumeration and the memory table.
module PraTactile.Window.Visit
  ( Visit,
    visit,
    visitRows,
    visitColumns,
    visitSpan,
    visitSurface,
    visitGrid,
    visitMask,
    visitKey,
    forWindows,
    Tile (..),
    forWindowsWithin,
    packedWindows,
    packedAt,
    visitedShape,
    visitPosition,
  )
where

import Control.Monad (forM_, zipWithM_)
import Control.Monad.ST (ST)
import Data.List (sort)
import Data.Vector.Primitive (MVector, Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Grid
import PraTactile.Window

-- | The windows of a grid, at the positions (r, c) with 0 <= r < 'visitRows' and 0 <= c <
-- 'visitColumns', with the packed content of each.
data Visit = Visit
  { visitRows :: !Int,
    visitColumns :: !Int,
    -- | q^cells; packed contents are below it
    visitSpan :: !Int,
    visitSurface :: !Surface,
    visitGrid :: !Grid,
    visitMask :: !Mask,
    -- | for each cell of the window, the most significant first, its offset in rows down, less than
    -- one turn
    visitDown :: !(Vector Int),
    -- | for each cell, its offset in columns to the right
    visitRight :: !(Vector Int),
    -- | on the twisted torus, for each cell, its offset in cells along the rows
    visitAlong :: !(Vector Int)
  }

-- | All windows of this shape on the surface. 'Nothing' if q^cells exceeds 2^62, so that a packed
-- window does not fit. On the sheet only windows that lie wholly on it are visited; there may be
-- none.
visit :: Packing -> Surface -> Grid -> Mask -> Maybe Visit
visit packing surface grid mask
  | spanned > 2 ^ (62 :: Int) = Nothing
  | otherwise =
    Just
      Visit
        { visitRows = fromIntegral visitedRows,
          visitColumns = fromIntegral visitedColumns,
          visitSpan = fromIntegral spanned,
          visitSurface = surface,
          visitGrid = grid,
          visitMask = mask,
          visitDown = eachCell (\o -> row o `mod` height),
          visitRight = eachCell (\o -> column o `mod` width),
          visitAlong = eachCell (\o -> (row o * width + column o) `mod` (height * width))
        }
  where
    spanned = fromIntegral (gridAlphabet grid) ^ maskSize mask :: Natural
    Shape height width = gridShape grid
    Shape visitedRows visitedColumns = visitedShape surface (gridShape grid) mask
    eachCell along = Primitive.fromListN (maskSize mask) (map (fromIntegral . along) offsets)
    offsets = case packing of
      MostSignificantFirst -> maskOffsets mask
      LeastSignificantFirst -> reverse (maskOffsets mask)

-- | Where cell j of the windows of row r is, from the window at column c on. Returns the index of
-- the first such cell, the number of cells from there that follow each other, and the index at
-- which they continue, at the other edge of the surface. This holds up to the row's last window.
cellsFrom :: Visit -> Int -> Int -> Int -> (Int, Int, Int)
cellsFrom windows j r c = case visitSurface windows of
  TwistedTorus ->
    let i = once cells (r * width + c + Primitive.unsafeIndex (visitAlong windows) j)
     in (i, cells - i, 0)
  _ ->
    let start = once height (r + Primitive.unsafeIndex (visitDown windows) j) * width
        across = once width (c + Primitive.unsafeIndex (visitRight windows) j)
     in (start + across, width - across, start)
  where
    height = gridHeight (visitGrid windows)
    width = gridWidth (visitGrid windows)
    cells = height * width
    once side i = if i >= side then i - side else i
{-# INLINE cellsFrom #-}

-- | The packed content of the window at a row and a column, which must be among the visited ones.
visitKey :: Visit -> Int -> Int -> Int
visitKey windows r c = go 0 0
  where
    q = gridAlphabet (visitGrid windows)
    codes = gridCells (visitGrid windows)
    go !j !acc
      | j == Primitive.length (visitDown windows) = acc
      | otherwise =
        let (i, _, _) = cellsFrom windows j r c
         in go (j + 1) (acc * q + fromIntegral (codes Primitive.! i))

-- | Runs an action for each window, row by row, with its row, column and packed content.
forWindows :: Visit -> (Int -> Int -> Int -> ST s ()) -> ST s ()
forWindows windows = forWindowsWithin windows (Tile 0 (visitRows windows) 0 (visitColumns windows))
{-# INLINE forWindows #-}

-- | The windows in a range of rows and columns; the ends are exclusive.
data Tile = Tile
  { tileTop :: !Int,
    tileBottom :: !Int,
    tileLeft :: !Int,
    tileRight :: !Int
  }

-- | 'forWindows' for the windows of a tile. Windows are packed in strips of a row, one cell of all
-- of them after the other, so that no window has to check for edges.
forWindowsWithin :: Visit -> Tile -> (Int -> Int -> Int -> ST s ()) -> ST s ()
forWindowsWithin windows (Tile r0 r1 c0 c1) act = do
  keys <- Mutable.new (max 1 strip)
  forM_ [r0 .. r1 - 1] $ \r -> forM_ [c0, c0 + strip .. c1 - 1] $ \c -> do
    let size = min strip (c1 - c)
    packStrip windows r c size keys
    let go !t
          | t >= size = pure ()
          | otherwise = Mutable.unsafeRead keys t >>= act r (c + t) >> go (t + 1)
    go 0
  where
    strip = max 1 (min 4096 (c1 - c0))
{-# INLINE forWindowsWithin #-}

-- | @packStrip windows r c size keys@ writes the packed contents of the windows of row r from
-- column c on, which must be among the visited ones. Four cells of each window are taken at a time
-- while there are four, and then the others one by one.
packStrip :: Visit -> Int -> Int -> Int -> MVector s Int -> ST s ()
packStrip windows r c size keys = Mutable.set (Mutable.unsafeTake size keys) 0 >> go 0
  where
    go j
      | count - j >= 4 = between size (map edge [j .. j + 3]) (appendFour j) >> go (j + 4)
      | count - j >= 1 = between size [edge j] (appendOne j) >> go (j + 1)
      | otherwise = pure ()
    count = Primitive.length (visitDown windows)
    -- The first window of the strip whose cell lies beyond the surface's edge.
    edge j = let (_, following, _) = cellsFrom windows j r c in following
    -- That cell of window t has the index from + t, for all windows t on the same side of the edge
    -- as this one.
    from j t =
      let (first, following, onwards) = cellsFrom windows j r c
       in if t < following then first else onwards - following
    appendOne j t0 t1 = loop t0
      where
        !a = from j t0
        loop !t
          | t >= t1 = pure ()
          | otherwise = do
            key <- Mutable.unsafeRead keys t
            Mutable.unsafeWrite keys t (key * q + code (a + t))
            loop (t + 1)
    appendFour j t0 t1 = loop t0
      where
        !a0 = from j t0
        !a1 = from (j + 1) t0
        !a2 = from (j + 2) t0
        !a3 = from (j + 3) t0
        loop !t
          | t >= t1 = pure ()
          | otherwise = do
            key <- Mutable.unsafeRead keys t
            let upper = code (a0 + t) * q + code (a1 + t)
                lower = code (a2 + t) * q + code (a3 + t)
            Mutable.unsafeWrite keys t (key * fourth + upper * square + lower)
            loop (t + 1)
    code i = fromIntegral (Primitive.unsafeIndex codes i) :: Int
    !codes = gridCells (visitGrid windows)
    !q = gridAlphabet (visitGrid windows)
    !square = q * q
    !fourth = square * square

-- | Splits the range 0 to size at these numbers, and acts on each part with its begin and its
-- exclusive end.
between :: Int -> [Int] -> (Int -> Int -> ST s ()) -> ST s ()
between size edges act = case filter (< size) edges of
  [] -> act 0 size
  inside ->
    let bounds = [0] ++ sort (filter (> 0) inside) ++ [size]
     in zipWithM_ act bounds (drop 1 bounds)
{-# NOINLINE between #-}

-- | All windows, row by row, with packed contents that may exceed a machine integer.
packedWindows :: Packing -> Surface -> Grid -> Mask -> [(Position, Natural)]
packedWindows packing surface grid mask =
  [ (p, content)
    | p <- shapeCells (visitedShape surface (gridShape grid) mask),
      Just content <- [packedAt packing surface grid mask p]
  ]

-- | The packed content of one window; 'Nothing' if it extends beyond the sheet.
packedAt :: Packing -> Surface -> Grid -> Mask -> Position -> Maybe Natural
packedAt packing surface grid mask position =
  pack packing (gridAlphabet grid) <$> traverse cell (maskOffsets mask)
  where
    cell offset = displaced surface (gridShape grid) position offset >>= codeAt grid

-- | The shape of the region of window positions: all of a torus; on the sheet, the positions from
-- which the mask does not extend beyond it.
visitedShape :: Surface -> Shape -> Mask -> Shape
visitedShape surface shape = admissible surface shape . maskExtent

-- | The position of visited coordinates.
visitPosition :: Int -> Int -> Position
visitPosition r c = Position (fromIntegral r) (fromIntegral c)
