{-# OPTIONS_HADDOCK hide #-}

-- | Lays an unfolded solid on a page.
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

-- | An unfolded solid on a page, with faces as seen from outside. Coordinates are millimetres, x to
-- the right and y down. The first face is upright: its last vertex is to the right of its first.
data Net = Net
  { netFaces :: [NetFace],
    -- | the edges that are glued
    netFolds :: [Fold],
    -- | the outline; a corner occurs once for each time that the walk around it passes
    netOutline :: [(Double, Double)]
  }
  deriving stock (Eq, Show)

-- | A face, with its corners in the order of its name.
data NetFace = NetFace
  { netFaceName :: FaceName,
    netCorners :: [(Double, Double)]
  }
  deriving stock (Eq, Show)

-- | A point of a face on the page. It is given in millimetres right of and below the face's first
-- corner, for the upright face, whose last corner is to the right of its first.
onFace :: NetFace -> (Double, Double) -> (Double, Double)
onFace face (right, down) = case (netCorners face, reverse (netCorners face)) of
  ((x, y) : _, (x', y') : _) ->
    let long = sqrt ((x' - x) ^ (2 :: Int) + (y' - y) ^ (2 :: Int))
        (c, s) = ((x' - x) / long, (y' - y) / long)
     in (x + c * right - s * down, y + s * right + c * down)
  _ -> (right, down)

-- | An edge that is glued, with its ends and its bend.
data Fold = Fold
  { foldEdge :: EdgeName,
    foldEnds :: ((Double, Double), (Double, Double)),
    foldBend :: Bend
  }
  deriving stock (Eq, Show)

-- | The bend of an edge as seen from outside: a ridge is folded away from the viewer, a valley
-- towards the viewer; between faces of one plane the edge is flat.
data Bend = Ridge | Valley | Flat
  deriving stock (Eq, Ord, Show)

-- | The page with all faces of an unfolding.
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
    -- The page is turned so that the first face's last corner is to the right of its first, with y
    -- down.
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
