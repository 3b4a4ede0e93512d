-- | Whether polygons cross themselves or each other, by a line that sweeps over their sides (Shamos
-- and Hoey 1976).
--
-- The line comes from the left and is leant a little, so that points of one x are met in the order
-- of y. What it crosses is kept in order, from below. Two sides that meet become neighbours there
-- before the line is where they meet first; so it is enough to ask each pair that becomes
-- neighbours, and up to the first answer of yes the order is one. Exact, so that there is none of
-- the trouble that machine numbers have with it.
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

-- | Of the sides of closed walks, each by the place where it begins, the first that shares more
-- with one before it than a vertex that both name, and the first of those before it: the lesser
-- place first. A side may be gone once in each direction. The places are those of all vertices, one
-- walk after the other, with the points at which they are. O(n log n) where there is none, else
-- O(n log^2 n).
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
    -- Of two that meet among the first sides, so many, the one after the other.
    among = fmap (uncurry max) . meetingAmong it (sortOn (points V.!) [0 .. count - 1])
    -- The first sides, so many, do not meet; those up to the other place do.
    least clean met
      | clean == met = met
      | otherwise = maybe (least middle met) (least clean) (among middle)
      where
        middle = (clean + met + 1) `div` 2

-- | Of the corners of a closed walk, which does not cross itself, the first that has another one's
-- second side within it, by the places of the two, the lesser first: where the walk comes to a
-- vertex again it must not lie between its own sides.
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

-- | Closed walks, by places: which vertex is there, at which point, and the places after and before
-- it.
data Loops = Loops
  { vertexOf :: !(U.Vector Int),
    pointOf :: !(V.Vector V2),
    afterIt :: !(U.Vector Int),
    beforeIt :: !(U.Vector Int)
  }

loopsOf :: [U.Vector Int] -> V.Vector V2 -> Loops
loopsOf walks points = Loops (U.concat walks) points (beside 1) (beside (-1))
  where
    beside step =
      U.concat
        [ U.generate size (\k -> begin + (k + step) `mod` size)
          | (begin, size) <- zip (scanl (+) 0 sizes) sizes
        ]
    sizes = map U.length walks

-- | The ends of a side.
ends :: Loops -> Int -> (V2, V2)
ends it i = (pointOf it V.! i, pointOf it V.! (afterIt it U.! i))

-- | Whether two sides share more than a vertex that both name.
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

-- | Some two of the first sides, so many, that share more than that, if there are any; given the
-- places in the order in which the line meets them.
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
    -- Those that end or begin at a place.
    endingAt v = filter (< sides) [beforeIt it U.! v, v]
    -- A side that is a point meets what its neighbours meet.
    sidesAt v =
      [Side i (min a b) (max a b) | i <- endingAt v, let (a, b) = ends it i, a /= b]
    step crossed v = do
      left <- foldM close crossed (filter ((== at v) . to) (sidesAt v))
      foldM open left (filter ((== at v) . from) (sidesAt v))
    close crossed s = do
      apart (Set.lookupLT s crossed) (Set.lookupGT s crossed)
      pure (Set.delete s crossed)
    -- One along which it lies is equal to it.
    open crossed s = do
      apart (Set.lookupLE s crossed) (Just s)
      apart (Just s) (Set.lookupGT s crossed)
      pure (Set.insert s crossed)
    apart below above = case (,) <$> below <*> above of
      Just (s, t) | share it (number s) (number t) -> Left (number s, number t)
      _ -> Right ()

-- | A side of a walk, from its left end to its right one.
data Side = Side
  { number :: !Int,
    from :: !V2,
    to :: !V2
  }

instance Eq Side where
  s == t = compare s t == EQ

-- | From below, of sides that the line crosses and that do not meet before it.
instance Ord Side where
  compare s t
    | number s == number t = EQ
    | from s >= from t = s `over` t
    | otherwise = compare EQ (t `over` s)
    where
      over one other = side (from one) <> side (to one)
        where
          side p = compare (turn (from other) (to other) p) 0
