{-# OPTIONS_HADDOCK hide #-}

-- | What files of polyhedra say, whatever their format, and what can be written of it.
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

-- | A polyhedron, and what of the file is none of it.
data Contents = Contents
  { contentsMesh :: Mesh,
    contentsPassed :: [Passed]
  }
  deriving stock (Eq, Show)

-- | What a file has beside and is passed over, each named once.
newtype Passed = Passed String
  deriving stock (Eq, Ord, Show)

-- | A polyhedron of these vertices, counted from 1 in the file's order, and these walks among them.
-- Equal points are one vertex, the first of them: many programs write a vertex for each corner.
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

-- | A polyhedron of triangles, three points each. Equal points are one vertex; vertices are counted
-- as they come.
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

-- | What is written, and how many coordinates had to be rounded, since the format cannot have them.
data Written a = Written {writtenBytes :: a, writtenRounded :: Int}

-- | The coordinates of all vertices as decimal numbers; where one is none, the nearest machine
-- number's.
asDecimals :: Mesh -> Written (V.Vector [String])
asDecimals = coordinates $ \value -> case decimalText value of
  Just exact -> (exact, False)
  Nothing -> (nearest value, True)
  where
    nearest value =
      fromMaybe (show (numerator value `div` denominator value)) $
        decimalText (toRational (fromRational value :: Double))

-- | The same as the nearest machine numbers.
asMachine :: RealFloat a => Mesh -> Written (V.Vector [a])
asMachine = coordinates $ \value ->
  let near = fromRational value in (near, toRational near /= value)

-- | The coordinates of all vertices as a format has them, each with whether it is another number.
coordinates :: (Rational -> (a, Bool)) -> Mesh -> Written (V.Vector [a])
coordinates had it = Written (V.map (map fst) made) (V.sum (V.map (length . filter snd) made))
  where
    made = V.map (\(V3 x y z) -> map (had . (% meshDenominator it)) [x, y, z]) (meshPoints it)
