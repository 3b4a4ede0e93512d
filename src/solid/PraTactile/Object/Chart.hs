-- | A face with a square lattice on it, exactly: the places of its points in the face's plane, for
-- triangulation, and in space.
--
-- In the face's frame ("PraTactile.Object.Frame") a corner is at (x / sqrt a, y / sqrt b) with
-- integers x and y. The lattice point (i, j) is i steps of t millimetres to the right of the
-- lattice's origin and j steps below it:
--
-- > (u / sqrt a + m + t i,  v / sqrt b + n + t j)
--
-- with fractions u, v, m, n. For a block that is centred on the face, (u, v) is the centre of the
-- corners' bounding box; for a block at a margin it is 0.
--
-- Scaled by sqrt a and sqrt b, corners become integers, and the lattice's coordinates contain two
-- roots. 'planeOf' replaces the roots by fractions, which makes a stretched face with a stretched
-- lattice. This keeps points of one lattice row or column on a line, and also corners on a line. A
-- root that is a multiple of the other stays that multiple, so all collinear points stay collinear.
-- If the fractions are close enough to the roots, no three points change their turning direction;
-- 'sameTurn' checks this for three points.
--
-- In space, let o be the walk's first vertex, E the vector from o to the last one, and N the
-- outward normal, as integer vectors over the common denominator d of the corners. Let F = E x N, a
-- = E^2 d^2 and b = a N^2. Then the frame's point (x, y), at height z above the face, is
--
-- > o + x E / |E| + y F / (|E| |N|) + z N / |N|.
module PraTactile.Object.Chart
  ( Chart,
    chartOf,
    Spot (..),

    -- * In the plane
    Plane (..),
    planeOf,

    -- * In space
    ExactPoint (..),
    pointOn,
  )
where

import Data.Maybe (isJust)
import Data.Ratio (denominator, numerator, (%))
import qualified Data.Vector as V
import PraTactile.Object.Cells (Anchor (..))
import PraTactile.Object.Frame
import PraTactile.Object.Mesh
import PraTactile.Object.Number (plus, times)
import PraTactile.Object.Polygon (V2 (..), turn)
import PraTactile.Object.Radicals
import PraTactile.Object.Triangulation (Metric (..))
import PraTactile.Object.Vector hiding (plus)

-- | A face with a lattice. The letters are those of the module's formulas.
data Chart = Chart
  { chartFrame :: FaceFrame,
    -- | the step t, in millimetres
    step :: !Rational,
    -- | u and m
    across :: !(Rational, Rational),
    -- | v and n
    downwards :: !(Rational, Rational),
    latticeOrigin :: ExactPoint,
    -- | the vectors of one step to the right, and of one step down
    stepRight :: ExactPoint,
    stepDown :: ExactPoint,
    -- | the vector of one millimetre outward from the face
    unitUp :: ExactPoint,
    corners :: V.Vector ExactPoint
  }

-- | A point or vector in space, in millimetres along x, y and z.
data ExactPoint = ExactPoint !Radicals !Radicals !Radicals

-- | The chart of a face. Arguments: the polyhedron; the face's walk, which must consist of existing
-- vertices; the lattice's step in millimetres; the width and height of a cell in steps; the anchor
-- of a block of cells, whose upper left corner is the lattice's origin; the block's numbers of rows
-- and columns. 'Nothing' if the face has no frame.
chartOf ::
  Mesh ->
  Walk ->
  Rational ->
  (Integer, Integer) ->
  Anchor ->
  (Integer, Integer) ->
  Maybe Chart
chartOf it walk t (wide, high) anchor (rows, columns) = charted <$> frameOf it walk
  where
    charted frame =
      Chart
        { chartFrame = frame,
          step = t,
          across = (u, m),
          downwards = (v, n),
          latticeOrigin =
            vector
              (\i -> part i o % d + u * along i / da + v * into i / (da * c))
              (\i -> m * along i / a)
              (const 0)
              (\i -> n * into i / (a * c)),
          stepRight = vector (const 0) (\i -> t * along i / a) (const 0) (const 0),
          stepDown = vector (const 0) (const 0) (const 0) (\i -> t * into i / (a * c)),
          unitUp = vector (const 0) (const 0) (\i -> fromInteger (part i normal) / c) (const 0),
          corners = V.map (\p -> vector (\i -> part i p % d) (const 0) (const 0) (const 0)) points
        }
      where
        da = fromInteger d * a
        along i = fromInteger (part i e) :: Rational
        into i = fromInteger (part i f) :: Rational
        (u, m) = case anchor of
          Margin right _ -> (0, right)
          Centred -> centred (spanAcross frame) wide columns 0
          CentredPart (_, whole) (_, column) -> centred (spanAcross frame) wide whole column
        (v, n) = case anchor of
          Margin _ down -> (0, down)
          Centred -> centred (spanDown frame) high rows 0
          CentredPart (whole, _) (row, _) -> centred (spanDown frame) high whole row
    (d, points) = lowestTerms (meshDenominator it) (cornersOf it walk)
    o = firstOf points
    e = V.foldl (\_ p -> p) o points `minus` o
    normal = doubleArea points
    f = cross e normal
    (ee, nn) = (dot e e, dot normal normal)
    (a, c) = (fromInteger ee, fromInteger nn) :: (Rational, Rational)
    base = coprimeBase [ee, nn]
    rooted n = let root = rootIn base n in \k -> k `times` root
    (root1, root2, root12) = (rooted ee, rooted nn, rooted (ee * nn))
    -- The number p + q sqrt a + r sqrt c + s sqrt (a c) for each coordinate i. Here a is E^2 and c
    -- is N^2.
    vector p q r s = ExactPoint (number 0) (number 1) (number 2)
      where
        number i = fraction (p i) `plus` root1 (q i) `plus` root2 (r i) `plus` root12 (s i)
    part :: Int -> V3 -> Integer
    part i (V3 x y z) = case i of
      0 -> x
      1 -> y
      _ -> z
    -- The centre of the box, and the offset of the block's first cell in steps.
    centred (Span from size) cells count first =
      ((2 * from + size) % 2, t * fromInteger (cells * (2 * first - count)) / 2)

