{-# LANGUAGE OverloadedStrings #-}

-- | Reading a line of the protocol. To a JSON library @2@, @2e0@ and @2.0e0@ may be one number;
-- here a whole number is one that is written as such, so that the others must stay distinct.
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

-- | The value of a JSON text, in which a number that is written with a fraction or an exponent has
-- a base-10 exponent other than 0: 2e0 becomes 20e-1. Refuses as
-- 'PraTactile.Format.Json.Strict.readJson' does, but numbers only of more than 'mostDigits' digits.
readLine :: ByteString -> Either JsonError Value
readLine = readJsonWith mostDigits . told

-- | How many digits a number may have, as a JSON number or as a decimal string: 4096.
mostDigits :: Int
mostDigits = 4096

-- | How many bytes a line may have: 1 MiB.
longestLine :: Int
longestLine = 1024 * 1024

-- | Whether a line has room for a text, which is made no further than that.
lineHolds :: Lazy.ByteString -> Bool
lineHolds = Lazy.null . Lazy.drop (fromIntegral longestLine)

-- | The text with another 0 behind the fraction of each number whose exponent makes it whole by as
-- many places as its fraction has: 20e-1 is not 2.
told :: ByteString -> ByteString
told text
  | Bytes.any (`Bytes.elem` "eE") text && any scientific (Bytes.findIndices isExponent text) =
    Bytes.concat (pieces text)
  | otherwise = text
  where
    isExponent c = c == 'e' || c == 'E'
    scientific i = i > 0 && isDigit (Bytes.index text (i - 1))

-- | The text in pieces, strings and numbers whole.
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

-- | A number with an exponent that its fraction does not undo; others as they are.
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
