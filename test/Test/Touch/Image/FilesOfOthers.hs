{-# LANGUAGE OverloadedStrings #-}

-- | Tests images in the files of other programs. Those in test/data/images/made.json are by numpy
-- and Pillow, with the values that these read.
module Test.Touch.Image.FilesOfOthers (spec) where

import Data.Aeson
import qualified Data.ByteString as B
import qualified Data.ByteString.Base64 as Base64
import qualified Data.ByteString.Char8 as C
import Data.Foldable (for_)
import Data.List (intercalate, isPrefixOf)
import Data.Maybe (catMaybes, isNothing)
import qualified Data.Text.Encoding as Text
import qualified Data.Vector.Storable as V
import PraTactile.Image (fromRows, rasterSize, rasterValues, toRows)
import PraTactile.Image.Error (ImageError (..))
import PraTactile.Image.File
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, maxPixels, pgmIntensity, pgmMaxval)
import Test.Hspec
import Test.QuickCheck hiding (reason)
import Test.Support
import Test.Touch.Image.PgmLaws (genPgm)

spec :: Spec
spec = do
  describe "of numpy and Pillow" $ beforeAll made ofOthers
  describe "that are written" written
  describe "with several images" movies
  describe "as text" matrices
  describe "of Tekscan" tekscan

-- | A file with another program's reading: its width and its shares, or the reason for its refusal.
data Made = Made String B.ByteString (Either String (Int, [[Maybe Double]]))

instance FromJSON Made where
  parseJSON = withObject "made" $ \o -> do
    name <- o .: "name"
    file <- either fail pure . Base64.decode . Text.encodeUtf8 =<< o .: "file"
    refused <- o .:? "refused"
    Made name file <$> case refused of
      Just reason -> pure (Left reason)
      Nothing -> fmap Right ((,) <$> o .: "width" <*> o .: "shares")

made :: IO [Made]
made = eitherDecodeFileStrict "test/data/images/made.json" >>= either fail pure

ofOthers :: SpecWith [Made]
ofOthers = do
  it "have the values that those programs read, or are refused with their reason" $ \files -> do
    length [() | Made _ _ (Right _) <- files] `shouldSatisfy` (>= 50)
    for_ files $ \(Made name file expected) -> case (expected, decodeImages maxPixels file) of
      (Left reason, Left why) -> (name, reason) `shouldSatisfy` (told why . snd)
      (Right (width, shares), Right images) -> do
        (name, imagesCount images, fst (imagesSize images))
          `shouldBe` (name, length shares, width)
        for_ (zip [0 ..] shares) $ \(i, image) -> do
          felt <- right (numberedImage Nothing (Just i) images)
          let found = V.toList (rasterValues (scaledImage felt))
          (name, [v | (v, Just _) <- zip found image]) `shouldBe` (name, catMaybes image)
          scaledDead felt `shouldBe` [k `quotRem` width | (k, Nothing) <- zip [0 ..] image]
      (_, found) -> expectationFailure (name ++ ": " ++ either show (const "read") found)
  it "are refused wherever an array is cut short" $ \files ->
    [ (name, n)
      | Made name file _ <- files,
        "\x93NUMPY" `B.isPrefixOf` file,
        name /= "too long",
        n <- [0 .. B.length file - 1],
        isNothing (problem (B.take n file))
    ]
      `shouldBe` []
  where
    told why reason = case why of
      PngRefused png -> show png == reason
      _ -> reason `isPrefixOf` show why

written :: Spec
written =
  it "are read as what they were written from, with the original samples" $
    property . forAll ((,) <$> elements [minBound ..] <*> genPgm) $ \(format, pgm) ->
      let full = fromIntegral (pgmMaxval pgm)
          shown = decodeImages maxPixels (encodeImage format pgm)
       in whenRight (shown >>= numberedImage (Just full) Nothing) $ \felt ->
            (scaledImage felt, scaledDead felt, scaledClipped felt) === (pgmIntensity pgm, [], 0)

