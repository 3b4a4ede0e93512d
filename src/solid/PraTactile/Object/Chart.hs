-- | A face with a square lattice on it, exactly: where its points lie in the face's plane, for
-- cutting it into triangles, and where in space.
--
-- In the face's frame ("PraTactile.Object.Frame") a corner lies at (x / sqrt a, y / sqrt b) with
-- whole x and y, and the lattice's point (i, j), i steps of t millimetres to the right of the
-- lattice's origin and j below it, at
--
-- > (u / sqrt a + m + t i,  v / sqrt b + n + t j)
--
-- with fractions u, v, m, n: of a block that is centred on the face (u, v) is the middle of the box
-- round the corners, of one at a margin 0. Stretched by sqrt a and sqrt b corners are whole, and
-- the lattice is where it is by two roots, which 'planeOf' replaces by fractions: a stretched face
-- with a stretched lattice. On it all that lies in one row or column of the lattice, and all
-- corners that lie on a line, do so still, and a root that is a multiple of the other one stays
-- that multiple; so three points that lay on a line do, and with fractions near enough to the roots
-- no three turn another way. Whether they are near enough is tried: 'sameTurn' tells it of three
-- points.
--
-- In space, with E from the walk's first vertex o to its last one and N the outward normal, whole
-- vectors over a denominator d of the corners' coordinates, and F = E x N, a = E^2 d^2, b = a N^2,
-- the point (x, y) of the frame at the height z above the face is
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

-- | A face with a lattice.
data Chart = Chart
  { chartFrame :: Frame,
    -- | t
    step :: !Rational,
    -- | u and m
    across :: !(Rational, Rational),
    -- | v and n
    downwards :: !(Rational, Rational),
    latticeOrigin :: ExactPoint,
    -- | one step to the right and one down
    stepRight :: ExactPoint,
    stepDown :: ExactPoint,
    -- | one millimetre up from the face
    unitUp :: ExactPoint,
    corners :: V.Vector ExactPoint
  }

-- | A point or a way in space: millimetres along x, y and z.
data ExactPoint = ExactPoint !Radicals !Radicals !Radicals

-- | The chart of a face, whose walk is of vertices that there are, with a lattice of steps of so
-- many millimetres. Its origin is where the anchor has the upper left corner of a block of so many
-- rows and columns of cells, which are so many steps wide and high. None where the face has no
-- frame.
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
    -- p + q sqrt a + r sqrt c + s sqrt (a c)
    vector p q r s = ExactPoint (number 0) (number 1) (number 2)
      where
        number i = fraction (p i) `plus` root1 (q i) `plus` root2 (r i) `plus` root12 (s i)
    part :: Int -> V3 -> Integer
    part i (V3 x y z) = case i of
      0 -> x
      1 -> y
      _ -> z
    -- The middle of the box, and so many cells of so many steps from the first of a block on.
    centred (Span from size) cells count first =
      ((2 * from + size) % 2, t * fromInteger (cells * (2 * first - count)) / 2)

-- | A point of a chart.
data Spot
  = -- | the corner at this place of the walk
    Corner !Int
  | -- | so many steps to the right of the lattice's origin and below it
    Lattice !Integer !Integer
  deriving stock (Eq, Ord, Show)

-- | The chart stretched, so that all is whole.
data Plane = Plane
  { planeMetric :: Metric,
    -- | where a point lies; y goes up
    planePoint :: Spot -> V2,
    -- | of three points that turn left here, whether it is certain that they do so on the face
    sameTurn :: Spot -> Spot -> Spot -> Bool
  }

-- | The chart with fractions for the roots that have so many binary digits behind the point.
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
    -- The roots times the scale, and how much less than the true ones they are at most.
    (rootA, rootB, missing)
      | exact = (near a, near b, 0)
      | Just ratio <- exactRoot (a % b) =
        let (u, v) = (numerator ratio, denominator ratio)
            one = near (b `quot` (v * v))
         in (u * one, v * one, max u v)
      | otherwise = (near a, near b, 1)
    near n = floorRoot (fromInteger (n * scale * scale))
    -- All that is a fraction is whole if multiplied by this.
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
        -- By how much a way may be too short or too long along an axis, and its product with
        -- another one.
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

-- | Where a point lies in space, so many millimetres above the face.
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

further :: ExactPoint -> ExactPoint -> ExactPoint
further (ExactPoint x y z) (ExactPoint x' y' z') =
  ExactPoint (plus x x') (plus y y') (plus z z')

scaledWay :: Rational -> ExactPoint -> ExactPoint
scaledWay k (ExactPoint x y z) = ExactPoint (times k x) (times k y) (times k z)
