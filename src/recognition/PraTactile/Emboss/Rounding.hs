-- | What was embossed as a polyhedron with rational points: those that it has, where they are
-- rational, or near ones.
module PraTactile.Emboss.Rounding
  ( Precision (..),
    Rounded (..),
    rounded,
    Misshapen (..),
    collision,
  )
where

import Data.Maybe (isJust)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Emboss
import PraTactile.Object.Chart (ExactPoint (..))
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Enclosure (nearest)
import PraTactile.Object.Mesh
import PraTactile.Object.Radicals
import PraTactile.Object.Validity
import PraTactile.Object.Vector
import PraTactile.Object.WingedEdge (Solid, solidMesh)

-- | Which numbers coordinates may be.
data Precision
  = -- | those of 32 bits (binary32 of IEEE 754)
    Binary32
  | -- | fractions, and those of 64 bits where a coordinate is none
    Binary64
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
  = -- | So many points become others', and so many triangles lose their area or turn over.
    Melted Int Int
  | -- | Coordinates of so many points are no fractions.
    Irrational Int
  deriving stock (Eq, Show)

-- | The triangles with their points rounded. Points that are no vertices of the object are named
-- E1, E2, .., but for names that it has. O(n log n).
rounded :: Precision -> Embossed -> Either Misshapen Rounded
rounded precision made
  | precision == Fractions && irrational > 0 = Left (Irrational irrational)
  | alike > 0 || flat > 0 = Left (Melted alike flat)
  | otherwise = Right (Rounded it (V.maximum (V.zipWith furthest (embossedPoints made) placed)))
  where
    irrational = V.length (V.filter (not . rational) (embossedPoints made))
    placed = V.map (nearPoint way) (embossedPoints made)
    way = case precision of
      Binary32 -> Way single single
      _ -> Way id double
    it = roundedBy way made
    firsts = firstAlike (meshPoints it)
    alike = U.length (U.ifilter (/=) firsts)
    -- With coordinates of 64 bits a triangle faces where it does.
    flat
      | precision == Binary32 = V.length (V.filter turnedOver (meshWalks it))
      | otherwise = 0
    fine = roundedBy (Way double double) made
    turnedOver walk = dot (facing it walk) (facing fine walk) <= 0
    facing :: Mesh -> Walk -> V3
    facing one = doubleArea . cornersOf one

-- | What becomes of coordinates that are fractions, and of others.
data Way = Way (Rational -> Rational) (Rational -> Rational)

-- | To the nearest number of 32 bits, and of 64.
single, double :: Rational -> Rational
single = toRational . (fromRational :: Rational -> Float)
double = toRational . (fromRational :: Rational -> Double)

-- | The polyhedron whose points are moved so.
roundedBy :: Way -> Embossed -> Mesh
roundedBy way made = mesh (subjectName (embossedSubject made)) names over points walks
  where
    (over, points) = overOne (map (nearPoint way) (V.toList (embossedPoints made)))
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

-- | The first two triangles that have something in common beside a corner or a side, as where
-- symbols on faces that look at each other run into one another, to within the rounding of numbers
-- of 64 bits. On a convex solid there is nothing to look for.
collision :: Solid -> Embossed -> Maybe Defect
collision object made = case reportComponents (examine (solidMesh object)) of
  [piece] | componentConvex piece == Just True -> Nothing
  _ -> intersecting (examine (roundedBy (Way double double) made))
