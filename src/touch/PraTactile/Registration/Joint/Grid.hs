-- | The displacements that a frame may have from its nominal place.
module PraTactile.Registration.Joint.Grid
  ( Grid (..),
    gridOf,
    gridSpacing,
    onGrid,
    priorAlong,
  )
where

import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Model (normalLog, placesPerTaxel)
import PraTactile.Registration.Search (Registration (..), searchRadius)

-- | The displacements that are considered.
data Grid = Grid
  { -- | How far, in places.
    gridReach :: !Int,
    -- | The robot's standard deviation, in places.
    gridSigma :: !Double
  }

-- | The displacements that the robot's accuracy leaves.
gridOf :: Registration -> Grid
gridOf settings =
  Grid
    (max 2 (min 64 (ceiling (gridSpacing * searchRadius settings))))
    (gridSpacing * registrationSigma settings)

-- | Places to the taxel.
gridSpacing :: Double
gridSpacing = fromIntegral placesPerTaxel

-- | A nominal place as the nearest grid point, and what is left, in places.
onGrid :: Taxels -> ((Int, Int), (Double, Double))
onGrid (x, y) = ((round x', round y'), (x' - whole x', y' - whole y'))
  where
    (x', y') = (x * gridSpacing, y * gridSpacing)
    whole t = fromIntegral (round t :: Int)

-- | The logarithm of the prior along one axis, for a displacement in places from the grid point.
priorAlong :: Grid -> Double -> Int -> Double
priorAlong grid rest d = normalLog (gridSigma grid * gridSigma grid) (t * t)
  where
    t = fromIntegral d - rest
