-- | Tests the sensor's forward model; also has scenes of touched faces for other specifications.
module Test.Touch.Sensor.MeanHeights
  ( spec,
    texture,
    faceOf,
    embossing,
  )
where

import Data.List (genericLength)
import Data.Maybe (fromMaybe)
import Data.Tuple (swap)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Random (uniform)
import PraTactile.Sensor
import PraTactile.Sensor.Frame
import PraTactile.Shape (shapes, toRaster)
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (paperAlphabet)

-- | A relief of this many taxels, each of a random height from 0 to full scale, so that it has
-- detail everywhere.
texture :: Int -> Int -> Int -> HeightMap
texture seed w h =
  heightMap taxelPitch (generate w h (\x y -> full * fromMaybe 0 (heights V.!? (y * w + x))))
  where
    heights = V.unfoldrN (w * h) (Just . uniform) (mkStdGen seed)
    full = sensorFullScale standardSensor

-- | A face with the paper's symbols: the classes of its cells, row by row, each symbol in the
-- middle of a cell of 16 x 20 taxels.
faceOf :: [[Int]] -> HeightMap
faceOf cells = heightMap taxelPitch (generate (16 * columns) (20 * length cells) height)
  where
    columns = maximum (0 : map length cells)
    height x y = fromMaybe 0 $ do
      row <- at (y `quot` 20) cells
      kind <- at (x `quot` 16) row
      embossed <- at kind embossing
      (1.5875 *) <$> index embossed (x `rem` 16 - 4) (y `rem` 20 - 4)
    at i list = case drop i list of
      found : _ | i >= 0 -> Just found
      _ -> Nothing

-- | The paper's four symbols, 1 where they are embossed.
embossing :: [Raster]
embossing = either (const []) (map toRaster . shapes) paperAlphabet

spec :: Spec
spec = do
  describe "Forward model" forward
  describe "Noise and position errors" errors

-- | The mean height under an element of a sensor of this size, as a share of full scale, from
-- points of a fine grid: the definition, up to the grid's fineness.
sampled :: (Int, Int) -> HeightMap -> SensorPose -> Int -> Int -> Double
sampled (columns, rows) (HeightMap cell _ heights _) (SensorPose px py r) i j =
  sum hs
    / genericLength hs
  where
    fine = 40 :: Int
    hs =
      [ fromMaybe 0 (index heights (floor (x / cell)) (floor (y / cell)))
          / sensorFullScale idealSensor
        | a <- [0 .. fine - 1],
          b <- [0 .. fine - 1],
          let (x, y) = movePoint (Motion r px py) (at columns i a, at rows j b)
      ]
    at n k a =
      taxelPitch
        * (fromIntegral k - fromIntegral n / 2 + (fromIntegral a + 0.5) / fromIntegral fine)

-- | A sensor without errors of this many columns and rows, whose full scale is 1 mm.
sensorOf :: (Int, Int) -> Sensor
sensorOf (columns, rows) =
  idealSensor {sensorFullScale = 1, sensorColumns = columns, sensorRows = rows}

-- | Columns and rows, equal or not.
genSize :: Gen (Int, Int)
genSize = (,) <$> choose (1, 17) <*> choose (1, 17)

forward :: Spec
forward = do
  it "with the sensor's grid on the map's, the image is the map" $
    forAll genSize $ \size -> forAll (uncurry genRasterOf size) $ \heights ->
      let seen = forwardImage (sensorOf size) (heightMap taxelPitch heights) (middle size 0)
       in closeTo 1e-9 seen heights
  it "the image is the mean height under each element, on maps of any fineness" $
    forAll
      ((,,,) <$> genSize <*> genRasterOf 9 7 <*> choose (0.8, 4) <*> genNearPose)
      $ \(size@(w, h), heights, cell, pose) ->
        forAll ((,) <$> choose (0, w - 1) <*> choose (0, h - 1)) $ \(i, j) ->
          let relief = heightMap cell heights
              full = sensorFullScale idealSensor
              exact = index (forwardImage (sensorOf size) relief pose) i j
              fine = full * sampled size relief pose i j
           in counterexample
                (show (exact, fine))
                (maybe False (\v -> abs (v - fine) < fineness pose) exact)
  it "the heights that an upright sensor sees add up to the relief's volume" $
    forAll ((,,) <$> genRasterOf 5 5 <*> choose (-7, 12) <*> choose (-7, 12)) $ \(heights, x, y) ->
      let cell = 1.1
          sensor = idealSensor {sensorFullScale = 1}
          volume = cell * cell * V.sum (rasterValues heights)
          seen =
            taxelPitch
              * taxelPitch
              * V.sum
                ( rasterValues
                    (forwardImage sensor (heightMap cell heights) (SensorPose x y 0))
                )
       in counterexample (show (volume, seen)) (abs (volume - seen) < 1e-9)
  it "a turned sensor sees the turned image" $
    forAll genSize $ \size -> forAll (uncurry genRasterOf size) $ \heights ->
      let relief = heightMap taxelPitch heights
          -- On its side, a sensor of the same elements has as many rows as the relief has columns.
          seen r = forwardImage (sensorOf (lying r)) relief (middle size r)
          lying r = if r `elem` [90, 270] then swap size else size
       in conjoin
            [ closeTo 1e-9 (seen 180) (onRaster (turned 2) heights),
              closeTo 1e-9 (seen (-180)) (onRaster (turned 2) heights),
              closeTo 1e-9 (onRaster (turned 1) (seen 90)) heights,
              closeTo 1e-9 (seen 270) (onRaster (turned 1) heights)
            ]
  it "heights above full scale and below 0 are clipped" $
    forwardImage
      idealSensor
      (heightMap taxelPitch (generate 16 16 (\x _ -> if x < 8 then 99 else -1)))
      (SensorPose 12.7 12.7 0)
      `shouldBe` generate 16 16 (\x _ -> if x < 8 then 1 else 0)
  it "there is nothing to touch off the map" $
    forwardImage idealSensor (heightMap 1 (constant 4 4 1)) (SensorPose (-99) 0 0)
      `shouldBe` constant 16 16 0
  where
    -- The largest difference between the points of the two grids at borders of cells whose heights
    -- differ by up to 1.
    fineness pose = if poseRotation pose `elem` [0, 90, 180, 270] then 0.06 else 0.2
    -- In the middle of a relief of as many taxels.
    middle (w, h) = SensorPose (taxelPitch * fromIntegral w / 2) (taxelPitch * fromIntegral h / 2)
    genNearPose =
      SensorPose
        <$> choose (0, 20)
        <*> choose (0, 20)
        <*> oneof [elements [0, 90, 180, 270], choose (0, 360)]

