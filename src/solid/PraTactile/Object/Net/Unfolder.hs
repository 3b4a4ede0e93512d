{-# OPTIONS_HADDOCK hide #-}

-- | Prepares a solid for unfolding: the planes of its faces, their convex parts, and the maps
-- between neighbouring planes, exactly and as intervals of increasing precision.
module PraTactile.Object.Net.Unfolder
  ( Unfolder (..),
    ConvexPart,
    unfolder,
    faceCount,
    gluedTo,

    -- * Ways to compute
    Rung (..),
    rungPlaces,
  )
where

import Data.List.NonEmpty (NonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Map.Lazy as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Enclosure
import PraTactile.Object.Mesh
import PraTactile.Object.Net.Template
import PraTactile.Object.Number
import PraTactile.Object.Polygon
import PraTactile.Object.Radicals
import PraTactile.Object.Surface
import PraTactile.Object.Triangles
import PraTactile.Object.WingedEdge (Solid, solidMesh)

-- | A solid prepared for unfolding.
data Unfolder = Unfolder
  { unfolderMesh :: Mesh,
    unfolderSides :: FaceSides,
    unfolderTemplates :: V.Vector Template,
    -- | the convex parts of each face
    unfolderParts :: V.Vector [ConvexPart],
    -- | corners and maps in exact numbers
    unfolderExactly :: Rung (Maybe Radicals),
    -- | corners and maps as intervals with 'rungPlaces'
    unfolderRungs :: NonEmpty (Rung Enclosure)
  }

-- | Corners and maps in one kind of number.
data Rung n = Rung
  { -- | the corners of each face
    rungCorners :: V.Vector (V.Vector (Planar n)),
    -- | for each side, the map from the plane of the face across it to the plane of its own face
    rungAcross :: V.Vector (Similarity n)
  }

-- | The binary places of the intervals, one number for each rung; an infinite list.
rungPlaces :: NonEmpty Int
rungPlaces = NonEmpty.iterate (2 *) 64

-- | Prepares a solid; each part is computed when first used.
unfolder :: Solid -> Unfolder
unfolder whole =
  Unfolder
    { unfolderMesh = it,
      unfolderSides = sides,
      unfolderTemplates = flats,
      unfolderParts = V.generate (V.length flats) (convexParts it),
      unfolderExactly = rung (\q n -> Just (q `times` root n)),
      unfolderRungs = NonEmpty.map (rung . enclosed) rungPlaces
    }
  where
    it = solidMesh whole
    sides = surface (meshWalks it)
    flats = templates it
    roots = map templateRoot (V.toList flats)
    base = coprimeBase roots
    known = Map.fromList [(n, rootIn base n) | n <- roots]
    root n = Map.findWithDefault (fraction 1) n known
    rung :: Number n => (Rational -> Integer -> n) -> Rung n
    rung make =
      Rung
        { rungCorners =
            V.map
              (\one -> V.generate (V.length (templateCorners one)) (templateCorner make one))
              flats,
          rungAcross =
            V.generate
              (sideCount sides)
              (\s -> neighbourly make it sides flats (s, gluedTo sides s))
        }

-- | How many faces there are.
faceCount :: Unfolder -> Int
faceCount = V.length . unfolderTemplates

-- | The other side of the edge to which a side belongs.
gluedTo :: FaceSides -> Int -> Int
gluedTo sides s = fromMaybe s (mateOf sides s)

-- | A convex part of a face, by the places of its corners on the face's walk.
type ConvexPart = V.Vector Int

-- | A face as convex parts, whose corners are all corners of the face.
convexParts :: Mesh -> Int -> [ConvexPart]
convexParts it f
  | and [turn (at i) (at (i + 1)) (at (i + 2)) >= 0 | i <- [0 .. count - 1]] =
    [V.enumFromN 0 count]
  | otherwise = [V.fromList (map place [i, j, k]) | (i, j, k) <- triangles it walk]
  where
    walk = meshWalks it V.! f
    points = cornersOf it walk
    seen = V.map (flat (doubleArea points)) points
    count = V.length seen
    at i = seen V.! (i `mod` count)
    place v = fromMaybe 0 (U.elemIndex v walk)
