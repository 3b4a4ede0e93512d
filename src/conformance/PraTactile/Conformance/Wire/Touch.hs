{-# LANGUAGE OverloadedStrings #-}

-- | Questions about touch and their answers as JSON values. The answers are objects with some of
-- the keys that @pra-tactile register@, @stitch@ and @segment@ print, and further keys do not
-- matter.
module PraTactile.Conformance.Wire.Touch
  ( -- * Questions
    pairValue,
    readPair,
    framesValue,
    readFrames,
    compositeValue,
    readComposite,

    -- * Answers
    registeredValue,
    readRegistered,
    correctionsValue,
    readCorrections,
    symbolsValue,
    readSymbols,
  )
where

import Control.Monad (guard, (>=>))
import Data.Aeson (Object, Value, object, toJSON, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Maybe (isNothing)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire.Read
import PraTactile.Format.Json (integerValue, naturalValue)

pairValue :: Maybe Drawings -> Pair -> Value
pairValue shapes (Pair a b step search) =
  object $
    [ "a" .= rowsValue a,
      "b" .= rowsValue b,
      "step" .= wholeValue step,
      "search" .= naturalValue search
    ]
      ++ ["alphabet" .= some | Just some <- [shapes]]

readPair :: Object -> Maybe (Maybe Drawings, Pair)
readPair fields = (,) <$> readAlphabet fields <*> pair
  where
    pair =
      Pair
        <$> readKey "a" readRows fields
        <*> readKey "b" readRows fields
        <*> readKey "step" (readTwo readWhole) fields
        <*> readKey "search" readNatural fields

-- | A key that may be missing.
readAlphabet :: Object -> Maybe (Maybe Drawings)
readAlphabet fields
  | KeyMap.member "alphabet" fields =
    Just <$> readKey "alphabet" (readItems (readItems readText)) fields
  | otherwise = Just Nothing

framesValue :: Maybe Drawings -> Natural -> [Placed] -> Value
framesValue shapes search frames =
  object $
    ["frames" .= map placed frames, "search" .= naturalValue search]
      ++ ["alphabet" .= some | Just some <- [shapes]]
  where
    placed (Placed rows place) = object ["rows" .= rowsValue rows, "place" .= wholeValue place]

readFrames :: Object -> Maybe (Maybe Drawings, Natural, [Placed])
readFrames fields =
  (,,) <$> readAlphabet fields
    <*> readKey "search" readNatural fields
    <*> readKey "frames" (readItems (readObject >=> placed)) fields
  where
    placed frame =
      Placed <$> readKey "rows" readRows frame <*> readKey "place" (readTwo readWhole) frame

compositeValue :: Rows -> Value
compositeValue rows = object ["rows" .= rowsValue rows]

readComposite :: Object -> Maybe Rows
readComposite = readKey "rows" readRows

rowsValue :: Rows -> Value
rowsValue = toJSON . map (map naturalValue)

readRows :: Value -> Maybe Rows
readRows = readItems (readItems readNatural)

wholeValue :: WholeTaxels -> Value
wholeValue (x, y) = toJSON [integerValue x, integerValue y]

registeredValue :: Registered -> Value
registeredValue (Registered reason best (x, y)) =
  object
    [ "outcome" .= maybe registered (const refused) reason,
      "reason" .= reason,
      "best" .= best,
      "axes" .= [axis | (axis, True) <- [("x" :: String, x), ("y", y)]]
    ]

-- | Whether it is registered or refused is said twice, and both must say the same.
readRegistered :: Object -> Maybe Registered
readRegistered fields = do
  outcome <- readKey "outcome" readText fields
  reason <- readKey "reason" (readNullable readText) fields
  guard (outcome == if isNothing reason then registered else refused)
  best <- readKey "best" (readTwo readReal) fields
  axes <- readKey "axes" (readItems readText) fields
  guard (all (`elem` ["x", "y"]) axes)
  pure (Registered reason best ("x" `elem` axes, "y" `elem` axes))

registered, refused :: String
registered = "registered"
refused = "refused"

correctionsValue :: [Taxels] -> Value
correctionsValue corrections =
  object ["frames" .= [object ["correction" .= offset] | offset <- corrections]]

readCorrections :: Object -> Maybe [Taxels]
readCorrections =
  readKey "frames" (readItems (readObject >=> readKey "correction" (readTwo readReal)))

symbolsValue :: [Symbol] -> Value
symbolsValue symbols =
  object
    [ "symbols"
        .= [ object ["x" .= x, "y" .= y, "axis_deg" .= degrees]
             | Symbol (x, y) degrees <- symbols
           ]
    ]

readSymbols :: Object -> Maybe [Symbol]
readSymbols = readKey "symbols" (readItems (readObject >=> symbol))
  where
    symbol fields = do
      place <- (,) <$> readKey "x" readReal fields <*> readKey "y" readReal fields
      Symbol place <$> readKey "axis_deg" readReal fields
