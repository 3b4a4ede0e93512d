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

import Data.List (find)
import Data.Maybe (isJust)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Emboss
import PraTactile.Object.Chart (ExactPoint (..))
import PraTactile.Object.Description
import PraTactile.Object.Defect
import PraTactile.Object.Mesh
import PraTactile.Object.Radical
import PraTactile.Object.Validity
import PraTactile.Object.Vector hiding (plus)
import PraTactile.Object.WingedEdge (solidMesh, Solid)

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

-- | The triangles with their points rounded. Points that are no vertices of the object are named E1,
-- E2, .., but for names that it has. O(n log n).
rounded :: Precision -> Embossed -> Either Misshapen Rounded
rounded precision made
  | precision == Fractions && irrational > 0 = Left (Irrational irrational)
  | alike > 0 || flat > 0 = Left (Melted alike flat)
  | otherwise = Right (Rounded it (V.foldl' max 0 (V.map fst placed)))
  where
    irrational = V.length (V.filter (not . rational) (embossedPoints made))
    placed = V.map (moved precision) (embossedPoints made)
    (over, points) = overOne (map snd (V.toList placed))
    walks = V.map (\(a, b, c) -> U.fromList [a, b, c]) (embossedTriangles made)
    it = mesh (subjectName (embossedSubject made)) names over points walks
    firsts = firstAlike points
    alike = U.length (U.ifilter (/=) firsts)
    -- With coordinates of 64 bits a triangle faces where it does.
    (_, fine) = overOne (map (snd . moved Binary64) (V.toList (embossedPoints made)))
    flat
      | precision == Binary32 = V.length (V.filter turnedOver walks)
      | otherwise = 0
    turnedOver walk = dot (facing points walk) (facing fine walk) <= 0
    facing :: V.Vector V3 -> Walk -> V3
    facing at walk = doubleArea (V.map (at V.!) (V.convert walk))
    names = V.take count (embossedNames made V.++ V.fromList (take count new))
    count = V.length (embossedPoints made)
    own = Set.fromList (V.toList (embossedNames made))
    new = filter (`Set.notMember` own) [VertexName ('E' : show k) | k <- [1 :: Int ..]]

rational :: ExactPoint -> Bool
rational (ExactPoint _ x y z) = all (isJust . asFraction) [x, y, z]

-- | A point as it is rounded, and by how much a coordinate of it was moved at most.
moved :: Precision -> ExactPoint -> (Double, Point)
moved precision (ExactPoint over x y z) = (max p (max q r), Point a b c)
  where
    ((p, a), (q, b), (r, c)) = (one x, one y, one z)
    one number = case asFraction number of
      Just exact
        | precision /= Binary32 -> (0, exact)
        | otherwise -> let near = single exact in (abs (fromRational (near - exact)), near)
      Nothing -> let near = nearest rounding over number in (abs (nearest (asDouble . subtract near) over number), near)
    rounding = if precision == Binary32 then single else toRational . asDouble
    single = toRational . (fromRational :: Rational -> Float)
    asDouble = fromRational :: Rational -> Double

-- | The first two triangles that have something in common beside a corner or a side, as where
-- symbols on faces that look at each other run into one another; of solids that are convex none, which
-- is not looked for.
collision :: Solid -> Embossed -> Maybe Defect
collision object made
  | [piece] <- reportComponents (examine (solidMesh object)), componentConvex piece == Just True = Nothing
  | otherwise = case rounded Binary64 made of
    Right found -> find ((== FacesIntersect) . defectKind) (reportDefects (examine (roundedMesh found)))
    Left _ -> Nothing
