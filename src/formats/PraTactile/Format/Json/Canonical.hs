-- | The canonical text of a JSON value: equal values have equal digests.
module PraTactile.Format.Json.Canonical
  ( canonicalWith,
  )
where

import Data.Aeson (Value (..), encode)
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import Data.Foldable (toList)
import Data.List (intersperse, sortOn)
import Data.Scientific (Scientific)

-- | A JSON value with sorted keys and without white space. The function writes a number.
canonicalWith :: (Scientific -> Builder) -> Value -> Builder
canonicalWith number = go
  where
    go value = case value of
      Object fields ->
        listed '{' '}' (map member (sortOn fst (map named (KeyMap.toList fields))))
      Array parts -> listed '[' ']' (map go (toList parts))
      Number n -> number n
      _ -> Builder.lazyByteString (encode value)
    named (key, part) = (Key.toText key, part)
    member (name, part) =
      Builder.lazyByteString (encode name) <> Builder.char7 ':' <> go part
    listed open close parts =
      Builder.char7 open <> mconcat (intersperse (Builder.char7 ',') parts) <> Builder.char7 close
