{-# OPTIONS_HADDOCK hide #-}

-- | Elimination over GF(q): independent rows of a matrix, and the inverse of a square matrix.
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

-- | Independent rows in echelon form, the last included row first. Each row has a pivot: an index
-- where it has 1 and all rows included later have 0.
newtype Basis (k :: Field) = Basis [(Int, Row k)]

type role Basis nominal

-- | The basis without rows.
emptyBasis :: Basis k
emptyBasis = Basis []

-- | The number of rows: the dimension of the space that they span.
basisSize :: Basis k -> Int
basisSize (Basis pivoted) = length pivoted

-- | The rows with their pivots in reduced echelon form, the last included row first: all other rows
-- have 0 at a row's pivot. O(r^2 n) for r rows of n elements.
basisRows :: KnownField k => Basis k -> [(Int, Row k)]
basisRows (Basis pivoted) = reverse (foldl' clear [] pivoted)
  where
    clear later (pivot, x) = (pivot, foldl' clearedAt x later) : later

-- | A row minus its component along a row with a pivot. All rows have one length, so the pivot is
-- an index of each.
clearedAt :: KnownField k => Row k -> (Int, Row k) -> Row k
clearedAt x (pivot, b) = addScaled (negate (Primitive.unsafeIndex x pivot)) b x

-- | A row minus its components along the basis. It is zero at every pivot, and zero everywhere
-- exactly if the basis spans the row.
reduced :: KnownField k => Basis k -> Row k -> Row k
reduced (Basis pivoted) given = foldl' clearedAt given (reverse pivoted)

-- | Includes a row; 'Nothing' if the basis spans it already. The pivot is the first preferred index
-- at which the reduced row is nonzero, or else the first such index.
extend :: KnownField k => (Int -> Bool) -> Basis k -> Row k -> Maybe (Basis k)
extend preferred basis@(Basis pivoted) given = case filter preferred support ++ support of
  [] -> Nothing
  pivot : _ ->
    Just (Basis ((pivot, scaleVector (inverted (Primitive.unsafeIndex rest pivot)) rest) : pivoted))
  where
    rest = reduced basis given
    support = [i | (i, a) <- zip [0 ..] (Primitive.toList rest), a /= zero]
    inverted = either (const zero) id . inverse

-- | The indices, ascending, of the rows that the rows before them do not span; at most this many.
independentRows :: KnownField k => Int -> [Row k] -> [Int]
independentRows most = go emptyBasis . zip [0 ..]
  where
    go basis ((i, x) : others)
      | basisSize basis < most =
        maybe (go basis others) (\larger -> i : go larger others) (extend (const True) basis x)
    go _ _ = []

-- | The inverse of a square matrix, given by rows; 'Nothing' exactly if there is none.
inverseMatrix :: KnownField k => [[GF k]] -> Maybe [[GF k]]
inverseMatrix matrix = do
  -- Each row is extended by the same row of the unit matrix. When the left half has become the unit
  -- matrix, up to the order of rows, the right half is the inverse.
  basis <- foldl' include (Just emptyBasis) (zipWith beside [0 ..] matrix)
  traverse (\i -> drop n . rowToList <$> lookup i (basisRows basis)) [0 .. n - 1]
  where
    n = length matrix
    beside i x = rowFromList (take n x ++ [if j == i then one else zero | j <- [0 .. n - 1 :: Int]])
    include basis x = basis >>= \b -> extend (< n) b x
