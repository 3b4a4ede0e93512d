{-# OPTIONS_HADDOCK hide #-}

-- | Relief under a blur: a symbol is felt as the sum over its embossed taxels j of g(u - j), where
--
-- > g(t) = G(t_x) G(t_y),    G(t) = Phi((t + 1/2) / beta) - Phi((t - 1/2) / beta)
--
-- is what a taxel of height 1 brings at t, in taxels from its centre, under a normal blur of
-- standard deviation beta. Phi is the normal distribution function.
--
-- Who asks sets beta. Registration takes 0.75 taxels ("PraTactile.Registration.Model"), for an
-- elastic overlay spreads what is felt, and a wide template finds symbols that lie a little
-- otherwise. The pose takes 0.3 ("PraTactile.Pose.Alignment"), an element's aperture: its errors
-- are told by how steep the relief's edges are, and a wide blur would tell them too large.
module PraTactile.Shape.Blur
  ( blurredAt,
    blurredSlope,
  )
where

import PraTactile.Probability (normalDensity, normalDistribution)

-- | G: the share of a unit taxel that is felt at a distance from its centre, given beta; taxels.
--
-- >>> blurredAt 1e-3 0
-- 1.0
blurredAt :: Double -> Double -> Double
blurredAt beta t = normalDistribution ((t + 0.5) / beta) - normalDistribution ((t - 0.5) / beta)

-- | The derivative of G with respect to the distance, per taxel.
blurredSlope :: Double -> Double -> Double
blurredSlope beta t = (normalDensity ((t + 0.5) / beta) - normalDensity ((t - 0.5) / beta)) / beta
