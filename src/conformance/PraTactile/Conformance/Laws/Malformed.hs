{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Invalid inputs, derived from valid ones.
module PraTactile.Conformance.Laws.Malformed
  ( malformed,
    rawWith,
    noShapes,
  )
where

import Data.Aeson (Value (..))
import Data.Aeson.Key (Key)
import qualified Data.Aeson.KeyMap as KeyMap
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question

-- | Questions with an invalid input, derived from a valid one: with a missing key, or a value of
-- another type in each place.
malformed :: Question a -> [SomeQuestion]
malformed question =
  map (SomeQuestion . Raw (operationOf question)) (malformedForms question)

-- | Invalid alphabets: no drawing, a drawing of another size or with other marks, a blank one, a
-- repeated one, and too many.
noShapes :: [Drawings]
noShapes =
  [ [],
    [drop 1 corner],
    [corner ++ take 1 corner],
    [map (drop 1) corner],
    [map ('.' :) corner],
    ["x......." : drop 1 corner],
    [replicate 12 "........"],
    [corner, corner],
    [bits i : bits (i `div` 256) : drop 2 corner | i <- [0 .. 256]]
  ]
  where
    corner = "##......" : replicate 11 "#......."
    bits :: Int -> String
    bits i = [if i `div` (2 ^ k) `mod` 2 == 1 then '#' else '.' | k <- [0 .. 7 :: Int]]

-- | The question with another JSON value for a key of its input.
rawWith :: Question a -> Key -> Value -> SomeQuestion
rawWith question name value = SomeQuestion . Raw (operationOf question) $
  case questionInput question of
    Object fields -> Object (KeyMap.insert name value fields)
    other -> other
