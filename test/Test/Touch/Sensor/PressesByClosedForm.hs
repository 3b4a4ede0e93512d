-- | Tests whole presses: by closed forms if nothing is random, and by the deviations otherwise.
-- Also tests a sensor's specimen and its calibration, at their limits too.
module Test.Touch.Sensor.PressesByClosedForm (spec) where

import Data.Foldable (for_)
import Data.List (sort)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Sensor
import PraTactile.Sensor.Calibration
import PraTactile.Sensor.Frame
import PraTactile.Sensor.Press
import PraTactile.Sensor.Response
import System.Random (mkStdGen)
import Test.Effort (byEffort)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Sensor.MeanHeights (texture)

spec :: Spec
spec = do
  describe "Angles" angleSpec
  describe "Full scale" scaleSpec
  describe "Presses" pressSpec
  describe "Specimens" specimenSpec
  describe "Calibration at its limits" calibrationSpec

at :: Raster -> Int -> Int -> Double
at image x y = fromMaybe (0 / 0) (index image x y)

closeTo :: Raster -> Raster -> Property
closeTo a b =
  counterexample (show (toRows a, toRows b)) $
    rasterSize a == rasterSize b
      && V.all (< 1e-9) (V.zipWith (\p q -> abs (p - q)) (rasterValues a) (rasterValues b))

angleSpec :: Spec
angleSpec = do
  it "are kept from 0 up to 360 degrees; infinite ones stay" $
    for_ [0, 90, 359.5, 360, -0.5, 720.25, -1e-20, 1 / 0, -1 / 0] $ \r -> do
      let told = poseRotation (move stay (SensorPose 1 2 r))
          back = motionRotation (inverse (Motion r 0 0))
          both = motionRotation (andThen (Motion r 0 0) stay)
      if isInfinite r
        then [told, both, negate back] `shouldBe` [r, r, r]
        else do
          [told, both, back] `shouldSatisfy` all (\a -> a >= 0 && a < 360)
          let whole a = abs (a - 360 * fromIntegral (round (a / 360) :: Int)) < 1e-9
          map whole [told - r, both - r, back + r] `shouldBe` [True, True, True]
  it "stay NaN" $
    map (isNaN . poseRotation . move stay . SensorPose 0 0) [0 / 0] `shouldBe` [True]

scaleSpec :: Spec
scaleSpec = do
  it "scales the mean of 8 x 8 points of an element's aperture on a turned sensor" $
    forAll ((,) <$> elements [10, 37, 200, -75] <*> elements [0.7, 1.5875, 2]) $ \(turn, cell) ->
      forAll ((,) <$> choose (6, 20) <*> choose (6, 20)) $ \(x, y) ->
        let sensor = idealSensor {sensorColumns = 3, sensorRows = 4}
            heights = generate 14 12 (\u v -> fromIntegral ((u * 5 + v * 3) `mod` 7) / 4 - 0.2)
            point u v =
              let (px, py) = movePoint (Motion turn x y) (u, v)
               in fromMaybe 0 (index heights (floor (px / cell)) (floor (py / cell)))
            element i j =
              sum
                [ point
                    (1.5875 * (fromIntegral i - 1.5 + (a + 0.5) / 8))
                    (1.5875 * (fromIntegral j - 2 + (b + 0.5) / 8))
                  | a <- [0 .. 7],
                    b <- [0 .. 7]
                ]
                / 64
            wanted = generate 3 4 (\i j -> max 0 (min 1 (element i j / sensorFullScale sensor)))
         in closeTo (forwardImage sensor (heightMap cell heights) (SensorPose x y turn)) wanted
  it "scales the tab's share on the face times its height, spread below the tabs" $
    forAll ((,) <$> elements [0, 30, 90] <*> elements [0, 0.7]) $ \(turn, depth) ->
      forAll ((,) <$> choose (6, 20) <*> choose (6, 20)) $ \(x, y) ->
        let sensor =
              idealSensor
                { sensorColumns = 5,
                  sensorRows = 4,
                  sensorTab = 1.2,
                  sensorDepth = depth,
                  sensorExponent = 0.8
                }
            heights = generate 14 12 (\u v -> fromIntegral ((u * 5 + v * 3) `mod` 7) / 2 - 1)
            under =
              tabSupport (sensorTaxelGrid sensor) 1.2 (heightMap 1.5 heights) (SensorPose x y turn)
            share i j =
              at (supportShare under) i j
                * max 0 (min 1 (at (supportHeight under) i j / sensorFullScale sensor))
            felt = spreadForces 1.5875 depth (generate 5 4 share)
            wanted = mapRaster (\v -> max 0 (min 1 (max 0 v ** 0.8))) felt
         in closeTo (forwardImage sensor (heightMap 1.5 heights) (SensorPose x y turn)) wanted
  it "is never exceeded, however the reading comes about" $ do
    let steep = heightMap taxelPitch (constant 16 16 50)
        here = SensorPose (8 * taxelPitch) (8 * taxelPitch) 0
        stiff =
          idealSensor
            { sensorStiffness = 0.19,
              sensorForce = 500,
              sensorFullForce = 1,
              sensorExponent = 1
            }
        tabbed = idealSensor {sensorTab = 1.2, sensorFullScale = 1}
    for_ [(stiff, 1), (tabbed, 1), (idealSensor, 1), (stiff {sensorFullForce = 1000}, 0.002)] $
      \(sensor, wanted) ->
        V.all (\v -> abs (v - wanted) < 1e-3) (rasterValues (forwardImage sensor steep here))
          `shouldBe` True

