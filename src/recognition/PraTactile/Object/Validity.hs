-- | Whether a description is a polyhedron that can be embossed: a closed surface without holes, of
-- flat faces that are counter-clockwise seen from outside. Each fault is named. The conditions are
-- those of a winged-edge model (Ballard and Brown, Computer Vision, ch. 9) with Euler's formula;
-- all arithmetic is exact. That faces do not cut through each other is not examined.
module PraTactile.Object.Validity
  ( ObjectError (..),
    validate,

    -- * Geometry
    doubleArea,
    sixfoldVolume,
    minus,
    cross,
    dot,
  )
where

import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import PraTactile.Object.Description

-- | What is broken in a 'Description'.
data ObjectError
  = -- | there is no face at all
    NoFaces
  | -- | two vertices have this name
    RepeatedVertex VertexName
  | -- | two vertices are the same point
    CoincidentVertices VertexName VertexName
  | -- | a face has fewer than three vertices
    TooFewVertices FaceName
  | -- | a face names a vertex that the object has not got
    UnknownVertex FaceName VertexName
  | -- | a face visits a vertex twice
    VertexTwiceOnFace FaceName VertexName
  | -- | two faces have the same vertices
    RepeatedFace FaceName FaceName
  | -- | no face has this vertex
    UnusedVertex VertexName
  | -- | these faces meet at the edge, and they are not two
    EdgeWithoutTwoFaces VertexName VertexName [FaceName]
  | -- | both faces walk the edge in this direction, so one of them is clockwise seen from outside
    FacesDisagree VertexName VertexName FaceName FaceName
  | -- | the faces at this vertex are more than one ring
    PinchedVertex VertexName
  | -- | no walk over edges leads from the one face to the other
    NotConnected FaceName FaceName
  | -- | V, E, F with V - E + F other than 2: the surface has a handle
    EulerFails Int Int Int
  | -- | the vertices of a face lie on a line
    NoArea FaceName
  | -- | the vertices of a face do not lie in a plane
    NotPlanar FaceName
  | -- | the enclosed volume is not positive: every face is clockwise seen from outside
    NotOutward
  deriving stock (Eq, Show)

-- | The faults of a description, none if it is a polyhedron. Later conditions make sense only where
-- the earlier ones hold, so the list holds the faults of the first condition that fails.
validate :: Description -> [ObjectError]
validate described =
  firstOf
    ( map
        ($ described)
        [ namesClash,
          facesMalformed,
          verticesUnused,
          edgesMalformed,
          surfaceMalformed,
          eulerFails,
          facesBent,
          insideOut
        ]
    )
  where
    firstOf = concat . take 1 . dropWhile null

namesClash,
  facesMalformed,
  verticesUnused,
  edgesMalformed,
  surfaceMalformed,
  eulerFails,
  facesBent,
  insideOut ::
    Description -> [ObjectError]
namesClash described =
  [RepeatedVertex name | name <- repeats (map fst named)]
    ++ [ CoincidentVertices a b
         | ((a, p), later) <- withLater named,
           (b, q) <- later,
           p == q,
           a /= b
       ]
  where
    named = describedVertices described
facesMalformed described =
  [NoFaces | null faces]
    ++ concatMap malformed faces
    ++ [RepeatedFace a b | (a, later) <- withLater faces, b <- later, sameVertices a b]
  where
    faces = describedFaces described
    known = Map.fromList (describedVertices described)
    malformed face =
      [TooFewVertices face | length (faceVertices face) < 3]
        ++ [UnknownVertex face vertex | vertex <- faceVertices face, Map.notMember vertex known]
        ++ [VertexTwiceOnFace face vertex | vertex <- repeats (faceVertices face)]
verticesUnused described =
  [UnusedVertex vertex | (vertex, _) <- describedVertices described, Set.notMember vertex used]
  where
    used = Set.fromList (concatMap faceVertices (describedFaces described))
