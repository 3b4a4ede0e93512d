-- | Tests the way from bytes to frames and recognition, and the reading of folders.
module Test.Recognition.FromBytesToAnswers (spec) where

import Control.Exception (IOException, finally, try)
import Control.Monad (filterM, forM_, zipWithM_)
import Data.Bifunctor (first)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.Either (isRight)
import Data.List (isPrefixOf)
import qualified Data.Map.Strict as Map
import PraTactile
import PraTactile.Composite.Noise (frameNoise)
import PraTactile.Decode (nominalStitching, someRecogniser, sourceComposite)
import PraTactile.Files
import PraTactile.Format (FormatError (..), JsonError (..), folderFiles)
import PraTactile.Image (constant, crop, generate)
import PraTactile.Image.Error (ImageError (..))
import PraTactile.Image.File (ImageFormat (..))
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, pgmFromIntensity)
import PraTactile.Object.Placement (Face (..), scaledPlacement, spotMillimetres)
import PraTactile.Object.WingedEdge (ObjectName (..), faceText, vertexText)
import PraTactile.Pressing (pressed, pressingWith)
import PraTactile.Recognise (ReadWindow (..))
import PraTactile.Registration (Registration (..), compositePosition, maxImagePixels)
import PraTactile.Registration.Stitching (registrationFor)
import PraTactile.Sensor (Sensor (..), sensorTaxelGrid, standardSensor, withTaxel)
import PraTactile.Sensor.Calibration (Calibration (..), CalibrationError (..), corrected)
import PraTactile.Sensor.Frame (TaxelGrid (..), standardTaxelGrid, taxelPitch)
import PraTactile.Sensor.Manifest
import PraTactile.Source
import PraTactile.Truth (Claim (..), compared)
import System.Directory (createDirectory)
import System.FilePath ((</>))
import System.IO (IOMode (..), hClose, hSetFileSize, withBinaryFile)
import System.IO.Error (isPermissionError)
import System.Posix.Files (setFileMode)
import System.Posix.IO (closeFd, createPipe, fdToHandle)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Support
import Test.Touch.Paper (paperAlphabet, paperTables)
import Text.Printf (printf)

spec :: Spec
spec = do
  describe "a folder as bytes" bytesSpec
  describe "frames prepared for stitching" preparedSpec
  describe "a folder on disk" diskSpec
  describe "decoding" decodeSpec

bytesSpec :: Spec
bytesSpec = do
  it "folderFrames of the folder of frames = Right these frames" $
    property $
      forAll (listOf1 genFrame) $ \frames ->
        fmap folderFrames (folderOf frames) === Right (Right frames)
  it "a name that leads out of the folder, or is malformed, is refused, even if it has bytes" $
    [folderFrames (Folder (listed [name]) (Map.singleton name flat)) | name <- elsewhere]
      `shouldBe` map (Left . ImageElsewhere) elsewhere
  it "a missing or malformed image is refused by its name" $ do
    folderFrames (Folder (listed ["a.pgm"]) Map.empty) `shouldBe` Left (ImageAbsent "a.pgm")
    folderFrames (Folder (listed ["a.pgm"]) (Map.singleton "a.pgm" (Bytes8.pack "P6")))
      `shouldBe` Left (ImageRefused "a.pgm" (NotPgm (Bytes8.pack "P6")))
  it "an image of another size than the manifest states is refused with both sizes" $
    folderFrames
      (Folder (listed ["a.pgm"]) {manifestFrame = Just (16, 8)} (Map.singleton "a.pgm" flat))
      `shouldBe` Left (ImageSize "a.pgm" (16, 16) (16, 8))
  it "an image is a composite up to a size; a larger one is refused" $ do
    let image :: Int -> Int -> Bytes.ByteString
        image wide high = Bytes8.pack ("P5 " ++ show wide ++ " " ++ show high ++ " 255\n")
        refused = either Just (const Nothing) . imageComposite
    -- Without its samples, an image that is not too large is cut off.
    refused (image 1024 1024) `shouldBe` Just (Truncated maxImagePixels 0)
    refused (image 1024 1025) `shouldBe` Just (LargerThanTouched 1048576 1024 1025)
    refused (image 1048577 1) `shouldBe` Just (LargerThanTouched 1048576 1048577 1)
  it "images with too many pixels together are refused before one is decoded" $ do
    let folder n = Folder (listed names) (Map.fromList [(name, half) | name <- names])
          where
            names = take n ["a.pgm", "b.pgm", "c.pgm"]
        half = Bytes8.pack "P5 2048 2048 255\n"
    preparedFrames asStated (folder 3) `shouldBe` Left (ImagesTooLarge 12582912)
    preparedFrames asStated (folder 2)
      `shouldBe` Left (ImageRefused "a.pgm" (Truncated 4194304 0))
  it "the images to be read are those in the folder, each once" $
    imagesNamed (listed (["b.pgm", "sub/a.pgm", "b.pgm"] ++ elsewhere))
      `shouldBe` ["b.pgm", "sub/a.pgm"]
  where
    elsewhere = ["../a.pgm", "/a.pgm", "sub/../../a.pgm", "a.pgm\0", "\0"]

