{-# LANGUAGE OverloadedStrings #-}

-- | @decode@ with damage, as scripts use it.
module Test.CommandLine.Decode (spec) where

import Data.Aeson
import qualified Data.ByteString as Bytes
import Data.Foldable (for_)
import Data.List (isInfixOf)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Text as Text
import PraTactile.Format (encodeCalibration)
import PraTactile.Image
import PraTactile.Image.Pgm
import PraTactile.Sensor.Calibration (Calibration (..))
import PraTactile.Symmetry
import System.FilePath ((</>))
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  it "however the image is turned, the place is the same" $
    inFolder $ \folder ->
      for_
        [(90, onRaster (turned 1)), (180, onRaster (turned 2)), (270, onRaster (turned 3))]
        $ \(degrees, turn) -> do
          changed folder turn
          (status, out, _) <- pra ["decode", "--json", folder </> "changed.pgm"]
          (status, key ["orientation_deg"] out, key ["position"] out)
            `shouldBe` (0, Just (Number degrees), Just workedCell)
          key ["place_mm"] out `shouldBe` Just (toJSON [25.4, 95.25 :: Double])
  it "a whole image of two pixels a taxel is read with its pitch, and lies where the other does" $
    inFolder $ \folder -> do
      changed folder doubled
      (_, whole, _) <- pra ["decode", "--json", worked]
      (blind, _, _) <- pra ["decode", "--json", folder </> "changed.pgm"]
      (status, out, _) <- pra ["decode", "--json", "--taxel", "0.79375", folder </> "changed.pgm"]
      (blind, status) `shouldBe` (1, 0)
      for_ [["position"], ["face"], ["place_mm"], ["orientation_deg"]] $ \path ->
        key path out `shouldBe` key path whole
      -- The upper left pixel is half as wide: its centre is a quarter of a taxel further out.
      for_ [0, 1] $ \axis -> case (robotAt axis out, robotAt axis whole) of
        (Just there, Just here) -> there - here `shouldSatisfy` near (1.5875 / 4)
        other -> expectationFailure (show other)
      writeImage folder (generate 600 600 (\_ _ -> 0))
      outcome <- pra ["decode", "--taxel", "50", folder </> "changed.pgm"]
      outcome `refuses` "is --taxel right?"
  it "a whole image is corrected by a calibration of its size, and one of another is refused" $
    inFolder $ \folder -> do
      image <- readImage worked
      let (w, h) = rasterSize image
          offset = generate w h (\u v -> if even (u + v) then 0.3 else 0)
          gain = generate w h (\u v -> if even (u `div` 3 + v) then 0.6 else 0.3)
          file = folder </> "calibration.json"
          everywhere side v = generate side side (\_ _ -> v)
      changed folder (\whole -> generate w h (\u v -> at offset u v + at gain u v * at whole u v))
      whenFull $ do
        (uncorrected, _, _) <- pra ["decode", "--json", folder </> "changed.pgm"]
        uncorrected `shouldBe` 1
      Bytes.writeFile file (encodeCalibration (Calibration offset gain []))
      (status, out, _) <-
        pra ["decode", "--json", "--calibration", file, folder </> "changed.pgm"]
      (status, key ["position"] out) `shouldBe` (0, Just workedCell)
      Bytes.writeFile file (encodeCalibration (Calibration (everywhere 16 0) (everywhere 16 1) []))
      outcome <- pra ["decode", "--calibration", file, worked]
      outcome `refuses` "the calibration is of a sensor of 16 x 16 taxels"
  it "a mirror image is refused as a mirror image" $
    inFolder $ \folder -> do
      changed folder (onRaster mirror)
      (status, out, _) <- pra ["decode", "--json", folder </> "changed.pgm"]
      (status, key ["outcome"] out, key ["reason"] out)
        `shouldBe` (1, Just "refused", Just "mirrored")
  it "3 x 3 symbols: one may be blotted out or wrong, and the answer names it" $
    inFolder $ \folder -> do
      (stitched, composite) <- cubeTop folder
      stitched `shouldBe` 0
      (status, whole, _) <- pra ["decode", "--json", composite]
      (status, key ["doubt"] whole >>= small, key ["wrong"] whole)
        `shouldBe` (0, Just True, Just (Number 0))
      let place out = [key ["object"] out, key ["face"] out, key ["outcome"] out]
      image <- readImage composite
      centres <- maybe (fail "no symbols") pure (key ["symbols"] whole >>= points)
      length centres `shouldSatisfy` (>= 9)
      for_ (zip [0 :: Int ..] (byEffort (take 1) id centres)) $ \(i, (x, y)) -> do
        -- Blotted out: as the flat face is.
        writeImage
          folder
          ( generate
              (rasterWidth image)
              (rasterHeight image)
              (\u v -> if inBox (x, y) u v then 0.05 else at image u v)
          )
        (blotted, out, _) <- pra ["decode", "--json", folder </> "changed.pgm"]
        (i, blotted, place out) `shouldBe` (i, 0, place whole)
        -- Upside down: an error that the others correct, if there is redundancy to spare.
        writeImage
          folder
          ( generate
              (rasterWidth image)
              (rasterHeight image)
              ( \u v ->
                  if inBox (x, y) u v
                    then at image (round (2 * x) - u) (round (2 * y) - v)
                    else at image u v
              )
          )
        (degrees, again, _) <- pra ["decode", "--json", folder </> "changed.pgm"]
        (i, degrees, place again, key ["wrong"] again)
          `shouldBe` (i, 0, place whole, Just (Number 1))
        (strict, refused, _) <- pra ["decode", "--json", "--radius", "0", folder </> "changed.pgm"]
        (i, strict, key ["reason"] refused) `shouldBe` (i, 1, Just "orientation-contradiction")
  it "two columns of a face, one column apart: each is too little, both together are enough" $
    inFolder $ \folder -> do
      for_ [("left" :: String, "0"), ("right", "50.8")] $ \(name, x) -> do
        (probed, _, _) <-
          pra
            [ "probe",
              "--object",
              "cube",
              "--face",
              "C1 C2 C3 C4",
              "--at",
              x ++ ",0",
              "--origin",
              x ++ ",0",
              "--upright",
              "--size",
              "16x52",
              "--seed",
              "3",
              "--output",
              folder </> name
            ]
        probed `shouldBe` 0
        (status, out, _) <- pra ["decode", "--json", folder </> name]
        (status, key ["reason"] out) `shouldBe` (1, Just "no-complete-window")
        (stitched, _, _) <- pra ["stitch", folder </> name, "--output", folder </> name ++ ".pgm"]
        stitched `shouldBe` 0
      (status, out, _) <-
        pra ["decode", "--json", "--together", folder </> "left", folder </> "right"]
      (status, key ["object"] out, key ["on"] out) `shouldBe` (0, Just "cube", Just "face")
      key ["sources"] out `shouldBe` Just (toJSON [folder </> "left", folder </> "right"])
      (images, placed, _) <-
        pra
          [ "decode",
            "--json",
            "--together",
            folder </> "left.pgm",
            folder </> "right.pgm",
            "--at",
            "0,0",
            "--at",
            "50.8,0"
          ]
      (images, key ["position"] placed) `shouldBe` (0, key ["position"] out)
      (misplaced, other, _) <-
        pra
          [ "decode",
            "--json",
            "--together",
            folder </> "left.pgm",
            folder </> "right.pgm",
            "--at",
            "0,0",
            "--at",
            "63.5,0"
          ]
      (misplaced, key ["outcome"] other) `shouldBe` (1, Just "refused")
  it "--doubt 0 gives no answer; --surface chooses the sheet or the torus" $ do
    (status, out, _) <- pra ["decode", "--json", "--doubt", "0", worked]
    (status, key ["reason"] out) `shouldBe` (1, Just "below-threshold")
    (sheet, onSheet, _) <- pra ["decode", "--json", "--surface", "sheet", worked]
    (sheet, key ["position"] onSheet) `shouldBe` (0, Just workedCell)
  it "frames without a manifest: one line says what is missing" $
    inFolder $ \folder -> do
      let copied = folder </> "frame_000.pgm"
      Bytes.readFile "data/worked-example/frames/frame_000.pgm" >>= Bytes.writeFile copied
      complains ["decode", folder] "holds no manifest.csv"
      complains ["stitch", folder, "--output", folder </> "out.pgm"] "holds no manifest.csv"
      complains ["stitch", copied, "--output", folder </> "out.pgm"] "is a file; a folder of frames"
      complains ["stitch", folder </> "none", "--output", folder </> "out.pgm"] "there is no folder"
      (status, out, err) <- pra ["decode", "--json", copied]
      (status, key ["reason"] out, length (lines err)) `shouldBe` (1, Just "no-symbols", 1)
      err
        `shouldSatisfy` ( (folder ++ " holds no manifest.csv for an image of 16 x 16 taxels")
                            `isInfixOf`
                        )
      (_, _, silent) <- pra ["decode", "--json", worked]
      silent `shouldBe` ""
  it "bad input: one line, status 2" $ do
    complains ["decode", "--doubt", "1", worked] "--doubt"
    complains ["decode", "--at", "0,0", worked] "--together"
    complains ["decode", "--together", worked, worked, "--at", "0,0"] "--at is given 1 times"
    (status, out, err) <- pra ["decode", "--together", worked, "--at", "here"]
    (status, out) `shouldBe` (2, "")
    err `shouldSatisfy` (not . null)
  where
    worked = "data/worked-example/composite.pgm"
    workedCell = object ["row" .= (6 :: Int), "column" .= (5 :: Int)]
    changed folder f = readImage worked >>= writeImage folder . f
    readImage file = Bytes.readFile file >>= either (fail . show) (pure . pgmIntensity) . decodePgm
    writeImage folder image =
      either
        (fail . show)
        (Bytes.writeFile (folder </> "changed.pgm") . encodePgm Binary)
        (pgmFromIntensity 255 image)
    at image u v = fromMaybe 0 (index image u v)
    doubled image =
      generate
        (2 * rasterWidth image)
        (2 * rasterHeight image)
        (\u v -> at image (u `div` 2) (v `div` 2))
    near expected found = abs (found - expected) < (1e-6 :: Double)
    robotAt :: Int -> String -> Maybe Double
    robotAt axis out = case fromJSON <$> key ["robot_mm"] out of
      Just (Success place) -> listToMaybe (drop axis place)
      _ -> Nothing
    inBox (x, y) u v =
      abs (fromIntegral (u :: Int) - x) < 5.5 && abs (fromIntegral (v :: Int) - y) < (7.5 :: Double)
    cubeTop folder = do
      _ <-
        pra
          [ "probe",
            "--object",
            "cube",
            "--face",
            "C1 C2 C3 C4",
            "--at",
            "12.7,0",
            "--upright",
            "--size",
            "56x72",
            "--seed",
            "7",
            -- Frames that lie where they are said to lie make the composite as they are.
            "--position-error",
            byEffort "0" "1",
            "--output",
            folder </> "frames"
          ]
      (status, _, _) <-
        pra
          ( ["stitch", folder </> "frames", "--output", folder </> "composite.pgm", "--method"]
              ++ [byEffort "nominal" "auto"]
          )
      pure (status, folder </> "composite.pgm")
    small v = case fromJSON v of
      Success doubt -> Just (doubt < (1e-6 :: Double))
      Error _ -> Nothing
    points v = case fromJSON v of
      Success symbols -> traverse (\s -> (,) <$> number "x" s <*> number "y" s) (symbols :: [Value])
      Error _ -> Nothing
    number :: Text.Text -> Value -> Maybe Double
    number name v =
      key' name v >>= \found -> case fromJSON found of
        Success x -> Just x
        Error _ -> Nothing
    key' name v = case fromJSON v of
      Success o -> Map.lookup name (o :: Map.Map Text.Text Value)
      Error _ -> Nothing
