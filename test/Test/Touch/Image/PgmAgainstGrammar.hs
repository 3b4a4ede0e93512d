{-# LANGUAGE OverloadedStrings #-}

-- | PGM files against a reader that follows pgm(5) word by word: comments become blanks, the header
-- is three words, the samples are the words or the bytes after them. It is slow, and says all that
-- is wrong with a file.
module Test.Touch.Image.PgmAgainstGrammar
  ( spec,
    contents,
    samplesOf,
  )
where

import Codec.Picture (Image (..))
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Data.Char (isDigit)
import Data.List (groupBy)
import qualified Data.Vector.Storable as V
import PraTactile.Image.Pgm
import Test.Hspec hiding (after, before)
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (once)
import Test.Support

spec :: Spec
spec = describe "By the manual" byDefinition

-- | Width, height, maximum value and samples.
type Contents = (Int, Int, Int, [Int])

contents :: Pgm -> Contents
contents pgm = (pgmWidth pgm, pgmHeight pgm, pgmMaxval pgm, samplesOf pgm)

samplesOf :: Pgm -> [Int]
samplesOf (Pgm8 _ image) = map fromIntegral (V.toList (imageData image))
samplesOf (Pgm16 _ image) = map fromIntegral (V.toList (imageData image))

-- | What a file holds, or all that is wrong with it.
defined :: ByteString -> Either [ImageError] Contents
defined file = case splitAt 2 text of
  (magic, after)
    | magic `elem` ["P2", "P5"] && all (`elem` (white ++ "#")) (take 1 after) ->
      header (magic == "P5") (spaced (blanked after))
  _ -> Left [NotPgm (B.take 8 file)]
  where
    text = C.unpack file
    -- The words of what follows the magic, each with where it begins.
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

-- | The words of a text, each with its place; the first character has this one.
wordsFrom :: Int -> String -> [(Int, String)]
wordsFrom start text =
  [ (i, map snd word)
    | word@((i, c) : _) <- groupBy (\(_, a) (_, b) -> isWhite a == isWhite b) (zip [start ..] text),
      not (isWhite c)
  ]
  where
    isWhite = (`elem` white)

-- | A word of digits as a number; from 10^18 on all are one, too large for everything.
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

-- | As it is, or with one or two pieces changed, or cut off, or with something after the end.
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
  modifyMaxSuccess (const 3000) $
    it "a file is read as it is defined, or refused for something that is wrong with it" $
      property $ \(Pieces pieces) -> readAsDefined defined decodePgm contents (B.concat pieces)
  it "at maximum values near a change of size, samples up to it are read, and one more is not" $
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
