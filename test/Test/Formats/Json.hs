{-# LANGUAGE OverloadedStrings #-}

-- | Tests that an object with a repeated key is found wherever it stands in a JSON text.
module Test.Formats.Json (spec) where

import Control.Monad (forM_)
import Data.Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.List (intercalate)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import PraTactile.Format.Error (JsonError (..))
import PraTactile.Format.Json.Strict
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "up to 64 nested brackets and up to 1000 digits in a row are read, and no more" $ do
    let nested n = Bytes.replicate n '[' <> Bytes.replicate n ']'
        digits n = "[-" <> Bytes.replicate n '7' <> "]"
        refusal = either Just (const Nothing)
    map (refusal . readJson . nested) [63, 64, 65, 100]
      `shouldBe` [Nothing, Nothing, Just TooDeep, Just TooDeep]
    refusal (readJson ("[" <> nested 63 <> "," <> nested 63 <> "]")) `shouldBe` Nothing
    map (refusal . readJson . digits) [999, 1000, 1001]
      `shouldBe` [Nothing, Nothing, Just TooLong]
    map (refusal . readJsonWith 4 . digits) [4, 5] `shouldBe` [Nothing, Just TooLong]
  describe "repeatedKey" $ do
    it "is the key that one object repeats, at any depth and however it is written" $
      forM_ twice $ \(text, name) -> (text, repeatedKey text) `shouldBe` (text, Just name)
    it "is Nothing where keys repeat only in different objects, or as values" $
      forM_ single $ \text -> do
        (text, repeatedKey text) `shouldBe` (text, Nothing)
        either (const False) (const True) (readJson text) `shouldBe` True
    it "is Nothing for everything that aeson writes" $
      property $
        forAllShrink document shrunk $ \d ->
          repeatedKey (Lazy.toStrict (encode (valueOf d))) === Nothing
    it "finds the key that was repeated in any one object of a document" $
      property $
        forAllShrink (document `suchThat` (not . null . repetitions)) shrunk $ \d ->
          conjoin
            [ counterexample
                text
                (repeatedKey (Text.encodeUtf8 (Text.pack text)) === Just (Text.pack name))
              | (text, name) <- repetitions d
            ]
  where
    twice =
      [ ("{\"a\":1,\"a\":1}", "a"),
        ("{\"a\":1,\"b\":{\"a\":1},\"a\" \n\t\r:2}", "a"),
        ("[{\"b\":[{\"a\":1,\"a\":2}]}]", "a"),
        ("{\"a\":1,\"\\u0061\":2}", "a"),
        ("{\"\\\"\":1,\"\\u0022\":2}", "\""),
        ("{\"\":1,\"\":2}", ""),
        ("{\"\\\\\":1,\"x\":\"\\\\\",\"\\u005C\":2}", "\\"),
        ("{\"a\":[1,{\"a\":3}],\"c\":\"}\",\"a\":1}", "a")
      ]
    single =
      [ "{}",
        "[]",
        "1",
        "\"a\"",
        "[\"a\",\"a\"]",
        "{\"a\":\"a\",\"b\":\"a\"}",
        "{\"a\":{\"a\":{\"a\":1}}}",
        "[{\"a\":1},{\"a\":1}]",
        "{\"a\":\"\\\"a\\\":\",\"b\":\"{\\\"b\\\":1}\"}",
        "{\"a\":1,\"A\":2}"
      ]

-- | A JSON document whose objects keep their order.
data Document = Text' String | List [Document] | Fields [(String, Document)]
  deriving stock (Eq, Show)

document :: Gen Document
document = sized go
  where
    go size
      | size <= 1 = Text' <$> word
      | otherwise =
        oneof
          [ Text' <$> word,
            List <$> (choose (0, 3) >>= \n -> vectorOf n (go (size `div` 3))),
            Fields . distinct
              <$> (choose (0, 4) >>= \n -> vectorOf n ((,) <$> word <*> go (size `div` 3)))
          ]
    word = choose (0, 3) >>= \n -> vectorOf n (elements "ab\"\\{}[]:,\n\233")
    distinct fields =
      [(k, d) | (i, (k, d)) <- zip [0 :: Int ..] fields, k `notElem` map fst (take i fields)]

-- | Its parts, and the document itself with fewer or smaller ones.
shrunk :: Document -> [Document]
shrunk d = case d of
  Text' text -> map Text' (shrinkList (const []) text)
  List ds -> ds ++ map List (shrinkList shrunk ds)
  Fields fields ->
    map snd fields ++ map Fields (shrinkList (\(k, v) -> map ((,) k) (shrunk v)) fields)

valueOf :: Document -> Value
valueOf d = case d of
  Text' text -> toJSON text
  List ds -> toJSON (map valueOf ds)
  Fields fields -> object [Key.fromString k .= valueOf v | (k, v) <- fields]

-- | The document as text in which one object repeats one key, and that key.
repetitions :: Document -> [(String, String)]
repetitions d = case d of
  Text' _ -> []
  List ds ->
    [ ("[" ++ intercalate "," (replacing i text (map written ds)) ++ "]", k)
      | (i, d') <- zip [0 ..] ds,
        (text, k) <- repetitions d'
    ]
  Fields fields ->
    [(braced (map pair fields ++ [pair (k, Text' "again")]), k) | (k, _) <- fields]
      ++ [ (braced (replacing i (quoted k ++ ":" ++ text) (map pair fields)), k')
           | (i, (k, v)) <- zip [0 ..] fields,
             (text, k') <- repetitions v
         ]
  where
    replacing i new items = [if i == j then new else item | (j, item) <- zip [0 :: Int ..] items]

written :: Document -> String
written d = case d of
  Text' text -> quoted text
  List ds -> "[" ++ intercalate "," (map written ds) ++ "]"
  Fields fields -> braced (map pair fields)

pair :: (String, Document) -> String
pair (k, v) = quoted k ++ ": " ++ written v

braced :: [String] -> String
braced items = "{" ++ intercalate " , " items ++ "}"

quoted :: String -> String
quoted = Text.unpack . Text.decodeUtf8 . Lazy.toStrict . encode
