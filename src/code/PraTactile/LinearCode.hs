{-# OPTIONS_HADDOCK hide #-}

-- | Linear codes over GF(q). This module and those below it do not depend on arrays.
module PraTactile.LinearCode
  ( LinearCode,
    spannedBy,
    dimension,
    codeLength,
    codeBasis,
    dual,
  )
where

import Data.List (foldl')
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.LinearCode.Elimination

-- | The space spanned by some vectors of one length, by that length and a basis.
data LinearCode (k :: Field) = LinearCode !Int !(Basis k)

type role LinearCode nominal

-- | The code of this length that the vectors span. Each vector must have that length.
spannedBy :: KnownField k => Int -> [Row k] -> LinearCode k
spannedBy size =
  LinearCode size . foldl' (\basis x -> fromMaybe basis (extend (const True) basis x)) emptyBasis

-- | The dimension: the number of independent codewords.
dimension :: LinearCode k -> Int
dimension (LinearCode _ basis) = basisSize basis

-- | The number of elements of a codeword.
codeLength :: LinearCode k -> Int
codeLength (LinearCode size _) = size

-- | Independent codewords that span the code.
codeBasis :: KnownField k => LinearCode k -> [Row k]
codeBasis (LinearCode _ basis) = map snd (basisRows basis)

-- | The vectors that are orthogonal to every codeword. Take the basis in reduced echelon form
-- ('basisRows'): at the pivots it is the unit matrix, and elsewhere a matrix P. The dual basis is
-- then the unit matrix elsewhere and -P transposed at the pivots.
dual :: forall k. KnownField k => LinearCode k -> LinearCode k
dual (LinearCode size basis) = spannedBy size (map orthogonal free)
  where
    pivoted = Map.fromList (basisRows basis) :: Map Int (Row k)
    free = filter (`Map.notMember` pivoted) [0 .. size - 1]
    orthogonal j = rowFromList (map (entry j) [0 .. size - 1])
    entry j i = case Map.lookup i pivoted of
      Just x -> negate (Primitive.unsafeIndex x j)
      Nothing -> if i == j then one else zero
