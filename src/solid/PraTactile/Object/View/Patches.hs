{-# OPTIONS_HADDOCK hide #-}

-- | The faces of a solid that are turned to the eye, as convex parts in an order in which each may
-- be painted over those before it.
module PraTactile.Object.View.Patches
  ( VisiblePart (..),
    Side (..),
    patches,
  )
where

import Data.List (minimumBy)
import qualified Data.Map.Strict as Map
import Data.Ord (comparing)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Mesh
import PraTactile.Object.Surface
import PraTactile.Object.Triangles
import PraTactile.Object.Vector
import PraTactile.Object.View.Camera

-- | A convex part of a face that is visible, or hidden by patches that are painted later.
data VisiblePart = VisiblePart
  { -- | the face's index in the solid
    patchFace :: !Int,
    -- | its corners on the picture, each with the kind of the side to the next corner
    patchCorners :: [((Double, Double), Side)],
    -- | how much the face is turned to a light over the viewer's left shoulder, from 0 to 1
    patchLight :: !Double,
    -- | whether it is the whole face
    patchWhole :: !Bool
  }
  deriving stock (Eq, Show)

-- | The kind of a patch's side: an edge where faces bend, an edge where they do not, or a cut that
-- was made here.
data Side = Bent | Level | Cut
  deriving stock (Eq, Show)

data Piece = Piece
  { pieceFace :: !Int,
    pieceWhole :: !Bool,
    pieceCorners :: [(Corner, Side)]
  }

-- | All patches; those that others may hide come first.
patches :: Camera -> [VisiblePart]
patches it = map patch (ordered it planeOf (concatMap pieces (filter (facing it) [0 .. faces - 1])))
  where
    solid = cameraMesh it
    faces = V.length (meshWalks solid)
    sides = surface (meshWalks solid)
    normals = V.map (doubleArea . cornersOf solid) (meshWalks solid)
    planes = V.generate faces (\f -> let plane = planeAt it f in (plane, nearly it f plane))
    planeOf piece = planes V.! pieceFace piece
    patch piece =
      VisiblePart
        { patchFace = pieceFace piece,
          patchCorners =
            [ (onPicture it (millimetres it (cornerAt p)), side)
              | (p, side) <- pieceCorners piece
            ],
          patchLight = light (pieceFace piece),
          patchWhole = pieceWhole piece
        }
    light f =
      let V3 a b c = normals V.! f
          (x, y, z) = unit (doubles (fromInteger a, fromInteger b, fromInteger c))
          (dx, dy, dz) = unit (doubles (viewTowards (cameraView it)))
          -- The light comes from the eye, and from above and left of it.
          (lx, ly, lz) = unit (dx + 0.5 * dy, dy - 0.5 * dx, dz + 0.6)
       in max 0 (min 1 (x * lx + y * ly + z * lz))
    pieces f
      | length parts <= 1 = [Piece f True (cornersBy (U.toList walk))]
      | otherwise = [Piece f False (cornersBy [i, j, k]) | (i, j, k) <- parts]
      where
        walk = meshWalks solid V.! f
        parts = if convex f then [] else triangles solid walk
        kinds =
          Map.fromList
            [ ((sideStart sides s, sideEnd sides s), kindOf s)
              | s <- sidesOfFace sides f
            ]
        cornersBy vs =
          [(corners V.! v, Map.findWithDefault Cut (v, w) kinds) | (v, w) <- cyclicPairs vs]
    corners = V.map cornerAt' (meshPoints solid)
    cornerAt' (V3 x y z) = cornerOf it (fromInteger x, fromInteger y, fromInteger z)
    kindOf s = case mateOf sides s of
      Just t
        | sideFace sides s == sideFace sides t -> Cut
        | cross (normals V.! sideFace sides s) (normals V.! sideFace sides t) == zero -> Level
      _ -> Bent
    convex f =
      let points = cornersOf solid (meshWalks solid V.! f)
          n = V.length points
          p i = points V.! (i `mod` n)
       in and
            [ dot (normals V.! f) (cross (p (i + 1) `minus` p i) (p (i + 2) `minus` p (i + 1))) >= 0
              | i <- [0 .. n - 1]
            ]

-- | Sorts pieces so that none hides a later one.
ordered :: Camera -> (Piece -> (Plane, Nearly)) -> [Piece] -> [Piece]
ordered it planeOf given = go given []
  where
    go list rest = case list of
      [] -> rest
      [one] -> one : rest
      _ -> go behind (within ++ go front rest)
        where
          (behind, within, front) = parted (planeOf (splitter list)) list
    -- The one of a few candidates whose plane cuts the fewest pieces.
    splitter list = minimumBy (comparing (\one -> cuts (planeOf one) list)) (take 6 list)
    cuts plane list =
      length [() | one <- list, let s = sidesOf plane one, GT `elem` s, LT `elem` s]
    parted plane list = (concat bs, concat ws, concat fs)
      where
        (bs, ws, fs) = unzip3 (map (part it plane) list)

sidesOf :: (Plane, Nearly) -> Piece -> [Ordering]
sidesOf plane = map (sideOf plane . fst) . pieceCorners

-- | The parts of a piece that are behind a plane, in it, and before it.
part :: Camera -> (Plane, Nearly) -> Piece -> ([Piece], [Piece], [Piece])
part it plane piece
  | all (== EQ) sides = ([], [piece], [])
  | GT `notElem` sides = ([piece], [], [])
  | LT `notElem` sides = ([], [], [piece])
  | otherwise = ([half negate], [], [half id])
  where
    sides = sidesOf plane piece
    heights = map (before (fst plane) . cornerAt . fst) (pieceCorners piece)
    half way =
      Piece (pieceFace piece) False $
        concat
          [ [(p, if s > 0 || t >= 0 then side else Cut) | s >= 0]
              ++ [(between' p q (s / (s - t)), if t > 0 then side else Cut) | s * t < 0]
            | (((p, side), s'), ((q, _), t')) <- cyclicPairs (zip (pieceCorners piece) heights),
              let (s, t) = (way s', way t')
          ]
    between' p q k =
      let ((x, y, z), (x', y', z')) = (cornerAt p, cornerAt q)
       in cornerOf it (x + k * (x' - x), y + k * (y' - y), z + k * (z' - z))
