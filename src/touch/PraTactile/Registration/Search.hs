{-# OPTIONS_HADDOCK hide #-}

-- | The search for one frame's displacement: correlation as evidence, the robot's accuracy as
-- prior.
module PraTactile.Registration.Search
  ( -- * Settings
    Registration (..),
    standardRegistration,
    supposedSigma,
    sigmasFor,
    searchRadius,
    usable,

    -- * Probability of a displacement
    Prior (..),
    logPrior,
    logLikelihood,

    -- * The search
    Window (..),
    mostProbable,
    independent,
    finestStep,
  )
where

import Data.List (foldl')
import Data.Maybe (fromMaybe)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster)
import PraTactile.Image.Correlate (Overlap (..), Reference, overlapAt)
import PraTactile.Registration.Model (normalLog)

-- | What registration supposes of the robot and the sensor, and how far it goes.
data Registration = Registration
  { -- | The standard deviation of the robot's position error along each axis, in taxels, that the
    -- robot is known for; 'Nothing' where nobody has told.
    registrationSigma :: !(Maybe Double),
    -- | The standard deviation of the sensor's noise, as a share of full scale.
    registrationNoise :: !Double,
    -- | How far from where it is expected a frame is looked for, in standard deviations of the
    -- position error.
    registrationReach :: !Double,
    -- | The most sweeps that register each frame against the others.
    registrationSweeps :: !Int
  }
  deriving stock (Eq, Show)

-- | Position errors that nobody has told, noise of 0.1, a reach of four and a half standard
-- deviations, at most five sweeps.
standardRegistration :: Registration
standardRegistration = Registration Nothing 0.1 4.5 5

-- | The standard deviation of the position error, in taxels, where one has to be supposed: the one
-- told, else one taxel.
supposedSigma :: Registration -> Double
supposedSigma = fromMaybe 1 . registrationSigma

-- | The least and the greatest standard deviation, in taxels, that the position error may have:
-- from half a taxel to four, a quarter of the pitch; or from half to twice the one told, but no
-- further than to four, where less was told.
sigmasFor :: Registration -> (Double, Double)
sigmasFor = maybe (0.5, 4) around . registrationSigma
  where
    around sigma = (sigma / 2, max sigma (min 4 (2 * sigma)))

-- | How far from where it is expected a frame is looked for, in taxels.
searchRadius :: Registration -> Double
searchRadius settings = registrationReach settings * supposedSigma settings

-- | Whether the settings make sense: a positive sigma, noise of at least 0, and a search radius of
-- at most 64 taxels.
usable :: Registration -> Bool
usable settings =
  sigma > 0 && noise >= 0 && not (isInfinite noise) && reach >= 0 && searchRadius settings <= 64
  where
    Registration _ noise reach _ = settings
    sigma = supposedSigma settings

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

-- | How much more probable, as a natural logarithm, an overlap is when the image and the reference
-- show the same relief than when they have nothing to do with each other: the profile likelihood of
-- n pairs of normal values with correlation rho, -(n/2) ln (1 - rho^2), for rho > 0, else 0. (It is
-- n times the mutual information of two normal variables with that correlation.)
--
-- In rho both variances are enlarged by the noise's, so that the accidental correlations of two
-- blank patches, which the largest of some seventy displacements would make look telling, carry
-- next to no information, and the prior decides.
logLikelihood :: Registration -> Overlap -> Double
logLikelihood settings (Overlap n vf vc cov)
  | n <= 0 || cov <= 0 = 0
  | otherwise = negate (n / 2) * log (1 - min 0.9999 rhoSquared)
  where
    -- Not quite nothing for a sensor without noise, so that rounding errors on flat images tell
    -- nothing.
    noise = max 1e-9 (registrationNoise settings * registrationNoise settings)
    rhoSquared = cov * cov / ((vf + noise) * (vc + noise))

-- | The search's finest step: an eighth of a taxel.
finestStep :: Double
finestStep = 0.125

-- | Where a displacement is looked for: within a radius of a centre, in taxels.
data Window = Window
  { windowCentre :: !Taxels,
    windowRadius :: !Double
  }
  deriving stock (Eq, Show)

-- | The most probable displacement of an image on a reference: the best of those in the window that
-- lie whole taxels from the start, which should be near its centre, then refined by steps of a
-- half, a quarter and an eighth. The function turns a displacement into the place of the image's
-- pixel (0, 0) on the reference.
mostProbable ::
  Registration ->
  Reference ->
  Raster ->
  (Taxels -> Taxels) ->
  Prior ->
  Window ->
  Taxels ->
  Taxels
mostProbable settings ref image placeOf prior (Window (cx, cy) radius) start@(x0, y0) =
  snd (foldl' refine whole [4 * finestStep, 2 * finestStep, finestStep])
  where
    whole =
      foldl'
        better
        (posterior start, start)
        (filter inside [(x0 + i, y0 + j) | j <- line, i <- line])
    line = let r = ceiling radius + 1 :: Int in map fromIntegral [negate r .. r] :: [Double]
    inside d@(x, y) = (x - cx) * (x - cx) + (y - cy) * (y - cy) <= radius * radius && d /= start
    -- Along x first, then along y from there.
    refine best step = foldl' along best [(step, 0), (0, step)]
    along best@(_, (x, y)) (i, j) = foldl' better best [(x - i, y - j), (x + i, y + j)]
    better best@(score, _) candidate =
      let score' = posterior candidate in if score' > score then (score', candidate) else best
    posterior d = logLikelihood settings (capped (at d)) + logPrior prior d
    at d = let (px, py) = placeOf d in overlapAt ref image px py
    -- Note [No reward for overlap]
    capped overlap = overlap {overlapWeight = min startWeight (overlapWeight overlap)}
    startWeight = overlapWeight (at start)

-- | How many independent pairs of values a pixel of an overlap counts for where probabilities are
-- told: neighbouring pixels of relief resemble each other. Found so that of pairs that are given at
-- 99 % at least that much is right.
independent :: Double
independent = 0.4

{- Note [No reward for overlap] The likelihood takes each pixel that leaves the overlap for one that
   chance must explain. But neighbouring pixels of a relief resemble each other, so the pixel's own
   image explains it nearly as well, and rewarding a larger overlap draws smooth images together. So
   an overlap counts for no more than the one at the start has. -}