edgesMalformed described =
  [EdgeWithoutTwoFaces a b faces | ((a, b), faces) <- Map.toList meeting, length faces /= 2]
    ++ [FacesDisagree a b left right | ((a, b), [left, right]) <- Map.toList walking]
  where
    everySide = concatMap sides (describedFaces described)
    walking = facesBy [((sideStart side, sideEnd side), sideFace side) | side <- everySide]
    meeting =
      facesBy [(unordered (sideStart side) (sideEnd side), sideFace side) | side <- everySide]
    unordered a b = (min a b, max a b)
    facesBy keyed = Map.fromListWith (flip (++)) [(key, [face]) | (key, face) <- keyed]

-- Every edge has one face on each side by now, so stepping to the face across a side is a
-- permutation.
surfaceMalformed described =
  [PinchedVertex vertex | (vertex, leaving) <- Map.toList fans, ring leaving < length leaving]
    ++ [ NotConnected face other
         | face : others <- [faces],
           other <- others,
           Set.notMember other (reach [face] Set.empty)
       ]
  where
    faces = describedFaces described
    everySide = concatMap sides faces
    bySide = Map.fromList [((sideStart side, sideEnd side), side) | side <- everySide]
    fans = Map.fromListWith (++) [(sideStart side, [side]) | side <- everySide]
    across start end = Map.lookup (end, start) bySide
    ring leaving = sum [1 + turns side (next side) | side <- take 1 leaving]
    next side = across (sideBefore side) (sideStart side)
    turns :: Side -> Maybe Side -> Int
    turns first (Just side) | side /= first = 1 + turns first (next side)
    turns _ _ = 0
    reach [] seen = seen
    reach (face : waiting) seen
      | Set.member face seen = reach waiting seen
      | otherwise = reach (adjacent face ++ waiting) (Set.insert face seen)
    adjacent face =
      [sideFace other | side <- sides face, Just other <- [across (sideStart side) (sideEnd side)]]
eulerFails described = [EulerFails v e f | v - e + f /= 2]
  where
    v = length (describedVertices described)
    e = sum (map (length . faceVertices) (describedFaces described)) `div` 2
    f = length (describedFaces described)
facesBent described = concatMap bent (describedFaces described)
  where
    bent face = case pointsOf described face of
      points@(origin : _)
        | normal == Point 0 0 0 -> [NoArea face]
        | any (\point -> dot normal (point `minus` origin) /= 0) points -> [NotPlanar face]
        where
          normal = doubleArea points
      _ -> []
insideOut described =
  [NotOutward | sixfoldVolume (map (pointsOf described) (describedFaces described)) <= 0]

-- | The vector area of a polygon, doubled, in square millimetres: it points to the side from which
-- the polygon is counter-clockwise (Newell's formula).
doubleArea :: [Point] -> Point
doubleArea points = foldr (plus . uncurry cross) (Point 0 0 0) (cyclicPairs points)
  where
    plus (Point a b c) (Point d e f) = Point (a + d) (b + e) (c + f)

-- | Six times the volume that flat faces enclose, in cubic millimetres, positive where they are
-- counter-clockwise seen from outside: the cones from the origin to each face, summed (the
-- divergence theorem).
sixfoldVolume :: [[Point]] -> Rational
sixfoldVolume polygons =
  sum [dot (doubleArea points) apex | points <- polygons, apex <- take 1 points]

-- | The difference of two points.
minus :: Point -> Point -> Point
minus (Point a b c) (Point d e f) = Point (a - d) (b - e) (c - f)

-- | The vector product.
cross :: Point -> Point -> Point
cross (Point a b c) (Point d e f) = Point (b * f - c * e) (c * d - a * f) (a * e - b * d)

-- | The scalar product.
dot :: Point -> Point -> Rational
dot (Point a b c) (Point d e f) = a * d + b * e + c * f

pointsOf :: Description -> FaceName -> [Point]
pointsOf described face =
  [point | vertex <- faceVertices face, Just point <- [Map.lookup vertex known]]
  where
    known = Map.fromList (describedVertices described)

repeats :: Ord a => [a] -> [a]
repeats list =
  Map.keys (Map.filter (> (1 :: Int)) (Map.fromListWith (+) [(item, 1) | item <- list]))

withLater :: [a] -> [(a, [a])]
withLater [] = []
withLater (item : later) = (item, later) : withLater later
