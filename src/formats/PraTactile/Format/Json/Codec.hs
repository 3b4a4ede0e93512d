{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE OverloadedStrings #-}

-- | JSON formats, each described once: a 'Codec' writes a value, reads it back, and has a schema.
-- 'Keys' describe the keys of an object in the same way. Each refusal has a cause and a place.
module PraTactile.Format.Json.Codec
  ( -- * Values
    Codec (..),
    FromValue,
    refuse,
    writeValue,
    readValue,
    schemaOf,
    malformedOf,
    via,
    withSchema,
    anything,
    listOf,
    distinct,
    satisfying,
    nullable,
    text,
    fileName,
    bool,
    natural,
    integer,
    int,
    real,
    pairOf,
    shape,
    position,
    positionPair,
    named,
    among,
    exactOr,
    quarterTurn,

    -- * Objects
    Keys,
    key,
    optionalKey,
    optionalKeys,
    withKeys,
    schemaKey,
    object,
    objectOf,
    writeLine,
    writeObject,
    series,
    readKeys,
    field,
    decodeWith,
    decodeObject,
  )
where

import Control.Monad ((>=>))
import Data.Aeson (Key, Object, Series, ToJSON, Value (..), toJSON, (.=))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (JSONPathElement (..))
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isDigit)
import Data.Foldable (toList)
import Data.List (find)
import Data.Scientific (Scientific, floatingOrInteger, toBoundedRealFloat)
import qualified Data.Set as Set
import qualified Data.Text as Text
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.FileName (isFileName)
import PraTactile.Format.Error
import PraTactile.Format.Json
import PraTactile.Format.Json.Schema (Schema)
import qualified PraTactile.Format.Json.Schema as Schema
import PraTactile.Format.Json.Strict

-- | Reads a value of type @a@ from JSON.
type FromValue a = Value -> Either FormatError a

-- | A schema, a writer and a reader.
data Codec a = forall w. ToJSON w => Codec Schema (a -> w) (FromValue a)

-- | Writes a value as JSON.
writeValue :: Codec a -> a -> Value
writeValue (Codec _ write _) = toJSON . write

-- | Reads a value from JSON.
readValue :: Codec a -> FromValue a
readValue (Codec _ _ fromValue) = fromValue

-- | The schema of a codec's JSON values.
schemaOf :: Codec a -> Schema
schemaOf (Codec schema _ _) = schema

-- | Invalid JSON values for an object's codec, derived from a valid one.
malformedOf :: Codec a -> a -> [Value]
malformedOf codec a = Schema.malformed (schemaOf codec) (writeValue codec a)

-- | Converts a codec to another type by functions back and there.
via :: (b -> a) -> (a -> Either FormatError b) -> Codec a -> Codec b
via back there (Codec schema write decoder) = Codec schema (write . back) (decoder >=> there)

-- | Replaces the schema of a codec.
withSchema :: (Schema -> Schema) -> Codec a -> Codec a
withSchema change (Codec schema write decoder) = Codec (change schema) write decoder

-- | A refusal at this place.
refuse :: Misfit -> Either FormatError a
refuse = Left . Misfit []

-- | Prefixes the place of a refusal with a step.
atElement :: JSONPathElement -> Either FormatError a -> Either FormatError a
atElement step = first $ \why -> case why of
  Misfit place misfit -> Misfit (step : place) misfit
  _ -> why

-- | Any JSON value.
anything :: Codec Value
anything = Codec Schema.Anything id Right

-- | A list of values.
listOf :: Codec a -> Codec [a]
listOf (Codec schema write decoder) = Codec (Schema.list schema) (map write) $
  \value -> case value of
    Array values -> traverse item (zip [0 ..] (toList values))
    _ -> refuse NotList
  where
    item (i, value) = atElement (Index i) (decoder value)

-- | A list without repetition. The first function gives the key that must differ; the second names
-- a repeated key.
distinct :: Ord k => (a -> k) -> (k -> String) -> Codec [a] -> Codec [a]
distinct part name (Codec schema write decoder) =
  Codec schema write $ \value ->
    decoder value >>= \given -> go Set.empty (zip [0 ..] given) >> Right given
  where
    go _ [] = Right ()
    go before ((i, a) : others)
      | part a `Set.member` before = atElement (Index i) (refuse (GivenTwice (name (part a))))
      | otherwise = go (Set.insert (part a) before) others

