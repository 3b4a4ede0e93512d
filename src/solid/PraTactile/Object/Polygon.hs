-- | Polygons in a plane, exactly: crossings of sides, and points inside.
module PraTactile.Object.Polygon
  ( -- * Points of a plane
    V2 (..),
    flat,
    turn,
    inner,
    between,
    intoCorner,

    -- * Sides
    crossing,

    -- * What a polygon holds
    PointLocation (..),
    standing,
    following,
  )
where

import Data.Foldable (toList)
import Data.List (find)
import qualified Data.Vector as V
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Vector (V3 (..))

-- | A point of a plane.
data V2 = V2 !Integer !Integer
  deriving stock (Eq, Ord, Show)

-- | Projects points of a plane with this normal along an axis that is not parallel to it. Lines
-- stay lines, and counter-clockwise about the normal stays counter-clockwise.
flat :: V3 -> V3 -> V2
flat (V3 nx ny nz)
  | abs nz >= abs nx && abs nz >= abs ny = \(V3 x y _) -> if nz > 0 then V2 x y else V2 y x
  | abs nx >= abs ny = \(V3 _ y z) -> if nx > 0 then V2 y z else V2 z y
  | otherwise = \(V3 x _ z) -> if ny > 0 then V2 z x else V2 x z

-- | Twice the signed area of a triangle: positive if the path turns left at the second point.
turn :: V2 -> V2 -> V2 -> Integer
turn (V2 ax ay) (V2 bx by) (V2 cx cy) = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

-- | The scalar product of the vectors from the first point to the others.
inner :: V2 -> V2 -> V2 -> Integer
inner (V2 ox oy) (V2 ax ay) (V2 bx by) = (ax - ox) * (bx - ox) + (ay - oy) * (by - oy)

-- | Whether the third point is on the segment between the others, ends included.
between :: V2 -> V2 -> V2 -> Bool
between a b p = turn a b p == 0 && inner p a b <= 0

-- | Whether the direction from a corner to the last point is strictly inside an angle: from the
-- first direction of the pair, counter-clockwise, to the second.
intoCorner :: V2 -> (V2, V2) -> V2 -> Bool
intoCorner o (from, to) p
  | way > 0 = turn o from p > 0 && turn o p to > 0
  | way == 0 = turn o from p > 0
  | otherwise = not (turn o to p >= 0 && turn o p from >= 0)
  where
    way = turn o from to

-- | Whether two segments have a point in common.
crossing :: (V2, V2) -> (V2, V2) -> Bool
crossing (a, b) (c, d) =
  (opposite (turn a b c) (turn a b d) && opposite (turn c d a) (turn c d b))
    || between a b c
    || between a b d
    || between c d a
    || between c d b
  where
    opposite m n = signum m * signum n < 0

-- | The next index of a cycle.
following :: V.Vector a -> Int -> Int
following walk i = if i + 1 == V.length walk then 0 else i + 1

-- | The place of a point relative to a polygon.
data PointLocation = Outside | OnRim | Inside
  deriving stock (Eq, Show)

-- | The place of a point relative to a polygon that does not cross itself.
standing :: V.Vector V2 -> V2 -> PointLocation
standing walk p@(V2 _ y)
  | Just _ <- find (\(a, b) -> between a b p) sides = OnRim
  | odd (length (filter passes sides)) = Inside
  | otherwise = Outside
  where
    sides = cyclicPairs (toList walk)
    -- A ray to the right meets the side; one end of a side belongs to it.
    passes (a@(V2 _ ay), b@(V2 _ by))
      | (ay > y) == (by > y) = False
      | by > ay = turn a b p > 0
      | otherwise = turn a b p < 0
