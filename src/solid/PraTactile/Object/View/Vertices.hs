{-# OPTIONS_HADDOCK hide #-}

-- | Finds the vertices of a solid that a camera sees: no face hides them.
module PraTactile.Object.View.Vertices
  ( SeenVertex (..),
    seenVertices,
  )
where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description (VertexName, cyclicPairs)
import PraTactile.Object.Mesh
import PraTactile.Object.Rims
import PraTactile.Object.Vector
import PraTactile.Object.View.Camera

-- | A vertex that is seen, with places on the picture ('onPicture'): millimetres right of and below
-- the centre.
data SeenVertex = SeenVertex
  { seenName :: VertexName,
    -- | its place
    seenAt :: !(Double, Double),
    -- | the places of the other ends of its edges, once for each face at the edge that is turned to
    -- the eye
    seenEdges :: [(Double, Double)]
  }
  deriving stock (Eq, Show)

-- | The vertices of faces that are turned to the eye, unless another such face hides them.
seenVertices :: Camera -> [SeenVertex]
seenVertices it =
  [ SeenVertex (vertexAt solid v) (flat' v) (map flat' (Map.findWithDefault [] v ends))
    | v <- Map.keys ends,
      not (any (hides v) shown)
  ]
  where
    solid = cameraMesh it
    shown = filter (facing it) [0 .. V.length (meshWalks solid) - 1]
    ends =
      Map.fromListWith
        (++)
        [ (a, [b])
          | f <- shown,
            (v, w) <- rimPairs (U.toList (meshWalks solid V.! f)),
            (a, b) <- [(v, w), (w, v)]
        ]
    flat' v = pictured V.! v
    pictured = V.generate (V.length (meshPoints solid)) (onPicture it . millimetres it . at)
    planes =
      Map.fromList [(f, (plane, nearly it f plane)) | f <- shown, let plane = planeAt it f]
    at v = let V3 x y z = meshPoints solid V.! v in (fromInteger x, fromInteger y, fromInteger z)
    -- A point behind the plane of a visible face is hidden if its picture is inside the face's
    -- picture. Near the rim, the exact place where the ray to the eye meets the plane decides.
    hides v f
      | U.elem v walk = False
      | maybe True (\plane -> sideOf plane (cornerOf it (at v)) /= LT) (Map.lookup f planes) = False
      | otherwise =
        fromMaybe
          (any (holds f) (reached (at v) (planeAt it f)))
          (surelyIn (1e-9 * roughSize) (flat' v) (map flat' (U.toList walk)))
      where
        walk = meshWalks solid V.! f
    roughSize = fromRational (cameraSize it / fromInteger (meshDenominator solid))
    reached p@(x, y, z) plane
      | along > 0 && height < 0 && maybe True (const (height + along > 0)) (cameraEye it) =
        let k = negate height / along in Just (x + k * dx, y + k * dy, z + k * dz)
      | otherwise = Nothing
      where
        (dx, dy, dz) = case cameraEye it of
          Just (ex, ey, ez) -> (ex - x, ey - y, ez - z)
          Nothing -> viewTowards (cameraView it)
        height = before plane p
        along = before (fst plane, 0) (dx, dy, dz)
    holds f p = inPolygon (seen p) [seen (at w) | w <- U.toList (meshWalks solid V.! f)]
      where
        V3 a b c = fst (planeAt it f)
        seen (x, y, z)
          | abs c >= abs a && abs c >= abs b = (x, y)
          | abs a >= abs b = (y, z)
          | otherwise = (z, x)

-- | Whether a point of the picture is in a polygon. Arguments: a distance; the point; the polygon.
-- 'Nothing' if the point is within the distance of the rim.
surelyIn :: Double -> (Double, Double) -> [(Double, Double)] -> Maybe Bool
surelyIn room (x, y) corners
  | any near sides = Nothing
  | otherwise = Just (odd (length (filter passes sides)))
  where
    sides = cyclicPairs corners
    near ((ax, ay), (bx, by)) = (x - ax - k * dx) ^ two + (y - ay - k * dy) ^ two < room * room
      where
        (dx, dy) = (bx - ax, by - ay)
        k = max 0 (min 1 (((x - ax) * dx + (y - ay) * dy) / max 1e-300 (dx * dx + dy * dy)))
    passes ((ax, ay), (bx, by)) =
      (ay > y) /= (by > y) && x < ax + (y - ay) * (bx - ax) / (by - ay)
    two = 2 :: Int

-- | Whether a point is in a polygon or on its rim, exactly.
inPolygon :: (Rational, Rational) -> [(Rational, Rational)] -> Bool
inPolygon (x, y) corners = any onSide sides || odd (length (filter passes sides))
  where
    sides = cyclicPairs corners
    turn (ax, ay) (bx, by) = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
    onSide (p@(ax, ay), q@(bx, by)) =
      turn p q == 0 && min ax bx <= x && x <= max ax bx && min ay by <= y && y <= max ay by
    passes (p@(_, ay), q@(_, by))
      | (ay > y) == (by > y) = False
      | otherwise = (turn p q > 0) == (by > ay)
