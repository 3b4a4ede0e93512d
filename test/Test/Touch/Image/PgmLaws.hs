{-# LANGUAGE OverloadedStrings #-}

-- | The laws of PGM files and images. Files are compared with a reader that follows pgm(5) word by
-- word: comments become blanks, the header is three words, the samples are the words or the bytes
-- after them. This reader is slow, and lists all faults of a file.
module Test.Touch.Image.PgmLaws (spec, genPgm) where

import Codec.Picture (DynamicImage (..), Image (..), decodePng)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.Char (isDigit)
import Data.List (groupBy)
import qualified Data.Vector.Storable as V
import PraTactile.Image (constant, fromRows, toRows)
import PraTactile.Image.Pgm
import Test.Effort (withCases)
import Test.Hspec hiding (after, before)
import Test.QuickCheck hiding (once, vector)
import Test.Support
import Test.Touch.Image.RastersAndCorrelation (genRaster)

spec :: Spec
spec = do
  describe "A file" byDefinition
  describe "An image" built
  describe "A file that is written" written
  describe "A file of another format" mistaken
  describe "Intensities" intensities

-- | Width, height, maximum value and samples.
type Contents = (Int, Int, Int, [Int])

contents :: Pgm -> Contents
contents pgm = (pgmWidth pgm, pgmHeight pgm, pgmMaxval pgm, samplesOf pgm)

samplesOf :: Pgm -> [Int]
samplesOf (Pgm8 _ image) = map fromIntegral (V.toList (imageData image))
samplesOf (Pgm16 _ image) = map fromIntegral (V.toList (imageData image))

-- | The content of a file, or all of its faults.
defined :: ByteString -> Either [ImageError] Contents
defined file = case splitAt 2 text of
  (magic, after)
    | magic `elem` ["P2", "P5"] && all (`elem` (white ++ "#")) (take 1 after) ->
      header (magic == "P5") (spaced (blanked after))
  _ -> Left [NotPgm (B.take 8 file)]
  where
    text = C.unpack file
    -- The words after the magic, each with its position.
    spaced = wordsFrom 2

    header raw found = do
      (w, afterWidth) <- headerNumber HeaderWidth found
      (h, afterHeight) <- headerNumber HeaderHeight afterWidth
      (m, afterMaxval) <- headerNumber HeaderMaxval afterHeight
      refuse $
        [ZeroSize (fromInteger w) (fromInteger h) | w * h == 0]
          ++ [TooManyPixels (fromInteger w) (fromInteger h) | w * h > 2 ^ (24 :: Int)]
          ++ [MaxvalOutOfRange (fromInteger m) | m < 1 || m > 65535]
      let size = (fromInteger w, fromInteger h, fromInteger m)
          end = case afterHeight of
            (start, word) : _ -> start + length word
            [] -> length text
      if raw then binary size (drop end text) else plain size afterMaxval

    headerNumber field found = case found of
      (_, word) : rest | Just n <- decimal word -> Right (n, rest)
      _ -> Left [BadHeader field (bytesAt found)]
    bytesAt found = B.take 8 (B.drop (case found of (i, _) : _ -> i; [] -> B.length file) file)

    plain (w, h, m) found = do
      let samples = [(place, decimal word) | (place, (_, word)) <- zip [0 .. w * h - 1] found]
      refuse $
        [BadSample i (bytesAt (drop i found)) | (i, Nothing) <- samples]
          ++ aboveMaxval w m [(i, v) | (i, Just v) <- samples]
          ++ [Truncated (w * h) (length samples) | length samples < w * h]
          ++ [TrailingData (length text - i) | (i, _) <- take 1 (drop (w * h) found)]
      Right (w, h, m, [fromInteger v | (_, Just v) <- samples])

    binary (w, h, m) after = do
      let raster = case after of
            '#' : comment -> drop 1 (dropWhile (`notElem` lineEnds) comment)
            _ -> drop 1 after
          size = if m < 256 then 1 else 2
          whole = length raster `div` size
          samples = take (w * h) (valuesOf size (map fromEnum raster))
          trailing = dropWhile (`elem` white) (drop (w * h * size) raster)
      refuse ([Truncated (w * h) whole | whole < w * h])
      refuse $
        aboveMaxval w m (zip [0 ..] (map toInteger samples))
          ++ [TrailingData (length trailing) | not (null trailing)]
      Right (w, h, m, samples)

    valuesOf size bytes = case splitAt size bytes of
      ([a], rest) | size == 1 -> a : valuesOf size rest
      ([a, b], rest) -> 256 * a + b : valuesOf size rest
      _ -> []

    aboveMaxval w m samples =
      [ SampleAboveMaxval (i `mod` w, i `div` w) (fromInteger v) m
        | (i, v) <- samples,
          v > toInteger m
      ]

refuse :: [ImageError] -> Either [ImageError] ()
refuse causes = if null causes then Right () else Left causes

-- | "Blanks, TABs, CRs, LFs."
white, lineEnds :: String
white = " \t" ++ lineEnds
lineEnds = "\r\n"

-- | Each comment replaced by blanks: "Characters from a # to the next end-of-line [...] are
-- ignored."
blanked :: String -> String
blanked text = case break (== '#') text of
  (before, comment@(_ : _)) ->
    let (ignored, rest) = break (`elem` lineEnds) comment
     in before ++ map (const ' ') ignored ++ blanked rest
  (before, []) -> before

-- | The words of a text, each with its position; the first character has this one.
wordsFrom :: Int -> String -> [(Int, String)]
wordsFrom start text =
  [ (i, map snd word)
    | word@((i, c) : _) <- groupBy (\(_, a) (_, b) -> isWhite a == isWhite b) (zip [start ..] text),
      not (isWhite c)
  ]
  where
    isWhite = (`elem` white)

-- | A word of digits as a number; from 10^18 on all are one number, too large for everything.
decimal :: String -> Maybe Integer
decimal word
  | not (null word) && all isDigit word = Just (min (10 ^ (18 :: Int)) (read word))
  | otherwise = Nothing

-- | A file in pieces.
newtype Pieces = Pieces [ByteString]
  deriving stock (Show)

instance Arbitrary Pieces where
  arbitrary = do
    raw <- arbitrary
    m <- boundary [1, 9, 254, 255, 256, 257, 65534, 65535] [0, 65536]
    w <- frequency [(20, choose (1, 4)), (1, pure 0)]
    h <- frequency [(20, choose (1, 4)), (1, pure 0)]
    above <- frequency [(3, pure []), (1, pure [m + 1, 65535])]
    values <- vectorOf (w * h) (elements ([0, 1, m - 1, m] ++ above))
    gaps <- vectorOf 4 gap
    end <- elements (["\n", " ", "\t", "\r"] ++ ["# to the end of the line\n" | raw])
    samples <-
      if raw
        then pure (map (bytesOf m) values)
        else concat <$> traverse (\v -> (\g -> [shown v, g]) <$> gap) values
    let numbers = zipWith (\n g -> [g, shown n]) [w, h, m] gaps
    mutated ([if raw then "P5" else "P2"] ++ concat numbers ++ [end] ++ samples)
    where
      boundary good bad = frequency [(20, elements good), (1, elements bad)]
      shown = C.pack . show :: Int -> ByteString
  shrink (Pieces pieces) =
    map Pieces (shrinkList (\piece -> [B.take 1 piece | B.length piece > 1]) pieces)

-- | A sample at a maximum value.
bytesOf :: Int -> Int -> ByteString
bytesOf m v = B.pack (map fromIntegral (if m < 256 then [v] else [v `div` 256, v]))

-- | White space, with comments in it.
gap :: Gen ByteString
gap = B.concat <$> ((:) <$> one <*> frequency [(3, pure []), (1, listOf one)])
  where
    one = elements ([" ", "\t", "\n", "\r", "\r\n"] ++ comments)
    comments = ["# a comment 12 P5\n", "#\n", " # ## \r", "#7\r\n"]

-- | Unchanged, or with one or two pieces changed, or cut off, or with something after the end.
mutated :: [ByteString] -> Gen Pieces
mutated pieces = do
  times <- frequency [(2, pure 0), (3, pure (1 :: Int)), (1, pure 2)]
  Pieces <$> foldr (const (>>= once)) (pure pieces) [1 .. times]
  where
    once list = do
      i <- choose (0, length list)
      byte <- elements [" ", "#", "\n", "\r", "x", "0", "9", "-", ".", "\0", "\255"]
      word <- elements (map C.pack numbers)
      n <- choose (0, B.length (B.concat list))
      let (before, after) = splitAt i list
          rest = drop 1 after
      elements
        [ before ++ rest,
          before ++ byte : after,
          before ++ byte : rest,
          before ++ word : rest,
          before ++ take 1 after ++ after,
          [B.take n (B.concat list)],
          list ++ [byte],
          list ++ [" \n", byte, " "]
        ]
    numbers =
      ["0", "00", "007", "1", "255", "256", "257", "511", "65535", "65536", "4096", "4097"]
        ++ ["16777216", "16777217", "-1", "+1", "1.5", "1x", "x", "P5"]
        ++ [show (10 ^ e + d :: Integer) | e <- [17 .. 20 :: Int], d <- [-1, 0, 1]]
        ++ ["000" ++ show (10 ^ (18 :: Int) + d :: Integer) | d <- [-1, 1]]

byDefinition :: Spec
byDefinition = do
  withCases 1000 3000 $
    it "is read by the definition, or refused for one of its faults" $
      property $ \(Pieces pieces) -> readAsDefined defined decodePgm contents (B.concat pieces)
  it "has the size in its header, which is read alone" $
    property $ \(Pieces pieces) ->
      let file = B.concat pieces
       in case defined file of
            Right (w, h, _, _) -> pgmSize file === Right (w, h)
            Left _ -> property Discard
  it "accepts samples up to the maximum value, near a change of size, and none above" $
    conjoin
      [ case decodePgm file of
          Right pgm -> counterexample name (contents pgm === (2, 1, m, [0, v]) .&&. v <= m)
          Left e ->
            counterexample name (e === SampleAboveMaxval (1, 0) (fromIntegral v) m .&&. v > m)
        | m <- [1, 2, 127, 128, 254, 255, 256, 257, 511, 512, 32767, 32768, 65534, 65535],
          v <- [m - 1, m, m + 1, m + 255, m + 256],
          (name, file) <-
            ("plain", C.pack (unwords ["P2 2 1", show m, "0", show v])) :
              [ ("raw", B.concat [C.pack ("P5 2 1 " ++ show m ++ "\n"), bytesOf m 0, bytesOf m v])
                | v < (if m < 256 then 256 else 65536)
              ]
      ]

built :: Spec
built = do
  it "is accepted by pgm8 and pgm16 exactly if it has one of their maximum values" $
    forAllShrink image' shrinkImage $ \(m, (w, h, values)) ->
      let causes range =
            [MaxvalOutOfRange (fromIntegral m) | m `notElem` range]
              ++ [ZeroSize (natural w) (natural h) | w < 1 || h < 1]
              ++ [WrongValueCount w h (length values) | length values /= w * h]
              ++ [ SampleAboveMaxval (i `mod` w, i `div` w) (fromIntegral v) m
                   | w > 0,
                     (i, v) <- zip [0 ..] values,
                     v > m
                 ]
          held range made = case made of
            Right pgm -> (contents pgm, causes range) === ((w, h, m, values), [])
            Left e -> counterexample (show (e, causes range)) (e `elem` causes range)
       in conjoin
            ( held [256 .. 65535] (pgm16 (fromIntegral m) (Image w h (vector values))) :
                [ held [1 .. 255] (pgm8 (fromIntegral m) (Image w h (vector values)))
                  | all (< 256) (m : values)
                ]
            )
  it "of exactly 2^24 pixels is not too large, and one with another row is" $ do
    maxPixels `shouldBe` 2 ^ (24 :: Int)
    contentsOf (pgm8 1 (Image 4096 4096 V.empty)) `shouldBe` Left (WrongValueCount 4096 4096 0)
    contentsOf (pgm8 1 (Image 4096 4097 V.empty)) `shouldBe` Left (TooManyPixels 4096 4097)
    contentsOf (pgm8 1 (Image 16777217 1 V.empty)) `shouldBe` Left (TooManyPixels 16777217 1)
  it "is shown as the expression that builds it, in parentheses as an argument" $
    forAllShrink image' shrinkImage $ \(m, (w, h, values)) ->
      let shown name =
            unwords [name, show m, "(Image", show w, show h, show values ++ ")"]
          check text pgm =
            [showsPrec d pgm "" | d <- [0 .. 12]]
              === replicate 11 text ++ replicate 2 ("(" ++ text ++ ")")
       in conjoin $
            [ check (shown "Pgm8") pgm
              | all (< 256) (m : values),
                Right pgm <- [pgm8 (fromIntegral m) (Image w h (vector values))]
            ]
              ++ [ check (shown "Pgm16") pgm
                   | Right pgm <- [pgm16 (fromIntegral m) (Image w h (vector values))]
                 ]
  where
    contentsOf = fmap contents
    natural = fromIntegral . max 0
    vector :: (Num a, V.Storable a) => [Int] -> V.Vector a
    vector = V.fromList . map fromIntegral
    image' = do
      m <- elements [0, 1, 9, 254, 255, 256, 257, 65534, 65535]
      w <- frequency [(9, choose (1, 3)), (1, choose (-1, 0))]
      h <- frequency [(9, choose (1, 3)), (1, choose (-1, 0))]
      count <- frequency [(9, pure (max 0 (w * h))), (1, choose (0, 9))]
      values <- vectorOf count (frequency [(9, elements [0, m]), (1, pure (min 65535 (m + 1)))])
      pure (m, (w, h, values))
    shrinkImage (m, (w, h, values)) = [(m, (w, h, vs)) | vs <- shrink values, all (>= 0) vs]

written :: Spec
written = do
  it "is read as the image that it was written from, plain and raw" $
    forAll ((,) <$> elements [Plain, Binary] <*> genPgm) $ \(format, pgm) ->
      decodePgm (encodePgm format pgm) === Right pgm
  it "has lines of at most 70 characters if plain, and begins each row on a new line" $
    forAll genPgm $ \pgm ->
      let written' = drop 3 (C.lines (encodePgm Plain pgm))
          counts = map (length . C.words) written'
       in counterexample (show counts) $
            all ((<= 70) . B.length) written'
              && scanl (+) 0 counts `containsAll` [0, pgmWidth pgm .. pgmWidth pgm * pgmHeight pgm]
  where
    containsAll sums = all (`elem` sums)

genPgm :: Gen Pgm
genPgm = do
  w <- frequency [(3, choose (1, 9)), (1, choose (10, 40))]
  h <- choose (1, 9)
  m <- oneof [choose (1, 255), choose (256, 65535), elements [1, 255, 256, 65535]]
  values <- vectorOf (w * h) (choose (0, m))
  let made
        | m < 256 = pgm8 (fromIntegral m) (Image w h (V.fromList (map fromIntegral values)))
        | otherwise = pgm16 m (Image w h (V.fromList values))
  either (\e -> error ("the generator made no PGM: " ++ show e)) pure made

mistaken :: Spec
mistaken =
  it "is recognised by its signature, and by nothing less" $
    conjoin
      [ counterexample (show (name, signature)) $
          conjoin
            [ formatName (signature <> "\0") === Just name,
              conjoin
                [ counterexample (show changed) (formatName changed =/= Just name)
                  | i <- [0 .. B.length signature - 1],
                    let (before, after) = B.splitAt i signature,
                    changed <- [before, before <> B.map (+ 64) (B.take 1 after) <> B.drop 1 after]
                ]
            ]
        | (name, signatures) <- signaturesOf,
          signature <- signatures
      ]
  where
    -- From the specifications: PNG 5.2 (its first half is enough), JFIF, GIF89a 17, TIFF 6.0 2,
    -- BITMAPFILEHEADER, pbm(5), ppm(5), pam(5), RFC 1952, ISO 32000 7.5.2.
    signaturesOf =
      [ ("PNG", ["\x89PNG"]),
        ("JPEG", [B.pack [0xff, 0xd8, 0xff]]),
        ("GIF", ["GIF8"]),
        ("TIFF", ["II*\0", "MM\0*"]),
        ("BMP", ["BM"]),
        ("PBM", ["P1", "P4"]),
        ("PPM", ["P3", "P6"]),
        ("PAM", ["P7"]),
        ("gzip", [B.pack [0x1f, 0x8b]]),
        ("PDF", ["%PDF"])
      ]

intensities :: Spec
intensities = do
  it "are the samples' shares of the maximum value, and give the samples back" $
    forAll genPgm $ \pgm ->
      let shares = pgmIntensity pgm
          m = fromIntegral (pgmMaxval pgm)
       in concat (toRows shares) === [fromIntegral v / m | v <- samplesOf pgm]
            .&&. pgmFromIntensity (fromIntegral (pgmMaxval pgm)) shares === Right pgm
  it "become the nearest samples, beyond 0 to 1 the last ones, and for NaN 0" $
    forAll (elements [1, 9, 254, 255, 256, 257, 65534, 65535]) $ \m ->
      forAll (vectorOf 9 (frequency [(3, choose (-2, 3)), (1, elements edges)])) $
        \values ->
          let image = either (error . show) id (fromRows [values])
              -- The nearer one, or of two equally near the even one.
              nearest v = snd (minimum [((abs (at v - fromIntegral s), odd s), s) | s <- near v])
              at v = fromIntegral m * (if isNaN v then 0 else max 0 (min 1 v))
              near v = [floor (at v), floor (at v) + 1] :: [Int]
           in fmap samplesOf (pgmFromIntensity m image) === Right (map nearest (values :: [Double]))
  it "without pixels, or with a maximum value of 0, are no image" $ do
    pgmFromIntensity 255 (constant 0 4 1) `shouldBe` Left (ZeroSize 0 4)
    pgmFromIntensity 0 (constant 1 1 1) `shouldBe` Left (MaxvalOutOfRange 0)
  it "become a PNG whose pixels are the samples of 8 bits" $
    forAll genRaster $ \r -> case (decodePng (L.toStrict (rasterPng r)), pgmFromIntensity 255 r) of
      (Right (ImageY8 image), Right pgm) ->
        map fromIntegral (V.toList (imageData image)) === samplesOf pgm
      other -> counterexample (either show (const "not grey") (fst other)) False
  where
    edges = [-0.5, 0, 0.5, 1, 0 / 0, 1 / 0, -1 / 0]
