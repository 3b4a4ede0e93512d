{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}
-- | From JSON to what it says, with complaints in plain words that name the place:
-- @profile.shape[1]: a number 0, 1, 2, ... is needed@.
module Json.Decode
  ( -- * Decoding
    Decoder
  , decodeWith
  , Complaint (..)
  , complaintText
  , refuse
    -- * Values
  , listOf
  , list
  , text
  , number
  , real
  , pairOf
  , named
    -- * Objects
  , Fields
  , object
  , field
  , schemaIs
  ) where

import Data.Aeson (Value (..))
import Data.Aeson.Key (Key)
import qualified Data.Aeson.Key as Key
import Data.Aeson.KeyMap (KeyMap)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Char (isDigit)
import Data.Foldable (toList)
import Data.Scientific (Scientific, floatingOrInteger, toBoundedRealFloat)
import qualified Data.Text as Text
import Numeric.Natural (Natural)

import JsonInput
import Visible

-- | From text to what it says; 'Left' is a clause that says what is wrong.
decodeWith :: Decoder a -> ByteString -> Either String a
decodeWith decoder bytes = first jsonFaultMessage (readJson bytes) >>= first complaintText . decoder

-- | From a value to what it says.
type Decoder a = Value -> Either Complaint a

-- | Where something is wrong, by keys and indices from the outermost, and what.
data Complaint = Complaint [Step] String
  deriving stock (Eq, Show)

data Step = Under Key | At Int
  deriving stock (Eq, Show)

-- | The place and what is wrong there.
complaintText :: Complaint -> String
complaintText (Complaint path what) = case path of
  [] -> what
  Under key : others -> visible (Key.toString key) ++ concatMap step others ++ ": " ++ what
  others -> concatMap step others ++ ": " ++ what
  where
    step (Under key) = '.' : visible (Key.toString key)
    step (At i) = "[" ++ show i ++ "]"

-- | Something is wrong right here.
refuse :: String -> Either Complaint a
refuse = Left . Complaint []

within :: Step -> Either Complaint a -> Either Complaint a
within step = first (\(Complaint path what) -> Complaint (step : path) what)

-- | A list.
list :: Decoder [Value]
list value = case value of
  Array values -> Right (toList values)
  _ -> refuse "a list is needed"

-- | A list of such values.
listOf :: Decoder a -> Decoder [a]
listOf decoder value = list value >>= traverse (\(i, item) -> within (At i) (decoder item)) . zip [0 ..]

-- | A text.
text :: Decoder String
text value = case value of
  String given -> Right (Text.unpack given)
  _ -> refuse "a text is needed"

-- | A natural number, as a JSON number or a decimal string of at most 10000 digits.
number :: Decoder Natural
number value = case value of
  Number n | Right i <- whole n, i >= 0 -> Right (fromInteger i)
  String given
    | not (Text.null given), Text.all isDigit given ->
        if Text.compareLength given mostDigits == GT
          then refuse ("a number has at most " ++ show mostDigits ++ " digits")
          else Right (read (Text.unpack given))
  _ -> refuse "a number 0, 1, 2, ... is needed"
  where
    whole :: Scientific -> Either Double Integer
    whole n = if abs n < 1e18 then floatingOrInteger n else Left 0
    mostDigits = 10000

-- | A number, as a double has it; what is too large for one is refused.
real :: Decoder Double
real value = case value of
  Number n | Right x <- toBoundedRealFloat n -> Right x
  _ -> refuse "a number is needed"

-- | A list of two such values.
pairOf :: Decoder a -> Decoder (a, a)
pairOf decoder value = listOf decoder value >>= \given -> case given of
  [a, b] -> Right (a, b)
  _ -> refuse "a list of two is needed"

-- | One of these by its name.
named :: (a -> String) -> [a] -> Decoder a
named name choices value = do
  given <- text value
  case [ c | c <- choices, name c == given ] of
    c : _ -> Right c
    [] -> refuse (quoted given ++ " is not one of " ++ unwords (map name choices))

-- | What an object has.
type Fields = KeyMap Value

-- | An object.
object :: Decoder Fields
object value = case value of
  Object fields -> Right fields
  _ -> refuse "an object is needed"

-- | What an object has under a key.
field :: Key -> Decoder a -> Fields -> Either Complaint a
field key decoder fields = case KeyMap.lookup key fields of
  Just value -> within (Under key) (decoder value)
  Nothing -> refuse ("the key " ++ quoted (Key.toString key) ++ " is missing")

-- | Refuse an object of another form than this.
schemaIs :: String -> Fields -> Either Complaint ()
schemaIs schema fields = field "schema" text fields >>= \given ->
  if given == schema then Right () else refuse ("its schema is " ++ quoted given ++ ", not " ++ quoted schema)
