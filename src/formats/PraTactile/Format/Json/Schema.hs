{-# LANGUAGE OverloadedStrings #-}

-- | Schemas of JSON values: written as JSON Schema (draft 2020-12), written in brief, and used to
-- derive invalid values.
module PraTactile.Format.Json.Schema
  ( Schema (..),
    list,
    listOfLength,
    orNull,

    -- * Uses
    schemaValue,
    namedSchemas,
    brief,
    malformed,
  )
where

import Data.Aeson (Key, Value, (.=))
import qualified Data.Aeson as Json
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (Pair)
import Data.List (sortOn)
import Data.Scientific (scientific)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as Vector

-- | The JSON values of a type.
data Schema
  = Anything
  | Null
  | Boolean
  | -- | A text, with the keywords that restrict it.
    Text [Pair]
  | -- | One of these texts.
    OneOf [Text]
  | -- | A number, with the keywords that bound it.
    Real [Pair]
  | -- | An integer of 0 or more, as a number or as a decimal string.
    Natural
  | -- | An integer, as a number or as a decimal string.
    Integer
  | -- | A list, with the keywords that bound its length.
    List [Pair] Schema
  | -- | A list of these values.
    Tuple [Schema]
  | -- | An object: its keys, their schemas, and whether each is required. Further keys are
    -- ignored.
    Object [(Key, Bool, Schema)]
  | AnyOf [Schema]
  | -- | A schema with a description.
    Described Text Schema
  | -- | A schema that others refer to by this name.
    Named Text Schema

-- | A list of any length.
list :: Schema -> Schema
list = List []

-- | A list of this length.
listOfLength :: Int -> Schema -> Schema
listOfLength n = List ["minItems" .= n, "maxItems" .= n]

-- | A value or null.
orNull :: Schema -> Schema
orNull one = AnyOf [one, Null]

-- | The JSON Schema. Named parts become references to @common.json@.
schemaValue :: Schema -> Value
schemaValue = Json.object . keywords

-- | The keywords of the JSON Schema.
keywords :: Schema -> [Pair]
keywords schema = case schema of
  Anything -> []
  Null -> typed "null"
  Boolean -> typed "boolean"
  Text restrictions -> typed "string" ++ restrictions
  OneOf texts -> ["enum" .= texts]
  Real bounds -> typed "number" ++ bounds
  Natural -> whole ["minimum" .= (0 :: Int)] "^[0-9]{1,4096}$"
  Integer -> whole [] "^-?[0-9]{1,4096}$"
  List bounds item -> typed "array" ++ ["items" .= schemaValue item] ++ bounds
  Tuple items ->
    typed "array"
      ++ ["prefixItems" .= map schemaValue items, "items" .= False, "minItems" .= length items]
  Object fields ->
    typed "object"
      ++ [ "required" .= [name | (name, True, _) <- fields],
           "properties" .= Json.object [name .= schemaValue inner | (name, _, inner) <- fields]
         ]
  AnyOf some -> ["anyOf" .= map schemaValue some]
  Described sentence inner -> ("description" .= sentence) : keywords inner
  Named name _ -> ["$ref" .= ("common.json#/$defs/" <> name)]
  where
    typed name = ["type" .= (name :: Text)]
    whole least pattern' =
      [ "anyOf"
          .= [ Json.object (typed "integer" ++ least),
               Json.object (typed "string" ++ ["pattern" .= (pattern' :: Text)])
             ]
      ]

-- | The named parts of a schema, recursively, each with its schema.
namedSchemas :: Schema -> [(Text, Schema)]
namedSchemas schema = case schema of
  List _ item -> namedSchemas item
  Tuple items -> concatMap namedSchemas items
  Object fields -> concat [namedSchemas inner | (_, _, inner) <- fields]
  AnyOf some -> concatMap namedSchemas some
  Described _ inner -> namedSchemas inner
  Named name inner -> (name, inner) : namedSchemas inner
  _ -> []

-- | The required keys of objects, as in @{"frames": [{"rows", "place"}, ..], "search"}@; empty if
-- there is no object.
brief :: Schema -> Text
brief schema = case schema of
  Object fields ->
    "{" <> Text.intercalate ", " [keyed name inner | (name, True, inner) <- fields] <> "}"
  List _ item | inner <- brief item, not (Text.null inner) -> "[" <> inner <> ", ..]"
  Described _ inner -> brief inner
  Named _ inner -> brief inner
  _ -> ""
  where
    keyed name inner = Text.pack (show (Key.toText name)) <> after (brief inner)
    after inner = if Text.null inner then "" else ": " <> inner

-- | Invalid values for an object's schema, derived from a valid one: values that are not objects,
-- the object without each required key, and the object with a value of another type at each key.
malformed :: Schema -> Value -> [Value]
malformed schema value =
  [Json.Null, Json.Bool True, Json.Number 1, Json.String "", Json.Array Vector.empty]
    ++ [Json.Object (KeyMap.delete name given) | (name, True, _) <- fields]
    ++ [ Json.Object (KeyMap.insert name other given)
         | (name, _, inner) <- fields,
           Just one <- [KeyMap.lookup name given],
           other <- [Json.Null | not (any isNull (alternatives inner))] ++ otherTypes inner one
       ]
  where
    fields = sortOn (\(name, _, _) -> name) (concat [keys | Object keys <- alternatives schema])
    given = case value of
      Json.Object there -> there
      _ -> mempty
    isNull one = case one of
      Null -> True
      _ -> False

-- | Values of other types than the schema's, in the place of a value or of a list's first element.
-- An integer written with a fraction counts as another type; the last such number is 1.0e7.
otherTypes :: Schema -> Value -> [Value]
otherTypes schema value = case value of
  Json.Number _ ->
    [Json.Bool True, Json.object []]
      ++ (if isReal then [] else map tenths [10, 15, 10 ^ (8 :: Int)])
      ++ map Json.String ["", "+1", " 1", "1.0", "1e0", "0x1", "one"]
  Json.Array items -> notNumbers ++ inFirst items
  Json.String _ -> notNumbers
  _ -> [Json.Bool True, Json.object []]
  where
    -- Written with one digit after the point.
    tenths n = Json.Number (scientific n (-1))
    isReal = or [True | Real _ <- alternatives schema]
    -- Replacements for a list or a text. A large integer is written as a text, so a number would be
    -- valid there.
    notNumbers = [Json.Bool True] ++ [Json.Number 1 | not isNumber] ++ [Json.object []]
    isNumber =
      isReal
        || or [True | Natural <- alternatives schema]
        || or [True | Integer <- alternatives schema]
    inFirst items = case (Vector.uncons items, concatMap itemsOf (alternatives schema)) of
      (Just (first, rest), inner : _) ->
        [Json.Array (Vector.cons other rest) | other <- otherTypes inner first]
      _ -> []
    itemsOf one = case one of
      List _ inner -> [inner]
      Tuple inner -> inner
      _ -> []

-- | The alternatives of a schema, without names and descriptions.
alternatives :: Schema -> [Schema]
alternatives schema = case schema of
  AnyOf some -> concatMap alternatives some
  Described _ inner -> alternatives inner
  Named _ inner -> alternatives inner
  _ -> [schema]
