{-# LANGUAGE OverloadedStrings #-}

-- | From JSON values to what they stand for, each refusal with its cause and its place.
module PraTactile.Format.Json.Read
  ( decodeAs
    -- * Objects and lists
  , objectAs
  , field
  , part
  , each
    -- * Values
  , hasSchema
  , natural
  , naturals
  , shape
  , named
  ) where

import Control.Monad (unless)
import Data.Aeson
import Data.Aeson.Types (JSONPathElement (..), Parser, parseEither)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Char (isDigit)
import Data.List (find)
import Data.Scientific (Scientific, floatingOrInteger)
import qualified Data.Text as Text
import Numeric.Natural (Natural)

import PraTactile.Array (Shape (..))
import PraTactile.Format.Error
import PraTactile.Format.Json.Strict

-- | What a JSON text stands for, by what its value stands for.
decodeAs :: (Value -> Either FormatError a) -> ByteString -> Either FormatError a
decodeAs use text = readJson text >>= use

-- | The fields of an object; the name is what the JSON library calls it where it is something else.
objectAs :: String -> Value -> Either FormatError Object
objectAs name = typed (withObject name pure)

-- | The value of a key, of the type that it must have.
field :: FromJSON a => Object -> Key -> Either FormatError a
field o key = typed (.: key) o

-- | The value of a key, read further; where that is refused, the place has the key.
part :: FromJSON a => Object -> Key -> (a -> Either FormatError b) -> Either FormatError b
part o key use = field o key >>= within (Key key) . use

-- | All values of a list, read further.
each :: (a -> Either FormatError b) -> [a] -> Either FormatError [b]
each use = traverse (\(i, value) -> within (Index i) (use value)) . zip [0 ..]

-- | Run a parser of the JSON library.
typed :: (a -> Parser b) -> a -> Either FormatError b
typed parser = first (Misfit [] . OtherType) . parseEither parser

-- | Where a value is refused, its place begins with this step.
within :: JSONPathElement -> Either FormatError a -> Either FormatError a
within step = first deeper
  where
    deeper why = case why of
      Misfit place misfit -> Misfit (step : place) misfit
      _ -> why

refuse :: Misfit -> Either FormatError a
refuse = Left . Misfit []

-- | That an object states this schema.
hasSchema :: String -> Object -> Either FormatError ()
hasSchema expected o = part o "schema" $ \form ->
  unless (form == expected) (refuse (OtherSchema form expected))

-- | A natural number: a JSON number below 10^18, or a decimal string.
natural :: Value -> Either FormatError Natural
natural value = case value of
  Number n | Right i <- whole n, i >= 0 -> Right (fromInteger i)
  String digits | text <- Text.unpack digits, not (null text), all isDigit text -> Right (read text)
  _ -> refuse NotNatural
  where
    whole :: Scientific -> Either Double Integer
    whole n = if abs n < 1e18 then floatingOrInteger n else Left 0

-- | A list of natural numbers.
naturals :: [Value] -> Either FormatError [Natural]
naturals = each natural

-- | A shape as a list of two numbers, rows and columns.
shape :: [Value] -> Either FormatError Shape
shape value = case value of
  [high, wide] -> Shape <$> natural high <*> natural wide
  _ -> refuse NotShape

-- | One of all values of a type, by its name.
named :: (Bounded a, Enum a) => (a -> String) -> String -> Either FormatError a
named nameOf text =
  maybe (refuse (NotAmong (map nameOf choices) text)) Right (find ((== text) . nameOf) choices)
  where
    choices = [minBound ..]