closeTo :: Double -> Raster -> Raster -> Property
closeTo most a b =
  counterexample (show (toRows a) ++ "\n/=\n" ++ show (toRows b)) $
    either (const False) (maybe True (<= most) . maximumValue) (zipRaster (\p q -> abs (p - q)) a b)

errors :: Spec
errors = do
  it "noise has mean 0 and the stated deviation, within five standard errors" $ do
    let sensor = idealSensor {sensorNoise = 0.05}
        flat = heightMap 1 (constant 60 60 (0.5 * sensorFullScale sensor))
        images = fst (scan sensor flat stay (replicate 100 (SensorPose 30 30 0)) (mkStdGen 5))
        deviations = V.concat [V.map (subtract 0.5) (rasterValues (frameImage f)) | f <- images]
        n = fromIntegral (V.length deviations)
        variance = V.sum (V.map (\d -> d * d) deviations) / n
    abs (V.sum deviations / n) `shouldSatisfy` (< 5 * 0.05 / sqrt n)
    abs (variance - 0.0025) `shouldSatisfy` (< 5 * 0.0025 * sqrt (2 / n))
  it "values with noise are clipped to 0..1" $
    forAll arbitrary $ \seed ->
      let (seen, _) =
            press
              standardSensor {sensorNoise = 2}
              (texture 1 20 20)
              (SensorPose 12 12 0)
              (mkStdGen seed)
       in V.all (\v -> v >= 0 && v <= 1) (rasterValues seen)
  it "position errors have mean 0 and the stated deviation, within five standard errors" $ do
    -- On ramps rising by 1 mm of 100 a millimetre the mean of an image gives the sensor's true
    -- place.
    let sensor = idealSensor {sensorFullScale = 100, sensorPositionError = 1}
        ramp along =
          heightMap
            0.5
            (generate 200 200 (\x y -> (fromIntegral (if along then x else y) + 0.5) * 0.5))
        places along =
          [ 100 * fromMaybe 0 (mean (frameImage f)) - 50
            | f <-
                fst
                  ( scan
                      sensor
                      (ramp along)
                      stay
                      (replicate 400 (SensorPose 50 50 0))
                      (mkStdGen 11)
                  )
          ]
        spread xs = sqrt (sum [x * x | x <- xs] / genericLength xs)
    let found =
          [ abs (sum xs / 400) < 5 * taxelPitch / 20
              && abs (spread xs - taxelPitch) < 5 * taxelPitch / sqrt 800
            | xs <- [places True, places False]
          ]
    found `shouldBe` [True, True]
  it "a frame has the nominal pose, in the robot's coordinates, and the sensor's force" $ do
    let nominal = SensorPose 3 4 180
        (frame, _) = probe standardSensor (texture 2 40 40) (Motion 180 60 60) nominal (mkStdGen 1)
    (framePose frame, frameForce frame) `shouldBe` (nominal, sensorForce standardSensor)
  it "without errors a frame shows the face where the motion puts the nominal pose" $
    forAll ((,,) <$> elements [0, 180] <*> choose (10, 40) <*> choose (10, 40)) $ \(r, x, y) ->
      let motion = Motion r x y
          relief = texture 3 40 40
       in frameImage (fst (probe idealSensor relief motion (SensorPose 5 6 0) (mkStdGen 1)))
            === forwardImage idealSensor relief (move motion (SensorPose 5 6 0))
  it "one seed gives the same frames, and a scan is its presses in turn" $
    property $ \seed ->
      let poses = [SensorPose 15 15 0, SensorPose 20 15 0]
          relief = texture 4 30 30
          one = scan standardSensor relief stay poses (mkStdGen seed)
          (a, g) = probe standardSensor relief stay (SensorPose 15 15 0) (mkStdGen seed)
          (b, _) = probe standardSensor relief stay (SensorPose 20 15 0) g
       in fst one === [a, b]
            .&&. fst one === fst (scan standardSensor relief stay poses (mkStdGen seed))
