{-# OPTIONS_HADDOCK hide #-}

-- | The faces of a solid, each in a plane of its own, and how the planes of two faces with a common
-- edge are put together.
--
-- A face with the walk v_0 .. v_m, the first side e = v_1 - v_0 and a normal n has its corner v at
--
-- > z = r (e . (v - v_0) + i e x (v - v_0) . n / |n|) / (e . e)
--
-- where r is the power of 2 next to the length of e in millimetres: lengths are then within a
-- factor of 2 of millimetres. Since e x (v - v_0) is a multiple k n of the normal, the coordinates
-- are rational but for the root of N = n . n. The plane of a neighbour, in which the common edge
-- runs from a' to b', comes to that in which it runs from a to b by
--
-- > z' -> c z' + d        c = (b - a) conj (b' - a') / |b' - a'|^2        d = a - c a'
--
-- and |b' - a'|^2 is rational. So nothing but roots of the numbers N of the faces and their
-- products comes in, however many faces are unfolded: no root of a root.
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
  { -- | the corners: the real part, and what the imaginary part has before the root
    templateCorners :: !(V.Vector (Rational, Rational)),
    -- | what is under the root
    templateRoot :: !Integer,
    -- | the shortest whole vector outward, at right angles to the face; its length is that root
    templateNormal :: !V3,
    -- | the square of the unit, in square millimetres
    templateUnit :: !Rational
  }
  deriving stock (Eq, Show)

-- | The faces of a solid.
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

-- | A corner, given how many times a root is made a number of the kind wanted.
templateCorner :: (Rational -> Integer -> n) -> Template -> Int -> Planar n
templateCorner make it i = Planar (make x 1) (make y (templateRoot it))
  where
    (x, y) = templateCorners it V.! i

-- | How the plane of the face across a side comes to that of the side's own face, given the two
-- sides of the edge.
neighbourly ::
  Number n =>
  (Rational -> Integer -> n) ->
  Mesh ->
  Surface ->
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
