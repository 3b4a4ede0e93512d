-- | The sizes of the sensor and of the symbols (the paper's sections III and IV), and formulas of
-- plane geometry that several modules need. Lengths in millimetres have the caller's number type:
-- exact as a 'Rational', rounded as a 'Double'.
--
-- > +----------------+  - - -      columnPitch = 16 taxels across
-- > |   . . . . .    |    |        rowPitch    = 20 taxels down
-- > |   +--------+   |    |
-- > |   | symbol |   |  rowPitch   symbolWidth  = 8 taxels
-- > |   +--------+   |    |        symbolHeight = 12 taxels
-- > |                |    |
-- > +----------------+  - - -      one taxel is 1.5875 mm
-- > |<- columnPitch >|
module PraTactile.Geometry
  ( -- * The sensor
    taxelPitch,
    sensorSide,

    -- * The symbols
    symbolWidth,
    symbolHeight,
    symbolThickness,

    -- * Their distances
    columnPitch,
    rowPitch,

    -- * Angles
    toRadians,
    toDegrees,
    cosineSine,
    rotated,

    -- * Parabolas
    parabolaVertex,
  )
where

import Data.Bifunctor (bimap)
import PraTactile.Symmetry (onOffset, turnedByDegrees)

-- | The distance between neighbouring sensing elements in millimetres: 1.5875, a sixteenth of an
-- inch.
taxelPitch :: Fractional millimetres => millimetres
taxelPitch = 127 / 80
{-# INLINE taxelPitch #-}

-- | The number of sensing elements along each side of the sensor.
sensorSide :: Int
sensorSide = 16

-- | The width of a symbol in taxels.
symbolWidth :: Int
symbolWidth = 8

-- | The height of a symbol in taxels, seen upright on its face.
symbolHeight :: Int
symbolHeight = 12

-- | The height of a symbol's relief above its face, in millimetres: 1.5875.
symbolThickness :: Fractional millimetres => millimetres
symbolThickness = 127 / 80
{-# INLINE symbolThickness #-}

-- | The distance between neighbouring symbols' centres in a row, in taxels: 16 (25.4 mm).
columnPitch :: Num taxels => taxels
columnPitch = 16
{-# INLINE columnPitch #-}

-- | The distance between neighbouring symbols' centres in a column, in taxels: 20 (31.75 mm).
rowPitch :: Num taxels => taxels
rowPitch = 20
{-# INLINE rowPitch #-}

-- | Converts degrees to radians.
toRadians :: Double -> Double
toRadians angle = angle * pi / 180
{-# INLINE toRadians #-}

-- | Converts radians to degrees.
toDegrees :: Double -> Double
toDegrees angle = angle * 180 / pi
{-# INLINE toDegrees #-}

-- | Cosine and sine of an angle in degrees, exact at the multiples of 90.
--
-- >>> cosineSine (-90)
-- (0.0,-1.0)
cosineSine :: Double -> (Double, Double)
cosineSine angle = case turnedByDegrees angle of
  Just symmetry -> bimap fromInteger fromInteger (onOffset symmetry (1, 0))
  Nothing -> (cos (toRadians angle), sin (toRadians angle))

-- | Rotates a place or a displacement (right, down) clockwise about the origin by an angle in
-- degrees.
--
-- >>> rotated 90 (1, 2)
-- (-2.0,1.0)
rotated :: Double -> (Double, Double) -> (Double, Double)
rotated angle = \(x, y) -> (c * x - s * y, s * x + c * y)
  where
    (c, s) = cosineSine angle
{-# INLINE rotated #-}

-- | The place of the maximum of the parabola through three values at -1, 0 and 1; 'Nothing' if it
-- has no maximum. It lies within half a step of the middle if the middle value is the largest.
--
-- >>> parabolaVertex 0 3 2
-- Just 0.25
parabolaVertex :: Double -> Double -> Double -> Maybe Double
parabolaVertex before here after
  | bend < 0 = Just ((before - after) / (2 * bend))
  | otherwise = Nothing
  where
    bend = before - 2 * here + after
