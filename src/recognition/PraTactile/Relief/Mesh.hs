{-# OPTIONS_HADDOCK hide #-}

-- | The relief of a face of a polyhedron, such as one that was printed. Rays along the face's
-- normal measure the height of its surface. The placement only says where the face and its lattice
-- of taxels lie, so that no ray falls on the wall of a symbol. The array is not used.
--
-- A ray begins 'highest' above the face and ends 'lowest', slightly below it. The first surface
-- that it meets is felt; if it meets none, nothing is felt. So parts further away, such as another
-- arm of the object, are not in the way, and surfaces that fall away beyond the face's rim are not
-- reached.
module PraTactile.Relief.Mesh
  ( MeshError (..),
    meshRelief,
    highest,
    lowest,
    finestTaxel,
  )
where

import Data.Maybe (mapMaybe)
import qualified Data.Vector as V
import PraTactile.Geometry (symbolThickness, taxelPitch)
import PraTactile.Object.Mesh
import PraTactile.Object.Placement
import PraTactile.Object.Surface
import PraTactile.Object.Triangles
import PraTactile.Object.WingedEdge
import PraTactile.Relief

-- | Why a polyhedron cannot be pressed.
data MeshError
  = -- | This number of sides of its faces lack a neighbour that walks them in the opposite
    -- direction.
    NotClosed Int
  | -- | It has no vertex where this corner of this face should be.
    ElsewhereThan FaceName VertexName
  deriving stock (Eq, Show)

-- | The greatest height above the face that is felt, in millimetres: twice a symbol's height.
highest :: Double
highest = 2 * symbolThickness

-- | The lowest height that is felt, in millimetres: a sixteenth of a symbol's height below the
-- face.
lowest :: Double
lowest = negate (symbolThickness / 16)

-- | The number of rays along each side of a symbol's taxel.
finestTaxel :: Int
finestTaxel = 4

-- | The relief of a laid face, measured on a polyhedron that lies where the placement has the
-- object. Both are scaled so that symbols have the paper's size. Refuses a polyhedron that is not
-- closed, and one without a vertex within a hundredth of a taxel of each corner of the face. O(n)
-- in the polyhedron's corners; a ray costs what lies near it.
meshRelief :: Mesh -> Solid -> LaidFace -> Either MeshError Relief
meshRelief it object laid
  | open > 0 = Left (NotClosed open)
  | (vertex, _) : _ <- missing = Left (ElsewhereThan name vertex)
  | otherwise = Right (reliefByHeights finestTaxel laid heightAt)
  where
    name = faceName (laidFace laid)
    sides = surface (meshWalks it)
    open =
      length
        [ ()
          | s <- [0 .. sideCount sides - 1],
            maybe True (\t -> sideStart sides t /= sideEnd sides s) (mateOf sides s)
        ]
    onFace = faceMotion (cornerPoints object name)
    points = V.generate (V.length (meshPoints it)) (onFace . pointAt it)
    missing =
      [ found
        | found@(_, at) <- zip (faceVertices name) (map onFace (cornerPoints object name)),
          not (V.any (near at) points)
      ]
    near (x, y, z) (x', y', z') = all ((< taxelPitch / 100) . abs) [x - x', y - y', z - z']
    heightAt = highestAt (spotMillimetres (laidBox laid)) (spotMillimetres (laidExtent laid)) facets
    facets =
      [ Facet (points V.! a) (points V.! b) (points V.! c)
        | walk <- V.toList (meshWalks it),
          (a, b, c) <- triangles it walk
      ]

-- | Converts points in space to coordinates of a face with these corners: millimetres to the right
-- of its first corner, below it, and above the face.
faceMotion :: [Point] -> Point -> (Double, Double, Double)
faceMotion corners = \p -> let v = ways p in (along v right, along v down, along v up)
  where
    ways (Point x y z) =
      case corners of
        Point x0 y0 z0 : _ -> (fromRational (x - x0), fromRational (y - y0), fromRational (z - z0))
        [] -> (0, 0, 0)
    right = unit (foldl (\_ p -> ways p) (1, 0, 0) corners)
    up = unit (double (outwardNormal corners))
    -- Right, down and the direction away from the viewer are a right-handed frame.
    down = let (a, b, c) = right; (d, e, f) = up in (b * f - c * e, c * d - a * f, a * e - b * d)
    double (Point x y z) = (fromRational x, fromRational y, fromRational z)
    along (a, b, c) (d, e, f) = a * d + b * e + c * f
    unit v@(a, b, c) = let l = sqrt (along v v) in (a / l, b / l, c / l)

-- | A triangle, by its corners: right of, below and above the origin of a face.
data Facet = Facet !Corner !Corner !Corner

type Corner = (Double, Double, Double)

-- | The height of the first of these triangles that a ray meets, at a place right of and below the
-- face's first vertex. 'Nothing' if it meets none. The first two arguments are the upper left
-- corner and the size of the face's bounding box, in which the triangles are sorted into squares.
highestAt :: (Double, Double) -> (Double, Double) -> [Facet] -> Double -> Double -> Maybe Double
highestAt (left, top) (wide, high) facets = \x y ->
  case mapMaybe (meeting x y) (squares V.! (square down y * (across + 1) + square right x)) of
    [] -> Nothing
    heights -> Just (maximum heights)
  where
    side = max (2 * taxelPitch) (sqrt (wide * high / 1e6))
    count size = ceiling (size / side) :: Int
    (across, below) = (count wide, count high)
    right = (left, across)
    down = (top, below)
    square (from, most) x = max 0 (min most (floor ((x - from) / side)))
    squares =
      V.map reverse $
        V.accum
          (flip (:))
          (V.replicate ((across + 1) * (below + 1)) [])
          [ (j * (across + 1) + i, facet)
            | facet@(Facet (ax, ay, az) (bx, by, bz) (cx, cy, cz)) <- facets,
              -- Seen from above it is counter-clockwise, since y points down.
              (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0,
              minimum [az, bz, cz] <= highest,
              maximum [az, bz, cz] >= lowest,
              j <- [square down (minimum [ay, by, cy]) .. square down (maximum [ay, by, cy])],
              i <- [square right (minimum [ax, bx, cx]) .. square right (maximum [ax, bx, cx])]
          ]

-- | The height of a triangle at a place. 'Nothing' if it is not there, or not between 'lowest' and
-- 'highest'.
meeting :: Double -> Double -> Facet -> Maybe Double
meeting x y (Facet (ax, ay, az) (bx, by, bz) (cx, cy, cz))
  | u >= 0 && v >= 0 && w >= 0 && z >= lowest && z <= highest = Just z
  | otherwise = Nothing
  where
    whole = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    v = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / whole
    w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / whole
    u = 1 - v - w
    z = u * az + v * bz + w * cz
