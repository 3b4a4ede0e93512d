-- | Where the symbols of a solid's faces come to lie on its net, whether a face is one there or cut
-- into parts because of its holes: then the symbols are cut with it.
module Picture.Raised
  ( Raising (..),
    raisedOn,
    cellsOn,
  )
where

import Data.Complex (Complex (..))
import qualified Data.Map.Strict as Map
import Picture.Polygon
import PraTactile.Array (Position)
import PraTactile.Emboss.Face (Stamp (..), outlineSpot)
import PraTactile.Object.Chart (Spot (..))
import PraTactile.Object.Mesh (vertexAt)
import PraTactile.Object.Net
import PraTactile.Object.Placement hiding (Spot (..))
import PraTactile.Object.Triangles
import PraTactile.Object.WingedEdge

-- | A net, and what is raised.
data Raising = Raising
  { -- | the solid of which it is a net
    raisingSolid :: Solid,
    -- | the faces that are parts of others, with those
    raisingParts :: Map.Map FaceName FaceName,
    -- | how a face lies on the array, if it does
    raisingLaid :: FaceName -> Maybe LaidFace,
    raisingSymbols :: LaidFace -> [(Position, Stamp)],
    -- | how wide a taxel of the symbols is, millimetres
    raisingTaxel :: Double
  }

-- | The outlines of what is raised on a face of the net, millimetres of the page:
-- counter-clockwise, and clockwise where they are hollow.
raisedOn :: Raising -> NetFace -> [[(Double, Double)]]
raisedOn it face = concat [loops | (_, _, loops) <- found it face]

-- | The cells of which a face of the net has something, each with its face and its symbol.
cellsOn :: Raising -> NetFace -> [((Face, Position), Stamp)]
cellsOn it face = [((laidFace laid, cell), stamp) | (laid, (cell, stamp), _ : _) <- found it face]

found :: Raising -> NetFace -> [(LaidFace, (Position, Stamp), [[(Double, Double)]])]
found it face =
  [ (laid, one, concatMap (seen . map (onFace frame . spot laid) . at cell) (stampOutlines stamp))
    | Just laid <- [raisingLaid it owner],
      let frame = if owner == name then face else frameOf face laid,
      one@(cell, stamp) <- raisingSymbols it laid
  ]
  where
    name = netFaceName face
    owner = Map.findWithDefault name name (raisingParts it)
    at cell loop = [(i, j) | Lattice i j <- map (outlineSpot cell) loop]
    spot laid (i, j) =
      let (left, top) = spotMillimetres (laidMargin laid)
       in (left + raisingTaxel it * fromInteger i, top + raisingTaxel it * fromInteger j)
    seen loop
      | owner == name || abs (sum (map signedArea pieces) - signedArea loop) < 1e-6 = [loop]
      | otherwise = filter ((> 1e-6) . abs . signedArea) pieces
      where
        pieces = map (`within` loop) parts
    parts = partsOf it face

-- | The whole of a laid face, given a part of it on the page.
frameOf :: NetFace -> LaidFace -> NetFace
frameOf face laid = case [(at s, at p) | (v, p) <- corners, Just s <- [lookup v spots]] of
  (a, p) : (b, q) : _ ->
    face {netCorners = [(x, y) | (_, s) <- spots, let x :+ y = p + (q - p) / (b - a) * (at s - a)]}
  _ -> face
  where
    corners = zip (faceVertices (netFaceName face)) (netCorners face)
    spots = map (fmap spotMillimetres) (laidCorners laid)
    at (x, y) = x :+ y

-- | A face of the net as triangles.
partsOf :: Raising -> NetFace -> [[(Double, Double)]]
partsOf it face =
  [ [p | v <- [i, j, k], Just p <- [lookup (vertexAt (solidMesh whole) v) corners]]
    | Just walk <- [walkNamed whole (netFaceName face)],
      (i, j, k) <- triangles (solidMesh whole) walk
  ]
  where
    whole = raisingSolid it
    corners = zip (faceVertices (netFaceName face)) (netCorners face)
