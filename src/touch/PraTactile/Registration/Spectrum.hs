{-# OPTIONS_HADDOCK hide #-}

-- | Relief as a stationary normal process plus white noise. The discrete cosine transform makes its
-- coefficients nearly independent. This module finds the likeliest process of frames. For a pair of
-- patches it tells how much likelier they are if both show the same relief than if each shows its
-- own: the log-likelihood ratio of one relief to two.
--
-- A coefficient of frequency u across and v down (not both 0) is normal, of variance s (S + n),
-- independent of the others. S is a spectrum of Matern's family (Stein, Interpolation of Spatial
-- Data, 1999), of mean 1, with smoothness nu and range r (taxels); n is the noise's share. These
-- are the likeliest for all frames together. The scale s is the likeliest for each frame:
--
-- > S ~ (1 + r^2 ((pi u / width)^2 + (pi v / height)^2) / (2 nu - 1)) ^ -nu
--
-- A and B are the coefficients of the overlap in two frames, divided by the roots of the frames'
-- scales. For relief whose variance there is kappa times as large, p = kappa S:
--
-- > one relief:   A and B have variance p + n, and covariance C p
-- > two reliefs:  covariance 0, each with a kappa of its own
-- > C = 1,  or c,  or alike * c,    c = sinc (pi u / (2 width)) sinc (pi v / (2 height))
-- > L = tempering * log R - g^2 / (2 gainVariance)
-- > R = ratio of the densities of A e^(g/2) and B e^(-g/2) by one relief and by two,
-- >     each the mean over kappa and C
--
-- where c is the mean of cos (pi u dx / width) cos (pi v dy / height) over displacements dx and
-- dy of at most half a taxel.
module PraTactile.Registration.Spectrum
  ( -- * Processes
    Spectra,
    spectra,
    spectraSize,
    spectraCosines,
    coefficientsOf,
    Process (..),
    processOf,
    whiteness,
    Fitted (..),
    fitTo,

    -- * Patches of two frames
    PatchWeights,
    patchWeights,
    patchLog,
  )
where

import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Image (Raster)
import PraTactile.Probability (logSum)
import PraTactile.Registration.Cosine
import PraTactile.Registration.Loops
import PraTactile.Registration.Numbers (alike, gainVariance, mostNoise, tempering)

-- | Tables for frames of one size; each is computed on first use.
data Spectra = Spectra
  { spectraSize :: !(Int, Int),
    spectraCosines :: !Cosines,
    -- | For whole frames, by shape and noise share: the inverse variances of the coefficients, and
    -- the sum of the log variances.
    spectraWhole :: !(Boxed.Vector (Vector Double, Double))
  }

-- | The tables for frames of that width and height.
spectra :: Int -> Int -> Spectra
spectra w h =
  Spectra
    (w, h)
    (cosinesUpTo (max w h))
    ( Boxed.fromList
        [whole alone noise | alone <- map (powers w h) [0 .. shapeCount - 1], noise <- noiseShares]
    )
  where
    whole alone noise =
      let variances = V.map (+ noise) alone
       in (V.map (1 /) variances, V.sum (V.map log variances))

-- | A frame's coefficients by 'cosineTransform': row by row of v, at most 'highest' to a side,
-- without the mean's. No side of the frame may be longer than the longer side of the tables.
coefficientsOf :: Spectra -> Raster -> Vector Double
coefficientsOf = cosineTransform . spectraCosines

-- | The shapes of spectrum that are tried: smoothness nu and range r (taxels).
shapesOfSpectrum :: [(Double, Double)]
shapesOfSpectrum = [(nu, range) | nu <- [1.5, 2.5, 4], range <- [1, 1.5, 2.2, 3.3, 5]]

shapeCount, noiseCount :: Int
shapeCount = length shapesOfSpectrum
noiseCount = length noiseShares

-- | The variances of the noise that are tried, as shares of the relief's; the last is noise alone.
noiseShares :: [Double]
noiseShares = [1e-6, 3e-5, 5e-4, 0.003, 0.01, 0.03, 0.07, 0.15, 0.3, 0.6, 1.2, 2.5, 5, 25, 125]

