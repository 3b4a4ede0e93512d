{-# OPTIONS_HADDOCK hide #-}

-- | Frames on one scale: the sensor is pressed harder here than there, and what it reads of one and
-- the same relief is more, or begins higher. What a frame tells of the lattice tells that too.
--
-- A frame of N taxels whose readings have mean m and standard deviation s reads flat as o and
-- relief as o + g, in grey values, by its theta = (a, b, v):
--
-- > g = s a,    o = m + s b
-- > variance of log g:  e^2 = v / (0.4 N (1 - v)) + 0.3^2
-- > variance of o / g': e^2 = s^2 v / (0.4 N g'^2) + 0.05^2,    g' the mean gain
--
-- 0.4 of the taxels being independent ('independent'), 0.3 what the force of a press, worn symbols
-- and elements of their own make of a gain, which is better left as it is, and 0.05 what relief
-- that is not quite as it is drawn makes of an offset (assumptions). Gains and offsets are each
-- taken for draws from a normal distribution of variance tau^2 (random effects; DerSimonian and
-- Laird, Controlled Clinical Trials 7, 1986):
--
-- > w = 1 / e^2,   mean = sum w x / sum w,   Q = sum w (x - mean)^2
-- > tau^2 = max 0 (Q - (n - 1)) / (sum w - sum w^2 / sum w)
-- > x^ = mean + tau^2 / (tau^2 + e^2) (x - mean)
--
-- Where frames differ no more than their errors explain, tau is 0, and none is changed. One that
-- reads less shows its noise the more, and counts so much less: as the square of its gain, which is
-- one over its noise's variance; a hundredth at least.
module PraTactile.Registration.Levelling
  ( Levelling (..),
    Level (..),
    levelling,
    unlevelled,
    levelled,
    randomEffects,
  )
where

import PraTactile.Image (Raster, mapRaster)
import PraTactile.Registration.Lattice.Fit (Touched, standardOf)
import PraTactile.Registration.Model (Theta (..))
import PraTactile.Registration.Numbers (independent, negligible, unlikeGain, unlikeOffset)

-- | What all frames read on their common scale, and how each is brought to it.
data Levelling = Levelling
  { -- | What flat ground reads, grey values.
    levellingFlat :: !Double,
    -- | How much more relief reads.
    levellingContrast :: !Double,
    -- | In the order of the frames.
    levellingFrames :: ![Level]
  }
  deriving stock (Eq, Show)

-- | How a frame is brought to a common scale: each value v becomes offset + factor v.
data Level = Level
  { levelOffset :: !Double,
    levelFactor :: !Double,
    -- | The weight of the frame in a mean, beside 1 of a usual one.
    levelWeight :: !Double
  }
  deriving stock (Eq, Show)

-- | The level of a frame that stays as it is read.
unlevelled :: Level
unlevelled = Level 0 1 1

-- | A frame on the common scale.
levelled :: Level -> Raster -> Raster
levelled level
  | level == unlevelled = id
  | otherwise = mapRaster (\v -> levelOffset level + levelFactor level * v)

-- | The common scale of frames, from the frames and how each reads relief.
levelling :: [(Touched, Theta)] -> Levelling
levelling frames
  | alike gains && alike offsets = Levelling flat unit (map (const unlevelled) frames)
  | otherwise = Levelling flat unit (zipWith onto gains offsets)
  where
    flat = usual * unit
    told = map (uncurry reading) frames
    (usualGain, logGains) = randomEffects [(log (gain r), gainError r) | r <- told]
    unit = exp usualGain
    gains = map exp logGains
    (usual, shares) =
      randomEffects [(offset r / unit, offsetError r / (unit * unit) + unlikeOffset) | r <- told]
    offsets = map (* unit) shares
    alike xs = and (zipWith (==) xs (drop 1 xs))
    onto g o = Level (flat - o / share) (1 / share) (max 0.01 (share * share))
      where
        share = g / unit

-- | How a frame reads relief, grey values.
data Reading = Reading
  { gain :: !Double,
    offset :: !Double,
    -- | The variance of the gain's logarithm; infinite where the frame shows too little to tell.
    gainError :: !Double,
    -- | The variance of the offset, that of relief apart.
    offsetError :: !Double
  }

reading :: Touched -> Theta -> Reading
reading seen (Theta a b v) = Reading (s * a) (m + s * b) ofGain (s * s * v / (independent * n))
  where
    ofGain
      | n / 2 * log (1 / v) < negligible = 1 / 0
      | otherwise = v / (independent * n * (1 - v)) + unlikeGain
    (n, m, s) = standardOf seen

-- | The mean of numbers with variances, and what each is by itself and by all together: the mean,
-- where its variance is infinite.
randomEffects :: [(Double, Double)] -> (Double, [Double])
randomEffects given = (mean, map shrunk given)
  where
    told = [(x, 1 / e) | (x, e) <- given, not (isInfinite e)]
    total = sum (map snd told)
    mean = if null told then 0 else sum [w * x | (x, w) <- told] / total
    spread = sum [w * (x - mean) * (x - mean) | (x, w) <- told]
    freedom = total - sum [w * w | (_, w) <- told] / total
    tau2
      | length told < 2 = 0
      | otherwise = max 0 ((spread - fromIntegral (length told - 1)) / freedom)
    shrunk (x, e)
      | tau2 <= 0 || isInfinite e = mean
      | otherwise = mean + tau2 / (tau2 + e) * (x - mean)
