-- | The chance of a random answer: the share of all contents of the observed cells that would be
-- located. A decoder that corrects up to r wrong cells answers for every word in the Hamming sphere
-- of radius r around the word of a position. That sphere holds
--
--   V(r) = sum over i up to r of (m over i) (q - 1)^i
--
-- of the q^m words of m cells. With N positions the share is at most N V(r) / q^m. It is exact
-- while 2 r is less than the minimum distance, since the spheres are then disjoint (R. W. Hamming
-- 1950; F. J. MacWilliams and N. J. A. Sloane 1977, chapter 1, theorem 6). It is the probability
-- that random symbols are mistaken for cells of the array.
module PraTactile.Locate.Chance
  ( -- * The share
    Chance (..),
    chance,
    atMost,

    -- * Spheres
    Spheres (..),
    spheres,
    correcting,
    amongCells,
    sphereVolume,
  )
where

import Data.List (genericTake, nub, scanl')
import Data.Ratio ((%))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field (KnownField, fieldOrder)
import PraTactile.Grid (admissible, extentOf)
import PraTactile.Locate.Logarithm
import PraTactile.Symmetry

-- | A share of all contents of the observed cells.
data Chance = Chance
  { -- | From 0 to 1.
    chanceShare :: !Double,
    -- | Whether the share is exact; else it is an upper bound.
    chanceExact :: !Bool
  }
  deriving stock (Eq, Show)

-- | The same share as an upper bound, for a decoder that may refuse what it could locate.
atMost :: Chance -> Chance
atMost found = found {chanceExact = False}

-- | Spheres of one radius around the words of all candidates: positions in the queried symmetries.
data Spheres = Spheres
  { -- | The number of symbols, q.
    sphereAlphabet :: !Natural,
    -- | The length of a word, m.
    sphereCells :: !Natural,
    -- | The number of candidates, N.
    sphereCentres :: !Natural,
    -- | The radius r, in cells.
    sphereRadius :: !Natural,
    -- | The minimum number of cells in which two candidates differ; 0 if that is not guaranteed.
    sphereDistance :: !Natural
  }
  deriving stock (Eq, Show)

-- | Spheres of radius 0 without a guaranteed distance. Arguments: the array on its surface; the
-- queried symmetries; the shape of the patch as seen; the offsets in it of the observed cells. On
-- the sheet, a candidate must have the patch's upper left cell and all observed cells on it.
-- 'Nothing' if no cell was observed. O(o m) for o symmetries and m cells.
spheres ::
  KnownField k =>
  ArrayOn k ->
  [Symmetry] ->
  Shape ->
  [Position] ->
  Maybe Spheres
spheres (ArrayOn surface array) possible shape offsets
  | null offsets = Nothing
  | otherwise =
    Just
      Spheres
        { sphereAlphabet = fromIntegral (fieldOrder array),
          sphereCells = fromIntegral (length offsets),
          sphereCentres = sum (map places (nub possible)),
          sphereRadius = 0,
          sphereDistance = 0
        }
  where
    places orientation =
      area
        ( admissible
            surface
            (arrayShape array)
            (extentOf (map (onPosition (invert orientation) shape) offsets))
        )

-- | @correcting d r@ sets the minimum distance d between candidates and the radius r: the decoder
-- corrects up to r wrong cells.
correcting :: Natural -> Natural -> Spheres -> Spheres
correcting d r around = around {sphereDistance = d, sphereRadius = r}

-- | Restricts the spheres to this many of the cells, for a decoder that compares only these with
-- the array. It may refuse because of the others, so no distance is guaranteed.
amongCells :: Natural -> Spheres -> Spheres
amongCells m around = around {sphereCells = m, sphereDistance = 0}

-- | The share of all contents that lies in the spheres. With up to 4096 cells it has the precision
-- of a 'Double'. With more it is computed by logarithms; it is then 0 or 1 except for few radii.
-- O(r) operations, on integers up to q^m, or beyond 4096 cells on doubles.
--
-- The examples are the paper's array with 2 x 2 cells, and with 3 x 3 cells of which one is
-- corrected:
--
-- >>> chanceShare (chance (Spheres 4 4 255 0 1)) == 255 / 256
-- True
-- >>> chanceShare (chance (Spheres 4 9 255 1 4)) == 255 * 28 / 4 ^ 9
-- True
chance :: Spheres -> Chance
chance (Spheres q m n r d) = Chance (min 1 share) (2 * r < d)
  where
    share
      | m <= mostExactCells = fromRational (toInteger (n * sphereVolume q m r) % toInteger (q ^ m))
      | otherwise = exp (naturalLogarithm n + logVolume - fromIntegral m * naturalLogarithm q)
    -- The logarithms of the terms of the volume; their sum is taken relative to the largest.
    terms =
      scanl'
        (+)
        0
        [ naturalLogarithm (m - i) - naturalLogarithm (i + 1) + naturalLogarithm (q - 1)
          | i <- genericTake (min r m) [0 ..]
        ]
    largest = maximum terms
    logVolume = largest + log (sum (map (\x -> exp (x - largest)) terms))

-- | The most cells for which shares are computed with integers.
mostExactCells :: Natural
mostExactCells = 4096

-- | @sphereVolume q m r@ is the number of words of m symbols out of q that differ from a given word
-- in at most r places. O(r) operations on numbers up to q^m.
--
-- >>> [sphereVolume 2 7 1, sphereVolume 4 9 1, sphereVolume 4 3 9]
-- [8,28,64]
sphereVolume :: Natural -> Natural -> Natural -> Natural
sphereVolume q m r =
  sum (scanl' (\term i -> term * (m - i) * (q - 1) `div` (i + 1)) 1 (genericTake (min r m) [0 ..]))
