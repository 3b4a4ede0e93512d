-- | Whether a polygon crosses itself, by a line that sweeps over its sides (Shamos and Hoey 1976).
--
-- The line comes from the left and is leant a little, so that points of one x are met in the order
-- of y. What it crosses is kept in order, from below. Two sides that meet become neighbours there
-- before the line is where they meet first; so it is enough to ask each pair that becomes
-- neighbours, and up to the first answer of yes the order is one. Exact, so that there is none of
-- the trouble that machine numbers have with it.
module PraTactile.Object.Crossing
  ( firstCrossing,
  )
where

import Control.Applicative ((<|>))
import Control.Monad (foldM)
import Data.List (find, sortOn)
import Data.Maybe (listToMaybe)
import qualified Data.Set as Set
import qualified Data.Vector as V
import PraTactile.Object.Polygon

-- | Of the sides of a closed walk, each by the place where it begins, the first that shares more
-- with one before it than a vertex at which one follows the other, and the first of those before
-- it: the lesser place first. O(n log n) where there is none, else O(n log^2 n).
--
-- >>> firstCrossing (V.fromList [V2 0 0, V2 2 2, V2 2 0, V2 0 2])
-- Just (0,2)
firstCrossing :: V.Vector V2 -> Maybe (Int, Int)
firstCrossing walk
  | count <= 3 = Nothing
  | count <= 8 = listToMaybe [(i, j) | j <- [1 .. count - 1], i <- earlier j]
  | otherwise = do
    found <- among count
    let j = least 0 found
    i <- listToMaybe (earlier j)
    pure (i, j)
  where
    count = V.length walk
    earlier j = [i | i <- [0 .. j - 1], share walk i j]
    -- Of two that meet among the first sides, so many, the one after the other.
    among = fmap (uncurry max) . meetingAmong walk (sortOn (walk V.!) [0 .. count - 1])
    -- The first sides, so many, do not meet; those up to the other place do.
    least clean met
      | clean == met = met
      | otherwise = maybe (least middle met) (least clean) (among middle)
      where
        middle = (clean + met + 1) `div` 2

-- | Whether two sides share more than a vertex at which one follows the other.
share :: V.Vector V2 -> Int -> Int -> Bool
share walk i j
  | following walk i == j = back (walk V.! i) (walk V.! j) (end j)
  | following walk j == i = back (walk V.! j) (walk V.! i) (end i)
  | otherwise = crossing (walk V.! i, end i) (walk V.! j, end j)
  where
    end k = walk V.! following walk k
    back a b c = turn a b c == 0 && inner b a c > 0

-- | Some two of the first sides, so many, that share more than that, if there are any; given the
-- places of the walk in the order in which the line meets them.
meetingAmong :: V.Vector V2 -> [Int] -> Int -> Maybe (Int, Int)
meetingAmong walk order sides =
  firstOf ([(i, i + 1) | i <- [0 .. sides - 2]] ++ [(0, sides - 1) | whole])
    <|> firstOf (concat (zipWith atOnePoint met (drop 1 met)))
    <|> either Just (const Nothing) (foldM step Set.empty met)
  where
    whole = sides == V.length walk
    met = if whole then order else filter (<= sides) order
    firstOf = find (uncurry (share walk))
    atOnePoint v w
      | walk V.! v == walk V.! w = [(i, j) | i <- endingAt v, j <- endingAt w, i /= j]
      | otherwise = []
    -- Those that end or begin at a place of the walk.
    endingAt v = filter (< sides) [if v == 0 then V.length walk - 1 else v - 1, v]
    -- A side that is a point meets what its neighbours meet.
    sidesAt v =
      [ Side i (min a b) (max a b)
        | i <- endingAt v,
          let (a, b) = (walk V.! i, walk V.! following walk i),
          a /= b
      ]
    step crossed v = do
      left <- foldM close crossed (filter ((== walk V.! v) . to) (sidesAt v))
      foldM open left (filter ((== walk V.! v) . from) (sidesAt v))
    close crossed s = do
      apart (Set.lookupLT s crossed) (Set.lookupGT s crossed)
      pure (Set.delete s crossed)
    -- One along which it lies is equal to it.
    open crossed s = do
      apart (Set.lookupLE s crossed) (Just s)
      apart (Just s) (Set.lookupGT s crossed)
      pure (Set.insert s crossed)
    apart below above = case (,) <$> below <*> above of
      Just (s, t) | share walk (number s) (number t) -> Left (number s, number t)
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
