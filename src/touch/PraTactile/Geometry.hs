-- | The sizes of the sensor and of the symbols that it reads (the paper's sections III and IV),
-- once for simulation, reading, objects and pictures. Lengths in millimetres are of the type that
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
  )
where

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
