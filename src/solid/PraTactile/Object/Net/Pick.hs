-- | Finds a net of a solid: an unfolding in which no two faces overlap.
module PraTactile.Object.Net.Pick
  ( NoNet (..),
    mostTried,
    pickNet,
    pickCut,
    searched,
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
import PraTactile.Object.Net.Trees
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Net.Unfolding
import PraTactile.Object.Surface
import PraTactile.Object.Vector (V3 (..))
import PraTactile.Object.WingedEdge

-- | Why there is no net.
data NoNet
  = -- | every unfolding overlaps
    EveryOneOverlaps
  | -- | none was found, but there may be one
    NoneFound
  | -- | the solid has several pieces, whose faces cannot be unfolded together
    SeveralPieces
  deriving stock (Eq, Show)

-- | The number of unfoldings that are tried before 'NoneFound'.
mostTried :: Int
mostTried = 10000

-- | Finds a net of a solid. The number limits the unfoldings that are tried. It first tries the
-- steepest edge unfoldings in six directions (W. Schlickenrieder, Nets of Polyhedra, TU Berlin
-- 1997); nearly every convex solid has a net among these. Then it tries those that grow from the
-- first face.
pickNet :: Int -> Solid -> Either NoNet Unfolding
pickNet steps whole
  | spanningTrees whole == 0 = Left SeveralPieces
  | tree : _ <- steep ++ catMaybes tried = Right tree
  | length tried < steps = Left EveryOneOverlaps
  | otherwise = Left NoneFound
  where
    it = unfolder whole
    tried = take steps (searched whole)
    steep =
      [ grown tree
        | along <- directions,
          Just sides <- [steepest it along],
          let tree = foldl' (glue it) (firstFace it) sides,
          grownMeeting tree /= Overlapping
      ]
    directions = [(3, 5, 97), (97, 5, -3), (-5, 97, 3), (31, 47, -83), (-59, 61, 53), (71, -67, 41)]

-- | Finds a net of a solid. If there is none, it cuts faces with holes into faces without, and
-- finds a net of that solid. The result is the solid that is unfolded; for each of its faces, the
-- given solid's face that it is part of; and the net.
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

-- | The sides that are glued if each vertex is cut along its steepest rising edge. 'Nothing' if the
-- cut edges are not a spanning tree of the vertices.
steepest :: Unfolder -> (Double, Double, Double) -> Maybe [Int]
steepest it (a, b, c)
  | length tree + 1 == faceCount it && IntSet.size cut == edgeCount sides - length tree =
    Just tree
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

-- | All unfoldings without overlap, one after the other, with 'Nothing' for each branch in which
-- all overlap. They grow from the first face. Each step glues a face that is missing across a side
-- of one that is there, in the order in which faces came.
--
-- A side is glued, or left out for good. It must be glued if nothing else leads to what is behind
-- it. So every branch ends in an unfolding or in 'Nothing'.
searched :: Solid -> [Maybe Unfolding]
searched whole = go (firstFace it) (sidesOfFace sides 0)
  where
    it = unfolder whole
    sides = unfolderSides it
    across = sideFace sides . gluedTo sides
    go growing frontier = case dropWhile (hasFace growing . across) frontier of
      [] -> [Just (grown growing)]
      s : others ->
        taken (glue it growing s) (others ++ sidesOfFace sides (across s))
          ++ (if spared growing (across s) others then go growing others else [])
    taken growing frontier
      | grownMeeting growing == Overlapping = [Nothing]
      | otherwise = go growing frontier
    -- Whether one of these sides leads to the part of the solid with this face.
    spared growing face others = reaches (IntSet.singleton face) [face]
      where
        goals = IntSet.fromList (map across others)
        reaches _ [] = False
        reaches seen (f : rest)
          | f `IntSet.member` goals = True
          | otherwise =
            let new =
                  [ g
                    | g <- map across (sidesOfFace sides f),
                      not (hasFace growing g || g `IntSet.member` seen)
                  ]
             in reaches (foldl' (flip IntSet.insert) seen new) (new ++ rest)
