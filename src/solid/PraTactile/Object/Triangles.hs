-- | Cuts faces into triangles, for files and views that need triangles.
module PraTactile.Object.Triangles
  ( triangles,
  )
where

import qualified Data.IntMap.Strict as Map
import Data.Maybe (isJust)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Crossing
import PraTactile.Object.Mesh
import PraTactile.Object.Polygon
import PraTactile.Object.Rims
import PraTactile.Object.Triangulation

-- | A face as triangles, each by its vertices counter-clockwise as the face is. Together they use
-- every vertex, and none has the area 0. A convex face is cut from its first vertex. So is a face
-- that crosses itself or has no area, for which nothing is promised. O(n) for a convex face, else
-- the cost of 'firstCrossing' and 'triangulation'.
triangles :: Mesh -> Walk -> [(Int, Int, Int)]
triangles it walk
  | count < 3 = []
  | count == 3 || convex || isJust (firstCrossing [walk] seen) =
    [(0, i, i + 1) `on` walk | i <- [1 .. count - 2]]
  | otherwise = map (`on` walk) (triangulation (Metric 1 1) seen loops)
  where
    points = cornersOf it walk
    seen = V.map (flat (doubleArea points)) points
    count = V.length seen
    numbered = [0 .. count - 1]
    loops = map (map (places Map.!)) (rims (U.toList walk))
    places = Map.fromList (zip (U.toList walk) numbered)
    convex =
      and [at i (i + 1) (i + 2) > 0 | i <- numbered]
        && and [at 0 i (i + 1) > 0 | i <- [1 .. count - 2]]
    at i j k = turn (corner i) (corner j) (corner k)
    corner i = seen V.! (i `mod` count)
    on (i, j, k) its = (its U.! i, its U.! j, its U.! k)
