{-# OPTIONS_HADDOCK hide #-}

-- | Codebooks: every position of an array with the content of a patch there. For arrays of up to
-- 2^20 cells a patch is compared with the whole codebook, which is exact. Each observed cell gives
-- a score to every symbol it may hold, and the scores are summed. Scores 0 and 1 give distances;
-- log-probabilities give log-likelihoods.
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

-- | An array on a surface, with its window.
data Codebook (k :: Field) = Codebook
  { -- | The array on its surface.
    codebookOn :: !(ArrayOn k),
    -- | The array's window, which names support and the reasons of refusals.
    codebookMask :: !Mask,
    -- | All its cells.
    codebookGrid :: !Grid,
    -- | The scores that sum to a weight: 0 for zero, 1 for every other symbol.
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

-- | The surface, which says what lies beyond the edges.
codebookSurface :: Codebook k -> Surface
codebookSurface = arraySurface . codebookOn

-- | The array.
codebookArray :: Codebook k -> PseudorandomArray k
codebookArray = arrayItself . codebookOn

-- | The score of each symbol in a cell, by its code: q entries.
type Scores a = Vector a

-- | The total scores of all positions for which the compared cells lie on the surface, row by row.
data Comparison a = Comparison !Shape !(Vector a)

-- | The total scores, one for each position.
comparedTotals :: Comparison a -> Vector a
comparedTotals (Comparison _ sums) = sums

-- | The position at an index of the totals.
comparedPosition :: Comparison a -> Int -> Position
comparedPosition (Comparison shape _) = positionAt shape

-- | The total score at every position. Cells are given by their offsets, each with its scores.
compareWith :: (Prim a, Num a) => Codebook k -> [(Position, Scores a)] -> Comparison a
compareWith codebook cells =
  Comparison (admissible surface (gridShape grid) extent) (totals surface grid extent cells)
  where
    surface = codebookSurface codebook
    grid = codebookGrid codebook
    extent = extentOf (map fst cells)
{-# INLINE compareWith #-}

-- | The minimum distance of the contents of the cells with these offsets. On the array's
-- 'naturalSurface' the contents are a linear code, so it is the least number of nonzero cells at
-- any position. It is 0 if two positions have the same content. It also holds on the sheet. On any
-- other surface contents are not linear and no distance is guaranteed, so it is 0.
observedDistance :: Codebook k -> [Position] -> Natural
observedDistance codebook offsets
  | codebookSurface codebook `notElem` [Sheet, natural] || null offsets = 0
  | otherwise = fromIntegral (Primitive.minimum weights)
  where
    natural = naturalSurface (arrayFolding (codebookArray codebook))
    -- On a torus there is a total for every cell of the array, so at least one.
    weights = totals natural (codebookGrid codebook) (Shape 1 1) scored
    scored = [(offset, weightScores codebook) | offset <- offsets]

-- | The total score of the cells at each position for which a patch of this extent lies on the
-- surface, row by row. On the sheet, all offsets must lie within the extent.
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

-- | Adds the scores of one cell at each position.
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
    -- From this column of the patch on, the cell is beyond the grid's last column: it is in the
    -- first columns, and on the twisted torus a row lower.
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
