{-# OPTIONS_HADDOCK hide #-}

-- | The window property by algebra, for arrays of any size. Let the array be folded from the
-- sequence s with a primitive polynomial of degree n over GF(q). Let alpha be a root of the
-- polynomial, and let e(i, j) be the index in s of the cell (i, j). The cell at offset (i, j) from
-- the position of the term s(t) holds s(t + e(i, j)). That is a GF(q)-linear function of alpha^(t +
-- e(i, j)), and only 0 gives the zero sequence. So a window's content is a linear function of
-- alpha^t. That function is one-to-one exactly if the alpha^e(i, j) of the window's cells span
-- GF(q^n) over GF(q).
module PraTactile.Window.Rank
  ( windowRank,
    windowVectors,
    cellVectors,
    gridVectors,
    windowsOfRank,
    rankOf,
  )
where

import Data.List (scanl')
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Extension
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.Polynomial
import PraTactile.Window

-- | The rank over GF(q), at most n, of the alpha^e(i, j) for the cells (i, j) of the mask. The
-- windows of the 'naturalSurface' are distinct exactly if it is n; those of the sheet are distinct
-- if it is n. O(m n^2), after 'windowVectors'.
windowRank :: KnownField k => PseudorandomArray k -> Mask -> Natural
windowRank array mask =
  fromIntegral (length (independentRows n (cellVectors array (maskOffsets mask))))
  where
    n = primitiveDegree (arrayPrimitive array)

-- | The alpha^e(i, j) for the cells of the mask, row by row, each by its n coordinates in the basis
-- 1, alpha, ...
--
-- Since e(i, j) = e(i, 0) + e(0, j), each is the product of a power for its row and one for its
-- column. The powers are computed from one row or column to the next, so a rectangle needs only two
-- powers with long exponents. O(m n^2 + g (n^3 + q n^2)) operations in GF(q) for m cells and g
-- different gaps between neighbouring rows or columns of the mask; a rectangle has two.
windowVectors :: KnownField k => PseudorandomArray k -> Mask -> [[GF k]]
windowVectors array = map rowToList . cellVectors array . maskOffsets

-- | 'windowVectors' for any number of cells with these offsets, in their order.
cellVectors :: KnownField k => PseudorandomArray k -> [Position] -> [Row k]
cellVectors array = gridVectors h (alphaTo . (`Position` 0)) (alphaTo . Position 0)
  where
    h = arrayPrimitive array
    alphaTo = powerOfRoot h . sequenceIndex array

-- | The products a(i) b(j) for cells with these offsets (i, j), in their order, each by its
-- coordinates in the basis 1, alpha, ... Arguments: the primitive polynomial with the root alpha;
-- the function a of rows; the function b of columns; the offsets. Both functions must turn sums
-- into products, which is not checked.
gridVectors ::
  KnownField k =>
  Primitive k ->
  (Natural -> Residue k) ->
  (Natural -> Residue k) ->
  [Position] ->
  [Row k]
gridVectors h byRows byColumns offsets =
  [ residueVector h (multiplyModulo h a b)
    | Position i j <- offsets,
      Just a <- [Map.lookup i down],
      Just b <- [Map.lookup j right]
  ]
  where
    down = powersAlong byRows (map row offsets)
    right = powersAlong byColumns (map column offsets)
    -- From each index to its power, step by step.
    powersAlong by indices =
      Map.fromList (zip used (drop 1 (scanl' (multiplyModulo h) (powerOfRoot h 0) taken)))
      where
        used = Set.toAscList (Set.fromList indices)
        gaps = zipWith (-) used (0 : used)
        taken = [a | gap <- gaps, Just a <- [Map.lookup gap steps]]
        steps = Map.fromSet by (Set.fromList gaps)

-- | The rank of a matrix over GF(q), given by rows of one length. O(m n r) for m rows of n
-- elements, of rank r.
rankOf :: KnownField k => [[GF k]] -> Natural
rankOf matrix = fromIntegral (length (independentRows maxBound (map rowFromList matrix)))

-- | The number of different contents of windows on the 'naturalSurface', if the window's rank is r.
-- As alpha^t runs through the q^n - 1 nonzero elements, the content runs through the image of a
-- linear map of rank r, except for the image of zero. For r = n that gives q^n - 1 contents. For r
-- < n some nonzero element has the image of zero too, and there are q^r contents.
windowsOfRank :: KnownField k => PseudorandomArray k -> Natural -> Natural
windowsOfRank array r
  | r == fromIntegral (primitiveDegree h) = period h
  | otherwise = fromIntegral (fieldOrder array) ^ r
  where
    h = arrayPrimitive array
