{-# LANGUAGE OverloadedStrings #-}

-- | PGM files, against the netpbm manual's pgm(5).
module Test.Touch.Image.PgmByTheManual (spec) where

import Codec.Picture (DynamicImage (..), Image (..), decodePng)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.Either (isLeft)
import Data.Maybe (isJust)
import qualified Data.Vector.Storable as V
import Data.Word (Word16)
import PraTactile.Image (constant, generate, toRows)
import PraTactile.Image.Pgm
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRaster)

spec :: Spec
spec = do
  describe "Reading what the manual shows" manual
  describe "Round trips" roundTrips
  describe "Headers" headers
  describe "Refusals" refusals
  describe "Intensities" intensities

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
  it "reads pgm(5)'s feep example" $
    case decodePgm feep of
      Right pgm@(Pgm8 15 image) -> do
        (pgmWidth pgm, pgmHeight pgm) `shouldBe` (24, 7)
        V.toList (V.slice 24 24 (imageData image))
          `shouldBe` [ 0,
                       3,
                       3,
                       3,
                       3,
                       0,
                       0,
                       7,
                       7,
                       7,
                       7,
                       0,
                       0,
                       11,
                       11,
                       11,
                       11,
                       0,
                       0,
                       15,
                       15,
                       15,
                       15,
                       0
                     ]
      other -> expectationFailure (show other)
  it "reads two bytes a sample, the more significant first, when the maximum value is above 255" $
    samples <$> decodePgm (B.concat ["P5 2 1 256\n", B.pack [1, 0, 0, 255]])
      `shouldBe` Right [256, 255]
  it "reads one byte a sample up to a maximum value of 255" $
    samples <$> decodePgm (B.concat ["P5 2 1 255\n", B.pack [255, 10]]) `shouldBe` Right [255, 10]
  it "takes a sample that is a white space's byte for a sample" $
    samples <$> decodePgm "P5 3 1 255\n\n #" `shouldBe` Right [10, 32, 35]

samples :: Pgm -> [Word16]
samples (Pgm8 _ image) = map fromIntegral (V.toList (imageData image))
samples (Pgm16 _ image) = V.toList (imageData image)

genPgm :: Gen Pgm
genPgm = do
  w <- choose (1, 9)
  h <- choose (1, 9)
  m <- oneof [choose (1, 255), choose (256, 65535), elements [1, 255, 256, 65535]]
  values <- vectorOf (w * h) (choose (0, m))
  let built
        | m < 256 = pgm8 (fromIntegral m) (Image w h (V.fromList (map fromIntegral values)))
        | otherwise = pgm16 m (Image w h (V.fromList values))
  either (\e -> error ("the generator made no PGM: " ++ show e)) pure built

roundTrips :: Spec
roundTrips = do
  it "decodePgm (encodePgm format p) = p" $
    forAll ((,) <$> elements [Plain, Binary] <*> genPgm) $ \(format, p) ->
      decodePgm (encodePgm format p) === Right p
  it "no line of a plain file is longer than 70 characters" $
    forAll genPgm $ \p -> all ((<= 70) . B.length) (C.lines (encodePgm Plain p))
  it "every proper prefix of a raw file is refused" $
    forAll genPgm $ \p ->
      let file =
            encodePgm Binary p
       in all (isLeft . decodePgm . (`B.take` file)) [0 .. B.length file - 1]
  it "every prefix of a plain file that ends before the last sample is refused" $
    forAll genPgm $ \p ->
      let file = encodePgm Plain p
          end =
            B.length (C.dropWhileEnd (`notElem` (" \n" :: String)) (C.dropWhileEnd (== '\n') file))
       in all (isLeft . decodePgm . (`B.take` file)) [0 .. end]
  it "any bytes after a magic are answered, and what is accepted keeps its promises" $
    forAll
      ((,) <$> elements ["P2", "P5", "P5 2 2 255 ", "P2 2 2 9\n", ""] <*> (B.pack <$> arbitrary))
      $ \(magic, rest) ->
        case decodePgm (magic <> rest) of
          Left _ -> True
          Right p ->
            pgmWidth p * pgmHeight p == length (samples p)
              && all ((<= pgmMaxval p) . fromIntegral) (samples p)

