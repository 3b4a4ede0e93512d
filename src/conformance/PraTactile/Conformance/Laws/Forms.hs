{-# LANGUAGE OverloadedStrings #-}

-- | An integer is the same in either form that it may have, a JSON number or a decimal string,
-- whether it is small or large; and a value, however its JSON text is written.
module PraTactile.Conformance.Laws.Forms
  ( formLaws,
    otherForms,
    otherText,
    typical,
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
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..), area)
import PraTactile.Conformance.Definition (Known, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire (questionInput, readWhole)
import PraTactile.Profile (Profile (..))

-- | A law of each operation that takes integers, under its stage.
formLaws :: Stage -> [Operation] -> [Law Known]
formLaws stage operations =
  [ law
      stage
      (operationName operation ++ "-takes-either-form")
      [operation]
      "an integer is a JSON number or a decimal string, be it small or large"
      "the protocol, integers"
      ( \known ->
          Cases
            rawForm
            ( Every . map (SomeQuestion . Raw operation) . nub $
                [ input
                  | SomeQuestion question <- typical known operation,
                    input <- otherForms (questionInput question)
                ]
            )
            (asDefined known)
      )
    | operation <- operations
  ]

-- | The value with all of its integers as strings, with all as numbers, and with every other one
-- as a string.
otherForms :: Value -> [Value]
otherForms value = map rewritten [repeat True, repeat False, cycle [True, False]]
  where
    rewritten choices = snd (inForms choices value)

-- | With its integers, in order, as strings where that is so chosen; and what is left of the
-- choices.
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

-- | A JSON text of the value as no program writes it: with white space round everything, the keys
-- from last to first, and each string, keys too, begun by an escape.
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

-- | Questions of an operation to which every profile has an answer: with small numbers, and where
-- these may be of any size with large ones.
typical :: Known -> Operation -> [SomeQuestion]
typical known operation = case operation of
  OfAdd -> [SomeQuestion (Add 1 (q - 1))]
  OfMultiply -> [SomeQuestion (Multiply 1 (q - 1))]
  OfNegate -> [SomeQuestion (Negate (q - 1))]
  OfInverse -> [SomeQuestion (Inverse (q - 1))]
  OfPower -> [SomeQuestion (Power (q - 1) (sign * toInteger i)) | i <- sizes, sign <- [1, -1]]
  OfLogarithm -> [SomeQuestion (Logarithm (q - 1))]
  OfTrace -> [SomeQuestion (Trace (q - 1))]
  OfPrimitive -> [SomeQuestion (Primitive (profilePolynomial p))]
  OfFirstPrimitive -> [SomeQuestion (FirstPrimitive 1)]
  OfTerm -> SomeQuestion . Term <$> sizes
  OfTerms -> [SomeQuestion (Terms i 3) | i <- sizes]
  OfCell -> [SomeQuestion (Cell i j) | i <- sizes, j <- take 2 sizes]
  OfPack -> [SomeQuestion (Pack (map (const (q - 1)) (naturalCells (profileWindow p))))]
  OfUnpack -> SomeQuestion . Unpack . (`mod` (q ^ area (profileWindow p))) <$> sizes
  OfLocate -> SomeQuestion . Locate <$> patches
  OfNearest -> [SomeQuestion (Nearest radius patch) | patch <- patches, radius <- [Nothing, Just 1]]
  OfPosterior -> SomeQuestion . Posterior . map (map (maybe Unfelt Certainly)) <$> patches
  OfProve -> SomeQuestion . Prove <$> masks
  OfDistance -> SomeQuestion . Distance <$> masks
  _ -> []
  where
    p = knownProfile known
    q = profileOrder p
    sizes = [7, 2 ^ (53 :: Int) + 1, 10 ^ (19 :: Int) + 7, 10 ^ (40 :: Int) + 3] :: [Natural]
    masks = [["#"], ["##"], ["#", "#"], ["#.#", "..#"]]
    naturalCells shape = [1 .. area shape]
    Shape h w = profileWindow p
    patches =
      [ map (map Just) (seenAt known shape place)
        | shape <- [Shape h w, Shape 1 1],
          place <- take 1 (places p shape)
      ]
