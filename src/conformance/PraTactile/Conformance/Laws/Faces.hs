-- | Random faces in any plane, for the laws about faces.
module PraTactile.Conformance.Laws.Faces
  ( faces,
    staircase,
    inPlane,
    Vector3,
  )
where

import PraTactile.Object.Description (Point (..))
import Test.QuickCheck

-- | Corners of faces in any plane. Most are simple polygons.
faces :: Gen [Point]
faces = do
  flatCorners <- oneof [staircase (chooseInteger (1, 30)), star]
  u@(a, b, c) <- vector3 `suchThat` (/= (0, 0, 0))
  (d, e, f) <- vector3
  let v = (b * f - c * e, c * d - a * f, a * e - b * d)
      corners =
        inPlane
          (u, if v == (0, 0, 0) then (negate b, a, 0) else v)
          (Point 3 (-7) (1 / 2))
          flatCorners
  k <- chooseInt (0, length corners - 1)
  pure (drop k corners ++ take k corners)
  where
    vector3 = (,,) <$> part <*> part <*> part
    part = elements [0, 0, 1, 1, -1, 2, 1 / 2]
    -- A star-shaped polygon about the origin.
    star = do
      count <- chooseInt (3, 8)
      kept <- take count <$> shuffle [0 .. 7]
      radii <- vectorOf 8 (fromInteger <$> chooseInteger (2, 25))
      pure [(r * x, r * y) | (i, r, (x, y)) <- zip3 [0 :: Int ..] radii round8, i `elem` kept]
    round8 = [(2, 0), (2, 1), (0, 2), (-1, 2), (-2, 1), (-2, -1), (0, -2), (2, -1)]

-- | A polygon above a staircase that goes down and comes back up.
staircase :: Gen Integer -> Gen [(Rational, Rational)]
staircase size = do
  n <- chooseInt (1, 4)
  widths <- vectorOf n (fromInteger <$> size)
  depths <- vectorOf n (fromInteger <$> size)
  let marks = scanl (+) 0 widths
      below = concat [[(x, d), (x', d)] | (x, x', d) <- zip3 marks (drop 1 marks) depths]
  pure ((0, 0) : without below ++ [(last marks, 0)])
  where
    -- Equal depths make no corner.
    without (p : q : others) | p == q = without others
    without (p : others) = p : without others
    without [] = []

-- | Points of a plane in space, from two directions that span it, its origin, and the points'
-- coordinates along these.
inPlane :: (Vector3, Vector3) -> Point -> [(Rational, Rational)] -> [Point]
inPlane ((a, b, c), (d, e, f)) (Point x y z) corners =
  [Point (x + s * a + t * d) (y + s * b + t * e) (z + s * c + t * f) | (s, t) <- corners]

type Vector3 = (Rational, Rational, Rational)
