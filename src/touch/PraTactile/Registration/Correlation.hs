{-# OPTIONS_HADDOCK hide #-}

-- | The posterior of a displacement: correlation gives the likelihood, the robot's accuracy the
-- prior.
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

-- | The log-likelihood ratio of an overlap: image and reference show one relief, or have nothing in
-- common. It is the profile likelihood of n pairs of normal values with correlation rho: -(n/2) ln
-- (1 - rho^2) for rho > 0, else 0. That is n times the mutual information of two normal variables
-- with that correlation.
--
-- The given noise variance enlarges both variances in rho. Two blank patches then have next to no
-- likelihood ratio, and the prior decides. Without it, the largest chance correlation among some
-- seventy displacements would look significant.
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

-- | Log prior density of a displacement, up to a constant.
logPrior :: Prior -> Taxels -> Double
logPrior (Prior (mx, my) variance) (x, y) = normalLog variance (squared (x - mx) + squared (y - my))
  where
    squared t = t * t

-- | The most probable displacement, given the overlap at each displacement, the prior, the radius
-- and the start. It is the best whole-taxel displacement within the radius of the start. Then it is
-- refined by a half, a quarter and an eighth of a taxel, along x and then along y.
--
-- An overlap counts for at most as many pixels as the one at the start. The likelihood takes every
-- pixel of an overlap for independent evidence, but neighbouring pixels of relief resemble each
-- other. To reward a larger overlap would draw smooth images together.
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
    -- Above 0 even for a sensor without noise, so that rounding errors on flat images do not count.
    noise = max 1e-9 (registrationNoise settings * registrationNoise settings)
    capped overlap = overlap {overlapWeight = min most (overlapWeight overlap)}
    most = overlapWeight (overlapOf start)
