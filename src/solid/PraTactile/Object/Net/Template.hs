{-# OPTIONS_HADDOCK hide #-}

-- | The faces of a solid, each in its own plane, and the maps between the planes of faces with a
-- common edge.
--
-- Let a face have the walk v_0 .. v_m, the first side e = v_1 - v_0 and a normal n. Its corner v is
-- at
--
-- > z = r (e . (v - v_0) + i e x (v - v_0) . n / |n|) / (e . e)
--
-- where r is the power of 2 nearest to the length of e in millimetres. So lengths are within a
-- factor of 2 of millimetres. Since e x (v - v_0) is a multiple k n of the normal, the coordinates
-- are rational except for the root of N = n . n. Let a common edge run from a to b in a face's
-- plane, and from a' to b' in the neighbour's plane. The neighbour's plane is mapped by
--
-- > z' -> c z' + d        c = (b - a) conj (b' - a') / |b' - a'|^2        d = a - c a'
--
-- and |b' - a'|^2 is rational. So only roots of the faces' numbers N and of their products occur,
-- however many faces are unfolded; there are no nested roots.
module PraTactile.Object.Net.Template
  ( Template (..),
    templates,
    templateCorner,
    neighbourly,
  )
where

import Data.Ratio ((%))
import qualified Data.Vector as V
import Math.NumberTheory.Logarithms (integerLog2)
import PraTactile.Object.Mesh
import PraTactile.Object.Number
import PraTactile.Object.Surface
import PraTactile.Object.Vector hiding (minus, plus)
import qualified PraTactile.Object.Vector as Space

-- | A face in its plane.
data Template = Template
  { -- | the corners: the real part, and the coefficient of the root in the imaginary part
    templateCorners :: !(V.Vector (Rational, Rational)),
    -- | the number N under the root
    templateRoot :: !Integer,
    -- | the shortest outward integer vector normal to the face; its length is the root of N
    templateNormal :: !V3,
    -- | the square of the unit, in square millimetres
    templateUnit :: !Rational
  }
  deriving stock (Eq, Show)

-- | The templates of all faces of a solid.
templates :: Mesh -> V.Vector Template
templates it = V.map template (meshWalks it)
  where
    over = meshDenominator it
    template walk = Template (V.map place points) n2 normal (ee % (over * over) / (r * r))
      where
        points = cornersOf it walk
        origin = firstOf points
        e = (points V.! 1) `Space.minus` origin
        ee = dot e e
        normal = primitive (doubleArea points)
        n2 = dot normal normal
        r = 2 ^^ ((integerLog2 ee - 2 * integerLog2 over) `div` 2) :: Rational
        place v =
          let d = v `Space.minus` origin
           in (r * (dot e d % ee), r * (dot (cross e d) normal % (n2 * ee)))

-- | A corner of a template. The function makes a number from a coefficient and the integer under
-- its root.
templateCorner :: (Rational -> Integer -> n) -> Template -> Int -> Planar n
templateCorner make it i = Planar (make x 1) (make y (templateRoot it))
  where
    (x, y) = templateCorners it V.! i

-- | The map from the plane of the face across an edge to the plane of the first side's face. The
-- pair is the two sides of the edge.
neighbourly ::
  Number n =>
  (Rational -> Integer -> n) ->
  Mesh ->
  FaceSides ->
  V.Vector Template ->
  (Int, Int) ->
  Similarity n
neighbourly make it sides flats (s, t) = Similarity c (a `subtracted` multiplied c a')
  where
    c = stretched (1 / squared) (multiplied (b `subtracted` a) (conjugate (b' `subtracted` a')))
    (a, b) = ends s
    (b', a') = ends t
    ends side = (corner side, corner (nextSide sides side))
    corner side = templateCorner make (flats V.! sideFace sides side) (placeOnWalk sides side)
    squared = dot across across % (meshDenominator it * meshDenominator it) / unit
    across = (meshPoints it V.! sideEnd sides t) `Space.minus` (meshPoints it V.! sideStart sides t)
    unit = templateUnit (flats V.! sideFace sides t)
