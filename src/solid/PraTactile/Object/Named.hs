{-# LANGUAGE OverloadedStrings #-}

-- | Solids that are defined by a name and a few lengths. As seen from the front, x points right, y
-- to the back and z up. All vertices are rational. So there is no regular dodecahedron or
-- icosahedron: it is symmetric under a rotation of order 5, whose trace, 1 + 2 cos 72 degrees = (1
-- + sqrt 5) / 2, is irrational. The pyritohedron is a dodecahedron with rational vertices.
module PraTactile.Object.Named
  ( Named (..),
    namedDescription,
    positive,
  )
where

import Data.Ratio ((%))
import PraTactile.Object.Description
import PraTactile.Object.PaperObjects

-- | A solid by its name. Lengths are in millimetres.
data Named
  = -- | the paper's cube, 'cubeDescription'
    Cube
  | -- | the paper's parallelepiped, 'parallelepipedDescription'
    Parallelepiped
  | -- | width, depth and height; its vertices V1 to V8 are numbered as the cube's C1 to C8 are
    Box Rational Rational Rational
  | -- | the width and depth of the rectangular base, and the height of the apex over its centre
    Pyramid Rational Rational Rational
  | -- | the number of sides, the radius of the circle on which the base's vertices lie, and the
    -- height
    Prism Int Rational Rational
  | -- | the side of a cube; the tetrahedron's vertices are every other vertex of that cube
    Tetrahedron Rational
  | -- | the distance of the vertices from the centre
    Octahedron Rational
  | -- | the side of a cube; the cube's vertices are eight of the pyritohedron's twenty
    Pyritohedron Rational
  | -- | width, depth and height of a box that lacks its upper right quarter, as seen from the front
    LShape Rational Rational Rational
  | -- | width, depth and height of a box with a vertical hole, a third as wide and as deep, through
    -- its middle
    Frame Rational Rational Rational
  | -- | width and depth of a plate that is 25.4 mm high; its vertices S1 to S8 are numbered as the
    -- cube's C1 to C8 are, so its upper face is S1 S2 S3 S4
    Sheet Rational Rational
  deriving stock (Eq, Show)

-- | Whether the numbers are valid: lengths are positive, and a prism has 3 to 1000 sides.
positive :: Named -> Bool
positive it = case it of
  Cube -> True
  Parallelepiped -> True
  Box w d h -> all (> 0) [w, d, h]
  Pyramid w d h -> all (> 0) [w, d, h]
  Prism n r h -> n >= 3 && n <= 1000 && r > 0 && h > 0
  Tetrahedron a -> a > 0
  Octahedron a -> a > 0
  Pyritohedron a -> a > 0
  LShape w d h -> all (> 0) [w, d, h]
  Frame w d h -> all (> 0) [w, d, h]
  Sheet w d -> w > 0 && d > 0

-- | The description of the solid. Its numbers must be valid by 'positive', which is not checked.
namedDescription :: Named -> Description
namedDescription it = case it of
  Cube -> cubeDescription
  Parallelepiped -> parallelepipedDescription
  Box w d h -> boxOf "box" w d h
  Sheet w d -> box "sheet" 'S' (Point w d 25.4) boxFaces
  Pyramid w d h ->
    numbered
      "pyramid"
      [(0, d, 0), (0, 0, 0), (w, 0, 0), (w, d, 0), (w / 2, d / 2, h)]
      [[5, 2, 3], [5, 3, 4], [5, 4, 1], [5, 1, 2], [1, 4, 3, 2]]
  Prism n r h -> upright "prism" (map (circle n r) [0 .. n - 1]) h
  Tetrahedron a ->
    numbered
      "tetrahedron"
      [(0, 0, 0), (a, a, 0), (a, 0, a), (0, a, a)]
      [[1, 2, 3], [1, 3, 4], [1, 4, 2], [2, 4, 3]]
  Octahedron a ->
    numbered
      "octahedron"
      [(a, 0, 0), (0, a, 0), (negate a, 0, 0), (0, negate a, 0), (0, 0, a), (0, 0, negate a)]
      [[5, i, j] | (i, j) <- around]
      `withFaces` [[6, j, i] | (i, j) <- around]
  Pyritohedron a -> pyritohedron a
  LShape w d h ->
    lying
      "l"
      [(0, h), (0, 0), (w, 0), (w, h / 2), (w / 2, h / 2), (w / 2, h)]
      d
  Frame w d h -> frame w d h
  where
    around = [(1, 2), (2, 3), (3, 4), (4, 1)]
    boxOf name w d h = box name 'V' (Point w d h) boxFaces

-- | Vertex k of a nearly regular polygon with n vertices on the circle of radius r around the
-- origin. Arguments: n, r and k. The tangent of half the vertex's angle is rounded to thousandths,
-- so that the point is rational and on the circle.
circle :: Int -> Rational -> Int -> (Rational, Rational)
circle n r k
  | 2 * k == n = (negate r, 0)
  | otherwise = (r * (1 - t * t) / (1 + t * t), r * 2 * t / (1 + t * t))
  where
    t = round (1000 * tan (pi * fromIntegral k / fromIntegral n :: Double)) % 1000

-- | A polyhedron with this name. Its vertices V1, V2, .. are at these points, and each face is
-- given by the numbers of its vertices.
numbered :: ObjectName -> [(Rational, Rational, Rational)] -> [[Int]] -> Description
numbered name points = Description name vertices . map face
  where
    vertices = [(vertex i, Point x y z) | (i, (x, y, z)) <- zip [1 ..] points]

-- | The description with further faces, given by the numbers of their vertices.
withFaces :: Description -> [[Int]] -> Description
withFaces it more = it {describedFaces = describedFaces it ++ map face more}

vertex :: Int -> VertexName
vertex i = VertexName ('V' : show i)

face :: [Int] -> FaceName
face = FaceName . map vertex

-- | The prism with this name over a polygon in the plane z = 0, up to the height h. The polygon is
-- counter-clockwise as seen from above. The upper vertices come first.
upright :: ObjectName -> [(Rational, Rational)] -> Rational -> Description
upright name polygon h =
  numbered
    name
    ([(x, y, h) | (x, y) <- polygon] ++ [(x, y, 0) | (x, y) <- polygon])
    ( [1 .. n] :
      [n + i | i <- [n, n - 1 .. 1]] :
        [[i, n + i, n + j, j] | (i, j) <- cyclicPairs [1 .. n]]
    )
  where
    n = length polygon

-- | The prism with this name behind a polygon of points (x, z) in the plane y = 0, back to the
-- depth d. The polygon is counter-clockwise as seen from the front. The front vertices come first.
lying :: ObjectName -> [(Rational, Rational)] -> Rational -> Description
lying name polygon d =
  numbered
    name
    ([(x, 0, z) | (x, z) <- polygon] ++ [(x, d, z) | (x, z) <- polygon])
    ( [1 .. n] :
      [n + i | i <- [n, n - 1 .. 1]] :
        [[j, i, n + i, n + j] | (i, j) <- cyclicPairs [1 .. n]]
    )
  where
    n = length polygon

-- | A box with this width, depth and height and a vertical hole. Its upper and lower faces are four
-- trapezoids each.
frame :: Rational -> Rational -> Rational -> Description
frame w d h =
  numbered
    "frame"
    [(x, y, z) | z <- [h, 0], (x, y) <- outer ++ hole]
    ( [[i, j, 4 + j, 4 + i] | (i, j) <- ring]
        ++ [[8 + j, 8 + i, 12 + i, 12 + j] | (i, j) <- ring]
        ++ [[i, 8 + i, 8 + j, j] | (i, j) <- ring]
        ++ [[4 + j, 12 + j, 12 + i, 4 + i] | (i, j) <- ring]
    )
  where
    outer = [(0, d), (0, 0), (w, 0), (w, d)]
    hole = [(w / 3, 2 * d / 3), (w / 3, d / 3), (2 * w / 3, d / 3), (2 * w / 3, 2 * d / 3)]
    ring = cyclicPairs [1 .. 4]

-- | A dodecahedron around a cube with this side. In units of half the side, it has the vertices (1,
-- 1, 1) with all signs. The others are (0, 1 + h, 1 - h^2) with all signs and with the coordinates
-- rotated. The pentagons are flat for every h; here h is 1/2.
pyritohedron :: Rational -> Description
pyritohedron a =
  numbered
    "pyritohedron"
    [(x * a / 2, y * a / 2, z * a / 2) | (x, y, z) <- points]
    (map (map number) pentagons)
  where
    points =
      [(x, y, z) | x <- [1, -1], y <- [1, -1], z <- [1, -1]]
        ++ [turned (0, s * 3 / 2, t * 3 / 4) | turned <- turns, s <- [1, -1], t <- [1, -1]]
    turns = [id, \(x, y, z) -> (z, x, y), \(x, y, z) -> (y, z, x)]
    -- Each pentagon has an edge that crosses the centre of a side of the cube.
    pentagons =
      [ if s * t > 0 then walk else reverse walk
        | turned <- turns,
          s <- [1, -1],
          t <- [1, -1],
          let walk =
                map
                  turned
                  [ (0, s * 3 / 2, 3 / 4),
                    (t, s, 1),
                    (t * 3 / 2, s * 3 / 4, 0),
                    (t, s, -1),
                    (0, s * 3 / 2, -3 / 4)
                  ]
      ]
    number point = 1 + length (takeWhile (/= point) points)
