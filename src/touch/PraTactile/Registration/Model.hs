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
-- A frame has N taxels u, with readings z(u) standardised to mean 0 and variance 1. Relief r is 1
-- where the face is embossed and 0 where it is flat:
--
-- > z(u) = a r(u) + b + noise,    noise normal, of variance v, independent in each taxel
--
-- If frames show that the sensor was tilted, "PraTactile.Registration.Contact" finds the slopes. It
-- rewrites each frame as an even press would read it, and gives each taxel a weight. Sums over
-- taxels are weighted.
--
-- = Priors
--
-- > P(w)        "PraTactile.Registration.Layout"
-- > P(alpha)    uniform; maximised by "PraTactile.Registration.Lattice.Angle"
-- > P(lambda)   uniform over places of half a taxel modulo the pitch of 16 x 20 taxels
-- > P(sigma)    uniform in log sigma: from half a taxel to four (a quarter of the pitch) if the
-- >             robot's error is unknown; else from half to twice the known error, but at most
-- >             four taxels or the known error, whichever is larger
-- > P(d_f)      pi_sigma: normal, of variance sigma^2 + s^2 / 12, where s is the grid's spacing
--
-- theta_f is maximised ("PraTactile.Registration.Lattice.Fit").
--
-- = Factors
--
-- A factor c joins the frames that see one cell, or the two frames of a pair. It has a few
-- hypotheses h with priors P_c(h). Under h = 0 the frames have nothing in common:
--
-- > likelihood of c = sum over h of P_c(h) * product over its frames f of exp l_fh(d_f)
--
-- If the frames show symbols, the factors are the cells of the lattice. Otherwise they are the
-- pairs of overlapping frames:
--
-- > cell   h = empty         P = epsilon              l = 0
-- >        h = class k       P = (1 - epsilon) / q    l_k
-- > pair   h = two reliefs   P = 1/2                  l = 0
-- >        h = one relief    P = 1/2                  L, "PraTactile.Registration.Overlap"
--
-- Symbols do not overlap, so the squared error of a lattice is a sum over its cells. Registration
-- accepts a lattice if its log posterior odds against the likeliest normal process exceed 'sure'.
--
-- = Inference
--
-- lambda is maximised ("PraTactile.Registration.Joint.Phase"). A product of q_f and q (a mean
-- field) approximates the posterior of the displacements and of sigma:
--
-- > m_c(h)     ~ P_c(h) exp (sum over other frames g of <l_gh>)      c by the other frames
-- > m'_c       = (1 - delta) m_c + delta P_c                         any frame may be an outlier
-- > s_f(sigma) ~ exp (sum over other frames g of <log pi_sigma>)     sigma by the other frames
-- > q_f(d)     ~ (sum over sigma of s_f(sigma) pi_sigma(d))
-- >              * product over c of sum over h of m'_c(h) exp l_fh(d)
--
-- where <.> is the mean over q_g. A pair has only one other frame, so its displacements are summed:
--
-- > q_f(d)     ~ prior * product over pairs of (1 + sum over d' of q_g(d') exp L(d' - d))
--
-- "PraTactile.Registration.Field" has the prior and the sweeps; its two submodules have the
-- factors. A shift common to all frames is unobservable. A lattice absorbs it in its phase; with
-- pairs the first frame stays at its nominal place. Reported displacements have mean 0. Two frames
-- on a lattice are solved exactly ("PraTactile.Registration.Joint.TwoFrames").
--
-- = Evidence
--
-- One bound scores each layout, up to a constant that all layouts share:
--
-- > cells   log P >= F, with 'cellShare' of the log-likelihood ("PraTactile.Registration.Joint")
-- > pairs   E = sum over pairs of log (delta + (1 - delta) * sum over e of pi(e) exp L(e))
--
-- Layouts with slipped frames, or with one frame elsewhere, keep the lattice: their F has the same
-- terms in other cells. E_0, the limit of large sigma, is the evidence if positions are
-- uninformative.
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
    TiltedPress (..),
    planeAt,
    indentation,
    touches,
    reliefShare,

    -- * The lattice
    classPrior,
    cellLog,

    -- * Displacements
    normalLog,
    eighth,
  )
where

import PraTactile.Registration.Numbers (absence, negligible)

-- | theta: gain, offset and noise variance of a frame's readings.
data Theta = Theta
  { thetaGain :: !Double,
    thetaOffset :: !Double,
    thetaVariance :: !Double
  }
  deriving stock (Eq, Show)

-- | A tilted press: gain a, depth b, slopes p (across) and q (down), noise variance v.
data TiltedPress = TiltedPress
  { pressGain :: !Double,
    pressDepth :: !Double,
    pressAcross :: !Double,
    pressDown :: !Double,
    pressVariance :: !Double
  }
  deriving stock (Eq, Show)

-- | The plane p x + q y at (x, y): how much nearer to the face the sensor lies there.
planeAt :: TiltedPress -> Double -> Double -> Double
planeAt (TiltedPress _ _ p q _) x y = p * x + q * y
{-# INLINE planeAt #-}

-- | h_r, the indentation by relief r, given r and the plane at the taxel.
indentation :: TiltedPress -> Double -> Double -> Double
indentation (TiltedPress a b _ _ _) r s = max 0 (a * r + b + s)
{-# INLINE indentation #-}

-- | Whether relief r touches the sensor, given r and the plane at the taxel.
touches :: TiltedPress -> Double -> Double -> Bool
touches (TiltedPress a b _ _ _) r s = a * r + b + s > 0
{-# INLINE touches #-}

-- | P(r), the prior of relief r. A symbol covers a quarter of its cell, and its edges half as much
-- more (assumption).
reliefShare :: Double -> Double
reliefShare r
  | r <= 0 = 0.62
  | r < 1 = 0.16
  | otherwise = 0.22
{-# INLINE reliefShare #-}

-- | P(k), the prior of each class, given the number of classes.
classPrior :: Int -> Double
classPrior count = (1 - absence) / fromIntegral count

-- | l, the log-likelihood ratio of a cell, classes summed, to an empty one, given the number of
-- classes and l_k of each. Terms below the largest by more than 'negligible' are dropped.
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

-- | Log density of a normal distribution up to a constant, given its variance and the squared
-- distance from its mean.
normalLog :: Double -> Double -> Double
normalLog variance square = negate square / (2 * variance)
{-# INLINE normalLog #-}

-- | Rounds to an eighth of a taxel, the resolution of reported displacements.
eighth :: Double -> Double
eighth t = fromIntegral (round (8 * t) :: Int) / 8
