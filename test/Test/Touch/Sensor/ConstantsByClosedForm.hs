-- | Tests each constant of the forward model by itself against its closed form.
module Test.Touch.Sensor.ConstantsByClosedForm (spec) where

import Data.List (genericLength, nub)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Sensor
import PraTactile.Sensor.Constants
import PraTactile.Sensor.Frame
import PraTactile.Sensor.Press
import PraTactile.Sensor.Response
import System.Random (mkStdGen)
import Test.Effort (withCases)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (generate, sample)

spec :: Spec
spec = do
  describe "Tabs" tabs
  describe "The rigid press" rigid
  describe "The point spread" spreading
  describe "Readings" readings
  describe "Errors of one press" oneByOne
  describe "Presets and names" presets

at :: Raster -> Int -> Int -> Double
at image x y = fromMaybe (0 / 0) (index image x y)

near :: Double -> Double -> Double -> Property
near most a b = counterexample (show (a, b)) (abs (a - b) <= most)

-- | A sensor without errors whose readings are proportional to the force on an element.
linear :: Sensor
linear = idealSensor {sensorTab = 1.1, sensorStiffness = 0.19, sensorFullForce = 10}

tabs :: Spec
tabs = do
  it "a round tab has the twelve points of a 4 x 4 grid in its circle, a square one all" $ do
    let points = tabPoints 1.5875 1.1
        square = tabPoints 1.5875 0
    (length points, length square) `shouldBe` (12, 16)
    filter (\(x, y) -> x * x + y * y > 0.55 * 0.55) points `shouldBe` []
    abs (sum (map fst points)) + abs (sum (map snd points)) `shouldSatisfy` (< 1e-12)
    maximum (map fst square) - 1.5875 * 0.375 `shouldSatisfy` ((< 1e-12) . abs)
  it "a tab on the face's edge has half its share there, and one beyond has none" $ do
    let face = heightMap 0.1 (constant 100 100 0.7)
        under x = tabSupport (TaxelGrid 1 1 1.5875) 1.1 face (SensorPose x 5 0)
        seen x = (at (supportShare (under x)) 0 0, at (supportHeight (under x)) 0 0)
        gap (a, b) (c, d) = max (abs (a - c)) (abs (b - d))
    maximum (zipWith gap (map seen [5, 0, -5]) [(1, 0.7), (0.5, 0.7), (0, 0)])
      `shouldSatisfy` (< 1e-12)
  prop "turned tabs meet the face at the turned places" $ \seed ->
    forAll (choose (0, 360)) $ \r ->
      let (i, j) = (seed `mod` 16, (seed `div` 16) `mod` 16 :: Int)
          under = tabSupport standardTaxelGrid 1.1 ramp (SensorPose 20 20 r)
          place k = taxelPitch * (fromIntegral k - 7.5)
          (x, y) = movePoint (Motion r 20 20) (place i, place j)
       in near 0.08 (at (supportHeight under) i j) (0.2 * x + 0.4 * y)
  where
    ramp =
      heightMap 0.1 (generate 400 400 (\u v -> 0.02 * fromIntegral u + 0.04 * fromIntegral v))

rigid :: Spec
rigid = do
  it "10 N on 38 tabs of 0.19 N/mm press 1.4 mm" $
    forceBalance 0.19 10 (replicate 38 (1, 0))
      `shouldSatisfy` maybe False ((< 0.02) . abs . subtract 1.4)
  it "there is no balance without anything under the tabs" $
    (forceBalance 0.19 10 [], forceBalance 0.19 10 [(0, 1)]) `shouldBe` (Nothing, Nothing)
  prop "the tabs bear the force: the sum of k s max 0 (z + h) is F" $
    forAll ((,) <$> choose (0.01, 5) <*> choose (0.1, 50)) $ \(k, force) ->
      forAll (listOf1 ((,) <$> choose (0.1, 1) <*> choose (-3, 3))) $ \under ->
        case forceBalance k force under of
          Nothing -> property False
          Just z -> near (1e-9 * force) (sum [k * s * max 0 (z + h) | (s, h) <- under]) force
  prop "on a plane under all tabs, the displacements are F / (k n) plus the tilts" $
    forAll ((,) <$> choose (-0.1, 0.1) <*> choose (-0.1, 0.1)) $ \(a, b) ->
      forAll ((,) <$> choose (1, 16) <*> choose (1, 16)) $ \(w, h) ->
        let plane = TabSupport (constant w h 1) (constant w h 0.3)
            across n k = (2 * fromIntegral k + 1 - fromIntegral n) / fromIntegral n
            expected i j =
              20 / (0.19 * fromIntegral (w * h)) + a * across w i + b * across h j
         in conjoin
              [ near 1e-9 (at (displacements 0.19 20 (a, b) plane) i j) (expected i j)
                | i <- [0, w - 1],
                  j <- [0, h - 1]
              ]
  prop "the elements' readings add up to the force" $
    forAll ((,,) <$> choose (1, 40) <*> choose (15, 30) <*> choose (15, 30)) $ \(force, x, y) ->
      let relief = heightMap 3 (generate 20 20 (\u v -> if even (u + v) then 1.5875 else 0))
          sensor = linear {sensorForce = force, sensorFullForce = 100}
          seen = forwardImage sensor relief (SensorPose x y 30)
       in near 1e-6 (100 * V.sum (rasterValues seen)) force
  it "nothing is felt beyond the face's edge, unlike on an endless plane" $ do
    let plane = heightMap 1 (constant 50 50 0)
        seen = forwardImage linear plane (SensorPose 0 25 0)
    [at seen x 8 > 0 | x <- [0, 7, 8, 15]] `shouldBe` [False, False, True, True]

