{-# LANGUAGE OverloadedStrings #-}

-- | Reads a line of the protocol. JSON libraries may read @2@, @2e0@ and @2.0e0@ as one number.
-- The protocol accepts only the first as an integer, so this reader keeps them distinct.
module PraTactile.Conformance.Wire.Line
  ( readLine,
    mostDigits,
    longestLine,
    lineHolds,
  )
where

import Data.Aeson (Value)
import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isDigit)
import PraTactile.Format.Error (JsonError)
import PraTactile.Format.Json.Strict (closing, readJsonWith)

-- | The value of a JSON text, in which a number written with a fraction or an exponent gets a
-- base-10 exponent other than 0: 2e0 becomes 20e-1. Refuses what
-- 'PraTactile.Format.Json.Strict.readJson' refuses, but allows numbers of up to 'mostDigits'
-- digits.
readLine :: ByteString -> Either JsonError Value
readLine = readJsonWith mostDigits . told

-- | The greatest number of digits of a number, as JSON number or decimal string: 4096.
mostDigits :: Int
mostDigits = 4096

-- | The greatest number of bytes of a line: 1 MiB.
longestLine :: Int
longestLine = 1024 * 1024

-- | Whether a text fits into a line. It evaluates no more than that.
lineHolds :: Lazy.ByteString -> Bool
lineHolds = Lazy.null . Lazy.drop (fromIntegral longestLine)

-- | Appends a 0 to the fraction of each number whose exponent cancels its fraction exactly: 20e-1
-- instead of 2.
told :: ByteString -> ByteString
told text
  | Bytes.any (`Bytes.elem` "eE") text && any scientific (Bytes.findIndices isExponent text) =
    Bytes.concat (pieces text)
  | otherwise = text
  where
    isExponent c = c == 'e' || c == 'E'
    scientific i = i > 0 && isDigit (Bytes.index text (i - 1))

-- | The text in pieces; strings and numbers are whole.
pieces :: ByteString -> [ByteString]
pieces text = case Bytes.uncons others of
  Nothing -> [plain]
  Just ('"', rest) ->
    let end = closing rest + 1
     in plain : "\"" : Bytes.take end rest : pieces (Bytes.drop end rest)
  _ ->
    let (number, after) = Bytes.span (\c -> isDigit c || c `Bytes.elem` ".eE+-") others
     in plain : marked number : pieces after
  where
    (plain, others) = Bytes.break (\c -> c == '"' || isDigit c) text

-- | A number whose exponent no longer cancels its fraction; other numbers are unchanged.
marked :: ByteString -> ByteString
marked number
  | Bytes.null exponent' || places /= Just (Bytes.length fraction') = number
  | Bytes.null point = mantissa <> ".0" <> exponent'
  | otherwise = mantissa <> "0" <> exponent'
  where
    (mantissa, exponent') = Bytes.break (`Bytes.elem` "eE") number
    point = Bytes.dropWhile (/= '.') mantissa
    fraction' = Bytes.drop 1 point
    places = case Bytes.readInt (unsigned (Bytes.drop 1 exponent')) of
      Just (n, "") -> Just n
      _ -> Nothing
    unsigned digits = if "+" `Bytes.isPrefixOf` digits then Bytes.drop 1 digits else digits
