{-# LANGUAGE OverloadedStrings #-}

-- | From JSON values to what they stand for, each refusal with its cause and its place.
module PraTactile.Format.Json.Read
  ( Decoder,
    decodeWith,
    refuse,

    -- * Values
    listOf,
    text,
    natural,
    real,
    pairOf,
    shape,
    named,

    -- * Objects
    object,
    field,
    schemaIs,
  )
where

import Data.Aeson (Key, Object, Value (..))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (JSONPathElement (..))
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Char (isDigit)
import Data.Foldable (toList)
import Data.List (find)
import Data.Scientific (Scientific, floatingOrInteger, toBoundedRealFloat)
import qualified Data.Text as Text
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..))
import PraTactile.Format.Error
import PraTactile.Format.Json.Strict

-- | From a value to what it stands for.
type Decoder a = Value -> Either FormatError a

-- | What a JSON text stands for, by what its value stands for.
decodeWith :: Decoder a -> ByteString -> Either FormatError a
decodeWith decoder bytes = first JsonRefused (readJson bytes) >>= decoder

-- | Something is wrong right here.
refuse :: Misfit -> Either FormatError a
refuse = Left . Misfit []

-- | Where a value is refused, its place begins with this step.
within :: JSONPathElement -> Either FormatError a -> Either FormatError a
within step = first $ \why -> case why of
  Misfit place misfit -> Misfit (step : place) misfit
  _ -> why

-- | A list of such values.
listOf :: Decoder a -> Decoder [a]
listOf decoder value = case value of
  Array values -> traverse element (zip [0 ..] (toList values))
  _ -> refuse NotList
  where
    element (i, item) = within (Index i) (decoder item)

-- | A text.
text :: Decoder String
text value = case value of
  String given -> Right (Text.unpack given)
  _ -> refuse NotText

-- | A natural number: a JSON number below 10^18, or a decimal string of at most 10000 digits.
natural :: Decoder Natural
natural value = case value of
  Number n | Right i <- whole n, i >= 0 -> Right (fromInteger i)
  String given
    | not (Text.null given),
      Text.all isDigit given ->
      if Text.compareLength given mostDigits == GT
        then refuse (NaturalTooLong mostDigits)
        else Right (read (Text.unpack given))
  _ -> refuse NotNatural
  where
    whole :: Scientific -> Either Double Integer
    whole n = if abs n < 1e18 then floatingOrInteger n else Left 0
    mostDigits = 10000

-- | A number, as a double has it; what is too large for one is refused, however it is written:
-- 1e400, or with 400 zeros, which 'toBoundedRealFloat' alone takes for infinity.
real :: Decoder Double
real value = case value of
  Number n | Right x <- toBoundedRealFloat n, not (isInfinite x) -> Right x
  _ -> refuse NotReal

-- | A list of two such values.
pairOf :: Decoder a -> Decoder (a, a)
pairOf decoder value =
  listOf decoder value >>= \given -> case given of
    [a, b] -> Right (a, b)
    _ -> refuse NotPair

-- | A shape as a list of two numbers, rows and columns.
shape :: Decoder Shape
shape value =
  listOf natural value >>= \given -> case given of
    [high, wide] -> Right (Shape high wide)
    _ -> refuse NotShape

-- | One of all values of a type, by its name.
named :: (Bounded a, Enum a) => (a -> String) -> Decoder a
named nameOf value = do
  given <- text value
  maybe (refuse (NotAmong (map nameOf choices) given)) Right (find ((== given) . nameOf) choices)
  where
    choices = [minBound ..]

-- | The fields of an object.
object :: Decoder Object
object value = case value of
  Object fields -> Right fields
  _ -> refuse NotObject

-- | What an object has under a key.
field :: Key -> Decoder a -> Object -> Either FormatError a
field key decoder fields = case KeyMap.lookup key fields of
  Just value -> within (Key key) (decoder value)
  Nothing -> refuse (MissingKey (Key.toText key))

-- | Refuse an object of another schema than this.
schemaIs :: String -> Object -> Either FormatError ()
schemaIs schema fields =
  field "schema" text fields >>= \given ->
    if given == schema then Right () else refuse (OtherSchema given schema)
