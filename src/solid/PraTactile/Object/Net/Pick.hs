-- | Finds a net of a solid: an unfolding in which no two faces overlap.
module PraTactile.Object.Net.Pick
  ( NoNet (..),
    mostTried,
    pickNet,
    pickCut,
  )
where

import qualified Data.IntSet as IntSet
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, listToMaybe)
import qualified Data.Vector as V
import PraTactile.Object.Merge
import PraTactile.Object.Mesh
import PraTactile.Object.Net.Meeting
import PraTactile.Object.Net.Search
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Net.Unfolding
import PraTactile.Object.Surface
import PraTactile.Object.Vector (V3 (..))
import PraTactile.Object.WingedEdge

-- | Why there is no net to be had.
data NoNet
  = -- | every unfolding overlaps
    EveryOneOverlaps
  | -- | none was found, and there may be one
    NoneFound
  | -- | faces of several pieces cannot be unfolded together
    SeveralPieces
  deriving stock (Eq, Show)

-- | How many unfoldings are tried before 'NoneFound'.
mostTried :: Int
mostTried = 10000

-- | A net of a solid: the first that does not overlap of the steepest edge unfoldings in a few
-- directions (W. Schlickenrieder, Nets of Polyhedra, TU Berlin 1997), which nearly every convex
-- solid has, or else of those that grow from the first face, in so many steps at most.
pickNet :: Int -> Solid -> Either NoNet Unfolding
pickNet steps whole
  | spanningTrees whole == 0 = Left SeveralPieces
  | Just tree <- listToMaybe [tree | tree <- steep, worstMeeting it tree /= Overlapping] =
    Right tree
  | (tree, _) : _ <- catMaybes tried = Right tree
  | length tried < steps = Left EveryOneOverlaps
  | otherwise = Left NoneFound
  where
    it = unfolder whole
    tried = take steps (searched it)
    steep = [tree | along <- directions, Just tree <- [steepest it along]]
    directions = [(3, 5, 97), (97, 5, -3), (-5, 97, 3), (31, 47, -83), (-59, 61, 53), (71, -67, 41)]

-- | The same, of the solid, or else of what comes of it where its faces with holes are cut into
-- faces without: that, for each of its faces the one that it is of, and the net.
pickCut :: Int -> Solid -> Either NoNet (Solid, [FaceName], Unfolding)
pickCut steps whole = case pickNet steps whole of
  Right tree -> Right (whole, solidFaces whole, tree)
  Left why ->
    maybe (Left why) Right . listToMaybe $
      [ (parted, map (faceAt (solidMesh whole)) owners, tree)
        | (owners, cut) <- withoutHoles (solidMesh whole),
          Right parted <- [solidOf cut],
          Right tree <- [pickNet steps parted]
      ]

-- | The unfolding for which each vertex is cut off along the edge that rises most steeply from it;
-- none where these edges are not a spanning tree of the vertices.
steepest :: Unfolder -> (Double, Double, Double) -> Maybe Unfolding
steepest it (a, b, c)
  | length tree + 1 == faceCount it && IntSet.size cut == edgeCount sides - length tree =
    Just (unfoldingAlong tree)
  | otherwise = Nothing
  where
    sides = unfolderSides it
    points = V.map double (meshPoints (unfolderMesh it))
    double (V3 x y z) = (fromInteger x, fromInteger y, fromInteger z)
    rise s = (a * dx + b * dy + c * dz) / sqrt (dx * dx + dy * dy + dz * dz)
      where
        (x, y, z) = points V.! sideStart sides s
        (x', y', z') = points V.! sideEnd sides s
        (dx, dy, dz) = (x' - x, y' - y, z' - z) :: (Double, Double, Double)
    best =
      Map.fromListWith
        max
        [(sideStart sides s, (rise s, s)) | s <- [0 .. sideCount sides - 1], rise s > 0]
    cut = IntSet.fromList [min s (gluedTo sides s) | (_, s) <- Map.elems best]
    isCut s = min s (gluedTo sides s) `IntSet.member` cut
    tree = spread (IntSet.singleton 0) [0]
    spread _ [] = []
    spread seen (f : others) =
      map fst new ++ spread (foldl' (flip IntSet.insert) seen (map snd new)) (others ++ map snd new)
      where
        new =
          firstOfEach
            seen
            [ (s, sideFace sides (gluedTo sides s))
              | s <- sidesOfFace sides f,
                not (isCut s)
            ]
    firstOfEach _ [] = []
    firstOfEach seen ((s, g) : rest)
      | g `IntSet.member` seen = firstOfEach seen rest
      | otherwise = (s, g) : firstOfEach (IntSet.insert g seen) rest
