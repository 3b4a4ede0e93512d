-- | The one text of a JSON value, so that equal values have equal digests whoever computes them.
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

-- | Keys sorted, no white space; given how numbers are written.
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