headers :: Spec
headers = do
  it "takes any run of blanks, tabs, line ends and comments for white space" $
    forAll (vectorOf 3 gap) $ \gaps ->
      case gaps of
        [a, b, c] ->
          ( fmap samples (decodePgm (B.concat ["P5", a, "2", b, "1", c, "255\n", "ab"]))
              === Right [97, 98]
          )
            .&&. ( fmap
                     samples
                     (decodePgm (B.concat ["P2", a, "2", b, "1", c, "255", a, "7", b, "8", c]))
                     === Right [7, 8]
                 )
        _ -> property False
  it "takes each single white space after a raw file's maximum value, and only one" $
    [samples <$> decodePgm (B.concat ["P5 1 1 255", w, "a"]) | w <- [" ", "\t", "\n", "\r"]]
      `shouldBe` replicate 4 (Right [97])
  it "takes a comment after the maximum value, with its line end, for white space" $
    samples <$> decodePgm "P5 1 1 255# a comment\na" `shouldBe` Right [97]
  it "takes what follows a blank after the maximum value for the image, comment or not" $
    samples <$> decodePgm "P5 1 1 255 #" `shouldBe` Right [35]
  it "takes numbers with leading zeros" $
    samples
      <$> decodePgm
        (B.concat ["P2 ", C.replicate 50 '0', "1 01 0009 00000000000000000000000000005"])
      `shouldBe` Right [5]
  it "allows white space after the image, and nothing else" $ do
    samples <$> decodePgm "P5 1 1 255\na \n\r\t" `shouldBe` Right [97]
    decodePgm "P5 1 1 255\nab" `shouldBe` Left (TrailingData 1)
    decodePgm "P2 1 1 255\n7 8" `shouldBe` Left (TrailingData 1)
  where
    gap = B.concat <$> ((:) <$> piece <*> listOf piece)
    piece = elements [" ", "\t", "\n", "\r", "\r\n", "# a comment 12 P5\n", "#\n", "# ## \r"]