-- | Restricts a codec to values that satisfy the test; others are refused with the given misfit.
satisfying :: (a -> Bool) -> Misfit -> Codec a -> Codec a
satisfying holds misfit = via id (\a -> if holds a then Right a else refuse misfit)

-- | A value or null.
nullable :: Codec a -> Codec (Maybe a)
nullable (Codec schema write decoder) = Codec (Schema.orNull schema) (fmap write) $ \value ->
  case value of
    Null -> Right Nothing
    _ -> Just <$> decoder value

-- | A text.
text :: Codec String
text = Codec (Schema.Text []) id $ \value -> case value of
  String given -> Right (Text.unpack given)
  _ -> refuse NotText

-- | A file name.
fileName :: Codec FilePath
fileName = satisfying isFileName NotFileName text

-- | True or false.
bool :: Codec Bool
bool = Codec Schema.Boolean id $ \value -> case value of
  Bool given -> Right given
  _ -> refuse NotBool

-- | A natural number: a JSON number below 10^18, or a decimal string of at most 10000 digits.
natural :: Codec Natural
natural = Codec Schema.Natural naturalValue $ \value -> case value of
  String given
    | not (Text.null given),
      Text.all isDigit given ->
      if Text.compareLength given mostDigits == GT
        then refuse (NaturalTooLong mostDigits)
        else Right (read (Text.unpack given))
  _ | Just i <- wholeNumber value, i >= 0 -> Right (fromInteger i)
  _ -> refuse NotNatural
  where
    mostDigits = 10000

-- | An integer between -10^18 and 10^18, both exclusive.
integer :: Codec Integer
integer = Codec Schema.Integer id (maybe (refuse NotInteger) Right . wholeNumber)

-- | An integer between -10^18 and 10^18 as an 'Int'.
int :: Codec Int
int = via toInteger (Right . fromInteger) integer

wholeNumber :: Value -> Maybe Integer
wholeNumber value = case value of
  Number n | abs n < 1e18, Right i <- whole n -> Just i
  _ -> Nothing
  where
    whole :: Scientific -> Either Double Integer
    whole = floatingOrInteger

-- | A number in the range of a double. Refuses numbers that are too large, or too small without
-- being 0, in any notation. 'toBoundedRealFloat' alone reads 1 with 400 zeros as infinity.
real :: Codec Double
real = Codec (Schema.Real []) id $ \value -> case value of
  Number n | Right x <- toBoundedRealFloat n, not (isInfinite x) -> Right x
  _ -> refuse NotReal

-- | A list of two values.
pairOf :: Codec a -> Codec (a, a)
pairOf = listOfTwo NotPair (,) (\(a, b) -> [a, b])

-- | A shape as a list of two numbers, rows and columns.
shape :: Codec Shape
shape = listOfTwo NotShape Shape (\(Shape high wide) -> [high, wide]) natural

-- | A position as @[r, c]@, for lists.
positionPair :: Codec Position
positionPair = listOfTwo NotCell Position (\(Position r c) -> [r, c]) natural

listOfTwo :: Misfit -> (a -> a -> b) -> (b -> [a]) -> Codec a -> Codec b
listOfTwo misfit make parts codec =
  withSchema (const (Schema.listOfLength 2 (schemaOf codec))) . via parts two $ listOf codec
  where
    two given = case given of
      [a, b] -> Right (make a b)
      _ -> refuse misfit

-- | A position as @{"row": r, "column": c}@.
position :: Codec Position
position = object (Position <$> key "row" natural row <*> key "column" natural column)

-- | A value of an enumeration, by its name.
named :: (Bounded a, Enum a) => (a -> String) -> Codec a
named nameOf = among nameOf [minBound ..]

-- | One of the listed values, by its name.
among :: (a -> String) -> [a] -> Codec a
among nameOf choices = withSchema (const (Schema.OneOf names)) (via nameOf called text)
  where
    called given =
      maybe (refuse (NotAmong (map nameOf choices) given)) Right $
        find ((== given) . nameOf) choices
    names = map (Text.pack . nameOf) choices

-- | Whether a number is exact: the text @exact@, or the name of the kind of bound.
exactOr :: String -> Codec Bool
exactOr bound = named (\exact -> if exact then "exact" else bound)