-- | Frames of 16 x 16 taxels whose images pass through 8 bits unchanged.
genFrame :: Gen Frame
genFrame = do
  pose <- SensorPose <$> number <*> number <*> elements [0, 90, 180, 270]
  values <- vectorOf 256 (choose (0, 255 :: Int))
  Frame pose
    <$> number
    <*> pure (generate 16 16 (\x y -> fromIntegral (values !! (16 * y + x)) / 255))
    <*> pure taxelPitch
    <*> pure []
  where
    number = choose (-1e3, 1e3)

-- | The folder of frames of the standard sensor.
folderOf :: [Frame] -> Either String Folder
folderOf frames = do
  files <- first show (folderFiles Pgm standardTaxelGrid 8 frames)
  let (lists, images) = Map.partitionWithKey (\name _ -> name == manifestName) (Map.fromList files)
  entries <- traverse (first show . parseManifest) (Map.elems lists)
  pure (Folder (listing (concat entries)) images)

listed :: [FilePath] -> Manifest
listed names = listing [Entry name (Just (SensorPose 0 0 0)) (Just 1) | name <- names]

manifest :: [FilePath] -> Bytes.ByteString
manifest = renderManifest . manifestEntries . listed

flat :: Bytes.ByteString
flat = either (const Bytes.empty) (encodePgm Binary) (pgmFromIntensity 255 (constant 16 16 0))

