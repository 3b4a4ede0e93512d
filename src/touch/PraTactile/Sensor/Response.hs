{-# OPTIONS_HADDOCK hide #-}

-- | From the forces on the elements to their readings: conductance, gains, crosstalk, noise and
-- the converter, one function each. Readings are shares of full scale.
module PraTactile.Sensor.Response
  ( -- * One element
    conductance,
    converted,
    drifted,

    -- * All elements
    crosstalk,
    noiseDeviation,
    noisy,
    Deviates (..),

    -- * A specimen
    Specimen (..),
    flawless,
    drawSpecimen,
  )
where

import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Image
  ( Raster,
    generate,
    index,
    rasterHeight,
    rasterSize,
    rasterValues,
    rasterWidth,
  )
import PraTactile.Random (normals, uniform)
import PraTactile.Sensor.Model (Sensor (..))
import System.Random (RandomGen)

-- | The reading for a force: (force / full) ^ k, and 0 below the break force. The arguments are k,
-- the break force, the force of full scale and the force.
conductance :: Double -> Double -> Double -> Double -> Double
conductance k breakForce full force
  | force <= 0 || force < breakForce = 0
  | k == 1 = force / full
  | otherwise = (force / full) ** k

-- | The output of an analog-to-digital converter with the given number of bits: the nearest code
-- as a share of the greatest. The second number is how many lowest codes read as 0. With 0 bits the
-- reading is only clipped to 0..1.
converted :: Int -> Int -> Double -> Double
converted bits zeroed v
  | bits <= 0 = clipped
  | code < zeroed = 0
  | otherwise = fromIntegral code / top
  where
    clipped = max 0 (min 1 v)
    top = 2 ^ bits - 1 :: Double
    code = floor (clipped * top + 0.5) :: Int

-- | A reading after drift. The arguments are the drift per decade of time, the number of the
-- press, and the reading. Press n, counted from 1, is made at time n.
drifted :: Double -> Int -> Double -> Double
drifted drift press v
  | drift == 0 = v
  | otherwise = v * (1 + drift * logBase 10 (fromIntegral (max 1 press)))

-- | Readings with crosstalk: the given share of each comes from the mean of its row, the same
-- share from the mean of its column. A value that all readings have in common does not change.
crosstalk :: Double -> Raster -> Raster
crosstalk share image
  | share <= 0 || w == 0 || h == 0 = image
  | otherwise = generate w h (\x y -> (1 - 2 * share) * at x y + share * (row y + column x))
  where
    (w, h) = rasterSize image
    at x y = fromMaybe 0 (index image x y)
    values = rasterValues image
    rowMeans =
      V.generate h (\y -> V.sum (V.slice (y * w) w values) / fromIntegral w) :: Vector Double
    columnMeans = V.generate w (\x -> sum [at x y | y <- [0 .. h - 1]] / fromIntegral h)
    row y = fromMaybe 0 (rowMeans V.!? y)
    column x = fromMaybe 0 (columnMeans V.!? x)

-- | Draws from the standard normal distribution: one per element, one per row, one per column.
data Deviates = Deviates
  { deviatesOfElements :: Vector Double,
    deviatesOfRows :: Vector Double,
    deviatesOfColumns :: Vector Double
  }

-- | The standard deviation of the noise at a reading.
noiseDeviation :: Sensor -> Double -> Double
noiseDeviation sensor v = sensorNoise sensor + sensorNoiseSlope sensor * max 0 (min 1 v)

-- | Readings with noise of 'noiseDeviation'. The shares 'sensorRowNoise' and 'sensorColumnNoise'
-- of its variance are common to a row and to a column.
noisy :: Sensor -> Deviates -> Raster -> Raster
noisy sensor (Deviates own ofRow ofColumn) image =
  generate
    w
    (rasterHeight image)
    (\x y -> let v = at x y in v + noiseDeviation sensor v * deviate x y)
  where
    w = rasterWidth image
    at x y = fromMaybe 0 (index image x y)
    deviate x y
      | sensorRowNoise sensor + sensorColumnNoise sensor <= 0 = drawn own (y * w + x)
      | otherwise =
        sqrt (max 0 (1 - sensorRowNoise sensor - sensorColumnNoise sensor)) * drawn own (y * w + x)
          + sqrt (sensorRowNoise sensor) * drawn ofRow y
          + sqrt (sensorColumnNoise sensor) * drawn ofColumn x
    drawn v i = fromMaybe 0 (v V.!? i)

-- | An individual sensor of a kind, by the gain of each element; 0 for a dead element.
newtype Specimen = Specimen {specimenGains :: Raster}
  deriving stock (Eq, Show)

-- | The specimen whose elements all have the gain 1.
flawless :: Sensor -> Specimen
flawless sensor = Specimen (generate (sensorColumns sensor) (sensorRows sensor) (\_ _ -> 1))

-- | A random specimen: gains are normal about 1 and at least 0; each element is dead
-- independently. Nothing is drawn where the constants leave nothing to chance.
drawSpecimen :: RandomGen g => Sensor -> g -> (Specimen, g)
drawSpecimen sensor g0 = (Specimen (generate w h gain), g2)
  where
    (w, h) = (sensorColumns sensor, sensorRows sensor)
    count = w * h
    (spread, g1) = if sensorGainSpread sensor > 0 then normals count g0 else (V.empty, g0)
    (fates, g2) = if sensorDead sensor > 0 then uniforms count g1 else (V.empty, g1)
    gain x y
      | fromMaybe 1 (fates V.!? i) < sensorDead sensor = 0
      | otherwise = max 0 (1 + sensorGainSpread sensor * fromMaybe 0 (spread V.!? i))
      where
        i = y * w + x

uniforms :: RandomGen g => Int -> g -> (Vector Double, g)
uniforms count g0 = let (drawn, end) = go count g0 in (V.fromListN count drawn, end)
  where
    go :: RandomGen g => Int -> g -> ([Double], g)
    go 0 g = ([], g)
    go n g = let (u, g') = uniform g; (rest, g'') = go (n - 1) g' in (u : rest, g'')
