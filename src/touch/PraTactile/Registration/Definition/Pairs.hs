{-# OPTIONS_HADDOCK hide #-}

-- | Two frames registered blindly and by correlation, straight from the formulas of
-- "PraTactile.Registration.Model". Every coefficient is a sum over all pixels, and every process,
-- height and gain is tried with its normal density.
module PraTactile.Registration.Definition.Pairs
  ( -- * Frames
    cosines,
    ReliefProcess (..),
    reliefOf,
    whiteNoise,

    -- * Pairs
    PlacePosterior,
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

-- | Coefficients of the orthonormal cosine transform (DCT-II) by frequency across and down, at most
-- 32 along each axis. The mean's coefficient is left out.
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
data ReliefProcess = ReliefProcess
  { reliefShape :: !(Double, Double),
    reliefNoise :: !Double,
    -- | The relief's variance in each frame.
    reliefScales :: ![Double],
    -- | The log density of each frame, standardised to variance 1.
    reliefLogs :: ![Double]
  }

-- | The frequencies, across and down, of the coefficients that are used.
frequencies :: (Int, Int) -> [(Int, Int)]
frequencies (w, h) = drop 1 [(u, v) | v <- [0 .. min 32 h - 1], u <- [0 .. min 32 w - 1]]

-- | S of each coefficient, given smoothness and range (taxels), and the frame's size: Matern's
-- spectrum, of mean 1 over 64 x 64 frequencies.
spectrumOf :: (Double, Double) -> (Int, Int) -> [Double]
spectrumOf (nu, range) (w, h) = [at (wave w u) (wave h v) / average | (u, v) <- frequencies (w, h)]
  where
    at x y = (1 + range * range * (x * x + y * y) / (2 * nu - 1)) ** negate nu
    average = sum [at x y | x <- line, y <- line] / (64 * 64)
    line = map (wave 64) [0 .. 63]
    wave :: Int -> Int -> Double
    wave n k = pi * fromIntegral k / fromIntegral n

-- | The likeliest process of the frames, each frame with its own likeliest scale.
reliefOf :: [Raster] -> ReliefProcess
reliefOf images = maximumBy (comparing (sum . reliefLogs)) (reverse tried)
  where
    tried =
      [ ReliefProcess shape noise scales logs
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

-- | Log density of a frame under white noise, standardised to variance 1.
whiteNoise :: Raster -> Double
whiteNoise image = sum [normal 1 (z / sqrt variance) | z <- seen]
  where
    seen = map snd (cosines image)
    variance = sum (map (^ (2 :: Int)) seen) / fromIntegral (length seen)

-- | Log density of a normal number of mean 0, given the variance.
normal :: Double -> Double -> Double
normal v z = -(log (2 * pi * v) / 2) - z * z / (2 * v)

-- | Log density of two jointly normal numbers, given their common variance and their covariance.
normalPair :: Double -> Double -> (Double, Double) -> Double
normalPair v c (a, b) = normal (v + c) ((a + b) / sqrt 2) + normal (v - c) ((a - b) / sqrt 2)

-- | Posterior of the place of the second frame's upper left pixel in the first: whole places and
-- their probabilities.
type PlacePosterior = [((Int, Int), Double)]

-- | The posterior over whole places within the search around a nominal step, given the
-- log-likelihood of each place.
knownBy :: (Double, Double) -> Double -> ((Int, Int) -> Double) -> PlacePosterior
knownBy (x, y) search told = zip places (shares [prior d + told d | d <- places])
  where
    places = [(i, j) | j <- reached y, i <- reached x]
    reached t = [ceiling (t - search) .. floor (t + search)]
    -- The search covers two standard deviations.
    prior (i, j)
      | search <= 0 = 0
      | otherwise =
        -2 * (squared (fromIntegral i - x) + squared (fromIntegral j - y)) / squared search
    squared t = t * t

-- | The overlap of two images, as a part of each. The displacement is the place of the second's
-- upper left pixel in the first.
inCommon :: Raster -> Raster -> (Int, Int) -> (Raster, Raster)
inCommon a b (dx, dy) = (part a (max 0 dx, max 0 dy), part b (max 0 (-dx), max 0 (-dy)))
  where
    part image (x, y) = generate w h (\u v -> fromMaybe 0 (index image (x + u) (y + v)))
    (w, h) = (extent rasterWidth dx, extent rasterHeight dy)
    extent side d = max 0 (min (side a) (d + side b) - max 0 d)

pixels :: Raster -> Double
pixels image = fromIntegral (rasterWidth image * rasterHeight image)

-- | The posterior by blind registration, given the nominal step and the search.
blindly :: (Double, Double) -> Double -> Raster -> Raster -> PlacePosterior
blindly step search a b = knownBy step search (\d -> log (1 + exp (overlapLog step a b d)))

-- | Log evidence of two frames that overlap at a nominal step. Sigma is the standard deviation of
-- that step's error, taxels.
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

-- | L of two frames, given the nominal step and the place d of the second's upper left pixel in the
-- first.
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
          -- The height of each patch's relief, under the greatest height.
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
    ReliefProcess shape noise scales _ = reliefOf [a, b]
    brought = zipWith (\scale -> mapRaster (\z -> if scale > 0 then z / sqrt scale else 0)) scales
    nominal = max 1 (pixels (fst (inCommon a b (round x, round y))))
    sinc t = if t == 0 then 1 else sin t / t :: Double

-- | One coefficient: A and B, S, and C.
data Coefficient = Coefficient !(Double, Double) !Double !Double

-- | Log-likelihood ratio of one relief to two, from the coefficients and the noise share.
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

-- | The posterior by correlation, given the nominal step and the search.
byCorrelation :: (Double, Double) -> Double -> Raster -> Raster -> PlacePosterior
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
