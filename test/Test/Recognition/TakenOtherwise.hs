-- | Tests the worked example's frames with positions or images that are misinterpreted. Each kind
-- is refused with the mistake. Every advice in a refusal, followed to its end, leads to the worked
-- example's window.
module Test.Recognition.TakenOtherwise (spec) where

import Control.Applicative ((<|>))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Foldable (for_)
import Data.Maybe (fromMaybe, mapMaybe)
import PraTactile.Array (Position (..))
import PraTactile.Composite (Contradiction (..))
import PraTactile.Decode
import PraTactile.Files (readFolder)
import PraTactile.Image (Raster, constant, generate, mapRaster, onRaster)
import PraTactile.Image.Pgm
import PraTactile.Recognise
import PraTactile.Sensor.Frame (SensorPose (..))
import PraTactile.Sensor.Manifest
import PraTactile.Sensor.Resample (resampled)
import PraTactile.Source
import PraTactile.Symmetry
import Test.Effort
import Test.Hspec

spec :: Spec
spec = do
  describe "axes of positions and images" axesSpec
  describe "scales of positions" scaleSpec
  describe "an image without readable symbols" seenSpec
  describe "positions without information" nothingSpec

-- A robot with y up, a sensor mounted turned, a camera that sees the overlay from behind.
axesSpec :: Spec
axesSpec = do
  it "are named so that the advice leads to the window" $ do
    folder <- exampleFolder
    for_ (byEffort differing (alone ++ together)) $ \(positions, images) -> do
      let written = onImages (invert (axesSymmetry images)) (onPositions (unalong positions) folder)
      ended <- snd <$> followed 3 asStated written
      (axesName positions, axesName images, ended)
        `shouldBe` (axesName positions, axesName images, Right (Just exampleWindow))
  -- Frames agree if the positions are taken along a besides, and with them whatever is done to
  -- positions and images alike.
  it "remedies keep positions and images together, and show what is not mirrored" $
    for_ [(p, i, a, m) | p <- axes, i <- axes, a <- axes, m <- [Nothing, Just False, Just True]] $
      \(positions, images, Axes a, mirroredThen) -> do
        let given = standardConventions {positionAxes = positions, imageAxes = images}
            found = remedies given (Axes a) mirroredThen
        found `shouldNotBe` []
        for_ found $ \remedy -> do
          let taken now = axesSymmetry . fromMaybe now
              h = taken images (remedyImages remedy) <> invert (axesSymmetry images)
          taken positions (remedyPositions remedy) `shouldBe` h <> a <> axesSymmetry positions
          maybe True (== mirrored h) mirroredThen `shouldBe` True
  it "of a whole mirrored image are named" $ do
    image <- reencoded (onRaster mirror) <$> Bytes.readFile "data/worked-example/composite.pgm"
    refused <- decoded asStated (WholeImage image)
    refused `shouldBe` Left (Mirrored [Remedy Nothing (lookup "-x,y" axesNamed)])
    let known = asStated {preparedImageAxes = fromMaybe straight (lookup "-x,y" axesNamed)}
    decoded known (WholeImage image) `shouldReturn` Right (Just exampleWindow)
  where
    axes = map snd axesNamed
    alone = [(a, straight) | a <- axes] ++ [(straight, a) | a <- drop 1 axes]
    together = zip (drop 1 axes) (drop 3 axes)
    -- A mirrored robot alone, and a robot and an image that both exchange their axes.
    differing = take 1 (drop 2 alone) ++ take 1 (drop 4 together)
    unalong (Axes symmetry) = onOffset (invert symmetry)
    onImages symmetry folder =
      folder {folderImages = reencoded (onRaster symmetry) <$> folderImages folder}

-- Light that is no contact, and a camera with more pixels than there are taxels.
seenSpec :: Spec
seenSpec = do
  it "is recognised as inverted" $ do
    image <- changed (mapRaster (1 -))
    decoded asStated (WholeImage image)
      `shouldReturn` Left (ShownInstead InsteadInverted NoSymbols)
    decoded asStated {preparedInverted = True} (WholeImage image)
      `shouldReturn` Right (Just exampleWindow)
  it "is recognised as having symbols of another size" $ do
    image <- changed (resampled 2)
    decoded asStated (WholeImage image) >>= \refused -> case refused of
      Left (ShownInstead (InsteadScaled factor taxel) _) -> do
        factor `shouldBe` 2
        decoded asStated {preparedTaxel = Just taxel} (WholeImage image)
          `shouldReturn` Right (Just exampleWindow)
      other -> expectationFailure (show other)
  it "is refused as flat, or as unknown if its size would hold a symbol" $ do
    decoded asStated (WholeImage (imageFile (constant 60 60 0)))
      `shouldReturn` Left (ShownInstead InsteadFlat NoSymbols)
    decoded asStated (WholeImage (imageFile (generate 60 60 stripes)))
      >>= (`shouldSatisfy` isUnknown)
  where
    changed f = reencoded f <$> Bytes.readFile "data/worked-example/composite.pgm"
    stripes x _ = if x `mod` 7 < 3 then 1 else 0
    isUnknown refused = case refused of
      Left (ShownInstead (InsteadUnknown 60 60) _) -> True
      _ -> False

