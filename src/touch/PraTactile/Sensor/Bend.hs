{-# OPTIONS_HADDOCK hide #-}

-- | A face that is wrapped on a cylinder, under a sensor that is flat.
--
-- Unrolled, a cylinder is a plane: what lies on the face, and where a robot goes on it, is told in
-- arc length, and nothing but the sensor notices that the face is bent. At each press it lies on
-- the cylinder, of radius R, along the tangent plane at its own middle. Let s be the arc length
-- from there across the cylinder's axis, u the distance in the tangent plane, and w the height
-- above it:
--
-- >   - - - + - - -> u       u = R sin (s / R)
-- >  .   '  |  ' . w         w = R cos (s / R) - R
-- > '       | R     '
--
-- so that an element at u has the face's point at s under it, which is lower by d:
--
-- > s = R asin (u / R),      d = R - sqrt (R^2 - u^2) = u^2 / (R + sqrt (R^2 - u^2))
--
-- (the last form loses no digits where R is large). A relief of height h is put upon it along w,
-- where along the radius it would end h u / R further out. What a face gives that is lower is up to
-- the sensor's model: where readings are proportional to the height, they are as much less, and 0
-- below the tangent plane; a rigid press with a force goes on until its tabs bear that.
--
-- A large R is nearly flat: with asin t - t <= (pi / 2 - 1) t^3 on [0, 1],
--
-- > |s| - |u| <= (pi / 2 - 1) |u|^3 / R^2,      d <= u^2 / R.
module PraTactile.Sensor.Bend
  ( Bend (..),
    BendAxis (..),
    bendAxisName,
    leastRadius,
    longestRadius,

    -- * Along one axis of the face
    Course (..),
    courses,
    arc,
    chord,
    fall,
  )
where

import PraTactile.Sensor.Model

-- | A cylinder that a face is wrapped on.
data Bend = Bend
  { -- | R, millimetres
    bendRadius :: !Double,
    bendAxis :: !BendAxis
  }
  deriving stock (Eq, Show)

-- | How the cylinder's axis lies: along the face's x axis or its y axis.
data BendAxis = AboutX | AboutY
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of an axis.
bendAxisName :: BendAxis -> String
bendAxisName axis = case axis of
  AboutX -> "x"
  AboutY -> "y"

-- | The radius, millimetres, that a cylinder must exceed so that all of a sensor has it underneath,
-- however it is turned: as far as its elements, or their tabs, reach from its middle.
leastRadius :: Sensor -> Double
leastRadius sensor
  | tab > 0 = sqrt (side columns * side columns + side rows * side rows) / 2 + tab / 2
  | otherwise = sqrt (across * across + down * down) / 2
  where
    Sensor {sensorColumns = columns, sensorRows = rows, sensorTaxel = taxel, sensorTab = tab} =
      sensor
    side count = taxel * fromIntegral (count - 1)
    (across, down) = (taxel * fromIntegral columns, taxel * fromIntegral rows)

-- | The largest radius that has to be told, millimetres: a thousand kilometres.
longestRadius :: Double
longestRadius = 1e9

-- | How a face runs along one of its axes: straight on, or round a circle of this radius (mm).
data Course = Straight | Round !Double
  deriving stock (Eq, Show)

-- | How a face runs along its x axis and along its y axis.
courses :: Maybe Bend -> (Course, Course)
courses bend = case bend of
  Nothing -> (Straight, Straight)
  Just (Bend radius AboutX) -> (Straight, Round radius)
  Just (Bend radius AboutY) -> (Round radius, Straight)

-- | The arc length s from the sensor's middle to what lies under it at u, both in millimetres. The
-- circle ends at u = R and -R.
arc :: Course -> Double -> Double
arc Straight u = u
arc (Round radius) u = radius * asin (max (-1) (min 1 (u / radius)))
{-# INLINE arc #-}

-- | The u under which an arc length s ends: of a half circle, at most R.
chord :: Course -> Double -> Double
chord Straight s = s
chord (Round radius) s = radius * sin (max (-pi / 2) (min (pi / 2) (s / radius)))

-- | How much lower than the sensor's middle the face lies at u: d, millimetres.
fall :: Course -> Double -> Double
fall Straight _ = 0
fall (Round radius) u = v * v / (radius + sqrt (radius * radius - v * v))
  where
    v = max (negate radius) (min radius u)
{-# INLINE fall #-}
