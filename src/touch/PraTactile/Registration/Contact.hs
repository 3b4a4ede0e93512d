{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Tilted presses: finds the plane between a rigid sensor and the face with each frame's gain and
-- offset, removes it, and weights the taxels by their contact.
--
-- A tilted rigid sensor lies nearer to the face by p x + q y, where x and y go from -1 to 1 between
-- its edges. A taxel that does not touch reads c, the mean of the lowest 1/32 of the readings. A
-- taxel that touches reads more the nearer it lies:
--
-- > z = c + h_r(x, y) + noise,    h_r(x, y) = max 0 (a r + b + p x + q y)
--
-- where r is 0, 1/2 (on an edge) or 1, with priors 0.62, 0.16 and 0.22, independent in each taxel.
-- EM maximises over (a, b, p, q, v), from the even press and from slopes in eight directions:
--
-- > eStep:  rho_r(u) ~ P(r) exp (- (z(u) - c - h_r(u))^2 / (2 v))
-- > mStep:  (a, b, p, q) = least squares of a r + b + p x + q y against z - c, by rho_r(u), over
-- >         the taxels u and reliefs r that touch: where the argument of h_r is above 0
-- >         v = (sum of rho_r (z - c - h_r)^2) / N
--
-- Presses count as tilted if 'mostAsked' of them show it by 'sure'. Schwarz's criterion charges for
-- the slopes, and 'independentShare' of the taxels counts:
--
-- > sum over frames of (share (log p(z) - max over p = q = 0 of log p(z)) - log N) > log 99
--
-- Each frame is then rewritten as an even press of the same depth would read it. t is a taxel's
-- contrast of embossed to flat, relative to the centre's, so that its noise becomes 1/t of the
-- centre's. Its weight is w = min 1 t^2, or 0 if t is below 'leastTouch', where it does not touch:
--
-- > t  = (h_1(x, y) - h_0(x, y)) / (h_1(0, 0) - h_0(0, 0))
-- > z' = c + h_0(0, 0) + (z - c - h_0(x, y)) / t
module PraTactile.Registration.Contact
  ( evened,

    -- * By parts
    TiltedPress (..),
    Taxel (..),
    taxelsOf,
    eStep,
    mStep,
    evenedBy,
  )
where

import Data.List (foldl', maximumBy, sort)
import Data.Maybe (fromMaybe)
import Data.Ord (comparing)
import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra (atIndex, linearSolve, (><))
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Image (Raster, constant, generate, rasterSize, rasterValues, standardDeviation)
import qualified PraTactile.Image as Image (mean)
import PraTactile.Registration.Model
import PraTactile.Registration.Numbers
  ( independentShare,
    leastGain,
    leastTouch,
    leastVariance,
    mostAsked,
    pressSteps,
  )

-- | Frames as even presses would read them, each with the weights w of its taxels; 'Nothing' unless
-- the frames show that they are tilted.
evened :: [Raster] -> Maybe [(Raster, Raster)]
evened images
  | sum (map shown (spacedOut mostAsked (filter varied images))) > log 99 = Just (map even' images)
  | otherwise = Nothing
  where
    -- Schwarz's criterion charges half the log of the number of taxels for each slope.
    shown image =
      let taxels = taxelsOf image
          (level, press) = climbed Level pressSteps taxels (usualPress taxels)
          (tilted, _) = climbed Tilted pressSteps taxels press
       in independentShare * (tilted - level) - log (fromIntegral (length taxels))
    even' image
      | varied image = evenedBy (likeliestPress image) image
      | otherwise = (image, uncurry constant (rasterSize image) 1)
    varied = any (> 1e-9) . standardDeviation

-- | A frame as an even press would read it, and the weights w of its taxels.
evenedBy :: TiltedPress -> Raster -> (Raster, Raster)
evenedBy press image = (generate w h level, generate w h counts)
  where
    (w, h) = rasterSize image
    (mean, deviation, lowest) = scaleOf image
    plane x y = planeAt press (across w x) (across h y)
    level x y
      | share < leastTouch = back 0
      | otherwise = back ((read' - indentation press 0 (plane x y)) / share)
      where
        share = touchAt (plane x y)
        read' = (V.unsafeIndex (rasterValues image) (y * w + x) - mean) / deviation - lowest
    back t = mean + deviation * (lowest + indentation press 0 0 + t)
    counts x y =
      let share = touchAt (plane x y) in if share < leastTouch then 0 else min 1 (share * share)
    touchAt s = contrast s / unit
    contrast s = indentation press 1 s - indentation press 0 s
    -- The centre's contrast, or half of that at the corner that touches most, if this is more.
    unit = max 1e-6 (max (contrast 0) (contrast most / 2))
    most = abs (pressAcross press) + abs (pressDown press)

-- | The maximum-likelihood press of a frame, which must vary.
likeliestPress :: Raster -> TiltedPress
likeliestPress image = snd (maximumBy (comparing fst) (map (climbed Tilted 15 taxels) starts))
  where
    taxels = taxelsOf image
    usual = usualPress taxels
    level = snd (climbed Level pressSteps taxels usual)
    starts =
      level :
        [ usual {pressAcross = 2 * cos t, pressDown = 2 * sin t}
          | k <- [0 .. 7 :: Int],
            let t = pi * fromIntegral k / 4
        ]

-- | A reading minus c, standardised, and its place: x and y from -1 to 1.
data Taxel = Taxel !Double !Double !Double

-- | The taxels of a frame, at most 1024, evenly spread.
taxelsOf :: Raster -> [Taxel]
taxelsOf image =
  [ Taxel ((v - mean) / deviation - lowest) (across w x) (across h y)
    | y <- [0, every .. h - 1],
      x <- [0, every .. w - 1],
      let v = V.unsafeIndex (rasterValues image) (y * w + x)
  ]
  where
    (w, h) = rasterSize image
    (mean, deviation, lowest) = scaleOf image
    every = max 1 (ceiling (sqrt (fromIntegral (w * h) / 1024 :: Double)))

-- | The place of taxel k of n, from -1 to 1 between the edges.
across :: Int -> Int -> Double
across n k = (2 * fromIntegral k + 1 - fromIntegral n) / fromIntegral n

-- | The mean and the standard deviation of a frame's readings, and c, standardised by them.
scaleOf :: Raster -> (Double, Double, Double)
scaleOf image = (mean, deviation, (sum few / fromIntegral (length few) - mean) / deviation)
  where
    mean = fromMaybe 0 (Image.mean image)
    deviation = max 1e-9 (fromMaybe 0 (standardDeviation image))
    values = rasterValues image
    few = take (max 1 (V.length values `quot` 32)) (sort (V.toList values))

-- | An even press with a gain and an offset usual for symbols.
usualPress :: [Taxel] -> TiltedPress
usualPress taxels = TiltedPress gain (average - 0.3 * gain) 0 0 0.25
  where
    gain = 1 / 0.42
    average = sum [t | Taxel t _ _ <- taxels] / fromIntegral (max 1 (length taxels))

-- | Whether p and q are estimated, or stay as they are.
data Slopes = Level | Tilted
  deriving stock (Eq)

-- | EM with n E steps: log p(z) and the press of the last.
climbed :: Slopes -> Int -> [Taxel] -> TiltedPress -> (Double, TiltedPress)
climbed slopes n taxels press
  | n <= 1 = (density, press)
  | otherwise = climbed slopes (n - 1) taxels (mStep slopes' press expected)
  where
    (density, expected) = eStep press taxels
    slopes' = if slopes == Level then 2 else 4

-- | Posterior sums over taxels and the reliefs that touch: of the products of (r, 1, x, y) with
-- each other and with the reading. Then the squared errors of all reliefs, and the number of
-- taxels.
data Expected = Expected
  { rr, r1, rx, ry, n1, nx, ny, xx, xy, yy, tr, t1, tx, ty, errors, total :: !Double
  }

-- | log p(z) at a press, and the expected sums.
eStep :: TiltedPress -> [Taxel] -> (Double, Expected)
eStep press taxels = (logs - total sums / 2 * log (2 * pi * pressVariance press), sums)
  where
    (logs, sums) = foldl' taxel (0, Expected 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0) taxels
    taxel (!l, !e) (Taxel t x y) = (l + top + log mass, added)
      where
        !s = planeAt press x y
        !d0 = t - indentation press 0 s
        !dh = t - indentation press 0.5 s
        !d1 = t - indentation press 1 s
        !l0 = logOf (reliefShare 0) d0
        !lh = logOf (reliefShare 0.5) dh
        !l1 = logOf (reliefShare 1) d1
        logOf share d = log share - d * d / (2 * pressVariance press)
        !top = max l0 (max lh l1)
        !e0 = exp (l0 - top)
        !eh = exp (lh - top)
        !e1 = exp (l1 - top)
        !mass = e0 + eh + e1
        touching relief p = if touches press relief s then p / mass else 0
        !p0 = touching 0 e0
        !ph = touching 0.5 eh
        !p1 = touching 1 e1
        !n = p0 + ph + p1
        !r = ph / 2 + p1
        !added =
          Expected
            (rr e + ph / 4 + p1)
            (r1 e + r)
            (rx e + r * x)
            (ry e + r * y)
            (n1 e + n)
            (nx e + n * x)
            (ny e + n * y)
            (xx e + n * x * x)
            (xy e + n * x * y)
            (yy e + n * y * y)
            (tr e + r * t)
            (t1 e + n * t)
            (tx e + n * x * t)
            (ty e + n * y * t)
            (errors e + (e0 * d0 * d0 + eh * dh * dh + e1 * d1 * d1) / mass)
            (total e + 1)

-- | The least-squares press, given how many of a, b, p and q to estimate (2 or 4). The others stay
-- as they are.
mStep :: Int -> TiltedPress -> Expected -> TiltedPress
mStep slopes press e = case linearSolve system given of
  Just found ->
    TiltedPress
      (max leastGain (atIndex found (0, 0)))
      (atIndex found (1, 0))
      (if slopes < 4 then pressAcross press else atIndex found (2, 0))
      (if slopes < 4 then pressDown press else atIndex found (3, 0))
      variance
  Nothing -> press {pressVariance = variance}
  where
    variance = max leastVariance (errors e / max 1 (total e))
    system = (slopes >< slopes) (concatMap (take slopes) (take slopes (ridged rows)))
    given = (slopes >< 1) (map ($ e) (take slopes [tr, t1, tx, ty]))
    rows = map (map ($ e)) [[rr, r1, rx, ry], [r1, n1, nx, ny], [rx, nx, xx, xy], [ry, ny, xy, yy]]
    -- Ridge: a parameter that no touching taxel determines becomes 0.
    ridged m =
      [ [if i == j then v + 1e-6 else v | (j, v) <- zip [0 ..] row]
        | (i, row) <- zip [0 :: Int ..] m
      ]
