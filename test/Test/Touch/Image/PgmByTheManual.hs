{-# LANGUAGE OverloadedStrings #-}

-- | Tests the statements and examples of the netpbm manual's pgm(5), and files whose headers would
-- cost much memory if they were believed. The laws are in "Test.Touch.Image.PgmLaws".
module Test.Touch.Image.PgmByTheManual (spec) where

import Codec.Picture (Image (..))
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Data.Either (isLeft)
import Data.Maybe (isJust)
import qualified Data.Vector.Storable as V
import Data.Word (Word16)
import PraTactile.Image.Pgm
import Test.Hspec

spec :: Spec
spec = do
  describe "Reading by the manual" manual
  describe "Headers" headers
  describe "Refusals" refusals

-- | The example of pgm(5).
feep :: ByteString
feep =
  "P2\n# feep.pgm\n24 7\n15\n\
  \0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0\n\
  \0  3  3  3  3  0  0  7  7  7  7  0  0 11 11 11 11  0  0 15 15 15 15  0\n\
  \0  3  0  0  0  0  0  7  0  0  0  0  0 11  0  0  0  0  0 15  0  0 15  0\n\
  \0  3  3  3  0  0  0  7  7  7  0  0  0 11 11 11  0  0  0 15 15 15 15  0\n\
  \0  3  0  0  0  0  0  7  0  0  0  0  0 11  0  0  0  0  0 15  0  0  0  0\n\
  \0  3  0  0  0  0  0  7  7  7  7  0  0 11 11 11 11  0  0 15  0  0  0  0\n\
  \0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0\n"

manual :: Spec
manual = do
  it "reads pgm(5)'s feep example" $ do
    let size pgm = (pgmWidth pgm, pgmHeight pgm, pgmMaxval pgm)
    size <$> decodePgm feep `shouldBe` Right (24, 7, 15)
    samples <$> decodePgm feep
      `shouldBe` Right (map (read . C.unpack) (concatMap C.words (drop 4 (C.lines feep))))
  it "reads two bytes for each sample, the more significant first, if the maximum is above 255" $
    samples <$> decodePgm (B.concat ["P5 2 1 256\n", B.pack [1, 0, 0, 255]])
      `shouldBe` Right [256, 255]
  it "reads one byte for each sample up to a maximum value of 255" $
    samples <$> decodePgm (B.concat ["P5 2 1 255\n", B.pack [255, 10]]) `shouldBe` Right [255, 10]
  it "takes a sample for a sample even if it is a byte of white space" $
    samples <$> decodePgm "P5 3 1 255\n\n #" `shouldBe` Right [10, 32, 35]

samples :: Pgm -> [Word16]
samples (Pgm8 _ image) = map fromIntegral (V.toList (imageData image))
samples (Pgm16 _ image) = V.toList (imageData image)

headers :: Spec
headers = do
  it "takes each single white space after a raw file's maximum value, and only one" $
    [samples <$> decodePgm (B.concat ["P5 1 1 255", w, "a"]) | w <- [" ", "\t", "\n", "\r"]]
      `shouldBe` replicate 4 (Right [97])
  it "takes a comment after the maximum value, with its line end, for white space" $
    samples <$> decodePgm "P5 1 1 255# a comment\na" `shouldBe` Right [97]
  it "takes all after a blank after the maximum value for the image, comment or not" $
    samples <$> decodePgm "P5 1 1 255 #" `shouldBe` Right [35]
  it "takes numbers with leading zeros" $
    samples
      <$> decodePgm
        (B.concat ["P2 ", C.replicate 50 '0', "1 01 0009 00000000000000000000000000005"])
      `shouldBe` Right [5]
  it "allows white space after the image, and nothing else" $ do
    samples <$> decodePgm "P5 1 1 255\na \n\r\t" `shouldBe` Right [97]
    decodePgm "P5 1 1 255\nab" `shouldBe` Left (TrailingData 1)

refusals :: Spec
refusals = do
  it "names a file that is no PGM by its first bytes" $ do
    let png = B.concat [B.pack [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10], "rest"]
    decodePgm png `shouldBe` Left (NotPgm (B.take 8 png))
    formatName png `shouldBe` Just "PNG"
    decodePgm "" `shouldBe` Left (NotPgm "")
    decodePgm "P6 1 1 255\nabc" `shouldBe` Left (NotPgm "P6 1 1 2")
    formatName "P6 1 1 255\n" `shouldBe` Just "PPM"
    decodePgm "P52 1 255\nab" `shouldBe` Left (NotPgm "P52 1 25")
    filter (isJust . formatName) ["", "P2 ", "P5\n", "hello"] `shouldBe` []
  it "refuses a header of too many pixels before it takes memory for them" $ do
    decodePgm "P5 1000000000 1000000000 255\n"
      `shouldBe` Left (TooManyPixels 1000000000 1000000000)
    decodePgm "P2 4294967296 4294967296 255\n0"
      `shouldBe` Left (TooManyPixels 4294967296 4294967296)
    decodePgm (B.concat ["P5 ", C.replicate 1000000 '7', " 1 255\n"]) `shouldSatisfy` isLeft
    decodePgm (C.pack ("P5 " ++ show maxPixels ++ " 2 255\n"))
      `shouldBe` Left (TooManyPixels (fromIntegral maxPixels) 2)
  it "believes a header within the bound only as far as the file goes" $ do
    decodePgm (C.pack ("P5 " ++ show maxPixels ++ " 1 255\nabc"))
      `shouldBe` Left (Truncated maxPixels 3)
    decodePgm (C.pack ("P2 " ++ show maxPixels ++ " 1 255\n1 2 3"))
      `shouldBe` Left (Truncated maxPixels 3)
  it "names the number or the sample that is wrong, however long it is" $ do
    decodePgm (B.concat ["P5 1 1 ", C.replicate 1000000 '9', "\na"]) `shouldSatisfy` isLeft
    decodePgm (B.concat ["P2 1 1 9 ", C.replicate 100000 '9']) `shouldSatisfy` isLeft
    decodePgm "P2 2 2 9 1 2 3 10" `shouldBe` Left (SampleAboveMaxval (1, 1) 10 9)
    decodePgm "P2 2 2 9 1 2 x 4" `shouldBe` Left (BadSample 2 "x 4")
