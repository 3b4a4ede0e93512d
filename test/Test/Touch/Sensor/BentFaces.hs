{-# OPTIONS_GHC -O1 #-}

-- | Tests faces that are bent round a cylinder under a flat sensor: by the circle's area, by its
-- length along a chain of chords, and by symmetries.
module Test.Touch.Sensor.BentFaces (spec) where

import Data.Foldable (for_)
import Data.List (genericLength)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Sensor
import PraTactile.Sensor.Frame
import PraTactile.Sensor.Press
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate, within)
import Test.Touch.Sensor.MeanHeights (texture)

spec :: Spec
spec = do
  it "a plain face is lower under an aperture by the area that the circle leaves" $
    forAll ((,) <$> choose (18, 500) <*> elements [minBound ..]) $ \(radius, axis) ->
      let sensor = idealSensor {sensorFullScale = 100}
          plain = bent radius axis (heightMap 1 (constant 200 200 50))
          -- The integral of sqrt (R^2 - u^2).
          area u = (u * sqrt (radius * radius - u * u) + radius * radius * asin (u / radius)) / 2
          low k =
            let u = taxelPitch * (fromIntegral k - 8)
             in radius - (area (u + taxelPitch) - area u) / taxelPitch
          wanted i j = (50 - low (if axis == AboutY then i else j)) / 100
       in within 2e-4 (forwardImage sensor plain (SensorPose 100 100 0)) (generate 16 16 wanted)
  withCases 6 100
    . it "an element has the relief at its distance along the circle under it, by a chain of chords"
    $ forAll ((,) <$> choose (18, 200) <*> anyTurn) $ \(radius, turn) ->
      let sensor = idealSensor {sensorColumns = 3, sensorRows = 14, sensorFullScale = 100}
          seen = forwardImage sensor (bent radius AboutY ramp) (SensorPose 20 15 turn)
          under i j =
            mean'
              [ 50 + along radius u - (radius - sqrt (radius * radius - u * u))
                | a <- [0 .. 7],
                  b <- [0 .. 7],
                  let (u, _) =
                        movePoint
                          (Motion turn 0 0)
                          (place 3 i ((a + 0.5) / 8), place 14 j ((b + 0.5) / 8))
              ]
          place n k part = taxelPitch * (fromIntegral (k :: Int) + part - n / 2)
       in within 3e-4 seen (generate 3 14 (\i j -> under i j / 100))
  it "the larger the radius, the flatter, within the bounds of the formulas" $
    forAll ((,) <$> choose (2, 7 :: Double) <*> elements [minBound ..]) $ \(exponent', axis) ->
      forAll ((,,) <$> choose (15, 45) <*> choose (15, 45) <*> elements [0, 90, 180, 270]) $
        \(x, y, turn) ->
          let radius = 10 ** exponent'
              heights = texture 5 40 40
              full = sensorFullScale idealSensor
              -- If cells are as wide as an aperture, at most three borders move within one.
              most =
                reach * reach / radius / full
                  + 3 * (pi / 2 - 1) * reach ** 3 / (radius * radius) / taxelPitch
              reach = 8 * taxelPitch
              pose = SensorPose x y turn
           in within
                (most + 1e-9)
                (forwardImage idealSensor (bent radius axis heights) pose)
                (forwardImage idealSensor heights pose)
  it "bending the transposed relief about one axis is bending the relief about the other" $
    forAll (elements [idealSensor, presetSensor Real]) $ \sensor ->
      forAll ((,) <$> choose (20, 300) <*> anyTurn) $
        \(radius, turn) ->
          forAll ((,) <$> choose (15, 45) <*> choose (15, 45)) $ \(x, y) ->
            let heights = texture 6 40 40
                transposed = heightMap taxelPitch (turnedOver (heightValues heights))
             in within
                  1e-9
                  ( forwardImage
                      sensor
                      (bent radius AboutX transposed)
                      (SensorPose y x (negate turn))
                  )
                  ( turnedOver
                      (forwardImage sensor (bent radius AboutY heights) (SensorPose x y turn))
                  )
  it "the sensor touches at its own middle: moved by a period of the relief it reads the same" $
    forAll ((,) <$> elements [minBound ..] <*> elements [idealSensor, presetSensor Real]) $
      \(axis, sensor) ->
        forAll ((,,) <$> choose (20, 90) <*> choose (0, 360) <*> choose (25, 35)) $
          \(radius, turn, x) ->
            let period = 5
                repeated = generate 80 80 (\i j -> fromIntegral ((i + 2 * j) `mod` period) / 4)
                seen a = forwardImage sensor (bent radius axis (heightMap taxelPitch repeated)) a
             in within
                  1e-9
                  (seen (SensorPose x 40 turn))
                  (seen (SensorPose (x + 4 * taxelPitch * fromIntegral period) 40 turn))
  it "a rigid press goes on until lower tabs bear it, too" $
    forAll ((,) <$> choose (10, 60) <*> choose (0.01, 3)) $ \(radius, force) ->
      let -- Three tabs, so small that each feels a point, 2 mm apart.
          under =
            tabSupport
              (TaxelGrid 3 1 2)
              1e-6
              (bent radius AboutY (heightMap 1 (constant 50 50 1)))
              $ SensorPose 25 25 0
          low = radius - sqrt (radius * radius - 4)
          stiffness = 0.2
          middle = force / stiffness
          wanted
            | middle <= low = [0, middle, 0]
            | otherwise = let z = (middle + 2 * low) / 3 in [z - low, z, z - low]
          pressed' = displacements stiffness force (0, 0) under
       in counterexample (show (wanted, toRows pressed')) $
            and (zipWith (\a b -> abs (a - b) < 1e-6) wanted (concat (toRows pressed')))
  it "the least radius is the greatest distance of an element's points from the middle" $
    for_ [standardSensor, presetSensor Real, standardSensor {sensorColumns = 5}] $ \sensor -> do
      let points =
            [ sqrt (u * u + v * v)
              | i <- [0 .. sensorColumns sensor - 1],
                j <- [0 .. sensorRows sensor - 1],
                -- The aperture's corners, or the tab's rim.
                (a, b) <-
                  if sensorTab sensor > 0
                    then [(cos t / 2, sin t / 2) | k <- [0 .. 999 :: Int], t <- [fromIntegral k]]
                    else [(a, b) | a <- [-0.5, 0.5], b <- [-0.5, 0.5]],
                let side = if sensorTab sensor > 0 then sensorTab sensor else sensorTaxel sensor,
                let u = centre (sensorColumns sensor) i sensor + side * a,
                let v = centre (sensorRows sensor) j sensor + side * b
            ]
          centre n k one = sensorTaxel one * (fromIntegral k - (fromIntegral n - 1) / 2)
      abs (leastRadius sensor - maximum points) `shouldSatisfy` (< 1e-3)

-- | A ramp that rises by 1 mm for each millimetre of arc, from 50 under the middle of a sensor at
-- (20, 15).
ramp :: HeightMap
ramp = heightMap cell (generate 800 600 (\x _ -> cell * (fromIntegral x + 0.5) + 30))
  where
    cell = 0.05

anyTurn :: Gen Double
anyTurn = oneof [elements [0, 90, 180, 270], choose (0, 360)]

bent :: Double -> BendAxis -> HeightMap -> HeightMap
bent radius axis heights = heights {heightBend = Just (Bend radius axis)}

-- | The length of the circle from its top to u, along a chain of chords.
along :: Double -> Double -> Double
along radius u = signum u * sum (zipWith apart points (drop 1 points))
  where
    steps = 400 :: Int
    points =
      [ (t, sqrt (radius * radius - t * t))
        | k <- [0 .. steps],
          let t = abs u * fromIntegral k / fromIntegral steps
      ]
    apart (a, b) (c, d) = sqrt ((a - c) * (a - c) + (b - d) * (b - d))

mean' :: [Double] -> Double
mean' values = sum values / genericLength values

-- | The heights with rows and columns exchanged.
turnedOver :: Raster -> Raster
turnedOver image = generate (rasterHeight image) (rasterWidth image) (flip (at image))

at :: Raster -> Int -> Int -> Double
at image x y = fromMaybe (0 / 0) (index image x y)

within :: Double -> Raster -> Raster -> Property
within most a b =
  counterexample (show (toRows a) ++ "\n/=\n" ++ show (toRows b)) $
    rasterSize a == rasterSize b
      && V.all (<= most) (V.zipWith (\p q -> abs (p - q)) (rasterValues a) (rasterValues b))
