{-# LANGUAGE BangPatterns #-}

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
        [whole s (noiseShares !! n) | s <- [0 .. shapeCount - 1], n <- [0 .. noiseCount - 1]]
    )
  where
    bySize i =
      let (y, x) = i `quotRem` (w + 1)
       in (Boxed.generate shapeCount (powers x y), coherence x y)
    whole s noise =
      let variances = V.map (+ noise) (powers w h s)
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

-- | The variance of each process before it is made 1.
normalisers :: Vector Double
normalisers =
  V.fromList
    [ sum [density nu range (f u) (f v) | u <- [0 .. n - 1], v <- [0 .. n - 1]]
        / fromIntegral (n * n)
      | (nu, range) <- shapesOfSpectrum
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

-- | How much likelier, as a natural logarithm, the patches are of one relief than of two, if the
-- second reads that many times what the first does, beyond the scales. Relief is no normal process,
-- and the coefficients are not quite independent, so each counts for somewhat less: @tempering@.
sharedLog :: Double -> [Shared] -> Double
sharedLog ratio scales =
  tempering
    * ( meanOf (concat [[one exactly, one nearly] | Shared _ exactly nearly <- scales])
          - meanOf [negate (l / 2) - x * ratio / 2 | Shared (Sums x _ _ l) _ _ <- scales]
          - meanOf [negate (l / 2) - z / ratio / 2 | Shared (Sums _ _ z l) _ _ <- scales]
      )
  where
    one (Sums x y z l) = negate l - (x * ratio + z / ratio) / 2 + y
    meanOf logs =
      let top =
            maximum logs
       in top + log (sum [exp (l - top) | l <- logs, l > top - 40] / fromIntegral (length logs))

-- | Found on simulated frames of symbols, so that of what is given at 99 % that much is right.
tempering :: Double
tempering = 0.8
