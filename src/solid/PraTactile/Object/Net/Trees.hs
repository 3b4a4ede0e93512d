-- | The spanning trees of the graph that has the faces of a solid for nodes and its edges for arcs
-- (its dual graph; two faces may have several edges in common): how many there are, and all of
-- them. Each is a way to unfold the solid: its edges are folded, the others are cut.
module PraTactile.Object.Net.Trees
  ( spanningTreeCount,
    growing,
  )
where

import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import Data.Ratio (numerator)
import qualified Data.Set as Set
import Numeric.Natural (Natural)

-- | The weights of arcs, by the nodes at both ends.
type Weights = IntMap.IntMap (IntMap.IntMap Rational)

-- | How many spanning trees a graph has, with so many nodes and these arcs between them.
--
-- By Kirchhoff (1847) it is the determinant of the Laplacian matrix, in which a row and its column
-- are left out. With weights w of arcs, a node with arcs w_1 .. w_k to nodes 1 .. k is eliminated
-- from the symmetric matrix by
--
-- > d = w_1 + .. + w_k        w_ij <- w_ij + w_i w_j / d
--
-- and the determinant is the product of all d but the last node's, which is left. The node with the
-- fewest neighbours comes first, so that the graphs of polyhedra stay sparse. Fractions are exact.
spanningTreeCount :: Int -> [(Int, Int)] -> Natural
spanningTreeCount count arcs
  | count <= 0 = 0
  | otherwise = fromInteger (numerator (go (Set.fromList (map key (IntMap.toList first))) first 1))
  where
    first =
      foldl'
        (\graph (i, j) -> join i j 1 graph)
        (IntMap.fromList [(i, IntMap.empty) | i <- [0 .. count - 1]])
        [arc | arc@(i, j) <- arcs, i /= j]
    join i j w = half i j w . half j i w
    half :: Int -> Int -> Rational -> Weights -> Weights
    half i j w = IntMap.adjust (IntMap.insertWith (+) j w) i
    key (i, row) = (IntMap.size row, i)
    go queue graph product' = case Set.minView queue of
      Nothing -> product'
      Just ((_, node), others)
        | Set.null others -> product'
        | IntMap.null row -> 0
        | otherwise -> go requeued reduced (product' * d)
        where
          row = IntMap.findWithDefault IntMap.empty node graph
          near = IntMap.toList row
          d = sum (map snd near)
          cut =
            foldl'
              (\g (i, _) -> IntMap.adjust (IntMap.delete node) i g)
              (IntMap.delete node graph)
              near
          reduced =
            foldl'
              (\g ((i, w), (j, v)) -> join i j (w * v / d) g)
              cut
              [(one, other) | one@(i, _) <- near, other@(j, _) <- near, i < j]
          keys of' = [key (i, IntMap.findWithDefault IntMap.empty i of') | (i, _) <- near]
          requeued = foldl' (flip Set.insert) left (keys reduced)
          left = foldl' (flip Set.delete) others (keys graph)

-- | All spanning trees of a connected graph, each once, as they grow: from a node, by an arc to one
-- that the tree does not have yet, in the order in which their nodes came to it. Given what is
-- known of the first node alone, and what an arc to a new node makes of that: 'Nothing' leaves out
-- all trees that go on so, and stands among the trees where it does. An arc is given by a number;
-- from each node lead these, each to a node.
--
-- An arc is taken, or left out for good; it must be taken where no other way leads to what is
-- behind it. So every branch ends in a tree or in a 'Nothing'.
growing :: Int -> (Int -> [(Int, Int)]) -> (s -> Int -> Maybe s) -> s -> [Maybe s]
growing count arcsFrom step begun
  | count <= 0 = []
  | otherwise = go begun (IntSet.singleton 0) (arcsFrom 0)
  where
    go known reached frontier = case dropWhile ((`IntSet.member` reached) . snd) frontier of
      [] -> [Just known | IntSet.size reached == count]
      (arc, node) : others ->
        taken (IntSet.insert node reached) (others ++ arcsFrom node) (step known arc)
          ++ (if spared node reached others then go known reached others else [])
    taken reached frontier = maybe [Nothing] (\more -> go more reached frontier)
    -- Whether an arc of these leads to the part of the graph that has the node.
    spared node reached others = search (IntSet.singleton node) [node]
      where
        goals = IntSet.fromList (map snd others)
        search _ [] = False
        search seen (i : rest)
          | i `IntSet.member` goals = True
          | otherwise =
            let new =
                  [ j
                    | (_, j) <- arcsFrom i,
                      not (j `IntSet.member` reached || j `IntSet.member` seen)
                  ]
             in search (foldl' (flip IntSet.insert) seen new) (new ++ rest)