-- | A number of quarter turns, as degrees: 0, 90, 180 or 270.
quarterTurn :: Codec Int
quarterTurn = via ((90 *) . fromIntegral) turns natural
  where
    turns degrees =
      maybe (refuse NotQuarterTurn) Right (find ((== degrees) . fromIntegral . (90 *)) [0 .. 3])

-- | Keys of an object: their names, whether they are required, and their schemas; the items
-- written for an @r@, in order, in front of others; and how an @a@ is read.
data Keys r a = Keys [(Key, Bool, Schema)] (r -> [Item] -> [Item]) (Object -> Either FormatError a)

data Item = forall w. ToJSON w => Item Key w

instance Functor (Keys r) where
  fmap f (Keys fields write decoder) = Keys fields write (fmap f . decoder)

instance Applicative (Keys r) where
  pure a = Keys [] (const id) (const (Right a))
  Keys fields write decoder <*> Keys fields' write' decoder' =
    Keys
      (fields ++ fields')
      (\r -> write r . write' r)
      (\given -> decoder given <*> decoder' given)

-- | A required key, with the field of the whole that it holds.
key :: Key -> Codec a -> (r -> a) -> Keys r a
key name (Codec schema write decoder) part =
  Keys [(name, True, schema)] (\r -> (Item name (write (part r)) :)) $ \fields ->
    case KeyMap.lookup name fields of
      Just value -> atElement (Key name) (decoder value)
      Nothing -> refuse (MissingKey (Key.toText name))

-- | A key that is absent if its value is 'Nothing'.
optionalKey :: Key -> Codec a -> (r -> Maybe a) -> Keys r (Maybe a)
optionalKey name codec = optionalKeys name (key name codec id)

-- | Keys that are either all there or all absent. The first argument is the key that decides.
optionalKeys :: Key -> Keys s a -> (r -> Maybe s) -> Keys r (Maybe a)
optionalKeys name (Keys fields write decoder) part =
  Keys [(one, False, schema) | (one, _, schema) <- fields] (maybe id write . part) $ \given ->
    if KeyMap.member name given then Just <$> decoder given else Right Nothing

-- | The keys of a field, as keys of the whole.
withKeys :: (r -> s) -> Keys s a -> Keys r a
withKeys part (Keys fields write decoder) = Keys fields (write . part) decoder

-- | The key @schema@. Refuses any other schema.
schemaKey :: String -> Keys r ()
schemaKey wanted = Keys fields (const (Item "schema" wanted :)) $ \given -> do
  stated <- readKeys (key "schema" text (const wanted)) given
  if stated == wanted then Right () else refuse (OtherSchema stated wanted)
  where
    fields = [("schema", True, Schema.OneOf [Text.pack wanted])]

-- | An object with these keys; further keys are ignored.
object :: Keys a a -> Codec a
object keys@(Keys fields _ _) =
  Codec (Schema.Object fields) (writeObject keys) (objectOf >=> readKeys keys)

-- | The JSON object with these keys.
writeObject :: Keys r a -> r -> Object
writeObject (Keys _ write _) r =
  KeyMap.fromList [(name, toJSON part) | Item name part <- write r []]

-- | The encoder of these keys, in their order.
series :: Keys r a -> r -> Series
series (Keys _ write _) r = mconcat [name .= part | Item name part <- write r []]

-- | An object with these keys as one line, without its line end.
writeLine :: Keys r a -> r -> ByteString
writeLine keys = Lazy.toStrict . encodeLine . series keys

-- | Reads the keys of a JSON object.
readKeys :: Keys r a -> Object -> Either FormatError a
readKeys (Keys _ _ decoder) = decoder

-- | Reads the value of one key of an object.
field :: Key -> Codec a -> Object -> Either FormatError a
field name codec = readKeys (key name codec id)

-- | The fields of an object.
objectOf :: FromValue Object
objectOf value = case value of
  Object fields -> Right fields
  _ -> refuse NotObject

-- | Reads an object with these keys from a JSON text.
decodeWith :: Keys r a -> ByteString -> Either FormatError a
decodeWith = decodeObject . readKeys

-- | Reads an object from a JSON text with a reader that may depend on the keys that it finds.
decodeObject :: (Object -> Either FormatError a) -> ByteString -> Either FormatError a
decodeObject decoder bytes = first JsonRefused (readJson bytes) >>= objectOf >>= decoder
