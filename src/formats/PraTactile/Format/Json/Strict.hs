{-# LANGUAGE OverloadedStrings #-}

-- | The reader of all JSON texts. It refuses everything that libraries accept silently, or only at
-- a disproportionate cost in time or memory.
module PraTactile.Format.Json.Strict
  ( readJson,
    readJsonWith,

    -- * Bounds
    deepest,
    longestNumber,

    -- * Keys and strings
    repeatedKey,
    closing,
  )
where

import Data.Aeson (Value, decodeStrict)
import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (isDigit)
import qualified Data.Set as Set
import Data.Text (Text)
import Data.Text.Encoding (decodeUtf8')
import PraTactile.Format.Error
import PraTactile.PlainText

-- | Reads a JSON text in UTF-8, with or without a byte order mark. Refuses invalid JSON. Refuses
-- deep nesting, which takes many times its own size in memory, and numbers of very many digits,
-- which aeson reads in quadratic time. Refuses an object with a repeated key, of which parsers keep
-- different ones (RFC 8259, section 4).
readJson :: ByteString -> Either JsonError Value
readJson = readJsonWith longestNumber

-- | 'readJson' for numbers with at most the given number of digits.
readJsonWith :: Int -> ByteString -> Either JsonError Value
readJsonWith digits = either (Left . JsonInEncoding) (readPlain digits) . plainText

-- | Reads a JSON text without a byte order mark.
readPlain :: Int -> ByteString -> Either JsonError Value
readPlain digits text
  | Bytes.all (`Bytes.elem` " \t\r\n") text = Left NoText
  | Just why <- excess digits text = Left why
  | Left _ <- decodeUtf8' text = Left NotUtf8
  | otherwise = maybe (Left NotJson) unrepeated (decodeStrict text)
  where
    unrepeated value = maybe (Right value) (Left . RepeatedKey) (repeatedKey text)

-- | The greatest depth of nested brackets: 64.
deepest :: Int
deepest = 64

-- | The greatest number of consecutive digits of a number that is not a string: 1000.
longestNumber :: Int
longestNumber = 1000

-- | Why a text is refused, if it is nested too deeply or has too many consecutive digits outside
-- strings. The number is the greatest number of digits.
excess :: Int -> ByteString -> Maybe JsonError
excess most = go 0
  where
    go :: Int -> ByteString -> Maybe JsonError
    go open text
      | open > deepest = Just TooDeep
      | otherwise = case Bytes.uncons (Bytes.dropWhile (`Bytes.notElem` "{}[]\"0123456789") text) of
        Nothing -> Nothing
        Just ('"', rest) -> go open (Bytes.drop (closing rest + 1) rest)
        Just (c, rest)
          | isDigit c ->
            let (digits, others) = Bytes.span isDigit rest
             in if Bytes.length digits >= most then Just TooLong else go open others
          | otherwise -> go (if c `Bytes.elem` "{[" then open + 1 else open - 1) rest

-- | The first repeated key of an object in a valid JSON text, in any notation: @\"q\"@ equals
-- @\"\\u0071\"@. For invalid texts the result is meaningless.
repeatedKey :: ByteString -> Maybe Text
repeatedKey = go []
  where
    -- The keys so far of the open objects and lists, innermost first; a list has none.
    go open text = case Bytes.uncons (Bytes.dropWhile (`Bytes.notElem` "{}[]\"") text) of
      Nothing -> Nothing
      Just ('"', rest) -> string open rest
      Just (opening, rest)
        | opening `Bytes.elem` "{[" -> go (Set.empty : open) rest
        | otherwise -> go (drop 1 open) rest
    string open rest =
      let (inside, after) = Bytes.splitAt (closing rest) rest
          following = Bytes.drop 1 after
          isKey = ":" `Bytes.isPrefixOf` Bytes.dropWhile (`Bytes.elem` " \t\r\n") following
       in case (open, decodeStrict ("\"" <> inside <> "\"")) of
            (keys : others, Just name)
              | isKey ->
                if name `Set.member` keys
                  then Just name
                  else go (Set.insert name keys : others) following
            _ -> go open following

-- | The index of the quotation mark that ends a string: the first that is not escaped. The text
-- begins after the opening one. The text's length, or up to 1 more, if none ends it.
closing :: ByteString -> Int
closing = go 0
  where
    go past text = case Bytes.findIndex (`Bytes.elem` "\"\\") text of
      Nothing -> past + Bytes.length text
      Just i
        | Bytes.index text i == '"' -> past + i
        | otherwise -> go (past + i + 2) (Bytes.drop (i + 2) text)
