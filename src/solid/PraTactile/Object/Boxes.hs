{-# OPTIONS_HADDOCK hide #-}

-- | Finds which of many boxes meet a given box or segment, without testing each. Boxes have sides
-- along the axes. They are the leaves of a tree, sorted along a curve that keeps neighbours
-- together (Morton 1966), so a single sort builds the tree. Corners are rounded down, which keeps
-- their order. So if two boxes meet before rounding, they meet after it, and perhaps others do.
module PraTactile.Object.Boxes
  ( Box (..),
    Rounding,
    roundingOf,
    boxOf,
    around,
    meets,
    Boxes,
    boxes,
    meeting,
    along,

    -- * Sorting
    sortedPairs,
  )
where

import Control.Monad (forM_)
import Control.Monad.ST (ST)
import Data.Bits (countLeadingZeros, shiftL, shiftR, (.&.), (.|.))
import Data.List (foldl')
import qualified Data.Vector as V
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Math.NumberTheory.Logarithms (integerLog2)
import PraTactile.Object.Vector

-- | The least x, y and z, then the greatest x, y and z, rounded.
data Box = Box !Int !Int !Int !Int !Int !Int
  deriving stock (Eq, Show)

-- | The number of last binary digits that are dropped from every coordinate, so that it fits a
-- machine integer. Only boxes with one rounding can be compared.
newtype Rounding = Rounding Int

-- | A rounding that suffices for points whose coordinates are no larger than those of these points.
roundingOf :: V.Vector V3 -> Rounding
roundingOf points = Rounding (max 0 (integerLog2 (max 1 most) - 60))
  where
    most = V.foldl' (\m (V3 a b c) -> max (abs a) (max (abs b) (max (abs c) m))) 1 points

-- | The box that contains only this point, rounded.
boxOf :: Rounding -> V3 -> Box
boxOf (Rounding digits) (V3 a b c) = Box x y z x y z
  where
    x = down a
    y = down b
    z = down c
    down n = fromInteger (if digits == 0 then n else n `shiftR` digits)

-- | The smallest box around two boxes.
around :: Box -> Box -> Box
around (Box a b c d e f) (Box a' b' c' d' e' f') =
  Box (min a a') (min b b') (min c c') (max d d') (max e e') (max f f')

-- | Whether two boxes have a point in common.
meets :: Box -> Box -> Bool
meets (Box a b c d e f) (Box a' b' c' d' e' f') =
  a <= d' && a' <= d && b <= e' && b' <= e && c <= f' && c' <= f

-- | A searchable tree of boxes. The nodes are numbered from 1, the root. The box of node @k@
-- contains those of nodes @2 k@ and @2 k + 1@.
data Boxes = Boxes
  { -- | the number of leaves, a power of 2; the leaves are the nodes from this number up to twice
    -- it, less 1
    leaves :: !Int,
    -- | for each leaf in order, the index of its box in the input of 'boxes'; other leaves are
    -- empty
    items :: !(U.Vector Int),
    -- | the numbers of each node's 'Box'; those of node @k@ begin at @6 k@
    bounds :: !(U.Vector Int)
  }

-- | Builds the tree of boxes. O(n log n).
boxes :: V.Vector Box -> Boxes
boxes given = Boxes width sorted (U.create filled)
  where
    count = V.length given
    width = 1 `shiftL` (64 - countLeadingZeros (max 1 count - 1))
    sorted = U.map snd (sortedPairs (U.generate count (\i -> (curve (given V.! i), i))))
    whole = foldl' around nothing (V.toList given)
    curve box = interleaved (middle box)
    middle (Box a b c d e f) = (place 0 a d, place 1 b e, place 2 c f)
    place :: Int -> Int -> Int -> Int
    place axis low high =
      let Box x y z x' y' z' = whole
          (from, to) = [(x, x'), (y, y'), (z, z')] !! axis
          size = max 1 ((to - from) `shiftR` 21 + 1)
       in ((low - from) `quot` 2 + (high - from) `quot` 2) `quot` size
    filled :: ST s (M.MVector s Int)
    filled = do
      store <- M.new (6 * 2 * width)
      forM_ [0 .. width - 1] $ \k ->
        write store (width + k) (if k < count then given V.! (sorted U.! k) else nothing)
      forM_ [width - 1, width - 2 .. 1] $ \k ->
        (around <$> fetch store (2 * k) <*> fetch store (2 * k + 1)) >>= write store k
      pure store
    write store k (Box a b c d e f) =
      forM_ (zip [6 * k ..] [a, b, c, d, e, f]) (uncurry (M.write store))
    fetch store k =
      Box <$> at 0 <*> at 1 <*> at 2 <*> at 3 <*> at 4 <*> at 5
      where
        at i = M.read store (6 * k + i)

-- | A box that meets no box and does not change a union with it.
nothing :: Box
nothing = Box maxBound maxBound maxBound minBound minBound minBound

-- | The place of a point on the curve: the last 21 binary digits of its three coordinates, in turn.
interleaved :: (Int, Int, Int) -> Int
interleaved (x, y, z) = spread x .|. (spread y `shiftL` 1) .|. (spread z `shiftL` 2)
  where
    spread n = foldl' step (n .&. 0x1fffff) [(32, a), (16, b), (8, c), (4, d), (2, e)]
    step n (by, mask) = (n .|. (n `shiftL` by)) .&. mask
    a = 0x1f00000000ffff
    b = 0x1f0000ff0000ff
    c = 0x100f00f00f00f00f
    d = 0x10c30c30c30c30c3
    e = 0x1249249249249249

-- | The boxes that meet this one, by their indices in the input of 'boxes'. O(log n) plus the
-- number found, if boxes are compact.
meeting :: Boxes -> Box -> [Int]
meeting tree = descended tree . meetsNode tree

-- | The boxes that the segment between two points may meet, by their indices in the input of
-- 'boxes'. Each point is given as the box of 'boxOf'. The result contains all boxes that the
-- segment meets, and perhaps more. Subtrees are excluded whose box the segment misses in the
-- projection along an axis, so slanted segments find few. O(log n) plus the number found, if boxes
-- are compact.
along :: Boxes -> Box -> Box -> [Int]
along tree p@(Box a b c _ _ _) q@(Box a' b' c' _ _ _) =
  descended tree (\k -> whole k && (k >= leaves tree || mayMeet k))
  where
    mayMeet k = shadow k 0 a dx 1 b dy && shadow k 1 b dy 2 c dz && shadow k 2 c dz 0 a dx
    whole = meetsNode tree (p `around` q)
    (dx, dy, dz) = (double (a' - a), double (b' - b), double (c' - c))
    double = fromIntegral :: Int -> Double
    -- Coordinates are rounded, and so are machine numbers.
    shadow :: Int -> Int -> Int -> Double -> Int -> Int -> Double -> Bool
    shadow k i u du j v dv =
      abs (du * t - dv * s) <= abs du * (high + off) + abs dv * (wide + off) + 2 * (abs s + abs t)
      where
        (s, wide) = (double (most k i + least k i - u), double (most k i - least k i))
        (t, high) = (double (most k j + least k j - v), double (most k j - least k j))
        off = 4 + (abs s + abs t + wide + high + abs du + abs dv) / 0x10000000000
    -- Halves of coordinates, whose sum fits a machine integer.
    least k axis = U.unsafeIndex (bounds tree) (6 * k + axis) `shiftR` 1
    most k axis = U.unsafeIndex (bounds tree) (6 * k + axis + 3) `shiftR` 1

-- | Whether the box meets that of the node with this number.
meetsNode :: Boxes -> Box -> Int -> Bool
meetsNode tree (Box a b c d e f) k =
  a <= at 3 && at 0 <= d && b <= at 4 && at 1 <= e && c <= at 5 && at 2 <= f
  where
    at i = U.unsafeIndex (bounds tree) (6 * k + i)
{-# INLINE meetsNode #-}

-- | The input's boxes, by their indices, whose leaves are reached from the root through nodes that
-- all satisfy the condition.
descended :: Boxes -> (Int -> Bool) -> [Int]
descended tree holds = visit 1 []
  where
    visit k rest
      | not (holds k) = rest
      | k >= leaves tree = U.unsafeIndex (items tree) (k - leaves tree) : rest
      | otherwise = visit (2 * k) (visit (2 * k + 1) rest)
{-# INLINE descended #-}

-- | Sorts pairs in ascending order. (The sort is specialised to pairs only if it has all its
-- arguments.)
sortedPairs :: U.Vector (Int, Int) -> U.Vector (Int, Int)
sortedPairs = U.modify (\pairs -> Intro.sortByBounds compare pairs 0 (M.length pairs))
