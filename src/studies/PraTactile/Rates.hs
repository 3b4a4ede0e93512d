{-# LANGUAGE BangPatterns #-}

-- | How often damaged patches are located right, wrong, or refused, by simulation. Readings of
-- patches at random positions are decoded twice: from symbols alone (hard), and from the same
-- cells' class probabilities (soft). "PraTactile.Rates.Noise" has the model of the readings.
module PraTactile.Rates
  ( -- * Damage
    Damage (..),
    noiseFor,
    errorRate,

    -- * Trials
    Radius (..),
    TrialSetup,
    trialSetup,
    setupArray,
    setupShape,
    SetupError (..),
    Seed (..),
    simulate,
    simulations,

    -- * Rates
    Rates (..),
    exactRates,
    module PraTactile.Rates.Tally,
  )
where

import Data.List (foldl')
import Data.Proxy (Proxy (..))
import PraTactile.Array (Shape (..))
import PraTactile.Field
import PraTactile.Locate.Query (Radius (..))
import PraTactile.Rates.Damage
import PraTactile.Rates.Decoding
import PraTactile.Rates.Exact
import PraTactile.Rates.Formulas (Rates (..))
import PraTactile.Rates.Noise
import PraTactile.Rates.Setup
import PraTactile.Rates.Tally
import PraTactile.Rates.Trial
import System.Random (StdGen, genWord64, mkStdGen)

-- | The seed of the random numbers of trials.
newtype Seed = Seed Int
  deriving stock (Eq, Show)

-- | Runs this number of trials from a seed. Hard decoding uses this radius.
simulate :: KnownField k => Radius -> TrialSetup k -> Damage -> Int -> Seed -> RatesTally
simulate radius setup damage = withNoise radius setup (noiseOf setup damage) (damageErasures damage)

-- | Runs this number of trials in parts of a thousand that can be computed in parallel and must be
-- merged. Each part has a seed of its own, which also depends on the patches' shape and the damage,
-- so that the lines of a table are independent.
simulations :: KnownField k => Radius -> TrialSetup k -> Damage -> Int -> Seed -> [RatesTally]
simulations radius setup damage trials (Seed seed) =
  [ withNoise
      radius
      setup
      sigma
      (damageErasures damage)
      (min 1000 (trials - start))
      (Seed (mixed (own ++ [i])))
    | (i, start) <- zip [0 ..] [0, 1000 .. trials - 1]
  ]
  where
    sigma = noiseOf setup damage
    own =
      [ seed,
        fromIntegral (rows shape),
        fromIntegral (columns shape),
        parts (damageErrors damage),
        parts (damageErasures damage)
      ]
    shape = setupShape setup
    parts x = round (1e12 * x)
    mixed = foldl' (\h x -> fromIntegral (fst (genWord64 (mkStdGen (h * 1000003 + x))))) 0

-- | The standard deviation of the noise with which symbols have the damage's error rate.
noiseOf :: forall k. KnownField k => TrialSetup k -> Damage -> Double
noiseOf _ = noiseFor (fieldOrder (Proxy :: Proxy k)) . damageErrors

-- | @withNoise radius setup sigma missing trials seed@ runs trials with noise of standard deviation
-- sigma, in which each cell is missing with the given probability.
withNoise :: KnownField k => Radius -> TrialSetup k -> Double -> Double -> Int -> Seed -> RatesTally
withNoise radius setup sigma missing trials = \(Seed seed) -> go trials (mkStdGen seed) noTrials
  where
    go :: Int -> StdGen -> RatesTally -> RatesTally
    go !left g !tally
      | left <= 0 = tally
      | otherwise =
        let (trial, g') = drawTrial setup sigma missing g
         in go (left - 1) g' (count tally (decodeTrial radius setup trial))
