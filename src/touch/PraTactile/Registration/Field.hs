{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The displacements that a frame may have from its nominal place, and how probable the robot's
-- error makes each.
module PraTactile.Registration.Field
  ( Grid (..),
    gridOf,
    gridSpacing,
    gridOctaves,
    onGrid,

    -- * The robot's error
    priorsAlong,
    Squares (..),
    sigmaLogs,
    sigmaShares,
    displacementLog,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Model (logSum, normalLog)
import PraTactile.Registration.Numbers (placesPerTaxel, sigmasPerOctave)
import PraTactile.Registration.Settings (Registration (..), sigmasFor)

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

-- | One standard deviation to an octave, in places.
gridOctaves :: Grid -> [Double]
gridOctaves = every . gridSigmas
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

-- | The variance of a displacement along one axis, in square places: that of the robot's error, and
-- that of a place within the grid's cell around it.
displacementVariance :: Double -> Double
displacementVariance sigma = sigma * sigma + 1 / 12

-- | pi_sigma along one axis, of the displacements of a place that lies so many places beyond its
-- grid point: from @-gridReach@ to @gridReach@, each from the one nearer to the grid point by a
-- ratio, which shrinks from one to the next as those of normal densities do.
priorsAlong :: Grid -> Double -> Double -> Vector Double
priorsAlong grid sigma rest = V.reverse (V.drop 1 (outward (negate rest))) <> outward rest
  where
    outward beyond =
      V.unfoldrN
        (gridReach grid + 1)
        (\(!p, !ratio) -> Just (p, (p * ratio, ratio * shrink)))
        ( exp (normalLog v (beyond * beyond)) / sqrt (2 * pi * v),
          exp (normalLog v (1 - 2 * beyond))
        )
    shrink = exp (normalLog v 2)
    v = displacementVariance sigma

-- | What displacements tell of sigma: how many there are, and the sum of their squares, as it is
-- expected of each, in square places.
data Squares = Squares !Double !Double

instance Semigroup Squares where
  Squares n s <> Squares n' s' = Squares (n + n') (s + s')

instance Monoid Squares where
  mempty = Squares 0 0

-- | The logarithms of how likely these make each of 'gridSigmas', up to a constant.
sigmaLogs :: Grid -> Squares -> [Double]
sigmaLogs grid (Squares n s) =
  [normalLog v s - n * log v | v <- map displacementVariance (gridSigmas grid)]

-- | How probable each of 'gridSigmas' is.
sigmaShares :: Grid -> Squares -> [Double]
sigmaShares grid told = map (exp . subtract total) logs
  where
    logs = sigmaLogs grid told
    total = logSum logs

-- | The logarithm, up to a constant, of a displacement's prior by what others tell of sigma, from
-- its square in square places.
displacementLog :: Grid -> Squares -> Double -> Double
displacementLog grid others square = logSum (sigmaLogs grid (others <> Squares 1 square))
