-- | From bytes to frames and recognition, and the reading of folders.
module Test.Source (spec) where

import Control.Exception (IOException, try)
import Control.Monad (filterM, forM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.List (isPrefixOf)
import qualified Data.Map.Strict as Map
import PraTactile
import PraTactile.Files
import PraTactile.Image (constant, generate)
import PraTactile.Image.Error (ImageError (..))
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, pgmFromIntensity)
import PraTactile.Object.Placement (Face (..), spotMillimetres)
import PraTactile.Object.WingedEdge (faceText, vertexText)
import PraTactile.Recognise (ReadWindow (..))
import PraTactile.Sensor.Frame (taxelPitch)
import PraTactile.Sensor.Manifest (ManifestError (..))
import PraTactile.Source
import System.Directory (createDirectory)
import System.FilePath ((</>))
import System.IO (IOMode (..), hSetFileSize, withBinaryFile)
import System.IO.Error (isPermissionError)
import System.Posix.Files (setFileMode)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Support

spec :: Spec
spec = do
  describe "a folder as bytes" bytesSpec
  describe "a folder on disk" diskSpec
  describe "decoding" decodeSpec

bytesSpec :: Spec
bytesSpec = do
  it "the frames of the folder of frames are those frames" $
    property $
      forAll (listOf1 frame) $ \frames ->
        fmap folderFrames (framesFolder frames) === Right (Right frames)
  it "chosen frames do not need the images of the others" $
    fmap
      length
      ( chosenFrames
          (== "b.pgm")
          (Folder (manifest ["a.pgm", "b.pgm"]) (Map.singleton "b.pgm" flat))
      )
      `shouldBe` Right 1
  it "a name that leads out of the folder is refused, even if there are bytes for it" $
    [folderFrames (Folder (manifest [name]) (Map.singleton name flat)) | name <- elsewhere]
      `shouldBe` map (Left . ImageElsewhere) elsewhere
  it "an image that is not there, or none, is refused by its name; so is a manifest" $ do
    folderFrames (Folder (manifest ["a.pgm"]) Map.empty) `shouldBe` Left (ImageAbsent "a.pgm")
    folderFrames (Folder (manifest ["a.pgm"]) (Map.singleton "a.pgm" (Bytes8.pack "P6")))
      `shouldBe` Left (ImageRefused "a.pgm" (NotPgm (Bytes8.pack "P6")))
    folderFrames (Folder Bytes.empty Map.empty) `shouldBe` Left (ManifestRefused EmptyManifest)
  it "the images to be read are those in the folder, each once" $ do
    namedImages (manifest (["b.pgm", "sub/a.pgm", "b.pgm"] ++ elsewhere))
      `shouldBe` ["b.pgm", "sub/a.pgm"]
    namedImages (Bytes8.pack "no manifest") `shouldBe` []
  where
    elsewhere = ["../a.pgm", "/a.pgm", "sub/../../a.pgm"]
    frame = do
      pose <- Pose <$> number <*> number <*> elements [0, 90, 180, 270]
      -- Steps of 1/255 pass through an 8-bit image unchanged.
      values <- vectorOf 256 (choose (0, 255 :: Int))
      Frame pose
        <$> number
        <*> pure (generate 16 16 (\x y -> fromIntegral (values !! (16 * y + x)) / 255))
        <*> pure taxelPitch
        <*> pure []
    number = choose (-1e3, 1e3)

manifest :: [FilePath] -> Bytes.ByteString
manifest names =
  Bytes8.pack
    (unlines ("file,x_mm,y_mm,rotation_deg,force_n" : [name ++ ",0,0,0,1" | name <- names]))

flat :: Bytes.ByteString
flat = either (const Bytes.empty) (encodePgm Binary) (pgmFromIntensity 255 (constant 16 16 0))

diskSpec :: Spec
diskSpec = do
  it "the manifest and the images that it names, and no others" $
    inFolder $ \folder -> do
      Bytes.writeFile (folder </> "a.pgm") flat
      Bytes.writeFile (folder </> "other.pgm") flat
      Bytes.writeFile (folder </> "manifest.csv") (manifest ["a.pgm", "../a.pgm"])
      readFolder folder
        `shouldReturn` Right
          (Folder (manifest ["a.pgm", "../a.pgm"]) (Map.singleton "a.pgm" flat))
      readChosen (const False) folder >>= (`shouldBe` Right Map.empty) . fmap folderImages
  it "each thing that is missing or wrong is told apart" $
    inFolder $ \folder -> do
      problem (readFolder folder) `shouldReturn` Just (NoManifest folder)
      let none = folder </> "none"
      problem (readFolder none) `shouldReturn` Just (NoSuchFolder none)
      Bytes.writeFile (folder </> "manifest.csv") (manifest ["a.pgm"])
      problem (readFolder folder) `shouldReturn` Just (NoSuchFile (folder </> "a.pgm"))
      problem (readFolder (folder </> "manifest.csv"))
        `shouldReturn` Just (IsFile (folder </> "manifest.csv"))
      createDirectory (folder </> "a.pgm")
      problem (readFolder folder) `shouldReturn` Just (IsFolder (folder </> "a.pgm"))
      problem (readImage (folder </> "a.pgm")) `shouldReturn` Just (IsFolder (folder </> "a.pgm"))
  it "a file is read if it is no longer than the limit" $
    inFolder $ \folder ->
      forM_ [0 .. 5] $ \size -> forM_ [0 .. 5] $ \limit -> do
        let bytes = Bytes.replicate size 80
            file = folder </> "some"
        Bytes.writeFile file bytes
        readUpTo limit file
          `shouldReturn` if size <= limit then Right bytes else Left (TooLarge file limit)
  it "a file that may not be read is not permitted, whoever asks" $
    inFolder $ \folder -> do
      let own = folder </> "own"
      Bytes.writeFile own (manifest [])
      setFileMode own 0
      -- What no one may read, the superuser neither.
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
          [ canonicalDecoder >>= (`decodeFolder` folder),
            canonicalDecoder >>= (`decodeImage` image)
          ]
    map (fmap place) decodings
      `shouldBe` replicate 2 (Right (Just (Position 6 5, "C1 C2 C3 C4", ["C2"], (25.4, 95.25))))
  it "a flat image is refused; its summary is the refusal's name" $
    fmap summary (canonicalDecoder >>= (`decodeImage` flat))
      `shouldBe` Right ["refused: no-symbols"]
  it "what is no image, and no folder of frames, is an error of its own" $ do
    errorOf (canonicalDecoder >>= (`decodeImage` Bytes8.pack "P7"))
      `shouldBe` Just (FileRefused (NotPgm (Bytes8.pack "P7")))
    errorOf (canonicalDecoder >>= (`decodeFolder` Folder Bytes.empty Map.empty))
      `shouldBe` Just (FolderRefused (ManifestRefused EmptyManifest))
    errorOf (canonicalDecoder >>= (`decodeFrames` []))
      `shouldSatisfy` maybe False (isPrefixOf "FramesRefused" . show)
  where
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
