{-# OPTIONS_HADDOCK hide #-}

-- | The relief of a face as a polyhedron has it that was made: rays along the face's normal find
-- how high its surface is. Of the placement only where the face and the lattice of its taxels lie
-- is asked, so that a ray does not fall on the wall of a symbol; of the array nothing.
--
-- A ray begins 'highest' above the face and ends 'lowest' above it, which is a little below: what
-- it meets first is felt, and where it meets nothing there is nothing to feel. So what stands
-- further off is not in the way, such as another arm of the object, and what falls away beyond the
-- face's rim is not reached.
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

-- | Why a polyhedron is not pressed.
data MeshError
  = -- | So many sides of its faces are not shared by two that walk them in opposite directions.
    NotClosed Int
  | -- | It has no vertex where this corner of this face should be.
    ElsewhereThan FaceName VertexName
  deriving stock (Eq, Show)

-- | What is felt at most so far above the face, in millimetres: twice a symbol's height.
highest :: Double
highest = 2 * symbolThickness

-- | And at least: a sixteenth of that below it.
lowest :: Double
lowest = negate (symbolThickness / 16)

-- | How many rays meet a taxel of the symbols, along each of its sides.
finestTaxel :: Int
finestTaxel = 4

-- | The relief of a laid face by a polyhedron that lies where the placement has the object, both so
-- large that symbols have the paper's size. Refuses a polyhedron that is not closed, and one
-- without a vertex within a hundredth of a taxel of each corner of the face. O(n) in the
-- polyhedron's corners, and for each ray what lies near it.
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

-- | From space to a face with these corners: millimetres to the right of its first one, below it,
-- and above the face.
faceMotion :: [Point] -> Point -> (Double, Double, Double)
faceMotion corners = \p -> let v = ways p in (along v right, along v down, along v up)
  where
    ways (Point x y z) =
      case corners of
        Point x0 y0 z0 : _ -> (fromRational (x - x0), fromRational (y - y0), fromRational (z - z0))
        [] -> (0, 0, 0)
    right = unit (foldl (\_ p -> ways p) (1, 0, 0) corners)
    up = unit (double (outwardNormal corners))
    -- Right, down and away from who looks at it are a right-handed frame.
    down = let (a, b, c) = right; (d, e, f) = up in (b * f - c * e, c * d - a * f, a * e - b * d)
    double (Point x y z) = (fromRational x, fromRational y, fromRational z)
    along (a, b, c) (d, e, f) = a * d + b * e + c * f
    unit v@(a, b, c) = let l = sqrt (along v v) in (a / l, b / l, c / l)

-- | A triangle: its corners right of, below and above the origin of a face.
data Facet = Facet !Corner !Corner !Corner

type Corner = (Double, Double, Double)

-- | How high the first of these triangles lies that a ray meets which falls on the face at a place
-- right of and below its first vertex; they are sorted into squares of the box that begins there
-- and is so large.
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
              -- Seen from above it is counter-clockwise; y goes down.
              (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0,
              minimum [az, bz, cz] <= highest,
              maximum [az, bz, cz] >= lowest,
              j <- [square down (minimum [ay, by, cy]) .. square down (maximum [ay, by, cy])],
              i <- [square right (minimum [ax, bx, cx]) .. square right (maximum [ax, bx, cx])]
          ]

-- | How high a triangle is at a place, if it is there.
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
