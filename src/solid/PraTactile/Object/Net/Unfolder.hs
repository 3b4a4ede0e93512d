-- | What is made of a solid before its faces are unfolded: their planes, and how each comes to that
-- of its neighbours, exactly and as enclosures of more and more places.
module PraTactile.Object.Net.Unfolder
  ( Unfolder (..),
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
import PraTactile.Object.Enclosure
import PraTactile.Object.Mesh
import PraTactile.Object.Net.Template
import PraTactile.Object.Number
import PraTactile.Object.Radicals
import PraTactile.Object.Surface
import PraTactile.Object.WingedEdge (Solid, solidMesh)

-- | A solid of which faces are unfolded.
data Unfolder = Unfolder
  { unfolderMesh :: Mesh,
    unfolderSides :: Surface,
    unfolderTemplates :: V.Vector Template,
    -- | the roots of the templates, each a multiple of another
    unfolderRoot :: Integer -> (Rational, Integer),
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
      unfolderRoot = root,
      unfolderExactly = rung (\q n -> let (k, under) = root n in Just (radical (q * k) under)),
      unfolderRungs = NonEmpty.map (rung . enclosed) rungPlaces
    }
  where
    it = solidMesh whole
    sides = surface (meshWalks it)
    flats = templates it
    roots = map templateRoot (V.toList flats)
    base = coprimeBase roots
    known = Map.fromList [(n, rootIn base n) | n <- roots]
    root n = if n == 1 then (1, 1) else Map.findWithDefault (1, n) n known
    rung :: Number n => (Rational -> Integer -> n) -> Rung n
    rung make =
      Rung
        { rungCorners =
            V.map
              (\flat -> V.generate (V.length (templateCorners flat)) (templateCorner make flat))
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
