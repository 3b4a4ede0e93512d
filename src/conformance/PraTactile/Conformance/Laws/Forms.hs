{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of notation: an integer is the same as a JSON number and as a decimal string, small
-- or large, and a value is the same in any JSON notation.
module PraTactile.Conformance.Laws.Forms
  ( formLaws,
    otherForms,
    otherText,
  )
where

import Data.Aeson (Value (..), encode, fromEncoding, toEncoding)
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Bifunctor (first)
import Data.ByteString.Builder (Builder, lazyByteString, toLazyByteString, word16HexFixed)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (ord)
import Data.Foldable (toList)
import Data.List (intersperse, nub)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import PraTactile.Conformance.Definition (ProfileFacts)
import PraTactile.Conformance.Forms (readWhole)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question

-- | One law for each of the operations that take integers, in its stage.
formLaws :: Stage -> [SomeOp] -> [Law ProfileFacts]
formLaws stage operations =
  [ law
      stage
      (nameOf operation ++ "-takes-either-form")
      [operation]
      "an integer, small or large, may be a JSON number or a decimal string"
      "the protocol, integers"
      ( \known ->
          Cases
            rawForm
            ( Every . map (SomeQuestion . Raw operation) . nub $
                [ input
                  | SomeQuestion question <- typicalOf known operation,
                    input <- otherForms (questionInput question)
                ]
            )
            (asDefined known)
      )
    | operation <- operations
  ]

-- | The value with all integers as strings, with all as numbers, and with every other one as a
-- string.
otherForms :: Value -> [Value]
otherForms value = map rewritten [repeat True, repeat False, cycle [True, False]]
  where
    rewritten choices = snd (inForms choices value)

-- | The value with its integers, in order, as strings where the choice is 'True'; and the
-- remaining choices.
inForms :: [Bool] -> Value -> ([Bool], Value)
inForms choices value = case value of
  Object fields ->
    let (rest, inner) = through choices (map snd (KeyMap.toList fields))
     in (rest, Object (KeyMap.fromList (zip (KeyMap.keys fields) inner)))
  Array items -> Array . Vector.fromList <$> through choices (toList items)
  _ -> case (readWhole value, choices) of
    (Just i, asText : rest) -> (rest, if asText then written i else Number (fromInteger i))
    _ -> (choices, value)
  where
    written = String . Text.pack . show
    through left inner = case inner of
      [] -> (left, [])
      one : others ->
        let (left', one') = inForms left one
         in (one' :) <$> through left' others

-- | A JSON text of the value in unusual notation: white space everywhere, keys in reverse order,
-- and each string (also keys) beginning with an escape.
otherText :: Value -> Builder
otherText value = case value of
  Object fields ->
    listed "{" "}" [text key <> " :\t" <> otherText inner | (key, inner) <- reverse (keyed fields)]
  Array items -> listed "[" "]" (map otherText (toList items))
  String string -> text string
  _ -> fromEncoding (toEncoding value)
  where
    keyed = map (first Key.toText) . KeyMap.toAscList
    listed opened closed inner =
      opened <> "\t" <> mconcat (intersperse " , " inner) <> "  " <> closed
    text string = lazyByteString $ case Text.uncons string of
      Just (begin, rest) | begin <= '\xFFFF' -> "\"" <> escape begin <> Lazy.drop 1 (encode rest)
      _ -> encode string
    escape = ("\\u" <>) . toLazyByteString . word16HexFixed . fromIntegral . ord
