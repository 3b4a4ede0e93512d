{-# LANGUAGE OverloadedStrings #-}

-- | What all JSON of this project has in common. Keys are promises; integers above 2^53 - 1 are
-- decimal strings, because many readers of JSON hold numbers as IEEE doubles.
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

-- | An object on one line, without its end, its keys in the order given.
encodeLine :: Series -> Lazy.ByteString
encodeLine = valid . encodingToLazyByteString . pairs
  where
    -- Whatever was in a text, JSON is UTF-8.
    valid = Lazy.encodeUtf8 . Lazy.decodeUtf8With lenientDecode

-- | An object of this schema of ours with these keys, on one line, without its end.
encodeSchema :: String -> Series -> ByteString
encodeSchema name keys = Lazy.toStrict (encodeLine ("schema" .= ("pra-tactile/" ++ name) <> keys))

-- | A number, or a decimal string where a double would round it.
naturalValue :: Natural -> Value
naturalValue = integerValue . toInteger

-- | Like 'naturalValue'.
integerValue :: Integer -> Value
integerValue n
  | abs n < 2 ^ (53 :: Int) = toJSON n
  | otherwise = toJSON (show n)

-- | A position as @{"row": r, "column": c}@.
positionValue :: Position -> Value
positionValue (Position r c) = object ["row" .= naturalValue r, "column" .= naturalValue c]

-- | A position as @[r, c]@, where many are listed.
positionListValue :: Position -> Value
positionListValue (Position r c) = toJSON [naturalValue r, naturalValue c]

-- | A shape as @[rows, columns]@.
shapeValue :: Shape -> Value
shapeValue (Shape high wide) = toJSON [naturalValue high, naturalValue wide]
