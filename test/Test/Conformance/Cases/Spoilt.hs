{-# LANGUAGE OverloadedStrings #-}

-- | Questions that are spoilt in one place, which laws say are refused.
module Test.Conformance.Cases.Spoilt (spoilt) where

import Data.Aeson (Value (..), decode, object, toJSON)
import Data.Aeson.Key (Key, fromString)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (toList)
import Data.Maybe (fromMaybe)
import qualified Data.Vector as Vector
import PraTactile.Array (Shape (..), area)
import PraTactile.Conformance.Question
import PraTactile.Profile
import Test.Conformance.Cases.Domains (large, question)

-- | What is no input of an operation, by the laws' ids.
spoilt :: Profile -> [(String, [Value])]
spoilt p =
  [ ( "field/" ++ name ++ "-refuses-what-is-invalid",
      concatMap ask (q : q + 1 : large) ++ wrong one ++ [with "a" minus one]
    )
    | (name, ask, one) <-
        [ ("add", \a -> [question (Add a 0), question (Add 0 a)], question (Add 1 1)),
          ( "multiply",
            \a -> [question (Multiply a 0), question (Multiply 0 a)],
            question (Multiply 1 1)
          ),
          ("negate", \a -> [question (Negate a)], question (Negate 1)),
          ("inverse", \a -> [question (Inverse a)], question (Inverse 1)),
          ("power", \a -> [question (Power a i) | i <- [-1 .. 2]], question (Power 1 1)),
          ("logarithm", \a -> [question (Logarithm a)], question (Logarithm 1)),
          ("trace", \a -> [question (Trace a)], question (Trace 1))
        ]
  ]
    ++ [ ( "polynomial/primitive-refuses-what-is-invalid",
           [ question (Primitive codes)
             | a <- q : q + 1 : large,
               codes <- [[a, 1], [1, a], [1, 0, a, 1]]
           ]
             ++ [with "polynomial" (toJSON [-1, 1 :: Int]) (question (Primitive [1, 1]))]
             ++ wrong (question (Primitive [1, 1]))
         ),
         ( "polynomial/first-primitive-refuses-what-is-invalid",
           question (FirstPrimitive 0) :
           with "degree" minus (question (FirstPrimitive 1)) :
           wrong (question (FirstPrimitive 1))
         ),
         ( "sequence/term-refuses-what-is-invalid",
           with "index" minus (question (Term 0)) : wrong (question (Term 1))
         ),
         ( "sequence/terms-refuses-what-is-invalid",
           [with name minus (question (Terms 0 1)) | name <- ["from", "length"]]
             ++ wrong (question (Terms 1 1))
         ),
         ( "array/cell-refuses-what-is-invalid",
           [with name minus (question (Cell 0 0)) | name <- ["row", "column"]]
             ++ wrong (question (Cell 1 1))
         ),
         ( "window/pack-refuses-what-is-invalid",
           [question (Pack (zeros count)) | count <- [0, k - 1, k + 1, 2 * k], count /= k]
             ++ [question (Pack (take k (a : zeros k))) | a <- q : q + 1 : large]
             ++ [question (Pack (zeros (k - 1) ++ [q]))]
             ++ [with "cells" (toJSON (replicate k (-1 :: Int))) (question (Pack [0]))]
             ++ wrong (question (Pack (zeros k)))
         ),
         ( "window/unpack-refuses-what-is-invalid",
           with "packed" minus (question (Unpack 0)) : wrong (question (Unpack 1))
         )
       ]
    ++ [ ( "proof/" ++ name ++ "-refuses-what-is-invalid",
           [with "mask" (String drawing) one | drawing <- noMasks] ++ wrong one
         )
         | (name, one) <-
             [("prove", question (Prove ["#"])), ("distance", question (Distance ["#"]))]
       ]
    ++ spoiltPatches p
  where
    q = profileOrder p
    k = fromIntegral (area (profileWindow p)) :: Int
    minus = Number (-1)
    zeros count = replicate count 0
    -- No cell, rows of different lengths, other characters, no cell that is in it.
    noMasks =
      ["", "/", "#/", "/#", "##/#", "#/##", "#x", "# #", "01", "#\n#", "##//##", ".", "../.."]

spoiltPatches :: Profile -> [(String, [Value])]
spoiltPatches p =
  [ ( "locate/locate-refuses-what-is-invalid",
      ofPatch (question (Locate felt'))
    ),
    ( "damage/nearest-refuses-what-is-invalid",
      [ with "radius" radius (question (Nearest Nothing [[Just 1]]))
        | radius <- [Number (-1), oneAsFraction, Bool True, toJSON ([] :: [Int])]
      ]
        ++ ofPatch (question (Nearest Nothing felt'))
        ++ ofPatch (question (Nearest (Just 1) felt'))
    ),
    ( "chances/posterior-refuses-what-is-invalid",
      [question (Posterior [[Probably chances]]) | chances <- noChances]
        ++ [ question (Posterior [[Unfelt, Probably chances], [Certainly 0, Unfelt]])
             | chances <- noChances
           ]
        ++ [question (Posterior [[Certainly code]]) | code <- [q, q + 1, q + 2]]
        ++ [ with
               "patch"
               (toJSON [[[toJSON True, toJSON (0 :: Int)]]])
               (question (Posterior [[Unfelt]]))
           ]
        ++ ofPatch (question (Posterior (map (map (maybe Unfelt Certainly)) felt')))
    )
  ]
  where
    q = profileOrder p
    q' = fromIntegral q :: Int
    Shape h w = profileWindow p
    felt' = [[Just 1, Nothing], [Just 0, Just 1]]
    ofPatch one =
      [ with "patch" patch one
        | patch <-
            map toJSON ([[], [[]], [[], []], [[0, 1], [1]], [[1], [0, 1]], [[0, 1], []]] :: [Ints])
              ++ [toJSON [[no]] | no <- [Number (-1), Bool True, Number 1.5, toJSON [String "0"]]]
              ++ [toJSON (replicate (fromIntegral h) (replicate (fromIntegral w) q))]
              ++ [toJSON [[0, q + 1]], toJSON [[Nothing, Just q]], Null]
      ]
        ++ wrong one
    -- Too many, none that is not 0, a negative one; sums beyond a thousandth of 1; too few.
    noChances =
      [replicate (q' + 1) (1 / fromIntegral (q' + 1)), replicate q' 0]
        ++ [[2, -1] ++ replicate (q' - 2) 0]
        ++ [map (* factor) halved | factor <- [1.002, 0.998, 2]]
        ++ [[], replicate (q' - 1) (1 / fromIntegral (q' - 1))]
    halved = [0.5 ^ i | i <- [1 .. q' - 1]] ++ [0.5 ^ (q' - 1)] :: [Double]

-- | A question with another value under a key.
with :: String -> Value -> Value -> Value
with name value one = changed one (insertAt name value)

-- | A question without each of its keys, and with a value of each wrong type in each place: the
-- first of a list stands for all of them.
wrong :: Value -> [Value]
wrong one =
  [changed one (KeyMap.delete name) | name <- keysOf one]
    ++ [ changed one (KeyMap.insert name other)
         | (name, inner) <- fieldsOf one,
           other <- others inner
       ]
  where
    others value = case value of
      Number _ -> [Bool True, oneAsFraction, Number 1.5, object []]
      String _ -> [Bool True, Number 1, object []]
      Array items ->
        [Bool True, Number 1, object []]
          ++ [ Array (Vector.fromList (other : rest))
               | first : rest <- [toList items],
                 other <- others first
             ]
      _ -> [Bool True, object []]

-- | 1 in a form that no whole number has.
oneAsFraction :: Value
oneAsFraction = fromMaybe Null (decode "1.0")

insertAt :: String -> Value -> KeyMap.KeyMap Value -> KeyMap.KeyMap Value
insertAt name = KeyMap.insert (fromString name)

changed :: Value -> (KeyMap.KeyMap Value -> KeyMap.KeyMap Value) -> Value
changed one change = case one of
  Array parts | [name, Object fields] <- toList parts -> toJSON [name, Object (change fields)]
  _ -> Null

fieldsOf :: Value -> [(Key, Value)]
fieldsOf one = case one of
  Array parts | [_, Object fields] <- toList parts -> KeyMap.toList fields
  _ -> []

keysOf :: Value -> [Key]
keysOf = map fst . fieldsOf

type Ints = [[Int]]
