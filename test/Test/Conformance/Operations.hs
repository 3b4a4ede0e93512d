{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Tests the records of operations: written inputs and answers can be read again, malformed ones
-- cannot, and each refusal has one of the listed reasons.
module Test.Conformance.Operations (spec) where

import Data.Aeson (Value (..), eitherDecodeFileStrict', encode, object, toJSON, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List (nub)
import Data.Maybe (isNothing)
import Data.Text.Encoding (decodeUtf8)
import PraTactile.Array (Position (..))
import PraTactile.Conformance
import PraTactile.Conformance.Definition (agrees, expected, expectedWithoutProfile)
import PraTactile.Conformance.Law (Cases (..))
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Protocol
import PraTactile.Format.Json.Codec (readValue, writeValue)
import Test.Hspec

spec :: Spec
spec = do
  it "each operation has its own name, and is read by it" $ do
    map nameOf allOperations `shouldBe` nub (map nameOf allOperations)
    for_ allOperations $ \operation ->
      readValue operationForm (writeValue operationForm operation) `shouldBe` Right operation
  it "docs/reference/protocol.md and data/schemas describe the operations as their records do" $ do
    page <- decodeUtf8 <$> Bytes.readFile "docs/reference/protocol.md"
    withOperations page `shouldBe` page
    for_ schemasOfOperations $ \name -> do
      schema <- eitherDecodeFileStrict' ("data/schemas/" ++ name ++ ".json")
      fmap statingOperations schema `shouldBe` schema
  for_ allOperations $ \operation -> describe (nameOf operation) $ do
    let questions = filter (isTyped . snd) (questionsOf operation)
        inputOf (SomeQuestion question) = questionInput question
    it "an input is read as it was written, whatever other keys stand beside it" $
      for_ questions $ \(_, SomeQuestion question) -> do
        Object keys <- pure (questionInput question)
        for_ [keys, KeyMap.insert "other" Null keys] $ \given ->
          (inputOf <$> someQuestion operation (Object given)) `shouldBe` Just (Object keys)
    it "malformed inputs are not read" $
      for_ (take 40 questions) $ \(_, SomeQuestion question) ->
        [input | input <- malformedForms question, Just _ <- [someQuestion operation input]]
          `shouldBe` []
    it "an answer is read as it was written; a refusal has a listed reason" $
      for_ questions $ \(about, SomeQuestion question) ->
        for_ (maybe expectedWithoutProfile (\k -> Just . expected k) about question) $ \wanted ->
          case wanted of
            Left (Refusal reason) ->
              ruleOf operation reason `shouldSatisfy` (/= ruleOf operation "a reason of none")
            Right answer -> do
              let value = answerValue question answer
              (answerValue question <$> readAnswer question value) `shouldBe` Just value
              fromIntegral (Lazy.length (encode value)) `shouldSatisfy` (>= leastBytes question)
    it "answers of another type are not read" $
      for_ (take 1 questions) $ \(_, SomeQuestion question) ->
        for_ [Null, String "one", object ["other" .= Null], toJSON [[Null]]] $ \other ->
          (other, isNothing (readAnswer question other)) `shouldBe` (other, True)
    it "shrinking any input comes to an end" $
      for_ questions $ \(_, question) ->
        let steps = iterate (take 1 . concatMap smallerQuestions) [question]
         in length (take 1000 (takeWhile (not . null) steps)) `shouldSatisfy` (< 1000)
  it "the shapes in a question about frames may be missing, but must be drawings if given" $
    for_
      [ SomeQuestion (Register :? (Just [["#.", ".#"], []], Pair [[1]] [[2]] (-4, -5) 1)),
        SomeQuestion (Stitch :? (Just [["#"]], 1, [NominalFrame [[1]] (0, 0)]))
      ]
      $ \(SomeQuestion question) -> do
        Object keys <- pure (questionInput question)
        let with other = KeyMap.insert "alphabet" other keys
            read' = fmap show . someQuestion (operationOf question) . Object
        read' keys `shouldBe` Just (show (SomeQuestion question))
        read' (KeyMap.delete "alphabet" keys) `shouldSatisfy` (/= Nothing)
        for_ [Null, Bool True, String "#", toJSON [1 :: Int], toJSON ["#" :: String]] $ \other ->
          (other, read' (with other)) `shouldBe` (other, Nothing)
  it "a case of a law of single questions is the pair of an operation's name and its input" $
    for_ (known <$> lookup "gf2-3x5" defaultProfiles) $ \about -> do
      [Cases form _ _] <-
        pure
          [ lawCases one k
            | Right k <- [about],
              one <- laws,
              lawId one == "field/addition-as-defined"
          ]
      let again :: Value -> Maybe Value
          again value = either (const Nothing) (Just . writeValue form) (readValue form value)
          named operation input = toJSON [toJSON (nameOf operation), input]
      for_ (map exampleOf allOperations) $ \(SomeQuestion question) -> do
        let one = named (operationOf question) (questionInput question)
        again one `shouldBe` Just one
      -- Invalid inputs are not changed.
      for_ [Null, object [], Number 1] $ \input ->
        again (named (SomeOp Add) input) `shouldBe` Just (named (SomeOp Add) input)
      map
        again
        [ toJSON [String "divide", object []],
          toJSON [String "add"],
          toJSON [String "add", object [], object []],
          toJSON [Number 1, object []],
          toJSON ([] :: [Value]),
          object [],
          String "add"
        ]
        `shouldBe` replicate 7 Nothing
  it "a probability keeps its value when it or its question is written in another form" $
    for_ (known <$> lookup "gf2-3x5" defaultProfiles) $ \about -> do
      [k] <- pure [k | Right k <- [about]]
      let input = object ["patch" .= [[Just (String "1"), Nothing]]]
      SomeQuestion posed <- maybe (fail "no input") pure (someQuestion (SomeOp Posterior) input)
      Right wanted <- pure (expected k (Raw (SomeOp Posterior) input))
      let off by value = case value of
            Array places -> Array (fmap (off by) places)
            Number n | n /= fromInteger (round n) -> Number (n + by)
            _ -> value
          agreed by = agrees k (Raw (SomeOp Posterior) input) wanted (off by wanted)
      (answerValue posed <$> readAnswer posed wanted) `shouldBe` Just wanted
      map agreed [0, 1e-18, 1e-12, 1e-6] `shouldBe` [True, True, True, False]
  it "an answer gives exactly one of: a position, several positions, or their number" $ do
    let at r c = object ["row" .= (r :: Int), "column" .= (c :: Int)]
        position = "position" .= at 1 2
        several = "positions" .= [at 1 2, at 3 4]
        count = ["count" .= (5 :: Int), "dimension" .= (6 :: Int)]
        read' = readAnswer (Locate :? []) . object
    read' [position] `shouldBe` Just (At (Position 1 2))
    read' [several] `shouldBe` Just (OneOf [Position 1 2, Position 3 4])
    read' count `shouldBe` Just (Coset 5 6)
    map read' [[], [position, several], position : count, several : count, take 1 count]
      `shouldBe` replicate 5 Nothing
  it "an answer states twice and alike whether frames were registered; axes are named x and y" $ do
    let registered outcome reason axes =
          readAnswer
            (Register :? (Nothing, Pair [] [] (0, 0) 0))
            ( object
                [ "outcome" .= (outcome :: String),
                  "reason" .= (reason :: Maybe String),
                  "best" .= [1.5, -2 :: Double],
                  "axes" .= (axes :: [String])
                ]
            )
    registered "registered" Nothing ["x", "y"]
      `shouldBe` Just (Registered Nothing (1.5, -2) (True, True))
    registered "refused" (Just "one-axis") ["y"]
      `shouldBe` Just (Registered (Just "one-axis") (1.5, -2) (False, True))
    registered "refused" (Just "blank") []
      `shouldBe` Just (Registered (Just "blank") (1.5, -2) (False, False))
    [ registered "registered" (Just "blank") [],
      registered "refused" Nothing [],
      registered "other" Nothing [],
      registered "registered" Nothing ["x", "z"]
      ]
      `shouldBe` replicate 4 Nothing

-- | Questions of an operation, with the array of the profile under which they are asked: the
-- example, and under small profiles typical questions, refused ones, and those chosen for vectors.
questionsOf :: SomeOp -> [(Maybe ProfileFacts, SomeQuestion)]
questionsOf some@(SomeOp op) =
  [(Nothing, exampleOf some) | not under] ++ case recordOf op of
    it'@Operation {} -> case operationWays it' of
      UnderProfile means _ ->
        [ (Just k, question)
          | k <- profiles,
            question <-
              typicalOf k some ++ refusedOf k some ++ map (SomeQuestion . (op :?)) (chosen means k)
        ]
      WithoutProfile means _ ->
        [(Nothing, SomeQuestion (op :? input)) | input <- take 60 (chosen means ())]
      ByScene _ _ -> []
  where
    under = some `elem` codeOperations
    chosen :: Meaning about i o -> about -> [i]
    chosen means about = concat [inputs | Group _ (Chosen inputs) <- asked means about]
    profiles =
      [k | (name, p) <- defaultProfiles, name `elem` ["gf2-3x5", "gf9-5x16"], Right k <- [known p]]

isTyped :: SomeQuestion -> Bool
isTyped (SomeQuestion question) = case question of
  _ :? _ -> True
  Raw _ _ -> False
