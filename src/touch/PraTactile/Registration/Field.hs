{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The mean field of "PraTactile.Registration.Model" over frames, for factors of any kind. It has
-- the grid of displacements, their prior by the robot's error sigma, the posterior of sigma, and
-- the sweeps. "PraTactile.Registration.Field.Cells" has the factors of a lattice's cells,
-- "PraTactile.Registration.Field.Pairs" those of pairs of frames.
--
-- With t the square of a displacement, and n and S the number and the sum of the other frames'
-- expected squares:
--
-- > v(sigma)  = sigma^2 + 1 / 12                     in square steps of the grid
-- > s(sigma)  ~ exp (- S / (2 v)) / v^n
-- > prior     ~ sum over sigma of s(sigma) / v exp (- t / (2 v))
module PraTactile.Registration.Field
  ( -- * Displacements
    Grid (..),
    latticeGrid,
    pairsGrid,
    onGrid,
    inTaxels,

    -- * The robot's error
    gridOctaves,
    priorsAlong,
    Squares (..),
    sigmaLogs,
    sigmaShares,
    likelySigma,
    displacementLog,

    -- * Sweeps
    settled,
    normalised,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Probability (logSum)
import PraTactile.Registration.Model (normalLog)
import PraTactile.Registration.Numbers (mostReach, placesPerTaxel, sigmasPerOctave)
import PraTactile.Registration.Settings (Registration (..), sigmasFor)

-- | The displacements that a frame may have: whole steps along both axes from the grid point
-- nearest to its nominal place.
data Grid = Grid
  { -- | Steps to the taxel.
    gridPerTaxel :: !Int,
    -- | The greatest displacement along an axis, steps.
    gridReach :: !Int,
    -- | The values of sigma, steps, ascending and equally probable, 'sigmasPerOctave' per octave.
    gridSigmas :: ![Double]
  }

-- | The grid for a lattice: half taxels, as far as the settings have frames searched.
latticeGrid :: Registration -> Grid
latticeGrid settings = gridFor placesPerTaxel 2 64 (registrationReach settings) settings

-- | The grid for pairs: whole taxels, up to three standard deviations.
pairsGrid :: Registration -> Grid
pairsGrid = gridFor 1 1 mostReach 3

-- | A grid with the given steps per taxel. It reaches to a multiple (deviations) of the largest
-- sigma, limited to the least and the most steps.
gridFor :: Int -> Int -> Int -> Double -> Registration -> Grid
gridFor perTaxel least most deviations settings =
  Grid
    perTaxel
    (max least (min most (ceiling (steps * deviations * largest - 1e-9))))
    [ steps * smallest * 2 ** (fromIntegral k / fromIntegral sigmasPerOctave)
      | k <- [0 .. round (fromIntegral sigmasPerOctave * logBase 2 (largest / smallest)) :: Int]
    ]
  where
    steps = fromIntegral perTaxel
    (smallest, largest) = sigmasFor settings

-- | The grid point nearest to a place in taxels, and the place's offset from it, steps.
onGrid :: Grid -> Taxels -> ((Int, Int), (Double, Double))
onGrid grid (x, y) = ((round x', round y'), (x' - whole x', y' - whole y'))
  where
    (x', y') = (x * steps, y * steps)
    steps = fromIntegral (gridPerTaxel grid)
    whole t = fromIntegral (round t :: Int)

-- | Converts steps to taxels.
inTaxels :: Grid -> Double -> Double
inTaxels grid t = t / fromIntegral (gridPerTaxel grid)

-- | One value of sigma per octave, steps.
gridOctaves :: Grid -> [Double]
gridOctaves = every . gridSigmas
  where
    every sigmas = case sigmas of
      sigma : rest -> sigma : every (drop (sigmasPerOctave - 1) rest)
      [] -> []

-- | v(sigma): the variance of the robot's error along an axis, plus that of a place within its
-- step.
displacementVariance :: Double -> Double
displacementVariance sigma = sigma * sigma + 1 / 12

-- | pi_sigma along an axis for the displacements from @-gridReach@ to @gridReach@, given sigma and
-- the place's offset from its grid point. Each value follows from its neighbour by a ratio, which
-- shrinks by a constant factor.
priorsAlong :: Grid -> Double -> Double -> Vector Double
priorsAlong grid sigma beyond = V.reverse (V.drop 1 (outward (negate beyond))) <> outward beyond
  where
    outward from =
      V.unfoldrN
        (gridReach grid + 1)
        (\(!p, !ratio) -> Just (p, (p * ratio, ratio * shrink)))
        ( exp (normalLog v (from * from)) / sqrt (2 * pi * v),
          exp (normalLog v (1 - 2 * from))
        )
    shrink = exp (normalLog v 2)
    v = displacementVariance sigma

-- | The statistics of sigma: the number n of displacements, and the sum S of their expected
-- squares, square steps.
data Squares = Squares !Double !Double

instance Semigroup Squares where
  Squares n s <> Squares n' s' = Squares (n + n') (s + s')

instance Monoid Squares where
  mempty = Squares 0 0

-- | log s(sigma) of each of 'gridSigmas', up to a constant.
sigmaLogs :: Grid -> Squares -> [Double]
sigmaLogs grid (Squares n s) =
  [normalLog v s - n * log v | v <- map displacementVariance (gridSigmas grid)]

-- | The posterior probability of each of 'gridSigmas'.
sigmaShares :: Grid -> Squares -> [Double]
sigmaShares grid told = map (exp . subtract total) logs
  where
    logs = sigmaLogs grid told
    total = logSum logs

-- | The geometric mean of sigma under its posterior, taxels.
likelySigma :: Grid -> Squares -> Double
likelySigma grid told =
  inTaxels grid (exp (sum (zipWith (*) (sigmaShares grid told) (map log (gridSigmas grid)))))

-- | The log prior of a displacement, up to a constant, from its square t and the other frames'
-- statistics of sigma.
displacementLog :: Grid -> Squares -> Double -> Double
displacementLog grid others = \t ->
  log (max 1e-300 (V.sum (V.zipWith (\w r -> w * exp (negate r * t)) weights rates)))
  where
    !weights = V.fromList (zipWith (/) (sigmaShares grid others) variances)
    !rates = V.fromList [1 / (2 * v) | v <- variances]
    variances = map displacementVariance (gridSigmas grid)

-- | Repeats a sweep until the likeliest displacements stay as they are, but at most the given
-- number of times.
settled :: Eq b => Int -> (field -> b) -> (field -> field) -> field -> field
settled sweeps likeliest sweep = go sweeps
  where
    go n now
      | n <= 1 || likeliest now == likeliest new = new
      | otherwise = go (n - 1) new
      where
        new = sweep now

-- | Normalises log weights to probabilities.
normalised :: [(d, Double)] -> [(d, Double)]
normalised scored = [(d, exp (s - top) / total) | (d, s) <- scored]
  where
    top = maximum (map snd scored)
    total = sum [exp (s - top) | (_, s) <- scored]
