-- | Tests calibration, and frames of any size and pitch.
module Test.Touch.Sensor.CalibrationUndoesGains (spec) where

import Control.Exception (evaluate)
import Data.Aeson.Types (JSONPathElement (..))
import Data.Foldable (for_)
import Data.List (partition, sort, subsequences)
import Data.Maybe (fromMaybe)
import Data.String (fromString)
import qualified Data.Vector.Storable as V
import PraTactile.Format (FormatError (..), Misfit (..))
import PraTactile.Format.Calibration (decodeCalibration, encodeCalibration)
import PraTactile.Image
import PraTactile.Registration
import PraTactile.Sensor
import PraTactile.Sensor.Calibration
import PraTactile.Sensor.Frame
import PraTactile.Sensor.Resample
import System.Random (mkStdGen)
import System.Timeout (timeout)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (generate, sample)
import Test.Support
import Test.Touch.Sensor.MeanHeights (texture)

spec :: Spec
spec = do
  describe "Calibration" calibrating
  describe "Another pitch" pitches
  describe "Another size" sizes

at :: Raster -> Int -> Int -> Double
at image x y = fromMaybe (0 / 0) (index image x y)

-- | The difference of the greatest and the least value.
spread :: Raster -> Double
spread image = fromMaybe 0 (maximumValue image) - fromMaybe 0 (minimumValue image)

