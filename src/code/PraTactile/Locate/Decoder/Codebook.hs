{-# OPTIONS_HADDOCK hide #-}

-- | The codebook of an array: every position with what a patch there would hold. For arrays of up
-- to 2^20 cells decoding is the comparison of a patch with the whole codebook, which is exact. Each
-- observed cell gives every symbol in its place a score, and scores are added up: 0 and 1 make
-- distances, logarithms of probabilities make likelihoods.
module PraTactile.Locate.Decoder.Codebook
  ( -- * Codebooks
    Codebook,
    buildCodebook,
    codebookOn,
    codebookSurface,
    codebookArray,
    codebookMask,
    codebookGrid,

    -- * Comparing
    Scores,
    Comparison,
    compareWith,
    comparedTotals,
    comparedPosition,

    -- * The distance of a code
    observedDistance,
  )
where

import Control.Monad.ST (ST)
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Prim, Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid
import PraTactile.Locate.Definition (largestSearchedArray)
import PraTactile.Locate.Patch (LocateError (..))
import PraTactile.Window

-- | An array on a surface, with the window that its support and its refusals are named by.
data Codebook (k :: Field) = Codebook
  { -- | The array on its surface.
    codebookOn :: !(ArrayOn k),
    -- | The array's window.
    codebookMask :: !Mask,
    -- | All its cells.
    codebookGrid :: !Grid,
    -- | The scores that add up to a weight: 0 for zero, 1 for every other symbol.
    weightScores :: !(Scores Int)
  }

type role Codebook nominal

-- | The codebook of an array. Refuses arrays of more than 'largestSearchedArray' cells.
buildCodebook ::
  forall k.
  KnownField k =>
  ArrayOn k ->
  Mask ->
  Either LocateError (Codebook k)
buildCodebook on@(ArrayOn _ array) mask
  | cells > largestSearchedArray = Left (TooManyPlaces cells largestSearchedArray)
  | otherwise = do
    grid <- either (Left . TableArray) Right (toGrid array)
    pure (Codebook on mask grid (Primitive.fromList (0 : replicate (q - 1) 1)))
  where
    cells = area (arrayShape array)
    q = fieldOrder (Proxy :: Proxy k)

-- | What lies beyond the edges.
codebookSurface :: Codebook k -> Surface
codebookSurface = arraySurface . codebookOn

-- | The array.
codebookArray :: Codebook k -> PseudorandomArray k
codebookArray = arrayItself . codebookOn

-- | The score of each symbol in a cell, by its code: q entries.
type Scores a = Vector a

-- | The totals at every position at which the compared cells lie on the surface, in order.
data Comparison a = Comparison !Shape !(Vector a)

-- | The totals, one a position.
comparedTotals :: Comparison a -> Vector a
comparedTotals (Comparison _ sums) = sums

-- | The position that an index of the totals belongs to.
comparedPosition :: Comparison a -> Int -> Position
comparedPosition (Comparison shape _) = positionAt shape

-- | The total score at every position, of cells given by their offsets, each with its scores.
compareWith :: (Prim a, Num a) => Codebook k -> [(Position, Scores a)] -> Comparison a
compareWith codebook cells =
  Comparison (admissible surface (gridShape grid) extent) (totals surface grid extent cells)
  where
    surface = codebookSurface codebook
    grid = codebookGrid codebook
    extent = extentOf (map fst cells)
{-# INLINE compareWith #-}

-- | The minimum distance of the contents of the cells with these offsets, as they are on the
-- array's 'naturalSurface', where they are a linear code, so that it is the least number of them
-- that are not zero; 0 where two positions have the same content. It holds on the sheet as well;
-- for another surface, where the contents are not linear, no distance is promised, and this is 0.
observedDistance :: Codebook k -> [Position] -> Natural
observedDistance codebook offsets
  | codebookSurface codebook `notElem` [Sheet, natural] || null offsets = 0
  | otherwise = fromIntegral (Primitive.minimum weights)
  where
    natural = naturalSurface (arrayFolding (codebookArray codebook))
    -- On a torus there is a total for every cell of the array, and so at least one.
    weights = totals natural (codebookGrid codebook) (Shape 1 1) scored
    scored = [(offset, weightScores codebook) | offset <- offsets]

-- | The total score of the cells, by their offsets, at each position at which a patch of this
-- extent lies on the surface, row by row. On the sheet, all offsets must lie within the extent.
totals :: (Prim a, Num a) => Surface -> Grid -> Shape -> [(Position, Scores a)] -> Vector a
totals surface grid extent cells = Primitive.create $ do
  sums <- Mutable.replicate (high * wide) 0
  mapM_ (addCell surface grid high wide sums) cells
  pure sums
  where
    Shape h w = admissible surface (gridShape grid) extent
    high = fromIntegral h
    wide = fromIntegral w
{-# INLINEABLE totals #-}
{-# SPECIALIZE totals :: Surface -> Grid -> Shape -> [(Position, Scores Int)] -> Vector Int #-}
{-# SPECIALIZE totals ::
  Surface -> Grid -> Shape -> [(Position, Scores Double)] -> Vector Double
  #-}

-- | Add the score of one cell at each position.
addCell ::
  (Prim a, Num a) =>
  Surface ->
  Grid ->
  Int ->
  Int ->
  Mutable.MVector s a ->
  (Position, Scores a) ->
  ST s ()
addCell surface grid high wide sums (Position i j, scores) = go 0
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
    -- number of scores.
    along to from size
      | size <= 0 = pure ()
      | otherwise = do
        let symbol = fromIntegral (Primitive.unsafeIndex codes from)
        total <- Mutable.unsafeRead sums to
        Mutable.unsafeWrite sums to (total + Primitive.unsafeIndex scores symbol)
        along (to + 1) (from + 1) (size - 1)
{-# INLINE addCell #-}
