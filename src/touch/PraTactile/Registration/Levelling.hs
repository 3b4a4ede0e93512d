{-# OPTIONS_HADDOCK hide #-}

-- | Brings frames to one scale. A sensor is pressed harder on some frames, and then reads more of
-- equal relief, or from a higher level. The fit of the lattice gives the gain and offset of each
-- frame.
--
-- A frame of N taxels, whose readings have mean m and standard deviation s, reads flat ground as o
-- and relief as o + g, in grey values, by its theta = (a, b, v):
--
-- > g = s a,    o = m + s b
-- > variance of log g:  e^2 = v / (0.4 N (1 - v)) + 0.3^2
-- > variance of o / g': e^2 = s^2 v / (0.4 N g'^2) + 0.05^2,    g' the mean gain
--
-- 0.4 is the share of independent taxels ('independent'). 0.3 is the spread of gains by the force
-- of a press, worn symbols and single elements, which is better left in. 0.05 is the spread of
-- offsets by relief that is not quite as drawn. Both are assumptions. Gains and offsets are each
-- draws from a normal distribution of variance tau^2 (random effects; DerSimonian and Laird,
-- Controlled Clinical Trials 7, 1986):
--
-- > w = 1 / e^2,   mean = sum w x / sum w,   Q = sum w (x - mean)^2
-- > tau^2 = max 0 (Q - (n - 1)) / (sum w - sum w^2 / sum w)
-- > x^ = mean + tau^2 / (tau^2 + e^2) (x - mean)
--
-- If frames differ no more than their errors explain, tau is 0 and no frame changes. A frame that
-- reads less shows more noise once it is rescaled. Its weight is therefore the square of its
-- relative gain, a hundredth at least.
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
import PraTactile.Registration.Numbers
  ( independent,
    negligible,
    pressGainVariance,
    pressOffsetVariance,
  )

-- | The common scale of all frames, and the rescaling of each to it.
data Levelling = Levelling
  { -- | The reading of flat ground, grey values.
    levellingFlat :: !Double,
    -- | How much more embossed relief reads, grey values.
    levellingContrast :: !Double,
    -- | In the order of the frames.
    levellingFrames :: ![Level]
  }
  deriving stock (Eq, Show)

-- | The rescaling of a frame: each value v becomes offset + factor v.
data Level = Level
  { levelOffset :: !Double,
    levelFactor :: !Double,
    -- | The frame's weight in a mean; a usual one has 1.
    levelWeight :: !Double
  }
  deriving stock (Eq, Show)

-- | The level that changes nothing.
unlevelled :: Level
unlevelled = Level 0 1 1

-- | Brings a frame to the common scale.
levelled :: Level -> Raster -> Raster
levelled level
  | level == unlevelled = id
  | otherwise = mapRaster (\v -> levelOffset level + levelFactor level * v)

-- | The common scale, from the frames and their thetas.
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
      randomEffects
        [(offset r / unit, offsetError r / (unit * unit) + pressOffsetVariance) | r <- told]
    offsets = map (* unit) shares
    alike xs = and (zipWith (==) xs (drop 1 xs))
    onto g o = Level (flat - o / share) (1 / share) (max 0.01 (share * share))
      where
        share = g / unit

-- | The gain and the offset of a frame, grey values.
data GainOffset = GainOffset
  { gain :: !Double,
    offset :: !Double,
    -- | The variance of the log gain; infinite if the frame shows too little to estimate it.
    gainError :: !Double,
    -- | The variance of the offset by noise alone.
    offsetError :: !Double
  }

reading :: Touched -> Theta -> GainOffset
reading seen (Theta a b v) = GainOffset (s * a) (m + s * b) ofGain (s * s * v / (independent * n))
  where
    ofGain
      | n / 2 * log (1 / v) < negligible = 1 / 0
      | otherwise = v / (independent * n * (1 - v)) + pressGainVariance
    (n, m, s) = standardOf seen

-- | Random-effects estimates from numbers with their error variances: the mean, and each number
-- shrunk towards it. A number of infinite variance becomes the mean.
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
