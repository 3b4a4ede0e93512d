{-# OPTIONS_HADDOCK hide #-}

-- | Layouts of all frames that would hold if the robot's positions were wrong as a whole, beside
-- the error of each. Neither the lattice of symbols nor the array need refute them.
module PraTactile.Registration.Layout
  ( Layout (..),
    layouts,
  )
where

import Data.List (nub, sort, sortOn)
import Data.Ord (Down (..))
import PraTactile.Composite (LayoutCause (..))
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Lattice (cellSteps)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Registration.Numbers (groupShare, leastGap, mostGroups, mostLines)
import PraTactile.Sensor.Frame (SensorPose (..))
import PraTactile.Sensor.Manifest (Axes, alongAxes, axesNamed, straight)

-- | A hypothesis about the places of all frames.
data Layout = Layout
  { layoutCause :: !LayoutCause,
    -- | Its share of the prior probability of faults of its kind.
    layoutShare :: !Double,
    -- | The place of each frame, in their order; for a slip, the places as given.
    layoutPlaces :: [Taxels],
    -- | The rows and columns of cells by which each frame slips.
    layoutSteps :: [(Int, Int)]
  }

-- | All alternatives to the given places. Given are the scales across and down that the frames make
-- likely, the group of each frame (frames that show the same symbols), and the places.
layouts :: [(Double, Double)] -> [Int] -> [Taxels] -> [Layout]
layouts scales groups places =
  [ ofAll (OtherAxes axes) (axesShare axes)
    | (_, axes) <- axesNamed,
      axes /= straight
  ]
    ++ concat [ofScales found scales | not (null scales)]
    ++ ofScales (1 - found) [(0.5, 1), (2, 1), (1, 0.5), (1, 2)]
    ++ [ofAll Anywhere 1]
    ++ slips 1 (beyond fst ++ beyond snd)
    ++ slips groupShare [map (== g) groups | several > 1, g <- some]
  where
    -- Scales that the frames make likely have half of the prior of all scales.
    found = if null scales then 0 else 0.5
    ofScales share these =
      [ofAll (uncurry OtherScale scale) (share / fromIntegral (length these)) | scale <- these]
    ofAll cause share =
      Layout cause share (map (placeUnder cause) places) (map (const (0, 0)) places)
    -- One of some sets of frames slips, by any cell.
    slips share sets =
      [ Layout
          Slip
          (share / fromIntegral (4 * length sets))
          places
          [if moved then cell else (0, 0) | moved <- set]
        | set <- sets,
          cell <- cellSteps
      ]
    several = 1 + maximum (-1 : groups)
    some = spacedOut mostGroups [0 .. several - 1]
    beyond part = [map ((> t) . part) places | t <- lines' part]
    -- Between neighbouring rows or columns of frames.
    lines' part =
      take mostLines . map snd . sortOn (Down . fst) $
        [ (b - a, (a + b) / 2)
          | let ts = nub (sort (map part places)),
            (a, b) <- zip ts (drop 1 ts),
            b - a > leastGap
        ]

-- | Moves a place, in the robot's coordinates, as a fault of all places would.
placeUnder :: LayoutCause -> (Double, Double) -> (Double, Double)
placeUnder cause (x, y) = case cause of
  OtherAxes axes -> let SensorPose x' y' _ = alongAxes axes (SensorPose x y 0) in (x', y')
  OtherScale across down -> (across * x, down * y)
  _ -> (x, y)

-- | The prior share of other axes: two fifths each for x or y negated, a fifth for the five others
-- together.
axesShare :: Axes -> Double
axesShare axes
  | axes `elem` oneNegated = 0.4
  | otherwise = 0.2 / 5
  where
    oneNegated = [a | (name, a) <- axesNamed, name `elem` ["-x,y", "x,-y"]]
