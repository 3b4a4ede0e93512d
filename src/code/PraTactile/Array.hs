-- | Pseudorandom arrays: one period of an m-sequence folded into a rectangle (section II of the
-- paper). Along the diagonal, a[i mod n1][i mod n2] = s(i), which fills the rectangle exactly when
-- gcd(n1, n2) = 1, by the Chinese remainder theorem; or row by row, a[r][c] = s(n2 r + c).
--
-- Costs are numbers of operations in GF(q); n is the degree of the polynomial, and N = q^n - 1 the
-- number of cells.
module PraTactile.Array
  ( -- * Shapes and positions
    Shape (..),
    area,
    Position (..),
    shapeCells,
    naturalsBelow,
    Surface (..),

    -- * Arrays
    PseudorandomArray,
    fold,
    Folding (..),
    naturalSurface,
    arrayPrimitive,
    arrayState,
    arrayFolding,
    arrayShape,
    FoldError (..),

    -- * With what lies beyond the edges
    ArrayOn (..),
    naturally,

    -- * Cells
    cellAt,
    sequenceIndex,
    positionOfIndex,
    toGrid,
    toRows,
  )
where

import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array.Fill
import PraTactile.Array.Remainder
import PraTactile.Field
import PraTactile.Grid
import PraTactile.Polynomial
import PraTactile.Sequence

-- | How the sequence is folded into the rectangle.
data Folding
  = -- | a[i mod n1][i mod n2] = s(i), on the torus.
    Diagonal
  | -- | a[r][c] = s(n2 r + c), on the twisted torus.
    RowMajor
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The surface on which neighbouring cells hold the same terms further on, wherever the cell is.
naturalSurface :: Folding -> Surface
naturalSurface Diagonal = Torus
naturalSurface RowMajor = TwistedTorus

-- | Why a sequence does not fold into a rectangle, or not into memory.
data FoldError
  = -- | n1 and n2 have this common divisor g: the fold reaches only every g-th cell.
    NotCoprime Natural Natural Natural
  | -- | The shape does not have as many cells as the sequence has terms, this many.
    WrongArea Shape Natural
  | -- | There are this many cells; the second number is the most that is held in memory.
    TooManyCells Natural Natural
  deriving stock (Eq, Show)

-- | A period of the m-sequence of a primitive polynomial, folded so that it fills the shape. Only
-- 'fold' makes one. Its size has no limit: cells are computed lazily.
data PseudorandomArray (k :: Field) = PseudorandomArray
  { -- | The characteristic polynomial of the sequence.
    arrayPrimitive :: !(Primitive k),
    -- | The first n terms.
    arrayState :: !(State k),
    -- | How the sequence is folded.
    arrayFolding :: !Folding,
    -- | The shape, n1 x n2.
    arrayShape :: !Shape,
    arrayWeights :: !Weights,
    -- | The terms of the sequence; what they need is computed once, when first used.
    arrayTerm :: Natural -> GF k
  }

type role PseudorandomArray nominal

-- | An array with the surface that says what lies beyond its edges.
data ArrayOn (k :: Field) = ArrayOn
  { arraySurface :: !Surface,
    arrayItself :: !(PseudorandomArray k)
  }

type role ArrayOn nominal

-- | An array on its 'naturalSurface'.
naturally :: PseudorandomArray k -> ArrayOn k
naturally array = ArrayOn (naturalSurface (arrayFolding array)) array

-- | Folds a sequence into n1 x n2 cells. Refuses a shape without exactly q^n - 1 cells
-- ('WrongArea'), and a diagonal fold whose sides have a common divisor ('NotCoprime'). O(log N);
-- what cells are read from is computed when the first cell is read.
fold ::
  forall k.
  KnownField k =>
  Folding ->
  Shape ->
  Primitive k ->
  State k ->
  Either FoldError (PseudorandomArray k)
fold folding shape@(Shape n1 n2) h state
  | area shape /= terms = Left (WrongArea shape terms)
  | otherwise = case folding of
    RowMajor -> Right (array (n2, 1))
    Diagonal
      | g == 1 -> Right (array (diagonalWeights n1 n2))
      | otherwise -> Left (NotCoprime n1 n2 g)
  where
    terms = period h
    g = gcd n1 n2
    array weights = PseudorandomArray h state folding shape weights term
    term
      | terms <= 2 ^ (20 :: Int) =
        let short = sequenceVector h state (fromIntegral terms)
         in fromMaybe zero . (short Primitive.!?) . fromIntegral
      | otherwise = termAt h state

-- | The index i, below the period, of the term s(i) that a cell holds; positions beyond the edges
-- continue on the 'naturalSurface'.
sequenceIndex :: KnownField k => PseudorandomArray k -> Position -> Natural
sequenceIndex array (Position r c) =
  weightedIndex (period (arrayPrimitive array)) (arrayWeights array) r c

-- | The cell that holds the term s(i), for any i: the inverse of 'sequenceIndex'.
positionOfIndex :: PseudorandomArray k -> Natural -> Position
positionOfIndex array i = case arrayFolding array of
  Diagonal -> Position (i `mod` n1) (i `mod` n2)
  RowMajor -> Position ((i `div` n2) `mod` n1) (i `mod` n2)
  where
    Shape n1 n2 = arrayShape array

-- | The element at a position; positions beyond the edges continue on the 'naturalSurface'. Arrays
-- of up to 2^20 cells are looked up in one period of the sequence: O(1), after O(n N) and N bytes
-- once for the array. In larger arrays each cell is computed by a jump: O(n^2 log N), after the
-- table of 'termAt'.
cellAt :: KnownField k => PseudorandomArray k -> Position -> GF k
cellAt array = arrayTerm array . sequenceIndex array

-- | The whole array as codes. Refuses more than 'largestGrid' cells before allocating memory. O(n
-- N), and N bytes.
toGrid :: forall k. KnownField k => PseudorandomArray k -> Either FoldError Grid
toGrid array
  | area shape > largestGrid = Left tooMany
  | otherwise = either (const (Left tooMany)) Right (gridFromVector q shape (codes cells))
  where
    shape = arrayShape array
    tooMany = TooManyCells (area shape) largestGrid
    q = fieldOrder array
    cells = case arrayFolding array of
      RowMajor ->
        sequenceVector (arrayPrimitive array) (arrayState array) (fromIntegral (area shape))
      Diagonal -> filled (arrayPrimitive array) (arrayTerm array) (arrayWeights array) shape

-- | The whole array, row by row. Refuses as 'toGrid' does. O(n N), and some 40 bytes a cell.
toRows :: KnownField k => PseudorandomArray k -> Either FoldError [[GF k]]
toRows array = map (map (either (const zero) id . fromCode)) . gridRows <$> toGrid array
