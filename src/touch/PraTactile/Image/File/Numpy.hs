{-# OPTIONS_HADDOCK hide #-}

-- | Numpy arrays in files, by numpy's format description (NEP 1, versions 1.0 to 3.0).
module PraTactile.Image.File.Numpy
  ( isNumpy,
    decodeNumpy,
    encodeNumpy,
  )
where

import Control.Monad (unless, when)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Data.Char (isDigit, isSpace)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import Data.Word (Word16)
import PraTactile.Image.Error (ImageError (..))
import PraTactile.Image.Images
import PraTactile.Image.Pgm.Type (checkSize)

magic :: ByteString
magic = B.cons 0x93 (C.pack "NUMPY")

-- | Whether a file begins like a numpy file.
isNumpy :: ByteString -> Bool
isNumpy = B.isPrefixOf magic

-- | An array of two dimensions (rows and columns of an image) or three (images, rows, columns), of
-- a type of 'Number'. Full scale is that of the type. Refuses a header that cannot be read
-- ('NumpyHeader'), other types ('NumpyType') and other shapes ('NumpyShape'), sizes that
-- 'checkSize' refuses, and bytes that are too few ('Truncated') or too many ('TrailingData').
-- Objects are never unpickled.
decodeNumpy :: ByteString -> Either ImageError Images
decodeNumpy file = do
  (text, readings) <- maybe (Left NumpyHeader) Right (headerOf file)
  (descr, fortran, shape) <- maybe (Left NumpyHeader) Right (fieldsOf text)
  (number, big) <- maybe (Left (NumpyType descr)) Right (typeOf descr)
  (count, rows, columns) <- case shape of
    [r, c] -> Right (1, r, c)
    [f, r, c] | f > 0 -> Right (f, r, c)
    _ -> Left (NumpyShape shape)
  (w, h) <- checkSize (fromInteger columns) (fromInteger rows)
  let needed = count * toInteger (w * h)
      there = B.length readings `quot` numberBytes number
      beyond = B.length readings - fromInteger needed * numberBytes number
      most = toInteger (maxBound :: Int)
  when (needed > toInteger there) (Left (Truncated (fromInteger (min needed most)) there))
  unless (beyond == 0) (Left (TrailingData beyond))
  Right
    Images
      { imagesColumns = w,
        imagesRows = h,
        imagesCount = fromInteger count,
        imagesFull = numberFull number,
        imagesSpacing = Nothing,
        imagesReadings = Packed number big (not fortran) readings
      }

-- | The header's text and the bytes after it.
headerOf :: ByteString -> Maybe (ByteString, ByteString)
headerOf file = do
  let (begin, rest) = B.splitAt 8 file
  size <- case B.unpack (B.drop 6 begin) of
    [1, _] -> Just 2
    [major, _] | major `elem` [2, 3] -> Just 4
    _ -> Nothing
  let (bytes, after) = B.splitAt size rest
      announced = foldr (\byte n -> 256 * n + toInteger byte) 0 (B.unpack bytes)
  if B.length bytes == size && announced <= toInteger (B.length after)
    then Just (B.splitAt (fromInteger announced) after)
    else Nothing

-- | The fields of the header, a Python dictionary in any order: the type's description; whether the
-- first index varies fastest; the shape.
fieldsOf :: ByteString -> Maybe (ByteString, Bool, [Integer])
fieldsOf text = do
  fields <- dictionary =<< opened '{' text
  case fields of
    Fields (Just descr) (Just fortran) (Just shape) -> Just (descr, fortran, shape)
    _ -> Nothing

data Fields = Fields (Maybe ByteString) (Maybe Bool) (Maybe [Integer])

dictionary :: ByteString -> Maybe Fields
dictionary = go (Fields Nothing Nothing Nothing)
  where
    go fields rest
      | Just after <- opened '}' rest = if C.all isSpace after then Just fields else Nothing
      | otherwise = do
        (key, value) <- quoted rest
        (fields', after) <- opened ':' value >>= field (C.unpack key) fields
        go fields' (fromMaybe after (opened ',' after))
    field key (Fields d f s) value = case key of
      "descr" -> do
        (given, after) <- descrOf value
        Just (Fields (Just given) f s, after)
      "fortran_order" -> do
        (given, after) <- boolean value
        Just (Fields d (Just given) s, after)
      "shape" -> do
        (given, after) <- opened '(' value >>= numbers
        Just (Fields d f (Just given), after)
      _ -> Nothing
    -- The description of a structured type is a list.
    descrOf value = case quoted value of
      Just found -> Just found
      Nothing -> do
        list <- opened '[' value
        Just (C.pack "structured", snd (C.breakEnd (== ']') list))
    boolean value
      | Just after <- C.stripPrefix (C.pack "True") (blank value) = Just (True, after)
      | otherwise = (,) False <$> C.stripPrefix (C.pack "False") (blank value)
    numbers rest
      | Just after <- opened ')' rest = Just ([], after)
      | otherwise = do
        let (digits, after) = C.span isDigit (blank rest)
            -- Python 2 wrote long integers with an L.
            next = fromMaybe after (C.stripPrefix (C.pack "L") after)
        -- At most 18 digits are converted, so a very long number costs no time.
        n <- if B.length digits > 18 then Just (10 ^ (18 :: Int)) else fst <$> C.readInteger digits
        (more, end) <- numbers (fromMaybe next (opened ',' next))
        if null (drop 31 more) then Just (n : more, end) else Nothing

-- | The text after the given character, which may follow blanks; 'Nothing' if another one comes
-- first.
opened :: Char -> ByteString -> Maybe ByteString
opened mark rest = case C.uncons (blank rest) of
  Just (found, after) | found == mark -> Just after
  _ -> Nothing

-- | A quoted text, which may follow blanks, and the text after it.
quoted :: ByteString -> Maybe (ByteString, ByteString)
quoted rest = do
  (mark, after) <- C.uncons (blank rest)
  if mark `elem` "'\""
    then let (inner, end) = C.break (== mark) after in (,) inner . snd <$> C.uncons end
    else Nothing

blank :: ByteString -> ByteString
blank = C.dropWhile isSpace

-- | The number type of a description, and whether the most significant byte comes first. @=@ (the
-- writer's byte order) is read as little-endian. 'Nothing' for other types.
typeOf :: ByteString -> Maybe (Number, Bool)
typeOf descr = do
  (order, name) <- C.uncons descr
  number <- lookup (C.unpack name) names
  if order `elem` "<=>|" && (order /= '|' || number == U1)
    then Just (number, order == '>')
    else Nothing

names :: [(String, Number)]
names = [("u1", U1), ("u2", U2), ("i2", I2), ("i4", I4), ("f4", F4), ("f8", F8)]

-- | A numpy file of an image. Arguments: whether a sample has two bytes (little-endian) and not
-- one; the numbers of columns and rows; the samples, row by row.
encodeNumpy :: Bool -> Int -> Int -> V.Vector Word16 -> ByteString
encodeNumpy wide columns rows samples =
  B.concat [magic, B.pack [1, 0], little (B.length header), header, readings]
  where
    readings
      | wide = B.concat (map (little . fromIntegral) (V.toList samples))
      | otherwise = B.pack (map fromIntegral (V.toList samples))
    little :: Int -> ByteString
    little n = B.pack [fromIntegral n, fromIntegral (n `quot` 256)]
    header = text <> C.replicate ((-(B.length text + 11)) `mod` 64) ' ' <> C.pack "\n"
    text =
      C.pack $
        "{'descr': '" ++ (if wide then "<u2" else "|u1") ++ "', 'fortran_order': False, 'shape': "
          ++ show (rows, columns)
          ++ ", }"
