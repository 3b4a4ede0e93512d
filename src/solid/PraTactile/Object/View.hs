-- | What is seen of a solid, convex or not: the parts of its faces in an order in which each may be
-- painted over those before it, and the vertices that nothing hides.
--
-- A face whose outer side is turned away is hidden by others. The rest are convex parts of faces,
-- put in order by a binary partition of space (Fuchs, Kedem and Naylor 1980): the plane of one of
-- them parts the others, which are cut where they cross it; nothing behind that plane hides what is
-- before it, and the eye is before it, since the face is seen. Which side a corner is on is decided
-- exactly, by machine numbers where those are far from 0, and else by fractions, which corners made
-- by cuts are, too. The directions that one looks in are rounded to millionths before.
module PraTactile.Object.View
  ( -- * Looking
    View (..),
    viewFrom,
    viewAlong,
    Camera,
    camera,
    onPicture,

    -- * What is seen
    Patch (..),
    Side (..),
    patches,
    SeenVertex (..),
    seenVertices,
  )
where

import Data.List (minimumBy)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ord (comparing)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description (VertexName, cyclicPairs)
import PraTactile.Object.Mesh
import PraTactile.Object.Surface
import PraTactile.Object.Triangles
import PraTactile.Object.Vector
import PraTactile.Object.WingedEdge (Solid, solidMesh)

-- | How one looks at a solid.
data View = View
  { -- | the way from the solid to the eye, of length 1 but for the rounding
    viewTowards :: !(Rational, Rational, Rational),
    -- | what is up on the picture, as far as it is at right angles to that
    viewUp :: !(Double, Double, Double),
    -- | how many times as far away as the solid is large the eye is; far beyond all bounds where
    -- nothing is said, so that parallels stay parallel
    viewAway :: !(Maybe Rational)
  }
  deriving stock (Eq, Show)

-- | Looking from an azimuth and an elevation, in degrees: from the front where both are 0, from the
-- right at an azimuth of 90, from above at an elevation of 90.
viewFrom :: Double -> Double -> Maybe Rational -> View
viewFrom azimuth elevation =
  viewAlong
    (sin a * cos e, negate (cos a) * cos e, sin e)
    (negate (sin a) * sin e, cos a * sin e, cos e)
  where
    (a, e) = (azimuth * pi / 180, elevation * pi / 180)

-- | Looking from where such a way leads, of length 1, with another way up, not along the first.
viewAlong :: (Double, Double, Double) -> (Double, Double, Double) -> Maybe Rational -> View
viewAlong (x, y, z) = View (near x, near y, near z)
  where
    near v = fromInteger (round (v * 1000000)) / 1000000

-- | A view of one solid.
data Camera = Camera
  { cameraMesh :: Mesh,
    cameraView :: View,
    -- | the middle of the box round the solid, and the eye, in the units of the polyhedron's
    -- coordinates
    cameraMiddle :: !Spot3,
    cameraEye :: !(Maybe Spot3),
    -- | the longest side of that box
    cameraSize :: !Rational
  }

type Spot3 = (Rational, Rational, Rational)

-- | A view of this solid.
camera :: View -> Solid -> Camera
camera view whole = Camera it view middle eye size
  where
    it = solidMesh whole
    spans = [(minimum (along it), maximum (along it)) | along <- [xs, ys, zs]]
    middle = case [fromInteger (least + greatest) / 2 | (least, greatest) <- spans] of
      [a, b, c] -> (a, b, c)
      _ -> (0, 0, 0)
    size = fromInteger (maximum [greatest - least | (least, greatest) <- spans])
    eye = fmap (moved . (size *)) (viewAway view)
    moved far =
      let ((a, b, c), (x, y, z)) = (middle, viewTowards view)
       in (a + far * x, b + far * y, c + far * z)
    xs solid' = [x | V3 x _ _ <- V.toList (meshPoints solid')]
    ys solid' = [y | V3 _ y _ <- V.toList (meshPoints solid')]
    zs solid' = [z | V3 _ _ z <- V.toList (meshPoints solid')]

