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

-- | Tables for patches of up to a size; each is made when it is first looked at.
data Spectra = Spectra
  { spectraWidth :: !Int,
    spectraBases :: !(Boxed.Vector (Vector Double)),
    -- | By width and height of a patch: the variances of its coefficients for each shape of the
    -- spectrum, and their 'coherence'.
    spectraPatches :: !(Boxed.Vector (Boxed.Vector (Vector Double), Vector Double)),
    -- | Of whole frames, by shape and share of the noise: the inverse variances of the
    -- coefficients, and the sum of the logarithms of the variances.
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

cosines :: Int -> Vector Double
cosines n = V.generate (min highest n * n) $ \i ->
  let (u, t) = i `quotRem` n
      c = if u == 0 then sqrt (1 / size) else sqrt (2 / size)
   in c * cos (pi * fromIntegral u * (fromIntegral t + 0.5) / size)
  where
    size = fromIntegral n

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
    squares = map (V.map (\c -> c * c)) frames
    scores = V.generate (shapeCount * noiseCount) score
    score i
      | noiseShares !! (i `rem` noiseCount) < least = -1 / 0
      | otherwise = sum (map (fst . fit i) squares)
    best = V.maxIndex scores
    (logs, scales) = unzip (map (fit best) squares)
    fit i c
      | V.sum c <= 0 = (0, 0)
      | otherwise =
        (negate (logs' + n * log scale) / 2 - n / 2 * (1 + log (2 * pi)) + n / 2 * log total, scale)
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

-- | What two patches tell at one scale: the weighted sums of the squares of either, with half the
-- logarithm of the determinant; and for each way of showing one relief, lying exactly so and only
-- to half a taxel, those of the squares and of the products.
data Shared = Shared !Sums !Sums !Sums

-- | Sums of the first's squares, of the products and of the second's squares, and half the
-- logarithm of the determinant.
data Sums = Sums !Double !Double !Double !Double

-- | What two patches of that width and height tell at each of 'reliefScales', from their
-- coefficients, each divided by the root of its frame's scale.
shared :: Spectra -> Process -> Int -> Int -> Vector Double -> Vector Double -> [Shared]
shared tables process w h a b = map summed reliefScales
  where
    (shapesHere, coherent) = spectraPatches tables Boxed.! (h * (spectraWidth tables + 1) + w)
    power = shapesHere Boxed.! (processIndex process `quot` noiseCount)
    noise = processNoise process
    n = V.length a
    summed scale = whole 0 0 0 0 0 0 0 0 0 0 0 0
      where
        -- Sixteen factors at a time, so that there is one logarithm for all of them.
        whole ::
          Int ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Shared
        whole !from !x0 !z0 !l0 !x1 !y1 !z1 !l1 !x2 !y2 !z2 !l2
          | from >= n =
            Shared (Sums x0 0 z0 (l0 / 2)) (Sums x1 y1 z1 (l1 / 2)) (Sums x2 y2 z2 (l2 / 2))
          | otherwise = part from (min n (from + 16)) x0 z0 1 l0 x1 y1 z1 1 l1 x2 y2 z2 1 l2
        part ::
          Int ->
          Int ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Double ->
          Shared
        part !i !to !x0 !z0 !p0 !l0 !x1 !y1 !z1 !p1 !l1 !x2 !y2 !z2 !p2 !l2
          | i >= to = whole to x0 z0 (l0 + log p0) x1 y1 z1 (l1 + log p1) x2 y2 z2 (l2 + log p2)
          | otherwise =
            let p = scale * V.unsafeIndex power i
                v = p + noise
                c = p * V.unsafeIndex coherent i
                ca = V.unsafeIndex a i
                cb = V.unsafeIndex b i
                d1 = v * v - p * p
                d2 = v * v - c * c
                r0 = 1 / v
                r1 = 1 / d1
                r2 = 1 / d2
                aa = ca * ca
                bb = cb * cb
                ab = ca * cb
             in part
                  (i + 1)
                  to
                  (x0 + aa * r0)
                  (z0 + bb * r0)
                  (p0 * v)
                  l0
                  (x1 + aa * v * r1)
                  (y1 + ab * p * r1)
                  (z1 + bb * v * r1)
                  (p1 * d1)
                  l1
                  (x2 + aa * v * r2)
                  (y2 + ab * c * r2)
                  (z2 + bb * v * r2)
                  (p2 * d2)
                  l2

-- | How much likelier, as a natural logarithm, the patches are of one relief than of two, if the
-- second reads that many times what the first does, beyond the scales. Relief is no normal process,
-- and the coefficients are not quite independent, so each counts for somewhat less: 'tempering'.
sharedLog :: Double -> [Shared] -> Double
sharedLog ratio scales =
  tempering
    * ( meanOf (concat [[one exactly, one nearly] | Shared _ exactly nearly <- scales])
          - meanOf [negate l - x * ratio / 2 | Shared (Sums x _ _ l) _ _ <- scales]
          - meanOf [negate l - z / ratio / 2 | Shared (Sums _ _ z l) _ _ <- scales]
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
