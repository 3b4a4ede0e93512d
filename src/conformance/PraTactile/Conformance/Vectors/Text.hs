{-# LANGUAGE OverloadedStrings #-}

-- | Test vectors as JSON with one test per line, and reading them back for checking.
module PraTactile.Conformance.Vectors.Text
  ( vectorsText,
    StatedVectors (..),
    readVectors,
    difference,
  )
where

import Data.Aeson (Value (..), object, toJSON, (.=))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as Char8
import Data.List (intersperse)
import Data.Maybe (listToMaybe, mapMaybe)
import qualified Data.Set as Set
import qualified Data.Text as Text
import PraTactile.Conformance.Forms (readWhole)
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Vectors
import PraTactile.Conformance.Vectors.Canonical
import PraTactile.Conformance.Vectors.Flag
import PraTactile.Conformance.Version
import PraTactile.Format.Error (FormatError)
import qualified PraTactile.Format.Json.Codec as Codec
import PraTactile.Format.Profile (profileCodec, profileValue)
import PraTactile.Profile (Profile)

-- | The vectors as JSON, one line per test, with a final line end.
vectorsText :: Vectors -> Lazy.ByteString
vectorsText vectors =
  Builder.toLazyByteString . mconcat $
    [ "{\"schema\":\"pra-tactile/vectors/1\",\n",
      member "suite" (toJSON vectorsVersion) <> ",\n",
      member "operation" (toJSON (nameOf (vectorsOperation vectors))) <> ",\n",
      member "profile" (maybe Null profileValue (vectorsProfile vectors)) <> ",\n",
      member "notes" (notesOf vectors) <> ",\n"
    ]
      ++ [member "digest" (digestValue digest) <> ",\n" | Just digest <- [vectorsDigest vectors]]
      ++ ["\"groups\":[\n", separated (map groupText (vectorsGroups vectors)), "]}\n"]
  where
    digestValue (Digest over hex) = object ["of" .= over, "sha256" .= hex]

-- | The flags that occur, each with its explanation.
notesOf :: Vectors -> Value
notesOf vectors =
  object [Key.fromString (flagName flag) .= flagNote flag | flag <- Set.toList flags]
  where
    flags = Set.fromList (concatMap testFlags (concatMap groupTests (vectorsGroups vectors)))

groupText :: TestGroup -> Builder
groupText group =
  "{" <> member "source" (toJSON (groupName group)) <> ",\"tests\":[\n"
    <> separated (map testText (groupTests group))
    <> "]}"

testText :: Test -> Builder
testText test =
  "{" <> mconcat (intersperse "," [member name value | (name, value) <- testMembers test]) <> "}"

-- | The keys of a test, in order.
testMembers :: Test -> [(String, Value)]
testMembers test =
  [("id", toJSON (testId test)), ("input", testInput test)]
    ++ outcome
    ++ [ ("flags", toJSON (map flagName (Set.toList (Set.fromList (testFlags test))))),
         ("proof", proofValue (testProof test))
       ]
  where
    outcome = case testOutcome test of
      Right result -> [("outcome", String "result"), ("result", result)]
      Left (Refusal reason) -> [("outcome", String "refused"), ("reason", toJSON reason)]

proofValue :: TestProof -> Value
proofValue proof = object $ case proof of
  Exhaustive -> ["kind" .= Text.pack "exhaustive"]
  TwoRoads one other -> ["kind" .= Text.pack "two-roads", "roads" .= [one, other]]
  Sampled seed -> ["kind" .= Text.pack "sampled", "seed" .= seed]

separated :: [Builder] -> Builder
separated = mconcat . intersperse ",\n"

member :: String -> Value -> Builder
member name value = Builder.stringUtf8 (show name) <> ":" <> canonical value

-- | The contents of a file of vectors that are needed to make it again.
data StatedVectors = StatedVectors
  { statedOperation :: SomeOp,
    statedProfile :: Maybe Profile,
    -- | The seed in a drawn test.
    statedSeed :: Maybe Int,
    -- | The tests as JSON.
    statedTests :: [Value]
  }

-- | Reads a file of vectors. Refuses anything else; 'difference' checks the tests.
readVectors :: ByteString -> Either FormatError StatedVectors
readVectors = Codec.decodeWith keys
  where
    keys =
      Codec.schemaKey "pra-tactile/vectors/1"
        *> ( stated
               <$> Codec.key "operation" operationForm statedOperation
               <*> Codec.key "profile" (Codec.nullable profileCodec) statedProfile
               <*> Codec.key "groups" (Codec.listOf group) (const [])
           )
    group = Codec.object (Codec.key "tests" (Codec.listOf Codec.anything) id)
    stated operation profile groups =
      let tests = concat groups
       in StatedVectors operation profile (listToMaybe (mapMaybe seedOf tests)) tests
    seedOf test = lookupIn "proof" test >>= lookupIn "seed" >>= fmap fromInteger . readWhole

lookupIn :: String -> Value -> Maybe Value
lookupIn name value = case value of
  Object fields -> KeyMap.lookup (Key.fromString name) fields
  _ -> Nothing

-- | How a file of vectors, by its bytes and contents, differs from newly made vectors: the first
-- test that differs, or else the text around the tests; 'Nothing' if they are equal.
difference :: ByteString -> StatedVectors -> Vectors -> Maybe String
difference bytes stated made = case firstDifference stated made of
  Nothing
    | Lazy.fromStrict bytes /= vectorsText made ->
      Just "its tests are right, but what is around them is not as it is written"
  found -> found

-- | The first test that differs.
firstDifference :: StatedVectors -> Vectors -> Maybe String
firstDifference stated made = go (statedTests stated) (concatMap groupTests (vectorsGroups made))
  where
    go [] [] = Nothing
    go (test : _) [] = Just ("test " ++ idOf test ++ " is none of those made again")
    go [] (test : _) = Just ("test " ++ testId test ++ " is missing")
    go (test : tests) (again : others)
      | text test == text derived = go tests others
      | idOf test /= testId again =
        Just ("test " ++ idOf test ++ " stands where test " ++ testId again ++ " belongs")
      | otherwise = Just ("test " ++ testId again ++ concatMap (differing test derived) parts)
      where
        derived = object [Key.fromString name .= value | (name, value) <- testMembers again]
    parts = ["input", "outcome", "result", "reason", "flags", "proof"]
    differing test derived part
      | a == b = ""
      | otherwise = ": " ++ part ++ " is " ++ a ++ ", made again " ++ b
      where
        a = maybe "missing" text (lookupIn part test)
        b = maybe "missing" text (lookupIn part derived)
    idOf test = case lookupIn "id" test of
      Just (String name) -> Text.unpack name
      _ -> "without an id"
    text = Char8.unpack . Builder.toLazyByteString . canonical
