{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}
-- | Reading JSON, with complaints in plain words that name the place: @profile.shape[1]: a number 0, 1, 2, ... is needed@.
module Json.Decode
  ( -- * Text
    jsonValue
  , JsonFault (..)
  , jsonFaultMessage
  , deepest
  , longestNumber
  , decodeWith
    -- * Values
  , Decoder
  , Complaint (..)
  , complaintText
  , refuse
  , listOf
  , list
  , text
  , number
  , named
    -- * Objects
  , Fields
  , object
  , field
  , schemaIs
  ) where

import Data.Aeson (Value (..), decodeStrict')
import Data.Aeson.Key (Key)
import qualified Data.Aeson.Key as Key
import Data.Aeson.KeyMap (KeyMap)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Bifunctor (first)
import qualified Data.ByteString as Bytes
import Data.ByteString (ByteString)
import Data.Char (isDigit)
import Data.Foldable (toList)
import Data.Scientific (Scientific, floatingOrInteger)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8')
import Numeric.Natural (Natural)

import Visible

-- | The value that a text stands for. What takes a parser far more time or memory than the text has bytes is refused before: deep
-- nesting, and numbers of very many digits, which aeson reads in a time that grows with their square.
jsonValue :: ByteString -> Either JsonFault Value
jsonValue bytes
  | Bytes.all (`elem` [9, 10, 13, 32]) bytes = Left NoText
  | Just fault <- excess bytes = Left fault
  | Left _ <- decodeUtf8' bytes = Left NotUtf8
  | otherwise = maybe (Left NotJson) Right (decodeStrict' bytes)

-- | Why a text is no JSON that is read.
data JsonFault
  = NoText      -- ^ it is empty
  | TooDeep     -- ^ more brackets are within each other than 'deepest'
  | TooLong     -- ^ a number has more digits on end than 'longestNumber'
  | NotUtf8
  | NotJson
  deriving stock (Eq, Show)

-- | What is wrong, as a clause.
jsonFaultMessage :: JsonFault -> String
jsonFaultMessage fault = case fault of
  NoText -> "it is empty"
  TooDeep -> "it has more than " ++ show deepest ++ " brackets within each other"
  TooLong -> "it has a number of more than " ++ show longestNumber ++ " digits"
  NotUtf8 -> "it is not UTF-8 text"
  NotJson -> "it is not JSON"

-- | How many brackets may stand within each other: 64.
deepest :: Int
deepest = 64

-- | How many digits a number may have, before or after its point, that is no string: 1000.
longestNumber :: Int
longestNumber = 1000

-- | Whether more brackets are open at once, or more digits stand on end, than may; what is within strings does not count.
excess :: ByteString -> Maybe JsonFault
excess bytes = outside 0 0 0
  where
    -- How many brackets are open, how many digits have just been, and where this is.
    outside :: Int -> Int -> Int -> Maybe JsonFault
    outside open digits i
      | open > deepest = Just TooDeep
      | digits > longestNumber = Just TooLong
      | i >= Bytes.length bytes = Nothing
      | otherwise = case Bytes.index bytes i of
          0x22 -> inside open (i + 1)
          c | c == 0x5B || c == 0x7B -> outside (open + 1) 0 (i + 1)
            | c == 0x5D || c == 0x7D -> outside (open - 1) 0 (i + 1)
            | 0x30 <= c && c <= 0x39 -> outside open (digits + 1) (i + 1)
            | otherwise -> outside open 0 (i + 1)
    inside open i
      | i >= Bytes.length bytes = Nothing
      | otherwise = case Bytes.index bytes i of
          0x22 -> outside open 0 (i + 1)
          0x5C -> inside open (i + 2)
          _ -> inside open (i + 1)

-- | From text to what it says; 'Left' is a clause that says what is wrong.
decodeWith :: Decoder a -> ByteString -> Either String a
decodeWith decoder bytes = first jsonFaultMessage (jsonValue bytes) >>= first complaintText . decoder

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
