-- | The cells of symbols that lie wholly on a face, whatever simple polygon it is, decided exactly.
--
-- A face with the walk v_0 .. v_m and the outward normal n (twice its area long) is measured from
-- v_0: x along e = v_m - v_0, from the walk's first vertex to its last, and y along f = e x n, into
-- the face. With a = e . e and b = a (n . n), a corner v has
--
-- > x = e . (v - v_0) / sqrt a        y = f . (v - v_0) / sqrt b,
--
-- so that the numerators are integers and the roots alone need not be rational. The grid has as
-- many whole columns and rows as the box round all corners has room for, and is centred on it. A
-- cell, as an open rectangle, meets no side and has its middle in the polygon: then it lies in it,
-- its rim included. All that asks for signs of r + s sqrt a + t sqrt b with rational r, s and t,
-- which squaring twice decides.
module PraTactile.Object.Cells
  ( Grid (..),
    gridOf,
    bestGrid,
    triedFirst,
  )
where

import Data.List (sortOn)
import Data.Ord (Down (..))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Mesh
import PraTactile.Object.Validity (doubleArea)
import PraTactile.Object.Vector

-- | The grid of a face.
data Grid = Grid
  { -- | the face, from the vertex at which its frame begins
    gridWalk :: Walk,
    -- | the size of the box round it, to the right and down, in millimetres
    gridSize :: (Double, Double),
    -- | the columns and rows for which the box has room
    gridColumns :: Integer,
    gridRows :: Integer,
    -- | how many cells lie on the face; 'Nothing' where that would take too long to say
    gridCount :: Maybe Integer,
    -- | those cells, by row and column, row by row
    gridCells :: [(Integer, Integer)]
  }
  deriving stock (Eq, Show)

-- | The grid of a flat face with an area, with cells of so many millimetres to the right and down,
-- both positive. O(cells * corners), or O(corners) for a rectangle.
gridOf :: Mesh -> (Rational, Rational) -> Walk -> Grid
gridOf it (right, down) walk =
  Grid
    { gridWalk = walk,
      gridSize = (squareRoot (wide * wide / a), squareRoot (high * high / b)),
      gridColumns = columns,
      gridRows = rows,
      gridCount = count,
      gridCells = cells
    }
  where
    points = cornersOf it walk
    origin = firstOf points
    along = V.foldl (\_ p -> p) origin points `minus` origin
    normal = doubleArea points
    into = cross along normal
    -- In millimetres, the roots are of these.
    over = fromInteger (meshDenominator it)
    a = fromInteger (dot along along) * over * over
    b = a * fromInteger (dot normal normal)
    corners = V.map corner points
    corner p =
      ( fromInteger (dot along (p `minus` origin)),
        fromInteger (dot into (p `minus` origin))
      )
    (left, wide) = range (V.map fst corners)
    (top, high) = range (V.map snd corners)
    range values = (V.minimum values, V.maximum values - V.minimum values)
    columns = floorRoot (wide * wide / (a * right * right))
    rows = floorRoot (high * high / (b * down * down))
    sides = zip (V.toList corners) (V.toList (V.drop 1 corners V.++ V.take 1 corners))
    rectangle =
      V.length corners == 4
        && V.all (\(x, y) -> x `elem` [left, left + wide] && y `elem` [top, top + high]) corners
    count
      | rectangle = Just (columns * rows)
      | columns * rows * toInteger (V.length corners) > mostTests = Nothing
      | otherwise = Just (toInteger (length cells))
    cells =
      [ (r, c)
        | r <- [0 .. rows - 1],
          c <- [0 .. columns - 1],
          rectangle || onFace r c
      ]
    -- The line between columns j - 1 and j is at middleX + across j sqrt a.
    middleX = left + wide / 2
    middleY = top + high / 2
    across j = (j - fromInteger columns / 2) * right
    downTo i = (i - fromInteger rows / 2) * down
    onFace r c = not (any meetsCell sides) && odd (length (filter passesMiddle sides))
      where
        (west, east) = (across (fromInteger c), across (fromInteger c + 1))
        (north, south) = (downTo (fromInteger r), downTo (fromInteger r + 1))
        (middleAcross, middleDown) =
          (across (fromInteger c + 1 / 2), downTo (fromInteger r + 1 / 2))
        -- A side misses the open rectangle iff one of these lines separates them.
        meetsCell (p, q) =
          not
            ( both (\(x, _) -> beside x west <= 0)
                || both (\(x, _) -> beside x east >= 0)
                || both (\(_, y) -> below y north <= 0)
                || both (\(_, y) -> below y south >= 0)
                || all (>= 0) turns
                || all (<= 0) turns
            )
          where
            both holds = holds p && holds q
            turns = [turned p q x y | x <- [west, east], y <- [north, south]]
        passesMiddle (p, q)
          | (below (snd p) middleDown > 0) == (below (snd q) middleDown > 0) = False
          | below (snd q) middleDown > 0 = turned p q middleAcross middleDown > 0
          | otherwise = turned p q middleAcross middleDown < 0
    beside x at = signOf a 0 (x - middleX) (negate at) 0
    below y at = signOf 0 b (y - middleY) 0 (negate at)
    turned (px, py) (qx, qy) x y =
      signOf
        a
        b
        ((qx - px) * (middleY - py) - (qy - py) * (middleX - px))
        (negate (qy - py) * x)
        ((qx - px) * y)

