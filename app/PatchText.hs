{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE DataKinds #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE RoleAnnotations #-}
{-# LANGUAGE ScopedTypeVariables #-}
-- | Patches as they are written: rows parted by @/@, or JSON, in which cells may be probabilities.
module PatchText
  ( Observed (..)
  , readPatch
  ) where

import Data.Aeson (Value (..), eitherDecodeStrict')
import Data.Bifunctor (first)
import Data.Char (isSpace)
import Data.Foldable (toList)
import Data.Maybe (catMaybes)
import qualified Data.Scientific as Scientific
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text

import Message
import PraTactile.Field
import PraTactile.Locate (Patch, patch)
import PraTactile.Locate.Soft

-- | What was observed: symbols, or the probabilities of symbols.
data Observed (k :: Field) = Symbols (Patch k) | Chances (SoftPatch k)

type role Observed nominal

-- | A patch as it is written; 'Left' says what is wrong with the writing. Text that begins with a bracket is JSON: a list of rows, each a list of
-- cells; a cell is a code, an element as text, null or \"?\" for one not observed, or the list of the probabilities of all symbols.
readPatch :: KnownField k => String -> Either String (Observed k)
readPatch text
  | '[' : _ <- dropWhile isSpace text = do
      value <- first (const "the patch is no JSON; write it as [[3, 2], [3, 1]], with null for a cell that was not observed") (eitherDecodeStrict' (Text.encodeUtf8 (Text.pack text)))
      rows <- list "the patch is a list of rows" value
      cells <- traverse (\row -> list "a row is a list of cells" row >>= traverse jsonCell) rows
      observed cells
  | otherwise = traverse (traverse textCell . words) (rowsOf text) >>= observed
  where
    textCell "?" = Right Nothing
    textCell word = Just . Left <$> element word
    element = first fieldMessage . parseElement

jsonCell :: KnownField k => Value -> Either String (Maybe (Either (GF k) (Belief k)))
jsonCell value = case value of
  Null -> Right Nothing
  String "?" -> Right Nothing
  String name -> Just . Left <$> first fieldMessage (parseElement (Text.unpack name))
  Number code -> case Scientific.toBoundedInteger code of
    Just n -> Just . Left <$> first fieldMessage (fromCode n)
    Nothing -> Left "a code is a whole number"
  Array _ -> do
    numbers <- list "" value >>= traverse number
    Just . Right <$> first beliefMessage (belief numbers)
  _ -> Left "a cell is a code, an element such as \"A^2\", null, or the list of the probabilities of all symbols"
  where
    number (Number x) = Right (Scientific.toRealFloat x)
    number _ = Left "probabilities are numbers"

list :: String -> Value -> Either String [Value]
list _ (Array values) = Right (toList values)
list complaint _ = Left complaint

-- | Probabilities if any cell has them.
observed :: forall k. KnownField k => [[Maybe (Either (GF k) (Belief k))]] -> Either String (Observed k)
observed cells
  | or [True | Right _ <- catMaybes (concat cells)] = first locateMessage (Chances <$> softPatch (map (map (fmap (either certainly id))) cells))
  | otherwise = first locateMessage (Symbols <$> patch (map (map (>>= either Just (const Nothing))) cells))

-- | The rows, parted by @/@; none in an empty line.
rowsOf :: String -> [String]
rowsOf text
  | all isSpace text = []
  | otherwise = parted text
  where
    parted rest = case break (== '/') rest of
      (line, _ : more) -> line : parted more
      (line, []) -> [line]
