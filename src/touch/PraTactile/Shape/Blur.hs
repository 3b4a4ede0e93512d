{-# OPTIONS_HADDOCK hide #-}

-- | Relief under a blur. The reading of a symbol at u is the sum over its embossed taxels j of g(u
-- - j), where
--
-- > g(t) = G(t_x) G(t_y),    G(t) = Phi((t + 1/2) / beta) - Phi((t - 1/2) / beta)
--
-- is the reading, at t taxels from its centre, of a taxel of height 1 under a normal blur of
-- standard deviation beta. Phi is the normal distribution function.
--
-- The caller chooses beta. Registration uses 0.75 taxels ("PraTactile.Registration.Model"): an
-- elastic overlay spreads what is felt, and a wide template also finds symbols that are slightly
-- displaced. The pose uses 0.3 ("PraTactile.Pose.Alignment"), an element's aperture: the steepness
-- of the relief's edges determines its estimated errors, and a wide blur would overestimate them.
module PraTactile.Shape.Blur
  ( blurredAt,
    blurredSlope,
  )
where

import PraTactile.Probability (normalDensity, normalDistribution)

-- | G(t): the share of a unit taxel's height that is felt at distance t from its centre. The
-- arguments are beta and t, in taxels.
--
-- >>> blurredAt 1e-3 0
-- 1.0
blurredAt :: Double -> Double -> Double
blurredAt beta t = normalDistribution ((t + 0.5) / beta) - normalDistribution ((t - 0.5) / beta)

-- | The derivative of G(t) with respect to t, per taxel. The arguments are beta and t, in taxels.
blurredSlope :: Double -> Double -> Double
blurredSlope beta t = (normalDensity ((t + 0.5) / beta) - normalDensity ((t - 0.5) / beta)) / beta
