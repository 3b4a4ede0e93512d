{-# LANGUAGE OverloadedStrings #-}

-- | Tests the example decoders in @examples@: the suite certifies each, by the commands that its
-- page gives.
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
  describe "in C" . aroundAll withDecoder $ do
    it "is built without a warning, allocates no memory, and is certified" $
      ifBuilt $ \decoder -> do
        (_, symbols, _) <- readProcessWithExitCode "nm" ["-u", decoder] ""
        filter (`elem` ["malloc", "calloc", "realloc"]) (map name (words symbols)) `shouldBe` []
        certified (underSome 20) [decoder]
    it "is right in one-shot mode" $
      ifBuilt $ \decoder ->
        heldAll
          (inOneShot (byEffort drawnLaws "--skip *-as-defined --cases 3"))
          [decoder, "--one-shot"]
    it "passes test vectors" (ifBuilt (\decoder -> passesVectors [decoder]))
  describe "in Python" $ do
    it "holds the laws of the code" $
      withPython $ \python -> certifiedIn 8 [python, "examples/python/subject.py"]
    it "holds the laws of the network" $
      withPython $ \python ->
        heldAll
          (words ("--stage network --cases " ++ byEffort "4" "25"))
          [python, "examples/python/subject.py"]
    it "answers the one request of a process" $
      withPython $ \python -> answersAlone python ["-S", "examples/python/subject.py", "--one-shot"]
    whenFull . it "is right in one-shot mode" $
      withPython $ \python ->
        heldAll
          (inOneShot "--run field/negation-as-defined")
          [python, "-S", "examples/python/subject.py", "--one-shot"]
    whenFull . it "passes test vectors" $
      withPython (\python -> passesVectors [python, "-S", "examples/python/subject.py"])
  describe "in JavaScript" $ do
    it "holds the laws of the code" $
      withNode (\node -> certifiedIn 8 [node, "examples/javascript/subject.mjs"])
    it "answers the one request of a process" $
      withNode $ \node -> answersAlone node ["examples/javascript/subject.mjs", "--one-shot"]
    whenFull . it "is right in one-shot mode" $
      withNode $ \node ->
        heldAll
          (inOneShot "--run field/negation-as-defined")
          [node, "examples/javascript/subject.mjs", "--one-shot"]
    whenFull . it "passes test vectors" $
      withNode (\node -> passesVectors [node, "examples/javascript/subject.mjs"])
  it "the decoder in Go holds the laws of the code under the paper's profile" $ do
    compiler <- findExecutable "go"
    case compiler of
      Nothing -> pendingWith "there is no Go here"
      Just _ -> inFolder $ \folder -> do
        let decoder = folder </> "decoder"
            build = "cd examples/go && GOTOOLCHAIN=local go build -o '" ++ decoder ++ "' ."
        (status, _, err) <- readProcessWithExitCode "sh" ["-c", build] ""
        (status, err) `shouldBe` (ExitSuccess, "")
        certifiedBy (words "--profile examples/adapter/paper.json --cases 20") [decoder]
  describe "in Haskell, on the sublibrary" $ do
    whenFull . it "plain QuickCheck finds that the laws of the field hold" $
      inFolder $ \folder -> do
        built <- haskell ["-O0", "-outputdir", folder, "-o", folder </> "plain"] "Plain"
        built `shouldBe` (ExitSuccess, "", "")
        (status, out, err) <- readProcessWithExitCode (folder </> "plain") [] ""
        (status, err) `shouldBe` (ExitSuccess, "")
        filter (not . ("+++ OK" `isInfixOf`)) (lines out) `shouldBe` []
        length (lines out) `shouldSatisfy` (> 100)
    it "the calls of all laws and of the hspec items compile" $
      for_ (byEffort id ("Plain" :) ["Report", "Spec"]) $ \file ->
        haskell ["-fno-code"] file `shouldReturn` (ExitSuccess, "", "")
  it "the decoder on galois is short" $ do
    text <- readFile "examples/galois/subject.py"
    length (lines text) `shouldSatisfy` (< 60)
  it "the Python package passes its own tests as a wheel, and its page's lines run" $
    withPython $ \python -> inFolder $ \folder -> do
      Just program <- findExecutable "pra-tactile"
      top <- getCurrentDirectory
      (made, _, _) <- readProcessWithExitCode python ["-m", "venv", folder </> "venv"] ""
      if made /= ExitSuccess
        then pendingWith "Python has no venv here"
        else do
          -- The program is large and therefore not copied.
          writeFile (folder </> "program") ("#!/bin/sh\nexec '" ++ program ++ "' \"$@\"\n")
          createDirectoryLink (top </> "data") (folder </> "data")
          createDirectoryLink (top </> "data/worked-example/frames") (folder </> "frames")
          page <- lines <$> readFile "python/README.md"
          writeFile
            (folder </> "page.py")
            (unlines (takeWhile (/= "```") (drop 1 (dropWhile (/= "```python") page))))
          (_, wheel, "") <-
            readProcessWithExitCode
              python
              ["tools/wheel.py", folder </> "program", "LICENSE", folder]
              ""
          let script = "cd '" ++ folder ++ "' && PATH=venv/bin:$PATH && "
              run = readProcessWithExitCode "sh" ["-c", script ++ commands] ""
              commands =
                "pip install -q --no-index --disable-pip-version-check " ++ filter (/= '\n') wheel
                  ++ " && python -m unittest -q pra_tactile.test 2>&1 | tail -n 1 | cut -c 1-2\
                     \ && python page.py\
                     \ && venv/bin/pra-tactile locate '3 2 / 3 1'"
          (status, out, _) <- run
          (status, out)
            `shouldBe` ( ExitSuccess,
                         unlines
                           [ "OK",
                             "cube, face C1 C2 C3 C4, corner C2",
                             "{'column': 5, 'row': 6}",
                             "[]",
                             "row 6, column 5"
                           ]
                       )
  it "the tutorial shows the decoder and its adapter" $ do
    page <- lines <$> readFile "docs/tutorial/conform.md"
    shown <- traverse (readFile . ("examples/adapter/" ++)) ["somebody.py", "session.py"]
    pythonIn page `shouldBe` map lines shown
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
    -- The blocks of Python in a page.
    pythonIn page = case dropWhile (/= "```python") page of
      [] -> []
      _ : others -> let (block, rest) = break (== "```") others in block : pythonIn rest

-- | Expects that it is certified, under the default profiles if no others are given.
certified :: [String] -> [String] -> Expectation
certified options subject = do
  (status, out, err) <- praAlone (["conform", "--json"] ++ options ++ ["--"] ++ subject)
  (err, map (`key` out) [["failed"], ["errored"], ["certified"]])
    `shouldBe` ("", [Just (Number 0), Just (Number 0), Just (Bool True)])
  status `shouldBe` 0

-- | Expects that it is certified with this many cases under the default profiles. A quick run tries
-- laws of each operation under the paper's profile.
certifiedIn :: Int -> [String] -> Expectation
certifiedIn count = certifiedBy ["--cases", show count]

-- | Expects that it is certified with these options. A quick run tries laws of each operation, in a
-- few cases.
certifiedBy :: [String] -> [String] -> Expectation
certifiedBy options = byEffort (heldAll ofEachOperation) (certified options)
  where
    ofEachOperation =
      words "--profile examples/adapter/paper.json --cases 3"
        ++ concat [["--run", law] | law <- words someLaws]
    someLaws =
      "field/*-as-defined polynomial/first-primitive-as-defined polynomial/primitive-of-drawn-ones \
      \sequence/term-of-any-index sequence/terms-of-any-index array/cell-at-the-edges \
      \window/pack-as-defined window/unpack-as-defined proof/prove-drawn-masks \
      \proof/distance-drawn-masks locate/drawn-patches damage/few-cells chances/bayes"

-- | Options for this many cases of each law under the default profiles, or in a quick run a few
-- under the paper's.
underSome :: Int -> [String]
underSome count =
  byEffort
    (words "--profile examples/adapter/paper.json --cases 3")
    ["--cases", show count]

-- | Laws of which few cases are drawn.
drawnLaws :: String
drawnLaws =
  "--cases 3 --run field/negation-as-defined --run sequence/terms-of-any-index \
  \--run locate/drawn-patches --run chances/bayes"

-- | Expects that a process with one request and no session answers it and ends with success.
answersAlone :: FilePath -> [String] -> Expectation
answersAlone program arguments = do
  profile <- readFile "examples/adapter/paper.json"
  let request =
        ("{\"profile\": " ++ concat (lines profile) ++ ", \"sequence\": 7, ")
          ++ "\"operation\": \"multiply\", \"input\": {\"a\": 2, \"b\": 3}}\n"
  (status, out, err) <- readProcessWithExitCode program arguments request
  (status, err, map (`key` out) [["sequence"], ["result"]])
    `shouldBe` (ExitSuccess, "", [Just (Number 7), Just (Number 1)])

-- | The options for a process per request, which a busy machine may be slow to start.
inOneShot :: String -> [String]
inOneShot options =
  words ("--one-shot --timeout 60 --profile examples/adapter/paper.json " ++ options)

-- | Expects that some laws were tried and that all of these held.
heldAll :: [String] -> [String] -> Expectation
heldAll options subject = do
  (status, out, err) <- praAlone (["conform", "--json"] ++ options ++ ["--"] ++ subject)
  (status, err, map (`key` out) [["failed"], ["errored"]])
    `shouldBe` (0, "", [Just (Number 0), Just (Number 0)])
  key ["held"] out `shouldSatisfy` (/= Just (Number 0))

-- | Expects the answers of all test vectors; in a quick run of those of the paper's profile.
passesVectors :: [String] -> Expectation
passesVectors subject = withPython $ \python -> do
  let given = "test/data/run_vectors.py" : byEffort "paper" "*" : subject
  (status, out, err) <- readProcessWithExitCode python given ""
  (status, err, take 1 (drop 1 (lines out))) `shouldBe` (ExitSuccess, "", [])
  filter (`notElem` ['0' .. '9']) (concat (lines out)) `shouldBe` ""
  (read out :: Int) `shouldSatisfy` (> byEffort 1000 10000)

-- | Runs an action with the decoder in C, built in a new folder, if there is a compiler.
withDecoder :: (Maybe FilePath -> IO ()) -> IO ()
withDecoder test = do
  compiler <- findExecutable "cc"
  case compiler of
    Nothing -> test Nothing
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
      test (Just decoder)
  where
    isSource file = "c." `isPrefixOf` reverse file

ifBuilt :: (FilePath -> Expectation) -> Maybe FilePath -> Expectation
ifBuilt = maybe (pendingWith "there is no C compiler here")

withPython :: (FilePath -> Expectation) -> Expectation
withPython test =
  findExecutable "python3" >>= maybe (pendingWith "python3 is not installed here") test

withNode :: (FilePath -> Expectation) -> Expectation
withNode test = findExecutable "node" >>= maybe (pendingWith "there is no Node here") test
