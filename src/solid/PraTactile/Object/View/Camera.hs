{-# OPTIONS_HADDOCK hide #-}

-- | The camera that looks at a solid, the projection of points to the picture, and exact tests on
-- which side of a face's plane a point is.
module PraTactile.Object.View.Camera
  ( -- * Looking
    View (..),
    viewFrom,
    viewAlong,
    Camera (..),
    camera,
    onPicture,
    Spot3,
    doubles,
    unit,
    millimetres,

    -- * Planes
    Corner (..),
    cornerOf,
    Plane,
    planeAt,
    before,
    facing,
    Nearly,
    nearly,
    sideOf,
  )
where

import qualified Data.Vector as V
import PraTactile.Object.Mesh
import PraTactile.Object.Vector
import PraTactile.Object.WingedEdge (Solid, solidMesh)

-- | A direction of view.
data View = View
  { -- | the direction from the solid to the eye, of length 1 up to rounding
    viewTowards :: !(Rational, Rational, Rational),
    -- | the upward direction on the picture; only its part orthogonal to 'viewTowards' counts
    viewUp :: !(Double, Double, Double),
    -- | The eye's distance from the centre of the bounding box, as a multiple of its longest side.
    -- It is above 0.87, which is not checked, so that the whole solid is before the eye. 'Nothing'
    -- is an infinite distance, which keeps parallels parallel.
    viewAway :: !(Maybe Rational)
  }
  deriving stock (Eq, Show)

-- | The view from an azimuth and an elevation, in degrees, and a distance of the eye ('viewAway').
-- At 0 and 0 the eye is on the side of negative y (the front), at azimuth 90 on that of positive x
-- (the right), at elevation 90 on that of positive z (above).
viewFrom :: Double -> Double -> Maybe Rational -> View
viewFrom azimuth elevation =
  viewAlong
    (sin a * cos e, negate (cos a) * cos e, sin e)
    (negate (sin a) * sin e, cos a * sin e, cos e)
  where
    (a, e) = (azimuth * pi / 180, elevation * pi / 180)

-- | The view from a direction of length 1, with an upward direction that is not parallel to it and
-- a distance of the eye ('viewAway').
viewAlong :: (Double, Double, Double) -> (Double, Double, Double) -> Maybe Rational -> View
viewAlong (x, y, z) = View (near x, near y, near z)
  where
    near v = fromInteger (round (v * 1000000)) / 1000000

-- | A view of one solid.
data Camera = Camera
  { cameraMesh :: Mesh,
    cameraView :: View,
    -- | the centre of the solid's bounding box, in units of the mesh's coordinates
    cameraMiddle :: !Spot3,
    -- | the eye, in the same units; 'Nothing' at an infinite distance
    cameraEye :: !(Maybe Spot3),
    -- | the longest side of the bounding box, in the same units
    cameraSize :: !Rational
  }

-- | A point or vector in space, in units of the mesh's coordinates.
type Spot3 = (Rational, Rational, Rational)

-- | A camera for a view of this solid.
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

-- | The place on the picture of a point in space, both in millimetres; x to the right and y down,
-- from the centre of the solid. Lengths in the plane through the centre, at right angles to the
-- direction of view, are drawn in true size. With a finite 'viewAway' nearer ones are larger and
-- farther ones smaller.
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

-- | Three numbers as machine numbers.
doubles :: Spot3 -> (Double, Double, Double)
doubles (x, y, z) = (fromRational x, fromRational y, fromRational z)

-- | The vector of length 1 in the same direction.
unit :: (Double, Double, Double) -> (Double, Double, Double)
unit (x, y, z) = let long = sqrt (x * x + y * y + z * z) in (x / long, y / long, z / long)

-- | A point in millimetres.
millimetres :: Camera -> Spot3 -> (Double, Double, Double)
millimetres it (x, y, z) = doubles (x / over, y / over, z / over)
  where
    over = fromInteger (meshDenominator (cameraMesh it))

-- | A point, with its approximate place relative to the centre of the solid, as a fraction of the
-- solid's size.
data Corner = Corner
  { cornerAt :: Spot3,
    cornerNear :: (Double, Double, Double)
  }

-- | A point with its approximate place.
cornerOf :: Camera -> Spot3 -> Corner
cornerOf it p@(x, y, z) = Corner p (doubles ((x - mx) / size, (y - my) / size, (z - mz) / size))
  where
    (mx, my, mz) = cameraMiddle it
    size = cameraSize it

-- | A plane: a normal, and its scalar product with the plane's points.
type Plane = (V3, Rational)

-- | The exact plane of the face with this index; the normal points outward.
planeAt :: Camera -> Int -> Plane
planeAt it f = (normal, fromInteger (dot normal (firstOf corners)))
  where
    corners = cornersOf (cameraMesh it) (meshWalks (cameraMesh it) V.! f)
    normal = doubleArea corners

-- | How far a point is before a plane, on the side to which the normal points, times the normal's
-- length.
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

-- | A plane in machine numbers: the unit normal, and its scalar product with a point of the plane
-- in the coordinates of 'cornerNear'.
type Nearly = ((Double, Double, Double), Double)

-- | The plane of the face with this index, given its exact plane.
nearly :: Camera -> Int -> Plane -> Nearly
nearly it f (V3 a b c, _) = (normal, inner normal (cornerNear (cornerOf it (x, y, z))))
  where
    -- Scaled down, because long integers are beyond the range of machine numbers.
    most = fromInteger (maximum (map abs [1, a, b, c]))
    normal = unit (doubles (fromInteger a / most, fromInteger b / most, fromInteger c / most))
    (x, y, z) = (fromInteger x', fromInteger y', fromInteger z')
    V3 x' y' z' = firstOf (cornersOf (cameraMesh it) (meshWalks (cameraMesh it) V.! f))

-- | The scalar product of two vectors.
inner :: (Double, Double, Double) -> (Double, Double, Double) -> Double
inner (a, b, c) (x, y, z) = a * x + b * y + c * z

-- | The side of a plane on which a corner is; 'GT' is before it.
sideOf :: (Plane, Nearly) -> Corner -> Ordering
sideOf (plane, (normal, offset)) corner
  | about > 1e-9 = GT
  | about < -1e-9 = LT
  | otherwise = compare (before plane (cornerAt corner)) 0
  where
    about = inner normal (cornerNear corner) - offset
