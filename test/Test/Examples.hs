{-# LANGUAGE OverloadedStrings #-}

-- | The decoders in @examples@, which others are to learn from: each is put under the suite, as its
-- page says, and found right.
module Test.Examples (spec) where

import Data.Aeson (Value (..))
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf)
import System.Directory
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Process (readProcessWithExitCode)
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  describe "in C" $ do
    it "is built without a warning, asks for no memory, and is certified" $
      withDecoder $ \decoder -> do
        (_, symbols, _) <- readProcessWithExitCode "nm" ["-u", decoder] ""
        filter (`elem` ["malloc", "calloc", "realloc"]) (map name (words symbols)) `shouldBe` []
        certified (underSome 20) [decoder]
    it "is right in one-shot mode" $
      withDecoder $ \decoder ->
        heldAll
          (inOneShot ("--skip *-as-defined --cases " ++ byEffort "1" "3"))
          [decoder, "--one-shot"]
    it "passes all test vectors" (withDecoder (\decoder -> passesVectors [decoder]))
  describe "in Python" $ do
    it "is certified" $
      withPython $ \python -> certified (underSome 8) [python, "examples/python/subject.py"]
    it "holds the laws of the network" $
      withPython $ \python ->
        heldAll
          (words ("--stage network --cases " ++ byEffort "4" "25"))
          [python, "examples/python/subject.py"]
    it "is right in one-shot mode" $
      withPython $ \python ->
        heldAll
          (inOneShot "--run field/negation-as-defined")
          [python, "-S", "examples/python/subject.py", "--one-shot"]
    whenFull . it "passes all test vectors" $
      withPython (\python -> passesVectors [python, "-S", "examples/python/subject.py"])
  describe "in JavaScript" $ do
    it "is certified" $
      withNode (\node -> certified (underSome 8) [node, "examples/javascript/subject.mjs"])
    it "is right in one-shot mode" $
      withNode $ \node ->
        heldAll
          (inOneShot "--run field/negation-as-defined")
          [node, "examples/javascript/subject.mjs", "--one-shot"]
    whenFull . it "passes all test vectors" $
      withNode (\node -> passesVectors [node, "examples/javascript/subject.mjs"])
  it "in Go: is certified under the paper's profile" $ do
    compiler <- findExecutable "go"
    case compiler of
      Nothing -> pendingWith "there is no Go here"
      Just _ -> inFolder $ \folder -> do
        let decoder = folder </> "decoder"
            build = "cd examples/go && GOTOOLCHAIN=local go build -o '" ++ decoder ++ "' ."
        (status, _, err) <- readProcessWithExitCode "sh" ["-c", build] ""
        (status, err) `shouldBe` (ExitSuccess, "")
        certified (words "--profile examples/adapter/paper.json --cases 20") [decoder]
  describe "in Haskell, on the sublibrary" $ do
    whenFull . it "plain QuickCheck finds that the laws of the field hold" $
      inFolder $ \folder -> do
        built <- haskell ["-O0", "-outputdir", folder, "-o", folder </> "plain"] "Plain"
        built `shouldBe` (ExitSuccess, "", "")
        (status, out, err) <- readProcessWithExitCode (folder </> "plain") [] ""
        (status, err) `shouldBe` (ExitSuccess, "")
        filter (not . ("+++ OK" `isInfixOf`)) (lines out) `shouldBe` []
        length (lines out) `shouldSatisfy` (> 100)
    it "the call of all laws, and the items of hspec, are right to the compiler" $
      for_ ["Plain", "Report", "Spec"] $ \file ->
        haskell ["-fno-code"] file `shouldReturn` (ExitSuccess, "", "")
  it "on galois: it is short" $ do
    text <- readFile "examples/galois/subject.py"
    length (lines text) `shouldSatisfy` (< 60)
  it "the adapter is the one that its page shows" $ do
    page <- lines <$> readFile "docs/conformance.md"
    adapter <- readFile "examples/adapter/adapter.py"
    takeWhile (/= "```") (drop 1 (dropWhile (/= "```python") page)) `shouldBe` lines adapter
  where
    haskell options file =
      readProcessWithExitCode
        "tools/cabal.sh"
        ( ["exec", "-v0", "--", "ghc", "-v0", "-Wall"]
            ++ options
            ++ ["examples" </> "haskell" </> file ++ ".hs"]
        )
        ""
    name = takeWhile (/= '@')

-- | It is certified, under the default profiles if no others are given.
certified :: [String] -> [String] -> Expectation
certified options subject = do
  (status, out, err) <- praAlone (["conform", "--json"] ++ options ++ ["--"] ++ subject)
  (err, map (`key` out) [["failed"], ["errored"], ["certified"]])
    `shouldBe` ("", [Just (Number 0), Just (Number 0), Just (Bool True)])
  status `shouldBe` 0

-- | So many cases of each law under the default profiles, or a few under the paper's.
underSome :: Int -> [String]
underSome count =
  byEffort
    (words "--profile examples/adapter/paper.json --cases 3")
    ["--cases", show count]

-- | The options of a process a request, which a busy machine may take long to start.
inOneShot :: String -> [String]
inOneShot options =
  words ("--one-shot --timeout 60 --profile examples/adapter/paper.json " ++ options)

-- | Some laws were tried, and all of these held.
heldAll :: [String] -> [String] -> Expectation
heldAll options subject = do
  (status, out, err) <- praAlone (["conform", "--json"] ++ options ++ ["--"] ++ subject)
  (status, err, map (`key` out) [["failed"], ["errored"]])
    `shouldBe` (0, "", [Just (Number 0), Just (Number 0)])
  key ["held"] out `shouldSatisfy` (/= Just (Number 0))

-- | It answers all test vectors as they say.
passesVectors :: [String] -> Expectation
passesVectors subject = withPython $ \python -> do
  (status, out, err) <- readProcessWithExitCode python ("test/data/run_vectors.py" : subject) ""
  (status, err, take 1 (drop 1 (lines out))) `shouldBe` (ExitSuccess, "", [])
  filter (`notElem` ['0' .. '9']) (concat (lines out)) `shouldBe` ""
  (read out :: Int) `shouldSatisfy` (> 10000)

-- | With the decoder in C, built in a folder of its own.
withDecoder :: (FilePath -> Expectation) -> Expectation
withDecoder test = do
  compiler <- findExecutable "cc"
  case compiler of
    Nothing -> pendingWith "there is no C compiler here"
    Just cc -> inFolder $ \folder -> do
      entries <- listDirectory ("examples" </> "c")
      let sources = ["examples" </> "c" </> file | file <- entries, isSource file]
          decoder = folder </> "decoder"
      (status, out, err) <-
        readProcessWithExitCode
          cc
          (words "-std=c99 -O2 -Wall -Wextra -pedantic -Werror -o" ++ [decoder] ++ sources)
          ""
      (status, out, err) `shouldBe` (ExitSuccess, "", "")
      test decoder
  where
    isSource file = "c." `isPrefixOf` reverse file

withPython :: (FilePath -> Expectation) -> Expectation
withPython test =
  findExecutable "python3" >>= maybe (pendingWith "python3 is not installed here") test

withNode :: (FilePath -> Expectation) -> Expectation
withNode test = findExecutable "node" >>= maybe (pendingWith "there is no Node here") test
