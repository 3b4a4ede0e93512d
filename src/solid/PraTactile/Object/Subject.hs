{-# OPTIONS_HADDOCK hide #-}

-- | The data of a polyhedron that all checks share, computed once.
module PraTactile.Object.Subject
  ( SidedMesh (..),
    subjectOf,
    facesWhere,
    boxOfFace,

    -- * Walks
    repeats,
    repeatedFirsts,
    usesAny,
  )
where

import Data.List (sort)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Boxes
import PraTactile.Object.Mesh
import PraTactile.Object.Rims
import PraTactile.Object.Surface
import PraTactile.Object.Vector

-- | A polyhedron with its sides. Only well-formed faces keep their walks in 'formed'; all others
-- have an empty one.
data SidedMesh = SidedMesh
  { whole :: Mesh,
    formed :: V.Vector Walk,
    sides :: FaceSides,
    normals :: V.Vector V3,
    rounding :: Rounding
  }

-- | Prepares a polyhedron for checks. O(n log n).
subjectOf :: Mesh -> SidedMesh
subjectOf it =
  SidedMesh
    { whole = it,
      formed = walks,
      sides = surface walks,
      normals = V.map (doubleArea . cornersOf it) walks,
      rounding = roundingOf (meshPoints it)
    }
  where
    walks = V.map (\walk -> if wellFormed walk then walk else U.empty) (meshWalks it)
    wellFormed walk =
      U.length walk >= 3
        && ofVertices it walk
        && null (repeats walk)
        && not (usesAny (repeatedFirsts it) walk)

-- | The well-formed faces whose walks satisfy the condition.
facesWhere :: (Walk -> Bool) -> SidedMesh -> [Int]
facesWhere holds subject = V.toList (V.findIndices holds (formed subject))

-- | The vertices that a walk visits more than once, each once, ascending. Empty if it does so only
-- along bridges ("PraTactile.Object.Rims").
repeats :: Walk -> [Int]
repeats walk
  | U.length walk == 3, a /= b, b /= c, a /= c = []
  | otherwise = case go (sort (U.toList walk)) of
    again | null again || not (onlyBridged walk) -> again
    _ -> []
  where
    (a, b, c) = (walk U.! 0, walk U.! 1, walk U.! 2)
    go (x : y : more)
      | x == y = x : go (dropWhile (== x) more)
      | otherwise = go (y : more)
    go _ = []

-- | The first vertices of repeated names.
repeatedFirsts :: Mesh -> Set.Set Int
repeatedFirsts = Set.fromList . Map.elems . meshRepeated

-- | Whether a walk contains one of these vertices.
usesAny :: Set.Set Int -> Walk -> Bool
usesAny some walk = not (Set.null some) && U.any (`Set.member` some) walk

-- | The bounding box of a face.
boxOfFace :: SidedMesh -> Int -> Box
boxOfFace subject f = V.foldl1' around (V.map (boxOf (rounding subject)) corners)
  where
    corners = cornersOf (whole subject) (formed subject V.! f)
