-- | The sizes of the sensor and of the symbols that it reads (the paper's sections III and IV),
-- once for simulation, reading, objects and pictures; and the formulas of plane geometry that
-- several of these need. Lengths in millimetres are of the type that
-- is calculated with: exact as a 'Rational', the nearest machine number as a 'Double'.
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

-- | The sensing elements along each side of the sensor.
sensorSide :: Int
sensorSide = 16

-- | The width of a symbol in taxels.
symbolWidth :: Int
symbolWidth = 8

-- | The height of a symbol in taxels, seen upright on its face.
symbolHeight :: Int
symbolHeight = 12

-- | How far a symbol stands out of its face, in millimetres: 1.5875.
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

-- | An angle in degrees as one in radians.
toRadians :: Double -> Double
toRadians angle = angle * pi / 180
{-# INLINE toRadians #-}

-- | An angle in radians as one in degrees.
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

-- | A place or a displacement, to the right and down, turned clockwise about the origin by that
-- many degrees.
--
-- >>> rotated 90 (1, 2)
-- (-2.0,1.0)
rotated :: Double -> (Double, Double) -> (Double, Double)
rotated angle = \(x, y) -> (c * x - s * y, s * x + c * y)
  where
    (c, s) = cosineSine angle
{-# INLINE rotated #-}

-- | Where the parabola through three values, at -1, 0 and 1, is highest; 'Nothing' where it has no
-- highest place. Within half a step of the middle if the middle value is the largest.
--
-- >>> parabolaVertex 0 3 2
-- Just 0.25
parabolaVertex :: Double -> Double -> Double -> Maybe Double
parabolaVertex before here after
  | bend < 0 = Just ((before - after) / (2 * bend))
  | otherwise = Nothing
  where
    bend = before - 2 * here + after
