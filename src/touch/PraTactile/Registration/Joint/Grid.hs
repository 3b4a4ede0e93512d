{-# LANGUAGE FlexibleContexts #-}

-- | The displacements that a frame may have from its nominal place, and how probable the robot's
-- error makes each.
module PraTactile.Registration.Joint.Grid
  ( Grid (..),
    gridOf,
    gridSpacing,
    gridOctaves,
    onGrid,
    priorAlong,
    logSum,
  )
where

import qualified Data.Vector.Generic as G
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Model (normalLog, placesPerTaxel, sigmasPerOctave)
import PraTactile.Registration.Search (Registration (..), sigmasFor)

-- | The displacements that are considered.
data Grid = Grid
  { -- | How far, in places.
    gridReach :: !Int,
    -- | sigma, the standard deviations that the robot's error may have, one as probable as another:
    -- in places, ascending, 'sigmasPerOctave' to each doubling.
    gridSigmas :: ![Double]
  }

-- | The displacements that the robot's accuracy leaves.
gridOf :: Registration -> Grid
gridOf settings =
  Grid
    (max 2 (min 64 (ceiling (gridSpacing * registrationReach settings * most - 1e-9))))
    [ gridSpacing * least * 2 ** (fromIntegral k / fromIntegral sigmasPerOctave)
      | k <- [0 .. round (fromIntegral sigmasPerOctave * logBase 2 (most / least)) :: Int]
    ]
  where
    (least, most) = sigmasFor settings

-- | The same with one standard deviation to an octave.
gridOctaves :: Grid -> Grid
gridOctaves grid = grid {gridSigmas = every (gridSigmas grid)}
  where
    every sigmas = case sigmas of
      sigma : rest -> sigma : every (drop (sigmasPerOctave - 1) rest)
      [] -> []

-- | Places to the taxel.
gridSpacing :: Double
gridSpacing = fromIntegral placesPerTaxel

-- | A nominal place as the nearest grid point, and what is left, in places.
onGrid :: Taxels -> ((Int, Int), (Double, Double))
onGrid (x, y) = ((round x', round y'), (x' - whole x', y' - whole y'))
  where
    (x', y') = (x * gridSpacing, y * gridSpacing)
    whole t = fromIntegral (round t :: Int)

-- | The logarithms of the prior along one axis, for an error of standard deviation sigma, of all
-- displacements in places from the grid point, ascending; the probabilities sum to 1.
priorAlong :: Grid -> Double -> Double -> Vector Double
priorAlong grid rest sigma = V.map (subtract (logSum logs)) logs
  where
    logs = V.generate (2 * gridReach grid + 1) (at . subtract (gridReach grid))
    at d = let t = fromIntegral d - rest in normalLog (sigma * sigma) (t * t)

-- | The logarithm of the sum of what these are the logarithms of, of which there must be some.
logSum :: G.Vector v Double => v Double -> Double
logSum logs = top + log (G.foldl' (\s l -> s + exp (l - top)) 0 logs)
  where
    top = G.maximum logs
{-# INLINE logSum #-}