-- | The variances of a patch's coefficients, without the mean's, for the s-th shape, of variance 1.
powers :: Int -> Int -> Int -> Vector Double
powers w h s = V.generate (max 0 (k * m - 1)) (power . (+ 1))
  where
    (nu, range) = shapesOfSpectrum !! s
    k = min highest w
    m = min highest h
    power i =
      let (v, u) = i `quotRem` k
       in density nu range (frequency u w) (frequency v h) / normalisers V.! s
    frequency :: Int -> Int -> Double
    frequency u n = pi * fromIntegral u / fromIntegral n

-- | For each coefficient the number c of the module's header.
coherence :: Int -> Int -> Vector Double
coherence w h = V.generate (max 0 (k * m - 1)) (at . (+ 1))
  where
    k = min highest w
    m = min highest h
    at i = let (v, u) = i `quotRem` k in sinc (half u w) * sinc (half v h)
    half :: Int -> Int -> Double
    half u n = pi * fromIntegral u / fromIntegral n / 2
    sinc t = if t < 1e-9 then 1 else sin t / t

density :: Double -> Double -> Double -> Double -> Double
density nu range fx fy =
  range * range * (1 + range * range * (fx * fx + fy * fy) / (2 * nu - 1)) ** negate nu

-- | The mean of each shape's density over all pairs of frequencies, by which it is divided to have
-- mean 1. The density is symmetric in them, so each pair is computed once.
normalisers :: Vector Double
normalisers =
  V.fromList
    [ (2 * sum [at u v | v <- [1 .. n - 1], u <- [0 .. v - 1]] + sum [at u u | u <- [0 .. n - 1]])
        / fromIntegral (n * n)
      | (nu, range) <- shapesOfSpectrum,
        let at u v = density nu range (f u) (f v)
    ]
  where
    n = 64 :: Int
    f u = pi * fromIntegral u / fromIntegral n

-- | A process and its noise.
data Process = Process
  { -- | The index of its shape in 'shapesOfSpectrum' times 'noiseCount', plus the index of its
    -- noise in 'noiseShares'.
    processIndex :: !Int,
    -- | The noise's variance as a share of the relief's.
    processNoise :: !Double
  }
  deriving stock (Eq, Show)

-- | The likeliest process of frames, from their coefficients ('cosineTransform'), each frame with
-- its own scale. The noise shares that are tried are at most 'mostNoise', and at least the given
-- one rounded up to the next of 'noiseShares'. If that is above 'mostNoise', it alone is tried.
processOf :: Spectra -> Double -> [Vector Double] -> Process
processOf tables least frames = numbered (V.maxIndex scores)
  where
    numbered i = Process i (noiseShares !! (i `rem` noiseCount))
    squares = map (V.map (\x -> x * x)) frames
    lowest = minimum (maximum noiseShares : filter (>= least) noiseShares)
    scores = V.generate (shapeCount * noiseCount) $ \i ->
      let process = numbered i
       in if processNoise process < lowest || processNoise process > max lowest mostNoise
            then -1 / 0
            else sum (map (densityLog . fitted tables process) squares)

-- | The fit of a process to a frame.
data Fitted = Fitted
  { -- | The logarithm of the probability density of the frame, standardised to variance 1.
    densityLog :: !Double,
    -- | The relief's variance in the frame.
    reliefScale :: !Double
  }

-- | Fits a process to a frame, given the frame's coefficients. Both numbers are 0 for a frame
-- without variation.
fitTo :: Spectra -> Process -> Vector Double -> Fitted
fitTo tables process = fitted tables process . V.map (\x -> x * x)

-- | Fits a process to a frame, given the squares of the frame's coefficients.
fitted :: Spectra -> Process -> Vector Double -> Fitted
fitted tables process squares
  | total <= rounding = Fitted 0 0
  | otherwise = Fitted (n / 2 * (log (total / n) - log scale - 1 - log (2 * pi)) - logs / 2) scale
  where
    (inverses, logs) = spectraWhole tables Boxed.! processIndex process
    total = V.sum squares
    -- Below this a frame is flat. One taxel that differs by one step of 16 bits gives 2e-10.
    rounding = 1e-16
    n = fromIntegral (V.length squares)
    scale = dot squares inverses / n

