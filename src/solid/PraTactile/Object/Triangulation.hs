-- | Plane regions cut into triangles, exactly: polygons with any number of holes, with pieces in
-- the holes, and so on; of all ways to do so one whose least angle is greatest.
--
-- The region of some loops, which do not meet, is what an odd number of them has inside. With n
-- corners, o loops that bound a part of it from outside and h that bound one from inside, it is cut
-- into n - 2 o + 2 h triangles, whose corners are the loops' and whose sides either are those of
-- loops or have a triangle on both sides.
--
-- A sweep finds some triangles ("PraTactile.Object.Triangulation.Sweep"). Then, with the metric
--
-- > |v|^2 = p v_x^2 + q v_y^2
--
-- the side a b between the triangles a b c and b a d is exchanged for c d as long as d lies within
-- the circle round a, b and c, that is, as long as
--
-- > | a_x - d_x   a_y - d_y   |a - d|^2 |
-- > | b_x - d_x   b_y - d_y   |b - d|^2 |  >  0
-- > | c_x - d_x   c_y - d_y   |c - d|^2 |
--
-- (Lawson 1977). Each exchange lowers the surface that the triangles make of the points lifted to
-- |v|^2, so that this ends; what it ends with is a constrained Delaunay triangulation, whose least
-- angle is the greatest that there is (Lee and Lin 1986).
module PraTactile.Object.Triangulation
  ( Metric (..),
    triangulation,
    inCircle,
  )
where

import qualified Data.IntMap.Strict as Map
import Data.List (foldl')
import qualified Data.Vector as V
import PraTactile.Object.Polygon (V2 (..), turn)
import PraTactile.Object.Triangulation.Sweep

-- | How long steps of one unit are along x and along y: the squares, both positive.
data Metric = Metric !Integer !Integer

-- | The triangles of the region of these loops, by the places of the corners among the points,
-- counter-clockwise. Each loop has three corners or more; no two sides meet but at the corner at
-- which one follows the other. O(n log n), and as much again for each time that a side is
-- exchanged.
triangulation :: Metric -> V.Vector V2 -> [[Int]] -> [(Int, Int, Int)]
triangulation metric points loops =
  [ (a, b, c)
    | (side, c) <- Map.toAscList (exchanged (Map.keys begun) begun),
      let (a, b) = side `quotRem` count,
      a < b,
      a < c
  ]
  where
    count = V.length points
    key a b = a * count + b
    begun = foldl' (flip along) Map.empty (swept points loops)
    along (a, b, c) = Map.insert (key a b) c . Map.insert (key b c) a . Map.insert (key c a) b
    -- A side of a loop has a triangle to its left alone.
    exchanged stack apexes = case stack of
      [] -> apexes
      side : others
        | Just c <- Map.lookup side apexes,
          Just d <- Map.lookup (key b a) apexes,
          inCircle metric (at a) (at b) (at c) (at d),
          turn (at a) (at d) (at c) > 0,
          turn (at d) (at b) (at c) > 0 ->
          exchanged
            (key a d : key d b : key b c : key c a : others)
            ( along (a, d, c) . along (d, b, c)
                . Map.delete side
                . Map.delete (key b a)
                $ apexes
            )
        | otherwise -> exchanged others apexes
        where
          (a, b) = side `quotRem` count
    at = (points V.!)

-- | Whether the fourth point lies within the circle round the others, which turn left.
inCircle :: Metric -> V2 -> V2 -> V2 -> V2 -> Bool
inCircle (Metric p q) (V2 ax ay) (V2 bx by) (V2 cx cy) (V2 dx dy) =
  minor (bx - dx) (by - dy) (cx - dx) (cy - dy) * square (ax - dx) (ay - dy)
    + minor (cx - dx) (cy - dy) (ax - dx) (ay - dy) * square (bx - dx) (by - dy)
    + minor (ax - dx) (ay - dy) (bx - dx) (by - dy) * square (cx - dx) (cy - dy)
    > 0
  where
    minor x y u v = x * v - y * u
    square x y = p * x * x + q * y * y
