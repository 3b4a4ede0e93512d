{-# LANGUAGE OverloadedStrings #-}

-- | Reading JSON: every JSON text is read here, so that an object which has a key twice is refused
-- everywhere. Parsers of JSON keep one of the two in silence, and not all of them the same one (RFC
-- 8259, section 4).
module PraTactile.Format.Json.Strict
  ( readJson
  , repeatedKey
  ) where

import Data.Aeson (Value, decodeStrict, eitherDecodeStrict)
import Data.Bifunctor (first)
import qualified Data.ByteString.Char8 as Bytes
import Data.ByteString.Char8 (ByteString)
import qualified Data.Set as Set
import Data.Text (Text)

import PraTactile.Format.Error

-- | The value of a JSON text in UTF-8. Refuses what is no JSON, and an object anywhere in it that
-- has a key twice.
readJson :: ByteString -> Either FormatError Value
readJson text = do
  value <- first NotJson (eitherDecodeStrict text)
  maybe (Right value) (Left . RepeatedKey) (repeatedKey text)

-- | The first key that an object in a valid JSON text has a second time, however it is written:
-- @\"q\"@ is @\"\\u0071\"@. Of other texts it says nothing sensible.
repeatedKey :: ByteString -> Maybe Text
repeatedKey = go []
  where
    -- The keys so far of the objects and lists that are open, the innermost first; a list has none.
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
        (keys : others, Just name) | isKey ->
          if name `Set.member` keys then Just name else go (Set.insert name keys : others) following
        _ -> go open following

-- | Where a string ends: the index of the first quotation mark that no backslash escapes.
closing :: ByteString -> Int
closing text = case Bytes.findIndex (`Bytes.elem` "\"\\") text of
  Nothing -> Bytes.length text
  Just i
    | Bytes.index text i == '"' -> i
    | otherwise -> i + 2 + closing (Bytes.drop (i + 2) text)
