{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The mathematics of registration, in a page. The modules of this folder are its computation; the
-- tests hold them to the same formulas on lists, summed in full.
--
-- = What a frame reads
--
-- A frame has N taxels u, whose readings are standardised to mean 0 and variance 1 and called z(u).
-- It reads relief r, which is 1 where the face is embossed and 0 where it is flat, as
--
-- > z(u) = a r(u) + b + noise,    noise normal, of variance v, alone in each taxel
--
-- with theta = (gain a, offset b, variance v) of its own. Relief is blurred on the way: a symbol of
-- class k whose upper left taxel lies at x, in orientation o (upright or half turned), brings
--
-- > T(u) = sum over the embossed taxels j of class k, turned by o, of g(u - x - j)
--
-- where g is that of "PraTactile.Shape.Blur", but 0 from three taxels on along an axis. On a
-- lattice at an angle the taxels j are turned with it, and g, which is nearly the same in all
-- directions, is not. In the sum of the squares of T a taxel of which a symbol brings less than a
-- hundredth counts for nothing. Places x are those from which a symbol's taxels come within two
-- taxels of the frame.
--
-- = A tilted press
--
-- A rigid sensor that is tilted lies nearer to the face here than there, by p x + q y, where x and
-- y go from -1 to 1 between its edges. What it does not touch reads c, which is the mean of the
-- lowest 1/32 of its readings, and what it touches reads the more, the nearer it lies:
--
-- > z = c + h_r(x, y) + noise,    h_r(x, y) = max 0 (a r + b + p x + q y)
--
-- where r is 0, 1/2 (on an edge) or 1, with the probabilities 0.62, 0.16 and 0.22, in each taxel by
-- itself. (a, b, p, q, v) is maximised, from the even press and from slopes in eight directions:
--
-- > eStep:  rho_r(u) ~ P(r) exp (- (z(u) - c - h_r(u))^2 / (2 v))
-- > mStep:  (a, b, p, q) = least squares of a r + b + p x + q y against z - c, by rho_r(u), over
-- >         the taxels u and reliefs r that touch: where the argument of h_r is above 0
-- >         v = (sum of rho_r (z - c - h_r)^2) / N
--
-- Presses are tilted if twelve of them show it by log 99, where slopes cost what Schwarz's
-- criterion says, and a fifth of the taxels count, since what is left of relief goes together:
--
-- > sum over frames of (0.2 (log p(z) - max over p = q = 0 of log p(z)) - log N) > log 99
--
-- Then each frame is read as by an even press of the same depth. A taxel in which embossing would
-- read t times as much more than what is flat as it does at the centre, and whose noise is 1/t of
-- the centre's, counts w = min 1 t^2; below t = 1/4 it does not touch, and counts nothing:
--
-- > t = (h_1(x, y) - h_0(x, y)) / (h_1(0, 0) - h_0(0, 0))
-- > z' = c + h_0(0, 0) + (z - c - h_0(x, y)) / t
--
-- Below, sums over the taxels of a frame are by w: its mean and variance, N, \<z, T>, sum T and sum
-- T^2, of which the last is taken for as much less as sum T is. Frames that show no lattice so are
-- left as they are read.
--
-- = The lattice
--
-- Symbols stand on a lattice of cells, one to each pitch of 16 x 20 taxels, of angle alpha, and of
-- phase lambda = (orientation o, row, column), where row and column count places of half a taxel
-- modulo the pitch. A cell is empty with probability epsilon, else of any of the q classes alike:
--
-- > P(empty) = epsilon,    P(k) = (1 - epsilon) / q
--
-- Symbols do not overlap, so that the squared error of a lattice is a sum over its cells. Against
-- nothing at x, a symbol of class k there is likelier, as a natural logarithm, by
--
-- > l_k(x)   = (a <z, T> - a b sum T - a^2 sum T^2 / 2) / v
-- > l(x)     = log (epsilon + sum over k of P(k) exp l_k(x))                 a cell, classes summed
-- > L(lambda) = sum over the cells x of lambda of l(x)                       a phase
-- > log p(z)  = log (mean over lambda of exp L(lambda))
-- >             - N (1 + b^2) / (2 v) - N/2 log (2 pi v)                      the frame
--
-- = One frame: expectation and maximisation
--
-- Phases and classes are summed; theta is maximised, by steps each of which makes p(z) no smaller
-- (phases of w, and symbols of exp (l_k - l), below 10^-6 are left out of a step):
--
-- > eStep:  w(lambda) ~ exp L(lambda),    p_k(x) = P(k) exp (l_k(x) - l(x))
-- > mStep:  Y, S, Q = sum of w(lambda) p_k(x) times <z, T>, sum T, sum T^2,
-- >                   over phases, their cells and classes
-- >         a = Y / (Q - S^2 / N),    b = - a S / N
-- >         v = (N (1 + b^2) - 2 a (Y - b S) + a^2 Q) / N        a >= 0.3, v >= 0.002
--
-- They begin with v that of white noise, a and b as they are usual of symbols: v, within 0.001 to
-- 0.95, is a quarter of the mean square of z(x, y) - z(x + 1, y) - z(x, y + 1) + z(x + 1, y + 1),
-- a = root (max 0.02 (1 - v)) / 0.36, and b = - 0.15 a.
--
-- From coarse to fine: four steps at whole taxels, the first over all phases, the others over those
-- that it leaves likely (within e^30 of the best); then one at half taxels, over the phases less
-- than a taxel from one that is likely still. No other phase is looked at, unless all of these have
-- the frame where the robot's error does not let it be.
--
-- The angle alpha is maximised too, over the sum of log p(z) of a few frames: at whole taxels over
-- the circle, then by two degrees, and by a parabola's vertex
-- ("PraTactile.Registration.Lattice.Angle"). Upright is asked first, unless symbols seem to lie at
-- another angle, and five frames at whole taxels show the lattice there, and not upright. There is
-- a lattice at all if its posterior is 0.99, against the likeliest other relief, which is the
-- normal process below: if that sum, less log N of each frame (the gain and the offset, by
-- Schwarz's criterion), is above the process's by log 99.
--
-- = Many frames
--
-- Frame f lies at its nominal place n_f and the displacement d_f, which is the robot's error:
-- normal, of one standard deviation sigma along each axis, on a grid of half taxels, up to
-- registrationReach times the greatest sigma. The logarithm of sigma is uniform, over six sigma an
-- octave: from half a taxel to four, a quarter of the pitch; or from half to twice what the robot
-- is known for, but to four at most where it is known for less: beyond, a frame may as well lie a
-- cell further. A place within the grid's cell has a variance of its own; in half taxels
--
-- > log pi_sigma(d) = - |d|^2 / (2 v) - log (2 pi v),    v = sigma^2 + 1/12
--
-- The phase of the lattice under all frames is maximised, each frame's displacement summed, and one
-- sigma an octave; where delta is below, and L* a frame's greatest L:
--
-- > P(lambda) ~ sum over sigma of product over f of
-- >    (delta + (1 - delta) * sum over d of pi_sigma(d) exp (L_f(lambda - n_f - d) - L*_f))
--
-- Then the posterior of the displacements and of sigma is, with the classes of the cells c summed,
--
-- > P(d_1 .. d_F, sigma) ~ product of pi_sigma(d_f) * product over c of
-- >                 (epsilon + sum over k of P(k) exp (sum over f of l_fck(d_f)))
--
-- where l_fck(d) is l_k at the place of c on the frame f that lies at n_f + d. The posterior is
-- approximated by a product of q_f and q (a mean field): the other frames enter by their expected
-- log likelihoods, the frame's own sums over the classes and over sigma are exact. Begun from each
-- frame alone, all frames anew in each sweep, until no frame's likeliest displacement changes or
-- five are done:
--
-- > m_c(k)  ~ P(k) exp (sum over g /= f, d of q_g(d) l_gck(d))        what the others make of c
-- > m'_c    = (1 - delta) m_c + delta P                               one of them may be astray
-- > s_f(sigma) ~ exp (sum over g /= f, d of q_g(d) log pi_sigma(d))   likewise of sigma
-- > q_f(d)  ~ (sum over sigma of s_f(sigma) pi_sigma(d)) * product over the cells c that f sees of
-- >           (m'_c(empty) + sum over k of m'_c(k) exp l_fck(d))
--
-- A displacement of q_g(d) <= 0.02 tells the others nothing of the cells, and one that is e^12
-- below a frame's best by itself, one sigma an octave, is not looked at. The position error that
-- is given is the exponential of the mean of log sigma over q, which is s_f by all frames. What is
-- given of a frame is the mean of q_f over the 3 x 3 grid points that hold most of it, within
-- 'tolerance' of it; how much they hold; the deviations; and at most two hypotheses two taxels or
-- more from there and from each other. The mean of all displacements is 0, for a shift of all
-- cannot be seen.
--
-- How likely nominal places make what all frames show is told by a bound: log P is at least F, if
-- a twentieth of the log-likelihood counts, since errors of taxels go together and frames have
-- some in common, and each frame shows with probability delta something of its own in a cell (<.>
-- is the mean over q_f, and h_fc0 = 0). Otherwise a sliver of a symbol that is felt a little
-- otherwise than supposed would count as much as a symbol.
--
-- > h_fck(d) = l_fck(d) / 20
-- > h_fc(d)  = log (epsilon + sum over k of P(k) exp h_fck(d))
-- > g_fck(d) = log ((1 - delta) exp h_fck(d) + delta exp h_fc(d))
-- > F = sum over c of log (epsilon exp (sum over f of <g_fc0>)
-- >                        + sum over k of P(k) exp (sum over f of <g_fck>))
-- >     + log (sum over sigma of exp (sum over f of <log pi_sigma(d_f)>))
-- >     - sum over f, d of q_f(d) log q_f(d)
--
-- By the same g a cell's class is told, of which recognition makes its answer:
--
-- > P(k in c) ~ P(k) exp (sum over f of <g_fck>)
--
-- Frames that slip by a cell, or one that is elsewhere, stay on the lattice, so that F of them is
-- that of the same g in other cells.
--
-- So other axes and scales have against them the robot's errors that they need, symbols that frames
-- have in common and see otherwise, and those that a seam cuts into parts that do not fit. They are
-- not asked for F where P(lambda) is less likely by e^30 at a glance, each frame in its likeliest
-- phase; and of more than 256 frames so many are asked, evenly.
--
-- Positions may also tell nothing at all: each frame lies anywhere, with one orientation o for all.
-- That is the limit of large sigma, in which no frame tells another which classes the cells have.
-- With the mean over the n phases of an orientation, and f's phases within e^12 of its likeliest,
--
-- > E_0 = log (mean over o of product over f of
-- >            max (mean over the phases lambda of o of exp (sum of h_fc over lambda's cells c))
-- >                (delta * the larger of the two means))
-- > E   = F - log P(lambda*) - log (2 n) - F_n log (2 pi) - log (number of sigmas)
--
-- E is F of the nominal places at the likeliest phase lambda* as a log evidence like E_0, with F_n
-- frames and P(lambda*) among all phases. E_0 - E weighs that the positions tell nothing.
--
-- A scale s of the positions is a layout like other axes. Where sigma is above 1.5 taxels, scales
-- of both axes and of each one are tried at a glance, so finely that the outermost frames move by
-- less than a taxel from one to the next; of those that are likelier than 1, and than their
-- neighbours, the four likeliest are asked for F ("PraTactile.Registration.Scale").
--
-- = Two frames
--
-- By the lattice, a displacement d of the second against the first is summed over all phases and
-- the classes of the cells, those that both see having one class:
--
-- > P(d) ~ pi(d) * sum over lambda of
-- >        product over c of (epsilon + sum over k of P(k) exp (l_Ack + l_Bck(d)))
--
-- of which at most 30 000 displacements and phases are looked at, those that the two frames by
-- themselves have likeliest, within e^15 of the best.
--
-- Blind, relief is a stationary normal process: a coefficient of the frame's orthonormal cosine
-- transform, of frequency u across and v down (below 32 each, not both 0), is normal, of variance
-- s (S + n), independent of the others. S is a spectrum of Matern's family, of mean 1, with
-- smoothness nu (1.5, 2.5, 4) and range r (1, 1.5, 2.2, 3.3, 5 taxels); n is the noise's share
-- (10^-6, 3 10^-5, 5 10^-4, 0.003, 0.01, 0.03, 0.07, 0.15, 0.3, 0.6, 1.2, 2.5, 5). These are the
-- likeliest of both frames, and so is each frame's own scale s:
--
-- > S ~ (1 + r^2 ((pi u / width)^2 + (pi v / height)^2) / (2 nu - 1)) ^ -nu
--
-- With A and B the coefficients of what the frames have in common at d, over the roots of their
-- scales, and p = kappa S for relief that is kappa (0.003, 0.08, 0.4, 1.5) times as high there:
--
-- > one relief:   A and B have variance p + n, and covariance p or, to half a taxel, C p
-- > two reliefs:  covariance 0, each with a kappa of its own
-- > C = sinc (pi u / (2 width)) sinc (pi v / (2 height))
-- > R(g) = ratio of the densities of A e^(g/2) and B e^(-g/2) by one relief and by two,
-- >        each the mean over kappa
-- > P(d) ~ pi(d) * (mean over g of R(g)^0.8) ^ m,    g normal, of variance 0.16
--
-- where C is the mean cosine of a coefficient's phase over displacements within half a taxel, e^g
-- how many times what the first frame reads the second does beyond the scales, and m, within 1/2 to
-- 2, how many times as large the overlap is at the nominal displacement. An overlap of less than
-- two taxels tells nothing.
--
-- By correlation, the paper's, rho being that of n overlapping pixels (0.4 of them independent), no
-- more than at the nominal displacement:
--
-- > P(d) ~ pi(d) (1 - rho^2) ^ (-0.4 n / 2),    rho > 0
--
-- = Many frames that show no lattice
--
-- Of each frame at most eight overlaps are looked at. A pair overlaps in n pixels, no more than at
-- the nominal displacement, with correlation rho > 0, the noise's variance added to both. Then
--
-- > L_fg(e) = - (n / 2) log (1 - rho^2) / root B_fg,    e = d_g - d_f, whole taxels
-- > B_fg = sum over all lags of the product of the two frames' autocorrelations, at least 1
--
-- By chance two reliefs correlate as if pixels were B times fewer (Bartlett, 1946); one relief
-- under white noise is told by every pixel; root B is between the two. A pair tells nothing as
-- probably as it is right, and what is common to all displacements is free:
--
-- > P(d_1 .. d_F, sigma) ~ product of pi_sigma(d_f - c)
-- >                        * product over pairs of (1 + exp L_fg(d_g - d_f))
--
-- with pi and sigma as above, and c uniform. The mean of m frames tells c to sigma^2 / m, so that
-- each frame has for prior the others' mean and shares of sigma, with sigma^2 (1 + 1 / m):
--
-- > q_f(d) ~ pi(d) * product over the pairs of f of (1 + sum over d' of q_g(d') exp L_fg(d' - d))
--
-- At first one frame after the other by those before it, the first where the robot has it, next the
-- one whose pairs with those placed have the highest L; then each by all, until none changes its
-- likeliest displacement or ten sweeps are done. What q_g has below 0.002 tells nothing. Between
-- the grid's points the displacements are those of least squares: of a pair the highest place of L
-- within a taxel of where the field has it, to an eighth, its second derivatives for weights, as
-- far as both frames are there; and the robot's mean 1 / sigma^2.
--
-- = What is left over
--
-- A frame without variation, z = 0, tells next to nothing. Where two frames do not show a lattice,
-- what is sure by it is the prior; along a straight edge the prior alone is left
-- ("PraTactile.Registration.Pair.Straight"). Frames that agree at several places are refused
-- ("PraTactile.Registration.Pair.Alike"); that frames would agree along other axes, or nowhere, is
-- said ("PraTactile.Registration.Agreement").
--
-- = Names
--
-- > a, b, p, q, v     Press, of one frame that is tilted     h_r  indentation
-- > z, N              a frame, as fitOf standardises it      a, b, v   Theta
-- > T                 Templates     <z, T>, sum T, sum T^2   Moments, summed up: Y, S, Q
-- > l_k, l, L         classLogs, cellLogs, phaseLogs     log p(z)  logDensity
-- > epsilon, P(k)     absence, classPrior                  beta      blurDeviation
-- > P(lambda)         phasePosterior                         pi        priorsAlong
-- > d, with l_fck     Displacement                           delta     outlier
-- > q_f, F            meanField, fieldBound                  e^30      negligible
-- > E, E_0            jointEvidence, jointAnywhere
module PraTactile.Registration.Model
  ( -- * What a frame reads
    Theta (..),
    leastGain,
    leastVariance,
    blurDeviation,
    leastShare,

    -- * A tilted press
    Press (..),
    planeAt,
    indentation,
    touches,
    reliefShare,
    leastTouch,
    independentShare,

    -- * The lattice
    cellShare,
    placesPerTaxel,
    absence,
    classPrior,
    cellLog,
    negligible,

    -- * Displacements
    normalLog,
    sigmasPerOctave,
    outlier,
    tolerance,
    eighth,
  )
where

-- | theta: how a frame reads relief.
data Theta = Theta
  { thetaGain :: !Double,
    thetaOffset :: !Double,
    thetaVariance :: !Double
  }
  deriving stock (Eq, Show)

-- | The least gain and variance that are found: no frame is all noise, nor without any.
leastGain, leastVariance :: Double
leastGain = 0.3
leastVariance = 2e-3

-- | beta, the standard deviation, in taxels, of the blur that is supposed: that of an elastic
-- overlay and of an element's aperture. Assumption; a half more or less changes little.
blurDeviation :: Double
blurDeviation = 0.75

-- | The least share of a taxel that counts in a sum of squares.
leastShare :: Double
leastShare = 0.01

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

-- | The least t of a taxel that touches, and what share of taxels counts where it is asked whether
-- presses are tilted (assumptions).
leastTouch, independentShare :: Double
leastTouch = 0.25
independentShare = 0.2

-- | What share of a cell's log-likelihood counts where the symbol in it is told, and how likely a
-- layout is. Measured: as many symbols are wrong as are told to be (@bench/calibration.py@).
cellShare :: Double
cellShare = 0.05

-- | How finely phases and displacements are told apart, in places to the taxel.
placesPerTaxel :: Int
placesPerTaxel = 2

-- | epsilon, the probability that nothing is in a cell: beyond the face, or worn off.
absence :: Double
absence = 0.01

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
    !m = highest 0 0
    highest :: Int -> Double -> Double
    highest !k !best
      | k >= count = best
      | otherwise = highest (k + 1) (max best (at k))
{-# INLINE cellLog #-}

-- | What is so much less likely, as a natural logarithm, does not count.
negligible :: Double
negligible = 30

-- | How finely standard deviations of the robot's error are told apart.
sigmasPerOctave :: Int
sigmasPerOctave = 6

-- | The logarithm of a normal density up to a constant, given its variance and the square of the
-- distance from its mean: log pi, of the square of a displacement or of its part along an axis.
normalLog :: Double -> Double -> Double
normalLog variance square = negate square / (2 * variance)
{-# INLINE normalLog #-}

-- | delta, the probability that a frame shows something else in a cell than all others do there
-- (assumption): it is not where it is supposed to be, or has but an edge of the symbol, which was
-- felt otherwise than the relief here supposes. Where that is thought next to impossible, a frame
-- that is at odds with its neighbours over an edge goes a whole cell away from them.
outlier :: Double
outlier = 1e-3

-- | How near to the truth a displacement counts as right, along each axis, taxels.
tolerance :: Double
tolerance = 0.75

-- | To the nearest eighth of a taxel, as displacements are given.
eighth :: Double -> Double
eighth t = fromIntegral (round (8 * t) :: Int) / 8
