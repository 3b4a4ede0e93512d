{-# LANGUAGE OverloadedStrings #-}

-- | Frames in other forms than PGM, movies, and what is said about their readings.
module Test.CommandLine.Images (spec) where

import Control.Monad (forM)
import Data.Aeson (Value (..))
import qualified Data.ByteString as Bytes
import Data.Foldable (for_)
import Data.List (intercalate, isInfixOf, isPrefixOf)
import System.Directory (listDirectory, removeFile)
import System.FilePath ((</>))
import Test.CommandLine.Run
import Test.Hspec hiding (before)
import Test.Support

spec :: Spec
spec = do
  it "a press is decoded alike from every file format" $
    inFolder $ \folder -> do
      answers <- forM ["pgm", "png", "npy"] $ \form -> do
        let frames = folder </> form
        (0, _, "") <- pra (pressing ++ ["--format", form, "--output", frames])
        files <- listDirectory frames
        length (filter (("." ++ form) `isInfixOf`) files) `shouldBe` length files - 1
        answered frames
      for_ answers (`shouldBe` head answers)
      -- 12 bits: PNG and .npy have no full scale of 4095, and the manifest tells it.
      (0, constants, "") <- pra (words "sensor --preset real --json")
      let (begin, named) = breakOn "\"adc_bits\"" constants
          (name, bits) = breakOn "\"value\":8" named
      writeFile (folder </> "deep.json") (begin ++ name ++ "\"value\":12" ++ drop 9 bits)
      deep <- forM ["pgm", "png", "npy"] $ \form -> do
        let frames = folder </> ("deep-" ++ form)
        (0, _, "") <-
          pra
            ( pressing
                ++ ["--sensor", folder </> "deep.json", "--format", form, "--output", frames]
            )
        answered frames
      for_ deep (`shouldBe` head deep)
  it "a movie with its poses is the folder of its frames" $
    inFolder $ \folder -> do
      let frames = "data/worked-example/frames"
          movie = folder </> "movie"
          poses = folder </> "poses.csv"
          told = folder </> "told.csv"
      rows <- map fields . drop 1 . lines <$> readFile (frames </> "manifest.csv")
      Bytes.writeFile movie . Bytes.concat =<< mapM (Bytes.readFile . (frames </>) . head) rows
      writeFile poses (unlines ("x_mm,y_mm,rotation_deg" : map posed rows))
      writeFile told (unlines (map posed rows))
      let (status, expected, _) = workedExample
      for_ [poses, told] $ \file -> do
        (found, out, err) <- pra ["decode", "--json", "--poses", file, movie]
        (found, err) `shouldBe` (status, "")
        (key ["message"] out, key ["support"] out)
          `shouldBe` (key ["message"] expected, key ["support"] expected)
      -- In a manifest.
      writeFile (folder </> "manifest.csv") . unlines $
        "file,x_mm,y_mm,rotation_deg" :
          ["movie#" ++ show i ++ "," ++ posed row | (i, row) <- zip [0 :: Int ..] rows]
      for_ [folder, movie] $ \source -> do
        (_, out, err) <- pra ["decode", "--json", source]
        (source, key ["message"] out, err) `shouldBe` (source, key ["message"] expected, "")
      writeFile (folder </> "manifest.csv") "file,x_mm,y_mm\nmovie#99,0,0\n"
      complains ["decode", folder] "there is no frame #99; the file has"
      writeFile poses "x_mm,y_mm\n1,2\n"
      complains ["stitch", "--json", "--poses", poses, movie] "there are 1 poses, and the movie has"
      complains ["decode", "--poses", poses, movie, movie] "--poses is of one movie"
      removeFile (folder </> "manifest.csv")
      complains ["segment", movie] "a movie of"
      complains ["decode", "--poses", "README.md", movie] "the first line is"
  it "converted frames are decoded as the originals" $
    inFolder $ \folder -> do
      (0, _, "") <- pra (pressing ++ ["--format", "npy", "--output", folder </> "npy"])
      (0, said, "") <- pra ["convert", folder </> "npy", "--output", folder </> "pgm"]
      said `shouldSatisfy` ("wrote " `isInfixOf`)
      before <- answered (folder </> "npy")
      answered (folder </> "pgm") `shouldReturn` before
      complains ["convert", folder </> "npy", "--output", folder </> "pgm"] "is not empty"
  it "readings above full scale, and missing readings, are reported" $
    inFolder $ \folder -> do
      let image = folder </> "image.csv"
      writeFile image (unlines (replicate 40 (unwords (replicate 30 "0.1" ++ ["40", "nan"]))))
      (_, _, err) <- pra ["segment", image]
      err `shouldSatisfy` ("40 of 1280 readings are above full scale" `isInfixOf`)
      (_, _, quiet) <- pra ["segment", image, "--full-scale", "50"]
      quiet `shouldBe` ""
      (0, said, "") <- pra ["convert", image, "--output", folder </> "out"]
      said `shouldSatisfy` ("40 taxels without a reading are the mean of" `isInfixOf`)
      said `shouldSatisfy` ("40 readings above full scale count as that" `isInfixOf`)
      complains ["segment", image, "--full-scale", "0"] "the reading of full contact"
  it "the taxels' distance is the file's, unless --taxel states another" $
    inFolder $ \folder -> do
      let press = folder </> "press.asf"
      writeFile press (unlines (header ++ ["Frame 1"] ++ replicate 4 "0,1,2,3" ++ ["@@"]))
      (0, _, "") <- pra ["convert", press, "--output", folder </> "out"]
      manifest <- readFile (folder </> "out" </> "manifest.json")
      key ["taxel_mm"] manifest `shouldBe` Just (Number 1.25)
      (0, _, "") <- pra ["convert", press, "--taxel", "2", "--output", folder </> "said"]
      other <- readFile (folder </> "said" </> "manifest.json")
      key ["taxel_mm"] other `shouldBe` Just (Number 2)
  where
    posed = intercalate "," . take 3 . drop 1
    pressing = words "probe --object cube --seed 7"
    answered frames = do
      (_, out, err) <- pra ["decode", "--json", frames]
      err `shouldBe` ""
      pure (map (`key` out) [["message"], ["support"], ["doubt"], ["pose"]])
    breakOn mark text
      | mark `isPrefixOf` text || null text = ([], text)
      | otherwise = let (begin, end) = breakOn mark (drop 1 text) in (take 1 text ++ begin, end)
    fields = words . map (\c -> if c == ',' then ' ' else c)
    header =
      [ "ROWS 4",
        "COLS 4",
        "ROW_SPACING 1.25 mm",
        "COL_SPACING 1.25 mm",
        "UNITS RAW",
        "START_FRAME 1",
        "END_FRAME 1",
        "ASCII_DATA @@"
      ]
