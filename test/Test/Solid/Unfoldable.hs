{-# LANGUAGE OverloadedStrings #-}

-- | Solids with few unfoldings, of which some overlap.
module Test.Solid.Unfoldable
  ( unfoldable,
  )
where

import PraTactile.Conformance.Laws.Solids
import PraTactile.Object.Description
import PraTactile.Object.Named
import Test.QuickCheck

-- | A convex solid of whose 16 unfoldings 2 overlap.
overlapping :: Description
overlapping = fourCorners [(17, 2, 1), (10, 9, 0), (9, 15, 0), (2, 20, 0)]

-- | A tetrahedron with these corners, whose faces look outward.
fourCorners :: [(Rational, Rational, Rational)] -> Description
fourCorners corners = case corners of
  [a, b, c, d] ->
    (if volume a b c d > 0 then id else reversed)
      Description
        { describedName = "",
          describedVertices = [(v, Point x y z) | (v, (x, y, z)) <- zip names corners],
          describedFaces =
            map (FaceName . map (names !!)) [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
        }
  _ -> Description "" [] []
  where
    names = ["A", "B", "C", "D"]
    volume a b c d = determinant (way a b) (way a c) (way a d)
    way (x, y, z) (u, v, w) = (u - x, v - y, w - z)

determinant :: Vector3 -> Vector3 -> Vector3 -> Rational
determinant (a, b, c) (d, e, f) (g, h, i) =
  a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)

type Vector3 = (Rational, Rational, Rational)

-- | A rotation about the x axis and then the z axis, given the tangents of half the angles.
turnedBy :: Rational -> Rational -> Point -> Point
turnedBy p q (Point x y z) = Point (c * x - s * v) (s * x + c * v) w
  where
    (d, t) = angle p
    (c, s) = angle q
    (v, w) = (d * y - t * z, t * y + d * z)
    angle k = ((1 - k * k) / (1 + k * k), 2 * k / (1 + k * k))

-- | Solids with so few unfoldings that all can be compared, anywhere and in any direction.
unfoldable :: Gen Description
unfoldable = do
  drawn <-
    frequency
      [ (9, rationalTetrahedron),
        (1, tetrahedron),
        (2, pure overlapping),
        (4, namedDescription <$> (Pyramid <$> size <*> size <*> size)),
        (3, dart),
        (1, dented),
        (1, prism),
        (1, both . labelled "a" <$> rationalTetrahedron <*> (labelled "b" . far <$> tetrahedron))
      ]
  k <- elements [1, 1 / 3, 127 / 5]
  turn <- turnedBy <$> tangent <*> tangent
  it <- shuffledFaces (moved (scaled k . turn) drawn)
  pure it {describedName = ""}
  where
    size = fromInteger <$> chooseInteger (3, 12)
    tangent = elements [0, 0, 1 / 2, 1, -1 / 3]
    scaled k (Point x y z) = Point (k * x + 1) (k * y - 7) (k * z + 1 / 2)
    far = moved (\(Point x y z) -> Point (x + 1000) y z)
    coordinate = fromInteger <$> chooseInteger (0, 20)
    tetrahedron =
      (fourCorners <$> vectorOf 4 ((,,) <$> coordinate <*> coordinate <*> coordinate))
        `suchThat` thick
    -- The plane through any three corners has the origin on one side and the fourth on the other.
    thick it = case [(x, y, z) | (_, Point x y z) <- describedVertices it] of
      [(a, b, c), (d, e, f), (g, h, i), (j, k, l)] ->
        determinant (d - a, e - b, f - c) (g - a, h - b, i - c) (j - a, k - b, l - c) /= 0
      _ -> False
    -- The normals of all faces have rational lengths, so that an unfolding has rational corners.
    rationalTetrahedron =
      (tetrahedronOf <$> vectorOf 4 plane) `suchThat` maybe False thick >>= maybe tetrahedron pure
    plane = do
      (a, b, c) <-
        elements [(1, 2, 2), (2, 3, 6), (1, 4, 8), (4, 4, 7), (2, 6, 9), (0, 3, 4), (0, 0, 1)]
      order <- shuffle [a, b, c]
      signs <- vectorOf 3 (elements [1, -1])
      along <- fromInteger <$> chooseInteger (-20, 20)
      pure (zipWith (*) order signs, along :: Rational)
    tetrahedronOf planes =
      fourCorners
        <$> traverse common [[q | (j, q) <- zip [0 :: Int ..] planes, j /= i] | i <- [0 .. 3]]
    -- The common point of three planes, by Cramer's rule.
    common planes = case planes of
      [([a, b, c], p), ([d, e, f], q), ([g, h, i], r)]
        | whole /= 0 ->
          Just
            ( determinant (p, b, c) (q, e, f) (r, h, i) / whole,
              determinant (a, p, c) (d, q, f) (g, r, i) / whole,
              determinant (a, b, p) (d, e, q) (g, h, r) / whole
            )
        where
          whole = determinant (a, b, c) (d, e, f) (g, h, i)
      _ -> Nothing
    -- A pyramid over a quadrilateral that is not convex.
    dart = do
      (a, b, h) <- (,,) <$> size <*> size <*> size
      pure $
        Description
          ""
          [ ("A", Point 0 (-2) 0),
            ("B", Point a (negate (b + 2)) 0),
            ("C", Point 0 5 0),
            ("D", Point (negate a) (negate (b + 2)) 0),
            ("E", Point 0 0 h)
          ]
          ( FaceName ["D", "C", "B", "A"] :
              [FaceName [v, w, "E"] | (v, w) <- cyclicPairs ["A", "B", "C", "D"]]
          )
    -- A tetrahedron with a dent of three faces in place of its base.
    dented = do
      (a, h) <- (,) <$> size <*> size
      k <- elements [1 / 4, 1 / 2, 3 / 4]
      let base = ["A", "B", "C"]
      pure $
        Description
          ""
          [ ("A", Point a 0 0),
            ("B", Point (negate a) a 0),
            ("C", Point (negate a) (negate a) 0),
            ("D", Point 0 0 (k * h)),
            ("E", Point 0 0 h)
          ]
          ( [FaceName [v, w, "E"] | (v, w) <- cyclicPairs base]
              ++ [FaceName [w, v, "D"] | (v, w) <- cyclicPairs base]
          )
    prism = do
      (a, b, h) <- (,,) <$> size <*> size <*> size
      slanted <- elements [0, 0, 1, -3]
      let corners = [(0, 0), (3 * a, 0), (slanted, 4 * b)]
      pure $
        Description
          ""
          [ (VertexName (level : show i), Point x y z)
            | (level, z) <- [('a', 0), ('b', h)],
              (i, (x, y)) <- zip [0 :: Int ..] corners
          ]
          ( FaceName ["b0", "b1", "b2"] :
            FaceName ["a2", "a1", "a0"] :
              [ FaceName (map VertexName ['a' : show i, 'a' : show j, 'b' : show j, 'b' : show i])
                | (i, j) <- cyclicPairs [0 .. 2 :: Int]
              ]
          )
