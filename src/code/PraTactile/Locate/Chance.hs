-- | The chance of a random answer: of all contents that the observed cells could have, the share
-- that would be located. A decoder that corrects up to r wrong cells answers to whatever lies in
-- the Hamming sphere of radius r about the word of a position, which holds
--
--   V(r) = sum over i up to r of (m over i) (q - 1)^i
--
-- of the q^m words of m cells. With N positions that is N V(r) / q^m of all: exactly, while 2 r is
-- less than the minimum distance, when no two spheres meet; and never more (R. W. Hamming 1950; F.
-- J. MacWilliams and N. J. A. Sloane 1977, chapter 1, theorem 6). That share of random symbols is
-- taken for cells of the array.
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
    -- | Whether it is exactly this; else it is at most this.
    chanceExact :: !Bool
  }
  deriving stock (Eq, Show)

-- | The same share as a bound only: for a decoder that may refuse what it could locate.
atMost :: Chance -> Chance
atMost found = found {chanceExact = False}

-- | Spheres of one radius about the words of all candidates, which are positions in the
-- orientations in question.
data Spheres = Spheres
  { -- | q.
    sphereAlphabet :: !Natural,
    -- | m, the length of a word.
    sphereCells :: !Natural,
    -- | N, how many candidates there are.
    sphereCentres :: !Natural,
    -- | r, in cells.
    sphereRadius :: !Natural,
    -- | In how many cells any two candidates differ at least; 0 where that is not promised.
    sphereDistance :: !Natural
  }
  deriving stock (Eq, Show)

-- | The spheres of radius 0 of the candidates on a surface, no distance promised; by the
-- orientations in question, the shape of the patch as it is seen, and the offsets in it of the
-- observed cells. On the sheet candidates are those with which the patch's upper left and all
-- observed cells lie on it. 'Nothing' where no cell was observed. O(o m) for o orientations and m
-- cells.
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

-- | @correcting d r@: for a decoder that corrects up to r wrong cells, the minimum distance of the
-- candidates being d at least.
correcting :: Natural -> Natural -> Spheres -> Spheres
correcting d r around = around {sphereDistance = d, sphereRadius = r}

-- | For a decoder that holds only this many of the cells to what the array has: it may refuse for
-- the others' sake, so that no distance is promised.
amongCells :: Natural -> Spheres -> Spheres
amongCells m around = around {sphereCells = m, sphereDistance = 0}

-- | The share of all contents that lies in the spheres. To the precision of 'Double' up to 4096
-- cells, and beyond, where it is 0 or 1 but for few radii, by logarithms. O(r) operations, on whole
-- numbers up to q^m or beyond on doubles.
--
-- The paper's array, 2 x 2 cells, and 3 x 3 of which one is corrected:
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
    -- The logarithms of the terms of the volume, and of their sum, relative to the largest.
    terms =
      scanl'
        (+)
        0
        [ naturalLogarithm (m - i) - naturalLogarithm (i + 1) + naturalLogarithm (q - 1)
          | i <- genericTake (min r m) [0 ..]
        ]
    largest = maximum terms
    logVolume = largest + log (sum (map (\x -> exp (x - largest)) terms))

-- | 4096: up to this many cells shares are computed in whole numbers.
mostExactCells :: Natural
mostExactCells = 4096

-- | @sphereVolume q m r@: how many words of m symbols out of q differ from a given one in at most
-- r. O(r) operations on numbers up to q^m.
--
-- >>> [sphereVolume 2 7 1, sphereVolume 4 9 1, sphereVolume 4 3 9]
-- [8,28,64]
sphereVolume :: Natural -> Natural -> Natural -> Natural
sphereVolume q m r =
  sum (scanl' (\term i -> term * (m - i) * (q - 1) `div` (i + 1)) 1 (genericTake (min r m) [0 ..]))
