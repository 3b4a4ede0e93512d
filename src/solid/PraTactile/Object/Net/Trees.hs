{-# OPTIONS_HADDOCK hide #-}

-- | Counts the unfoldings of a solid. They are the spanning trees of its dual graph, with the faces
-- as nodes and the edges as arcs; two faces may have several edges in common. The edges of the tree
-- are folded, the others are cut.
module PraTactile.Object.Net.Trees
  ( spanningTrees,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import Data.Ratio (numerator)
import qualified Data.Set as Set
import qualified Data.Vector as V
import Numeric.Natural (Natural)
import PraTactile.Object.Mesh
import PraTactile.Object.Surface
import PraTactile.Object.WingedEdge

-- | The number of unfoldings of a solid; 0 if it has several pieces.
spanningTrees :: Solid -> Natural
spanningTrees whole =
  spanningTreeCount
    (V.length (meshWalks (solidMesh whole)))
    [ (sideFace sides s, sideFace sides t)
      | e <- [0 .. edgeCount sides - 1],
        [s, t] <- [edgeSides sides e]
    ]
  where
    sides = surface (meshWalks (solidMesh whole))

-- | The weights of arcs, by the nodes at both ends.
type Weights = IntMap.IntMap (IntMap.IntMap Rational)

-- | The number of spanning trees of a graph with this number of nodes and these arcs.
--
-- By Kirchhoff (1847) it is the determinant of the Laplacian matrix without one row and its column.
-- Let arcs have weights w. A node with arcs w_1 .. w_k to nodes 1 .. k is eliminated from the
-- symmetric matrix by
--
-- > d = w_1 + .. + w_k        w_ij <- w_ij + w_i w_j / d
--
-- and the determinant is the product of all d except the last node's. Nodes with the fewest
-- neighbours are eliminated first, so that the graphs of polyhedra stay sparse. Fractions are
-- exact.
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
