-- | A press from the draws to the image, a sensor's specimen and its calibration, each stated once
-- more as a whole from what its constants mean, and asked at the limits.
module Test.Touch.SensorSteps (spec) where

import Data.Foldable (for_)
import Data.List (sort, unfoldr)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Random (normal, normalPair, normals, uniform)
import PraTactile.Sensor
import PraTactile.Sensor.Calibration
import PraTactile.Sensor.Frame
import PraTactile.Sensor.Press
import PraTactile.Sensor.Response
import System.Random (StdGen, mkStdGen)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Sensor (texture)

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

-- | The next draw of a generator, which tells where it stands.
next :: StdGen -> Double
next = fst . uniform

angleSpec :: Spec
angleSpec = do
  it "are kept from 0 up to 360 degrees; what is not finite stays" $
    for_ [0, 90, 359.5, 360, -0.5, 720.25, -1e-20, 1 / 0, -1 / 0] $ \r -> do
      let told = poseRotation (move stay (Pose 1 2 r))
          back = motionRotation (inverse (Motion r 0 0))
          both = motionRotation (andThen (Motion r 0 0) stay)
      if isInfinite r
        then [told, both, negate back] `shouldBe` [r, r, r]
        else do
          [told, both, back] `shouldSatisfy` all (\a -> a >= 0 && a < 360)
          let whole a = abs (a - 360 * fromIntegral (round (a / 360) :: Int)) < 1e-9
          map whole [told - r, both - r, back + r] `shouldBe` [True, True, True]
  it "that are no numbers stay none" $
    map (isNaN . poseRotation . move stay . Pose 0 0) [0 / 0] `shouldBe` [True]

scaleSpec :: Spec
scaleSpec = do
  it "askew, an element reads the mean of 8 x 8 points of its aperture, as a share of it" $
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
         in closeTo (forwardImage sensor (HeightMap cell heights) (Pose x y turn)) wanted
  it "under tabs it reads the share of each on the face times its height, spread below them" $
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
            under = footing (sensorLayout sensor) 1.2 (HeightMap 1.5 heights) (Pose x y turn)
            share i j =
              at (footingShare under) i j
                * max 0 (min 1 (at (footingHeight under) i j / sensorFullScale sensor))
            felt = spreadForces 1.5875 depth (generate 5 4 share)
            wanted = mapRaster (\v -> max 0 (min 1 (max 0 v ** 0.8))) felt
         in closeTo (forwardImage sensor (HeightMap 1.5 heights) (Pose x y turn)) wanted
  it "no reading is above it, however it comes about" $ do
    let steep = HeightMap taxelPitch (constant 16 16 50)
        here = Pose (8 * taxelPitch) (8 * taxelPitch) 0
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

-- | A sensor whose elements average heights, with any of the errors.
genSensor :: Gen Sensor
genSensor = do
  columns <- choose (3, 6)
  rows' <- choose (3, 6)
  let some low high = frequency [(1, pure 0), (2, choose (low, high))]
  position <- some 0.1 2
  rotation <- some 1 9
  forceSpread <- some 0.05 0.5
  tilt <- some 0.01 0.1
  exponent' <- elements [1, 1, 0.7]
  share <- some 0.005 0.02
  hysteresis <- some 0.05 0.4
  drift <- some 0.01 0.1
  noise <- some 0.01 0.2
  slope <- some 0.01 0.2
  ofRows <- some 0.1 0.5
  ofColumns <- some 0.1 0.5
  bits <- elements [0, 0, 4, 8]
  zeroed <- elements [0, 2]
  pure
    idealSensor
      { sensorColumns = columns,
        sensorRows = rows',
        sensorPositionError = position,
        sensorRotationError = rotation,
        sensorForceSpread = forceSpread,
        sensorTiltSpread = tilt,
        sensorExponent = exponent',
        sensorCrosstalk = share,
        sensorHysteresis = hysteresis,
        sensorDrift = drift,
        sensorNoise = noise,
        sensorNoiseSlope = slope,
        sensorRowNoise = ofRows,
        sensorColumnNoise = ofColumns,
        sensorBits = bits,
        sensorZeroed = zeroed
      }

