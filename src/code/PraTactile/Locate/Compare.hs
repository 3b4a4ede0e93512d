-- |
-- Comparing a patch with a grid at every position at once: the inner loop of decoding. Each cell of
-- the patch says what each symbol in its place would be worth, and the worths are added up:
-- 0 and 1 make distances, logarithms of probabilities make likelihoods. Internal.
module PraTactile.Locate.Compare
  ( Worth,
    totals,
    comparedShape,
    extentOf,
    placeOf,
    indexOf,
  )
where

import Control.Monad.ST (ST)
import Data.Vector.Primitive (Prim, Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Grid

-- | What each symbol is worth, by its code: as many entries as the grid's alphabet has symbols.
type Worth a = Vector a

-- | The rows and columns of an array of some shape at which a patch of this extent is compared: all
-- of a torus; on the sheet those from which the extent does not stick out.
comparedShape :: Surface -> Shape -> Shape -> Shape
comparedShape surface shape extent = case surface of
  Sheet -> Shape (within (rows shape) (rows extent)) (within (columns shape) (columns extent))
  _ -> shape
  where
    within :: Natural -> Natural -> Natural
    within side size = if size > side then 0 else side + 1 - max 1 size

-- | The extent of a patch of which the cells at these offsets are observed: from its upper left,
-- which must lie on the sheet as well, to the last row and column that have one of them.
extentOf :: [Position] -> Shape
extentOf offsets = Shape (1 + maximum (0 : map row offsets)) (1 + maximum (0 : map column offsets))

-- | The position at an index of the totals, given the compared shape.
placeOf :: Shape -> Int -> Position
placeOf compared i = uncurry Position (fromIntegral i `divMod` max 1 (columns compared))

-- | The index of a position in the totals.
indexOf :: Shape -> Position -> Int
indexOf compared (Position r c) = fromIntegral (r * columns compared + c)

-- | The sum of the worths of the cells, by their offsets, at each position of the compared shape of
-- this extent, row by row. On the sheet, all offsets must lie within the extent.
totals :: (Prim a, Num a) => Surface -> Grid -> Shape -> [(Position, Worth a)] -> Vector a
totals surface grid extent cells = Primitive.create $ do
  sums <- Mutable.replicate (high * wide) 0
  mapM_ (addCell surface grid high wide sums) cells
  pure sums
  where
    Shape h w = comparedShape surface (gridShape grid) extent
    high = fromIntegral h
    wide = fromIntegral w
{-# INLINEABLE totals #-}
{-# SPECIALIZE totals :: Surface -> Grid -> Shape -> [(Position, Worth Int)] -> Vector Int #-}
{-# SPECIALIZE totals :: Surface -> Grid -> Shape -> [(Position, Worth Double)] -> Vector Double #-}

-- | Add what one cell is worth at each position.
addCell ::
  (Prim a, Num a) =>
  Surface ->
  Grid ->
  Int ->
  Int ->
  Mutable.MVector s a ->
  (Position, Worth a) ->
  ST s ()
addCell surface grid high wide sums (Position i j, worth) = go 0
  where
    height = gridHeight grid
    width = gridWidth grid
    codes = gridCells grid
    (down, right) = case surface of
      TwistedTorus ->
        let (carry, c) = j `divMod` fromIntegral width
         in (fromIntegral ((i + carry) `mod` fromIntegral height), fromIntegral c)
      _ -> (fromIntegral (i `mod` fromIntegral height), fromIntegral (j `mod` fromIntegral width))
    -- Columns from which the cell lies past the last column are on this row of the grid's, further.
    carried = if surface == TwistedTorus then 1 else 0
    before = min wide (width - right)
    once r = if r >= height then r - height else r
    go r
      | r >= high = pure ()
      | otherwise = do
        along (r * wide) (once (r + down) * width + right) before
        along (r * wide + before) (once (once (r + down) + carried) * width) (wide - before)
        go (r + 1)
    -- Both indices stay within a row: of the totals, and of the grid, whose codes are below q, the
    -- size of the worths.
    along to from size
      | size <= 0 = pure ()
      | otherwise = do
        let symbol = fromIntegral (Primitive.unsafeIndex codes from)
        total <- Mutable.unsafeRead sums to
        Mutable.unsafeWrite sums to (total + Primitive.unsafeIndex worth symbol)
        along (to + 1) (from + 1) (size - 1)
{-# INLINE addCell #-}
