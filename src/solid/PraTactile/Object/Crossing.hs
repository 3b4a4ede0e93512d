-- | Decides whether polygons cross themselves or each other, by a sweep line over their sides
-- (Shamos and Hoey 1976).
--
-- The line comes from the left and is slightly tilted, so that points with equal x are met in the
-- order of y. The sides that it crosses are kept in order from below. Two sides that meet become
-- neighbours in that order before the line reaches their first common point. So it suffices to test
-- each pair that becomes neighbours, and the order is consistent up to the first hit. Arithmetic is
-- exact, which avoids the usual problems with machine numbers.
module PraTactile.Object.Crossing
  ( firstCrossing,
    firstWithin,
  )
where

import Control.Applicative ((<|>))
import Control.Monad (foldM)
import Data.List (find, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Polygon

-- | The first side of closed walks that meets an earlier one, other than in a vertex that both
-- name, together with the first such earlier side. Sides are given by the places where they begin;
-- the smaller place comes first. A side may occur once in each direction. Places number the
-- vertices of all walks, one walk after the other; the vector gives their points. 'Nothing' if no
-- sides meet. O(n log n) in that case, else O(n log^2 n).
--
-- >>> firstCrossing [U.fromList [0, 1, 2, 3]] (V.fromList [V2 0 0, V2 2 2, V2 2 0, V2 0 2])
-- Just (0,2)
firstCrossing :: [U.Vector Int] -> V.Vector V2 -> Maybe (Int, Int)
firstCrossing walks points
  | count <= 3 = Nothing
  | count <= 8 = listToMaybe [(i, j) | j <- [1 .. count - 1], i <- earlier j]
  | otherwise = do
    found <- among count
    let j = least 0 found
    i <- listToMaybe (earlier j)
    pure (i, j)
  where
    it = loopsOf walks points
    count = V.length points
    earlier j = [i | i <- [0 .. j - 1], share it i j]
    -- Finds two sides that meet among the first sides, in ascending order.
    among = fmap (uncurry max) . meetingAmong it (sortOn (points V.!) [0 .. count - 1])
    -- The first sides up to one number do not meet; those up to the other do.
    least clean met
      | clean == met = met
      | otherwise = maybe (least middle met) (least clean) (among middle)
      where
        middle = (clean + met + 1) `div` 2

-- | For a closed walk that does not cross itself: the first corner that has another corner's second
-- side within it, as the two places in ascending order. Arguments: the walk's vertices and the
-- points at its places. A walk that visits a vertex again must not lie between its own sides there.
firstWithin :: U.Vector Int -> V.Vector V2 -> Maybe (Int, Int)
firstWithin walk points
  | Map.null again = Nothing
  | otherwise =
    listToMaybe
      [ (min i j, max i j)
        | j <- [0 .. V.length points - 1],
          i <- Map.findWithDefault [] (walk U.! j) again,
          i /= j,
          intoCorner (points V.! j) (points V.! after i, points V.! before i) (points V.! after j)
      ]
  where
    again =
      Map.filter
        ((> 1) . length)
        (Map.fromListWith (flip (++)) [(v, [i]) | (i, v) <- zip [0 ..] (U.toList walk)])
    after i = if i + 1 == U.length walk then 0 else i + 1
    before i = if i == 0 then U.length walk - 1 else i - 1

-- | Closed walks by places: the vertex and the point of each place, and the places after and before
-- it on its walk.
data Loops = Loops
  { vertexOf :: !(U.Vector Int),
    pointOf :: !(V.Vector V2),
    afterIt :: !(U.Vector Int),
    beforeIt :: !(U.Vector Int)
  }

-- | Closed walks by the numbers of their vertices, with the point at each place.
loopsOf :: [U.Vector Int] -> V.Vector V2 -> Loops
loopsOf walks points = Loops (U.concat walks) points (beside 1) (beside (-1))
  where
    beside step =
      U.concat
        [ U.generate size (\k -> begin + (k + step) `mod` size)
          | (begin, size) <- zip (scanl (+) 0 sizes) sizes
        ]
    sizes = map U.length walks

-- | The ends of the side that begins at a place.
ends :: Loops -> Int -> (V2, V2)
ends it i = (pointOf it V.! i, pointOf it V.! (afterIt it U.! i))

-- | Whether two sides meet other than in a vertex that both name.
share :: Loops -> Int -> Int -> Bool
share it i j
  | a == d = b /= c && back p q r
  | b == c = back q p s
  | a == c = back p q s
  | b == d = back q p r
  | otherwise = crossing (p, q) (r, s)
  where
    (a, b) = (vertexOf it U.! i, vertexOf it U.! (afterIt it U.! i))
    (c, d) = (vertexOf it U.! j, vertexOf it U.! (afterIt it U.! j))
    ((p, q), (r, s)) = (ends it i, ends it j)
    back o x y = turn o x y == 0 && inner o x y > 0

-- | Some two of the first sides that meet other than in a vertex that both name, if there are any.
-- The list has the places in the order in which the line meets them; the number is how many sides
-- count.
meetingAmong :: Loops -> [Int] -> Int -> Maybe (Int, Int)
meetingAmong it order sides =
  firstOf [(min i j, max i j) | i <- [0 .. sides - 1], let j = afterIt it U.! i, j < sides]
    <|> firstOf (concat (zipWith atOnePoint met (drop 1 met)))
    <|> either Just (const Nothing) (foldM step Set.empty met)
  where
    met = filter (\v -> v < sides || beforeIt it U.! v < sides) order
    at = (pointOf it V.!)
    firstOf = find (uncurry (share it))
    atOnePoint v w
      | at v == at w = [(i, j) | i <- endingAt v, j <- endingAt w, i /= j]
      | otherwise = []
    -- The sides that end or begin at a place.
    endingAt v = filter (< sides) [beforeIt it U.! v, v]
    -- A side of length 0 meets whatever its neighbours meet.
    sidesAt v =
      [Side i (min a b) (max a b) | i <- endingAt v, let (a, b) = ends it i, a /= b]
    step crossed v = do
      left <- foldM close crossed (filter ((== at v) . to) (sidesAt v))
      foldM open left (filter ((== at v) . from) (sidesAt v))
    close crossed s = do
      apart (Set.lookupLT s crossed) (Set.lookupGT s crossed)
      pure (Set.delete s crossed)
    -- A side along which it lies compares equal to it.
    open crossed s = do
      apart (Set.lookupLE s crossed) (Just s)
      apart (Just s) (Set.lookupGT s crossed)
      pure (Set.insert s crossed)
    apart below above = case (,) <$> below <*> above of
      Just (s, t) | share it (number s) (number t) -> Left (number s, number t)
      _ -> Right ()

-- | A side of a walk, from its left end to its right end.
data Side = Side
  { number :: !Int,
    from :: !V2,
    to :: !V2
  }

instance Eq Side where
  s == t = compare s t == EQ

-- | The order from below, for sides that the line crosses and that do not meet before it.
instance Ord Side where
  compare s t
    | number s == number t = EQ
    | from s >= from t = s `over` t
    | otherwise = compare EQ (t `over` s)
    where
      over one other = side (from one) <> side (to one)
        where
          side p = compare (turn (from other) (to other) p) 0
