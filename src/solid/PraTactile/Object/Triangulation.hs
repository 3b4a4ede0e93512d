-- | Triangulates plane regions exactly: polygons with any number of holes, pieces in the holes, and
-- so on. Among all triangulations it finds one whose smallest angle is greatest.
--
-- The region of some loops that do not meet is everything inside an odd number of them. Let there
-- be n corners; let o of the loops have the region on their inner side, and h of them on their
-- outer side. The region is cut into n - 2 o + 2 h triangles. Their corners are those of the loops;
-- each of their sides is a loop's or has a triangle on both sides.
--
-- A sweep finds an initial triangulation ("PraTactile.Object.Triangulation.Sweep"). Then, with the
-- metric
--
-- > |v|^2 = p v_x^2 + q v_y^2
--
-- the side a b between the triangles a b c and b a d is flipped to c d while d lies within the
-- circle through a, b and c, that is, while
--
-- > | a_x - d_x   a_y - d_y   |a - d|^2 |
-- > | b_x - d_x   b_y - d_y   |b - d|^2 |  >  0
-- > | c_x - d_x   c_y - d_y   |c - d|^2 |
--
-- (Lawson 1977). Each flip lowers the surface that the triangles make of the points lifted to
-- |v|^2, so this ends. The result is a constrained Delaunay triangulation, whose smallest angle is
-- the greatest possible (Lee and Lin 1986).
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

-- | The numbers p and q of the metric: the squared lengths of unit steps along x and along y, both
-- positive.
data Metric = Metric !Integer !Integer

-- | The triangles of the region of some loops, counter-clockwise, by the indices of their corners
-- among the points. Arguments: the metric in which angles are measured; the points; the loops, by
-- indices of points. Each loop must have at least three corners, and sides may meet only in the
-- corner between them; that is not checked. O(n log n), and as much for each flip of a side.
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
    -- A side of a loop has a triangle only on its left.
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

-- | Whether the fourth point lies within the circle, in this metric, through the first three, which
-- must be in counter-clockwise order.
inCircle :: Metric -> V2 -> V2 -> V2 -> V2 -> Bool
inCircle (Metric p q) (V2 ax ay) (V2 bx by) (V2 cx cy) (V2 dx dy) =
  minor (bx - dx) (by - dy) (cx - dx) (cy - dy) * square (ax - dx) (ay - dy)
    + minor (cx - dx) (cy - dy) (ax - dx) (ay - dy) * square (bx - dx) (by - dy)
    + minor (ax - dx) (ay - dy) (bx - dx) (by - dy) * square (cx - dx) (cy - dy)
    > 0
  where
    minor x y u v = x * v - y * u
    square x y = p * x * x + q * y * y
