{-# LANGUAGE OverloadedStrings #-}

-- | Inputs that are none, made systematically of one that is: a key missing, and in the place of
-- each value, at any depth, one of a wrong type, or a number that is written as none may be.
module PraTactile.Conformance.Laws.Malformed
  ( malformed,
    rawWith,
    noShapes,
  )
where

import Data.Aeson (Array, Value (..), object)
import Data.Aeson.Key (Key)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Scientific (scientific)
import qualified Data.Vector as Vector
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire (questionInput)

-- | The inputs that are none, made of this question's. What stands in a place is taken for one of a
-- wrong type if it is no number where a number stands, and so on; and null where none may stand.
malformed :: Question a -> [SomeQuestion]
malformed question =
  [ SomeQuestion (Raw (operationOf question) input)
    | input <- noObjects ++ missing (questionInput question) ++ wrong (questionInput question)
  ]
  where
    noObjects = [Null, Bool True, Number 1, String "", Array Vector.empty]

-- | The object without each of its keys.
missing :: Value -> [Value]
missing value = case value of
  Object fields -> [Object (KeyMap.delete name fields) | name <- KeyMap.keys fields]
  _ -> []

-- | With one value of another type, in each place.
wrong :: Value -> [Value]
wrong value = case value of
  Object fields ->
    [ Object (KeyMap.insert name other fields)
      | (name, inner) <- KeyMap.toList fields,
        other <- (if name `elem` ["radius", "patch", "plane"] then id else (Null :)) (instead inner)
    ]
  _ -> []

-- | Values of other types, instead of this one or in it.
instead :: Value -> [Value]
instead value = case value of
  Number _ ->
    [Bool True, object [], Number (scientific 10 (-1)), Number (scientific 15 (-1))]
      -- Written as 1.0e7.
      ++ [Number (scientific (10 ^ (8 :: Int)) (-1))]
      ++ map String ["", "+1", " 1", "1.0", "1e0", "0x1", "one"]
  String _ -> [Bool True, Number 1, object []]
  Array items -> [Bool True, Number 1, object []] ++ map Array (inOne items)
  _ -> [Bool True, object []]

-- | With the first of the items another.
inOne :: Array -> [Array]
inOne items = case Vector.uncons items of
  Nothing -> []
  Just (first, rest) -> [Vector.cons other rest | other <- instead first]

-- | Shapes that are none: no drawing, one of another size or with other marks, a blank one, the
-- same one twice, and too many.
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

-- | A question whose input has another value under a key.
rawWith :: Question a -> Key -> Value -> SomeQuestion
rawWith question name value = SomeQuestion . Raw (operationOf question) $
  case questionInput question of
    Object fields -> Object (KeyMap.insert name value fields)
    other -> other