pressSpec :: Spec
pressSpec = do
  it "of a tilted sensor without force on a flat face read a plane through its centre, or 0" $
    forAll (choose (0, 10000)) $ \seed -> forAll (elements [0, 1.1]) $ \tab ->
      let sensor = idealSensor {sensorTiltSpread = 0.3, sensorTab = tab}
          flat = heightMap 1 (constant 100 100 0)
          (image, _) = press sensor flat (SensorPose 50 50 0) (mkStdGen seed)
          value = at image
          touched =
            [ (x, y)
              | x <- [1 .. 14],
                y <- [1 .. 14],
                all inside [(x - 1, y), (x, y), (x + 1, y), (x, y - 1), (x, y + 1)]
            ]
          inside (x, y) = value x y > 0 && value x y < 1
       in conjoin
            [ property (V.any (> 0) (rasterValues image)),
              property
                ( and
                    [ value x y * value (15 - x) (15 - y) == 0
                      | x <- [0 .. 15],
                        y <- [0 .. 15]
                    ]
                ),
              property
                ( and
                    [ abs (value (x - 1) y + value (x + 1) y - 2 * value x y) < 1e-9
                        && abs (value x (y - 1) + value x (y + 1) - 2 * value x y) < 1e-9
                      | (x, y) <- touched
                    ]
                )
            ]
  it "apply forces, hysteresis, gains, drift, crosstalk, dead elements and code in this order" $
    forAll ((,,) <$> choose (0, 0.4) <*> elements [1, 0.7] <*> choose (0, 0.1)) $
      \(hysteresis, k, drift) ->
        forAll ((,) <$> choose (0, 0.02) <*> elements [0, 4, 8]) $ \(share, bits) ->
          forAll (listOf1 (elements [SensorPose 50 50 0, SensorPose 999 50 0])) $ \poses ->
            let sensor =
                  idealSensor
                    { sensorColumns = 5,
                      sensorRows = 4,
                      sensorHysteresis = hysteresis,
                      sensorExponent = k,
                      sensorDrift = drift,
                      sensorCrosstalk = share,
                      sensorBits = bits,
                      sensorZeroed = 2
                    }
                -- Half of full scale everywhere, or nothing.
                plateau = heightMap 10 (constant 10 10 (sensorFullScale sensor / 2))
                gain x y = if (x, y) == (3, 1) then 0 else 1 + fromIntegral (x - y) / 10 :: Double
                specimen = Specimen (generate 5 4 gain)
                forces = drop 1 (scanl withLeft 0 [if poseX p < 100 then 0.5 else 0 | p <- poses])
                withLeft old now = now + hysteresis * old
                readings n force = generate 5 4 $ \x y ->
                  let own u v = (force ** k) * (1 + drift * logBase 10 n) * gain u v
                      ofRow = sum [own u y | u <- [0 .. 4]] / 5
                      ofColumn = sum [own x v | v <- [0 .. 3]] / 4
                      mixed = (1 - 2 * share) * own x y + share * (ofRow + ofColumn)
                   in if gain x y > 0 then converted bits 2 mixed else 0
                frames = fst (scanWith sensor specimen plateau stay poses (mkStdGen 1))
                agrees n force frame = closeTo (readings n force) (frameImage frame)
             in conjoin (zipWith3 agrees [1 ..] forces frames)
                  .&&. map framePose frames === poses
  it "by themselves equal the first of a flawless specimen" $
    forAll ((,) <$> choose (-3, 3) <*> elements [0, 90, 15]) $ \(x, r) ->
      let sensor = idealSensor {sensorHysteresis = 0.3, sensorDrift = 0.1, sensorCrosstalk = 0.02}
          relief = texture 5 40 40
          pose = SensorPose (20 + x) 30 r
          alone = fst (press sensor relief pose (mkStdGen 3))
       in map frameImage (fst (scanWith sensor (flawless sensor) relief stay [pose] (mkStdGen 4)))
            === [alone]
  it "of a rigid sensor without noise are the conductance of the spread tab displacements" $
    forAll ((,) <$> choose (-3, 3) <*> elements [0, 90, 20]) $ \(x, r) ->
      let relief = texture 5 40 40
          pose = SensorPose (30 + x) 28 r
          under = tabSupport (sensorTaxelGrid rigid) 1.2 relief pose
          felt = mapRaster (0.19 *) (displacements 0.19 12 (0, 0) under)
          wanted =
            mapRaster (max 0 . min 1 . conductance 0.8 0.01 0.9) (spreadForces taxelPitch 0.7 felt)
       in closeTo (forwardImage rigid relief pose) wanted
            .&&. closeTo (fst (press rigid relief pose (mkStdGen 1))) wanted
  it "bear at least a twentieth of the force, and tilt equally across and down" $ do
    let many = byEffort 100 400 :: Int
        count = fromIntegral many
        even' = heightMap 5 (constant 20 20 0)
        linear = idealSensor {sensorTab = 1.1, sensorStiffness = 0.19, sensorFullForce = 10}
        images sensor =
          map
            frameImage
            (fst (scan sensor even' stay (replicate many (SensorPose 50 50 0)) (mkStdGen 2)))
        forces = [10 * V.sum (rasterValues i) | i <- images linear {sensorForceSpread = 1}]
        tilted = images linear {sensorTiltSpread = 0.02}
        -- The distance of the outer elements' centres from the middle is 15 / 16 of half the
        -- sensor.
        tilts (x, y) = [(at i x y - at i (15 - x) (15 - y)) / 0.019 / 2 * 16 / 15 | i <- tilted]
        deviation values = sqrt (sum (map (^ (2 :: Int)) values) / count)
        (right', down) = (tilts (15, 8), tilts (8, 15))
        -- Opposite elements lie a row or a column beside the middle.
        own = 0.02 * 1.5875
    minimum forces `shouldSatisfy` (\least -> abs (least - 0.5) < 1e-9)
    -- 17 % of the draws are below that: within five standard errors.
    fromIntegral (length (filter (< 0.5000001) forces)) / count
      `shouldSatisfy` (\part -> part > 0 && abs (part - 0.171) < 5 * sqrt (0.171 * 0.829 / count))
    [deviation right', deviation down]
      `shouldSatisfy` all (\sd -> abs (sd - own) < 5 * own / sqrt (2 * count) + own / 200)
    -- The two are drawn independently.
    abs (sum (zipWith (*) right' down) / count)
      `shouldSatisfy` (< 5 * own * own / sqrt count + own * own / 7)
  it "have noise of which rows and columns share their parts, the last ones too" $ do
    let sensor =
          idealSensor
            { sensorColumns = 12,
              sensorRows = 5,
              sensorNoise = 0.04,
              sensorRowNoise = 0.4,
              sensorColumnNoise = 0.2
            }
        noises =
          [ mapRaster (subtract 0.5) (frameImage f)
            | f <- flatFrames sensor (flawless sensor) 3000 (mkStdGen 6)
          ]
        together (x, y) (u, v) = sum [at i x y * at i u v | i <- noises] / (3000 * 0.04 * 0.04)
        -- The standard error of a mean of products of normal values.
        close wanted found = abs (found - wanted) < 5 * sqrt ((1 + wanted * wanted) / 3000)
    [together p p | p <- [(0, 0), (11, 4), (11, 0)]] `shouldSatisfy` all (close 1)
    [together (0, y) (11, y) | y <- [0, 4]] `shouldSatisfy` all (close 0.4)
    [together (x, 0) (x, 4) | x <- [0, 11]] `shouldSatisfy` all (close 0.2)
    [together (0, 0) (11, 4), together (0, 4) (11, 0)] `shouldSatisfy` all (close 0)
  where
    rigid =
      idealSensor
        { sensorStiffness = 0.19,
          sensorTab = 1.2,
          sensorForce = 12,
          sensorFullForce = 0.9,
          sensorBreakForce = 0.01,
          sensorExponent = 0.8,
          sensorDepth = 0.7
        }

specimenSpec :: Spec
specimenSpec = do
  it "have no negative gains; all elements are dead for the share 1, and none for 0" $ do
    let gains spread dead =
          V.toList . rasterValues . specimenGains . fst $
            drawSpecimen
              idealSensor {sensorGainSpread = spread, sensorDead = dead}
              (mkStdGen 8)
    minimum (gains 1.5 0) `shouldBe` 0
    length (filter (== 0) (gains 1.5 0)) `shouldSatisfy` (< 128)
    gains 0.1 1 `shouldBe` replicate 256 0
    filter (== 0) (gains 0.1 0) `shouldBe` []
  it "read 0 or half of full scale in calibration frames, each as at the first press" $ do
    let sensor =
          idealSensor {sensorColumns = 5, sensorRows = 3, sensorDrift = 0.3, sensorHysteresis = 0.4}
        gains = generate 5 3 (\x y -> fromIntegral ((x + 2 * y) `mod` 3))
        told s frames = map frameImage (frames s (Specimen gains) 3 (mkStdGen 7))
        halves = mapRaster (min 1 . (0.5 *)) gains
        noisy' = told sensor {sensorNoise = 0.01} flatFrames
    told sensor darkFrames `shouldBe` replicate 3 (constant 5 3 0)
    told sensor flatFrames `shouldBe` replicate 3 halves
    [i | (i, j) <- zip noisy' (drop 1 noisy'), i == j] `shouldBe` []

calibrationSpec :: Spec
calibrationSpec = do
  it "is as defined, also for elements at the limits of being dead" $
    forAll (choose (2, 6)) $ \w ->
      forAll (vectorOf (2 * w) ((,) <$> elements darks <*> elements rises)) $ \drawn' ->
        let part f = generate w 2 (\x y -> f (drawn' !! (y * w + x)))
            (dark, flat) = (part fst, part (uncurry (+)))
            places = [(y, x) | y <- [0, 1], x <- [0 .. w - 1]]
            rise (y, x) = at flat x y - at dark x y
            telling = [rise (y, x) | (y, x) <- places, at flat x y < 0.995]
            middle = sort telling !! (length telling `div` 2)
            dead p@(y, x) = 4 * rise p < middle || at dark x y > 0.5 || at flat x y >= 0.995
            wanted
              | null telling = Left AllSaturated
              | middle < 0.02 = Left AllDead
              | otherwise =
                Right
                  ( Calibration
                      dark
                      (generate w 2 (\x y -> if dead (y, x) then 1 else rise (y, x) / middle))
                      (filter dead places)
                  )
         in calibrate [dark, dark] [flat] === wanted
  it "of several frames is that of their means" $ do
    let darks' = [constant 3 2 0.25, constant 3 2 0.125, constant 3 2 0]
        flats = [constant 3 2 0.5, constant 3 2 0.75]
    calibrate darks' flats `shouldBe` Right (Calibration (constant 3 2 0.125) (constant 3 2 1) [])
  it "corrects to 0..1: less the offset, divided by the gain" $ do
    let row values = generate 4 1 (\x _ -> values !! x)
        calibration = Calibration (constant 4 1 0.25) (row [1, 2, 0.5, 1]) []
    correctedImage calibration (row [0.125, 0.75, 1, 0.5])
      `shouldBe` Right (row [0, 0.25, 1, 0.25])
  it "gives a dead element the mean of the nearest ring with living ones, or 0 without any" $
    forAll ((,) <$> choose (1, 9) <*> choose (1, 9)) $ \(w, h) ->
      forAll (shuffle [(y, x) | y <- [0 .. h - 1], x <- [0 .. w - 1]]) $ \places ->
        forAll (flip splitAt places <$> oneof [choose (0, 3), choose (0, w * h)]) $
          \(living, dead) ->
            let image = generate w h (\x y -> fromIntegral ((3 * x + 5 * y) `mod` 8) / 8)
                wanted x y
                  | null living = 0
                  | otherwise =
                    let far (v, u) = max (abs (u - x)) (abs (v - y))
                        least = minimum (map far living)
                        ring = [at image u v | p@(v, u) <- living, far p == least]
                     in sum ring / fromIntegral (length ring)
             in case correctedImage (plain w h dead) image of
                  Right found -> closeTo found (generate w h wanted)
                  Left e -> counterexample (show e) False
  it "finds elements stuck that are above the middle in six frames or more, 8 elements apart" $
    forAll ((,) <$> choose (5, 7) <*> elements [7.9, 8, 8.1]) $ \(count, far) ->
      forAll ((,) <$> choose (0, 6) <*> elements [0.5, 0.501]) $ \(stuck, level) ->
        forAll arbitrary $ \upwards ->
          let lit = take stuck [(y, x) | y <- [0 .. 3], x <- [0 .. 3]]
              -- The others read from 0.125 to 0.875.
              shown k y x
                | (y, x) `elem` lit = level
                | otherwise = if even k then 0.125 else 0.875
              place k
                | upwards = SensorPose 0 (if k == 1 then far * taxelPitch else 0) 0
                | otherwise = SensorPose (if k == 1 then far * taxelPitch else 0) 0 0
              frames =
                [ Frame (place k) 0 (generate 4 4 (flip (shown k))) taxelPitch []
                  | k <- [1 .. count :: Int]
                ]
              applies = count >= 6 && far >= 8 && level > 0.5 && stuck >= 1 && stuck <= 4
              wanted =
                if applies
                  then either (const []) id (traverse (corrected (none lit)) frames)
                  else frames
           in classify applies "stuck" (withoutStuck frames === wanted)
  it "changes nothing without stuck elements, not even readings above full scale" $ do
    let frame k = Frame (SensorPose (20 * k) 0 0) 0 (generate 4 4 (felt k)) taxelPitch [(1, 1)]
        felt k x y = if fromIntegral (x + y) == k then 1.5 else 0.25 :: Double
        frames = map frame [0 .. 6]
    withoutStuck frames `shouldBe` frames
  where
    darks = [0, 0, 0.125, 0.5, 0.5625]
    rises = [0, 0.0625, 0.125, 0.25, 0.25, 0.5, 0.875]
    plain w h = Calibration (constant w h 0) (constant w h 1)
    none = plain 4 4
