{-# OPTIONS_HADDOCK hide #-}

-- | How probable a displacement is, and which is the most probable: correlation as evidence, the
-- robot's accuracy as prior.
module PraTactile.Registration.Correlation
  ( -- * Probability of a displacement
    logLikelihood,
    Prior (..),
    logPrior,

    -- * The search
    mostProbable,
  )
where

import Data.List (foldl')
import PraTactile.Composite.Blend (Taxels, minus, plus)
import PraTactile.Image.Correlate (Overlap (..))
import PraTactile.Registration.Model (normalLog)
import PraTactile.Registration.Settings (Registration (..))

-- | The log-likelihood ratio of an overlap whose image and reference show the same relief to one
-- whose have nothing in common. It is the profile likelihood of n pairs of normal values with
-- correlation rho, -(n/2) ln (1 - rho^2), for rho > 0, else 0: n times the mutual information of
-- two normal variables with that correlation.
--
-- In rho both variances are enlarged by the given variance of the noise. So the accidental
-- correlations of two blank patches, of which the largest among some seventy displacements would
-- look telling, say next to nothing, and the prior decides.
logLikelihood :: Double -> Overlap -> Double
logLikelihood noise (Overlap n vf vc cov)
  | n <= 0 || cov <= 0 || vf + noise <= 1e-12 || vc + noise <= 1e-12 = 0
  | otherwise = negate (n / 2) * log (1 - min 0.9999 rhoSquared)
  where
    rhoSquared = cov * cov / ((vf + noise) * (vc + noise))

-- | A normal distribution of displacements: its mean, and its variance along each axis in square
-- taxels.
data Prior = Prior
  { priorMean :: !Taxels,
    priorVariance :: !Double
  }
  deriving stock (Eq, Show)

-- | The logarithm of a displacement's prior probability density, up to a constant.
logPrior :: Prior -> Taxels -> Double
logPrior (Prior (mx, my) variance) (x, y) = normalLog variance (squared (x - mx) + squared (y - my))
  where
    squared t = t * t

-- | The most probable displacement by the overlap at each and the prior: the best of those whole
-- taxels from the start, no further than the radius, and then the best a half, a quarter and an
-- eighth of a taxel from there, along x and then along y.
--
-- An overlap counts for no more pixels than the one at the start. The likelihood takes each pixel
-- that leaves the overlap for one that chance must explain, but neighbouring pixels of relief
-- resemble each other, and to reward a larger overlap would draw smooth images together.
mostProbable :: Registration -> (Taxels -> Overlap) -> Prior -> Double -> Taxels -> Taxels
mostProbable settings overlapOf prior radius start = snd (foldl' refined coarse steps)
  where
    coarse = best (scored start) [start `plus` by | by <- whole]
    whole = [(i, j) | j <- line, i <- line, i * i + j * j <= radius * radius]
    line = let r = fromIntegral (floor radius :: Int) in [negate r .. r]
    steps = [1 / 2, 1 / 4, 1 / 8]
    refined found step = along (0, step) (along (step, 0) found)
    along by found@(_, shift) = best found [shift `minus` by, shift `plus` by]
    best = foldl' (\found shift -> better found (scored shift))
    better a b = if fst b > fst a then b else a
    scored shift = (logLikelihood noise (capped (overlapOf shift)) + logPrior prior shift, shift)
    -- More than 0 for a sensor without noise, so that rounding errors on flat images say nothing.
    noise = max 1e-9 (registrationNoise settings * registrationNoise settings)
    capped overlap = overlap {overlapWeight = min most (overlapWeight overlap)}
    most = overlapWeight (overlapOf start)
