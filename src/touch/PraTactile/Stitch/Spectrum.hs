{-# LANGUAGE BangPatterns #-}

-- | Relief as a stationary normal process plus white noise, by the discrete cosine transform, which
-- nearly makes its coefficients independent: which process a frame is likely of, and how much
-- likelier two patches are when they show one relief than when they show two.
--
-- The spectra are those of Matern's family (Stein, Interpolation of Spatial Data, 1999): smoothness
-- and range are found from the frames, and so is the share of the noise.
module PraTactile.Stitch.Spectrum
  ( -- * The transform
    cosineTransform,

    -- * Processes
    Spectra,
    spectra,
    Process (..),
    processOf,
    whiteness,

    -- * Pairs
    Shared (..),
    shared,
    sharedLog,
  )
where

import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V

-- | The first coefficients of the orthonormal two-dimensional cosine transform (DCT-II) of a patch
-- of that width and height, row by row, without the first, the mean: at most 'highest' a side.
cosineTransform :: Spectra -> Int -> Int -> Vector Double -> Vector Double
cosineTransform tables w h values = V.generate (m * k - 1) (coefficient . (+ 1))
  where
    k = min highest w
    m = min highest h
    rowsOf = basis tables w
    columnsOf = basis tables h
    across = V.generate (h * k) $ \i ->
      let (y, u) = i `quotRem` k in dot w (u * w) rowsOf (y * w) 1 values
    coefficient i = let (v, u) = i `quotRem` k in dot h (v * h) columnsOf u k across
    dot :: Int -> Int -> Vector Double -> Int -> Int -> Vector Double -> Double
    dot n i xs j stride ys = go 0 0
      where
        go !t !s
          | t >= n = s
          | otherwise =
            go (t + 1) (s + V.unsafeIndex xs (i + t) * V.unsafeIndex ys (j + t * stride))
    {-# INLINE dot #-}

-- | How many frequencies a side are looked at.
highest :: Int
highest = 32

-- | What one relief takes from each square of a coefficient, and gives to each product of two; and
-- the logarithm of the determinants' ratio, halved.
data Weights = Weights !(Vector Double) !(Vector Double) !Double

-- | Tables for patches of up to a size; each is made when it is first looked at.
data Spectra = Spectra
  { spectraWidth :: !Int,
    spectraBases :: !(Boxed.Vector (Vector Double)),
    -- | By width and height of a patch, and by process.
    spectraPatches :: !(Boxed.Vector (Boxed.Vector Weights)),
    -- | Of whole frames, by shape and share of the noise: the inverse variances of the coefficients,
    -- and the sum of the logarithms of the variances.
    spectraWhole :: !(Boxed.Vector (Vector Double, Double))
  }

basis :: Spectra -> Int -> Vector Double
basis tables n = spectraBases tables Boxed.! n

-- | The tables for frames of that width and height.
spectra :: Int -> Int -> Spectra
spectra w h =
  Spectra
    w
    (Boxed.generate (max w h + 1) cosines)
    (Boxed.generate ((w + 1) * (h + 1)) bySize)
    (Boxed.fromList [whole s (noiseShares !! n) | s <- [0 .. shapeCount - 1], n <- [0 .. noiseCount - 1]])
  where
    bySize i = let (y, x) = i `quotRem` (w + 1) in Boxed.generate (shapeCount * noiseCount) (weights x y)
    weights x y i =
      let (s, n) = i `quotRem` noiseCount
          noise = noiseShares !! n
          power = powers x y s
          total p = p + noise
          rest p = total p * total p - p * p
       in Weights
            (V.map (\p -> p * p / (total p * rest p)) power)
            (V.map (\p -> p / rest p) power)
            (negate (V.sum (V.map (\p -> log (rest p / (total p * total p))) power)) / 2)
    whole s noise =
      let variances = V.map (+ noise) (powers w h s)
       in (V.map (1 /) variances, V.sum (V.map log variances))

cosines :: Int -> Vector Double
cosines n = V.generate (min highest n * n) $ \i ->
  let (u, t) = i `quotRem` n
      c = if u == 0 then sqrt (1 / size) else sqrt (2 / size)
   in c * cos (pi * fromIntegral u * (fromIntegral t + 0.5) / size)
  where
    size = fromIntegral n

-- | Smoothness and range (taxels) of the processes.
shapesOfSpectrum :: [(Double, Double)]
shapesOfSpectrum = [(nu, range) | nu <- [1.5, 2.5, 4], range <- [1, 1.5, 2.2, 3.3, 5]]

shapeCount, noiseCount :: Int
shapeCount = length shapesOfSpectrum
noiseCount = length noiseShares

-- | The variances of the noise that are tried, as shares of the relief's.
noiseShares :: [Double]
noiseShares = [0.003, 0.01, 0.03, 0.07, 0.15, 0.3, 0.6, 1.2, 2.5, 5]

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

density :: Double -> Double -> Double -> Double -> Double
density nu range fx fy =
  range * range * (1 + range * range * (fx * fx + fy * fy) / (2 * nu - 1)) ** negate nu

-- | The variance of each process before it is made 1.
normalisers :: Vector Double
normalisers =
  V.fromList
    [ sum [density nu range (f u) (f v) | u <- [0 .. n - 1], v <- [0 .. n - 1]] / fromIntegral (n * n)
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
-- its own scale.
processOf :: Spectra -> [Vector Double] -> Process
processOf tables frames = Process best (noiseShares !! (best `rem` noiseCount)) scales logs
  where
    squares = map (V.map (\c -> c * c)) frames
    scores = V.generate (shapeCount * noiseCount) (\i -> sum (map (fst . fit i) squares))
    best = V.maxIndex scores
    (logs, scales) = unzip (map (fit best) squares)
    fit i c
      | V.sum c <= 0 = (0, 0)
      | otherwise = (negate (logs' + n * log scale) / 2 - n / 2 * (1 + log (2 * pi)) + n / 2 * log total, scale)
      where
        (inverses, logs') = spectraWhole tables Boxed.! i
        n = fromIntegral (V.length c)
        scale = V.sum (V.zipWith (*) c inverses) / n
        total = V.sum c / n

-- | The logarithm of the probability density of a standardised frame with that many coefficients if
-- it is white noise and nothing else.
whiteness :: Vector Double -> Double
whiteness c = negate n / 2 * (1 + log (2 * pi))
  where
    n = fromIntegral (V.length c)

-- | What two patches tell of whether they show one relief: sums over the coefficients.
data Shared = Shared !Double !Double !Double !Double

-- | What two patches of that width and height tell, from their coefficients, each divided by the
-- root of its frame's scale.
shared :: Spectra -> Process -> Int -> Int -> Vector Double -> Vector Double -> Shared
shared tables process w h a b = go 0 0 0 0
  where
    Weights own cross constant =
      spectraPatches tables Boxed.! (h * (spectraWidth tables + 1) + w)
        Boxed.! processIndex process
    go :: Int -> Double -> Double -> Double -> Shared
    go !i !x !y !z
      | i >= V.length a = Shared x y z constant
      | otherwise =
        let ca = V.unsafeIndex a i
            cb = V.unsafeIndex b i
            o = V.unsafeIndex own i
         in go (i + 1) (x + o * ca * ca) (y + V.unsafeIndex cross i * ca * cb) (z + o * cb * cb)

-- | How much likelier, as a natural logarithm, the patches are of one relief than of two, if the
-- second reads that many times what the first does, beyond the scales.
sharedLog :: Double -> Shared -> Double
sharedLog ratio (Shared x y z l) = tempered * (l - (x * ratio + z / ratio) / 2 + y)

tempered :: Double
tempered = 0.8
