{-# OPTIONS_HADDOCK hide #-}

-- | An unfolded solid on a page.
module PraTactile.Object.Net.Layout
  ( Net (..),
    NetFace (..),
    onFace,
    Fold (..),
    Bend (..),
    layOut,
    foldedEdges,
  )
where

import qualified Data.IntSet as IntSet
import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Vector as V
import PraTactile.Object.Mesh
import PraTactile.Object.Net.Template
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Net.Unfolding
import PraTactile.Object.Surface
import PraTactile.Object.Vector
import PraTactile.Object.WingedEdge

-- | An unfolded solid on a page: millimetres, x to the right and y down, its faces seen from
-- outside. The first face lies as its name says: from its first vertex to its last one is to the
-- right.
data Net = Net
  { netFaces :: [NetFace],
    -- | the edges that are glued
    netFolds :: [Fold],
    -- | the outline: each corner once for each time that the walk round it passes
    netOutline :: [(Double, Double)]
  }
  deriving stock (Eq, Show)

-- | A face, and where its corners are, in the order of its name.
data NetFace = NetFace
  { netFaceName :: FaceName,
    netCorners :: [(Double, Double)]
  }
  deriving stock (Eq, Show)

-- | Where a point of a face is on the page, given in millimetres right of and below the first
-- corner of the face as its name has it upright: from its first corner to its last one is to the
-- right.
onFace :: NetFace -> (Double, Double) -> (Double, Double)
onFace face (right, down) = case (netCorners face, reverse (netCorners face)) of
  ((x, y) : _, (x', y') : _) ->
    let long = sqrt ((x' - x) ^ (2 :: Int) + (y' - y) ^ (2 :: Int))
        (c, s) = ((x' - x) / long, (y' - y) / long)
     in (x + c * right - s * down, y + s * right + c * down)
  _ -> (right, down)

-- | An edge that is glued, by its ends, and to which side it is folded.
data Fold = Fold
  { foldEdge :: EdgeName,
    foldEnds :: ((Double, Double), (Double, Double)),
    foldBend :: Bend
  }
  deriving stock (Eq, Show)

-- | Seen from outside, a ridge is folded away and a valley towards; where faces lie in one plane
-- the edge stays flat.
data Bend = Ridge | Valley | Flat
  deriving stock (Eq, Ord, Show)

-- | Where all faces come to lie.
layOut :: Solid -> Unfolding -> Net
layOut whole tree =
  Net
    { netFaces = zipWith NetFace (solidFaces whole) (map V.toList (V.toList corners)),
      netFolds = map folded (unfoldingSides tree),
      netOutline = map startOf (walk begin)
    }
  where
    it = unfolder whole
    sides = unfolderSides it
    upright = laidFlat it tree
    corners = V.map (V.map onPage) upright
    -- The first face from its first corner to its last one turned to the right, and y down.
    onPage (x, y) = ((x * c + y * s) / long, (x * s - y * c) / long)
    (c, s) = fromMaybe (1, 0) (upright V.!? 0 >>= \first -> first V.!? (V.length first - 1))
    long = sqrt (c * c + s * s)
    startOf side = corners V.! sideFace sides side V.! placeOnWalk sides side
    folded side =
      Fold
        { foldEdge = EdgeName (at (sideStart sides side)) (at (sideEnd sides side)),
          foldEnds = (startOf side, startOf (nextSide sides side)),
          foldBend = bend side
        }
    at = vertexAt (unfolderMesh it)
    bend side = case compare (dot (normal side `cross` across side) (along side)) 0 of
      GT -> Ridge
      LT -> Valley
      EQ -> Flat
    across = normal . gluedTo sides
    normal side = templateNormal (unfolderTemplates it V.! sideFace sides side)
    along side = point (sideEnd sides side) `minus` point (sideStart sides side)
    point = (meshPoints (unfolderMesh it) V.!)
    glued = gluedSides it tree
    cutSides = [side | side <- [0 .. sideCount sides - 1], not (side `IntSet.member` glued)]
    begin = fromMaybe 0 (listToMaybe cutSides)
    walk side = side : takeWhile (/= begin) (drop 1 (iterate nextCut side))
    nextCut = toCut . nextSide sides
    toCut side
      | side `IntSet.member` glued = toCut (nextSide sides (gluedTo sides side))
      | otherwise = side

-- | The edges that are glued.
foldedEdges :: Solid -> Unfolding -> [EdgeName]
foldedEdges whole tree =
  [EdgeName (at (sideStart sides s)) (at (sideEnd sides s)) | s <- unfoldingSides tree]
  where
    at = vertexAt (solidMesh whole)
    sides = surface (meshWalks (solidMesh whole))
