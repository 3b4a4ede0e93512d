{-# OPTIONS_HADDOCK hide #-}

-- | Readings as text: matrices of numbers and exports of Tekscan's programs.
module PraTactile.Image.File.Matrix
  ( isTekscan,
    decodeTekscan,
    beginsAsMatrix,
    decodeMatrix,
  )
where

import Control.Monad (unless, when)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Data.Char (isDigit, toLower)
import Data.List (find)
import Data.Maybe (fromMaybe, isJust)
import qualified Data.Vector.Storable as V
import PraTactile.Decimal (NotDecimal (..), readDouble)
import PraTactile.Image.Error (ImageError (..))
import PraTactile.Image.Images
import PraTactile.Image.Pgm.Type (checkSize)
import PraTactile.PlainText (lineFeeds, plainText)

-- | A line and its number, from 1.
type Line = (Int, ByteString)

-- | Whether a text may be a matrix: after blanks and comments it begins with a number or with a
-- missing reading.
beginsAsMatrix :: ByteString -> Bool
beginsAsMatrix text = case C.uncons begin of
  Just ('#', rest) -> beginsAsMatrix (C.dropWhile (`notElem` "\r\n") rest)
  Just (c, _) -> isDigit c || c `elem` "+-." || isJust (missing firstWord)
  Nothing -> False
  where
    begin = C.dropWhile (`elem` " \t\r\n") text
    firstWord = C.takeWhile (`notElem` ",; \t\r\n") begin

-- | Rows of numbers: one image, or several separated by blank lines. The first row decides how the
-- numbers of all rows are separated: by semicolons if it has one, else by commas if it has one,
-- else by blanks. An empty field at the end of a row is ignored. @nan@ and @B@ are taxels without a
-- reading. A number beyond the range of Double is infinite. Lines whose first character that is not
-- a blank is @#@ are comments. Full scale is 1, and no spacing is given.
--
-- Refuses other encodings than UTF-8 ('ImageInEncoding'), a text without rows ('ZeroSize'), other
-- fields ('NotNumber', 'DecimalComma'), rows of different lengths ('RaggedRow'), images of
-- different sizes ('SizesDiffer') and what 'checkSize' refuses.
decodeMatrix :: ByteString -> Either ImageError Images
decodeMatrix file = do
  text <- first ImageInEncoding (plainText file)
  let images = blocks [line | line <- numbered text, not (isComment line)]
      separator = separatorOf (maybe B.empty snd (find (not . isBlank) (concat images)))
  case images of
    [] -> Left (ZeroSize 0 0)
    _ -> imagesOf 1 Nothing =<< traverse (traverse (rowOf separator)) images

-- | The images: runs of lines that are not blank.
blocks :: [Line] -> [[Line]]
blocks text = case dropWhile isBlank text of
  [] -> []
  begin -> let (block, rest) = break isBlank begin in block : blocks rest

numbered :: ByteString -> [Line]
numbered = zip [1 ..] . C.lines

isBlank :: Line -> Bool
isBlank = C.all (`elem` " \t\r") . snd

-- | Whether the first character that is not a blank is @#@.
isComment :: Line -> Bool
isComment = C.isPrefixOf (C.pack "#") . C.dropWhile (`elem` " \t\r") . snd

-- | Images of one size. Arguments: the full scale; the spacing in millimetres, if it is known; the
-- rows of each image. Refuses rows of different lengths, images of different sizes, and what
-- 'checkSize' refuses.
imagesOf :: Double -> Maybe Double -> [[V.Vector Double]] -> Either ImageError Images
imagesOf full apart images = do
  (w, h) <- checkSize (size width) (size height)
  sequence_
    [ Left (RaggedRow i (V.length row) width)
      | (i, row) <- zip [0 ..] (concat images),
        V.length row /= width
    ]
  sequence_
    [ Left (SizesDiffer (width, height) (width, length image))
      | image <- images,
        length image /= height
    ]
  Right
    Images
      { imagesColumns = w,
        imagesRows = h,
        imagesCount = length images,
        imagesFull = full,
        imagesSpacing = apart,
        imagesReadings = Listed (V.concat (concat images))
      }
  where
    firstImage = concat (take 1 images)
    height = length firstImage
    width = maximum (0 : map V.length (take 1 firstImage))
    size = fromIntegral

-- | The separator of a line's numbers: a semicolon if the line has one, else a comma if it has one,
-- else 'Nothing' for blanks.
separatorOf :: ByteString -> Maybe Char
separatorOf line = find (`C.elem` line) ";,"

-- | The numbers of a line with the given separator, 'Nothing' for blanks. An empty last field is
-- ignored.
rowOf :: Maybe Char -> Line -> Either ImageError (V.Vector Double)
rowOf separator (number, text) = V.fromList <$> traverse value (zip [1 ..] fields)
  where
    fields = case separator of
      Nothing -> C.words text
      Just mark -> map C.strip (withoutLast (C.split mark text))
    withoutLast parts = case reverse parts of
      end : others | B.null (C.strip end) -> reverse others
      _ -> parts
    value (column, field) = case numberIn field of
      Just found -> Right found
      Nothing
        | hasDecimalComma field -> Left (DecimalComma number field)
        | otherwise -> Left (NotNumber number column (B.take 20 field))

-- | Whether a field is two groups of digits with a comma between them.
hasDecimalComma :: ByteString -> Bool
hasDecimalComma field = case C.split ',' field of
  [before, after] -> all plain [before, after]
  _ -> False
  where
    plain part = C.all (\c -> isDigit c || c == '-') part && not (B.null part)

-- | A number, or NaN for a taxel without a reading.
numberIn :: ByteString -> Maybe Double
numberIn field = case missing field of
  Nothing -> decimalIn field
  found -> found

-- | NaN for @nan@ or @B@ in either case.
missing :: ByteString -> Maybe Double
missing field = lookup (map toLower (C.unpack (B.take 5 field))) [("nan", none), ("b", none)]
  where
    none = 0 / 0

-- | A decimal number; an infinity if it is beyond the range of Double. A short one is computed as
-- the quotient of two integers that doubles hold exactly, so it is rounded once.
decimalIn :: ByteString -> Maybe Double
decimalIn field
  | shortEnough = Just ((if negative then negate else id) (fromIntegral digits / 10 ^ places))
  | otherwise = case readDouble field of
    Right found -> Just found
    Left Infinite -> infinite
    Left _ -> Nothing
  where
    (negative, text) = case C.uncons field of
      Just ('-', rest) -> (True, rest)
      Just ('+', rest) -> (False, rest)
      _ -> (False, field)
    (before, point) = C.span isDigit text
    fraction = B.drop 1 point
    places = B.length fraction
    shortEnough =
      not (B.null text) && B.length text <= 15
        && not (B.null before && places == 0)
        && (B.null point || C.isPrefixOf (C.pack ".") point)
        && C.all isDigit fraction
    digits = B.foldl' digit (B.foldl' digit 0 before) fraction :: Int
    digit n c = 10 * n + fromIntegral c - 48
    infinite = if negative then Just (-1 / 0) else Just (1 / 0)

