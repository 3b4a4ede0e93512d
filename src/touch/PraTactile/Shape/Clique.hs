{-# OPTIONS_HADDOCK hide #-}

-- | The cliques of a graph: sets of items of which every two are related. A relation is given as a
-- function of two items.
module PraTactile.Shape.Clique
  ( cliques,
    clique,
  )
where

import Data.Foldable (asum)
import qualified Data.IntMap.Strict as IntMap
import Data.IntSet (IntSet)
import qualified Data.IntSet as IntSet
import Data.Maybe (mapMaybe)

-- | All cliques with the given number of items, each in the order of the list. Of two items the
-- earlier one is the relation's first argument.
--
-- >>> cliques 3 (\a b -> gcd a b == 1) [2 .. 7 :: Int]
-- [[2,3,5],[2,3,7],[2,5,7],[3,4,5],[3,4,7],[3,5,7],[4,5,7],[5,6,7]]
cliques :: Int -> (a -> a -> Bool) -> [a] -> [[a]]
cliques size related items = map (itemsOf numbered) (go size (IntMap.keysSet numbered))
  where
    numbered = IntMap.fromList (zip [0 ..] items)
    later = laterRelated related numbered
    go n among
      | n <= 0 = [[]]
      | IntSet.size among < n = []
      | otherwise =
        [ i : rest
          | i <- IntSet.toAscList among,
            rest <-
              go (n - 1) (IntSet.intersection among (IntMap.findWithDefault IntSet.empty i later))
        ]

-- | One clique with the given number of items. 'Nothing' is a proof that there is none, because
-- the search is complete. The relation must be symmetric. Note [Colours]
--
-- >>> clique 4 (\a b -> gcd a b == 1) [2 .. 7 :: Int]
-- Just [7,5,3,2]
-- >>> clique 5 (\a b -> gcd a b == 1) [2 .. 7 :: Int]
-- Nothing
clique :: Int -> (a -> a -> Bool) -> [a] -> Maybe [a]
clique size related items = itemsOf numbered <$> go size (IntMap.keysSet numbered)
  where
    numbered = IntMap.fromList (zip [0 ..] items)
    later = laterRelated related numbered
    earlier =
      IntMap.fromListWith
        IntSet.union
        [(j, IntSet.singleton i) | (i, js) <- IntMap.toList later, j <- IntSet.toList js]
    neighbours = IntMap.unionWith IntSet.union later earlier
    next i = IntMap.findWithDefault IntSet.empty i neighbours
    go :: Int -> IntSet -> Maybe [Int]
    go n among
      | n <= 0 = Just []
      | otherwise =
        asum (zipWith with branches (scanl (flip IntSet.delete) among branches))
      where
        branches = IntSet.toAscList (uncoloured next (n - 1) among)
        with i left = (i :) <$> go (n - 1) (IntSet.intersection left (next i))

-- | The vertices that remain after the given number of independent sets (sets without neighbours)
-- are removed.
uncoloured :: (Int -> IntSet) -> Int -> IntSet -> IntSet
uncoloured next = go
  where
    go :: Int -> IntSet -> IntSet
    go n left
      | n <= 0 || IntSet.null left = left
      | otherwise = go (n - 1) (left `IntSet.difference` apart IntSet.empty left)
    -- An independent set, chosen greedily: each vertex taken removes its neighbours.
    apart :: IntSet -> IntSet -> IntSet
    apart taken free = case IntSet.minView free of
      Nothing -> taken
      Just (i, others) -> apart (IntSet.insert i taken) (others `IntSet.difference` next i)

-- | For each item, by its number, the numbers of the related items after it.
laterRelated :: (a -> a -> Bool) -> IntMap.IntMap a -> IntMap.IntMap IntSet
laterRelated related numbered =
  IntMap.mapWithKey
    (\i a -> IntMap.keysSet (IntMap.filter (related a) (snd (IntMap.split i numbered))))
    numbered

-- | The items with these numbers.
itemsOf :: IntMap.IntMap a -> [Int] -> [a]
itemsOf numbered = mapMaybe (`IntMap.lookup` numbered)

{- Note [Colours] An independent set has at most one vertex of a clique, so n - 1 such sets have at
   most n - 1. Hence a clique of n has a vertex outside n - 1 independent sets, and it is enough to
   branch on the vertices outside. A vertex that was tried need not be tried again. (Greedy
   colouring as a bound: E. Tomita and T. Seki, An efficient branch-and-bound algorithm for finding
   a maximum clique, DMTCS 2003.) -}
