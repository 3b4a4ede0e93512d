-- | A face in its plane, computed exactly: which cells of symbols lie on it, and which vertices
-- are nearest to a point.
--
-- With the walk v_0 .. v_m, e = v_m - v_0, n its double area vector and f = e x n, a corner v has
--
-- > x = X / sqrt a      X = e . (v - v_0)      a = e . e
-- > y = Y / sqrt b      Y = f . (v - v_0)      b = f . f
--
-- so X and Y are rational. The unit along x is 1 / sqrt a, along y 1 / sqrt b; a length of l
-- millimetres is l sqrt a or l sqrt b in these units. So comparisons are between numbers p + q sqrt
-- a + r sqrt b + s sqrt (a b).
module PraTactile.Conformance.Definition.Face
  ( Flat,
    flat,
    Block (..),
    Anchor (..),
    roomFor,
    holds,
    Spot,
    centreIn,
    millimetres,
    nearest,
  )
where

import Data.List (sortBy)
import PraTactile.Conformance.Definition.Roots
import PraTactile.Conformance.Definition.Solid (cyclicPairs, flatFace)
import PraTactile.Object.Description (Point (..))

-- | a, b, and X and Y of the corners.
data Flat = Flat Rational Rational [(Rational, Rational)]

-- | The face with these corners; 'Nothing' if they are not a simple polygon in a plane.
flat :: [Point] -> Maybe Flat
flat corners
  | flatFace corners = Just (Flat (e <.> e) (f <.> f) [(e <.> d, f <.> d) | d <- from])
  | otherwise = Nothing
  where
    points = [[x, y, z] | Point x y z <- corners]
    from = map (\p -> zipWith (-) p (head points)) points
    e = last from
    n = foldr (zipWith (+) . uncurry cross) [0, 0, 0] (cyclicPairs from)
    f = cross e n
    (<.>) u v = sum (zipWith (*) u v)
    cross [x, y, z] [u, v, w] = [y * w - z * v, z * u - x * w, x * v - y * u]
    cross _ _ = []

rational :: Rational -> Number Rational
rational p = [p, 0, 0, 0]

order :: Flat -> Number Rational -> Number Rational -> Ordering
order (Flat a b _) u v = compare (sign [b, a] (u `minus` v)) 0

-- | The place of a block of cells on a face.
data Anchor
  = -- | its middle is the middle of the corners' bounding box
    Middle
  | -- | its beginning is this many millimetres right of and below the first corner
    From (Rational, Rational)

-- | A block: its place, the size of a cell in millimetres (right, down), and its numbers of rows
-- and columns.
data Block = Block Anchor (Rational, Rational) (Integer, Integer)

-- | The greatest numbers of rows and columns for which the corners' bounding box has room.
roomFor :: Flat -> (Rational, Rational) -> (Integer, Integer)
roomFor (Flat a b corners) (right, down) =
  (most b down (map snd corners), most a right (map fst corners))
  where
    most k size values =
      let long = maximum values - minimum values
       in last (0 : takeWhile (\n -> (fromInteger n * size) ^ (2 :: Int) * k <= long * long) [1 ..])

-- | The vertical line with n columns to its left, as p + q sqrt a along x; and the horizontal line
-- with n rows above it, as p + q sqrt b along y.
lineX, lineY :: Flat -> Block -> Rational -> (Rational, Rational)
lineX (Flat _ _ corners) (Block anchor (right, _) (_, columns)) n = case anchor of
  Middle -> (middle (map fst corners), (n - fromInteger columns / 2) * right)
  From (x, _) -> (0, x + n * right)
lineY (Flat _ _ corners) (Block anchor (_, down) (rows, _)) n = case anchor of
  Middle -> (middle (map snd corners), (n - fromInteger rows / 2) * down)
  From (_, y) -> (0, y + n * down)

middle :: [Rational] -> Rational
middle values = (minimum values + maximum values) / 2

-- | Whether a cell of a block, by row and column, lies on the face including its rim. The cell is
-- cut into strips between the corners' x coordinates. Sides do not cross within a strip, so the
-- face lies between the first and the second, the third and the fourth, and so on.
holds :: Flat -> Block -> (Integer, Integer) -> Bool
holds face@(Flat _ _ corners) block (r, c) = and (zipWith within marks (drop 1 marks))
  where
    (west, east) = (column (fromInteger c), column (fromInteger c + 1))
    (north, south) = (row (fromInteger r), row (fromInteger r + 1))
    column n = let (p, q) = lineX face block n in [p, q, 0, 0]
    row n = let (p, q) = lineY face block n in [p, 0, q, 0]
    marks = [west] ++ sortBy by [x | x <- map (rational . fst) corners, between x] ++ [east]
    between x = by x west == GT && by x east == LT
    by = order face
    within u w =
      or
        [ all (upper `above`) [u, w] && all (lower `below`) [u, w]
          | (upper, lower) <- pairs
        ]
      where
        half = scale (1 / 2) (u `plus` w)
        across = [side | side@((x, _), (x', _)) <- cyclicPairs corners, left x /= left x']
        left x = by (rational x) half == LT
        pairs = paired (sortBy (\s t -> by (at s half) (at t half)) across)
    above side x = by (at side x) north /= GT
    below side x = by (at side x) south /= LT
    paired sides = case sides of
      s : t : others -> (s, t) : paired others
      _ -> []
    -- The y of a side at an x.
    at ((x, y), (x', y')) along =
      rational y `plus` scale ((y' - y) / (x' - x)) (along `minus` rational x)

-- | A point of the face's plane, along x and along y, in the form of 'lineX' and 'lineY'.
data Spot = Spot (Rational, Rational) (Rational, Rational)

-- | The middle of the given numbers of rows and columns of a block, from a cell on.
centreIn :: Flat -> Block -> (Integer, Integer) -> (Integer, Integer) -> Spot
centreIn face block (r, c) (high, wide) =
  Spot (lineX face block (mid c wide)) (lineY face block (mid r high))
  where
    mid from size = fromInteger from + fromInteger size / 2

-- | A point in millimetres right of and below the first corner.
millimetres :: Flat -> Spot -> (Double, Double)
millimetres (Flat a b _) (Spot (p, q) (p', r')) =
  (over a p + fromRational q, over b p' + fromRational r')
  where
    over k x = fromRational x / sqrt (fromRational k)

-- | The corners nearest to a point, by their indices in the walk.
nearest :: Flat -> Spot -> [Int]
nearest face@(Flat a b corners) (Spot (p, q) (p', r')) =
  [i | (i, far) <- distances, all ((/= GT) . order face far . snd) distances]
  where
    distances = zip [0 ..] (map squared corners)
    -- ((X - p - q sqrt a) / sqrt a)^2 + ((Y - p' - r' sqrt b) / sqrt b)^2
    squared (x, y) =
      [ (x - p) ^ (2 :: Int) / a + q * q + (y - p') ^ (2 :: Int) / b + r' * r',
        -2 * (x - p) * q / a,
        -2 * (y - p') * r' / b,
        0
      ]
