-- | The cells of symbols that lie wholly on a face, whatever simple polygon it is, with holes or
-- without, decided exactly in the face's frame ("PraTactile.Object.Frame").
--
-- A block of cells is centred on the box round the face's corners, or begins at a margin. A cell,
-- as an open rectangle, meets no side of a rim and has its middle in the polygon: then it lies in
-- it, its rim included. All that asks for signs of r + s sqrt a + t sqrt b with whole r, s and t.
module PraTactile.Object.Cells
  ( -- * Cells of a block
    Anchor (..),
    cellsOn,
    cellsAmong,
    allOn,
    blockCorner,

    -- * Grids
    Grid (..),
    gridOf,
    gridWithin,
    bestGrid,
    begunAnywhere,
    triedFirst,
  )
where

import Data.Containers.ListUtils (nubOrdOn)
import Data.List (sortOn)
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import Data.Ratio (denominator, numerator)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Frame
import PraTactile.Object.Mesh
import PraTactile.Object.Number (plus)
import PraTactile.Object.Radicals
import PraTactile.Object.Rims
import PraTactile.Object.Vector hiding (plus)

-- | Where a block of cells begins.
data Anchor
  = -- | it has its middle where the box round all corners has it
    Centred
  | -- | it is that part of a block of so many rows and columns, which has its middle there, that
    -- begins at this row and column of it
    CentredPart !(Integer, Integer) !(Integer, Integer)
  | -- | so many millimetres right of and below the walk's first vertex
    Margin !Rational !Rational
  deriving stock (Eq, Ord, Show)

-- | The upper left corner of a block of so many rows and columns, in millimetres right of and below
-- the walk's first vertex; cells are so many millimetres wide and high.
blockCorner :: Frame -> (Rational, Rational) -> Anchor -> (Integer, Integer) -> (Radicals, Radicals)
blockCorner frame (right, down) anchor size = case anchor of
  Margin x y -> (fraction x, fraction y)
  Centred -> centred size (0, 0)
  CentredPart whole from -> centred whole from
  where
    centred (rows, columns) (r, c) =
      ( centre overAcross spanAcross (fromInteger (2 * c - columns) * right),
        centre overDown spanDown (fromInteger (2 * r - rows) * down)
      )
    centre over part twice = fraction (twice / 2) `plus` over frame (middle (part frame))
    middle (Span from long) = fromInteger (2 * from + long) / 2

-- | The lines between the cells along one axis, and through their middles: the k-th is at @linesAt
-- + (linesFirst + k linesStep) sqrt a@, times 'linesTimes'; even ones lie between cells.
data Lines = Lines
  { linesTimes :: !Integer,
    linesAt :: !Integer,
    linesFirst :: !Integer,
    linesStep :: !Integer
  }

-- | The lines of cells of this size: so many half cells after the middle of the span, or from a
-- margin.
linesOf :: Span -> Rational -> Either Integer Rational -> Lines
linesOf (Span from size) width begin = case begin of
  Left halves ->
    Lines
      { linesTimes = 2 * denominator width,
        linesAt = denominator width * (2 * from + size),
        linesFirst = halves * numerator width,
        linesStep = numerator width
      }
  Right m ->
    Lines
      { linesTimes = 2 * denominator width * denominator m,
        linesAt = 0,
        linesFirst = 2 * denominator width * numerator m,
        linesStep = numerator width * denominator m
      }

-- | The lines of a block of so many rows and columns.
linesBetween ::
  Frame -> (Rational, Rational) -> Anchor -> (Integer, Integer) -> (Lines, Lines)
linesBetween frame (right, down) anchor (rows, columns) =
  (linesOf (spanAcross frame) right across, linesOf (spanDown frame) down below)
  where
    (across, below) = case anchor of
      Centred -> (Left (negate columns), Left (negate rows))
      CentredPart (high, wide) (r, c) -> (Left (2 * c - wide), Left (2 * r - high))
      Margin x y -> (Right x, Right y)

-- | Whether the face is a rectangle on which all cells of such a block lie. O(1).
allOn :: Frame -> (Rational, Rational) -> Anchor -> (Integer, Integer) -> Bool
allOn frame cell anchor (rows, columns) =
  isRectangle frame
    && within (frameAcross frame) (spanAcross frame) xs columns
    && within (frameDown frame) (spanDown frame) ys rows
  where
    (xs, ys) = linesBetween frame cell anchor (rows, columns)
    within root (Span from size) lines' count =
      line root lines' 0 from >= 0 && line root lines' (2 * count) (from + size) <= 0
    line root it k n =
      signOf root 0 (linesAt it - linesTimes it * n) (linesFirst it + k * linesStep it) 0

-- | Which cells of a block of so many rows and columns lie on the face, by row and column, row by
-- row. O(cells * corners).
cellsOn :: Frame -> (Rational, Rational) -> Anchor -> (Integer, Integer) -> [(Integer, Integer)]
cellsOn frame cell anchor size@(rows, columns) =
  cellsAmong frame cell anchor size [(r, [0 .. columns - 1]) | r <- [0 .. rows - 1]]