spreading :: Spec
spreading = do
  prop "a point's force is felt as t^3 (r^2 + t^2)^(-5/2)" $
    forAll ((,,) <$> choose (1, 2) <*> choose (-3, 3) <*> choose (-3, 3)) $ \(t, i, j) ->
      let point = generate 31 31 (\x y -> if (x, y) == (15, 15) then 1 else 0)
          felt = spreadForces 1.5875 t point
          boussinesq far = t ** 3 * (far + t * t) ** (-2.5)
          r2 = 1.5875 * 1.5875 * fromIntegral (i * i + j * j :: Int)
       in near 1e-12 (at felt (15 + i) (15 + j) / at felt 15 15) (boussinesq r2 / boussinesq 0)
  withCases 30 100
    . prop "a point's force adds up to itself, and an even load stays even"
    $ forAll (choose (1, 2)) $ \t ->
      let point = generate 41 41 (\x y -> if (x, y) == (20, 20) then 3 else 0)
       in near 1e-9 (V.sum (rasterValues (spreadForces 1.5875 t point))) 3
            .&&. near 1e-9 (at (spreadForces 1.5875 t (constant 41 41 0.2)) 20 20) 0.2
  prop "an element feels the sum of all forces that reach it, at the edges too" $
    forAll ((,,,) <$> choose (1, 9) <*> choose (1, 9) <*> choose (0.1, 3) <*> arbitrary) $
      \(w, h, t, seed) ->
        let forces = generate w h (\x y -> fromIntegral ((x * 7 + y * 13 + seed * 3) `mod` 11))
            reach = min (max w h) (floor (6.2 * t / 1.5875)) :: Int
            share i j =
              (1 + 1.5875 * 1.5875 * fromIntegral (i * i + j * j) / (t * t)) ** (-2.5) :: Double
            all' = sum [share i j | i <- [-reach .. reach], j <- [-reach .. reach]]
            felt x y =
              sum
                [ at forces u v * share (u - x) (v - y) / all'
                  | u <- [0 .. w - 1],
                    v <- [0 .. h - 1],
                    abs (u - x) <= reach,
                    abs (v - y) <= reach
                ]
            spread = spreadForces 1.5875 t forces
         in conjoin
              [ near 1e-9 (at spread x y) (felt x y)
                | x <- [0 .. w - 1],
                  y <- [0 .. h - 1]
              ]
  it "nothing is spread at depth 0" $
    spreadForces 1.5875 0 (constant 3 3 0.5) `shouldBe` constant 3 3 0.5

