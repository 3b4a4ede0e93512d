-- | Faces with holes. Such a face is still one walk: it goes around the outer rim, along a /bridge/
-- to a hole, around the hole in the other direction, and back along the bridge.
--
-- >  4 --------------- 3
-- >  |     8 --- 7     |
-- >  |     |     |     |      1 2 3 4 1 5 8 7 6 5
-- >  |     5 --- 6     |      the bridge: 1 5
-- >  |   /             |
-- >  1 --------------- 2
--
-- So areas, angles, and the parity of crossed sides are those of any walk. Only functions that need
-- the boundary of a face leave the bridges out ('rimPairs').
module PraTactile.Object.Rims
  ( rimPairs,
    rims,
    cyclesFrom,
    beginnings,
    onlyBridged,
    bridged,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, listToMaybe)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Crossing
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Mesh
import PraTactile.Object.Polygon
import PraTactile.Object.Triangulation
import PraTactile.Object.Vector

-- | The sides of a closed walk without its bridges, which it passes in both directions.
--
-- >>> rimPairs "adefdabc"
-- [('d','e'),('e','f'),('f','d'),('a','b'),('b','c'),('c','a')]
rimPairs :: Ord a => [a] -> [(a, a)]
rimPairs walk
  | Set.size (Set.fromList walk) == length walk = sides
  | otherwise = [(a, b) | (a, b) <- sides, Set.notMember (b, a) known]
  where
    sides = cyclicPairs walk
    known = Set.fromList sides

-- | The rims that a walk with bridges goes around, each once and in its direction. The walk must
-- visit vertices more than once only along bridges ('onlyBridged').
--
-- >>> rims [1, 2, 3, 4, 1, 5, 8, 7, 6, 5]
-- [[1,2,3,4],[5,8,7,6]]
rims :: Ord a => [a] -> [[a]]
rims walk = cyclesFrom (`Map.lookup` Map.fromList sides) (map fst sides)
  where
    sides = rimPairs walk

-- | The cycles that contain these elements, each once and from its first listed element. The
-- function gives an element's successor.
cyclesFrom :: Ord a => (a -> Maybe a) -> [a] -> [[a]]
cyclesFrom after begins = case begins of
  [] -> []
  a : others ->
    let cycle' = a : takeWhile (/= a) (follow a)
        seen = Set.fromList cycle'
     in cycle' : cyclesFrom after (filter (`Set.notMember` seen) others)
  where
    follow a = maybe [] (\b -> b : follow b) (after a)

-- | The indices of a walk at which it arrives along a rim: one for each vertex, sorted by rim.
--
-- >>> beginnings [1, 2, 3, 4, 1, 5, 7, 6, 5]
-- [1,2,3,4,6,7,8]
beginnings :: Ord a => [a] -> [Int]
beginnings walk
  | length loops == 1 = [0 .. length walk - 1]
  | otherwise =
    sortOn
      (\k -> Map.lookup (visited V.! k) rimOf)
      [k | k <- [0 .. V.length visited - 1], Set.member (before k, visited V.! k) onRim]
  where
    visited = V.fromList walk
    before k = visited V.! (if k == 0 then V.length visited - 1 else k - 1)
    loops = rims walk
    rimOf = Map.fromList [(v, k) | (k, loop) <- zip [0 :: Int ..] loops, v <- loop]
    onRim = Set.fromList (rimPairs walk)

-- | Whether a walk passes each side at most once in each direction, and exactly one of its sides
-- other than bridges begins at each vertex.
onlyBridged :: Walk -> Bool
onlyBridged walk =
  Set.size (Set.fromList sides) == length sides
    && all (uncurry (/=)) sides
    && sort (map fst (rimPairs visited)) == Set.toAscList (Set.fromList visited)
  where
    sides = cyclicPairs visited
    visited = U.toList walk

-- | One walk along all these rims of a flat face, the outer one counter-clockwise and the holes
-- clockwise about the normal. The bridges are the shortest between rims. 'Nothing' if rims cross or
-- touch.
bridged :: (Int -> V3) -> V3 -> [Walk] -> Maybe Walk
bridged point normal loops = case loops of
  [walk] -> Just walk
  _
    | V.null places || crossed || length bridges + 1 /= length loops -> Nothing
    | length walked /= V.length places + 2 * length bridges -> Nothing
    | otherwise -> Just (U.fromList walked)
  where
    places = V.fromList (concatMap U.toList loops)
    seen = flat normal . point
    crossed = isJust (firstCrossing loops (V.map seen places))
    numbered = snd (foldl' number (0, []) loops)
    number (k, done) loop = (k + U.length loop, done ++ [[k .. k + U.length loop - 1]])
    loopOf = IntMap.fromList [(v, k) | (k, loop) <- zip [0 :: Int ..] loops, v <- U.toList loop]
    -- Sides of triangles that connect rims, the shortest first (Kruskal 1956).
    candidates =
      sortOn
        long
        ( Set.toList
            ( Set.fromList
                [ (min v w, max v w)
                  | (i, j, k) <- triangulation (Metric 1 1) (V.map seen places) numbered,
                    (a, b) <- [(i, j), (j, k), (k, i)],
                    let (v, w) = (places V.! a, places V.! b),
                    IntMap.lookup v loopOf /= IntMap.lookup w loopOf
                ]
            )
        )
    long (v, w) = let d = point v `minus` point w in dot d d
    bridges = snd (foldl' joining (loopOf, []) candidates)
    joining (groups, chosen) (v, w)
      | a == b = (groups, chosen)
      | otherwise = (IntMap.map (\k -> if k == a then b else k) groups, (v, w) : chosen)
      where
        (a, b) = (at v, at w)
        at i = IntMap.findWithDefault 0 i groups
    after = IntMap.fromList (concatMap (cyclicPairs . U.toList) loops)
    before = IntMap.fromList [(b, a) | (a, b) <- IntMap.toList after]
    leaving =
      IntMap.unionWith
        (++)
        (IntMap.map pure after)
        (IntMap.fromListWith (++) (concat [[(v, [w]), (w, [v])] | (v, w) <- bridges]))
    -- The walk begins at the least vertex of the outer rim without a bridge, or else at one with a
    -- bridge, where it arrives along that rim.
    first =
      listToMaybe
        [ (u, v)
          | loop <- loops,
            dot normal (doubleArea (V.map point (V.convert loop))) > 0,
            v <- sortOn (\v -> (fmap length (IntMap.lookup v leaving), v)) (U.toList loop),
            Just u <- [IntMap.lookup v before]
        ]
    walked = maybe [] (\side -> snd side : map snd (takeWhile (/= side) (steps side))) first
    steps side = let next = turned side in next : steps next
    -- At a vertex the walk leaves by the next side to the left of the one it came from.
    turned (u, v) =
      ( v,
        foldl'
          (\best w -> if intoCorner (seen v) (seen best, seen u) (seen w) then w else best)
          (IntMap.findWithDefault u v after)
          (filter (/= u) (IntMap.findWithDefault [] v leaving))
      )
