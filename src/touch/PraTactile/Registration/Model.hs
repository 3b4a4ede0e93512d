{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Registration as one model. Each stage begins with the formulas of its own part;
-- "PraTactile.Registration.Numbers" is the table of every number that decides.
--
-- = Unknowns
--
-- > w         layout: the robot's axes and their scale, slips of frames by whole cells
-- > alpha     angle of the lattice against the frames
-- > lambda    phase of the lattice: orientation (upright or half turned), row, column
-- > sigma     standard deviation of the robot's position error along each axis
-- > d_f       displacement of frame f from its nominal place n_f
-- > theta_f   how frame f reads relief: gain a, offset b, noise variance v
--
-- A frame has N taxels u. Its readings z(u), standardised to mean 0 and variance 1, are those of
-- relief r, which is 1 where the face is embossed and 0 where it is flat:
--
-- > z(u) = a r(u) + b + noise,    noise normal, of variance v, independent in each taxel
--
-- Where a frame shows that it was tilted, "PraTactile.Registration.Contact" finds its slopes, reads
-- it as an even press would have, and gives each taxel a weight. Sums over taxels are by weight.
--
-- = Priors
--
-- > P(w)        "PraTactile.Registration.Layout"
-- > P(alpha)    uniform, found by "PraTactile.Registration.Lattice.Angle"
-- > P(lambda)   uniform over places of half a taxel modulo the pitch of 16 x 20 taxels
-- > P(sigma)    uniform in log sigma: from half a taxel to four, a quarter of the pitch; or from
-- >             half to twice what the robot is known for, but to four at most where that is less
-- > P(d_f)      pi_sigma: normal, of variance sigma^2 + s^2 / 12, where s is the grid's spacing
--
-- theta_f is maximised ("PraTactile.Registration.Lattice.Fit").
--
-- = Factors
--
-- A factor c joins the frames that see one thing. It has a few hypotheses h with priors P_c(h), and
-- under h = 0 the frames have nothing in common:
--
-- > likelihood of c = sum over h of P_c(h) * product over its frames f of exp l_fh(d_f)
--
-- Where frames show symbols, the factors are the cells of the lattice; otherwise they are the pairs
-- of frames that overlap:
--
-- > cell   h = empty         P = epsilon              l = 0
-- >        h = class k       P = (1 - epsilon) / q    l_k
-- > pair   h = two reliefs   P = 1/2                  l = 0
-- >        h = one relief    P = 1/2                  L, "PraTactile.Registration.Overlap"
--
-- Symbols do not overlap, so that the squared error of a lattice is a sum over its cells. There is
-- a lattice at all if its posterior odds are 'sure', against the likeliest normal process.
--
-- = Inference
--
-- lambda is maximised ("PraTactile.Registration.Joint.Phase"). The posterior of the displacements
-- and of sigma is approximated by a product of q_f and q (a mean field):
--
-- > m_c(h)     ~ P_c(h) exp (sum over other frames g of <l_gh>)      what the others make of c
-- > m'_c       = (1 - delta) m_c + delta P_c                         one of them may be astray
-- > s_f(sigma) ~ exp (sum over other frames g of <log pi_sigma>)     likewise of sigma
-- > q_f(d)     ~ (sum over sigma of s_f(sigma) pi_sigma(d))
-- >              * product over c of sum over h of m'_c(h) exp l_fh(d)
--
-- where <.> is the mean over q_g. A pair has but one other frame, whose displacements are summed:
--
-- > q_f(d)     ~ prior * product over pairs of (1 + sum over d' of q_g(d') exp L(d' - d))
--
-- "PraTactile.Registration.Field" has the prior and the sweeps, its two modules the factors. A shift
-- common to all frames cannot be seen: the phase of a lattice takes it, and with pairs the first
-- frame stays where the robot has it. The displacements that are given have mean 0. Two frames on a lattice are exact ("PraTactile.Registration.Joint.TwoFrames").
--
-- = Evidence
--
-- One bound tells how likely a layout is, up to what all layouts have in common:
--
-- > cells   log P >= F, with 'cellShare' of the log-likelihood ("PraTactile.Registration.Joint")
-- > pairs   E = sum over pairs of log (delta + (1 - delta) * sum over e of pi(e) exp L(e))
--
-- Frames that slip by a cell, or one that is elsewhere, stay on the lattice: F of the same terms in
-- other cells. That positions tell nothing at all is the limit of large sigma, E_0.
--
-- = Names
--
-- > N, z               a frame, as 'PraTactile.Registration.Lattice.Fit.fitOf' standardises it
-- > a, b, v            Theta
-- > l_k, l, L(lambda)  classLogs, cellLogs, phaseLogs        log p(z)     logDensity
-- > epsilon, P(k)      absence, classPrior                   beta         blurDeviation
-- > pi_sigma           priorsAlong                           delta        outlier
-- > d, with l_fck      Displacement                          L of a pair  overlapLogs
-- > q_f of cells, F    meanField, fieldBound                 E_0          jointAnywhere
-- > q_f of pairs       pairwiseField                         s(sigma)     sigmaShares
module PraTactile.Registration.Model
  ( -- * What a frame reads
    Theta (..),

    -- * A tilted press
    Press (..),
    planeAt,
    indentation,
    touches,
    reliefShare,

    -- * The lattice
    classPrior,
    cellLog,

    -- * Displacements
    normalLog,
    logSum,
    eighth,
  )
where

import PraTactile.Registration.Numbers (absence, negligible)

-- | theta: how a frame reads relief.
data Theta = Theta
  { thetaGain :: !Double,
    thetaOffset :: !Double,
    thetaVariance :: !Double
  }
  deriving stock (Eq, Show)

-- | How a frame meets the face: a, b, p, q and v.
data Press = Press
  { pressGain :: !Double,
    pressDepth :: !Double,
    pressAcross :: !Double,
    pressDown :: !Double,
    pressVariance :: !Double
  }
  deriving stock (Eq, Show)

-- | p x + q y.
planeAt :: Press -> Double -> Double -> Double
planeAt (Press _ _ p q _) x y = p * x + q * y
{-# INLINE planeAt #-}

-- | h_r, from r and p x + q y.
indentation :: Press -> Double -> Double -> Double
indentation (Press a b _ _ _) r s = max 0 (a * r + b + s)
{-# INLINE indentation #-}

-- | Whether relief r touches, where that is p x + q y.
touches :: Press -> Double -> Double -> Bool
touches (Press a b _ _ _) r s = a * r + b + s > 0
{-# INLINE touches #-}

-- | P(r): a symbol covers a quarter of its cell, and its edges half as much again (assumption).
reliefShare :: Double -> Double
reliefShare r
  | r <= 0 = 0.62
  | r < 1 = 0.16
  | otherwise = 0.22
{-# INLINE reliefShare #-}

-- | P(k), given the number of classes.
classPrior :: Int -> Double
classPrior count = (1 - absence) / fromIntegral count

-- | l from l_k, given the number of classes. What is less likely by 'negligible' does not count.
cellLog :: Int -> (Int -> Double) -> Double
cellLog count at
  | m < negate negligible = none
  | otherwise =
    let !top = max 0 m
        !rest
          | m <= 0 = absence
          | m > negligible = 0
          | otherwise = absence * exp (negate m)
        terms :: Int -> Double -> Double
        terms !k !s
          | k >= count = s
          | at k - top < negate negligible = terms (k + 1) s
          | at k == top = terms (k + 1) (s + share)
          | otherwise = terms (k + 1) (s + share * exp (at k - top))
        !s' = terms 0 rest
     in if s' == absence then top + none else top + log s'
  where
    !share = classPrior count
    none = log absence
    !m = greatest 0 0
    greatest :: Int -> Double -> Double
    greatest !k !best
      | k >= count = best
      | otherwise = greatest (k + 1) (max best (at k))
{-# INLINE cellLog #-}

-- | The logarithm of a normal density up to a constant, given its variance and the square of the
-- distance from its mean: log pi, of the square of a displacement or of its part along an axis.
normalLog :: Double -> Double -> Double
normalLog variance square = negate square / (2 * variance)
{-# INLINE normalLog #-}

-- | To the nearest eighth of a taxel, as displacements are given.
eighth :: Double -> Double
eighth t = fromIntegral (round (8 * t) :: Int) / 8

-- | The logarithm of the sum of the exponentials; there must be some.
logSum :: [Double] -> Double
logSum logs = top + log (sum [exp (l - top) | l <- logs])
  where
    top = maximum logs
