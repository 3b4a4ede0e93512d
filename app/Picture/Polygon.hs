-- | Polygons of a picture.
module Picture.Polygon
  ( signedArea,
    within,
  )
where

import PraTactile.Object.Description (cyclicPairs)

-- | The area, negative where one goes round clockwise (y up).
signedArea :: [(Double, Double)] -> Double
signedArea polygon = sum [x * y' - x' * y | ((x, y), (x', y')) <- cyclicPairs polygon] / 2

-- | The part of a polygon inside a convex one (Sutherland and Hodgman 1974).
within :: [(Double, Double)] -> [(Double, Double)] -> [(Double, Double)]
within convex polygon = foldl cut polygon (cyclicPairs convex)
  where
    cut corners ((ax, ay), (bx, by)) =
      concat
        [ [p | side p >= 0] ++ [crossing p q | side p * side q < 0]
          | (p, q) <- cyclicPairs corners
        ]
      where
        side (x, y) = signum (signedArea convex) * ((bx - ax) * (y - ay) - (by - ay) * (x - ax))
        crossing p@(x, y) q@(x', y') =
          let k = side p / (side p - side q) in (x + k * (x' - x), y + k * (y' - y))
