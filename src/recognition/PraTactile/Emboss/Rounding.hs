{-# OPTIONS_HADDOCK hide #-}

-- | The embossed surface as a polyhedron whose coordinates are rounded to those of a file format.
--
-- Let A be the exact area vector of a triangle and A' that of its rounded corners, V and V' the
-- volumes, and h the height of the relief. A rounded surface is accepted if
--
-- > no two points become one
-- > |A' - A| <= |A| / 2       for each triangle: it faces the same way, within 30 degrees
-- > |x' - x| <= h / 100       for each coordinate
-- > |V' - V| <= V / 100
--
-- and no two of its triangles intersect. The first two conditions fail if triangles are about as
-- small as the steps between neighbouring numbers. The third keeps the relief as it is felt; h is
-- one taxel. The fourth fails for solids thinner than these steps, which triangles alone do not
-- show.
module PraTactile.Emboss.Rounding
  ( Precision (..),
    Rounded (..),
    rounded,
    uncut,
    Misshapen (..),
  )
where

import Control.Monad (when)
import Data.Maybe (isJust, isNothing)
import Data.Ratio (denominator, (%))
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Emboss
import PraTactile.Object.Chart (ExactPoint (..))
import PraTactile.Object.Description
import PraTactile.Object.Mesh
import PraTactile.Object.Radicals
import PraTactile.Object.Validity
import PraTactile.Object.Vector
import PraTactile.Object.WingedEdge (Solid, solidMesh)

-- | The numbers that coordinates may be.
data Precision
  = -- | numbers of 32 bits (binary32 of IEEE 754)
    Binary32
  | -- | decimal numbers, and numbers of 64 bits for a coordinate that has no finite decimal
    Decimals
  | -- | rational numbers
    Fractions
  deriving stock (Eq, Show)

-- | A polyhedron, and the largest change of a coordinate by rounding, in millimetres.
data Rounded = Rounded
  { roundedMesh :: Mesh,
    roundedMost :: Double
  }

-- | Why a surface cannot be rounded.
data Misshapen
  = -- | The first number of points coincide with others, and the second number of triangles lose
    -- their area or turn.
    Melted Int Int
  | -- | A coordinate would move by the first number of millimetres, more than a hundredth of the
    -- second, the height of the relief.
    Shifted Double Rational
  | -- | The surface would enclose this volume in place of the exact one.
    Deflated Rational Volume
  | -- | Rounding would make triangles intersect.
    Cut
  | -- | Symbols run into another face or its symbols.
    Collided
  | -- | This number of points have irrational coordinates.
    Irrational Int
  deriving stock (Eq, Show)

-- | Rounds the points. Points that are not vertices of the object are named E1, E2 and so on,
-- skipping names that the object has. Refuses by the conditions above; 'uncut' checks for
-- intersecting triangles. O(n log n).
rounded :: Precision -> Embossed -> Either Misshapen Rounded
rounded precision made = do
  when (precision == Fractions && irrational > 0) (Left (Irrational irrational))
  when (alike > 0 || spoilt > 0) (Left (Melted alike spoilt))
  when (toRational most > height / 100) (Left (Shifted most height))
  when (differs (enclosedBy it) (embossedVolume made)) $
    Left (Deflated (enclosedBy it) (embossedVolume made))
  pure (Rounded it most)
  where
    height = embossedHeight made
    irrational = V.length (V.filter (not . rational) (embossedPoints made))
    near = V.map (nearPoint way) points
    it = movedTo near made
    most = V.maximum (V.zipWith furthest points near)
    points = embossedPoints made
    way = case precision of
      Binary32 -> Way single single
      Decimals -> Way decimal double
      Fractions -> Way id double
    firsts = firstAlike (meshPoints it)
    alike = U.length (U.ifilter (/=) firsts)
    spoilt = V.length (V.filter turned (meshWalks it))
    exact = roundedBy (finely made) made
    -- Twice both area vectors, times the squares of both denominators: integers.
    turned walk = 4 * dot off off > dot true true
      where
        true = facing exact it walk
        off = facing it exact walk `minus` true
    facing :: Mesh -> Mesh -> Walk -> V3
    facing one other walk =
      scaled (meshDenominator other * meshDenominator other) (doubleArea (cornersOf one walk))

-- | Whether a volume differs from r + sqrt s by more than a hundredth of it.
differs :: Rational -> Volume -> Bool
differs found (Volume r s) = found < least || found > most
  where
    (least, most) = (99 / 100 * (r + below), 101 / 100 * (r + above))
    -- Rational bounds on sqrt s, at most 2^-64 apart.
    (below, above) = if s == 0 then (0, 0) else (root / unit, (root + 1) / unit)
    root = fromInteger (floorRoot (s * unit * unit)) :: Rational
    unit = fromInteger (2 ^ (64 :: Int) * denominator s)

-- | How to round rational coordinates, and others.
data Way = Way (Rational -> Rational) (Rational -> Rational)

-- | Keeps rational numbers and rounds others to 2^-64 of the relief's height. This stands for the
-- exact surface.
finely :: Embossed -> Way
finely made = Way id (\x -> fromInteger (round (x / step)) * step)
  where
    step = embossedHeight made / 2 ^ (64 :: Int)

-- | The nearest numbers of 32 bits and of 64 bits.
single, double :: Rational -> Rational
single = toRational . (fromRational :: Rational -> Float)
double = toRational . (fromRational :: Rational -> Double)

-- | A number that has a finite decimal, unchanged; any other to the nearest number of 64 bits.
decimal :: Rational -> Rational
decimal x
  | without 5 (without 2 (denominator x)) == 1 = x
  | otherwise = double x
  where
    without p n = case n `quotRem` p of
      (q, 0) -> without p q
      _ -> n :: Integer

-- | The polyhedron with its points rounded this way.
roundedBy :: Way -> Embossed -> Mesh
roundedBy way made = movedTo (V.map (nearPoint way) (embossedPoints made)) made

-- | The polyhedron with its points moved to these.
movedTo :: V.Vector Point -> Embossed -> Mesh
movedTo near made = mesh (subjectName (embossedSubject made)) names over points walks
  where
    (over, points) = overOne (V.toList near)
    walks = V.map (\(a, b, c) -> U.fromList [a, b, c]) (embossedTriangles made)
    names = V.take (V.length points) (embossedNames made V.++ V.fromList new)
    own = Set.fromList (V.toList (embossedNames made))
    new =
      take
        (V.length points - V.length (embossedNames made))
        (filter (`Set.notMember` own) [VertexName ('E' : show k) | k <- [1 :: Int ..]])

rational :: ExactPoint -> Bool
rational (ExactPoint x y z) = all (isJust . asFraction) [x, y, z]

nearPoint :: Way -> ExactPoint -> Point
nearPoint (Way ofFractions ofOthers) (ExactPoint x y z) = Point (near x) (near y) (near z)
  where
    near number = maybe (nearest ofOthers number) ofFractions (asFraction number)

-- | The largest change of a point's coordinates, in millimetres.
furthest :: ExactPoint -> Point -> Double
furthest (ExactPoint x y z) (Point a b c) = maximum [off x a, off y b, off z c]
  where
    off number near = abs (nearest (fromRational . subtract near) number)

-- | Refuses a surface in which two triangles have more in common than a corner or a side. Either
-- symbols on faces that look at each other run into one another ('Collided'), or rounding did it
-- ('Cut').
--
-- The test is skipped for a convex solid with volume V and surface S if V / S is at least a
-- thousand times the largest change of a coordinate. The inscribed sphere's radius is at least V /
-- S, so rounding cannot make faces meet.
uncut :: Solid -> Embossed -> Rounded -> Either Misshapen ()
uncut object made (Rounded it most)
  | convex && thick = Right ()
  | isNothing (meeting it) = Right ()
  | isNothing (meeting (roundedBy (finely made) made)) = Left Cut
  | otherwise = Left Collided
  where
    meeting = intersecting . examine
    convex = case reportComponents (examine (solidMesh object)) of
      [piece] -> componentConvex piece == Just True
      _ -> False
    thick = 1000 * most * surface <= nearestVolume (embossedVolume made)
    surface = V.sum (V.map (size . doubleArea . cornersOf it) (meshWalks it))
    size n = squareRoot (dot n n % (4 * meshDenominator it ^ (4 :: Int)))
