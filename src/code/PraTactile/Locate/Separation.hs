{-# OPTIONS_HADDOCK hide #-}

-- | Patches that are seen turned or mirrored, and how far the code alone separates the symmetries.
-- Often not at all: every quarter turn of a 2 x 2 window of the paper's array is another of its
-- windows, and an array of windows with two columns is its own mirror image (Note [Two columns]);
-- then only the symbols' own axes show it.
module PraTactile.Locate.Separation
  ( -- * Candidates
    candidateDistance,
    candidatesDiffer,
    orientedDistance,
    largestOrientedSearch,
  )
where

import Data.List (nub, transpose)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.LinearCode
import PraTactile.LinearCode.Elimination (rowFromList)
import PraTactile.LinearCode.MinimumDistance
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Polynomial (primitiveDegree)
import PraTactile.Symmetry
import PraTactile.Window
import PraTactile.Window.Rank (windowVectors)

{- Note [Two columns]
   ~~~~~~~~~~~~~~~~~~
   Let an array be folded along the diagonal for windows of k1 rows and two columns: n1 = Q - 1 and
   n2 = Q + 1 with Q = q^k1, and alpha in GF(Q^2). Q is even, for else both sides were. Its terms
   are s(t) = Tr(b alpha^t), with the trace from GF(Q^2) to GF(q) and some b that is not zero. A
   trace is the same for conjugates, so that Tr(x^Q) = Tr(x), and s(t) = Tr(b^Q alpha^(Q t)) = s(Q t
   + u), where alpha^u = b^(Q - 1). Now Q = 1 modulo n1, and Q = -1 modulo n2; and u is a multiple
   of Q - 1 = n1. So the term s(Q t + u) stands in the row of s(t), and in the column u - j where
   s(t) stands in column j: a[i][j] = a[i][u - j]. Every row reads the same in both directions from
   an axis that is the same for all. The axis goes through one column, because n2 is odd: that with
   2 j = u, where (b alpha^t)^(Q - 1) = 1, so that b alpha^t is in GF(Q), whose elements have the
   trace 2 x = 0 already in GF(Q). It is the column of zeros. In general exchanging left and right
   is the map t -> m t with m = 1 modulo n1 and m = -1 modulo n2, and the same proof holds wherever
   m is a power of q modulo n1 n2. -}

{- Note [Distance between orientations]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   What cells of a patch hold at the position of the term s(t), the patch being seen in an
   orientation o, is a linear function L_o of alpha^t (see "PraTactile.Window.Rank"). Two positions
   b and b' in orientations o and o' differ in the cells where L_o(b) - L_o'(b') is not zero: a
   codeword of the sum of both codes. Zero is no position, but a codeword L_o(b) - L_o'(0) is the
   difference of two positions in the one orientation o, which has to be counted anyway. So the
   least distance of all in o or o' is the least weight of all L_o(b) - L_o'(b') with b and b' not
   both zero: the minimum distance of the sum of the codes if it has dimension 2 n, and 0 if it has
   less. -}

-- | The number of cells in which, at least, any two of these differ: one position in one of the
-- orientations, and another position or the same in another one. Given the shape of the patch as it
-- is seen, and the offsets in it of the observed cells. Half of it bounds the wrong cells that are
-- always corrected. 0 where two do not differ, and on a surface that is neither the array's
-- 'naturalSurface' nor the sheet, where no distance is promised. Exact up to
-- 'largestOrientedSearch' codewords for every two orientations and 4096 cells; beyond, it is a
-- lower bound. See Note [Distance between orientations].
candidateDistance ::
  KnownField k =>
  ArrayOn k ->
  [Symmetry] ->
  Shape ->
  [Position] ->
  Natural
candidateDistance on possible shape offsets =
  case map (fromIntegral . leastWeight largestOrientedSearch)
    <$> codesOfDifferences on possible shape offsets of
    Just distances@(_ : _) -> minimum distances
    _ -> 0

-- | Whether that distance is above 0, so that any two candidates differ: by ranks alone.
candidatesDiffer ::
  KnownField k =>
  ArrayOn k ->
  [Symmetry] ->
  Shape ->
  [Position] ->
  Bool
candidatesDiffer on possible shape offsets =
  maybe False (not . null) (codesOfDifferences on possible shape offsets)

-- | The codes of Note [Distance between orientations], one for every two orientations, or that of
-- the only one; 'Nothing' where one of them has not the full dimension, and where no distance is
-- promised.
codesOfDifferences ::
  KnownField k =>
  ArrayOn k ->
  [Symmetry] ->
  Shape ->
  [Position] ->
  Maybe [LinearCode k]
codesOfDifferences (ArrayOn surface array) possible shape offsets
  | surface `notElem` [Sheet, naturalSurface (arrayFolding array)] || null offsets = Nothing
  | any ((< full) . dimension) codes = Nothing
  | otherwise = Just codes
  where
    used = take 4096 offsets
    n = primitiveDegree (arrayPrimitive array)
    (full, codes) = case map words' (nub possible) of
      [only] -> (n, [spannedBy (length used) only])
      several ->
        ( 2 * n,
          [spannedBy (length used) (a ++ b) | (k, a) <- zip [1 ..] several, b <- drop k several]
        )
    -- Codewords that span the code of an orientation.
    words' o =
      either
        (const [])
        (map rowFromList . transpose . windowVectors array)
        (maskFrom (map (onPosition (invert o) shape) used))

-- | 2^18: the most codewords that are looked at for two orientations.
largestOrientedSearch :: Natural
largestOrientedSearch = 2 ^ (18 :: Int)

-- | The same of all cells of a square patch, given its side in cells. 0 for no cells.
orientedDistance :: KnownField k => Codebook k -> [Symmetry] -> Natural -> Natural
orientedDistance codebook possible side =
  candidateDistance
    (codebookOn codebook)
    possible
    (Shape side side)
    (shapeCells (Shape side side))