-- | Whether a file is a Tekscan export: one of its first 200 lines, within the first 64 KiB, begins
-- with @ASCII_DATA@, which ends the header.
isTekscan :: ByteString -> Bool
isTekscan file = any isEnd (take 200 (C.lines (lineFeeds (B.take 65536 file))))

isEnd :: ByteString -> Bool
isEnd = C.isPrefixOf (C.pack "ASCII_DATA")

-- | A Tekscan export: a header of keys and values, then frames. A frame is a line @Frame N@ and its
-- rows; N runs from @START_FRAME@ to @END_FRAME@. The fields of a row are those of 'decodeMatrix'.
-- Full scale is @SATURATION_PRESSURE@, or 255 if @UNITS@ is @RAW@ or that key is missing.
--
-- Refuses ('TekscanHeader') a header without a valid @COLS@, @ROWS@, @COL_SPACING@, @ROW_SPACING@,
-- @START_FRAME@ or @END_FRAME@, or with an invalid @SATURATION_PRESSURE@; and rows of another
-- length than @COLS@. Refuses ('TekscanFrame') frames that are missing, too many, out of order or
-- without some of their rows. Refuses different spacings of columns and rows ('UnequalSpacing'),
-- and the encodings, fields, rows and sizes that 'decodeMatrix' refuses.
decodeTekscan :: ByteString -> Either ImageError Images
decodeTekscan file = do
  text <- first ImageInEncoding (plainText file)
  let (header, rest) = break (isEnd . snd) (numbered text)
  columns <- whole header "COLS"
  rows <- whole header "ROWS"
  (w, h) <- checkSize (fromInteger columns) (fromInteger rows)
  across <- spacing header "COL_SPACING"
  down <- spacing header "ROW_SPACING"
  unless (across == down) (Left (UnequalSpacing across down))
  start <- whole header "START_FRAME"
  end <- whole header "END_FRAME"
  full <- fullScale header
  frames <- framesFrom (w, h) start (filter (not . isBlank) (drop 1 rest))
  let there = toInteger (length frames)
      announced = max 0 (end - start + 1)
  when (there /= announced) (Left (TekscanFrame (start + min there announced)))
  when (any ((/= w) . V.length) (take 1 (concat frames))) (Left (TekscanHeader "COLS"))
  imagesOf full (Just across) frames

