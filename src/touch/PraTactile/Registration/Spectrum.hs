{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Relief as a stationary normal process plus white noise, by the discrete cosine transform, which
-- nearly makes its coefficients independent: which process a frame is likely of, and how much
-- likelier two patches are when they show one relief than when they show two.
--
-- The spectra are those of Matern's family (Stein, Interpolation of Spatial Data, 1999): smoothness
-- and range are found from the frames, and so is the share of the noise.
module PraTactile.Registration.Spectrum
  ( -- * Processes
    Spectra,
    spectra,
    spectraCosines,
    coefficientsOf,
    Process (..),
    processOf,
    whiteness,

    -- * Pairs
    Shared,
    shared,
    sharedLog,
  )
where

import Data.List (maximumBy)
import Data.Ord (comparing)
import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Image (Raster)
import PraTactile.Registration.Cosine
import PraTactile.Registration.Loops

-- | Tables for patches of up to a size; each is made when it is first looked at.
data Spectra = Spectra
  { spectraWidth :: !Int,
    spectraCosines :: !Cosines,
    -- | By width and height of a patch: the variances of its coefficients for each shape of the
    -- spectrum, and their @coherence@.
    spectraPatches :: !(Boxed.Vector (Boxed.Vector (Vector Double), Vector Double)),
    -- | Of whole frames, by shape and share of the noise: the inverse variances of the
    -- coefficients, and the sum of the logarithms of the variances.
    spectraWhole :: !(Boxed.Vector (Vector Double, Double))
  }

-- | The tables for frames of that width and height.
spectra :: Int -> Int -> Spectra
spectra w h =
  Spectra
    w
    (cosinesUpTo (max w h))
    (Boxed.generate ((w + 1) * (h + 1)) bySize)
    ( Boxed.fromList
        [whole alone noise | alone <- map (powers w h) [0 .. shapeCount - 1], noise <- noiseShares]
    )
  where
    bySize i =
      let (y, x) = i `quotRem` (w + 1)
       in (Boxed.generate shapeCount (powers x y), coherence x y)
    whole alone noise =
      let variances = V.map (+ noise) alone
       in (V.map (1 /) variances, V.sum (V.map log variances))

-- | A frame's coefficients.
coefficientsOf :: Spectra -> Raster -> Vector Double
coefficientsOf = cosineTransform . spectraCosines

-- | How much of the relief's variance a patch may have: relief is not alike everywhere, and two
-- patches of a gap are alike without saying much.
reliefScales :: [Double]
reliefScales = [0.003, 0.08, 0.4, 1.5]

-- | Smoothness and range (taxels) of the processes.
shapesOfSpectrum :: [(Double, Double)]
shapesOfSpectrum = [(nu, range) | nu <- [1.5, 2.5, 4], range <- [1, 1.5, 2.2, 3.3, 5]]

shapeCount, noiseCount :: Int
shapeCount = length shapesOfSpectrum
noiseCount = length noiseShares

-- | The variances of the noise that are tried, as shares of the relief's.
noiseShares :: [Double]
noiseShares = [1e-6, 3e-5, 5e-4, 0.003, 0.01, 0.03, 0.07, 0.15, 0.3, 0.6, 1.2, 2.5, 5]

-- | The variances of a patch's coefficients, without the mean's, for a process of variance 1.
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

-- | The mean cosine of a coefficient's phase over the displacements within half a taxel.
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

-- | The variance of each process before it is made 1: the mean over both frequencies, of which one
-- as well as the other may be the greater.
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
  { -- | Which of the processes that are tried.
    processIndex :: !Int,
    -- | The noise's variance as a share of the relief's.
    processNoise :: !Double,
    -- | The relief's variance in each of the frames.
    processScales :: ![Double],
    -- | The logarithm of the probability density of each frame, standardised to variance 1.
    processLogs :: ![Double]
  }
  deriving stock (Eq, Show)

-- | The likeliest process of frames, from their coefficients ('cosineTransform'), each frame with
-- its own scale; among those whose noise has at least that share of the relief's variance.
processOf :: Spectra -> Double -> [Vector Double] -> Process
processOf tables least frames = Process best (noiseShares !! (best `rem` noiseCount)) scales logs
  where
    powersSeen = map (\c -> let squares = V.map (\x -> x * x) c in (squares, V.sum squares)) frames
    scores = V.generate (shapeCount * noiseCount) score
    score i
      | noiseShares !! (i `rem` noiseCount) < least = -1 / 0
      | otherwise = sum (map (fst . fit i) powersSeen)
    best = V.maxIndex scores
    (logs, scales) = unzip (map (fit best) powersSeen)
    fit i (squares, total)
      | total <= 0 = (0, 0)
      | otherwise =
        (n / 2 * (log (total / n) - log scale - 1 - log (2 * pi)) - logs' / 2, scale)
      where
        (inverses, logs') = spectraWhole tables Boxed.! i
        n = fromIntegral (V.length squares)
        scale = dot squares inverses / n

-- | The logarithm of the probability density of a standardised frame with that many coefficients if
-- it is white noise and nothing else.
whiteness :: Vector Double -> Double
whiteness c = negate n / 2 * (1 + log (2 * pi))
  where
    n = fromIntegral (V.length c)

-- | What two patches tell at one scale of the relief: of two reliefs, of one that lies exactly so,
-- and of one that lies so to half a taxel.
data Shared = Shared !Sums !Sums !Sums

-- | What two patches tell under a normal law of the pairs of their coefficients: the sums of the
-- first's squares, of the products and of the second's squares, each weighed by the inverse of
-- their covariance, and half the logarithm of its determinant.
data Sums = Sums !Double !Double !Double !Double

-- | What two patches of that width and height tell at each of @reliefScales@, from their
-- coefficients, each divided by the root of its frame's scale.
shared :: Spectra -> Process -> (Int, Int) -> (Vector Double, Vector Double) -> [Shared]
shared tables process (w, h) (a, b) =
  [ Shared
      (sums scale (\_ _ -> 0))
      (sums scale const)
      (sums scale (\p i -> p * V.unsafeIndex coherent i))
    | scale <- reliefScales
  ]
  where
    (shapesHere, coherent) = spectraPatches tables Boxed.! (h * (spectraWidth tables + 1) + w)
    power = shapesHere Boxed.! (processIndex process `quot` noiseCount)
    noise = processNoise process
    n = minimum (map V.length [a, b, power, coherent])
    -- Given the covariance of the patches by the relief's variance at a coefficient. Sixteen
    -- determinants at a time have one logarithm.
    sums :: Double -> (Double -> Int -> Double) -> Sums
    sums !scale covariance = from 0 0 0 0 0
      where
        from :: Int -> Double -> Double -> Double -> Double -> Sums
        from !i !x !y !z !l
          | i >= n = Sums x y z (l / 2)
          | otherwise = block i (min n (i + 16)) x y z 1 l
        block :: Int -> Int -> Double -> Double -> Double -> Double -> Double -> Sums
        block !i !to !x !y !z !product' !l
          | i >= to = from to x y z (l + log product')
          | otherwise =
            let p = scale * V.unsafeIndex power i
                v = p + noise
                c = covariance p i
                determinant = v * v - c * c
                squares = v / determinant
                ca = V.unsafeIndex a i
                cb = V.unsafeIndex b i
             in block
                  (i + 1)
                  to
                  (x + ca * ca * squares)
                  (y + ca * cb * (c / determinant))
                  (z + cb * cb * squares)
                  (product' * determinant)
                  l
    {-# INLINE sums #-}

-- | How much likelier, as a natural logarithm, the patches are of one relief than of two, whatever
-- the second reads times what the first does, beyond the scales: of that the logarithm g is normal,
-- of variance 'gainVariance', and summed over. Relief is no normal process, and the coefficients
-- are not quite independent, so each counts for somewhat less: @tempering@.
--
-- The sum is taken by steps of one width of the integrand about its highest place, both as they are
-- for the likeliest of the scales. (Without noise it is far narrower than the prior.)
sharedLog :: [Shared] -> Double
sharedLog scales = logSumOf [at (peak + k * width) | k <- [-4 .. 4]] + log width - logRoot
  where
    at g = tempering * ratioAt (exp g) - g * g / (2 * gainVariance)
    logRoot = log (2 * pi * gainVariance) / 2
    ratioAt ratio =
      meanOf [one ratio sums | Shared _ exactly nearly <- scales, sums <- [exactly, nearly]]
        - meanOf [first ratio sums | Shared sums _ _ <- scales]
        - meanOf [second ratio sums | Shared sums _ _ <- scales]
    one ratio (Sums x y z l) = negate l - (x * ratio + z / ratio) / 2 + y
    first ratio (Sums x _ _ l) = negate (l / 2) - x * ratio / 2
    second ratio (Sums _ _ z l) = negate (l / 2) - z / ratio / 2
    -- The integrand is the exponential of - (p exp g + r exp (-g)) / 2 - g^2 / 2 v, nearly.
    (p, r) = (weight xShared xAlone, weight zShared zAlone)
    weight both alone = tempering * max 0 (both - alone)
    Sums xShared _ zShared _ =
      likeliest
        (\(Sums x y z l) -> y - l - sqrt (x * z))
        [sums | Shared _ exactly nearly <- scales, sums <- [exactly, nearly]]
    Sums xAlone _ _ _ = likeliest (first 1) alones
    Sums _ _ zAlone _ = likeliest (second 1) alones
    alones = [sums | Shared sums _ _ <- scales]
    likeliest by = maximumBy (comparing by)
    curvature g = (p * exp g + r * exp (negate g)) / 2 + 1 / gainVariance
    peak = iterate newton (bounded 1 (if p > 0 && r > 0 then log (r / p) / 2 else 0)) !! 8
    newton g = g - bounded 0.5 (slope g / curvature g)
    slope g = (p * exp g - r * exp (negate g)) / 2 + g / gainVariance
    width = 1 / sqrt (curvature peak)
    bounded most = max (negate most) . min most
    meanOf logs = logSumOf logs - log (fromIntegral (length logs))
    logSumOf logs = top + log (sum [exp (l - top) | l <- logs, l > top - 40])
      where
        top = maximum logs

-- | Of the logarithm of the ratio of two frames' gains, beyond their scales (assumption).
gainVariance :: Double
gainVariance = 0.16

-- | Found on simulated frames of symbols, so that of what is given at 99 % that much is right.
tempering :: Double
tempering = 0.8
