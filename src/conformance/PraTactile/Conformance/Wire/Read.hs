{-# LANGUAGE OverloadedStrings #-}

-- | Reading the values of the protocol: each gives 'Nothing' for a value of another type.
module PraTactile.Conformance.Wire.Read
  ( readObject,
    readKey,
    readItems,
    readNullable,
    readBool,
    readText,
    readReal,
    readNatural,
    readWhole,
    readTwo,
  )
where

import Control.Monad ((>=>))
import Data.Aeson (Object, Value (..))
import Data.Aeson.Key (Key)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Char (isDigit)
import Data.Foldable (toList)
import Data.Scientific (base10Exponent, coefficient, toBoundedRealFloat)
import qualified Data.Text as Text
import Numeric.Natural (Natural)
import PraTactile.Conformance.Wire.Line (mostDigits)

readObject :: Value -> Maybe Object
readObject value = case value of
  Object fields -> Just fields
  _ -> Nothing

readKey :: Key -> (Value -> Maybe a) -> Object -> Maybe a
readKey name reader = KeyMap.lookup name >=> reader

readItems :: (Value -> Maybe a) -> Value -> Maybe [a]
readItems reader value = case value of
  Array values -> traverse reader (toList values)
  _ -> Nothing

readNullable :: (Value -> Maybe a) -> Value -> Maybe (Maybe a)
readNullable reader value = case value of
  Null -> Just Nothing
  _ -> Just <$> reader value

readBool :: Value -> Maybe Bool
readBool value = case value of
  Bool given -> Just given
  _ -> Nothing

-- | A number that a double has.
readReal :: Value -> Maybe Double
readReal value = case value of
  Number n | Right x <- toBoundedRealFloat n, not (isInfinite x) -> Just x
  _ -> Nothing

readNatural :: Value -> Maybe Natural
readNatural value = case readWhole value of
  Just i | i >= 0 -> Just (fromInteger i)
  _ -> Nothing

readText :: Value -> Maybe String
readText value = case value of
  String given -> Just (Text.unpack given)
  _ -> Nothing

-- | A list of two such values.
readTwo :: (Value -> Maybe a) -> Value -> Maybe (a, a)
readTwo reader = readItems reader >=> two
  where
    two values = case values of
      [a, b] -> Just (a, b)
      _ -> Nothing

-- | A whole number, written as one or as a decimal string of at most 'mostDigits' digits. A JSON
-- number with a fraction or an exponent is none, whatever its value;
-- "PraTactile.Conformance.Wire.Line" reads texts so that it can be told.
readWhole :: Value -> Maybe Integer
readWhole value = case value of
  Number n | base10Exponent n == 0 -> Just (coefficient n)
  String given
    | Just digits <- Text.stripPrefix "-" given -> negate <$> decimal digits
    | otherwise -> decimal given
  _ -> Nothing
  where
    decimal digits
      | not (Text.null digits),
        Text.all isDigit digits,
        Text.compareLength digits mostDigits /= GT =
        Just (read (Text.unpack digits))
      | otherwise = Nothing
