{-# LANGUAGE BangPatterns #-}

-- | How often damaged patches are located right, wrong, or refused: simulated readings of patches
-- at random positions, decoded from symbols alone (hard) and from the same cells' class
-- probabilities (soft). "PraTactile.Rates.Noise" says how cells are read.
module PraTactile.Rates
  ( -- * Damage
    Damage (..),
    noiseFor,
    errorRate,

    -- * Trials
    Radius (..),
    Ground,
    ground,
    groundBook,
    groundShape,
    GroundError (..),
    simulate,
    simulations,

    -- * Rates
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
import PraTactile.Rates.Exact
import PraTactile.Rates.Ground
import PraTactile.Rates.Noise
import PraTactile.Rates.Tally
import PraTactile.Rates.Trial
import PraTactile.Rates.Verdict
import System.Random (StdGen, genWord64, mkStdGen)

-- | So many trials, from a seed, hard decoding to this radius.
simulate :: KnownField k => Radius -> Ground k -> Damage -> Int -> Int -> Tally
simulate radius place damage = withNoise radius place (noiseOf place damage) (damageErasures damage)

-- | So many trials from a seed, in parts of a thousand, each with a seed of its own, which are to
-- be merged: to be run at the same time. The seeds are also those of these patches and this damage
-- alone, so that the lines of a table are independent of each other.
simulations :: KnownField k => Radius -> Ground k -> Damage -> Int -> Int -> [Tally]
simulations radius place damage trials seed =
  [ withNoise
      radius
      place
      sigma
      (damageErasures damage)
      (min 1000 (trials - 1000 * i))
      (mixed (own ++ [i]))
    | i <- takeWhile ((< trials) . (* 1000)) [0 ..]
  ]
  where
    sigma = noiseOf place damage
    own =
      [ seed,
        fromIntegral (rows shape),
        fromIntegral (columns shape),
        parts (damageErrors damage),
        parts (damageErasures damage)
      ]
    shape = groundShape place
    parts x = round (1e12 * x)
    mixed = foldl' (\h x -> fromIntegral (fst (genWord64 (mkStdGen (h * 1000003 + x))))) 0

-- | The standard deviation with which symbols are wrong as often.
noiseOf :: forall k. KnownField k => Ground k -> Damage -> Double
noiseOf _ = noiseFor (fieldOrder (Proxy :: Proxy k)) . damageErrors

-- | With noise of this standard deviation, cells missing with this probability, so many trials from
-- a seed.
withNoise :: KnownField k => Radius -> Ground k -> Double -> Double -> Int -> Int -> Tally
withNoise radius place sigma missing trials = \seed -> go trials (mkStdGen seed) noTrials
  where
    go :: Int -> StdGen -> Tally -> Tally
    go !left g !tally
      | left <= 0 = tally
      | otherwise =
        let (trial, g') =
              drawTrial place sigma missing g
         in go (left - 1) g' (count tally (judge radius place trial))
