{-# LANGUAGE OverloadedStrings #-}

-- | Conventions of all JSON of this project. Keys are stable. Integers above 2^53 - 1 are decimal
-- strings, because many JSON readers hold numbers as IEEE doubles.
module PraTactile.Format.Json
  ( encodeLine,
    encodeSchema,

    -- * Values
    naturalValue,
    integerValue,
    positionValue,
    positionListValue,
    shapeValue,
  )
where

import Data.Aeson
import Data.Aeson.Encoding (encodingToLazyByteString)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Text.Encoding.Error (lenientDecode)
import qualified Data.Text.Lazy.Encoding as Lazy
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))

-- | An object as one line without its line end, with the keys in the given order.
encodeLine :: Series -> Lazy.ByteString
encodeLine = valid . encodingToLazyByteString . pairs
  where
    -- The result is valid UTF-8 whatever the texts hold.
    valid = Lazy.encodeUtf8 . Lazy.decodeUtf8With lenientDecode

-- | An object of the named schema with these keys, as one line without its line end.
encodeSchema :: String -> Series -> ByteString
encodeSchema name keys = Lazy.toStrict (encodeLine ("schema" .= ("pra-tactile/" ++ name) <> keys))

-- | A number, or a decimal string if a double would round it.
naturalValue :: Natural -> Value
naturalValue = integerValue . toInteger

-- | An integer as a number, or as a decimal string if a double would round it.
integerValue :: Integer -> Value
integerValue n
  | abs n < 2 ^ (53 :: Int) = toJSON n
  | otherwise = toJSON (show n)

-- | A position as @{"row": r, "column": c}@.
positionValue :: Position -> Value
positionValue (Position r c) = object ["row" .= naturalValue r, "column" .= naturalValue c]

-- | A position as @[r, c]@, for lists.
positionListValue :: Position -> Value
positionListValue (Position r c) = toJSON [naturalValue r, naturalValue c]

-- | A shape as @[rows, columns]@.
shapeValue :: Shape -> Value
shapeValue (Shape high wide) = toJSON [naturalValue high, naturalValue wide]
