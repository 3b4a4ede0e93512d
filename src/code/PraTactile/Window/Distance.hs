-- | How many errors and erasures a window forgives. The windows of a mask on the array's
-- 'naturalSurface', with the zero window, are a linear code over GF(q), because the sum of two
-- shifts of an m-sequence is a third (MacWilliams and Sloane 1976): that of the vectors
-- "PraTactile.Window.Rank" speaks of. So two of them differ in at least as many cells as the
-- lightest window has that are not zero.
--
-- Costs: m is the number of the mask's cells, n the degree of the polynomial. First of all the code
-- is found, as 'PraTactile.Window.Proof.windowRank' does.
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

-- | The minimum distance, and cells that show it.
data Distance = Distance
  { -- | the least number of cells in which two windows on the array's surface differ: 0 if some are
    -- the same. Windows on the sheet differ in at least as many.
    distance :: Natural,
    -- | as many cells of the mask, by their offsets: a smallest set without which the rest of the
    -- mask does not determine the position any more; there are windows that differ in them only
    failingErasure :: [Position]
  }
  deriving stock (Eq, Show)

-- | Why the distance, or the weights, are not known.
data DistanceError
  = -- | The search would take too long: the distance is at least the first number, at most the
    -- second.
    DistanceBetween Natural Natural
  | -- | There are this many windows, more than 'largestSearch', and no fewer ones in the dual code.
    TooManyCodewords Natural
  deriving stock (Eq, Show)

-- | 2^24: the most codewords that are looked at.
largestSearch :: Natural
largestSearch = 2 ^ (24 :: Int)

-- | The minimum distance of the windows of a mask. Exact; by a search among combinations of few
-- independent windows (A. E. Brouwer and K.-H. Zimmermann), which refuses beyond 'largestSearch'
-- codewords. O(m) for each codeword looked at: some (n over w) (q - 1)^(w - 1) for each of the
-- disjoint sets of n independent cells, w being n d over m for the distance d.
minimumDistance :: KnownField k => PseudorandomArray k -> Mask -> Either DistanceError Distance
minimumDistance = minimumDistanceWithin largestSearch

-- | The same, refused beyond this many codewords instead.
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

-- | @corrects d e s@: with minimum distance d, e wrong cells and s missing ones still leave one
-- position that is nearest: 2 e + s < d.
corrects :: Natural -> Natural -> Natural -> Bool
corrects d errors erasures = 2 * errors + erasures < d

-- | How many windows, the zero window with them, have each number of cells that are not zero; the
-- numbers add up to q^r, r being the rank of the mask. By visiting them all, or all of the dual
-- code and the identity of MacWilliams, whichever are fewer; refuses when these exceed
-- 'largestSearch'. O(m) a codeword, of which there are min (q^r) (q^(m - r)); and O(m^4) for the
-- identity.
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

-- | The windows of a mask as a code: coordinate i of all the alpha^e makes a codeword, and these
-- span the code.
windowCode :: KnownField k => PseudorandomArray k -> Mask -> LinearCode k
windowCode array mask =
  spannedBy (maskSize mask) (map rowFromList (transpose (windowVectors array mask)))