preparedSpec :: Spec
preparedSpec = do
  it "by default frames are the folder's, along the axes that the manifest states" $
    forAll ((,) <$> elements (map snd axesNamed) <*> few genFrame) $ \(axes, frames) ->
      whenRight (folderOf frames) $ \folder ->
        preparedFrames asStated (alongTheirs axes folder)
          === Right [frame {framePose = alongAxes axes (framePose frame)} | frame <- frames]
  it "chosen axes and a chosen pitch replace those of the manifest" $
    forAll ((,) <$> elements (map snd axesNamed) <*> elements (map snd axesNamed)) $
      \(stated, chosen) -> forAll ((,) <$> choose (0.1, 5) <*> few genFrame) $
        \(taxel, frames) -> whenRight (folderOf frames) $ \folder ->
          preparedFrames
            asStated {preparedAxes = Just chosen, preparedTaxel = Just taxel}
            (alongTheirs stated folder)
            === Right
              [ frame {framePose = alongAxes chosen (framePose frame), frameTaxel = taxel}
                | frame <- frames
              ]
  it "frames are corrected by the calibration, which must have their size" $
    forAll genFrame $ \frame -> whenRight (folderOf [frame]) $ \folder -> do
      let known side =
            Calibration (constant side side 0.25) (constant side side 2) [(3, 4)]
          by side = asStated {preparedCalibration = Just (known side)}
      preparedFrames (by 16) folder
        === first CalibrationRefused (traverse (corrected (known 16)) [frame])
        .&&. preparedFrames (by 15) folder
        === Left (CalibrationRefused (SensorsDiffer (15, 15) (16, 16)))
  it "an element that reads full scale wherever the sensor is counts as dead" $ do
    let stuck k =
          Frame (SensorPose (12.7 * fromIntegral k) 0 0) 1 (generate 16 16 (value k)) taxelPitch []
        value :: Int -> Int -> Int -> Double
        value k x y
          | (x, y) == (5, 2) = 1
          | otherwise = if even (x + y + k) then 0.2 else 0
    folder <- right (folderOf (map stuck [0 .. 5]))
    fmap (map frameDead) (preparedFrames asStated folder) `shouldBe` Right (replicate 6 [(2, 5)])
    fmap (map frameDead) (folderFrames folder) `shouldBe` Right (replicate 6 [])
  it "registration assumes the stated errors, but at least a hundredth of a taxel" $
    forAll ((,) <$> few genFrame <*> choose (0.02, 3)) $ \(frames, sigma) -> do
      let told error' noise =
            registrationFor
              standardStitching {stitchingPositionError = Just error', stitchingNoise = Just noise}
              frames
          with error' noise =
            standardRegistration {registrationSigma = error', registrationNoise = noise}
          shown = frameNoise (map frameImage frames)
      conjoin
        [ told sigma 0.3 === with (Just sigma) 0.3,
          told 0 0 === with (Just 0.01) 0,
          told (-1) 0 === with (Just (-1)) 0,
          registrationFor standardStitching frames === with Nothing shown,
          registrationFor nominalStitching frames === standardRegistration
        ]
  where
    -- Too few frames for dead elements to be known.
    few gen = choose (1, 5) >>= (`vectorOf` gen)
    alongTheirs axes folder =
      folder {folderManifest = (folderManifest folder) {manifestAxes = Just axes}}

diskSpec :: Spec
diskSpec = do
  it "readFolder reads the manifest and the images that it names, and no others" $
    inFolder $ \folder -> do
      Bytes.writeFile (folder </> "a.pgm") flat
      Bytes.writeFile (folder </> "other.pgm") flat
      Bytes.writeFile (folder </> "manifest.csv") (manifest ["a.pgm", "../a.pgm"])
      readFolder folder
        `shouldReturn` Right (Folder (listed ["a.pgm", "../a.pgm"]) (Map.singleton "a.pgm" flat))
  it "written frames are read again, by either manifest; the one in JSON takes precedence" $
    withMaxSuccess 3 . forAllBlind (vectorOf 3 genFrame) $ \drawn ->
      ioProperty . inFolder $ \folder ->
        forM_ [(standardTaxelGrid, manifestName), (TaxelGrid 16 9 0.8, jsonManifestName)] $
          \(grid, name) -> do
            let cut = crop (0, 0) (taxelGridColumns grid, taxelGridRows grid) . frameImage
            images <- right (traverse cut drawn)
            let frames =
                  [ frame {frameImage = image, frameTaxel = taxelGridPitch grid}
                    | (frame, image) <- zip drawn images
                  ]
            files <- right (folderFiles Pgm grid 8 frames)
            map fst files `shouldContain` [name]
            forM_ files $ \(file, bytes) -> Bytes.writeFile (folder </> file) bytes
            found <- readFolder folder >>= right
            folderFrames found `shouldBe` Right frames
  it "images of more than 8 bits keep all grey values of the readings" $
    inFolder $ \folder -> do
      let frame = Frame (SensorPose 0 0 0) 1 (generate 16 16 (\x y -> level (x + y))) taxelPitch []
          level k = fromIntegral (135 * k) / 4095
      files <- right (folderFiles Pgm standardTaxelGrid 12 [frame])
      forM_ files $ \(file, bytes) -> Bytes.writeFile (folder </> file) bytes
      found <- readFolder folder >>= right
      folderFrames found `shouldBe` Right [frame]
  it "each missing or wrong part of a folder has its own error" $
    inFolder $ \folder -> do
      problem (readFolder folder) `shouldReturn` Just (NoManifest folder)
      let none = folder </> "none"
          (csv, json) = (folder </> "manifest.csv", folder </> "manifest.json")
      problem (readFolder none) `shouldReturn` Just (NoSuchFolder none)
      Bytes.writeFile csv (manifest ["a.pgm"])
      problem (readFolder folder) `shouldReturn` Just (NoSuchFile (folder </> "a.pgm"))
      problem (readFolder csv) `shouldReturn` Just (IsFile csv)
      createDirectory (folder </> "a.pgm")
      problem (readFolder folder) `shouldReturn` Just (IsFolder (folder </> "a.pgm"))
      problem (readImage (folder </> "a.pgm")) `shouldReturn` Just (IsFolder (folder </> "a.pgm"))
      Bytes.writeFile csv Bytes.empty
      problem (readFolder folder) `shouldReturn` Just (ManifestRefused csv EmptyManifest)
      Bytes.writeFile json Bytes.empty
      problem (readFolder folder)
        `shouldReturn` Just (JsonManifestRefused json (JsonRefused NoText))
  it "paths become sources: folders, images, and the frames of a folder together" $
    inFolder $ \folder -> do
      let inside name = folder </> name
          frames = inside "frames"
      createDirectory frames
      forM_ ["a.pgm", "b.pgm", "c.pgm", "other.pgm"] $ \name ->
        Bytes.writeFile (frames </> name) flat
      Bytes.writeFile (frames </> "manifest.csv") (manifest ["a.pgm", "b.pgm", "gone.pgm"])
      Bytes.writeFile (inside "image.pgm") flat
      found <-
        sourcePaths
          [ frames </> "b.pgm",
            inside "image.pgm",
            "-",
            frames,
            frames </> "other.pgm",
            frames </> "a.pgm"
          ]
      found
        `shouldBe` Right
          [ ImagePath (inside "image.pgm"),
            ImagePath "-",
            FolderPath frames,
            ImagePath (frames </> "other.pgm"),
            FramePaths frames ["b.pgm", "a.pgm"]
          ]
      -- In the manifest's order, whatever else it names.
      readSource (FramePaths frames ["b.pgm", "a.pgm"])
        `shouldReturn` Right
          ( FrameFolder
              (Folder (listed ["a.pgm", "b.pgm"]) (Map.fromList [("a.pgm", flat), ("b.pgm", flat)]))
          )
      readSource (ImagePath (inside "image.pgm")) `shouldReturn` Right (WholeImage flat)
      problem (sourcePaths [inside "image.pgm", inside "none"])
        `shouldReturn` Just (NoSuchPath (inside "none"))
      Bytes.writeFile (frames </> "manifest.json") Bytes.empty
      problem (sourcePaths [frames </> "c.pgm"])
        `shouldReturn` Just (JsonManifestRefused (frames </> "manifest.json") (JsonRefused NoText))
  it "a file or pipe, which has no size, is read if it is no longer than the limit" $
    inFolder $ \folder ->
      forM_ [0 .. 5] $ \size -> forM_ [0 .. 5] $ \limit -> do
        let bytes = Bytes.replicate size 80
            file = folder </> "some"
            isRead name =
              readUpTo limit name
                `shouldReturn` if size <= limit then Right bytes else Left (TooLarge name limit)
        Bytes.writeFile file bytes
        isRead file
        (out, into) <- createPipe
        written <- fdToHandle into
        Bytes.hPut written bytes >> hClose written
        isRead ("/dev/fd/" ++ show out) `finally` closeFd out
  it "a folder is read if its images together are no longer than the limit" $
    inFolder $ \folder -> do
      let inside name = folder </> name
          ofSize size name =
            withBinaryFile (inside name) WriteMode (`hSetFileSize` toInteger (size :: Int))
      Bytes.writeFile (inside "manifest.csv") (manifest ["a.pgm", "b.pgm", "c.pgm", "b.pgm"])
      forM_ [[a, b, c] | a <- [0 .. 4], b <- [0 .. 4], c <- [0, 3]] $ \sizes -> do
        zipWithM_ ofSize sizes ["a.pgm", "b.pgm", "c.pgm"]
        forM_ [0 .. 8] $ \limit -> do
          found <- problem (readFolderUpTo limit folder)
          (sizes, limit, found)
            `shouldBe` ( sizes,
                         limit,
                         case [i | i <- [1 .. 3], sum (take i sizes) > limit] of
                           [] -> Nothing
                           -- If those before it are empty, it is too long by itself.
                           i : _
                             | sum (take (i - 1) sizes) == 0 ->
                               Just (TooLarge (inside ["abc" !! (i - 1)] ++ ".pgm") limit)
                           _ -> Just (TooLarge folder limit)
                       )
      -- With the default limit: each of two images is below it.
      ofSize 1 "a.pgm" >> ofSize largestInput "b.pgm" >> ofSize 0 "c.pgm"
      problem (readFolder folder) `shouldReturn` Just (TooLarge folder largestInput)
  it "a file without permission is refused as NotPermitted, for any user" $
    inFolder $ \folder -> do
      let own = folder </> "own"
      Bytes.writeFile own (manifest [])
      setFileMode own 0
      -- A file that no one may read, not even the superuser.
      refused <-
        filterM
          (fmap (either isPermissionError (const False)) . tried)
          [own, "/proc/sys/vm/drop_caches"]
      if null refused
        then pendingWith "here every file may be read"
        else forM_ refused $ \file -> do
          problem (readUpTo 9 file) `shouldReturn` Just (NotPermitted file)
          problem (readImage file) `shouldReturn` Just (NotPermitted file)
  it "an image beyond the limit is not read" $
    inFolder $ \folder -> do
      Bytes.writeFile (folder </> "manifest.csv") (manifest ["a.pgm"])
      withBinaryFile (folder </> "a.pgm") WriteMode (`hSetFileSize` (toInteger largestInput + 1))
      problem (readFolder folder) `shouldReturn` Just (TooLarge (folder </> "a.pgm") largestInput)
      problem (readImage (folder </> "a.pgm"))
        `shouldReturn` Just (TooLarge (folder </> "a.pgm") largestInput)
  where
    tried :: FilePath -> IO (Either IOException ())
    tried file = try (withBinaryFile file ReadMode (const (pure ())))
    problem reading = either Just (const Nothing) <$> reading

decodeSpec :: Spec
decodeSpec = do
  it "the paper's worked example: (6, 5) at corner C2 of C1 C2 C3 C4" $ do
    folder <- readFolder "data/worked-example/frames" >>= either (fail . show) pure
    image <- readImage "data/worked-example/composite.pgm" >>= either (fail . show) pure
    let decodings =
          [ canonicalRecogniser >>= (`decodeFolder` folder),
            canonicalRecogniser >>= (`decodeImage` image)
          ]
    map (fmap place) decodings
      `shouldBe` replicate 2 (Right (Just (Position 6 5, "C1 C2 C3 C4", ["C2"], (25.4, 95.25))))
  it "half or double the size of objects, symbols and frames gives the same place at that size" $ do
    folder <- readFolder "data/worked-example/frames" >>= right
    paper <- right canonicalPlacement
    reader <- right (shippedReader 4)
    forM_ [1 / 2, 2] $ \size -> do
      let of' = fromRational size
          atSize =
            folder
              { folderManifest =
                  (folderManifest folder)
                    { manifestTaxel = Just (of' * taxelPitch),
                      manifestEntries = map longer (manifestEntries (folderManifest folder))
                    }
              }
          longer entry =
            entry
              { entryPose =
                  (\pose -> pose {poseX = of' * poseX pose, poseY = of' * poseY pose})
                    <$> entryPose entry
              }
      known <- right (someRecogniser canonicalProfile (scaledPlacement size paper) reader)
      frames <- right (folderFrames atSize)
      [place <$> decodeFolder known atSize, place <$> decodeFrames known frames]
        `shouldBe` replicate
          2
          (Right (Just (Position 6 5, "C1 C2 C3 C4", ["C2"], (of' * 25.4, of' * 95.25))))
      -- The numbers are the same in words.
      fmap (take 1 . drop 1 . summary) (decodeFolder known atSize)
        `shouldBe` Right
          [ printf
              "%.2f mm to the right of and %.2f mm below C1"
              (of' * 25.4 :: Double)
              (of' * 95.25 :: Double)
          ]
  it "a face felt by a sensor of half or double the pitch is found where it was pressed" $
    forM_ [(32, 0.79375), (8, 3.175)] $ \(side, taxel) ->
      inFolder $ \folder -> do
        layout <- right canonicalPlacement
        alphabet <- right paperAlphabet
        let sensor =
              (withTaxel taxel standardSensor)
                { sensorColumns = side,
                  sensorRows = side,
                  sensorNoise = 0.02
                }
            cube array = pressed (pressingWith sensor 7) alphabet array layout (ObjectName "cube")
        (frames, truth) <- right (withProfile canonicalProfile (const . cube)) >>= right
        files <- right (folderFiles Pgm (sensorTaxelGrid sensor) 8 frames)
        forM_ files $ \(name, bytes) -> Bytes.writeFile (folder </> name) bytes
        source <- FrameFolder <$> (readFolder folder >>= right)
        composite <- right (sourceComposite paperTables 1 asStated standardStitching source)
        recognition <-
          right (canonicalRecogniser >>= \known -> decodeSources standardDecoding known [source])
        map (compared layout truth) (claims composite recognition)
          `shouldSatisfy` \found -> not (null found) && all isRight found
  it "a flat image is refused; its summary is the refusal's name" $
    fmap summary (canonicalRecogniser >>= (`decodeImage` flat))
      `shouldBe` Right ["refused: no-symbols"]
  it "a malformed image, and a path that is no folder of frames, each have their own error" $ do
    errorOf (canonicalRecogniser >>= (`decodeImage` Bytes8.pack "P7"))
      `shouldBe` Just (FileRefused (NotPgm (Bytes8.pack "P7")))
    errorOf (canonicalRecogniser >>= (`decodeFolder` Folder (listed ["a.pgm"]) Map.empty))
      `shouldBe` Just (FolderRefused (ImageAbsent "a.pgm"))
    errorOf (canonicalRecogniser >>= (`decodeFrames` []))
      `shouldSatisfy` maybe False (isPrefixOf "FramesRefused" . show)
  where
    claims composite recognition =
      [ Claim
          { claimFace = placeFace on,
            claimSymmetry = foundOrientation found,
            claimPlace = spotMillimetres (placeCentre on),
            claimSeenAt = compositePosition composite (windowSeenAt (foundWindow found)),
            claimAngle = Nothing
          }
        | Right (Found found) <- [recognisedAnswer recognition],
          OnFace on <- [windowWhereabouts (foundWindow found)]
      ]
    place recognition = case recognisedAnswer recognition of
      Right (Found found)
        | OnFace on <- windowWhereabouts (foundWindow found) ->
          Just
            ( windowPosition (foundWindow found),
              faceText (faceName (placeFace on)),
              map vertexText (placeCorners on),
              spotMillimetres (placeCentre on)
            )
      _ -> Nothing
    errorOf = either Just (const Nothing)
