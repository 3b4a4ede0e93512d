{-# OPTIONS_HADDOCK hide #-}

-- | A face wrapped on a cylinder, under a flat sensor.
--
-- Unrolled, a cylinder is a plane. Places on the face, and the robot's positions, are arc lengths;
-- only the sensor notices the bend. At each press the sensor lies in the plane that is tangent to
-- the cylinder, of radius R, at the sensor's middle. Let s be the arc length from there across the
-- cylinder's axis, u the distance in the tangent plane, and w the height above it:
--
-- >   - - - + - - -> u       u = R sin (s / R)
-- >  .   '  |  ' . w         w = R cos (s / R) - R
-- > '       | R     '
--
-- An element at u has the face's point at s under it, which is lower by d:
--
-- > s = R asin (u / R),      d = R - sqrt (R^2 - u^2) = u^2 / (R + sqrt (R^2 - u^2))
--
-- (the last form loses no digits where R is large). A relief of height h is added along w; added
-- along the radius it would end h u / R further out. The effect of a lower face depends on the
-- sensor's model. Readings proportional to the height are reduced by d, and are 0 below the tangent
-- plane. A rigid press with a force continues until its tabs carry that force.
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

-- | The cylinder on which a face is wrapped.
data Bend = Bend
  { -- | R, millimetres
    bendRadius :: !Double,
    bendAxis :: !BendAxis
  }
  deriving stock (Eq, Show)

-- | The direction of the cylinder's axis: along the face's x axis or its y axis.
data BendAxis = AboutX | AboutY
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of an axis.
bendAxisName :: BendAxis -> String
bendAxisName axis = case axis of
  AboutX -> "x"
  AboutY -> "y"

-- | The radius, in millimetres, that a cylinder must exceed so that it lies under the whole sensor
-- at any rotation: the greatest distance of an element, or of its tab, from the sensor's middle.
leastRadius :: Sensor -> Double
leastRadius sensor
  | tab > 0 = sqrt (side columns * side columns + side rows * side rows) / 2 + tab / 2
  | otherwise = sqrt (across * across + down * down) / 2
  where
    Sensor {sensorColumns = columns, sensorRows = rows, sensorTaxel = taxel, sensorTab = tab} =
      sensor
    side count = taxel * fromIntegral (count - 1)
    (across, down) = (taxel * fromIntegral columns, taxel * fromIntegral rows)

-- | The largest accepted radius, in millimetres: a thousand kilometres.
longestRadius :: Double
longestRadius = 1e9

-- | The course of a face along one of its axes: straight, or round a circle of this radius (mm).
data Course = Straight | Round !Double
  deriving stock (Eq, Show)

-- | The courses of a face along its x axis and its y axis.
courses :: Maybe Bend -> (Course, Course)
courses bend = case bend of
  Nothing -> (Straight, Straight)
  Just (Bend radius AboutX) -> (Straight, Round radius)
  Just (Bend radius AboutY) -> (Round radius, Straight)

-- | The arc length s, from the sensor's middle to the point under u, both in millimetres. u is
-- clipped to -R..R, where the circle ends.
arc :: Course -> Double -> Double
arc Straight u = u
arc (Round radius) u = radius * asin (max (-1) (min 1 (u / radius)))
{-# INLINE arc #-}

-- | The u above the end of an arc length s. The arc is clipped to a half circle.
chord :: Course -> Double -> Double
chord Straight s = s
chord (Round radius) s = radius * sin (max (-pi / 2) (min (pi / 2) (s / radius)))

-- | The depth d, in millimetres, of the face at u below the sensor's middle.
fall :: Course -> Double -> Double
fall Straight _ = 0
fall (Round radius) u = v * v / (radius + sqrt (radius * radius - v * v))
  where
    v = max (negate radius) (min radius u)
{-# INLINE fall #-}
