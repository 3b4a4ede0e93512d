{-# LANGUAGE OverloadedStrings #-}

-- | Written patches: rows separated by @/@ or line ends, or JSON, in which cells may be
-- probabilities; and several patches, each with its displacement.
module PatchText
  ( Written (..),
    Displaced,
    readPatches,
  )
where

import Data.Aeson (Value (..))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Bifunctor (first)
import Data.Char (isSpace)
import Data.Foldable (toList)
import Data.Proxy (Proxy (..))
import qualified Data.Scientific as Scientific
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Message
import PatchBound
import PraTactile.Field
import PraTactile.Format.Error (JsonError (..))
import PraTactile.Format.Json.Strict
import PraTactile.Locate (Cell (..), Patch, belief, patch)
import PraTactile.Rows (rowsOf)
import Readers

-- | The patches of a text.
data Written (k :: Field) = Written
  { writtenPatches :: [Displaced (Patch (Cell k))],
    -- | Whether patches have displacements; otherwise there is one patch.
    writtenDisplaced :: Bool
  }

type role Written nominal

-- | A value with its displacement from a common point, rows down and columns to the right.
type Displaced a = ((Integer, Integer), a)

-- | Patches as they are written; 'Left' says what is wrong with the writing. Text that begins with
-- a bracket is JSON: a list of rows, each a list of cells; a cell is a code, an element as text,
-- null or \"?\" for one not observed, or the list of the probabilities of all symbols. Text that
-- begins with a brace is a JSON object with a list of patches. In other text rows are parted as
-- 'rowsOf' has it, patches by semicolons, and a displacement stands before a colon. Refuses more
-- than 'largestPatch' cells before it reads them.
readPatches :: forall k. KnownField k => Text -> Either String (Written k)
readPatches = readUnmarked . Text.dropWhile (== '\xFEFF')

readUnmarked :: forall k. KnownField k => Text -> Either String (Written k)
readUnmarked text = case ( oversized (fieldOrder (Proxy :: Proxy k)) text,
                           Text.uncons (Text.stripStart text)
                         ) of
  (Just complaint, _) -> Left complaint
  (Nothing, Just ('[', _)) -> do
    value <-
      json
        "the patch is no JSON; write it as [[3, 2], [3, 1]], with null for a cell that was not \
        \observed"
        text
    jsonRows value >>= alone
  (Nothing, Just ('{', _)) -> do
    value <-
      json
        "the patches are no JSON; write them as {\"patches\": [{\"at\": [0, 0], \"cells\": [[3, \
        \2], [3, 1]]}]}"
        text
    given <-
      only ["patches"] "the object has the key \"patches\" alone" value
        >>= maybe (Left "the object has the key \"patches\"") Right . lookup "patches"
        >>= list "\"patches\" is a list"
    numbered (map jsonPatch given) >>= displaced
  _
    | Text.any (`elem` [';', ':']) text ->
      numbered (map textPatch (withoutBlankLast (Text.split (== ';') text))) >>= displaced
    | otherwise -> textRows text >>= alone
  where
    -- What follows a semicolon after the last patch.
    withoutBlankLast texts = case reverse texts of
      end : others@(_ : _) | Text.all isSpace end -> reverse others
      _ -> texts

-- | The complaints about patches tell which one it is, from 1.
numbered :: [Either String a] -> Either String [a]
numbered given =
  sequence
    [ first (\complaint -> "patch " ++ show i ++ ": " ++ complaint) given'
      | (i, given') <- zip [1 :: Int ..] given
    ]

textRows :: KnownField k => Text -> Either String [[Maybe (Cell k)]]
textRows = traverse (traverse textCell . Text.words . Text.pack) . rowsOf . Text.unpack
  where
    textCell "?" = Right Nothing
    textCell word = Just . Symbol <$> element word

element :: KnownField k => Text -> Either String (GF k)
element word
  | Text.length word < longestWord = first fieldMessage (parseElement (Text.unpack word))
  | otherwise = Left (fieldMessage (ElementUnreadable (excerpt word)))

textPatch :: KnownField k => Text -> Either String (Displaced [[Maybe (Cell k)]])
textPatch text = case Text.break (== ':') text of
  (cells, "") -> (,) (0, 0) <$> textRows cells
  (before, rest)
    | [r, c] <-
        Text.split (== ',') before,
      Just at <- (,) <$> whole r <*> whole c ->
      (,) at <$> textRows (Text.drop 1 rest)
    | otherwise ->
      Left
        ( "before the colon stands a displacement, ROW,COLUMN; "
            ++ show (excerpt before)
            ++ " is none"
        )
  where
    whole digits =
      if Text.length digits < longestWord
        then either (const Nothing) Just (readDecimal (Text.unpack (Text.strip digits)))
        else Nothing

jsonPatch :: KnownField k => Value -> Either String (Displaced [[Maybe (Cell k)]])
jsonPatch value = do
  fields <- only ["at", "cells"] "a patch has the keys \"at\" and \"cells\" alone" value
  cells <- maybe (Left "a patch has the key \"cells\"") jsonRows (lookup "cells" fields)
  at <- case lookup "at" fields of
    Nothing -> Right (0, 0)
    Just (Array numbers)
      | [Number r, Number c] <-
          toList numbers,
        Just down <- whole r,
        Just along <- whole c ->
        Right (down, along)
    Just _ -> Left "\"at\" is a displacement, two whole numbers: [row, column]"
  pure (at, cells)
  where
    whole n = toInteger <$> (Scientific.toBoundedInteger n :: Maybe Int)

-- | The fields of an object that has no others than these.
only :: [Text] -> String -> Value -> Either String [(Text, Value)]
only keys complaint value = case value of
  Object fields
    | all ((`elem` keys) . Key.toText . fst) (KeyMap.toList fields) ->
      Right [(Key.toText name, field) | (name, field) <- KeyMap.toList fields]
  _ -> Left complaint

json :: String -> Text -> Either String Value
json complaint = first inWords . readJson . Text.encodeUtf8
  where
    inWords why
      | why == NotJson = complaint
      | otherwise = "the patch is not read: " ++ jsonMessage why

jsonRows :: KnownField k => Value -> Either String [[Maybe (Cell k)]]
jsonRows value =
  list "the patch is a list of rows" value
    >>= traverse (\row -> list "a row is a list of cells" row >>= traverse jsonCell)

jsonCell :: KnownField k => Value -> Either String (Maybe (Cell k))
jsonCell value = case value of
  Null -> Right Nothing
  String "?" -> Right Nothing
  String name -> Just . Symbol <$> element name
  Number code -> case Scientific.toBoundedInteger code of
    Just n -> Just . Symbol <$> first fieldMessage (fromCode n)
    Nothing -> Left "a code is a whole number"
  Array _ -> do
    numbers <- list "" value >>= traverse number
    Just . Probabilities <$> first beliefMessage (belief numbers)
  _ ->
    Left
      "a cell is a code, an element such as \"A^2\", null, or the list of the probabilities of \
      \all symbols"
  where
    number (Number x) = Right (Scientific.toRealFloat x)
    number _ = Left "probabilities are numbers"

list :: String -> Value -> Either String [Value]
list _ (Array values) = Right (toList values)
list complaint _ = Left complaint

alone :: [[Maybe (Cell k)]] -> Either String (Written k)
alone cells = (\seen -> Written [((0, 0), seen)] False) <$> patched cells

displaced :: [Displaced [[Maybe (Cell k)]]] -> Either String (Written k)
displaced given = (`Written` True) <$> numbered (map (traverse patched) given)

patched :: [[Maybe (Cell k)]] -> Either String (Patch (Cell k))
patched = first locateMessage . patch
