-- | Leaves out faces whose corners lie nearly on one line: the triangles without area that
-- exporters of curved and trimmed surfaces produce.
--
-- > a --------- v ---- b        a --------- v ---- b
-- >  \\_______________/          |
-- >   a           b      ->      the face below is  .. b v a ..
-- >  the face below: .. b a ..
--
-- Such a face has sides along its line, between its corners in some order. A face across a side
-- from p to q passes it from q to p, and takes in the corners between these. Then each piece of the
-- line between neighbouring corners is passed as often in both directions as before, so the other
-- faces stay closed. A corner that is off the line moves to its projection on it.
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

-- | The result of leaving out slivers.
data Unslivered = Unslivered
  { -- | the remaining walks
    unsliveredWalks :: [Walk],
    -- | the vertices that move, with their new places in units of the polyhedron's coordinates
    unsliveredMoves :: IntMap.IntMap Q3
  }

-- | Leaves out faces whose corners are all within this many millimetres of the line between two of
-- them. All vertices of all walks must exist. O(n log n).
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
    -- A face that took in corners may become a sliver. Of slivers that lie on each other, one may
    -- go after another has.
    leftOut f slivers = case IntMap.lookup f (walksLeft slivers) of
      Just walk
        | onLine square it (moves slivers) (U.fromList walk),
          Just (next, into) <- without it f walk slivers ->
          foldl' (flip leftOut) next into
      _ -> slivers

-- | The remaining faces, the faces at each edge, and the vertices that moved.
data Slivers = Slivers
  { walksLeft :: IntMap.IntMap [Int],
    facesAt :: Map.Map (Int, Int) [Int],
    moves :: IntMap.IntMap Q3
  }

edge :: (Int, Int) -> (Int, Int)
edge (p, q) = (min p q, max p q)

-- | Leaves out one face, if all faces across its sides can take in the corners between. Also
-- returns the faces that may have to go next: those that took in corners, and those at edges that
-- now have two faces.
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
    -- A side from its start, with the corners between inserted if it is this one, in either
    -- direction.
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

-- | Gives a face another walk; with fewer than three corners the face is removed.
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

-- | A walk without repeated corners in succession, and without spikes, where a side is walked back
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

-- | Whether all corners of a face are near the line between two distinct ones of them. The first
-- argument is the square of the distance.
onLine :: Rational -> Mesh -> IntMap.IntMap Q3 -> Walk -> Bool
onLine square it moved walk
  | U.length walk < 3 = False
  | IntMap.null moved || not (U.any (`IntMap.member` moved) walk) = near (farthest whole)
  | otherwise = nearly (extremes place (U.toList walk))
  where
    -- In integers, which saves most of the time.
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

-- | Two corners that are far apart: the farthest from the first corner, and the farthest from that.
extremes :: (Int -> Q3) -> [Int] -> (Int, Int)
extremes place walk = (from, far from)
  where
    from = far (head' walk)
    far v = maximumBy (comparing (\w -> let d = place w `less` place v in inner d d)) walk
    head' vertices = case vertices of
      v : _ -> v
      [] -> 0
