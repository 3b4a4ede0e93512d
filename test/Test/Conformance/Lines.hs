{-# LANGUAGE OverloadedStrings #-}

-- | Lines of the protocol: what is written as a whole number is one, and nothing else; all else is
-- as any reader of JSON has it.
module Test.Conformance.Lines (spec) where

import Data.Aeson (Value (..), decodeStrict)
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (isDigit)
import Data.Foldable (for_, toList)
import Data.Maybe (isJust)
import qualified Data.Text as Text
import PraTactile.Conformance.Wire (readWhole)
import PraTactile.Conformance.Wire.Line
import Test.Hspec

spec :: Spec
spec = do
  it "a number is whole if it is written so: of all up to three digits, a point and an exponent" $
    for_ numbers $ \text ->
      (text, whole <$> either (const Nothing) Just (readLine text))
        `shouldBe` (text, Just (Bytes.all isDigit (Bytes.dropWhile (== '-') text)))
  it "numbers are what they are to others, alone, among others, beside texts that look like them" $
    for_ (numbers ++ concatMap within numbers) $ \text ->
      (text, either (const Nothing) Just (readLine text)) `shouldBe` (text, decodeStrict text)
  it "texts stay as they are, whatever quotes, escapes, digits and exponents they have" $
    for_
      [ "{\"a\\\"2e0\":\"x\\\\\",\"3e0\":2e0}",
        "[\"2e0\",\"\\\"2.0e0\",2.0e0,\"\",\"e\",\"1E5\\\\\",1E5]",
        "{\"e\":{\"1e1\":[1e1,\"\\u0022e1\"]}}",
        "[\"no number\",\"e1\",true]"
      ]
      $ \text -> either (const Nothing) Just (readLine text) `shouldBe` decodeStrict text
  it "behind any text, and before one, a number is known to be whole as it is alone" $
    for_ ((,) <$> texts <*> ["2", "2e0", "2.0e0", "20e-1"]) $ \(text, number) ->
      ( (text, number),
        map whole . toList
          <$> (readLine ("[" <> text <> "," <> number <> "," <> text <> "]") >>= list)
      )
        `shouldBe` ((text, number), Right [False, number == "2", False])
  it "a text is a whole number if it is written in digits, at most 4096, behind a sign or none" $ do
    [readWhole (String text) | text <- ["0", "7", "007", "-5", "12345678901234567890123"]]
      `shouldBe` map Just [0, 7, 7, -5, 12345678901234567890123]
    [readWhole (String text) | text <- ["", "-", "--5", "+5", "1.0", "1e3", " 1", "1 ", "x", "0x1"]]
      `shouldBe` replicate 10 Nothing
    [isJust (readWhole (String (Text.replicate n "9"))) | n <- [4095, 4096, 4097]]
      `shouldBe` [True, True, False]
    map readWhole [Null, Bool True] `shouldBe` [Nothing, Nothing]
  where
    whole = isJust . readWhole
    list value = case value of
      Array items -> Right items
      _ -> Right mempty
    texts =
      [ "\"\"",
        "\"e\"",
        "\"2e0 \"",
        "\"\\\"\"",
        "\"x\\\\\"",
        "\"1 \\\"2e0\\\" 3.0\"",
        "{\"2e0\":2e0}"
      ]
    within text =
      [ "[" <> text <> ",\"" <> text <> "\"," <> text <> "]",
        "{\"" <> text <> "\":[" <> text <> "]}"
      ]

-- | Numbers as JSON has them.
numbers :: [Bytes.ByteString]
numbers =
  [ sign <> digits <> fraction <> exponent'
    | sign <- ["", "-"],
      digits <- ["0", "1", "20", "305"],
      fraction <- ["", ".0", ".5", ".25", ".250"],
      exponent' <- ["", "e0", "E0", "e1", "e+1", "e-1", "E2", "e+2", "e3", "e-3"]
  ]