-- Robots that log metres, inches, centimetres or taxels, and ones that are calibrated wrongly.
scaleSpec :: Spec
scaleSpec =
  it "are named, to three hundredths, and lead to the window" $ do
    folder <- exampleFolder
    -- Metres are furthest from millimetres.
    for_ (byEffort (take 1) id [1000, 25.4, 10, 1.5875, 4 / 3, 0.7]) $ \scale -> do
      let written = onPositions (\(x, y) -> (x / scale, y / scale)) folder
      (refused, ended) <- followed 1 asStated written
      case refused of
        Left (FramesContradict (AgreeingAtScale across down)) ->
          (across / scale, down / scale)
            `shouldSatisfy` \(a, b) -> abs (a - 1) < 0.03 && abs (b - 1) < 0.03
        other -> expectationFailure (show (scale, other))
      ended `shouldBe` Right (Just exampleWindow)

-- Logs of a robot that was not connected, of one coordinate twice, of another press, of steps.
nothingSpec :: Spec
nothingSpec = do
  refusedAs "all are the same" (map (const (0, 0))) $ \c ->
    case c of AgreeingAnywhere 24 0 0 -> True; _ -> False
  refusedAs "one coordinate is missing" (map (\(x, _) -> (x, 0))) anywhere
  refusedAs "one coordinate stands in both columns" (map (\(x, _) -> (x, x))) anywhere
  refusedAs "they are in another order" (\ps -> drop 7 ps ++ take 7 ps) anywhere
  refusedAs "they are steps from one frame to the next" steps anywhere
  where
    refusedAs named change expected =
      it named $ do
        folder <- exampleFolder
        refused <- decoded asStated (FrameFolder (withPositions change folder))
        refused `shouldSatisfy` either (named' expected) (const False)
    named' expected refusal = case refusal of
      FramesContradict contradiction -> expected contradiction
      _ -> False
    anywhere c = case c of
      AgreeingAnywhere 24 _ _ -> True
      _ -> False
    steps ps = zipWith (\(x, y) (x', y') -> (x' - x, y' - y)) ((0, 0) : ps) ps

-- | The window of the paper's worked example.
exampleWindow :: Position
exampleWindow = Position 6 5

exampleFolder :: IO Folder
exampleFolder = readFolder "data/worked-example/frames" >>= either (fail . show) pure

-- | The window that a source shows, if one is complete.
decoded :: Preparation -> Source -> IO (Either Refusal (Maybe Position))
decoded known source = do
  reader <- either (fail . show) pure canonicalRecogniser
  recognition <-
    either
      (fail . show)
      pure
      (decodeSources standardDecoding {decodingPreparation = known} reader [source])
  pure (placeOf <$> recognisedAnswer recognition)
  where
    placeOf answer = case answer of
      Found found -> Just (windowPosition (foundWindow found))
      Several _ _ -> Nothing

-- | The result for a folder, and the result after following its first advice at most this many
-- times.
followed ::
  Int ->
  Preparation ->
  Folder ->
  IO (Either Refusal (Maybe Position), Either Refusal (Maybe Position))
followed times known folder = do
  told <- decoded known (FrameFolder folder)
  ended <- case told of
    Left refusal
      | times > 0, Just next <- advised refusal -> snd <$> followed (times - 1) next folder
    _ -> pure told
  pure (told, ended)
  where
    advised refusal = case refusal of
      FramesContradict (AgreeingBy (remedy : _)) -> Just (remedied remedy)
      FramesContradict (AgreeingAtScale across down) ->
        Just known {preparedPositionScale = (across, down)}
      Mirrored (remedy : _) -> Just (remedied remedy)
      _ -> Nothing
    remedied (Remedy positions images) =
      known
        { preparedAxes = positions <|> preparedAxes known,
          preparedImageAxes = fromMaybe (preparedImageAxes known) images
        }

-- | A folder whose positions are changed, each by itself or all together.
onPositions :: ((Double, Double) -> (Double, Double)) -> Folder -> Folder
onPositions = withPositions . map

withPositions :: ([(Double, Double)] -> [(Double, Double)]) -> Folder -> Folder
withPositions change folder = folder {folderManifest = manifest {manifestEntries = changed}}
  where
    manifest = folderManifest folder
    entries = manifestEntries manifest
    changed =
      [ entry {entryPose = (\pose -> pose {poseX = x, poseY = y}) <$> entryPose entry}
        | (entry, (x, y)) <- zip entries (change (mapMaybe (fmap placeOf . entryPose) entries))
      ]
    placeOf (SensorPose x y _) = (x, y)

-- | The file of a changed image.
reencoded :: (Raster -> Raster) -> ByteString -> ByteString
reencoded change = either (const Bytes.empty) (imageFile . change . pgmIntensity) . decodePgm

imageFile :: Raster -> ByteString
imageFile = either (const Bytes.empty) (encodePgm Binary) . pgmFromIntensity 255
