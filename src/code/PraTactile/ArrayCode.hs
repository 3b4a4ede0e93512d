-- | Pseudorandom array codes: several arrays of one shape that share one window property, so that a
-- window determines both the array and the position in it. They exist for shapes that no single
-- array has. Let n1 n2 g = q^n - 1 with n1 and n2 coprime. Then the sequence splits into g
-- sequences s(j), s(j + g), s(j + 2 g), ..., and each is folded along the diagonal of its own
-- torus. For g = 1 this is the single array. For example, over GF(4) with degree 6, no linear array
-- of 15 x 273 cells exists on the torus, because 3 divides both sides; but three arrays of 15 x 91
-- cells share the 2 x 3 windows.
--
-- Costs are numbers of operations in GF(q); n is the degree of the polynomial, N = q^n - 1 the
-- number of terms, and m that of cells of a mask.
module PraTactile.ArrayCode
  ( ArrayCode,
    foldCode,
    codePrimitive,
    codeState,
    codeShape,
    codeArrays,
    ArrayCodeError (..),

    -- * Cells
    CodePosition (..),
    codeCellAt,
    codeIndex,
    codePositionOf,
    codeGrid,

    -- * The window property by algebra
    codeRank,
  )
where

import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Array.Fill
import PraTactile.Array.Remainder
import PraTactile.Field
import PraTactile.Grid
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Window
import PraTactile.Window.Rank (rankOf)

-- | Why a sequence does not fold into arrays of a shape.
data ArrayCodeError
  = -- | The number of cells does not divide the number of terms, which is the second.
    AreaNotDivisor Shape Natural
  | -- | n1 and n2 have this common divisor.
    SidesNotCoprime Natural Natural Natural
  | -- | An array has this many cells; the second number is the most that is held in memory.
    CodeTooLarge Natural Natural
  deriving stock (Eq, Show)

-- | A period of an m-sequence, folded into g arrays of n1 x n2 cells. Only 'foldCode' makes one.
data ArrayCode (k :: Field) = ArrayCode
  { -- | The characteristic polynomial of the sequence.
    codePrimitive :: !(Primitive k),
    -- | The first n terms.
    codeState :: !(State k),
    -- | The shape of each array, n1 x n2.
    codeShape :: !Shape,
    -- | The number g of arrays.
    codeArrays :: !Natural,
    codeTerm :: Natural -> GF k
  }

type role ArrayCode nominal

-- | A cell of one of the arrays, which are numbered from 0.
data CodePosition = CodePosition
  { codePositionArray :: !Natural,
    codePositionInArray :: !Position
  }
  deriving stock (Eq, Ord, Show)

-- | Folds a sequence into as many arrays of the shape as it fills. Refuses a shape whose number of
-- cells does not divide q^n - 1, and a shape whose sides have a common divisor.
foldCode :: KnownField k => Shape -> Primitive k -> State k -> Either ArrayCodeError (ArrayCode k)
foldCode shape@(Shape n1 n2) h state
  | area shape == 0 || terms `mod` area shape /= 0 = Left (AreaNotDivisor shape terms)
  | gcd n1 n2 /= 1 = Left (SidesNotCoprime n1 n2 (gcd n1 n2))
  | otherwise = Right (ArrayCode h state shape (terms `div` area shape) (termAt h state))
  where
    terms = period h

-- | The index i, below the period, of the term s(i) in a cell. In array j, i = j modulo g, and (i -
-- j) / g is the row modulo n1 and the column modulo n2. Arrays are numbered modulo g; positions
-- beyond the edges continue on the torus. O(log N).
codeIndex :: ArrayCode k -> CodePosition -> Natural
codeIndex code (CodePosition j (Position r c)) =
  j `mod` codeArrays code + codeArrays code * weightedIndex (n1 * n2) (diagonalWeights n1 n2) r c
  where
    Shape n1 n2 = codeShape code

-- | The cell that holds the term s(i), for any i below the period: the inverse of 'codeIndex'.
codePositionOf :: ArrayCode k -> Natural -> CodePosition
codePositionOf code i = CodePosition j (Position (along `mod` n1) (along `mod` n2))
  where
    (along, j) = i `divMod` codeArrays code
    Shape n1 n2 = codeShape code

-- | The element in a cell, computed without building an array. O(n^2 log N), after the table of
-- 'termAt', which is made once for the code.
codeCellAt :: ArrayCode k -> CodePosition -> GF k
codeCellAt code = codeTerm code . codeIndex code

-- | One of the arrays, as codes. Refuses more than 'largestGrid' cells before allocating memory.
-- O(n c) for c cells, and c bytes.
codeGrid :: KnownField k => ArrayCode k -> Natural -> Either ArrayCodeError Grid
codeGrid code j
  | area shape > largestGrid = Left tooLarge
  | otherwise =
    either (const (Left tooLarge)) Right (gridFromVector (fieldOrder code) shape (codes cells))
  where
    shape@(Shape n1 n2) = codeShape code
    tooLarge = CodeTooLarge (area shape) largestGrid
    h = codePrimitive code
    g = codeArrays code
    (u, v) = diagonalWeights n1 n2
    start = j `mod` g
    cells = filled h (\i -> codeTerm code ((i + start) `mod` period h)) (g * u, g * v) shape

-- | The rank over GF(q) of the alpha^e, where e runs over the indices of the mask's cells from the
-- cell of s(0). The windows of all arrays are distinct exactly if it is n. The reason is that
-- moving a window by one term of the sequence, perhaps into another array, multiplies by alpha, as
-- in "PraTactile.Window.Rank". The vectors s(e), ..., s(e+n-1) represent the alpha^e, since they
-- are a one-to-one linear function of them. O(m n^3 log N).
codeRank :: KnownField k => ArrayCode k -> Mask -> Natural
codeRank code mask = rankOf (map (vector . codeIndex code . CodePosition 0) (maskOffsets mask))
  where
    vector e = map (codeTerm code . (`mod` period h)) (take (primitiveDegree h) [e ..])
    h = codePrimitive code
