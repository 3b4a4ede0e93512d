-- | Tests that a press lies where its truth says, and that an experiment is its presses in order.
module Test.Recognition.WhereItIsPressed (spec) where

import Data.Maybe (catMaybes)
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Image (Raster)
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Pressing
import PraTactile.Recognise
import PraTactile.Registration.Stitching
import PraTactile.Relief (reliefHeights)
import PraTactile.Sensor
import PraTactile.Sensor.Frame
import PraTactile.Symmetry
import PraTactile.Truth
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck
import Test.Recognition.Setting
import Test.Support

spec :: Spec
spec = do
  describe "presses" pressSpec
  describe "experiments" experimentSpec

pressSpec :: Spec
pressSpec = do
  withCases 2 10 $
    it "frames are what the sensor feels of the true face at the true region" $
      forAll ((,) <$> choose (1, 99999) <*> elements [(0, 0), (10, -20)]) $ \(seed, origin) ->
        forAll (elements [AmongTurns halfTurns, TurnedBy 33, AmongTurns [turned 1]]) $ \lying ->
          let how = (small seed) {pressingTurns = lying, pressingOrigin = origin}
           in whenRight (pressingOf how "cube") $ \(frames, truth) ->
                whenRight (feltAt truth) $ \felt ->
                  map frameImage frames === map (felt . framePose) frames
  it "the requested face, named from any vertex, is pressed at the requested place" $
    property $
      forAll (elements ["C1 C2 C3 C4", "C3 C4 C1 C2"]) $ \name ->
        whenRight
          ( pressingOf
              (small 1) {pressingFace = Just (readFaceName name), pressingAt = Just (12.7, 40)}
              "cube"
          )
          $ \(_, truth) ->
            (faceText (faceName (truthFace truth)), regionCorner (truthRegion truth))
              === ("C1 C2 C3 C4", (12.7, 40))
  it "each face of the object is drawn, and of no other object" $ do
    let drawn seed = faceName . truthFace . snd <$> pressingOf (small seed) "parallelepiped"
        layout = either (const []) laidFaces canonicalPlacement
        own = [laidFace f | f <- layout, faceObject (laidFace f) == ObjectName "parallelepiped"]
    faces <- right (traverse drawn [1 .. 60])
    map faceName own `shouldSatisfy` all (`elem` faces)
    faces `shouldSatisfy` all (`elem` map faceName own)
  it "a specimen has the same gains in other presses, and another specimen has others" $ do
    let gains seed one = map frameImage (flatPresses (spread seed) {pressingSpecimen = one} 1)
        spread seed = pressingWith idealSensor {sensorGainSpread = 0.2} seed
    gains 1 (Just 7) `shouldBe` gains 2 (Just 7)
    gains 2 (Just 7) `shouldSatisfy` (/= gains 2 (Just 8))
    gains 2 Nothing `shouldBe` gains 1 (Just 2)
    length (darkPresses (spread 1) 2) `shouldBe` 2
  it "each impossible press has its own error" $ do
    problem (pressingOf (small 1) "sphere") `shouldSatisfy` \e -> case e of
      Just (ObjectRefused _) -> True
      _ -> False
    problem (pressingOf (small 1) {pressingFace = Just (readFaceName "C1 C2")} "cube")
      `shouldSatisfy` \e -> case e of
        Just (NoSuchFace name _) -> name == readFaceName "C1 C2"
        _ -> False
    let long = (small 1) {pressingSize = (30, 100), pressingAt = Just (1.5875, 1.5875)}
    problem (pressingOf long "cube") `shouldSatisfy` off (30, 100)
    problem (pressingOf long {pressingTurns = TurnedBy 90} "cube") `shouldSatisfy` off (100, 30)
    problem (pressingOf long {pressingAt = Just (0, -15)} "cube") `shouldBe` Nothing
    problem (pressingOf (small 1) {pressingAt = Just (100, 100)} "cube")
      `shouldSatisfy` off (20, 24)
    problem (pressingOf (small 1) {pressingSize = (8, 8)} "cube") `shouldSatisfy` \e -> case e of
      Just (NotCovered _) -> True
      _ -> False
  where
    small seed = (pressingWith idealSensor seed) {pressingSize = (20, 24)}
    problem = either Just (const Nothing)
    off (w, h) e = case e of
      Just (RegionOffFace _ size) -> size == (1.5875 * w, 1.5875 * h)
      _ -> False

-- | A press of one of the paper's objects.
pressingOf :: Pressing -> String -> Either PressError ([Frame], Truth)
pressingOf how object =
  onPaper $ \(Setting array _ layout reader) ->
    pressed how (readerAlphabet reader) array layout (ObjectName object)

-- | The ideal sensor's frame of the true face at a pose in the robot's coordinates.
feltAt :: Truth -> Either String (SensorPose -> Raster)
feltAt truth = do
  heights <- maybe (Left "no such face") Right (lookup (truthFace truth) felt)
  let (x, y) = truthOrigin truth
      onFace pose =
        move
          (regionMotion (truthRegion truth))
          pose {poseX = poseX pose - x, poseY = poseY pose - y}
  pure (forwardImage idealSensor (reliefHeights heights) . onFace)
  where
    felt = onPaper (\setting -> [(laidFace face, surface) | (face, surface) <- facesFelt setting])

experimentSpec :: Spec
experimentSpec = do
  it "there are as many results as presses, each that of the trial with its number" $
    onPaper $ \setting -> do
      let experiment =
            (standardExperiment standardSensor) {experimentPresses = 3, experimentSeed = 5}
          reader = recogniserOf setting
          one t =
            runTrial
              standardTolerance
              reader
              (registrationFor (assumedStitching standardSensor) (trialFrames t))
              t
          each = catMaybes (trials (experimentExploration experiment) (facesFelt setting) 5)
      found <- right (evaluated experiment (settingArray setting) reader)
      found `shouldBe` map one (take 3 each)
  it "a region below the sensor is refused" $
    onPaper $ \setting -> do
      let refused size = evaluated (over size) (settingArray setting) (recogniserOf setting)
          over size =
            (standardExperiment standardSensor)
              { experimentExploration =
                  exploration standardSensor (AmongTurns halfTurns) size
              }
          cause = either name (const "none")
          name e = case e of
            PressesRefused _ -> "presses"
            ReliefRefused _ -> "relief"
            BendRefused _ -> "bend"
      map (cause . refused) [(20, 24), (4, 4)] `shouldBe` ["none", "presses"]
  it "a sensor's noise is the noise at full scale, with the spread of its elements" $ do
    let known sensor = stitchingNoise (assumedStitching sensor)
    known idealSensor {sensorNoise = 0.25, sensorNoiseSlope = 0, sensorGainSpread = 0}
      `shouldBe` Just 0.25
    known idealSensor {sensorNoise = 0.125, sensorNoiseSlope = 0.25, sensorGainSpread = 1}
      `shouldBe` Just 0.625
    stitchingPositionError (assumedStitching standardSensor {sensorPositionError = 1.5})
      `shouldBe` Just 1.5