-- | Which of these cells of the block do, told by rows and their columns.
cellsAmong ::
  Frame ->
  (Rational, Rational) ->
  Anchor ->
  (Integer, Integer) ->
  [(Integer, [Integer])] ->
  [(Integer, Integer)]
cellsAmong frame cell anchor (rows, columns) among =
  [ (r, c)
    | (r, candidates) <- among,
      let near = filter (meetsRow r) sides,
      c <- candidates,
      onFace near r c
  ]
  where
    (a, b) = (frameAcross frame, frameDown frame)
    (xs, ys) = linesBetween frame cell anchor (rows, columns)
    sides =
      rimPairs
        [(linesTimes xs * x, linesTimes ys * y) | (x, y) <- V.toList (frameNumerators frame)]
    across k = linesFirst xs + k * linesStep xs
    downTo k = linesFirst ys + k * linesStep ys
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
    beside x at = signOf a 0 (x - linesAt xs) (negate at) 0
    below y at = signOf 0 b (y - linesAt ys) 0 (negate at)
    turned (px, py) (qx, qy) x y =
      signOf
        a
        b
        ((qx - px) * (linesAt ys - py) - (qy - py) * (linesAt xs - px))
        (negate (qy - py) * x)
        ((qx - px) * y)

-- | The grid of a face: as many whole columns and rows as the box round all corners has room for,
-- centred on it.
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
    -- | a number of cells that there are at least: the count, where there is one, or else the area
    -- less what sides can cut, a cell for each line that a side crosses and three at its ends
    gridAtLeast :: Integer,
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
gridWithin most it cell@(right, down) walk =
  maybe (Grid walk (0, 0) 0 0 (Just 0) 0 []) grid (frameOf it walk)
  where
    grid frame =
      Grid
        { gridWalk = walk,
          gridSize = (nearestDouble wide, nearestDouble high),
          gridColumns = columns,
          gridRows = rows,
          gridCount = count,
          gridAtLeast = fromMaybe atLeast count,
          gridCells = cells
        }
      where
        (_, (wide, high)) = frameExtent frame
        columns = room frameAcross spanAcross right
        rows = room frameDown spanDown down
        room root part size =
          floorRoot
            ( fromInteger (spanLength (part frame) ^ (2 :: Int))
                / (fromInteger (root frame) * size * size)
            )
        count
          | isRectangle frame = Just (columns * rows)
          | columns * rows * toInteger (U.length walk) > most = Nothing
          | otherwise = Just (toInteger (length cells))
        -- In cells; the rounding of its terms is far below a thousandth.
        atLeast = max 0 (floor (0.999 * abs (sum (map swept sides)) / 2 - sum (map cut sides)))
        sides =
          rimPairs
            [ (nearestDouble x / fromRational right, nearestDouble y / fromRational down)
              | (x, y) <- frameCorners frame
            ]
        swept ((x1, y1), (x2, y2)) = x1 * y2 - x2 * y1
        cut ((x1, y1), (x2, y2)) = abs (x2 - x1) + abs (y2 - y1) + 3 :: Double
        cells
          | isRectangle frame = [(r, c) | r <- [0 .. rows - 1], c <- [0 .. columns - 1]]
          | otherwise = cellsOn frame cell Centred (rows, columns)

-- | Where more tests than this would be needed for a face, its cells are not counted: about a
-- second of them.
mostTests :: Integer
mostTests = 100000

-- | The walk begun at each of its vertices, the upper side along a rim; of upper sides in one
-- direction the first, for the block is centred all the same. Of a face with many such directions,
-- so many that the walks have 'triedFirst' corners together: the first, and those that begin the
-- longest upper sides.
begunAnywhere :: Mesh -> Walk -> [Walk]
begunAnywhere it walk
  | length begins * size <= triedFirst = map from begins
  | otherwise =
    map from (take (triedFirst `div` size) (take 1 begins ++ sortOn long (drop 1 begins)))
  where
    size = U.length walk
    from k = U.drop k walk U.++ U.take k walk
    begins = nubOrdOn (primitive . upper) (beginnings (U.toList walk))
    upper k = point k `minus` point ((k + size - 1) `mod` size)
    point k = meshPoints it V.! (walk U.! k)
    long k = Down (dot (upper k) (upper k))

-- | The grid with the most cells of those that a face has begun anywhere; of equal ones the first.
bestGrid :: Mesh -> (Rational, Rational) -> Walk -> Grid
bestGrid it (right, down) walk
  | diagonal < max right down ^ (2 :: Int) * fromInteger (meshDenominator it) ^ (2 :: Int) =
    (gridOf it (right, down) walk) {gridCount = Just 0, gridCells = []}
  | otherwise = better (map (gridWithin share it (right, down)) tried)
  where
    share = mostTests `div` toInteger (length tried)
    tried = begunAnywhere it walk
    better grids = case grids of
      first : others -> foldl (\g h -> if gridCount h > gridCount g then h else g) first others
      [] -> gridOf it (right, down) walk
    -- The square of the diagonal of the box round it, which is no shorter than any width.
    diagonal =
      let corners = V.toList (cornersOf it walk)
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
