{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The operations in the protocol's document and in its schemas, generated from the operations'
-- records. @make operations@ writes both.
module PraTactile.Conformance.Protocol
  ( withOperations,
    statingOperations,
    schemasOfOperations,
  )
where

import Data.Aeson (Value (..), toJSON)
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (toList)
import Data.List (nub)
import Data.Text (Text)
import qualified Data.Text as Text
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question (SomeOp (..))
import PraTactile.Format.Json.Codec (schemaOf)
import PraTactile.Format.Json.Schema (Schema (OneOf), brief, namedSchemas, schemaValue)
import qualified PraTactile.Format.Json.Schema as Schema

-- | The document with its two generated tables: the operations, each with input, result and the
-- reasons of refusal; and these reasons, each with its operations and its rule.
withOperations :: Text -> Text
withOperations =
  withRows "| operation | input | result | refused |" operationRows
    . withRows "| reason | operations | when |" reasonRows

-- | The document with these rows under the heading of a table.
withRows :: Text -> [Text] -> Text -> Text
withRows heading rows page = case break (== heading) (Text.lines page) of
  (before, first : rule : others) ->
    Text.unlines (before ++ first : rule : rows ++ dropWhile isRow others)
  _ -> page
  where
    isRow = Text.isPrefixOf "|"

operationRows :: [Text]
operationRows = map row allOperations
  where
    row some@(SomeOp op) =
      let it = recordOf op
          input = schemaOf (operationInput it)
       in cells
            [ code (Text.pack (nameOf some)),
              Text.intercalate ", optionally " (map code (brief input : optional input)),
              Text.pack (operationSays it),
              Text.intercalate ", " (map (code . Text.pack . fst) (operationReasons it))
            ]
    optional schema = case schema of
      Schema.Object fields -> [Text.pack (show (Key.toText name)) | (name, False, _) <- fields]
      Schema.Named _ inner -> optional inner
      Schema.Described _ inner -> optional inner
      _ -> []

-- | A row for each reason and rule, in the order in which operations first have them.
reasonRows :: [Text]
reasonRows = [row reason | reason <- nub (concatMap reasonsOf allOperations)]
  where
    reasonsOf (SomeOp op) = operationReasons (recordOf op)
    row reason@(name, rule) =
      cells
        [ code (Text.pack name),
          Text.intercalate
            ", "
            [code (Text.pack (nameOf some)) | some <- allOperations, reason `elem` reasonsOf some],
          Text.pack rule
        ]

-- | A row of a table.
cells :: [Text] -> Text
cells texts = Text.concat (map cell texts) <> "|"
  where
    cell text = if Text.null text then "| " else "| " <> text <> " "

code :: Text -> Text
code text = "`" <> text <> "`"

-- | Replaces the operations in a schema file. The definitions of operations, of their inputs and
-- results, and of the parts of these come from the codecs. A list whose first item refers to one
-- operation's input or result gets such an item for each operation.
statingOperations :: Value -> Value
statingOperations value = case value of
  Object keys ->
    Object (KeyMap.fromList [(key, statedUnder key inner) | (key, inner) <- KeyMap.toList keys])
  Array items
    | first : _ <- toList items,
      [name] <- filter (`isAbout` first) names ->
      toJSON [renamed name other first | other <- names]
    | otherwise -> Array (fmap statingOperations items)
  _ -> value
  where
    statedUnder key inner = case inner of
      Object known
        | key == "$defs",
          KeyMap.member "operation" known ->
          let others = KeyMap.filterWithKey (\name _ -> not (ofOperations name)) known
           in Object (KeyMap.union definitions others)
      _ -> statingOperations inner
    ofOperations key = any (`Text.isPrefixOf` Key.toText key) ["input-", "result-"]

-- | The schema files that mention operations.
schemasOfOperations :: [String]
schemasOfOperations = ["common", "reply", "request", "vectors"]

names :: [Text]
names = map (Text.pack . nameOf) allOperations

-- | The definitions that schemas refer to, by name.
definitions :: KeyMap.KeyMap Value
definitions =
  KeyMap.fromList $
    ("operation", schemaValue (OneOf names)) :
    concat
      [ concat
          [ (Key.fromText (part <> name), schemaValue schema) :
              [(Key.fromText inner, schemaValue its) | (inner, its) <- namedSchemas schema]
            | (part, schema) <-
                [ ("input-", schemaOf (operationInput (recordOf op))),
                  ("result-", schemaOf (operationOutput (recordOf op)))
                ]
          ]
        | (name, SomeOp op) <- zip names allOperations
      ]

-- | Whether a value refers to the input or the result of the named operation.
isAbout :: Text -> Value -> Bool
isAbout name value = case value of
  String text -> any (`Text.isSuffixOf` text) (references name)
  Object keys -> any (isAbout name) (toList keys)
  Array items -> any (isAbout name) (toList items)
  _ -> False

references :: Text -> [Text]
references name = ["#/$defs/input-" <> name, "#/$defs/result-" <> name]

-- | Replaces references to one operation by references to another.
renamed :: Text -> Text -> Value -> Value
renamed name other value = case value of
  String text
    | text == name -> String other
    | otherwise ->
      String (foldr replaced text (zip (references name) (references other)))
  Object keys -> Object (fmap (renamed name other) keys)
  Array items -> Array (fmap (renamed name other) items)
  _ -> value
  where
    replaced (from, to) text = maybe text (<> to) (Text.stripSuffix from text)
