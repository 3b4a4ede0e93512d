-- | Faces cut into triangles, for the files that have no others: ears are cut off one by one
-- (Meisters 1975), exactly, so that no triangle is flat and no vertex is left out.
module PraTactile.Object.Triangles
  ( triangles,
  )
where

import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description (rotations)
import PraTactile.Object.Mesh
import PraTactile.Object.Polygon

-- | The face as triangles, by vertices, each counter-clockwise as the face is. A face that crosses
-- itself, or has no area, is cut from its first vertex. O(n) for a convex face, O(n^3) at worst.
triangles :: Mesh -> Walk -> [(Int, Int, Int)]
triangles it walk
  | U.length walk < 3 = []
  | U.length walk == 3 || convex = fan numbered
  | otherwise = ears numbered
  where
    points = cornersOf it walk
    seen = V.map (flat (doubleArea points)) points
    count = V.length seen
    numbered = [0 .. count - 1]
    convex =
      and [at i (i + 1) (i + 2) > 0 | i <- numbered]
        && and [at 0 i (i + 1) > 0 | i <- [1 .. count - 2]]
    at i j k = turn (corner i) (corner j) (corner k)
    corner i = seen V.! (i `mod` count)
    labelled i j k = (walk U.! i, walk U.! j, walk U.! k)
    fan (first : others) = zipWith (labelled first) others (drop 1 others)
    fan [] = []
    ears left = case [cut | cut <- rotations left, isEar cut] of
      _ | length left <= 3 -> fan left
      (p : q : r : others) : _ -> labelled p q r : ears (p : r : others)
      _ -> fan left
    isEar (p : q : r : others) = at p q r > 0 && not (any (within p q r) others)
    isEar _ = False
    within p q r o = at p q o >= 0 && at q r o >= 0 && at r p o >= 0