readings :: Spec
readings = do
  prop "conductance: twice the force gives 2^k, full scale 1, less than the break force 0" $
    forAll ((,) <$> choose (0.8, 1) <*> choose (0.02, 0.4)) $ \(k, f) ->
      near 1e-12 (conductance k 0.01 0.93 (2 * f)) (2 ** k * conductance k 0.01 0.93 f)
        .&&. near 1e-12 (conductance k 0.01 0.93 0.93) 1
        .&&. conductance k (1.01 * f) 0.93 f === 0
  prop "conductance: the share of full scale to the power, any power" $
    forAll ((,) <$> elements [0, 0.5, 0.8, 1, 2] <*> choose (0.02, 2)) $ \(k, f) ->
      near 1e-12 (conductance k 0.01 0.93 f) ((f / 0.93) ** k)
  prop "noise grows with the reading from 0 to full scale, and no further" $
    forAll ((,,) <$> choose (0, 0.1) <*> choose (0, 0.1) <*> choose (-1, 3)) $ \(least, slope, v) ->
      near
        1e-12
        (noiseDeviation linear {sensorNoise = least, sensorNoiseSlope = slope} v)
        (if v < 0 then least else if v > 1 then least + slope else least + slope * v)
  prop "crosstalk of one: s / w to its row, s / h to its column, 1 - 2 s and both to itself" $
    forAll ((,,) <$> choose (0.005, 0.02) <*> choose (1, 9) <*> choose (1, 9)) $ \(s, w, h) ->
      forAll ((,) <$> choose (0, w - 1) <*> choose (0, h - 1)) $ \place@(i, j) ->
        let seen = crosstalk s (generate w h (\x y -> if (x, y) == place then 1 else 0))
            share n = s / fromIntegral n
            wanted x y =
              (if (x, y) == place then 1 - 2 * s else 0)
                + (if y == j then share w else 0)
                + (if x == i then share h else 0)
         in conjoin
              [ near 1e-12 (at seen x y) (wanted x y)
                | x <- [0 .. w - 1],
                  y <- [0 .. h - 1]
              ]
  prop "the converter: the nearest code of 2^bits - 1, the lowest ones 0, no bits no change" $
    forAll ((,,) <$> choose (1, 12) <*> choose (0, 4) <*> choose (0, 1)) $ \(bits, zeroed, v) ->
      let top = 2 ^ bits - 1 :: Double
          code = converted bits zeroed v * top
       in counterexample (show code) $
            abs (code - fromIntegral (round code :: Int)) < 1e-9
              && ( if round (v * top) < zeroed
                     then code == 0
                     else abs (code - v * top) <= 0.5 + 1e-9
                 )
              && converted 0 zeroed v == v
  prop "drift: after ten times the time the reading is larger by the stated share" $
    forAll ((,) <$> choose (0, 0.05) <*> choose (1, 100)) $ \(d, n) ->
      near 1e-12 (drifted d (10 * n) 0.4 - drifted d n 0.4) (0.4 * d)
  prop "noise: its deviation rises linearly; rows and columns share parts of the variance" $
    forAll ((,) <$> choose (0, 0.5) <*> choose (0, 0.5)) $ \(r, c) ->
      let sensor =
            idealSensor
              { sensorNoise = 0.01,
                sensorNoiseSlope = 0.2,
                sensorRowNoise = r,
                sensorColumnNoise = c
              }
          image = generate 4 3 (\x _ -> 0.25 * fromIntegral x)
          one n = V.replicate n 1
          none n = V.replicate n 0
          moved own rows columns x y =
            at (noisy sensor (Deviates own rows columns) image) x y - at image x y
          sd x = 0.01 + 0.2 * 0.25 * x
       in conjoin
            [ near 1e-12 (moved (one 12) (none 3) (none 4) 2 1) (sqrt (1 - r - c) * sd 2),
              near 1e-12 (moved (none 12) (one 3) (none 4) 3 0) (sqrt r * sd 3),
              near 1e-12 (moved (none 12) (none 3) (one 4) 0 2) (sqrt c * sd 0)
            ]
  it "gains: mean 1 and the stated deviation; the stated share is dead, and reads 0" $ do
    let sensor =
          idealSensor
            { sensorColumns = 200,
              sensorRows = 200,
              sensorGainSpread = 0.06,
              sensorDead = 0.01
            }
        (specimen, _) = drawSpecimen sensor (mkStdGen 3)
        gains = V.toList (rasterValues (specimenGains specimen))
        living = filter (> 0) gains
        n = genericLength living :: Double
        average = sum living / n
        variance = sum [(g - average) * (g - average) | g <- living] / n
        dead = 40000 - n
    abs (average - 1) `shouldSatisfy` (< 5 * 0.06 / sqrt n)
    abs (sqrt variance - 0.06) `shouldSatisfy` (< 5 * 0.06 / sqrt (2 * n))
    abs (dead - 400) `shouldSatisfy` (< 5 * sqrt (400 * 0.99))
    case flatFrames sensor specimen 1 (mkStdGen 1) of
      [frame] ->
        rasterValues (frameImage frame)
          `shouldBe` V.map (min 1 . (0.5 *)) (rasterValues (specimenGains specimen))
      _ -> expectationFailure "not one frame"

-- | The images of presses in turn.
scanned :: Sensor -> HeightMap -> [SensorPose] -> [Raster]
scanned sensor relief poses = map frameImage (fst (scan sensor relief stay poses (mkStdGen 2)))

