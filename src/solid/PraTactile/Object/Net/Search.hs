-- | All unfoldings of a solid one after the other, and those that do not overlap.
module PraTactile.Object.Net.Search
  ( spanningTrees,
    unfoldings,
    netsOf,
    searched,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import Data.Maybe (catMaybes)
import qualified Data.Vector as V
import Numeric.Natural (Natural)
import PraTactile.Object.Mesh
import PraTactile.Object.Net.Meeting
import PraTactile.Object.Net.Paths
import PraTactile.Object.Net.Trees
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Net.Unfolding
import PraTactile.Object.Surface
import PraTactile.Object.WingedEdge

-- | How many unfoldings a solid has; none if it is of several pieces. By Kirchhoff's theorem, so
-- that no unfolding is made.
spanningTrees :: Solid -> Natural
spanningTrees whole =
  spanningTreeCount
    (V.length (meshWalks (solidMesh whole)))
    [(sideFace sides s, sideFace sides t) | (s, t) <- edgesBySides sides]
  where
    sides = surface (meshWalks (solidMesh whole))

edgesBySides :: Surface -> [(Int, Int)]
edgesBySides sides = [(s, t) | e <- [0 .. edgeCount sides - 1], [s, t] <- [edgeSides sides e]]

-- | An unfolding as it grows: its sides, the last one first, and those at each face.
data Growing = Growing [Int] (IntMap.IntMap [Int]) Meeting

-- | All unfoldings that do not overlap, with the worst that two of their faces do.
netsOf :: Unfolder -> [(Unfolding, Meeting)]
netsOf it = catMaybes (searched it)

-- | The same, with 'Nothing' wherever all that begin so overlap.
searched :: Unfolder -> [Maybe (Unfolding, Meeting)]
searched it = map (fmap grown) (growing (faceCount it) (arcsOf sides) glue begun)
  where
    sides = unfolderSides it
    from = paths it
    begun = Growing [] IntMap.empty Apart
    grown (Growing tree _ meeting) = (unfoldingAlong (reverse tree), meeting)
    glue (Growing tree links worst) s
      | Overlapping `elem` found = Nothing
      | otherwise = Just (Growing (s : tree) linked (foldl' max worst found))
      where
        t = gluedTo sides s
        linked =
          IntMap.insertWith (++) (sideFace sides s) [s] (IntMap.insert (sideFace sides t) [t] links)
        found = concat [walk next | Just next <- [onward it (from V.! sideFace sides t) t]]
        walk path =
          pathMeeting path :
          concat
            [ walk next
              | back <- IntMap.findWithDefault [] (pathEnd path) links,
                Just next <- [onward it path back]
            ]

arcsOf :: Surface -> Int -> [(Int, Int)]
arcsOf sides f = [(s, sideFace sides (gluedTo sides s)) | s <- sidesOfFace sides f]

-- | All unfoldings, each once, whether they overlap or not.
unfoldings :: Solid -> [Unfolding]
unfoldings whole =
  map (unfoldingAlong . reverse) . catMaybes $
    growing (V.length (meshWalks (solidMesh whole))) (arcsOf sides) (\tree s -> Just (s : tree)) []
  where
    sides = surface (meshWalks (solidMesh whole))
