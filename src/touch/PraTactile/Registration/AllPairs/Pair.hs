{-# OPTIONS_HADDOCK hide #-}

-- | What two frames that overlap say of their displacements, whatever they show.
module PraTactile.Registration.AllPairs.Pair
  ( Pair (..),
    pairOf,
    pairReach,
    highestNear,
    byFrame,
    gridStep,
    rest,
  )
where

import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Neighbours (Neighbours (..))
import PraTactile.Registration.Overlap
import PraTactile.Registration.Settings

-- | What two frames say, by their numbers.
data Pair = Pair
  { pairFirst :: !Int,
    pairSecond :: !Int,
    -- | The greatest L: how much likelier, as a natural logarithm, they are of one relief than of
    -- two.
    pairMost :: !Double,
    -- | exp (L - the greatest), by the difference of the second's displacement on the grid and the
    -- first's: whole taxels up to 'pairReach' along both axes, row by row.
    pairShares :: !(Vector Float)
  }

-- | How far from each other two frames may lie beside their nominal displacement, taxels: two
-- standard deviations, of the largest that the robot's error may have.
pairReach :: Registration -> Int
pairReach settings = max 1 (min 12 (ceiling (2 * sqrt 2 * snd (sigmasFor settings))))

-- | What a pair says, given the nominal places of the frames. What lies further apart than
-- 'pairReach' tells nothing.
pairOf :: Registration -> Relief -> Boxed.Vector Taxels -> Neighbours -> Pair
pairOf settings relief places (Neighbours k l step _) =
  Pair k l most (V.map (\t -> realToFrac (exp (t - most))) logs)
  where
    most = V.maximum logs
    logs = overlapLogs relief (k, l) step grid
    grid = Displacements (stepX - reach, stepY - reach) (side, side)
    reach = pairReach settings
    side = 2 * reach + 1
    (stepX, stepY) = gridStep (places Boxed.! k) (places Boxed.! l)

-- | The difference of displacements on the grid at which L of a pair is highest, within a taxel of
-- a given one; and the probability that both frames show one relief there.
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

-- | From the grid point nearest to one place to that nearest to another, taxels.
gridStep :: Taxels -> Taxels -> (Int, Int)
gridStep (x, y) (x', y') = (round x' - round x, round y' - round y)

-- | What is left of a place beyond the nearest grid point.
rest :: Taxels -> Taxels
rest (x, y) = (x - nearest x, y - nearest y)

-- | The nearest whole number.
nearest :: Double -> Double
nearest t = fromIntegral (round t :: Int)

-- | What is said of frames, by frame.
byFrame :: Int -> [(Int, a)] -> Boxed.Vector [a]
byFrame count said = Boxed.accumulate (flip (:)) (Boxed.replicate count []) (Boxed.fromList said)