-- | Where a point of space, in millimetres, is on the picture: millimetres, x to the right and y
-- down, from where the middle of the solid is. Lengths there are true at right angles to the way
-- one looks.
onPicture :: Camera -> (Double, Double, Double) -> (Double, Double)
onPicture it (px, py, pz) = (k * right, negate (k * up))
  where
    (mx, my, mz) = millimetres it (cameraMiddle it)
    (x, y, z) = (px - mx, py - my, pz - mz)
    (dx, dy, dz) = unit (doubles (viewTowards (cameraView it)))
    right = rx * x + ry * y + rz * z
    up = ux * x + uy * y + uz * z
    across@(rx, ry, rz) = unit (viewUp (cameraView it) `crossed` (dx, dy, dz))
    (ux, uy, uz) = (dx, dy, dz) `crossed` across
    crossed (a, b, c) (d, e, f) = (b * f - c * e, c * d - a * f, a * e - b * d)
    deep = dx * x + dy * y + dz * z
    k = case cameraEye it of
      Nothing -> 1
      Just eye ->
        let (ex, ey, ez) = millimetres it eye
            far = sqrt ((ex - mx) ^ two + (ey - my) ^ two + (ez - mz) ^ two)
         in far / (far - deep)
    two = 2 :: Int

doubles :: Spot3 -> (Double, Double, Double)
doubles (x, y, z) = (fromRational x, fromRational y, fromRational z)

unit :: (Double, Double, Double) -> (Double, Double, Double)
unit (x, y, z) = let long = sqrt (x * x + y * y + z * z) in (x / long, y / long, z / long)

millimetres :: Camera -> Spot3 -> (Double, Double, Double)
millimetres it (x, y, z) = doubles (x / over, y / over, z / over)
  where
    over = fromInteger (meshDenominator (cameraMesh it))

-- | A convex part of a face that is seen, or hidden by patches that are painted later.
data Patch = Patch
  { -- | the face, by its place among the solid's faces
    patchFace :: !Int,
    -- | its corners on the picture, each with what the side from it to the next one is
    patchCorners :: [((Double, Double), Side)],
    -- | how much the face is turned to a light over the left shoulder, from 0 to 1
    patchLight :: !Double,
    -- | whether it is all of its face
    patchWhole :: !Bool
  }
  deriving stock (Eq, Show)

-- | What a side of a patch is: an edge at which faces bend, one at which they do not, or a cut that
-- was made here.
data Side = Bent | Level | Cut
  deriving stock (Eq, Show)

data Piece = Piece
  { pieceFace :: !Int,
    pieceWhole :: !Bool,
    pieceCorners :: [(Corner, Side)]
  }

-- | A point, and nearly where it is, from the middle of the solid and as a share of its size.
data Corner = Corner
  { cornerAt :: Spot3,
    cornerNear :: (Double, Double, Double)
  }

cornerOf :: Camera -> Spot3 -> Corner
cornerOf it p@(x, y, z) = Corner p (doubles ((x - mx) / size, (y - my) / size, (z - mz) / size))
  where
    (mx, my, mz) = cameraMiddle it
    size = cameraSize it

-- | All patches, those that others may hide first.
patches :: Camera -> [Patch]
patches it = map patch (ordered it planeOf (concatMap pieces (filter (facing it) [0 .. faces - 1])))
  where
    solid = cameraMesh it
    faces = V.length (meshWalks solid)
    sides = surface (meshWalks solid)
    normals = V.map (doubleArea . cornersOf solid) (meshWalks solid)
    planes = V.generate faces (\f -> let plane = planeAt it f in (plane, nearly it f plane))
    planeOf piece = planes V.! pieceFace piece
    patch piece =
      Patch
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
          -- From the eye, and from above and the left of it.
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

-- | A plane: what is at right angles to it, and the product of that with its points.
type Plane = (V3, Rational)

planeAt :: Camera -> Int -> Plane
planeAt it f = (normal, fromInteger (dot normal (firstOf corners)))
  where
    corners = cornersOf (cameraMesh it) (meshWalks (cameraMesh it) V.! f)
    normal = doubleArea corners

