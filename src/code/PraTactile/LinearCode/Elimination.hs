{-# OPTIONS_HADDOCK hide #-}

-- | Elimination over GF(q): which rows of a matrix are independent, and the inverse of a square
-- one.
module PraTactile.LinearCode.Elimination
  ( -- * Rows
    Row,
    rowFromList,
    rowToList,

    -- * Reduction
    Basis,
    emptyBasis,
    basisSize,
    basisRows,
    extend,
    reduced,
    independentRows,

    -- * Inverse
    inverseMatrix,
  )
where

import Data.List (foldl')
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.Field.Vector

-- | A vector over GF(q).
type Row k = Vector (GF k)

rowFromList :: [GF k] -> Row k
rowFromList = Primitive.fromList

rowToList :: Row k -> [GF k]
rowToList = Primitive.toList

-- | Independent rows in echelon form, the one that was included last first: each has a 1 where all
-- that follow it in the order of inclusion have 0, its pivot.
newtype Basis (k :: Field) = Basis [(Int, Row k)]

type role Basis nominal

-- | No rows.
emptyBasis :: Basis k
emptyBasis = Basis []

-- | The number of rows: the dimension of the space that they span.
basisSize :: Basis k -> Int
basisSize (Basis pivoted) = length pivoted

-- | The rows in reduced echelon form, where all others have 0 at a row's pivot, with their pivots,
-- the one that was included last first. O(r^2 n) for r rows of n elements.
basisRows :: KnownField k => Basis k -> [(Int, Row k)]
basisRows (Basis pivoted) = reverse (foldl' clear [] pivoted)
  where
    clear later (pivot, x) = (pivot, foldl' clearedAt x later) : later

-- | The row less its component along a row with a pivot. All have one length, so that the pivot is
-- an index of each.
clearedAt :: KnownField k => Row k -> (Int, Row k) -> Row k
clearedAt x (pivot, b) = addScaled (negate (Primitive.unsafeIndex x pivot)) b x

-- | The row less its components along the basis: zero at every pivot, and all zeros exactly when
-- the basis spans the row.
reduced :: KnownField k => Basis k -> Row k -> Row k
reduced (Basis pivoted) given = foldl' clearedAt given (reverse pivoted)

-- | Include a row, if the basis does not span it already. Its pivot is the first index that is
-- preferred, or else the first of all, where what is left of it is not zero.
extend :: KnownField k => (Int -> Bool) -> Basis k -> Row k -> Maybe (Basis k)
extend preferred basis@(Basis pivoted) given = case filter preferred support ++ support of
  [] -> Nothing
  pivot : _ ->
    Just (Basis ((pivot, scaleVector (inverted (Primitive.unsafeIndex rest pivot)) rest) : pivoted))
  where
    rest = reduced basis given
    support = [i | (i, a) <- zip [0 ..] (Primitive.toList rest), a /= zero]
    inverted = either (const zero) id . inverse

-- | The indices, ascending, of the rows that those before them do not span, at most this many.
independentRows :: KnownField k => Int -> [Row k] -> [Int]
independentRows most = go emptyBasis . zip [0 ..]
  where
    go basis ((i, x) : others)
      | basisSize basis < most =
        maybe (go basis others) (\larger -> i : go larger others) (extend (const True) basis x)
    go _ _ = []

-- | The inverse of a square matrix, given by rows; 'Nothing' exactly when there is none.
inverseMatrix :: KnownField k => [[GF k]] -> Maybe [[GF k]]
inverseMatrix matrix = do
  -- Beside each row the same row of the unit matrix: when the left half has become the unit matrix,
  -- up to the order of the rows, the right half is the inverse.
  basis <- foldl' include (Just emptyBasis) (zipWith beside [0 ..] matrix)
  traverse (\i -> drop n . rowToList <$> lookup i (basisRows basis)) [0 .. n - 1]
  where
    n = length matrix
    beside i x = rowFromList (take n x ++ [if j == i then one else zero | j <- [0 .. n - 1 :: Int]])
    include basis x = basis >>= \b -> extend (< n) b x