-- | The value of a key in the header, with the number of its line. Refuses a missing key.
valueOf :: [Line] -> String -> Either ImageError Line
valueOf header key = maybe (Left (TekscanHeader key)) Right (find ours header >>= Just . fmap after)
  where
    ours (_, text) = C.takeWhile (/= ' ') text == C.pack key
    after = C.strip . C.dropWhile (/= ' ')

-- | The value of a key as a natural number. Refuses other values.
whole :: [Line] -> String -> Either ImageError Integer
whole header key = do
  (_, text) <- valueOf header key
  case C.readInteger (B.take 12 text) of
    Just (n, rest) | B.null rest && n >= 0 -> Right n
    _ -> Left (TekscanHeader key)

-- | The value of a key as a length in millimetres: a positive number and its unit, millimetres or
-- centimetres. Without a unit it is in millimetres. Refuses other values.
spacing :: [Line] -> String -> Either ImageError Double
spacing header key = do
  (line, text) <- valueOf header key
  let (number, unit) = C.span (/= ' ') text
  when (hasDecimalComma number) (Left (DecimalComma line number))
  case (decimalIn number, lookup (C.unpack (C.strip unit)) units) of
    (Just n, Just times) | n > 0 -> Right (times * n)
    _ -> Left (TekscanHeader key)
  where
    units =
      [(name, 1) | name <- ["", "mm", "millimeters", "millimetres"]]
        ++ [(name, 10) | name <- ["cm", "centimeters", "centimetres"]]

-- | The full scale of a header. Refuses a saturation pressure that is not a positive number.
fullScale :: [Line] -> Either ImageError Double
fullScale header = case (valueOf header "UNITS", valueOf header key) of
  (Right (_, unit), _) | map toLower (C.unpack unit) == "raw" -> Right 255
  (_, Left _) -> Right 255
  (_, Right (line, text)) -> do
    let number = C.takeWhile (/= ' ') text
    when (hasDecimalComma number) (Left (DecimalComma line number))
    case decimalIn number of
      Just n | n > 0 -> Right n
      _ -> Left (TekscanHeader key)
  where
    key = "SATURATION_PRESSURE"

-- | Consecutive frames. Arguments: the numbers of columns and rows; the number of the first frame;
-- the lines after the header that are not blank. A line that begins with @\@\@@ ends the frames.
framesFrom :: (Int, Int) -> Integer -> [Line] -> Either ImageError [[V.Vector Double]]
framesFrom (w, h) = go
  where
    go _ [] = Right []
    go _ ((_, text) : _) | C.isPrefixOf (C.pack "@@") text = Right []
    go number ((_, text) : rest)
      | take 2 (C.words text) /= [C.pack "Frame", C.pack (show number)] = Left (TekscanFrame number)
      | length lines' < h || any (\(_, line) -> C.take 1 line `elem` map C.pack ["F", "@"]) lines' =
        Left (TekscanFrame number)
      | otherwise = (:) <$> traverse row lines' <*> go (number + 1) after
      where
        (lines', after) = splitAt h rest
    row line@(number, text) = do
      when (C.elem ';' text && C.elem ',' text) (Left (DecimalComma number (B.take 20 text)))
      values <- rowOf (Just (fromMaybe ',' (separatorOf text))) line
      -- Decimal commas beside separating ones make twice as many fields.
      when (V.length values == 2 * w) (Left (DecimalComma number (B.take 20 text)))
      pure values
