-- | The errors and erasures that a window can correct. The windows of a mask on the array's
-- 'naturalSurface', with the zero window, are a linear code over GF(q), because the sum of two
-- shifts of an m-sequence is a third (MacWilliams and Sloane 1976). It is the code of the vectors
-- in "PraTactile.Window.Rank". So two windows differ in at least as many cells as the lightest
-- window has nonzero cells.
--
-- Costs: m is the number of the mask's cells, n the degree of the polynomial. Each function first
-- computes the code, at the cost of 'PraTactile.Window.Proof.windowRank'.
module PraTactile.Window.Distance
  ( -- * Minimum distance
    minimumDistance,
    minimumDistanceWithin,
    Distance (..),
    DistanceError (..),
    largestSearch,

    -- * Correcting
    corrects,

    -- * Weights
    weightEnumerator,
  )
where

import Data.List (transpose)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.LinearCode
import PraTactile.LinearCode.Elimination
import PraTactile.LinearCode.MinimumDistance
import PraTactile.LinearCode.Weights
import PraTactile.Polynomial
import PraTactile.Window
import PraTactile.Window.Rank

-- | The minimum distance, with cells that attain it.
data Distance = Distance
  { -- | the least number of cells in which two windows on the array's surface differ; 0 if two are
    -- equal. Windows on the sheet differ in at least as many.
    distance :: Natural,
    -- | a smallest set of the mask's cells, by their offsets, without which the rest does not
    -- determine the position: some windows differ only in these cells. It has as many cells as the
    -- distance.
    failingErasure :: [Position]
  }
  deriving stock (Eq, Show)

-- | Why the distance or the weights are unknown.
data DistanceError
  = -- | The search would take too long. The distance is at least the first number and at most the
    -- second.
    DistanceBetween Natural Natural
  | -- | There are this many windows, more than 'largestSearch', and not fewer words in the dual
    -- code.
    TooManyCodewords Natural
  deriving stock (Eq, Show)

-- | The most codewords that are searched, 2^24.
largestSearch :: Natural
largestSearch = 2 ^ (24 :: Int)

-- | The minimum distance of the windows of a mask. It is exact, by a search among combinations of
-- few independent windows (A. E. Brouwer and K.-H. Zimmermann). Refuses if that takes more than
-- 'largestSearch' codewords. O(m) for each codeword searched: about (n over w) (q - 1)^(w - 1) for
-- each of the disjoint sets of n independent cells, where w is n d over m for the distance d.
minimumDistance :: KnownField k => PseudorandomArray k -> Mask -> Either DistanceError Distance
minimumDistance = minimumDistanceWithin largestSearch

-- | 'minimumDistance' that refuses beyond this many codewords instead.
minimumDistanceWithin ::
  KnownField k => Natural -> PseudorandomArray k -> Mask -> Either DistanceError Distance
minimumDistanceWithin effort array mask
  | dimension code < primitiveDegree (arrayPrimitive array) = Right (Distance 0 [])
  | otherwise = case lightest effort code of
    Lightest x -> let cells = support x in Right (Distance (fromIntegral (length cells)) cells)
    Between low high -> Left (DistanceBetween (fromIntegral low) (fromIntegral high))
    NoCodeword -> Right (Distance 0 [])
  where
    code = windowCode array mask
    support x = [offset | (offset, a) <- zip (maskOffsets mask) (rowToList x), a /= zero]

-- | @corrects d e s@ says whether, with minimum distance d, e wrong cells and s missing ones still
-- leave a unique nearest position: 2 e + s < d.
corrects :: Natural -> Natural -> Natural -> Bool
corrects d errors erasures = 2 * errors + erasures < d

-- | The number of windows for each number of nonzero cells, including the zero window. The numbers
-- add up to q^r, where r is the rank of the mask. Either all windows are visited, or all words of
-- the dual code, with the identity of MacWilliams, whichever are fewer. Refuses if these exceed
-- 'largestSearch'. O(m) for each of min (q^r) (q^(m - r)) codewords, and O(m^4) for the identity.
weightEnumerator ::
  KnownField k =>
  PseudorandomArray k ->
  Mask ->
  Either DistanceError (Map Natural Natural)
weightEnumerator array mask
  | own <= others && own <= largestSearch = Right (natural (weights code))
  | others < own && others <= largestSearch =
    Right (natural (weightsOfDual q (maskSize mask) (weights (dual code))))
  | otherwise = Left (TooManyCodewords own)
  where
    code = windowCode array mask
    q = fieldOrder array
    own = fromIntegral q ^ dimension code
    others = fromIntegral q ^ (maskSize mask - dimension code)
    natural = Map.mapKeysMonotonic fromIntegral

-- | The windows of a mask as a code. Coordinate i of all the alpha^e is a codeword, and these span
-- the code.
windowCode :: KnownField k => PseudorandomArray k -> Mask -> LinearCode k
windowCode array mask =
  spannedBy (maskSize mask) (map rowFromList (transpose (windowVectors array mask)))