-- | By how much a point is before a plane.
before :: Plane -> Spot3 -> Rational
before (V3 a b c, offset) (x, y, z) =
  fromInteger a * x + fromInteger b * y + fromInteger c * z - offset

-- | Whether the outer side of a face is turned to the eye.
facing :: Camera -> Int -> Bool
facing it f = case cameraEye it of
  Just eye -> before plane eye > 0
  Nothing -> before (fst plane, 0) (viewTowards (cameraView it)) > 0
  where
    plane = planeAt it f

-- | A plane by machine numbers: what is at right angles to it, of length 1, and the product of that
-- with a point of it, as 'cornerNear' has points.
type Nearly = ((Double, Double, Double), Double)

nearly :: Camera -> Int -> Plane -> Nearly
nearly it f (V3 a b c, _) = (normal, inner normal (cornerNear (cornerOf it (x, y, z))))
  where
    -- Shortened, for long numbers are beyond what machine numbers hold.
    most = fromInteger (maximum (map abs [1, a, b, c]))
    normal = unit (doubles (fromInteger a / most, fromInteger b / most, fromInteger c / most))
    (x, y, z) = (fromInteger x', fromInteger y', fromInteger z')
    V3 x' y' z' = firstOf (cornersOf (cameraMesh it) (meshWalks (cameraMesh it) V.! f))

inner :: (Double, Double, Double) -> (Double, Double, Double) -> Double
inner (a, b, c) (x, y, z) = a * x + b * y + c * z

-- | On which side of a plane a corner is: 'GT' before it.
sideOf :: (Plane, Nearly) -> Corner -> Ordering
sideOf (plane, (normal, offset)) corner
  | about > 1e-9 = GT
  | about < -1e-9 = LT
  | otherwise = compare (before plane (cornerAt corner)) 0
  where
    about = inner normal (cornerNear corner) - offset

-- | Pieces in an order in which none hides one that comes later.
ordered :: Camera -> (Piece -> (Plane, Nearly)) -> [Piece] -> [Piece]
ordered it planeOf given = go given []
  where
    go list rest = case list of
      [] -> rest
      [one] -> one : rest
      _ -> go behind (within ++ go front rest)
        where
          (behind, within, front) = parted (planeOf (splitter list)) list
    -- Of a few the one that cuts the fewest.
    splitter list = minimumBy (comparing (\one -> cuts (planeOf one) list)) (take 6 list)
    cuts plane list =
      length [() | one <- list, let s = sidesOf plane one, GT `elem` s, LT `elem` s]
    parted plane list = (concat bs, concat ws, concat fs)
      where
        (bs, ws, fs) = unzip3 (map (part it plane) list)

sidesOf :: (Plane, Nearly) -> Piece -> [Ordering]
sidesOf plane = map (sideOf plane . fst) . pieceCorners

-- | What of a piece is behind a plane, in it, and before it.
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

-- | A vertex that is seen.
data SeenVertex = SeenVertex
  { seenName :: VertexName,
    seenAt :: !(Double, Double),
    -- | where the edges that are seen from it lead
    seenEdges :: [(Double, Double)]
  }
  deriving stock (Eq, Show)

-- | The vertices of faces turned to the eye that no other face hides.
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
            (v, w) <- cyclicPairs (U.toList (meshWalks solid V.! f)),
            (a, b) <- [(v, w), (w, v)]
        ]
    flat' v = pictured V.! v
    pictured = V.generate (V.length (meshPoints solid)) (onPicture it . millimetres it . at)
    planes =
      Map.fromList [(f, (plane, nearly it f plane)) | f <- shown, let plane = planeAt it f]
    at v = let V3 x y z = meshPoints solid V.! v in (fromInteger x, fromInteger y, fromInteger z)
    -- What is behind the plane of a face that is seen is hidden where its picture is in that of the
    -- face. Near its rim the place is asked for where the ray to the eye meets the plane.
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

-- | Whether a point is in a polygon, unless it is as near as this to the rim.
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

-- | Whether a point is in a polygon or on its rim.
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
