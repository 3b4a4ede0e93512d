{-# OPTIONS_HADDOCK hide #-}

-- | The log-likelihood ratios of two overlapping frames by relative displacement, whatever they
-- show.
module PraTactile.Registration.AllPairs.Pair
  ( Pair (..),
    pairOf,
    pairReach,
    highestNear,
    byFrame,
    gridStep,
  )
where

import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Registration.Neighbours (OverlappingPair (..))
import PraTactile.Registration.Numbers (mostReach)
import PraTactile.Registration.Overlap
import PraTactile.Registration.Settings

-- | Two frames, by number, with their log-likelihood ratios.
data Pair = Pair
  { pairFirst :: !Int,
    pairSecond :: !Int,
    -- | The greatest L: the log-likelihood ratio of one relief to two.
    pairMost :: !Double,
    -- | exp (L - the greatest), by the second's grid displacement minus the first's. Both axes go
    -- in whole taxels up to 'pairReach', row by row.
    pairShares :: !(Vector Float)
  }

-- | The largest relative displacement of two frames beside the nominal one, taxels. It is two
-- standard deviations of their difference, for the robot's largest error.
pairReach :: Registration -> Int
pairReach settings = max 1 (min mostReach (ceiling (2 * sqrt 2 * snd (sigmasFor settings))))

-- | Compares a pair, given the grid points nearest to the nominal places of all frames.
-- Displacements beyond 'pairReach' are ignored.
pairOf :: Registration -> ReliefModel -> Boxed.Vector (Int, Int) -> OverlappingPair -> Pair
pairOf settings relief points (OverlappingPair k l step _) =
  Pair k l most (V.map (\t -> realToFrac (exp (t - most))) logs)
  where
    most = V.maximum logs
    logs = overlapLogs relief (k, l) step grid
    grid = Displacements (stepX - reach, stepY - reach) (side, side)
    reach = pairReach settings
    side = 2 * reach + 1
    (stepX, stepY) = gridStep (points Boxed.! k) (points Boxed.! l)

-- | The relative grid displacement with the highest L within a taxel of the given one, and the
-- probability that both frames show one relief there.
highestNear :: Registration -> Pair -> (Int, Int) -> ((Int, Int), Double)
highestNear settings pair (x0, y0) = (highest, share / max 1e-300 (share + apart))
  where
    apart = exp (negate (pairMost pair))
    share = realToFrac found :: Double
    (found, highest) = maximum [(at x y, (x, y)) | y <- [y0 - 1 .. y0 + 1], x <- [x0 - 1 .. x0 + 1]]
    reach = pairReach settings
    at x y
      | max (abs x) (abs y) > reach = 0
      | otherwise = pairShares pair V.! ((y + reach) * (2 * reach + 1) + x + reach)

-- | The step from one grid point to another, taxels.
gridStep :: (Int, Int) -> (Int, Int) -> (Int, Int)
gridStep (x, y) (x', y') = (x' - x, y' - y)

-- | Groups values by frame, given the number of frames and pairs of a frame's number and a value.
byFrame :: Int -> [(Int, a)] -> Boxed.Vector [a]
byFrame count said = Boxed.accumulate (flip (:)) (Boxed.replicate count []) (Boxed.fromList said)
