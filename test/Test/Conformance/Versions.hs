{-# LANGUAGE OverloadedStrings #-}

-- | Tests the version of the suite, and the file that lists its laws.
module Test.Conformance.Versions (spec) where

import Data.Aeson
import qualified Data.ByteString.Lazy as Lazy
import Data.List (nub, (\\))
import PraTactile.Conformance hiding (known)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Process (checkTexts)
import PraTactile.Conformance.Version
import Test.CommandLine.Run
import Test.Hspec hiding (before)

spec :: Spec
spec = do
  it "data/suite.json has every law as the code has it, and no other" $ do
    (_, _, written) <- suiteFile
    let stated = map fst written
    (stated \\ inCode, inCode \\ stated) `shouldBe` ([], [])
  it "data/suite.json has the version that reports state, and no law of a later version" $ do
    (schema, version, written) <- suiteFile
    (schema, version) `shouldBe` ("pra-tactile/suite/1", suiteVersion)
    filter ((> numbers suiteVersion) . numbers) (map snd written) `shouldBe` []
    map (length . numbers) (version : map snd written) `shouldSatisfy` all (== 3)
  it "no id stands twice in data/suite.json, whether its law exists or was removed" $ do
    (_, _, written) <- suiteFile
    gone <- Lazy.readFile "data/suite.json" >>= either fail pure . eitherDecode
    let ids = [name | (Listed name _ _ _ _, _) <- written] ++ map snd (goneLaws gone)
    ids \\ nub ids `shouldBe` []
    map (numbers . fst) (goneLaws gone) `shouldSatisfy` all (<= numbers suiteVersion)
  it "the version number follows from what became of laws since the last release" $ do
    (_, before, released) <- suiteIn "test/data/suite-1.0.0.json"
    (_, now, written) <- suiteFile
    let known = [name | (Listed name _ _ _ _, _) <- released]
        added = [since | (Listed name _ _ _ _, since) <- written, name `notElem` known]
        -- Some were removed, or differ from the released ones.
        changed = not (null (released \\ written))
        next = case numbers before of
          [major, minor, _]
            | changed -> [major + 1]
            | not (null added) -> [major, minor + 1]
          same -> same
    numbers now `shouldSatisfy` (>= next)
    filter ((<= numbers before) . numbers) added `shouldBe` []
  it "the program states the suite's version, also by conform alone" $ do
    praAlone ["conform", "--version"] `shouldReturn` (0, "suite " ++ suiteVersion ++ "\n", "")
    (status, out, err) <- praAlone ["--version"]
    (status, drop 2 (words out), err) `shouldBe` (0, ["suite", suiteVersion], "")

-- | An id, a stage, what the law needs, a sentence and a source.
data Listed = Listed String String [String] String String
  deriving stock (Eq, Show)

inCode :: [Listed]
inCode =
  [Listed name "protocol" [] sentence "the protocol" | (name, sentence) <- checkTexts]
    ++ map listed openingLaws
    ++ map listed laws
    ++ map listed lawsWithoutProfile
  where
    listed :: Law a -> Listed
    listed law =
      Listed
        (lawId law)
        (stageName (lawStage law))
        (map nameOf (lawNeeds law))
        (lawSentence law)
        (lawSource law)

-- | The schema, the version, and the laws, each with the version that introduced it.
suiteFile :: IO (String, String, [(Listed, String)])
suiteFile = suiteIn "data/suite.json"

suiteIn :: FilePath -> IO (String, String, [(Listed, String)])
suiteIn file = do
  bytes <- Lazy.readFile file
  either fail pure (eitherDecode bytes >>= parsed)
  where
    parsed value = case fromJSON value of
      Success (Suite schema version written) -> Right (schema, version, written)
      Error why -> Left why

data Suite = Suite String String [(Listed, String)]

instance FromJSON Suite where
  parseJSON = withObject "suite" $ \keys -> do
    written <- keys .: "laws"
    Suite <$> keys .: "schema" <*> keys .: "suite" <*> traverse law written
    where
      law = withObject "law" $ \keys ->
        (,)
          <$> ( Listed <$> keys .: "id" <*> keys .: "stage" <*> keys .: "needs"
                  <*> keys .: "sentence"
                  <*> keys .: "source"
              )
          <*> keys .: "since"

-- | The removed laws: the first version without each, and its id.
newtype Gone = Gone {goneLaws :: [(String, String)]}

instance FromJSON Gone where
  parseJSON = withObject "suite" $ \keys -> Gone <$> (keys .: "gone" >>= traverse law)
    where
      law = withObject "law" $ \one -> (,) <$> one .: "until" <*> one .: "id"

numbers :: String -> [Int]
numbers text = case break (== '.') text of
  (one, _ : more) -> read one : numbers more
  (one, []) -> [read one]