calibrating :: Spec
calibrating = do
  it "without noise the gains are the specimen's, and its dead elements are found" $
    forAll ((,,) <$> choose (4, 17) <*> choose (4, 17) <*> choose (1, 99999)) $ \(w, h, seed) ->
      let sensor =
            idealSensor
              { sensorColumns = w,
                sensorRows = h,
                sensorGainSpread = 0.1,
                sensorDead = 0.05
              }
          (specimen, _) = drawSpecimen sensor (mkStdGen seed)
          gains = specimenGains specimen
          images frames = map frameImage (frames sensor specimen 2 (mkStdGen 1))
          (dead, living) =
            partition
              (\(y, x) -> at gains x y == 0)
              [(y, x) | y <- [0 .. h - 1], x <- [0 .. w - 1]]
       in whenRight (calibrate (images darkFrames) (images flatFrames)) $ \found ->
            let ratios = [at (calibrationGain found) x y / at gains x y | (y, x) <- living]
             in conjoin
                  [ calibrationDead found === dead,
                    property (maximum ratios / minimum ratios - 1 < 1e-9),
                    -- So a flat frame is flat again, dead elements too.
                    whenRight
                      (traverse (corrected found) (flatFrames sensor specimen 1 (mkStdGen 2)))
                      $ all ((< 1e-9) . spread . frameImage)
                  ]
  it "offsets are subtracted" $ do
    let dark = generate 5 4 (\x y -> 0.01 * fromIntegral (x + y))
        lit = mapRaster (+ 0.5) dark
    found <- right (calibrate [dark] [lit])
    frame <- right (corrected found (Frame (SensorPose 0 0 0) 0 (mapRaster (+ 0.25) dark) 1 []))
    V.maximum (V.map (abs . subtract 0.25) (rasterValues (frameImage frame)))
      `shouldSatisfy` (< 1e-12)
  it "an element is dead if it rises below a quarter of the median, or is bright in the dark" $ do
    let rise x = [0.4, 0.1001, 0.0999, 0.4, 0.4] !! x
        dark x = [0, 0, 0, 0.4999, 0.5001] !! x
    found <-
      right
        ( calibrate
            [generate 5 1 (\x _ -> dark x)]
            [generate 5 1 (\x _ -> dark x + rise x)]
        )
    calibrationDead found `shouldBe` [(0, 2), (0, 4)]
  it "any element may be dead, without others becoming dead" $
    for_ [(y, x) | y <- [0 .. 3], x <- [0 .. 4]] $ \place -> do
      let dark = constant 5 4 0.1
          lit = generate 5 4 (\x y -> if (y, x) == place then 0.15 else 0.5)
      found <- right (calibrate [dark, dark] [lit, lit, lit])
      calibrationDead found `shouldBe` [place]
  it "an element that felt nothing stays dead besides those found, and keeps its reading" $ do
    let dead = [(2, 3), (0, 0), (0, 1), (1, 0), (1, 1)]
        plain = Calibration (constant 6 5 0) (constant 6 5 1) dead
        image = generate 6 5 (\x y -> 0.02 * fromIntegral x + 0.05 * fromIntegral y)
    frame <- right (corrected plain (Frame (SensorPose 0 0 0) 0 image 1 [(4, 5), (0, 1)]))
    at (frameImage frame) 5 4 `shouldBe` at image 5 4
    sort (frameDead frame) `shouldBe` sort ((4, 5) : dead)
  it "a dead element reads the mean of its nearest living ones, for all 4096 sets of 4 x 3" $
    for_ (subsequences [(y, x) | y <- [0 .. 2], x <- [0 .. 3]]) $ \dead -> do
      let image = generate 4 3 (\x y -> fromIntegral ((7 * x + 5 * y) `mod` 11) / 11)
          living = [(y, x) | y <- [0 .. 2], x <- [0 .. 3], (y, x) `notElem` dead]
          distance (y, x) (j, i) = max (abs (y - j)) (abs (x - i)) :: Int
          -- Itself, where it lives.
          nearest place = [n | n <- living, all ((>= distance place n) . distance place) living]
          expected x y = case nearest (y, x) of
            [] -> 0
            places -> sum [at image i j | (j, i) <- places] / fromIntegral (length places)
      seen <- right (correctedImage (Calibration (constant 4 3 0) (constant 4 3 1) dead) image)
      let wrong = [(x, y) | x <- [0 .. 3], y <- [0 .. 2], abs (at seen x y - expected x y) > 1e-12]
      (dead, wrong) `shouldBe` (dead, [])
  it "a single living element of 256 x 256 is the nearest of all, and soon found" $ do
    let dead = [(y, x) | y <- [0 .. 255], x <- [0 .. 255], (y, x) /= (10, 200)]
        image = generate 256 256 (\x y -> if (y, x) == (10, 200) then 0.625 else 1)
        plain = Calibration (constant 256 256 0) (constant 256 256 1) dead
    seen <- timeout 60000000 (evaluate (correctedImage plain image))
    seen `shouldBe` Just (Right (constant 256 256 0.625))
  it "impossible calibrations are refused, each with its reason" $ do
    let flat = constant 4 4 0.5
        dark = constant 4 4 0
    [ calibrate [] [flat],
      calibrate [dark] [],
      calibrate [dark] [constant 4 5 0.5],
      calibrate [dark] [constant 4 4 (0 / 0)],
      calibrate [dark] [dark],
      calibrate [dark] [constant 4 4 1]
      ]
      `shouldBe` map
        Left
        [ NoDarkFrame,
          NoFlatFrame,
          SensorsDiffer (4, 4) (4, 5),
          ReadingNotFinite,
          AllDead,
          AllSaturated
        ]
  it "an element pressed in every frame while the sensor moved is stuck and counts as not felt" $ do
    let lit = [(3, 2), (9, 9)]
        felt k = generate 16 16 $ \x y ->
          if (y, x) `elem` lit then 1 else if (x + 3 * k + y) `mod` 7 < 2 then 0.8 else 0
        framesAt step n =
          [Frame (SensorPose (step * fromIntegral k) 0 0) 0 (felt k) 1 [] | k <- [0 .. n]]
        plain = Calibration (constant 16 16 0) (constant 16 16 1) lit
        moved = framesAt 4 7
    expected <- right (traverse (corrected plain) moved)
    withoutStuck moved `shouldBe` expected
    for_
      [ ("standing still" :: String, framesAt 0.5 7),
        ("few", framesAt 4 4),
        ("all saturated", [frame {frameImage = constant 16 16 1} | frame <- moved]),
        ("two sizes", Frame (SensorPose 0 0 0) 0 (constant 4 4 1) 1 [] : moved)
      ]
      $ \(name, frames') -> (name, withoutStuck frames' == frames') `shouldBe` (name, True)
  it "a file's dead elements must be elements of the sensor" $
    for_ [(y, x) | y <- [-1, 0, 4, 5], x <- [-1, 0, 3, 4]] $ \(y, x) -> do
      let given = Calibration (constant 4 5 0) (constant 4 5 1) [(2, 2), (y, x)]
          sensible = y `elem` [0, 4] && x `elem` [0, 3]
      either (const Nothing) Just (decodeCalibration (encodeCalibration given))
        `shouldBe` if sensible then Just given else Nothing
  it "a file's dead elements must be distinct" $ do
    let given dead = encodeCalibration (Calibration (constant 4 5 0) (constant 4 5 1) dead)
    decodeCalibration (given [(2, 2), (0, 1), (2, 2)])
      `shouldBe` Left (Misfit [Key (fromString "dead"), Index 2] (GivenTwice "2,2"))
    fmap calibrationDead (decodeCalibration (given [(2, 2), (0, 1)]))
      `shouldBe` Right [(2, 2), (0, 1)]
  it "a file's gains must be positive" $
    for_ [-1, 0, 0.001] $ \gain -> do
      let given = Calibration (constant 4 5 0) (constant 4 5 gain) []
      either (const Nothing) Just (decodeCalibration (encodeCalibration given))
        `shouldBe` if gain > 0 then Just given else Nothing
  it "another sensor's calibration is refused" $
    for_ [(4, 4, 16, 16), (5, 4, 4, 5), (5, 4, 5, 5)] $ \(w, h, w', h') ->
      corrected
        (Calibration (constant w h 0) (constant w h 1) [])
        (Frame (SensorPose 0 0 0) 0 (constant w' h' 0) 1 [])
        `shouldBe` Left (SensorsDiffer (w, h) (w', h'))

pitches :: Spec
pitches = do
  prop "at half the pitch, each new taxel is the mean of the four that it covers" $
    forAll ((,) <$> choose (0, 3) <*> choose (0, 2)) $ \(i, j) ->
      let image = generate 8 6 (\x y -> fromIntegral ((7 * x + 13 * y) `mod` 11) / 11)
          four = [at image (2 * i + a) (2 * j + b) | a <- [0, 1], b <- [0, 1]]
       in counterexample (show four) (abs (at (resampled 0.5 image) i j - sum four / 4) < 1e-12)
  prop "an even image stays even at any ratio, with as many taxels as fit" $
    forAll ((,,) <$> choose (0.05, 4) <*> choose (4, 40) <*> choose (0, 1)) $ \(ratio, n, v) ->
      let image = resampled ratio (constant n (n + 1) v)
          whole k = max 1 (floor (fromIntegral (k :: Int) * ratio + 1e-9))
       in rasterSize image === (whole n, whole (n + 1))
            .&&. counterexample (show image) (V.all (\u -> abs (u - v) < 1e-9) (rasterValues image))
  prop "transposed and resampled equals resampled and transposed" $
    forAll ((,,) <$> oneof [choose (0.05, 1), choose (1, 4)] <*> choose (1, 9) <*> choose (1, 30)) $
      \(ratio, w, h) ->
        let image = generate w h (\x y -> fromIntegral ((7 * x + 13 * y * y) `mod` 11))
            exchanged whole =
              generate (rasterHeight whole) (rasterWidth whole) (\x y -> at whole y x)
            (one, other) = (exchanged (resampled ratio image), resampled ratio (exchanged image))
            apart = V.zipWith (\u v -> abs (u - v)) (rasterValues one) (rasterValues other)
         in rasterSize one === rasterSize other
              .&&. counterexample (show (one, other)) (V.all (< 1e-9) apart)
  prop "a ramp stays a ramp about the same centre, exactly or by areas to 0.15" $
    forAll (choose (0.3, 3)) $ \ratio ->
      let image = resampled ratio (generate 40 40 (\i _ -> fromIntegral i - 19.5))
          w = rasterWidth image
          x = w `div` 2 + 2
          expected = (fromIntegral x + 0.5 - fromIntegral w / 2) / ratio
       in counterexample (show (w, at image x 5, expected)) $
            abs (at image x 5 - expected) < (if ratio < 1 then 0.15 else 1e-9)
  it "an image narrower than a new pixel becomes one pixel, the mean of all" $
    resampled 0.1 (generate 4 8 (\x y -> fromIntegral (x + 4 * y))) `shouldBe` constant 1 1 15.5
  it "an image without pixels stays without pixels, at any pitch" $
    [ rasterSize image
      | (ratio, (w, h)) <- [(0.3, (0, 0)), (1, (0, 5)), (2.5, (5, 0))],
        let image = resampled ratio (constant w h 1)
    ]
      `shouldBe` [(0, 0), (0, 5), (12, 0)]
  it "frames of a sensor of half the pitch, resampled, are those of the usual sensor" $
    forAll ((,) <$> choose (2, 16) <*> choose (2, 16)) $ \(w, h) ->
      forAll ((,,) <$> choose (20, 40) <*> choose (20, 40) <*> elements [0, 90, 180, 270]) $
        \(x, y, r) ->
          let relief = texture 7 60 60
              pose = SensorPose (x * taxelPitch) (y * taxelPitch) r
              frame sensor = Frame pose 0 (forwardImage sensor relief pose) (sensorTaxel sensor) []
              fine =
                (withTaxel (taxelPitch / 2) idealSensor)
                  { sensorColumns = 2 * w,
                    sensorRows = 2 * h
                  }
              usual = frameImage (frame idealSensor {sensorColumns = w, sensorRows = h})
           in whenRight (zipRaster (-) usual (frameImage (atCanonicalPitch (frame fine)))) $
                V.all ((< 1e-9) . abs) . rasterValues

sizes :: Spec
sizes = do
  it "frames of any size are placed together, also turned ones" $ do
    let relief = texture 3 60 60
        sensor = idealSensor {sensorColumns = 10, sensorRows = 6}
        pressed x y r =
          let pose = SensorPose (taxelPitch * x) (taxelPitch * y) r
           in Frame pose 0 (forwardImage sensor relief pose) taxelPitch []
    together <- right (placeOnly [pressed 15 13 0, pressed 23 15 90])
    -- The first covers columns 10 to 19 and rows 10 to 15, the second columns 20 to 25 and rows 10
    -- to 19.
    let height x y = at (heightValues relief) x y / sensorFullScale sensor
        seen = compositeImage together
    rasterSize seen `shouldBe` (16, 10)
    let wrong =
          [ (x, y)
            | (x, y) <-
                [(x, y) | x <- [10 .. 19], y <- [10 .. 15]]
                  ++ [(x, y) | x <- [20 .. 25], y <- [10 .. 19]],
              abs (at seen (x - 10) (y - 10) - height x y) > 1e-9
          ]
    wrong `shouldBe` []
  it "frames below 4 x 4 or above 256 x 256, and invalid pitches, are refused" $ do
    let frame w h = Frame (SensorPose 0 0 0) 0 (constant w h 0.5) taxelPitch []
    map
      (either show (const "put together") . placeOnly . pure)
      [ frame 3 4,
        frame 4 257,
        (frame 4 4) {frameTaxel = 0},
        (frame 4 4) {frameTaxel = 0 / 0},
        (frame 4 4) {frameTaxel = 50.001},
        frame 4 256
      ]
      `shouldBe` [ show (FrameSize 0 3 4),
                   show (FrameSize 0 4 257),
                   show (FramePitch 0 0),
                   show (FramePitch 0 (0 / 0)),
                   show (FramePitch 0 50.001),
                   "put together"
                 ]
  prop "a plan with any sensor covers the region to its edges, and no pose leaves it" $
    forAll ((,,) <$> choose (4, 40) <*> choose (4, 40) <*> choose (0.3, 2)) $ \sensor ->
      forAll ((,,) <$> choose (1, 20) <*> choose (10, 90) <*> choose (10, 90)) $ \region ->
        planned sensor region
  where
    planned (w, h, ratio) (spacing, wide, high) =
      case planScanOf (TaxelGrid w h (ratio * taxelPitch)) spacing (0, 0) (wide, high) of
        Left (RegionBelowSensor wide' high' across' down') ->
          property (2 * across > fromIntegral wide || 2 * down > fromIntegral high)
            .&&. (wide', high') === (wide, high)
            .&&. counterexample
              (show (across', down'))
              (near across' (2 * across) && near down' (2 * down))
        Left e -> counterexample (show e) False
        Right poses -> covering across wide poseX poses .&&. covering down high poseY poses
      where
        (across, down) = (ratio * fromIntegral w / 2, ratio * fromIntegral h / 2)
    covering margin side coordinate poses =
      counterexample (show places) $
        near (minimum places) margin && near (maximum places) (fromIntegral side - margin)
      where
        places = map ((/ taxelPitch) . coordinate) poses
    near :: Double -> Double -> Bool
    near a b = abs (a - b) < 1e-6