-- | Draws where the constant is not nothing.
drawn :: Double -> a -> (StdGen -> (a, StdGen)) -> StdGen -> (a, StdGen)
drawn constant' without draw g
  | constant' > 0 = draw g
  | otherwise = (without, g)

-- | What a specimen reads of levels at the press of a number.
read' :: Sensor -> Raster -> Int -> Raster -> StdGen -> (Raster, StdGen)
read' sensor gains number levels g0 = (generate w h given, g3)
  where
    (w, h) = rasterSize levels
    later = 1 + sensorDrift sensor * logBase 10 (fromIntegral number)
    amplified = generate w h (\x y -> at levels x y * later * at gains x y)
    mixed = generate w h $ \x y ->
      (1 - 2 * share) * at amplified x y
        + share * sum [at amplified u y | u <- [0 .. w - 1]] / fromIntegral w
        + share * sum [at amplified x v | v <- [0 .. h - 1]] / fromIntegral h
    share = sensorCrosstalk sensor
    noiseless = sensorNoise sensor <= 0 && sensorNoiseSlope sensor <= 0
    (own, g1) = if noiseless then (V.replicate (w * h) 0, g0) else normals (w * h) g0
    (ofRows, g2) = common sensorRowNoise h g1
    (ofColumns, g3) = common sensorColumnNoise w g2
    common part n
      | noiseless = (,) (V.replicate n 0)
      | otherwise = drawn (part sensor) (V.replicate n 0) (normals n)
    noisy' x y =
      let v = at mixed x y
          sd = sensorNoise sensor + sensorNoiseSlope sensor * max 0 (min 1 v)
          (r, c) = (sensorRowNoise sensor, sensorColumnNoise sensor)
       in v
            + sd
              * ( sqrt (1 - r - c) * own V.! (y * w + x)
                    + sqrt r * ofRows V.! y
                    + sqrt c * ofColumns V.! x
                )
    given x y =
      converted (sensorBits sensor) (sensorZeroed sensor) $
        if at gains x y > 0 then noisy' x y else 0

