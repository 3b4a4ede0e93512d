{-# OPTIONS_HADDOCK hide #-}

-- | What is made of a solid before its faces are unfolded: their planes, their convex parts, and
-- how each plane comes to that of its neighbours, exactly and as enclosures of more and more
-- places.
module PraTactile.Object.Net.Unfolder
  ( Unfolder (..),
    Part,
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

-- | A solid of which faces are unfolded.
data Unfolder = Unfolder
  { unfolderMesh :: Mesh,
    unfolderSides :: Surface,
    unfolderTemplates :: V.Vector Template,
    -- | each face as convex parts
    unfolderParts :: V.Vector [Part],
    -- | in the exact numbers
    unfolderExactly :: Rung (Maybe Radicals),
    -- | in enclosures of 'rungPlaces'
    unfolderRungs :: NonEmpty (Rung Enclosure)
  }

-- | All that is told in one kind of number.
data Rung n = Rung
  { -- | of each face its corners
    rungCorners :: V.Vector (V.Vector (Planar n)),
    -- | of each side how the plane of the face across it comes to that of its own face
    rungAcross :: V.Vector (Similarity n)
  }

-- | How many binary places the enclosures have, one rung after the other, without an end.
rungPlaces :: NonEmpty Int
rungPlaces = NonEmpty.iterate (2 *) 64

-- | A solid that may be unfolded; of what it holds each part is made when it is first asked for.
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

-- | The other side of the edge that a side of a solid is of.
gluedTo :: Surface -> Int -> Int
gluedTo sides s = fromMaybe s (mateOf sides s)

-- | A convex part of a face: its corners by their places on the face's walk.
type Part = V.Vector Int

-- | A face as convex parts, which have no corners but its own.
convexParts :: Mesh -> Int -> [Part]
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