-- | The log density of a standardised frame under white noise; of the coefficients only the number
-- matters.
whiteness :: Vector Double -> Double
whiteness c = negate n / 2 * (1 + log (2 * pi))
  where
    n = fromIntegral (V.length c)

-- | The variances kappa of a patch's relief that are tried, as multiples of the process's. Relief
-- varies from place to place: two patches of the flat ground between symbols look alike, which says
-- nothing about their places.
reliefVariances :: [Double]
reliefVariances = [0.003, 0.08, 0.4, 1.5]

-- | Patches of one width and height under a process.
data PatchWeights = PatchWeights
  { -- | For the greatest of 'reliefVariances'.
    weightsHighest :: ApartWeights,
    -- | For each of 'reliefVariances': the weights under two reliefs, and under one relief by
    -- each of 'coherences'.
    weightsByHeight :: [(ApartWeights, [PairWeights])]
  }

-- | For one normal coefficient: its inverse variance, coefficient by coefficient, and half the sum
-- of the log variances.
data ApartWeights = ApartWeights !(Vector Double) !Double

-- | For two jointly normal coefficients: the weights of a square and of their product, coefficient
-- by coefficient, and half the sum of the log determinants.
data PairWeights = PairWeights !(Vector Double) !(Vector Double) !Double

-- | The share of a coefficient's relief that two frames have in common, for patches of the given
-- width and height: all of it; what is left of it within half a taxel; and 'alike' of that.
coherences :: Int -> Int -> [Vector Double]
coherences w h = [V.map (const 1) nearly, nearly, V.map (* alike) nearly]
  where
    nearly = coherence w h

-- | The weights for patches of the given width and height under a process.
patchWeights :: Process -> (Int, Int) -> PatchWeights
patchWeights process (w, h) =
  PatchWeights
    (apart (maximum reliefVariances))
    [ (apart height, map (together height) (coherences w h))
      | height <- reliefVariances
    ]
  where
    power = powers w h (processIndex process `quot` noiseCount)
    variancesAt height = V.map (\s -> height * s + processNoise process) power
    apart height =
      let variances = variancesAt height
       in ApartWeights (V.map (1 /) variances) (V.sum (V.map log variances) / 2)
    together height coherent =
      PairWeights
        (V.zipWith (/) variances determinants)
        (V.zipWith (/) covariances determinants)
        (V.sum (V.map log determinants) / 2)
      where
        variances = variancesAt height
        covariances = V.zipWith (\s c -> height * s * c) power coherent
        determinants = V.zipWith (\v c -> v * v - c * c) variances covariances

-- | The log-likelihood ratio of one relief to two for a pair of patches, from their coefficients,
-- each divided by the root of its frame's scale. 'tempering' reduces it, because relief is no
-- normal process and the coefficients are not quite independent.
--
-- The second frame may read e^g times what the first does, beyond the scales. Here g is the value
-- within -1 to 1 that brings the patches' heights nearest to each other; its prior is normal, of
-- variance 'gainVariance'. A patch without variation gives 0.
patchLog :: PatchWeights -> Vector Double -> Vector Double -> Double
patchLog weights a b
  | high a <= 0 || high b <= 0 = 0
  | otherwise = tempering * likelier - g * g / (2 * gainVariance)
  where
    likelier =
      logMean (concat [map pair pairs | (_, pairs) <- weightsByHeight weights])
        - logMean [alone apart squaresA | (apart, _) <- weightsByHeight weights]
        - logMean [alone apart squaresB | (apart, _) <- weightsByHeight weights]
    alone (ApartWeights inverses constant) z = negate constant - dot inverses z / 2
    pair (PairWeights ofSquares ofProducts constant) =
      negate constant - dot ofSquares (V.zipWith (+) squaresA squaresB) / 2
        + dot ofProducts (V.zipWith (*) a b)
    squaresA = V.map (\x -> exp g * x * x) a
    squaresB = V.map (\y -> exp (negate g) * y * y) b
    g = max (-1) (min 1 (log (high b / high a) / 2))
    high z =
      let ApartWeights inverses _ = weightsHighest weights in dot inverses (V.map (\x -> x * x) z)
    logMean logs = logSum logs - log (fromIntegral (length logs))
