{-# OPTIONS_HADDOCK hide #-}

-- | How neighbouring columns and rows of an array check each other: the number from which on parity
-- checks hold across them, and whether the array is its own mirror image. Both depend only on the
-- fold, not on the polynomial.
module PraTactile.Advise.Neighbours
  ( columnsToCheck,
    rowsToCheck,
    Mirror (..),
    ownMirrors,
  )
where

import Numeric.Natural (Natural)
import PraTactile.Advise.Layout
import PraTactile.Array

{- Note [Neighbouring columns]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~
   Let the cell (r, c) hold s(r u + c v), and let a = alpha^u and b = alpha^v. A whole column spans
   the field GF(q^d) of all powers of a, times a power of b; d is the degree of a over GF(q). Since
   a and b generate GF(q^n), b has degree n/d over GF(q^d). So n/d adjacent columns are independent,
   and one more depends on them. If n1 = q^k1 - 1, then d = k1 and n/d = k2. Along the diagonal,
   rows behave in the same way. Row by row, each row is n2 consecutive terms of the sequence, with
   rank n2, or n if that is less. -}

-- | The number of adjacent whole columns from which on parity checks hold across columns; 'Nothing'
-- if the array does not have that many. Arguments: q, n, the layout, and the shape of each array,
-- which the layout must fill. See Note [Neighbouring columns].
--
-- >>> columnsToCheck 4 4 (Single Diagonal) (Shape 15 17)
-- Just 3
columnsToCheck :: Natural -> Natural -> Layout -> Shape -> Maybe Natural
columnsToCheck q n layout shape =
  adjacent n (degreeOfPower q n (fst (layoutWeights layout shape))) (columns shape)

-- | The number of adjacent whole rows from which on parity checks hold across rows; 'Nothing' if
-- the array does not have that many. Arguments: q, n, the layout, and the shape of each array, as
-- for 'columnsToCheck'.
--
-- >>> rowsToCheck 4 4 (Single Diagonal) (Shape 15 17)
-- Just 2
rowsToCheck :: Natural -> Natural -> Layout -> Shape -> Maybe Natural
rowsToCheck q n layout shape = adjacent n rank (rows shape)
  where
    rank = case layout of
      Single RowMajor -> min n (columns shape)
      _ -> degreeOfPower q n (snd (layoutWeights layout shape))

-- | The degree over GF(q) of this power of alpha.
degreeOfPower :: Natural -> Natural -> Natural -> Natural
degreeOfPower q n e = degreeOfOrder q n (terms `div` gcd terms e)
  where
    terms = q ^ n - 1

-- | The least number of lines whose ranks add up to more than n; 'Nothing' if there are not that
-- many. Arguments: n, the rank of each line, and the number of lines.
adjacent :: Natural -> Natural -> Natural -> Maybe Natural
adjacent n rank most = if needed <= most then Just needed else Nothing
  where
    needed = n `div` rank + 1

-- | A mirror image.
data Mirror
  = -- | left and right are exchanged
    ColumnsMirrored
  | -- | up and down are exchanged
    RowsMirrored
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The mirror images of the arrays that equal the arrays themselves, shifted, on the layout's
-- surface. Arguments: q, n, the layout, and the shape of each array. These mirror images multiply
-- each index of a term by a power of q; no other multiple maps an m-sequence to a shift of itself.
-- O(n).
--
-- >>> ownMirrors 4 4 (Single Diagonal) (Shape 15 17)
-- [ColumnsMirrored]
ownMirrors :: Natural -> Natural -> Layout -> Shape -> [Mirror]
ownMirrors q n layout shape =
  [mirror | mirror <- [minBound ..], any (takes mirror) (take (fromIntegral n) (iterate (* q) 1))]
  where
    terms = q ^ n - 1
    (u, v) = layoutWeights layout shape
    takes mirror m = case mirror of
      ColumnsMirrored -> same (m * u) u && same (m * v + v) 0
      RowsMirrored -> same (m * u + u) 0 && same (m * v) v
    same x y = x `mod` terms == y `mod` terms
