{-# OPTIONS_HADDOCK hide #-}

-- | Two frames registered blindly and by correlation, by the formulas of
-- "PraTactile.Registration.Model" alone: every coefficient a sum over all pixels, every process,
-- height and gain tried, as densities of normal numbers.
module PraTactile.Registration.Definition.Pairs
  ( -- * Frames
    cosines,
    Relief (..),
    reliefOf,
    whiteNoise,

    -- * Pairs
    Known,
    blindly,
    pairEvidence,
    byCorrelation,
    inCommon,
  )
where

import Data.List (maximumBy)
import Data.Maybe (fromMaybe)
import Data.Ord (comparing)
import PraTactile.Image hiding (mean)
import PraTactile.Registration.Definition (logMean, shares)

-- | The coefficients of the orthonormal cosine transform (DCT-II), by the frequencies across and
-- down, of which 32 are looked at along each axis; without that of the mean.
cosines :: Raster -> [((Int, Int), Double)]
cosines image =
  [ ((u, v), sum [wave w u x * wave h v y * z | (y, row) <- rows, (x, z) <- zip [0 ..] row])
    | (u, v) <- frequencies (w, h)
  ]
  where
    (w, h) = rasterSize image
    rows = zip [0 ..] (toRows image)
    wave n k t =
      sqrt ((if k == 0 then 1 else 2) / fromIntegral n)
        * cos (pi * fromIntegral (k * (2 * t + 1)) / fromIntegral (2 * n))

-- | A process of relief: smoothness and range in taxels, and the noise's share.
data Relief = Relief
  { reliefShape :: !(Double, Double),
    reliefNoise :: !Double,
    -- | The relief's variance in each frame.
    reliefScales :: ![Double],
    -- | The logarithm of the density of each frame, brought to variance 1.
    reliefLogs :: ![Double]
  }

-- | The frequencies of the coefficients that are looked at, across and down.
frequencies :: (Int, Int) -> [(Int, Int)]
frequencies (w, h) = drop 1 [(u, v) | v <- [0 .. min 32 h - 1], u <- [0 .. min 32 w - 1]]

-- | S of each coefficient of a frame of that size, given smoothness and range in taxels: Matern's,
-- of mean 1 over 64 x 64 frequencies.
spectrumOf :: (Double, Double) -> (Int, Int) -> [Double]
spectrumOf (nu, range) (w, h) = [at (wave w u) (wave h v) / average | (u, v) <- frequencies (w, h)]
  where
    at x y = (1 + range * range * (x * x + y * y) / (2 * nu - 1)) ** negate nu
    average = sum [at x y | x <- line, y <- line] / (64 * 64)
    line = map (wave 64) [0 .. 63]
    wave :: Int -> Int -> Double
    wave n k = pi * fromIntegral k / fromIntegral n

-- | The process that makes frames likeliest, each of the scale that makes it likeliest.
reliefOf :: [Raster] -> Relief
reliefOf images = maximumBy (comparing (sum . reliefLogs)) (reverse tried)
  where
    tried =
      [ Relief shape noise scales logs
        | shape <- [(nu, range) | nu <- [1.5, 2.5, 4], range <- [1, 1.5, 2.2, 3.3, 5]],
          let relief = [zip coefficients (spectrumOf shape size) | (size, coefficients) <- seen],
          noise <- [1e-6, 3e-5, 5e-4, 0.003, 0.01, 0.03, 0.07, 0.15, 0.3, 0.6, 1.2, 2.5, 5],
          let (scales, logs) = unzip [likeliest [(z, s + noise) | (z, s) <- one] | one <- relief]
      ]
    seen = [(rasterSize image, map snd (cosines image)) | image <- images]
    likeliest told
      | variance <= 0 = (0, 0)
      | otherwise =
        (scale, sum [normal (scale * s / variance) (z / sqrt variance) | (z, s) <- told])
      where
        n = fromIntegral (length told)
        variance = sum [z * z | (z, _) <- told] / n
        scale = sum [z * z / s | (z, s) <- told] / n

-- | The logarithm of the density of a frame, brought to variance 1, if it is white noise.
whiteNoise :: Raster -> Double
whiteNoise image = sum [normal 1 (z / sqrt variance) | z <- seen]
  where
    seen = map snd (cosines image)
    variance = sum (map (^ (2 :: Int)) seen) / fromIntegral (length seen)

-- | The logarithm of a normal density, given the variance.
normal :: Double -> Double -> Double
normal v z = -(log (2 * pi * v) / 2) - z * z / (2 * v)

-- | That of two numbers of one variance, given it and their covariance.
normalPair :: Double -> Double -> (Double, Double) -> Double
normalPair v c (a, b) = normal (v + c) ((a + b) / sqrt 2) + normal (v - c) ((a - b) / sqrt 2)

-- | What is known of the place of the second frame's upper left pixel in the first: whole places
-- and their probabilities.
type Known = [((Int, Int), Double)]

-- | The places within the search around a step, each as probable as the prior times what both
-- frames tell there.
knownBy :: (Double, Double) -> Double -> ((Int, Int) -> Double) -> Known
knownBy (x, y) search told = zip places (shares [prior d + told d | d <- places])
  where
    places = [(i, j) | j <- reached y, i <- reached x]
    reached t = [ceiling (t - search) .. floor (t + search)]
    -- Two standard deviations are searched.
    prior (i, j)
      | search <= 0 = 0
      | otherwise =
        -2 * (squared (fromIntegral i - x) + squared (fromIntegral j - y)) / squared search
    squared t = t * t

-- | What both frames show where the second's upper left pixel lies at that place in the first.
inCommon :: Raster -> Raster -> (Int, Int) -> (Raster, Raster)
inCommon a b (dx, dy) = (part a (max 0 dx, max 0 dy), part b (max 0 (-dx), max 0 (-dy)))
  where
    part image (x, y) = generate w h (\u v -> fromMaybe 0 (index image (x + u) (y + v)))
    (w, h) = (extent rasterWidth dx, extent rasterHeight dy)
    extent side d = max 0 (min (side a) (d + side b) - max 0 d)

pixels :: Raster -> Double
pixels image = fromIntegral (rasterWidth image * rasterHeight image)

-- | Blind.
blindly :: (Double, Double) -> Double -> Raster -> Raster -> Known
blindly step search a b = knownBy step search (\d -> log (1 + exp (overlapLog step a b d)))

-- | The log evidence of two frames that overlap at a step, for robot's errors of that standard
-- deviation, in taxels between both.
pairEvidence :: Double -> (Double, Double) -> Raster -> Raster -> Double
pairEvidence sigma step@(x, y) a b = log (0.001 + 0.999 * sum (zipWith (*) (shares priors) told))
  where
    places = [(i, j) | j <- reached y, i <- reached x]
    reached t = let reach = max 1 (min 9 (2 * sigma)) in [ceiling (t - reach) .. floor (t + reach)]
    priors =
      [ -(squared (fromIntegral i - x) + squared (fromIntegral j - y)) / (2 * squared sigma)
        | (i, j) <- places
      ]
    squared t = t * t
    told = [exp (overlapLog step a b d) | d <- places]

-- | L of two frames, the second's upper left pixel lying there in the first, for a nominal step.
overlapLog :: (Double, Double) -> Raster -> Raster -> (Int, Int) -> Double
overlapLog (x, y) a b d = case brought [a, b] of
  [a', b']
    | (one, other) <- inCommon a' b' d,
      pixels one > 1 ->
      let seen =
            [ Coefficient (z, z') s (coherence f)
              | ((f, z), (_, z'), s) <-
                  zip3 (cosines one) (cosines other) (spectrumOf shape (rasterSize one))
            ]
          weight = max 0.5 (min 2 (nominal / pixels one))
          -- As many times as high is the second relief, by the highest process.
          high which = sum [which z * which z / (1.5 * s + noise) | Coefficient z s _ <- seen]
          g = max (-1) (min 1 (log (high snd / high fst) / 2))
          levelled =
            [Coefficient (exp (g / 2) * z, exp (-g / 2) * z') s c | Coefficient (z, z') s c <- seen]
          coherence (u, v) = sinc (half u rasterWidth) * sinc (half v rasterHeight)
          half k side = pi * fromIntegral k / (2 * fromIntegral (side one))
       in if high fst <= 0 || high snd <= 0
            then 0
            else weight * (0.8 * likelier noise levelled - g * g / 0.32)
  _ -> 0
  where
    Relief shape noise scales _ = reliefOf [a, b]
    brought = zipWith (\scale -> mapRaster (\z -> if scale > 0 then z / sqrt scale else 0)) scales
    nominal = max 1 (pixels (fst (inCommon a b (round x, round y))))
    sinc t = if t == 0 then 1 else sin t / t :: Double

-- | A and B, S, and C of a coefficient.
data Coefficient = Coefficient !(Double, Double) !Double !Double

-- | How much likelier, as a natural logarithm, coefficients are of one relief than of two.
likelier :: Double -> [Coefficient] -> Double
likelier noise seen =
  logMean (concatMap (`map` heights) [one, nearly 1, nearly 0.85]) - ofTwo fst - ofTwo snd
  where
    heights = [0.003, 0.08, 0.4, 1.5]
    one kappa = sum [normalPair (kappa * s + noise) (kappa * s) z | Coefficient z s _ <- seen]
    nearly share kappa =
      sum [normalPair (kappa * s + noise) (share * c * kappa * s) z | Coefficient z s c <- seen]
    ofTwo which =
      logMean
        [sum [normal (kappa * s + noise) (which z) | Coefficient z s _ <- seen] | kappa <- heights]

-- | By correlation.
byCorrelation :: (Double, Double) -> Double -> Raster -> Raster -> Known
byCorrelation step@(x, y) search a b = knownBy step search (told . inCommon a b)
  where
    most = pixels (fst (inCommon a b (round x, round y)))
    told (one, other)
      | n < 2 || cov <= 0 || min va vb <= 0 = 0
      | otherwise = -min most n / 5 * log (1 - min 0.9999 (cov * cov / (va * vb)))
      where
        n = pixels one
        centred image = let zs = concat (toRows image) in map (subtract (sum zs / n)) zs
        (as, bs) = (centred one, centred other)
        (va, vb, cov) = (dot as as, dot bs bs, dot as bs)
    dot us vs = sum (zipWith (*) us vs)