refusals :: Spec
refusals = do
  it "names what is no PGM by its first bytes" $ do
    let png = B.concat [B.pack [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10], "rest"]
    decodePgm png `shouldBe` Left (NotPgm (B.take 8 png))
    formatName png `shouldBe` Just "PNG"
    decodePgm "" `shouldBe` Left (NotPgm "")
    decodePgm "P6 1 1 255\nabc" `shouldBe` Left (NotPgm "P6 1 1 2")
    formatName "P6 1 1 255\n" `shouldBe` Just "PPM"
    decodePgm "P52 1 255\nab" `shouldBe` Left (NotPgm "P52 1 25")
    filter (isJust . formatName) ["", "P2 ", "P5\n", "hello"] `shouldBe` []
  it "names the header's number that is wrong" $ do
    decodePgm "P5" `shouldBe` Left (BadHeader HeaderWidth "")
    decodePgm "P5 -1 2 255\n" `shouldBe` Left (BadHeader HeaderWidth "-1 2 255")
    decodePgm "P2 3 # 4" `shouldBe` Left (BadHeader HeaderHeight "")
    decodePgm "P2 3 4x 9" `shouldBe` Left (BadHeader HeaderHeight "4x 9")
    decodePgm "P2 3 4 1.5" `shouldBe` Left (BadHeader HeaderMaxval "1.5")
  it "refuses a maximum value outside 1 to 65535" $ do
    decodePgm "P5 1 1 0\na" `shouldBe` Left (MaxvalOutOfRange 0)
    decodePgm "P5 1 1 65536\nabcd" `shouldBe` Left (MaxvalOutOfRange 65536)
    decodePgm (B.concat ["P5 1 1 ", C.replicate 1000000 '9', "\na"]) `shouldSatisfy` isLeft
  it "refuses an empty image" $ do
    decodePgm "P5 0 3 255\n" `shouldBe` Left (ZeroSize 0 3)
    decodePgm "P2 3 0 255\n" `shouldBe` Left (ZeroSize 3 0)
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
  it "counts the whole samples of a truncated file" $ do
    decodePgm "P5 2 1 256\n\0\1\0" `shouldBe` Left (Truncated 2 1)
    decodePgm "P2 3 1 9 1  2  " `shouldBe` Left (Truncated 3 2)
    decodePgm "P5 1 1 9" `shouldBe` Left (Truncated 1 0)
  it "names the sample that is above the maximum value" $ do
    decodePgm "P2 2 2 9 1 2 3 10" `shouldBe` Left (SampleAboveMaxval (1, 1) 10 9)
    decodePgm "P5 2 1 9\n\9\10" `shouldBe` Left (SampleAboveMaxval (1, 0) 10 9)
    decodePgm (B.concat ["P2 1 1 9 ", C.replicate 100000 '9']) `shouldSatisfy` isLeft
  it "names the plain sample that is no number" $
    decodePgm "P2 2 2 9 1 2 x 4" `shouldBe` Left (BadSample 2 "x 4")
  it "builds no PGM from an image that breaks the rules" $ do
    pgm8 0 (Image 1 1 (V.fromList [0])) `shouldBe` Left (MaxvalOutOfRange 0)
    pgm8 9 (Image 2 1 (V.fromList [9, 10])) `shouldBe` Left (SampleAboveMaxval (1, 0) 10 9)
    pgm8 9 (Image 2 2 (V.fromList [9, 9])) `shouldBe` Left (WrongValueCount 2 2 2)
    pgm8 9 (Image 0 2 V.empty) `shouldBe` Left (ZeroSize 0 2)
    pgm16 255 (Image 1 1 (V.fromList [0])) `shouldBe` Left (MaxvalOutOfRange 255)

intensities :: Spec
intensities = do
  it "pgmFromIntensity maxval (pgmIntensity p) = p" $
    forAll genPgm $ \p -> pgmFromIntensity (fromIntegral (pgmMaxval p)) (pgmIntensity p) === Right p
  it "all 65536 samples of the largest maximum value survive" $
    fmap
      samples
      (pgmFromIntensity 65535 (generate 256 256 (\x y -> fromIntegral (256 * y + x) / 65535)))
      `shouldBe` Right [0 .. 65535]
  it "clips to 0 and 1, rounds to the nearest sample, and takes what is not a number for 0" $
    fmap
      samples
      ( pgmFromIntensity
          10
          ( generate
              6
              1
              (\x _ -> case x of 0 -> -3; 1 -> 7; 2 -> 0.34; 3 -> 0.36; 4 -> 0 / 0; _ -> 1 / 0)
          )
      )
      `shouldBe` Right [0, 10, 3, 4, 0, 10]
  it "refuses an empty raster and a maximum value of 0" $ do
    pgmFromIntensity 255 (constant 0 4 1) `shouldBe` Left (ZeroSize 0 4)
    pgmFromIntensity 0 (constant 1 1 1) `shouldBe` Left (MaxvalOutOfRange 0)
  it "intensities are shares of the maximum value" $
    fmap (toRows . pgmIntensity) (decodePgm "P2 3 1 200 0 50 200") `shouldBe` Right [[0, 0.25, 1]]
  it "rasterPng is a PNG whose pixels are the samples of 8 bits" $
    forAll genRaster $ \r -> case (decodePng (L.toStrict (rasterPng r)), pgmFromIntensity 255 r) of
      (Right (ImageY8 image), Right pgm) ->
        map fromIntegral (V.toList (imageData image)) === samples pgm
      other -> counterexample (either show (const "not grey") (fst other)) False
