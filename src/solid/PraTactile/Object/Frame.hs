-- | The frame of a face. Let the face have the walk v_0 .. v_m and the outward normal n, whose
-- length is twice its area. The frame's origin is v_0. The x axis is along e = v_m - v_0, from the
-- walk's first vertex to its last; the y axis is along f = e x n, into the face. With a = e . e and
-- b = a (n . n), a corner v has the coordinates
--
-- > x = e . (v - v_0) / sqrt a        y = f . (v - v_0) / sqrt b,
--
-- so the numerators are integers, and only the roots may be irrational.
module PraTactile.Object.Frame
  ( FaceFrame (..),
    frameOf,
    frameOfPoints,
    Span (..),
    spanAcross,
    spanDown,
    overAcross,
    overDown,
    frameCorners,
    frameExtent,
    isRectangle,
  )
where

import qualified Data.Vector as V
import PraTactile.Object.Description (Point)
import PraTactile.Object.Mesh
import PraTactile.Object.Number (times)
import PraTactile.Object.Radicals
import PraTactile.Object.Vector hiding (plus)

-- | The corners' numerators, and the numbers under the roots that divide them. The quotients are in
-- millimetres.
data FaceFrame = FaceFrame
  { -- | a, times the square of the denominator of the polyhedron's coordinates
    frameAcross :: !Integer,
    -- | b, times the same square
    frameDown :: !Integer,
    -- | the roots of both
    frameRoots :: (Radicals, Radicals),
    -- | the numerators of x and y, in the order of the walk
    frameNumerators :: !(V.Vector (Integer, Integer))
  }
  deriving stock (Eq, Show)

-- | The frame of a face, whose walk must consist of existing vertices. 'Nothing' if the first
-- vertex coincides with the last, or the area is 0.
frameOf :: Mesh -> Walk -> Maybe FaceFrame
frameOf it walk = frameOver (lowestTerms (meshDenominator it) (cornersOf it walk))

-- | The frame of a face from its corners alone, in the order of its walk. 'Nothing' as for
-- 'frameOf'.
frameOfPoints :: [Point] -> Maybe FaceFrame
frameOfPoints = frameOver . overOne

-- | The frame in lowest terms, so that the roots do not depend on the rest of the object.
frameOver :: (Integer, V.Vector V3) -> Maybe FaceFrame
frameOver (d, points)
  | a == 0 || normal == zero = Nothing
  | otherwise = Just (FaceFrame a b (rootIn base a, rootIn base b) (V.map numerators points))
  where
    origin = firstOf points
    along = V.foldl (\_ p -> p) origin points `minus` origin
    normal = doubleArea points
    into = cross along normal
    a = dot along along * d * d
    b = a * dot normal normal
    base = coprimeBase [a, b]
    numerators p = (dot along (p `minus` origin), dot into (p `minus` origin))

-- | The range of numerators: the least, and the difference to the greatest.
data Span = Span
  { spanFrom :: !Integer,
    spanLength :: !Integer
  }
  deriving stock (Eq, Show)

-- | The range from the leftmost corner to the rightmost.
spanAcross :: FaceFrame -> Span
spanAcross = spanOf . V.map fst . frameNumerators

-- | The range from the uppermost corner to the lowest.
spanDown :: FaceFrame -> Span
spanDown = spanOf . V.map snd . frameNumerators

spanOf :: V.Vector Integer -> Span
spanOf values = Span (V.minimum values) (V.maximum values - V.minimum values)

-- | A numerator along x, or along y, divided by the root: millimetres.
overAcross, overDown :: FaceFrame -> Rational -> Radicals
overAcross frame n = times (n / fromInteger (frameAcross frame)) (fst (frameRoots frame))
overDown frame n = times (n / fromInteger (frameDown frame)) (snd (frameRoots frame))

-- | The corners, in millimetres right of and below the first one.
frameCorners :: FaceFrame -> [(Radicals, Radicals)]
frameCorners frame =
  [ (overAcross frame (fromInteger x), overDown frame (fromInteger y))
    | (x, y) <- V.toList (frameNumerators frame)
  ]

-- | The corners' bounding box: its upper left corner, in millimetres right of and below the first
-- corner, and its width and height.
frameExtent :: FaceFrame -> ((Radicals, Radicals), (Radicals, Radicals))
frameExtent frame = (both spanFrom, both spanLength)
  where
    both part =
      ( overAcross frame (fromInteger (part (spanAcross frame))),
        overDown frame (fromInteger (part (spanDown frame)))
      )

-- | Whether the face is a rectangle along the frame's axes.
isRectangle :: FaceFrame -> Bool
isRectangle frame =
  V.length corners == 4 && V.all (\(x, y) -> x `elem` ends across && y `elem` ends down) corners
  where
    corners = frameNumerators frame
    (across, down) = (spanAcross frame, spanDown frame)
    ends (Span from size) = [from, from + size]