pressSpec :: Spec
pressSpec = do
  modifyMaxSuccess (const 60)
    . it "in turn are the heights with what is left of the presses before, read as is said"
    $ forAll genSensor $ \sensor ->
      forAll (choose (1, 99999)) $ \seed ->
        forAll (choose (1, 4) >>= (`vectorOf` genPose)) $ \poses ->
          forAll (elements [0, 90, 37]) $ \turn ->
            let motion = Motion turn 30 20
                relief = texture 5 40 40
                (w, h) = (sensorColumns sensor, sensorRows sensor)
                gains = generate w h (\x y -> fromIntegral ((x * 5 + y * 3 + seed) `mod` 4) / 2)
                plain = idealSensor {sensorColumns = w, sensorRows = h}
                -- The readings of presses in turn, and the generator after them.
                go _ _ [] g = ([], g)
                go earlier number (pose : rest) g0 =
                  let ((ex, ey), g1) = normalPair g0
                      (er, g2) = drawn (sensorRotationError sensor) 0 normal g1
                      err = sensorPositionError sensor * 1.5875
                      true =
                        Pose
                          (poseX pose + err * ex)
                          (poseY pose + err * ey)
                          (poseRotation pose + sensorRotationError sensor * er)
                      (_, g3) = drawn (sensorForceSpread sensor) 0 normal g2
                      (_, g4) = drawn (sensorTiltSpread sensor) (0, 0) normalPair g3
                      shares = forwardImage plain relief (move motion true)
                      felt = generate w h $ \x y ->
                        at shares x y + maybe 0 ((sensorHysteresis sensor *) . flip' x y) earlier
                      levels = mapRaster conducted felt
                      (image, g5) = read' sensor gains number levels g4
                      (images, end) = go (Just felt) (number + 1) rest g5
                   in (image : images, end)
                flip' x y image = at image x y
                conducted v = if v <= 0 then 0 else v ** sensorExponent sensor
                (found, rest') =
                  scanWith sensor (Specimen gains) relief motion poses (mkStdGen seed)
                (wanted, stands) = go Nothing 1 poses (mkStdGen seed)
             in conjoin
                  [ length found === length poses,
                    map framePose found === poses,
                    conjoin (zipWith (closeTo . frameImage) found wanted),
                    next rest' === next stands
                  ]
  modifyMaxSuccess (const 40)
    . it "of one alone, without errors of place, are the first press of a flawless specimen"
    $ forAll genSensor $ \sensor ->
      forAll ((,) <$> genPose <*> choose (1, 99999)) $ \(pose, seed) ->
        let still = sensor {sensorPositionError = 0, sensorRotationError = 0}
            relief = texture 5 40 40
            (image, g) = press still relief pose (mkStdGen seed)
            -- A scan draws the two errors of place first.
            from = snd (normalPair (mkStdGen seed))
            (frames, _) = scanWith still (flawless still) relief stay [pose] (mkStdGen seed)
            (alone, g') = press still relief pose from
         in map frameImage frames === [alone]
              .&&. (next g == next g') === (next (mkStdGen seed) == next from)
              .&&. V.length (rasterValues image) === sensorColumns sensor * sensorRows sensor
  modifyMaxSuccess (const 40)
    . it "by a rigid sensor are the tabs' displacements at the force and the tilts that are drawn"
    $ forAll ((,) <$> elements [0, 0.2, 2] <*> elements [0, 0.05]) $ \(forceSpread, tilt) ->
      forAll (choose (1, 99999)) $ \seed ->
        let sensor =
              idealSensor
                { sensorStiffness = 0.19,
                  sensorTab = 1.2,
                  sensorForce = 12,
                  sensorForceSpread = forceSpread,
                  sensorTiltSpread = tilt,
                  sensorFullForce = 0.9,
                  sensorBreakForce = 0.01,
                  sensorExponent = 0.8,
                  sensorDepth = 0.7
                }
            relief = texture 5 40 40
            pose = Pose 30 28 20
            (force', g1) = drawn forceSpread 0 normal (mkStdGen seed)
            ((a, b), _) = drawn tilt (0, 0) normalPair g1
            -- At least a twentieth of the force.
            force = 12 * max 0.05 (1 + forceSpread * force')
            under = footing (sensorLayout sensor) 1.2 relief pose
            seen newtons tilts =
              mapRaster (max 0 . min 1 . conductance 0.8 0.01 0.9) $
                spreadForces taxelPitch 0.7 $
                  mapRaster (0.19 *) (displacements 0.19 newtons tilts under)
            wanted = seen force (a * tilt * 1.5875, b * tilt * 1.5875)
         in closeTo (fst (press sensor relief pose (mkStdGen seed))) wanted
              .&&. closeTo (forwardImage sensor relief pose) (seen 12 (0, 0))
  where
    genPose = Pose <$> choose (-3, 3) <*> choose (-3, 3) <*> elements [0, 90, 15]

specimenSpec :: Spec
specimenSpec = do
  it "have gains about 1, none negative, and are dead where the fate drawn is below the share" $
    forAll (choose (1, 99999)) $ \seed ->
      forAll ((,) <$> elements [0, 0.1, 1.5] <*> elements [0, 0.3, 1]) $ \(spread, dead) ->
        let sensor =
              idealSensor
                { sensorColumns = 5,
                  sensorRows = 3,
                  sensorGainSpread = spread,
                  sensorDead = dead
                }
            (specimen, g) = drawSpecimen sensor (mkStdGen seed)
            (off, g1) = drawn spread (V.replicate 15 0) (normals 15) (mkStdGen seed)
            (fates, g2)
              | dead > 0 = (take 15 (unfoldr (Just . uniform) g1), iterate (snd . uniform) g1 !! 15)
              | otherwise = (replicate 15 1, g1)
            gain x y =
              let i = y * 5 + x
               in if fates !! i < dead then 0 else max 0 (1 + spread * off V.! i)
         in closeTo (specimenGains specimen) (generate 5 3 gain) .&&. next g === next g2
  modifyMaxSuccess (const 30)
    . it "in calibration frames read nothing, or half of full scale, each as at the first press"
    $ forAll ((\s -> s {sensorBits = 0}) <$> genSensor) $ \sensor ->
      forAll ((,) <$> choose (0, 3) <*> choose (1, 99999)) $ \(count, seed) ->
        let (w, h) = (sensorColumns sensor, sensorRows sensor)
            gains = generate w h (\x y -> fromIntegral ((x + 2 * y) `mod` 3))
            wanted level =
              take count $
                unfoldr (Just . read' sensor gains 1 (constant w h level)) (mkStdGen seed)
            told frames = map frameImage (frames sensor (Specimen gains) count (mkStdGen seed))
            same a b = length a === length b .&&. conjoin (zipWith closeTo a b)
         in same (told darkFrames) (wanted 0) .&&. same (told flatFrames) (wanted 0.5)

calibrationSpec :: Spec
calibrationSpec = do
  it "is as defined, where elements lie at the limits of what is dead as well" $
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
  it "a dead element has the mean of the nearest ring with living ones; 0 where none lives" $
    forAll (sublistOf [(y, x) | y <- [0 .. 3], x <- [0 .. 4]]) $ \dead ->
      let image = generate 5 4 (\x y -> fromIntegral ((3 * x + 5 * y) `mod` 8) / 8)
          living = [(y, x) | y <- [0 .. 3], x <- [0 .. 4], (y, x) `notElem` dead]
          wanted x y
            | null living = 0
            | otherwise =
              let far (v, u) = max (abs (u - x)) (abs (v - y))
                  least = minimum (map far living)
                  ring = [at image u v | p@(v, u) <- living, far p == least]
               in sum ring / fromIntegral (length ring)
       in case correctedImage (plain dead) image of
            Right found -> closeTo found (generate 5 4 wanted)
            Left e -> counterexample (show e) False
  it "elements are stuck that are above a half in six frames or more, 8 elements apart or more" $
    forAll ((,) <$> choose (5, 7) <*> elements [7.9, 8, 8.1]) $ \(count, far) ->
      forAll ((,) <$> choose (0, 6) <*> elements [0.5, 0.501]) $ \(stuck, level) ->
        forAll arbitrary $ \upwards ->
          let lit = take stuck [(y, x) | y <- [0 .. 3], x <- [0 .. 3]]
              shown y x = if (y, x) `elem` lit then level else 0.125
              place k
                | upwards = Pose 0 (if k == 1 then far * taxelPitch else 0) 0
                | otherwise = Pose (if k == 1 then far * taxelPitch else 0) 0 0
              frames =
                [ Frame (place k) 0 (generate 4 4 (flip shown)) taxelPitch []
                  | k <- [1 .. count :: Int]
                ]
              applies = count >= 6 && far >= 8 && level > 0.5 && stuck >= 1 && stuck <= 4
              wanted =
                if applies
                  then either (const []) id (traverse (corrected (none lit)) frames)
                  else frames
           in classify applies "stuck" (withoutStuck frames === wanted)
  it "where no element is stuck nothing is changed, not even readings above full scale" $ do
    let frame k = Frame (Pose (20 * k) 0 0) 0 (generate 4 4 (felt k)) taxelPitch [(1, 1)]
        felt k x y = if fromIntegral (x + y) == k then 1.5 else 0.25 :: Double
        frames = map frame [0 .. 6]
    withoutStuck frames `shouldBe` frames
  where
    darks = [0, 0, 0.125, 0.5, 0.5625]
    rises = [0, 0.0625, 0.125, 0.25, 0.25, 0.5, 0.875]
    plain = Calibration (constant 5 4 0) (constant 5 4 1)
    none = Calibration (constant 4 4 0) (constant 4 4 1)
