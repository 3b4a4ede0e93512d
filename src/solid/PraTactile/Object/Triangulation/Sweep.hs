{-# OPTIONS_HADDOCK hide #-}

-- | An initial triangulation of a plane region, by a sweep line (Hertel and Mehlhorn 1983).
--
-- Points are met in the order of x, then y. Behind the line lie triangles. Between them and the
-- line, each part of the region that the line crosses has a chain. It goes from the start of the
-- part's lower side up to the start of its upper side. To the right of the last point met, the
-- chain has no points:
--
-- >      c_m -------- upper side
-- >       \
-- >        c_k   the last one met       |
-- >       /                             | the line
-- >      c_1                            |
-- >       \                             |
-- >      c_0 -------- lower side
--
-- A new point p makes triangles with all c_i, c_(i+1) that it sees: those with turn(c_i, p,
-- c_(i+1)) > 0, next to where it touches the chain. It starts from the lower end if it ends the
-- lower side, from the upper end if it ends the upper side, and both ways from c_k if it is a new
-- loop's first point. Up to c_k the chain turns left or goes straight at each point, and also after
-- it. So p sees each such side entirely.
module PraTactile.Object.Triangulation.Sweep
  ( swept,
  )
where

import Data.List (foldl', sortOn)
import Data.Sequence (Seq, (<|), (|>))
import qualified Data.Sequence as Seq
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Polygon (V2 (..), turn)

-- | A part of the region that the line crosses. Points are numbered in the order in which they are
-- met.
data SweepRegion = SweepRegion
  { -- | the lower side, from its start to its end
    lower :: !(Int, Int),
    -- | the upper side, from its start to its end
    upper :: !(Int, Int),
    -- | the chain, from the start of the lower side to that of the upper one
    chain :: !(Seq Int),
    -- | the index in the chain of the last point met
    latest :: !Int
  }

-- | The triangles of a region, as for 'PraTactile.Object.Triangulation.triangulation', but not
-- optimised.
swept :: V.Vector V2 -> [[Int]] -> [(Int, Int, Int)]
swept points loops =
  [(met a, met b, met c) | (a, b, c) <- snd (foldl' step (Seq.empty, []) [0 .. U.length order - 1])]
  where
    order = U.fromList (sortOn (points V.!) (concat loops))
    met = (order U.!)
    ranks = U.replicate (V.length points) 0 U.// zip (U.toList order) [0 ..]
    at rank = points V.! met rank
    before = beside [(b, a) | loop <- loops, (a, b) <- cyclicPairs loop]
    after = beside [(a, b) | loop <- loops, (a, b) <- cyclicPairs loop]
    beside sides =
      U.replicate (U.length order) 0 U.// [(ranks U.! a, ranks U.! b) | (a, b) <- sides]
    step (parts, made) p
      | l > p && r > p = case under of
        Just part | below (upper part) -> split part
        _ ->
          ( Seq.insertAt count (SweepRegion (p, first) (p, second) (Seq.singleton p) 0) parts,
            made
          )
      | l < p && r < p = case under of
        Just part
          | snd (lower part) == p && snd (upper part) == p ->
            (Seq.deleteAt (count - 1) parts, snd (fromBelow part) ++ made)
          | Just other <- Seq.lookup (count - 2) parts -> merged other part
        _ -> (parts, made)
      | otherwise = case under of
        Just part
          | snd (lower part) == p ->
            let (left, new) = fromBelow part
             in (put part {lower = (p, max l r), chain = p <| left, latest = 0}, new ++ made)
          | otherwise ->
            let (left, new) = fromAbove part
             in ( put part {upper = (p, max l r), chain = left |> p, latest = Seq.length left},
                  new ++ made
                )
        Nothing -> (parts, made)
      where
        (l, r) = (before U.! p, after U.! p)
        -- The lower and the upper of two sides that begin here.
        (first, second) = if turn (at p) (at l) (at r) > 0 then (l, r) else (r, l)
        -- The number of parts whose lower side is below the point or ends there.
        count = search 0 (Seq.length parts)
        search from to
          | from == to = from
          | lowerSideBelow (Seq.index parts middle) = search (middle + 1) to
          | otherwise = search from middle
          where
            middle = (from + to) `div` 2
        lowerSideBelow part = let (a, b) = lower part in turn (at a) (at b) (at p) >= 0
        below (a, b) = turn (at a) (at b) (at p) < 0
        under = Seq.lookup (count - 1) parts
        put part = Seq.update (count - 1) part parts
        sees a b = turn (at a) (at p) (at b) > 0
        fromBelow part = go (chain part) []
          where
            go left new = case left of
              a Seq.:<| others@(b Seq.:<| _) | sees a b -> go others ((a, p, b) : new)
              _ -> (left, new)
        fromAbove part = go (chain part) []
          where
            go left new = case left of
              others@(_ Seq.:|> a) Seq.:|> b | sees a b -> go others ((a, p, b) : new)
              _ -> (left, new)
        split part =
          ( Seq.insertAt count high (put low),
            snd (fromAbove part {chain = left}) ++ snd (fromBelow part {chain = right}) ++ made
          )
          where
            left = Seq.take (latest part + 1) (chain part)
            right = Seq.drop (latest part) (chain part)
            leftKept = fst (fromAbove part {chain = left})
            rightKept = fst (fromBelow part {chain = right})
            low = SweepRegion (lower part) (p, first) (leftKept |> p) (Seq.length leftKept)
            high = SweepRegion (p, second) (upper part) (p <| rightKept) 0
        merged low high =
          ( Seq.update (count - 2) joined (Seq.deleteAt (count - 1) parts),
            newBelow ++ newAbove ++ made
          )
          where
            (leftKept, newBelow) = fromAbove low
            (rightKept, newAbove) = fromBelow high
            joined =
              SweepRegion
                (lower low)
                (upper high)
                ((leftKept |> p) <> rightKept)
                (Seq.length leftKept)
