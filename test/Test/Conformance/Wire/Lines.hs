{-# LANGUAGE OverloadedStrings #-}

-- | Tests lines of the protocol: which numbers are whole depends on how they are written; all else
-- is read as any reader of JSON reads it.
module Test.Conformance.Wire.Lines (spec) where

import Data.Aeson (Value (..), decodeStrict, object, (.=))
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (isDigit)
import Data.Foldable (for_, toList)
import Data.Maybe (isJust)
import qualified Data.Text as Text
import PraTactile.Conformance.Forms (readWhole)
import PraTactile.Conformance.Process.Reply
import PraTactile.Conformance.Question (Op (Add), Question (..), SomeQuestion (..))
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Wire.Line
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile (canonicalProfile)
import Test.Hspec

spec :: Spec
spec = do
  it "a number is whole if written so: tried on three digits with point and exponent" $
    for_ numbers $ \text ->
      (text, whole <$> either (const Nothing) Just (readLine text))
        `shouldBe` (text, Just (Bytes.all isDigit (Bytes.dropWhile (== '-') text)))
  it "numbers are read as other programs read them: alone, among others, beside similar texts" $
    for_ (numbers ++ concatMap within numbers) $ \text ->
      (text, either (const Nothing) Just (readLine text)) `shouldBe` (text, decodeStrict text)
  it "texts are kept exactly, whatever quotes, escapes, digits and exponents they have" $
    for_
      [ "{\"a\\\"2e0\":\"x\\\\\",\"3e0\":2e0}",
        "[\"2e0\",\"\\\"2.0e0\",2.0e0,\"\",\"e\",\"1E5\\\\\",1E5]",
        "{\"e\":{\"1e1\":[1e1,\"\\u0022e1\"]}}",
        "[\"no number\",\"e1\",true]"
      ]
      $ \text -> either (const Nothing) Just (readLine text) `shouldBe` decodeStrict text
  it "a number before or after any text is recognised as whole, as it is when alone" $
    for_ ((,) <$> texts <*> ["2", "2e0", "2.0e0", "20e-1"]) $ \(text, number) ->
      ( (text, number),
        map whole . toList
          <$> (readLine ("[" <> text <> "," <> number <> "," <> text <> "]") >>= list)
      )
        `shouldBe` ((text, number), Right [False, number == "2", False])
  it "a text is a whole number if it is at most 4096 digits with an optional sign" $ do
    [readWhole (String text) | text <- ["0", "7", "007", "-5", "12345678901234567890123"]]
      `shouldBe` map Just [0, 7, 7, -5, 12345678901234567890123]
    [readWhole (String text) | text <- ["", "-", "--5", "+5", "1.0", "1e3", " 1", "1 ", "x", "0x1"]]
      `shouldBe` replicate 10 Nothing
    [isJust (readWhole (String (Text.replicate n "9"))) | n <- [4095, 4096, 4097]]
      `shouldBe` [True, True, False]
    map readWhole [Null, Bool True] `shouldBe` [Nothing, Nothing]
  it "a line of up to a hundred bytes is shown whole, a longer one by its first eighty" $
    for_ ([0 .. 130] ++ [1000]) $ \size -> do
      let line = take size (cycle ['a' .. 'z'])
      excerpt (Bytes.pack line)
        `shouldBe` if size <= 100 then line else take 80 line ++ " ... (" ++ show size ++ " bytes)"
  it "requests have the keys of the protocol; with a process per request also the profile" $ do
    let profile = profileValue canonicalProfile
        question = SomeQuestion (Add :? (1, 2))
        input = object ["a" .= (1 :: Int), "b" .= (2 :: Int)]
        run = ["sequence" .= (7 :: Int), "operation" .= String "add", "input" .= input]
        command name = "command" .= String name
    startRequest `shouldBe` object [command "start", "protocol" .= (1 :: Int)]
    profileRequest canonicalProfile `shouldBe` object [command "profile", "profile" .= profile]
    runRequest 7 question `shouldBe` object (command "run" : run)
    stopRequest `shouldBe` object [command "stop"]
    oneShotRequest canonicalProfile Nothing `shouldBe` object ["profile" .= profile]
    oneShotRequest canonicalProfile (Just (7, question))
      `shouldBe` object ("profile" .= profile : run)
    requestLine (object [command "stop"]) `shouldBe` "{\"command\":\"stop\"}\n"
  it "a reply has one of four keys, and a number or none" $ do
    for_ [("", Nothing), (",\"sequence\":7", Just 7), (",\"sequence\":-1", Just (-1))] $
      \(more, number) ->
        for_
          [ ("result\":null", ResponseResult Null),
            ("result\":\"x\"", ResponseResult "x"),
            ("refused\":\"why\"", ResponseRefused "why"),
            ("skipped\":\"why\"", ResponseSkipped "why"),
            ("errored\":\"why\"", ResponseErrored "why")
          ]
          $ \(one, came) ->
            replyTo ("{\"" <> one <> more <> ",\"other\":0}") `shouldBe` Right (number, came)
    for_
      [ ("{}", "has none of " ++ four),
        ("{\"sequence\":1}", "has none of " ++ four),
        ("{\"result\":1,\"refused\":\"x\"}", "has more than one of " ++ four),
        ("{\"skipped\":\"\",\"errored\":\"x\"}", "has more than one of " ++ four),
        ("{\"refused\":1}", "has a refused that is no text"),
        ("{\"skipped\":null}", "has a skipped that is no text"),
        ("{\"errored\":[]}", "has a errored that is no text"),
        ("{\"result\":1,\"sequence\":\"1\"}", "has a number that is none"),
        ("{\"result\":1,\"sequence\":1.5}", "has a number that is none"),
        ("[{\"result\":1}]", "is no object")
      ]
      $ \(line, what) ->
        replyTo line
          `shouldBe` Left (Fault NotAReply ("a reply that " ++ what ++ ": " ++ Bytes.unpack line))
    for_
      [ ("", "an empty line"),
        ("{", "a line that is no JSON"),
        (Bytes.replicate 65 '[' <> Bytes.replicate 65 ']', "a line nested deeper than 64"),
        ("{\"a\":1,\"a\":1}", "a line with the key \"a\" twice"),
        ( "{\"a\":" <> Bytes.replicate 4097 '1' <> "}",
          "a line with a number of more than 4096 digits"
        ),
        ("\"\255\"", "a line that is not UTF-8")
      ]
      $ \(line, what) ->
        replyTo line `shouldBe` Left (Fault NotJson (what ++ ": " ++ excerpt line))
  it "the reply to start has the protocol, a name, the operations and the batch size" $ do
    let start fields = startedBy (encodeLine fields)
        encodeLine fields = "{" <> Bytes.intercalate "," [k <> ":" <> v | (k, v) <- fields] <> "}"
        right' =
          [ ("\"protocol\"", "1"),
            ("\"name\"", "\"n\""),
            ("\"operations\"", "[\"b\",\"a\"]"),
            ("\"in_flight\"", "3")
          ]
        with name value = [if k == name then (k, value) else (k, v) | (k, v) <- right']
    start right' `shouldBe` Right ("n", ["b", "a"], 3)
    for_ right' $ \(name, _) ->
      fmap (const ()) (start (filter ((/= name) . fst) right'))
        `shouldBe` Left
          ( Fault
              NotAReply
              ( "a reply that to start has no " ++ Bytes.unpack name ++ ": "
                  ++ excerpt (encodeLine (filter ((/= name) . fst) right'))
              )
          )
    for_
      [ ("\"protocol\"", "2", "speaks protocol 2, not 1"),
        ("\"protocol\"", "0", "speaks protocol 0, not 1"),
        ("\"protocol\"", "\"1\"", "has a number that is none"),
        ("\"name\"", "1", "to start has a name that is no text"),
        ("\"operations\"", "{}", "to start has operations that are no list"),
        ("\"operations\"", "[1]", "to start has a name that is no text"),
        ("\"in_flight\"", "0", "to start has an in_flight below 1"),
        ("\"in_flight\"", "null", "has a number that is none")
      ]
      $ \(name, value, what) ->
        start (with name value)
          `shouldBe` Left
            ( Fault
                NotAReply
                ("a reply that " ++ what ++ ": " ++ excerpt (encodeLine (with name value)))
            )
  where
    replyTo line = (\reply -> (replySequence reply, replyResponse reply)) <$> readReply line
    startedBy line =
      (\said -> (startedName said, startedOperations said, startedInFlight said))
        <$> readStarted line
    four = "result, refused, skipped, errored"
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

-- | Numbers as JSON writes them.
numbers :: [Bytes.ByteString]
numbers =
  [ sign <> digits <> fraction <> exponent'
    | sign <- ["", "-"],
      digits <- ["0", "1", "20", "305"],
      fraction <- ["", ".0", ".5", ".25", ".250"],
      exponent' <- ["", "e0", "E0", "e1", "e+1", "e-1", "E2", "e+2", "e3", "e-3"]
  ]
