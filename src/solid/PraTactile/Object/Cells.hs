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
-- its rim included. All that asks for signs of r + s sqrt a + t sqrt b with whole r, s and t,
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
import Data.Ratio (denominator, numerator, (%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Mesh
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
gridOf = gridWithin mostTests

-- | The same where no more than so many sides are asked whether they meet a cell. From a vertex at
-- the place of the one before it there is no frame, and no cell.
gridWithin :: Integer -> Mesh -> (Rational, Rational) -> Walk -> Grid
gridWithin most it (right, down) walk
  | a == 0 = Grid walk (0, 0) 0 0 (Just 0) []
  | otherwise =
    Grid
      { gridWalk = walk,
        gridSize = (squareRoot (square wide % a), squareRoot (square high % b)),
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
    a = dot along along * square (meshDenominator it)
    b = a * dot normal normal
    corners = V.map corner points
    corner p = (dot along (p `minus` origin), dot into (p `minus` origin))
    (left, wide) = range (V.map fst corners)
    (top, high) = range (V.map snd corners)
    range values = (V.minimum values, V.maximum values - V.minimum values)
    columns = floorRoot (fromInteger (square wide) / (fromInteger a * right * right))
    rows = floorRoot (fromInteger (square high) / (fromInteger b * down * down))
    square n = n * n
    rectangle =
      V.length corners == 4
        && V.all (\(x, y) -> x `elem` [left, left + wide] && y `elem` [top, top + high]) corners
    count
      | rectangle = Just (columns * rows)
      | columns * rows * toInteger (V.length corners) > most = Nothing
      | otherwise = Just (toInteger (length cells))
    cells =
      [ (r, c)
        | r <- [0 .. rows - 1],
          let near = filter (meetsRow r) sides,
          c <- [0 .. columns - 1],
          rectangle || onFace near r c
      ]
    -- Everything times twice the denominators of a cell's width and height is whole.
    timesX x = 2 * denominator right * x
    timesY y = 2 * denominator down * y
    sides = cyclicPairs [(timesX x, timesY y) | (x, y) <- V.toList corners]
    middleX = timesX left + denominator right * wide
    middleY = timesY top + denominator down * high
    -- The line between columns j - 1 and j is at middleX + across (2 j) sqrt a, the middle of
    -- column j at middleX + across (2 j + 1) sqrt a.
    across k = (k - columns) * numerator right
    downTo k = (k - rows) * numerator down
    meetsRow r (p, q) =
      not (both (\(_, y) -> below y north <= 0) || both (\(_, y) -> below y south >= 0))
      where
        (north, south) = (downTo (2 * r), downTo (2 * r + 2))
        both holds = holds p && holds q
    onFace near r c = not (any meetsCell near) && odd (length (filter passesMiddle near))
      where
        (west, east) = (across (2 * c), across (2 * c + 2))
        (north, south) = (downTo (2 * r), downTo (2 * r + 2))
        (middleAcross, middleDown) = (across (2 * c + 1), downTo (2 * r + 1))
        -- A side that meets the row misses the rectangle iff one of these lines separates them.
        meetsCell (p, q) =
          not
            ( both (\(x, _) -> beside x west <= 0)
                || both (\(x, _) -> beside x east >= 0)
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

-- | Where more tests than this would be needed for a face, its cells are not counted: about a
-- second of them.
mostTests :: Integer
mostTests = 100000

-- | The sign of r + s sqrt a + t sqrt b, where a and b are not negative.
signOf :: Integer -> Integer -> Integer -> Integer -> Integer -> Integer
signOf a b r s t
  | first * signum t >= 0 = signum (first + signum t)
  | otherwise = first * sign2 a (r * r + s * s * a - t * t * b) (2 * r * s)
  where
    first = sign2 a r s

-- | The sign of r + s sqrt a.
sign2 :: Integer -> Integer -> Integer -> Integer
sign2 a r s
  | a == 0 || s == 0 = signum r
  | signum r * signum s >= 0 = signum (signum r + signum s)
  | otherwise = signum r * signum (r * r - s * s * a)

-- | The grid with the most cells of those that a face has from each of its vertices; of equal ones
-- the first in its walk. Of a face with many vertices, so many are tried that they have
-- 'triedFirst' corners together: its first one, and those that begin the longest upper sides.
bestGrid :: Mesh -> (Rational, Rational) -> Walk -> Grid
bestGrid it (right, down) walk
  | diagonal < max right down ^ (2 :: Int) * fromInteger (meshDenominator it) ^ (2 :: Int) =
    (gridOf it (right, down) walk) {gridCount = Just 0, gridCells = []}
  | otherwise = better (map (gridWithin share it (right, down) . from) tried)
  where
    size = U.length walk
    share = mostTests `div` toInteger (length tried)
    from k = U.drop k walk U.++ U.take k walk
    tried
      | size * size <= triedFirst = [0 .. size - 1]
      | otherwise = 0 : take (triedFirst `div` size - 1) (sortOn (Down . upper) [1 .. size - 1])
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

-- | How many corners the frames together have that are tried of a face.
triedFirst :: Int
triedFirst = 65536
