{-# OPTIONS_HADDOCK hide #-}

-- | What was embossed as a polyhedron with the coordinates that a format has, held against the
-- exact surface.
--
-- With A the exact area vector of a triangle and A' that of its rounded corners, V and V' the
-- volumes, and h the height of the relief, a rounded surface is accepted where
--
-- > no two points become one
-- > |A' - A| <= |A| / 2       for each triangle: it faces the same way, within 30 degrees
-- > |x' - x| <= h / 100       for each coordinate
-- > |V' - V| <= V / 100
--
-- and no two of its triangles cut each other. The first two fail where triangles are about as small
-- as the steps between neighbouring numbers. The third keeps the relief what is felt: 'h' is a
-- taxel. The fourth fails on solids thinner than these steps, which triangles alone do not show.
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

-- | Which numbers coordinates may be.
data Precision
  = -- | those of 32 bits (binary32 of IEEE 754)
    Binary32
  | -- | decimal numbers, and those of 64 bits where a coordinate is none
    Decimals
  | -- | fractions
    Fractions
  deriving stock (Eq, Show)

-- | A polyhedron, and by how many millimetres the coordinate was moved that was moved furthest.
data Rounded = Rounded
  { roundedMesh :: Mesh,
    roundedMost :: Double
  }

-- | Why there is no such polyhedron.
data Misshapen
  = -- | So many points become others', and so many triangles lose their area or turn.
    Melted Int Int
  | -- | A coordinate would be moved by so many millimetres, which is too much of this height of the
    -- relief.
    Shifted Double Rational
  | -- | The surface would enclose this volume in place of the exact one.
    Deflated Rational Volume
  | -- | Triangles would cut each other that do not do so before they are rounded.
    Cut
  | -- | Symbols run into another face or its symbols.
    Collided
  | -- | Coordinates of so many points are no fractions.
    Irrational Int
  deriving stock (Eq, Show)

-- | The triangles with their points rounded. Points that are no vertices of the object are named
-- E1, E2, .., but for names that it has. Whether triangles cut each other is asked by 'uncut'. O(n
-- log n).
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
    -- Both area vectors over the product of the squares of both denominators.
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
    -- Fractions on both sides of the root, as near as 64 binary digits more than it has.
    (below, above) = if s == 0 then (0, 0) else (root / unit, (root + 1) / unit)
    root = fromInteger (floorRoot (s * unit * unit)) :: Rational
    unit = fromInteger (2 ^ (64 :: Int) * denominator s)

-- | What becomes of coordinates that are fractions, and of others.
data Way = Way (Rational -> Rational) (Rational -> Rational)

-- | Fractions as they are, and other numbers to 64 binary digits more than the relief is high: what
-- the exact surface is held to be.
finely :: Embossed -> Way
finely made = Way id (\x -> fromInteger (round (x / step)) * step)
  where
    step = embossedHeight made / 2 ^ (64 :: Int)

-- | To the nearest number of 32 bits, and of 64.
single, double :: Rational -> Rational
single = toRational . (fromRational :: Rational -> Float)
double = toRational . (fromRational :: Rational -> Double)

-- | To a decimal number: itself where it is one.
decimal :: Rational -> Rational
decimal x
  | without 5 (without 2 (denominator x)) == 1 = x
  | otherwise = double x
  where
    without p n = case n `quotRem` p of
      (q, 0) -> without p q
      _ -> n :: Integer

-- | The polyhedron whose points are moved so.
roundedBy :: Way -> Embossed -> Mesh
roundedBy way made = movedTo (V.map (nearPoint way) (embossedPoints made)) made

-- | The polyhedron whose points are moved to these.
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

-- | How far a point was moved along an axis at most, millimetres.
furthest :: ExactPoint -> Point -> Double
furthest (ExactPoint x y z) (Point a b c) = maximum [off x a, off y b, off z c]
  where
    off number near = abs (nearest (fromRational . subtract near) number)

-- | Refuses a surface of which two triangles have something in common beside a corner or a side:
-- because symbols on faces that look at each other run into one another, or because rounding made
-- it so. On a convex solid that is at least as thick as a thousand times what coordinates were
-- moved, there is nothing to look for: its inscribed sphere is no smaller than V / S, with S the
-- surface.
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