movies :: Spec
movies = do
  it "are concatenated PGM images, which have all their images" $
    property . forAll ((,) <$> genPgm <*> choose (1, 5)) $ \(pgm, count) ->
      forAll (vectorOf count (elements [Plain, Binary])) $ \formats ->
        let file = B.concat [encodePgm format pgm | format <- formats]
         in whenRight (decodeImages maxPixels file) $ \images ->
              imagesCount images === count
                .&&. conjoin
                  [ fmap scaledImage (numberedImage Nothing (Just i) images)
                      === Right (pgmIntensity pgm)
                    | i <- [0 .. count - 1]
                  ]
                .&&. fmap scaledImage (numberedImage Nothing (Just count) images)
                  === Left (NoSuchImage count count)
  it "of different sizes are refused, and so is an image followed by anything else" $ do
    problem "P5 1 1 9\n\1P5 2 1 9\n\1\2" `shouldBe` Just (SizesDiffer (1, 1) (2, 1))
    problem "P5 1 1 9\n\1P6 1 1 9\n\1\2\3" `shouldBe` Just (TrailingData 12)
  it "are not a single image" $
    fmap scaledImage (read' "P2 1 1 9 1\nP2 1 1 9 2" >>= numberedImage Nothing Nothing)
      `shouldBe` Left (IsMovie 2)

read' :: B.ByteString -> Either ImageError Images
read' = decodeImages maxPixels

problem :: B.ByteString -> Maybe ImageError
problem = either Just (const Nothing) . read'

-- | Rows of numbers, with few digits or many.
genRows :: Gen [[Double]]
genRows = do
  (w, h) <- (,) <$> choose (1, 6) <*> choose (1, 6)
  vectorOf h (vectorOf w (oneof [choose (0, 1), (/ 8) . fromIntegral <$> choose (0, 8 :: Int)]))

matrices :: Spec
matrices = do
  it "are read, whatever separates their numbers; blank lines separate images" $
    property . forAll ((,,) <$> genRows <*> elements separators <*> choose (1, 3)) $
      \(rows, separator, count) ->
        let image = unlines (map (intercalate separator . map show) rows)
            file = C.pack (intercalate "\n" (replicate count image))
         in whenRight (decodeImages maxPixels file) $ \images ->
              imagesCount images === count
                .&&. conjoin
                  [ fmap (toRows . scaledImage) (numberedImage Nothing (Just i) images)
                      === Right
                        rows
                    | i <- [0 .. count - 1]
                  ]
  it "may lack readings, and are scaled by the stated full scale" $ do
    felt <- right (read' "10 nan 30\n20 B 51\n" >>= numberedImage (Just 50) Nothing)
    scaledDead felt `shouldBe` [(0, 1), (1, 1)]
    scaledClipped felt `shouldBe` 1
    -- The mean of the nearest neighbours replaces a missing reading.
    let mean = (0.2 + 0.6 + 0.4 + 1) / 4
    Right (scaledImage felt) `shouldBe` fromRows [[0.2, mean, 0.6], [0.4, mean, 1]]
  -- Comments before the first number could be indented, but were then refused as data.
  it "may have comments, indented or not, before and between rows" $
    let file = " # a\n#b\n0 1\n\t# c\n1 0\n"
     in fmap (toRows . scaledImage) (read' file >>= numberedImage Nothing Nothing)
          `shouldBe` Right [[0, 1], [1, 0]]
  it "are refused with the place of the fault" $ do
    problem "0.1 x\n" `shouldBe` Just (NotNumber 1 2 "x")
    problem "1\n\n0.1,5;0.2\n" `shouldBe` Just (NotNumber 3 1 "0.1,5;0.2")
    problem "0,5;0,25\n" `shouldBe` Just (DecimalComma 1 "0,5")
    problem "1 2\n3\n" `shouldBe` Just (RaggedRow 1 1 2)
    problem "1 2\n\n3 4\n5 6\n" `shouldBe` Just (SizesDiffer (2, 1) (2, 2))
  where
    separators = [", ", ",", ";", "  ", "\t"]

-- | An export as its programs write it.
export :: [String] -> B.ByteString
export = C.intercalate "\r\n" . map C.pack

exported :: [String]
exported =
  [ "DATA_TYPE MOVIE",
    "ROWS 2",
    "COLS 3",
    "ROW_SPACING 1.27 mm",
    "COL_SPACING 1.27 mm",
    "UNITS kPa",
    "SATURATION_PRESSURE 200",
    "START_FRAME 4",
    "END_FRAME 5",
    "ASCII_DATA @@",
    "",
    "Frame 4",
    "0,50,B",
    "100,200,250",
    "",
    "Frame 5",
    "1,2,3",
    "4,5,6",
    "@@",
    ""
  ]

tekscan :: Spec
tekscan = do
  it "are read with their spacing, full scale and missing elements" $ do
    images <- right (decodeImages maxPixels (export exported))
    (imagesCount images, imagesSize images, imagesSpacing images) `shouldBe` (2, (3, 2), Just 1.27)
    one <- right (numberedImage Nothing (Just 0) images)
    (scaledDead one, scaledClipped one) `shouldBe` ([(0, 2)], 1)
    [v | (k, v) <- zip [0 :: Int ..] (V.toList (rasterValues (scaledImage one))), k /= 2]
      `shouldBe` [0, 0.25, 0.5, 1, 1]
    two <- right (numberedImage Nothing (Just 1) images)
    toRows (scaledImage two) `shouldBe` [[0.005, 0.01, 0.015], [0.02, 0.025, 0.03]]
    rasterSize (scaledImage two) `shouldBe` (3, 2)
  -- An export whose lines end with CR alone was once not recognised as one.
  it "have lines that end with CR LF, LF or CR" $
    for_ ["\n", "\r"] $ \end ->
      -- Compared as text, because NaN differs from itself.
      show (read' (C.intercalate end (map C.pack exported)))
        `shouldBe` show (read' (export exported))
  it "may be in centimetres, and raw readings have 8 bits" $ do
    images <-
      right . decodeImages maxPixels . export $
        map (with "0.127 cm" "1.27 mm" . with "raw" "kPa") exported
    imagesSpacing images `shouldBe` Just 1.27
    one <- right (numberedImage Nothing (Just 0) images)
    take 2 (V.toList (rasterValues (scaledImage one))) `shouldBe` [0, 50 / 255]
  it "are refused with the missing part" $
    for_ refusals $ \(old, new, expected) -> do
      let spoilt = [if line == old then new else line | line <- exported]
      spoilt `shouldNotBe` exported
      (new, problem (export (filter (/= "-") spoilt))) `shouldBe` (new, Just expected)
  where
    with new old line = maybe line (\begin -> begin ++ new) (stripEnd old line)
    stripEnd end line
      | drop (length line - length end) line == end = Just (take (length line - length end) line)
      | otherwise = Nothing
    refusals =
      [ ("END_FRAME 5", "END_FRAME 6", TekscanFrame 6),
        ("END_FRAME 5", "END_FRAME 4", TekscanFrame 5),
        ("Frame 5", "Frame 6", TekscanFrame 5),
        ("4,5,6", "-", TekscanFrame 5),
        ("4,5,6", "4,5", RaggedRow 3 2 3),
        ("4,5,6", "4,x,6", NotNumber 18 2 "x"),
        ("4,5,6", "4,0,5,0,6,0", DecimalComma 18 "4,0,5,0,6,0"),
        ("4,5,6", "4,0;5,0;6,0", DecimalComma 18 "4,0;5,0;6,0"),
        ("COL_SPACING 1.27 mm", "COL_SPACING 2.54 mm", UnequalSpacing 2.54 1.27),
        ("COL_SPACING 1.27 mm", "COL_SPACING 1,27 mm", DecimalComma 5 "1,27"),
        ("COL_SPACING 1.27 mm", "COL_SPACING 1.27 parsec", TekscanHeader "COL_SPACING"),
        ("ROWS 2", "ROWS two", TekscanHeader "ROWS"),
        ("SATURATION_PRESSURE 200", "SATURATION_PRESSURE 0", TekscanHeader "SATURATION_PRESSURE"),
        ("COLS 3", "-", TekscanHeader "COLS"),
        -- Another number of columns than the rows have was once ignored.
        ("COLS 3", "COLS 4", TekscanHeader "COLS"),
        ("COLS 3", "COLS 2", TekscanHeader "COLS")
      ]
