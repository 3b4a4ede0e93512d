-- | Finds the cells of symbols that lie wholly on a face. The face may be any simple polygon, with
-- or without holes. The decision is exact, in the face's frame ("PraTactile.Object.Frame").
--
-- A block of cells is centred on the bounding box of the face's corners, or begins at a margin. A
-- cell lies on the face, rim included, if it meets no side of a rim as an open rectangle, and its
-- centre is in the polygon. That requires only signs of r + s sqrt a + t sqrt b with integers r, s
-- and t.
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

-- | Where a block of cells lies on a face.
data Anchor
  = -- | its centre is the centre of the corners' bounding box
    Centred
  | -- | it is a part of a larger, centred block. The first pair is the larger block's rows and
    -- columns, the second the row and column at which the part begins.
    CentredPart !(Integer, Integer) !(Integer, Integer)
  | -- | its upper left corner is this many millimetres right of and below the walk's first vertex
    Margin !Rational !Rational
  deriving stock (Eq, Ord, Show)

-- | The upper left corner of a block, in millimetres right of and below the walk's first vertex.
-- Arguments: the frame; the width and height of a cell in millimetres; the anchor; the numbers of
-- rows and columns.
blockCorner ::
  FaceFrame ->
  (Rational, Rational) ->
  Anchor ->
  (Integer, Integer) ->
  (Radicals, Radicals)
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

-- | The lines between the cells along one axis, and through their centres. Line k is at @linesAt +
-- (linesFirst + k linesStep) sqrt a@, all multiplied by 'linesTimes'. Even lines are between cells.
data Lines = Lines
  { linesTimes :: !Integer,
    linesAt :: !Integer,
    linesFirst :: !Integer,
    linesStep :: !Integer
  }

-- | The lines of cells of this size along a span. The first cell begins the given number of half
-- cells after the span's centre, or at a margin.
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

-- | The lines of a block with these numbers of rows and columns.
linesBetween ::
  FaceFrame -> (Rational, Rational) -> Anchor -> (Integer, Integer) -> (Lines, Lines)
linesBetween frame (right, down) anchor (rows, columns) =
  (linesOf (spanAcross frame) right across, linesOf (spanDown frame) down below)
  where
    (across, below) = case anchor of
      Centred -> (Left (negate columns), Left (negate rows))
      CentredPart (high, wide) (r, c) -> (Left (2 * c - wide), Left (2 * r - high))
      Margin x y -> (Right x, Right y)

-- | Whether the face is a rectangle that contains all cells of a block. Arguments: the face's
-- frame; a cell's width and height in millimetres; where the block lies; its numbers of rows and
-- columns. O(1).
allOn :: FaceFrame -> (Rational, Rational) -> Anchor -> (Integer, Integer) -> Bool
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

-- | The cells of a block that lie on the face, by row and column within it, row by row. The
-- arguments are those of 'allOn'. O(cells * corners).
cellsOn :: FaceFrame -> (Rational, Rational) -> Anchor -> (Integer, Integer) -> [(Integer, Integer)]
cellsOn frame cell anchor size@(rows, columns) =
  cellsAmong frame cell anchor size [(r, [0 .. columns - 1]) | r <- [0 .. rows - 1]]

-- | 'cellsOn' for only some cells of the block, given by their rows and the columns in each.
cellsAmong ::
  FaceFrame ->
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
        -- A side that meets the row misses the rectangle exactly if one of these lines separates
        -- them.
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

-- | The grid of a face: as many whole columns and rows as fit the corners' bounding box, centred on
-- it.
data Grid = Grid
  { -- | the walk around the face, from the vertex at which its frame begins
    gridWalk :: Walk,
    -- | the width and height of the bounding box, in millimetres
    gridSize :: (Double, Double),
    -- | the numbers of columns and rows that fit the box
    gridColumns :: Integer,
    gridRows :: Integer,
    -- | the number of cells on the face; 'Nothing' if counting would take too long
    gridCount :: Maybe Integer,
    -- | a lower bound on the number of cells. It is the count if that is known. Otherwise it is the
    -- area minus what sides can cut: a cell for each line that a side crosses, and three at its
    -- ends.
    gridAtLeast :: Integer,
    -- | the cells on the face, by row and column, row by row
    gridCells :: [(Integer, Integer)]
  }
  deriving stock (Eq, Show)

-- | The grid of a flat face with positive area. The pair is the width and height of a cell in
-- millimetres, both positive. O(cells * corners), or O(corners) for a rectangle.
gridOf :: Mesh -> (Rational, Rational) -> Walk -> Grid
gridOf = gridWithin mostTests

-- | 'gridOf' with a limit on the tests of a side against a cell. If the walk's first vertex
-- coincides with its last, there is no frame and no cell.
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
        -- In cells; the rounding error of its terms is far below a thousandth.
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

-- | The most tests for which the cells of a face are counted. They take about a second.
mostTests :: Integer
mostTests = 100000

-- | The face's walk begun at each of its vertices, with the upper side along a rim. If several
-- upper sides have one direction, only the first counts, because the block is centred in the same
-- way. If the walks would have more than 'triedFirst' corners in total, the first one and those
-- with the longest upper sides are returned.
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

-- | The grid with the most cells among those that begin at any vertex of a face; the first of equal
-- ones.
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
    -- The square of the bounding box's diagonal, which is at least any width of the face.
    diagonal =
      let corners = V.toList (cornersOf it walk)
          extent part = maximum (map part corners) - minimum (map part corners)
          V3 x y z =
            V3
              (extent (\(V3 u _ _) -> u))
              (extent (\(V3 _ v _) -> v))
              (extent (\(V3 _ _ w) -> w))
       in fromInteger (x * x + y * y + z * z)

-- | The most corners, over all frames, that are tried for a face.
triedFirst :: Int
triedFirst = 65536
