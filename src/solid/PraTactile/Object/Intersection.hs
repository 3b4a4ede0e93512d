{-# OPTIONS_HADDOCK hide #-}

-- | The intersection of two faces, apart from vertices and sides that they have in common by name.
-- All computation is exact.
--
-- Let the faces A and B be polygons in their planes n_A . x = d_A and n_B . x = d_B. Let S be the
-- set of the points of vertices and sides that both faces name. Wanted are the common points of A
-- and B outside S, and the largest distance between two of them.
--
-- If the planes meet in a line along u = n_A x n_B, its points are numbered by t = u . x. Each face
-- cuts the line where the sign of s = n . x - d, with n and d of the other face's plane, changes
-- along the face's walk. Between two neighbouring cuts, all points of the line belong to the face
-- or none does. That is decided by the parity of the sides that cross the line after it is moved
-- slightly to one side. So on the line A, B and S are finite lists of points and open intervals,
-- and so is the result.
--
-- If the planes coincide, every extreme point of the result is a vertex of one face inside the
-- other, or a crossing of two sides. A vertex that both name is an extreme point if, near it, the
-- faces have more in common than their common sides.
module PraTactile.Object.Intersection
  ( Plate,
    plate,
    plateNormal,
    plateFlat,
    overlap,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.List (nub)
import Data.Maybe (mapMaybe)
import Data.Ratio ((%))
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Polygon
import PraTactile.Object.Vector

-- | A flat face.
data Plate = Plate
  { -- | the numbers of the vertices, in order around the face
    plateWalk :: !(U.Vector Int),
    -- | the points of these vertices
    plateCorners :: !(V.Vector V3),
    -- | a normal vector, as long as twice the area
    plateNormal :: !V3,
    -- | the d of the face's plane n . x = d
    plateOffset :: !Integer,
    -- | the indices of a vertex in the walk: one, and one more for each bridge to a hole that ends
    -- there. Used for walks of more than eight vertices.
    platePlaces :: IntMap.IntMap [Int]
  }

-- | A face. Arguments: the numbers of its vertices, in order; their points, in any unit; a normal
-- as long as twice the area.
plate :: U.Vector Int -> V.Vector V3 -> V3 -> Plate
plate walk points normal =
  Plate walk points normal (V.foldr (\p _ -> dot normal p) 0 points) places
  where
    places = IntMap.fromListWith (flip (++)) [(v, [i]) | (i, v) <- zip [0 ..] (U.toList walk)]

-- | The face in its plane, in the coordinates of 'flat'.
plateFlat :: Plate -> V.Vector V2
plateFlat it = V.map (flat (plateNormal it)) (plateCorners it)

-- | The number of corners.
corners :: Plate -> Int
corners = V.length . plateCorners

-- | The indices of a vertex in a face's walk.
placesOf :: Plate -> Int -> [Int]
placesOf it vertex
  | corners it <= 8 = U.toList (U.elemIndices vertex (plateWalk it))
  | otherwise = IntMap.findWithDefault [] vertex (platePlaces it)

-- | Whether a face names a vertex.
names :: Plate -> Int -> Bool
names it = not . null . placesOf it

-- | Whether a face has a side between the vertices, in either direction.
hasSide :: Plate -> Int -> Int -> Bool
hasSide it v w = any beside (placesOf it v)
  where
    beside i = at (i + 1) == w || at (i + corners it - 1) == w
    at i = plateWalk it U.! (i `mod` corners it)

-- | The square of the largest distance between two common points of the faces, other than the
-- points of vertices and sides that both faces name; 'Nothing' if there is no such point.
overlap :: Plate -> Plate -> Maybe Rational
overlap a b
  | corners a > corners b = overlap b a
  | touchesOnly a b heightsA || touchesOnly b a heightsB = Nothing
  | u == zero = inOnePlane a b
  | apartAtVertex u (a, heightsA) (b, heightsB) = Nothing
  | otherwise = onLine u (a, heightsA) (b, heightsB)
  where
    heightsA = heights b a
    heightsB = heights a b
    u = cross (plateNormal a) (plateNormal b)

-- | The heights of the second face's corners over the first face's plane, in the order of its walk
-- and up to a common factor. They are 0 for vertices that both faces name.
heights :: Plate -> Plate -> V.Vector Integer
heights under it = V.imap height (plateCorners it)
  where
    height i p
      | names under (plateWalk it U.! i) = 0
      | otherwise = dot (plateNormal under) p - plateOffset under

-- | Whether the first face lies on one side of the second face's plane, and touches the plane at
-- most in one vertex or one side that both faces name. The last argument is the first face's
-- 'heights'.
touchesOnly :: Plate -> Plate -> V.Vector Integer -> Bool
touchesOnly it other above = (V.all (>= 0) above || V.all (<= 0) above) && named
  where
    named = case [plateWalk it U.! i | i <- V.toList (V.findIndices (== 0) above)] of
      [] -> True
      [v] -> names other v
      [v, w] -> hasSide it v w && hasSide other v w
      _ -> False

-- | Whether two triangles certainly have only one vertex in common: both name it, and they leave it
-- in opposite directions along the line of their planes. Arguments: the direction of that line;
-- each face with its 'heights' over the other.
apartAtVertex :: V3 -> (Plate, V.Vector Integer) -> (Plate, V.Vector Integer) -> Bool
apartAtVertex u (a, heightsA) (b, heightsB) =
  case [(i, j) | i <- [0 .. corners a - 1], j <- placesOf b (plateWalk a U.! i)] of
    [(i, j)]
      | corners a == 3,
        corners b == 3 ->
        direction a heightsA i * direction b heightsB j < 0
    _ -> False
  where
    direction it above i
      | signum p * signum q < 0 = signum (abs q * along next + abs p * along next')
      | otherwise = 0
      where
        next = (i + 1) `mod` 3
        next' = (i + 2) `mod` 3
        p = above V.! next
        q = above V.! next'
        along k = dot u ((plateCorners it V.! k) `minus` (plateCorners it V.! i))

-- | The result of 'overlap' if the planes meet in a line. Arguments: the direction of that line;
-- each face with its 'heights' over the other.
onLine :: V3 -> (Plate, V.Vector Integer) -> (Plate, V.Vector Integer) -> Maybe Rational
onLine u (a, heightsA) (b, heightsB)
  | null left = Nothing
  | otherwise = Just ((maximum left - minimum left) ^ (2 :: Int) / fromInteger (dot u u))
  where
    cutA = cut u a heightsA
    cutB = cut u b heightsB
    places = distinct (cutPlaces cutA ++ cutPlaces cutB)
    left =
      [t | t <- places, held t cutA, held t cutB, not (mayBe t)]
        ++ concat
          [ [s, t]
            | (s, t) <- zip places (drop 1 places),
              let middle = (s + t) / 2,
              cutWithin cutA middle,
              cutWithin cutB middle,
              not (mayBe middle)
          ]
    held t it = t `elem` cutPlaces it || cutWithin it t
    mayBe t = t `elem` points || any (\(s, e) -> s <= t && t <= e) segments
    points = [param v | (i, v) <- onIt, names b (plateWalk a U.! i)]
    onIt = [(i, plateCorners a V.! i) | i <- V.toList (V.findIndices (== 0) heightsA)]
    segments =
      [ (min s t, max s t)
        | (i, v) <- onIt,
          let j = following heightsA i,
          heightsA V.! j == 0,
          hasSide b (plateWalk a U.! i) (plateWalk a U.! j),
          let s = param v
              t = param (plateCorners a V.! j)
      ]
    param v = fromInteger (dot u v)

-- | How a face cuts a line of its plane: the ascending places where the line may enter or leave the
-- face, and whether a place between two neighbouring ones belongs to the face.
data Cut = Cut {cutPlaces :: [Rational], cutWithin :: Rational -> Bool}

-- | How a face cuts the line in which its plane meets another. Arguments: the line's direction; the
-- face; its 'heights' over the other plane.
cut :: V3 -> Plate -> V.Vector Integer -> Cut
cut u it above = Cut (distinct (touching ++ mapMaybe strictly sides)) within
  where
    count = corners it
    sides =
      [ (above V.! i, dot u (plateCorners it V.! i), above V.! j, dot u (plateCorners it V.! j))
        | i <- [0 .. count - 1],
          let j = following above i
      ]
    touching = [fromInteger t | (0, t, _, _) <- sides]
    strictly (s, t, s', t')
      | signum s * signum s' < 0 = Just ((t' * s - t * s') % (s - s'))
      | otherwise = Nothing
    passing rule =
      [ if s == 0 then fromInteger t else if s' == 0 then fromInteger t' else place
        | (s, t, s', t') <- sides,
          rule s /= rule s',
          let place = (t' * s - t * s') % (s - s')
      ]
    below = passing (>= 0)
    over = passing (> 0)
    within t = odd (length (filter (< t) below)) || odd (length (filter (< t) over))

-- | The numbers in ascending order, each once.
distinct :: [Rational] -> [Rational]
distinct = Set.toAscList . Set.fromList

-- | The result of 'overlap' for two faces in one plane.
inOnePlane :: Plate -> Plate -> Maybe Rational
inOnePlane a b
  | lined a flatA b flatB || lined b flatB a flatA || null left = Nothing
  | otherwise = Just (maximum [squared p q | p <- left, q <- left])
  where
    normal = plateNormal a
    flatA = V.map (flat normal) (plateCorners a)
    flatB = V.map (flat normal) (plateCorners b)
    left =
      nub
        ( cornersLeft normal a flatA b flatB
            ++ cornersLeft normal b flatB a flatA
            ++ crossings
        )
    crossings =
      [ p
        | (i, j) <- sidesOf a,
          (k, l) <- sidesOf b,
          Just p <- [crossPoint (at a i) (at a j) (at b k) (at b l)]
      ]
    at it i = plateCorners it V.! i
    crossPoint p q r s
      | signum m * signum n < 0 && signum (turn r' s' p') * signum (turn r' s' q') < 0 =
        Just (mixed r s m n)
      | otherwise = Nothing
      where
        (p', q', r', s') = (flat normal p, flat normal q, flat normal r, flat normal s)
        m = turn p' q' r'
        n = turn p' q' s'
    mixed (V3 x y z) (V3 x' y' z') m n = (mix x x', mix y y', mix z z')
      where
        mix c c' = (c' * m - c * n) % (m - n)
    squared (x, y, z) (x', y', z') =
      (x - x') ^ (2 :: Int) + (y - y') ^ (2 :: Int) + (z - z') ^ (2 :: Int)

-- | The sides of a face, each by the indices of its two corners.
sidesOf :: Plate -> [(Int, Int)]
sidesOf it = [(i, following (plateCorners it) i) | i <- [0 .. corners it - 1]]

-- | Whether the line of a side of the first face has that face on one side and the other face on
-- the other side. Then they have at most a vertex or a side in common that both name. Each face
-- comes with its corners in the plane. At most eight sides are tried, so it may be false although
-- there is such a side.
lined :: Plate -> V.Vector V2 -> Plate -> V.Vector V2 -> Bool
lined a flatA b flatB = any separates (take 8 (sidesOf a))
  where
    separates (i, j) =
      let turns = V.map (turn (flatA V.! i) (flatA V.! j))
          own = turns flatA
          foreign' = turns flatB
       in ( (V.all (>= 0) own && V.all (<= 0) foreign')
              || (V.all (<= 0) own && V.all (>= 0) foreign')
          )
            && case [plateWalk b U.! k | k <- V.toList (V.findIndices (== 0) foreign')] of
              [] -> True
              [v] -> names a v
              [v, w] -> hasSide a v w && hasSide b v w
              _ -> False

-- | The corners of the first face that are extreme points of the result, as far as this can be
-- decided corner by corner. Arguments: the normal along which the plane is seen; each face with its
-- corners in the plane.
cornersLeft ::
  V3 -> Plate -> V.Vector V2 -> Plate -> V.Vector V2 -> [(Rational, Rational, Rational)]
cornersLeft seenAlong a flatA b flatB =
  [ (fromInteger x, fromInteger y, fromInteger z)
    | i <- [0 .. corners a - 1],
      let V3 x y z = plateCorners a V.! i,
      case placesOf b (plateWalk a U.! i) of
        [] -> standing flatB (flatA V.! i) /= Outside
        places -> any (moreAt i) places
  ]
  where
    -- At a common vertex, each face is an angle. They share a direction that is not along a common
    -- side.
    moreAt i j =
      any (strictly angleB) [fst angleA, snd angleA]
        || any (strictly angleA) [fst angleB, snd angleB]
        || sameWay (fst angleA) (fst angleB)
        || sameWay (snd angleA) (snd angleB)
        || alongOnly (fst angleA) (snd angleB)
        || alongOnly (snd angleA) (fst angleB)
      where
        o = flatA V.! i
        angleA = angle a flatA i
        angleB = angle b flatB j
        -- Counter-clockwise from the first of these neighbours to the second.
        angle it seen k
          | dot (plateNormal it) seenAlong > 0 = (next, previous)
          | otherwise = (previous, next)
          where
            next = neighbour (following seen k)
            previous = neighbour (if k == 0 then V.length seen - 1 else k - 1)
            neighbour m = (plateWalk it U.! m, seen V.! m)
        strictly (from, to) d = intoCorner o (snd from, snd to) (snd d)
        sameWay (_, p) (_, q) = turn o p q == 0 && inner o p q > 0
        alongOnly p q = sameWay p q && fst p /= fst q