oneByOne :: Spec
oneByOne = do
  it "the specimen of the paper's sensor, which does not vary, is flawless" $
    fst (drawSpecimen standardSensor (mkStdGen 4)) `shouldBe` flawless standardSensor
  it "hysteresis: a press on nothing reads the share of the press before" $ do
    let sensor = idealSensor {sensorHysteresis = 0.1}
        face = heightMap taxelPitch (constant 16 16 (0.6 * sensorFullScale sensor))
        here = SensorPose (8 * taxelPitch) (8 * taxelPitch) 0
        images = scanned sensor face [here, SensorPose 500 500 0, here]
    [at image 7 7 | image <- images] `shouldSatisfy` \seen -> case seen of
      [a, b, c] -> maximum [abs (a - 0.6), abs (b - 0.06), abs (c - 0.606)] < 1e-9
      _ -> False
  it "force: readings vary with it by the stated deviation, within five standard errors" $ do
    let sensor = linear {sensorForceSpread = 0.15}
        plane = heightMap 5 (constant 20 20 0)
        images = scanned sensor plane (replicate 400 (SensorPose 50 50 0))
        forces = [10 * V.sum (rasterValues image) | image <- images]
        average = sum forces / 400
        deviation = sqrt (sum [(f - average) * (f - average) | f <- forces] / 400)
    abs (average - 10) `shouldSatisfy` (< 5 * 1.5 / 20)
    abs (deviation - 1.5) `shouldSatisfy` (< 5 * 1.5 / sqrt 800)
  it "tilt: the edges differ by the stated deviation, within five standard errors" $ do
    let sensor = linear {sensorTiltSpread = 0.02}
        plane = heightMap 5 (constant 20 20 0)
        images = scanned sensor plane (replicate 400 (SensorPose 50 50 0))
        -- The distance of the outer columns' centres from the middle is 15 / 16 of half the sensor.
        tilts = [(at image 15 8 - at image 0 8) * 10 / 0.19 / 2 * 16 / 15 | image <- images]
        deviation = sqrt (sum (map (^ (2 :: Int)) tilts) / 400)
    abs (deviation - 0.02 * 1.5875) `shouldSatisfy` (< 5 * 0.02 * 1.5875 / sqrt 800)
  it "rotation error: the angle has the stated deviation, within five standard errors" $ do
    let sensor = idealSensor {sensorRotationError = 3, sensorFullScale = 100}
        ramp = heightMap 0.5 (generate 200 200 (\x _ -> (fromIntegral x + 0.5) * 0.5))
        images = scanned sensor ramp (replicate 200 (SensorPose 50 50 0))
        angle image =
          atan2
            (sum [at image x 0 - at image x 15 | x <- [0 .. 15]])
            (sum [at image 15 y - at image 0 y | y <- [0 .. 15]])
            * 180
            / pi
        deviation = sqrt (sum [angle image ** 2 | image <- images] / 200)
    abs (deviation - 3) `shouldSatisfy` (< 5 * 3 / sqrt 400)
  it "one seed gives the same frames of every preset" $
    [ scanned sensor relief poses == scanned sensor relief poses
      | preset <- [minBound ..],
        let sensor = presetSensor preset
    ]
      `shouldBe` replicate 4 True
  where
    relief = heightMap 2 (generate 30 30 (\x y -> if (x + 2 * y) `mod` 5 == 0 then 1.5875 else 0))
    poses = [SensorPose 20 20 0, SensorPose 25 20 0, SensorPose 30 20 0]

