{-# OPTIONS_HADDOCK hide #-}

-- | The common contents of polyhedron files, and their conversion for writing.
module PraTactile.Format.Solid.Contents
  ( Contents (..),
    Passed (..),
    contents,
    soup,
    Written (..),
    asDecimals,
    asMachine,
  )
where

import Data.Maybe (fromMaybe)
import Data.Ratio (denominator, numerator, (%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Format.Solid.Number
import PraTactile.Object.Description (ObjectName)
import PraTactile.Object.Mesh
import PraTactile.Object.Vector

-- | A polyhedron, and the things in the file that were ignored.
data Contents = Contents
  { contentsMesh :: Mesh,
    contentsPassed :: [Passed]
  }
  deriving stock (Eq, Show)

-- | A kind of thing in a file that was ignored, listed once.
newtype Passed = Passed String
  deriving stock (Eq, Ord, Show)

-- | A polyhedron from its vertices, counted from 1 in the file's order, and the walks of its
-- faces. Equal points become one vertex, the first of them, because many programs write one vertex
-- per corner. The base is that of the numbers' exponents.
contents ::
  ObjectName -> Base -> [Passed] -> V.Vector (Number, Number, Number) -> V.Vector Walk -> Contents
contents name base passed points walks =
  Contents (mesh name names over (V.map (exact V.!) (V.convert kept)) joined) passed
  where
    (over, exact) = overCommon base points
    firsts = firstAlike exact
    kept = U.ifilter (==) firsts
    places = U.replicate (U.length firsts) 0 U.// zip (U.toList kept) [0 :: Int ..]
    joined = V.map (U.map (\i -> places U.! (firsts U.! i))) walks
    names = V.map (unnamed (V.length points) V.!) (V.convert kept)

-- | A polyhedron from triangles of three points each. Equal points become one vertex; vertices are
-- numbered in order of appearance.
soup :: ObjectName -> Base -> [Passed] -> V.Vector (Number, Number, Number) -> Contents
soup name base passed points = Contents (renumbered (contentsMesh read')) passed
  where
    read' =
      contents name base passed points $
        V.generate (V.length points `div` 3) (\f -> U.enumFromN (3 * f) 3)
    renumbered it =
      withShape
        (unnamed (V.length (meshPoints it)))
        (meshDenominator it)
        (meshPoints it)
        (meshWalks it)
        it

-- | A written file, and the number of coordinates that were rounded because the format cannot hold
-- them.
data Written a = Written {writtenBytes :: a, writtenRounded :: Int}

-- | The coordinates of all vertices as decimal numbers. Where there is no exact decimal number,
-- the nearest machine number's is used.
asDecimals :: Mesh -> Written (V.Vector [String])
asDecimals = coordinates $ \value -> case decimalText value of
  Just exact -> (exact, False)
  Nothing -> (nearest value, True)
  where
    nearest value =
      fromMaybe (show (numerator value `div` denominator value)) $
        decimalText (toRational (fromRational value :: Double))

-- | The coordinates of all vertices as the nearest machine numbers.
asMachine :: RealFloat a => Mesh -> Written (V.Vector [a])
asMachine = coordinates $ \value ->
  let near = fromRational value in (near, toRational near /= value)

-- | The coordinates of all vertices in a format's form. The function also tells whether it changed
-- the number.
coordinates :: (Rational -> (a, Bool)) -> Mesh -> Written (V.Vector [a])
coordinates had it = Written (V.map (map fst) made) (V.sum (V.map (length . filter snd) made))
  where
    made = V.map (\(V3 x y z) -> map (had . (% meshDenominator it)) [x, y, z]) (meshPoints it)
