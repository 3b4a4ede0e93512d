{-# OPTIONS_HADDOCK hide #-}

-- | Patches seen turned or mirrored, and how well the code alone separates the symmetries. Often it
-- does not: every quarter turn of a 2 x 2 window of the paper's array is another of its windows,
-- and an array for windows with two columns is its own mirror image (Note [Two columns]). Then only
-- the symbols' own axes show the symmetry.
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
   Let an array be folded along the diagonal for windows of k1 rows and two columns. Then n1 = Q - 1
   and n2 = Q + 1 with Q = q^k1, and alpha is in GF(Q^2). Q is even; otherwise both sides would be
   even. The terms are s(t) = Tr(b alpha^t), with the trace from GF(Q^2) to GF(q) and some nonzero
   b. Conjugates have one trace, so Tr(x^Q) = Tr(x), and s(t) = Tr(b^Q alpha^(Q t)) = s(Q t + u),
   where alpha^u = b^(Q - 1). Now Q = 1 modulo n1, Q = -1 modulo n2, and u is a multiple of Q - 1 =
   n1. So the term s(Q t + u) is in the row of s(t), and in column u - j if s(t) is in column j:
   a[i][j] = a[i][u - j].

   So every row reads the same in both directions from an axis that all rows share. The axis goes
   through one column, because n2 is odd: the column with 2 j = u. There (b alpha^t)^(Q - 1) = 1, so
   b alpha^t is in GF(Q), and its trace to GF(Q) is already 2 x = 0. It is the column of zeros.

   In general, exchanging left and right is the map t -> m t with m = 1 modulo n1 and m = -1 modulo
   n2. The same proof holds whenever m is a power of q modulo n1 n2. -}

{- Note [Distance between orientations]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   Take a patch in orientation o at the position of the term s(t). The content of its cells is a
   linear function L_o of alpha^t (see "PraTactile.Window.Rank"). Two positions b and b' in
   orientations o and o' differ in the cells where L_o(b) - L_o'(b') is nonzero, which is a codeword
   of the sum of both codes. Zero is not a position. But a codeword L_o(b) - L_o'(0) is the
   difference of two positions in the one orientation o, which must be counted anyway. So the
   minimum distance of all candidates in o or o' is the least weight of L_o(b) - L_o'(b') over all b
   and b' that are not both zero. That is the minimum distance of the sum of the codes if the sum
   has dimension 2 n, and 0 if it has less. -}

-- | The minimum number of observed cells in which two candidates differ: different positions, or
-- one position in different orientations. Arguments: the array; the orientations; the shape of the
-- patch as seen; the offsets of the observed cells in it. Fewer wrong cells than half of it are
-- always corrected.
--
-- It is 0 if two candidates do not differ, and on a surface other than the array's 'naturalSurface'
-- and the sheet, where no distance is guaranteed. It is exact up to 'largestOrientedSearch'
-- codewords for each pair of orientations and 4096 cells, and a lower bound beyond. See Note
-- [Distance between orientations].
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

-- | Whether 'candidateDistance' is above 0, so that any two candidates differ; computed by ranks
-- alone.
candidatesDiffer ::
  KnownField k =>
  ArrayOn k ->
  [Symmetry] ->
  Shape ->
  [Position] ->
  Bool
candidatesDiffer on possible shape offsets =
  maybe False (not . null) (codesOfDifferences on possible shape offsets)

-- | The codes of Note [Distance between orientations], one for each pair of orientations, or that
-- of the only orientation. 'Nothing' if one of them lacks the full dimension, or no distance is
-- guaranteed.
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

-- | The most codewords that are searched for a pair of orientations, 2^18.
largestOrientedSearch :: Natural
largestOrientedSearch = 2 ^ (18 :: Int)

-- | 'candidateDistance' for all cells of a square patch with this side. 0 for no cells.
orientedDistance :: KnownField k => Codebook k -> [Symmetry] -> Natural -> Natural
orientedDistance codebook possible side =
  candidateDistance
    (codebookOn codebook)
    possible
    (Shape side side)
    (shapeCells (Shape side side))
