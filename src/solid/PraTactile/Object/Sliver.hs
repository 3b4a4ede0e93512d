-- | Faces whose corners lie on one line, nearly, left out: the triangles without area that
-- exporters of curved and trimmed surfaces leave behind.
--
-- > a --------- v ---- b        a --------- v ---- b
-- >  \\_______________/          |
-- >   a           b      ->      the face below is  .. b v a ..
-- >  the face below: .. b a ..
--
-- Such a face has sides along its line, between corners in some order. What lies across a side from
-- p to q, and takes it from q to p, takes there the corners between these as well. Each piece of
-- the line from one corner to the next is then passed as often in both directions as before, so
-- that the other faces close where they did. A corner that is off the line goes to its foot on it.
module PraTactile.Object.Sliver
  ( withoutSlivers,
    Unslivered (..),
    tidied,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', maximumBy, sortOn)
import qualified Data.Map.Strict as Map
import Data.Ord (comparing)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Mesh
import PraTactile.Object.Vector
import PraTactile.Object.VectorQ

-- | What comes of it.
data Unslivered = Unslivered
  { -- | the walks that are left
    unsliveredWalks :: [Walk],
    -- | vertices that go to other places, in units of the polyhedron's coordinates
    unsliveredMoves :: IntMap.IntMap Q3
  }

-- | Leaves faces out whose corners lie no further than so many millimetres from the line between
-- two of them. All vertices of all walks must be there. O(n log n).
withoutSlivers :: Rational -> Mesh -> Unslivered
withoutSlivers mm it
  | null suspects = Unslivered (V.toList (meshWalks it)) IntMap.empty
  | otherwise = finished (foldl' (flip leftOut) begun suspects)
  where
    square = (mm * fromInteger (meshDenominator it)) ^ (2 :: Int)
    suspects = V.toList (V.findIndices (onLine square it IntMap.empty) (meshWalks it))
    begun =
      Slivers
        (IntMap.fromList (zip [0 ..] (map U.toList (V.toList (meshWalks it)))))
        ( Map.fromListWith
            (flip (++))
            [ (edge side, [f])
              | (f, walk) <- zip [0 ..] (V.toList (meshWalks it)),
                side <- cyclicPairs (U.toList walk)
            ]
        )
        IntMap.empty
    finished slivers =
      Unslivered (map U.fromList (IntMap.elems (walksLeft slivers))) (moves slivers)
    -- A face that took corners may lie on a line after that, and of slivers that lie on each other
    -- one can go once another has.
    leftOut f slivers = case IntMap.lookup f (walksLeft slivers) of
      Just walk
        | onLine square it (moves slivers) (U.fromList walk),
          Just (next, into) <- without it f walk slivers ->
          foldl' (flip leftOut) next into
      _ -> slivers

-- | The faces that are left, the faces at each edge, and the vertices that moved.
data Slivers = Slivers
  { walksLeft :: IntMap.IntMap [Int],
    facesAt :: Map.Map (Int, Int) [Int],
    moves :: IntMap.IntMap Q3
  }

edge :: (Int, Int) -> (Int, Int)
edge (p, q) = (min p q, max p q)

-- | Without one face, where all that lies across its sides can take the corners between; and the
-- faces that may have to go after that: those that took some, and those at edges that have two
-- faces now.
without :: Mesh -> Int -> [Int] -> Slivers -> Maybe (Slivers, [Int])
without it f walk slivers
  | distinct (map snd order), Just mates <- traverse mate needed = Just (taken mates)
  | otherwise = Nothing
  where
    place v = IntMap.findWithDefault (exactly (meshPoints it V.! v)) v (moves slivers)
    (from, to) = extremes place walk
    along v = inner (place v `less` place from) (place to `less` place from)
    order = sortOn snd [(v, along v) | v <- walk]
    distinct values = and (zipWith (/=) values (drop 1 values))
    between (p, q)
      | along p <= along q = inside (along p) (along q)
      | otherwise = reverse (inside (along q) (along p))
    inside least most = [v | (v, t) <- order, least < t, t < most]
    needed = [(side, between side) | side <- cyclicPairs walk, not (null (between side))]
    mate (side, corners) = case Map.lookup (edge side) (facesAt slivers) of
      Just faces | [g] <- filter (/= f) faces -> Just (g, side, corners)
      _ -> Nothing
    taken mates =
      ( after,
        [g | (g, _, _) <- mates]
          ++ [ g
               | side <- cyclicPairs walk,
                 Just both@[_, _] <- [Map.lookup (edge side) (facesAt after)],
                 g <- both
             ]
      )
      where
        after = foldl' put gone {moves = feet `IntMap.union` moves gone} mates
    gone = replaced f [] slivers
    put now (g, side, corners) = case IntMap.lookup g (walksLeft now) of
      Just old -> replaced g (tidied (concatMap (inserted side corners) (cyclicPairs old))) now
      Nothing -> now
    -- A side from its beginning on, with those between where it is this one, whichever way.
    inserted (p, q) corners (a, b)
      | (a, b) == (p, q) = a : corners
      | (a, b) == (q, p) = a : reverse corners
      | otherwise = [a]
    feet =
      IntMap.fromList
        [ (v, foot)
          | (v, t) <- drop 1 (take (length order - 1) order),
            let foot = place from `plusTimes` (t / inner line line, line),
            foot /= place v
        ]
    line = place to `less` place from

-- | A face with another walk; with one of fewer than three corners it goes.
replaced :: Int -> [Int] -> Slivers -> Slivers
replaced f walk slivers =
  slivers
    { walksLeft =
        if length walk < 3
          then IntMap.delete f (walksLeft slivers)
          else IntMap.insert f walk (walksLeft slivers),
      facesAt = foldl' added (foldl' removed (facesAt slivers) (sidesOf before)) (sidesOf now)
    }
  where
    before = IntMap.findWithDefault [] f (walksLeft slivers)
    now = if length walk < 3 then [] else walk
    sidesOf given = map edge (cyclicPairs given)
    removed found side = Map.adjust (withoutFirst f) side found
    added found side = Map.insertWith (++) side [f] found
    withoutFirst a list = let (front, rest) = break (== a) list in front ++ drop 1 rest

-- | A walk without corners that follow themselves, and without spikes, where a side is walked back
-- at once.
--
-- >>> tidied [1, 2, 2, 3, 4, 3]
-- [1,2,3]
tidied :: [Int] -> [Int]
tidied walk
  | shorter == walk = walk
  | otherwise = tidied shorter
  where
    shorter = case break bad (zip3 (rotated (n - 1)) walk (rotated 1)) of
      (_, []) -> walk
      (good, (_, v, after) : _)
        | v == after -> [a | (i, a) <- zip [0 ..] walk, i /= length good]
        | otherwise ->
          [a | (i, a) <- zip [0 ..] walk, i /= length good, i /= (length good + 1) `mod` n]
    n = length walk
    rotated k = drop k walk ++ take k walk
    bad (before, v, after) = n > 1 && (v == after || before == after)

-- | Whether all corners lie so near to the line between two of them, whose distance from each other
-- is not 0; the first argument is the square of the distance.
onLine :: Rational -> Mesh -> IntMap.IntMap Q3 -> Walk -> Bool
onLine square it moved walk
  | U.length walk < 3 = False
  | IntMap.null moved || not (U.any (`IntMap.member` moved) walk) = near (farthest whole)
  | otherwise = nearly (extremes place (U.toList walk))
  where
    -- Of whole numbers, which is most of all there is.
    points = cornersOf it walk
    whole = firstOf points
    farthest from = V.maximumBy (comparing (\p -> let d = p `minus` from in dot d d)) points
    near from =
      let line = farthest from `minus` from
       in line /= zero
            && V.all
              ( \p ->
                  let off = cross line (p `minus` from)
                   in fromInteger (dot off off) <= square * fromInteger (dot line line)
              )
              points
    place v = IntMap.findWithDefault (exactly (meshPoints it V.! v)) v moved
    nearly (from, to) =
      let line = place to `less` place from
          off v =
            let d = place v `less` place from
             in inner d d - inner d line ^ (2 :: Int) / inner line line
       in inner line line > 0 && U.all ((<= square) . off) walk

-- | Two corners that are far from each other: the farthest from the first one, and the farthest
-- from that.
extremes :: (Int -> Q3) -> [Int] -> (Int, Int)
extremes place walk = (from, far from)
  where
    from = far (head' walk)
    far v = maximumBy (comparing (\w -> let d = place w `less` place v in inner d d)) walk
    head' vertices = case vertices of
      v : _ -> v
      [] -> 0