-- | Of what more than so many tests would be needed for, cells are not counted.
mostTests :: Integer
mostTests = 4000000

-- | The sign of r + s sqrt a + t sqrt b, where a and b are not negative.
signOf :: Rational -> Rational -> Rational -> Rational -> Rational -> Rational
signOf a b r s t
  | first * signum t >= 0 = signum (first + signum t)
  | otherwise = first * sign2 a (r * r + s * s * a - t * t * b) (2 * r * s)
  where
    first = sign2 a r s

-- | The sign of r + s sqrt a.
sign2 :: Rational -> Rational -> Rational -> Rational
sign2 a r s
  | a == 0 || s == 0 = signum r
  | signum r * signum s >= 0 = signum (signum r + signum s)
  | otherwise = signum r * signum (r * r - s * s * a)

-- | The grid with the most cells of those that a face has from each of its vertices; of equal ones
-- the first in its walk. Of a face with more than 'triedFirst' vertices, those are tried that begin
-- the longest upper sides.
bestGrid :: Mesh -> (Rational, Rational) -> Walk -> Grid
bestGrid it (right, down) walk
  | diagonal < max right down ^ (2 :: Int) * fromInteger (meshDenominator it) ^ (2 :: Int) =
    (gridOf it (right, down) walk) {gridCount = Just 0, gridCells = []}
  | otherwise = better (map (gridOf it (right, down) . from) tried)
  where
    size = U.length walk
    from k = U.drop k walk U.++ U.take k walk
    tried
      | size <= triedFirst = [0 .. size - 1]
      | otherwise = 0 : take (triedFirst - 1) (sortOn (Down . upper) [1 .. size - 1])
    upper k = let side = point k `minus` point ((k + size - 1) `mod` size) in dot side side
    point k = meshPoints it V.! (walk U.! k)
    better grids = case grids of
      first : others -> foldl (\g h -> if gridCount h > gridCount g then h else g) first others
      [] -> gridOf it (right, down) walk
    -- The square of the diagonal of the box round it, which is no shorter than any width.
    diagonal =
      let corners = map (point . (`mod` size)) [0 .. size - 1]
          extent part = maximum (map part corners) - minimum (map part corners)
          V3 x y z =
            V3
              (extent (\(V3 u _ _) -> u))
              (extent (\(V3 _ v _) -> v))
              (extent (\(V3 _ _ w) -> w))
       in fromInteger (x * x + y * y + z * z)

-- | How many first vertices of a face are tried.
triedFirst :: Int
triedFirst = 256