-- | A point of a chart.
data Spot
  = -- | the corner at this index of the walk
    Corner !Int
  | -- | the lattice point this many steps to the right of the lattice's origin and below it
    Lattice !Integer !Integer
  deriving stock (Eq, Ord, Show)

-- | The chart, stretched to integer coordinates, for triangulation.
data Plane = Plane
  { -- | the lengths of the plane's unit steps, for angles as they are on the face
    planeMetric :: Metric,
    -- | the place of a point; y points up
    planePoint :: Spot -> V2,
    -- | for three points that turn left here, whether they certainly turn left on the face
    sameTurn :: Spot -> Spot -> Spot -> Bool
  }

-- | The plane in which the roots are replaced by fractions with this number of binary digits after
-- the point.
planeOf :: Int -> Chart -> Plane
planeOf digits chart =
  Plane
    { planeMetric = Metric (b `quot` common) (a `quot` common),
      planePoint = point,
      sameTurn = surely
    }
  where
    frame = chartFrame chart
    (a, b) = (frameAcross frame, frameDown frame)
    common = gcd a b
    square n = isJust (exactRoot (fromInteger n))
    exact = square a && square b
    scale = if exact then 1 else 2 ^ digits :: Integer
    -- The roots times the scale, and the largest amounts by which they are too small.
    (rootA, rootB, missing)
      | exact = (near a, near b, 0)
      | Just ratio <- exactRoot (a % b) =
        let (u, v) = (numerator ratio, denominator ratio)
            one = near (b `quot` (v * v))
         in (u * one, v * one, max u v)
      | otherwise = (near a, near b, 1)
    near n = floorRoot (fromInteger (n * scale * scale))
    -- A multiple that makes all fractions integers.
    over = 2 * foldr (lcm . denominator) 1 [step chart, snd (across chart), snd (downwards chart)]
    point spot = case spot of
      Corner k ->
        let (x, y) = frameNumerators frame V.! k
         in V2 (over * scale * x) (negate (over * scale * y))
      Lattice i j ->
        V2
          (numerator (fromInteger over * fst (across chart)) * scale + multiple across i * rootA)
          ( negate
              ( numerator (fromInteger over * fst (downwards chart)) * scale
                  + multiple downwards j * rootB
              )
          )
    multiple side k = numerator (fromInteger over * (snd (side chart) + step chart * fromInteger k))
    surely p q r = exact || turn (point p) (point q) (point r) > doubt
      where
        V2 ux uy = way p q
        V2 vx vy = way p r
        way from to =
          let (V2 x y, V2 x' y') = (point from, point to) in V2 (abs (x' - x)) (abs (y' - y))
        -- The largest error of a vector along an axis, and of its product with another one.
        off = 2 * maximum (map offOf [p, q, r])
        offOf spot = case spot of
          Corner _ -> 0
          Lattice i j -> missing * max (abs (multiple across i)) (abs (multiple downwards j))
        doubt
          | all onLattice [p, q, r] = 0
          | otherwise = off * (ux + uy + vx + vy) + 2 * off * off
    onLattice spot = case spot of
      Lattice _ _ -> True
      Corner _ -> False

-- | A point of a chart in space. Arguments: the chart; the height above the face in millimetres;
-- the point.
pointOn :: Chart -> Rational -> Spot -> ExactPoint
pointOn chart height spot
  | height == 0 = onFace
  | otherwise = onFace `further` scaledWay height (unitUp chart)
  where
    onFace = case spot of
      Corner k -> corners chart V.! k
      Lattice i j ->
        latticeOrigin chart
          `further` scaledWay (fromInteger i) (stepRight chart)
          `further` scaledWay (fromInteger j) (stepDown chart)

-- | The sum of a point and a vector.
further :: ExactPoint -> ExactPoint -> ExactPoint
further (ExactPoint x y z) (ExactPoint x' y' z') =
  ExactPoint (plus x x') (plus y y') (plus z z')

-- | A vector times a number.
scaledWay :: Rational -> ExactPoint -> ExactPoint
scaledWay k (ExactPoint x y z) = ExactPoint (times k x) (times k y) (times k z)