presets :: Spec
presets = do
  it "the standard sensor is the paper's, and its constants have distinct names" $ do
    presetSensor Paper `shouldBe` standardSensor
    length (nub (map constantName constants)) `shouldBe` length constants
  it "the model has a constant for each of its statements" $
    map constantName constants
      `shouldBe` words
        "columns rows taxel_pitch tab_diameter position_error rotation_error force force_spread \
        \tilt_spread full_scale_height tab_stiffness overlay_depth hysteresis conductance_exponent \
        \break_force full_scale_force gain_spread drift crosstalk dead_taxels adc_bits adc_zeroed \
        \noise noise_slope noise_row noise_column"
  it "every constant has a unit and a source, or is called an assumption" $
    [constantName c | c <- constants, null (constantUnit c) || length (constantSource c) < 8]
      `shouldBe` []
  it "each constant has the name of its field" $ do
    let numbered =
          Sensor
            { sensorColumns = 1,
              sensorRows = 2,
              sensorTaxel = 3,
              sensorTab = 4,
              sensorPositionError = 5,
              sensorRotationError = 6,
              sensorForce = 7,
              sensorForceSpread = 8,
              sensorTiltSpread = 9,
              sensorFullScale = 10,
              sensorStiffness = 11,
              sensorDepth = 12,
              sensorHysteresis = 13,
              sensorExponent = 14,
              sensorBreakForce = 15,
              sensorFullForce = 16,
              sensorGainSpread = 17,
              sensorDrift = 18,
              sensorCrosstalk = 19,
              sensorDead = 20,
              sensorBits = 21,
              sensorZeroed = 22,
              sensorNoise = 23,
              sensorNoiseSlope = 24,
              sensorRowNoise = 25,
              sensorColumnNoise = 26
            }
    map snd (constantsOf numbered) `shouldBe` [1 .. 26]
  it "replacing a constant by its own value leaves the sensor unchanged" $
    [ (presetName preset, constantName c)
      | preset <- [minBound ..],
        let sensor = presetSensor preset,
        (c, value) <- constantsOf sensor,
        either (const Nothing) Just (replaced (constantName c) value sensor) /= Just sensor
    ]
      `shouldBe` []
  it "replacing a constant sets its new value, and changes no other" $
    [ (constantName c, constantName d)
      | c <- constants,
        let (least, most) = constantRange c,
        value <- [least, fromIntegral (ceiling (min most (least + 7)) :: Int)],
        Right changed <- [replaced (constantName c) value (presetSensor Real)],
        ((d, now), (_, old)) <-
          zip (constantsOf changed) (constantsOf (presetSensor Real)),
        now /= if constantName c == constantName d then value else old
    ]
      `shouldBe` []
  it "a share goes from 0 to 1, and one of two sides or shared by two to 0.5" $ do
    let taken name value = either (const False) (const True) (replaced name value standardSensor)
        limits most name =
          (name, map (taken name) [-0.000001, 0, most, most + 0.000001])
    map (limits 1) ["hysteresis", "gain_spread", "drift", "dead_taxels"]
      ++ map (limits 0.5) ["crosstalk", "noise_row", "noise_column"]
      `shouldSatisfy` all ((== [False, True, True, False]) . snd)
  it "the ranges are promises: a value that was accepted once must stay accepted" $
    [(constantName c, constantRange c, constantWhole c) | c <- constants]
      `shouldBe` [ ("columns", (4, 256), True),
                   ("rows", (4, 256), True),
                   ("taxel_pitch", (0.05, 50), False),
                   ("tab_diameter", (0, 50), False),
                   ("position_error", (0, 1000), False),
                   ("rotation_error", (0, 180), False),
                   ("force", (0.001, 100000), False),
                   ("force_spread", (0, 1), False),
                   ("tilt_spread", (0, 100), False),
                   ("full_scale_height", (0.0001, 1000), False),
                   ("tab_stiffness", (0, 100000), False),
                   ("overlay_depth", (0, 50), False),
                   ("hysteresis", (0, 1), False),
                   ("conductance_exponent", (0.1, 4), False),
                   ("break_force", (0, 100000), False),
                   ("full_scale_force", (0.000001, 100000), False),
                   ("gain_spread", (0, 1), False),
                   ("drift", (0, 1), False),
                   ("crosstalk", (0, 0.5), False),
                   ("dead_taxels", (0, 1), False),
                   ("adc_bits", (0, 16), True),
                   ("adc_zeroed", (0, 65535), True),
                   ("noise", (0, 1000), False),
                   ("noise_slope", (0, 1000), False),
                   ("noise_row", (0, 0.5), False),
                   ("noise_column", (0, 0.5), False)
                 ]
  it "a value out of range, or of an unknown constant, is refused" $ do
    let refused = either (maybe "unknown" constantName) (const "taken")
    map
      refused
      [ replaced "columns" 3 standardSensor,
        replaced "columns" 16.5 standardSensor,
        replaced "noise" (0 / 0) standardSensor,
        replaced "colour" 1 standardSensor,
        replaced "noise" 0 standardSensor
      ]
      `shouldBe` ["columns", "columns", "noise", "unknown", "taken"]
  it "at half the pitch tabs are half as wide, and constants of their area a quarter" $ do
    let halved = withTaxel (taxelPitch / 2) (presetSensor Real)
        parts f = f halved / f (presetSensor Real)
    map parts [sensorTaxel, sensorTab, sensorStiffness, sensorBreakForce, sensorFullForce]
      `shouldBe` [0.5, 0.5, 0.25, 0.25, 0.25]
  it "the forces of a whole FSR 400 scaled to the tab are 0.0093 N and 0.93 N" $
    [sensorBreakForce (presetSensor Real), sensorFullForce (presetSensor Real)]
      `shouldSatisfy` \found -> case found of
        [a, b] -> abs (a - 0.0093) < 0.00005 && abs (b - 0.93) < 0.005
        _ -> False
