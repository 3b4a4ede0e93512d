-- | Running the executable, for the tests of the command line.
module Test.CommandLine.Run
  ( Outcome,
    pra,
    praWith,
    praUnder,
    key,
    prints,
    locates,
    complains,
    scripted,
    refuses,
  )
where

import Data.Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.List (isInfixOf, isPrefixOf)
import System.Exit (ExitCode (..))
import System.Process (readProcessWithExitCode)
import Test.Hspec

-- | Status, standard output, standard error.
type Outcome = (Int, String, String)

pra :: [String] -> IO Outcome
pra = (`praWith` "")

praWith :: [String] -> String -> IO Outcome
praWith = ran "pra-tactile"

-- | The same under these options of the run-time system, which the program takes from its
-- environment alone.
praUnder :: String -> [String] -> String -> IO Outcome
praUnder options arguments = ran "env" (("GHCRTS=" ++ options) : "pra-tactile" : arguments)

ran :: FilePath -> [String] -> String -> IO Outcome
ran program arguments input = do
  (code, out, err) <- readProcessWithExitCode program arguments input
  pure (case code of ExitSuccess -> 0; ExitFailure n -> n, out, err)

-- | The value under a path of keys in one line of JSON.
key :: [Key] -> String -> Maybe Value
key path line = decode (Lazy8.pack line) >>= go path
  where
    go [] value = Just value
    go (k : ks) (Object o) = KeyMap.lookup k o >>= go ks
    go _ _ = Nothing

-- | It prints exactly these lines, nothing on the standard error, and ends with status 0.
prints :: [String] -> [String] -> Expectation
prints arguments expected = pra arguments `shouldReturn` (0, unlines expected, "")

-- | The same, but that a line may warn of how little the answer is worth.
locates :: [String] -> [String] -> Expectation
locates arguments expected = do
  (status, out, err) <- pra arguments
  (status, out) `shouldBe` (0, unlines expected)
  filter (not . ("pra-tactile: warning: of random symbols " `isPrefixOf`)) (lines err) `shouldBe` []

-- | It prints nothing, one line of complaint with this in it, and ends with status 2.
complains :: [String] -> String -> Expectation
complains arguments about = do
  (status, out, err) <- pra arguments
  (status, out) `shouldBe` (2, "")
  err `shouldSatisfy` (about `isInfixOf`)
  length (lines err) `shouldBe` 1

-- | A script in a folder of its own, within a minute: nothing hangs. The program is @pra@ there.
scripted :: FilePath -> String -> IO Outcome
scripted folder script = do
  (code, out, err) <-
    readProcessWithExitCode
      "timeout"
      ["60", "sh", "-c", "cd '" ++ folder ++ "'; pra() { pra-tactile \"$@\"; }; " ++ script]
      ""
  pure (case code of ExitSuccess -> 0; ExitFailure n -> n, out, err)

-- | Nothing on the standard output, one line with this in it, status 2.
refuses :: Outcome -> String -> Expectation
refuses (status, out, err) about = do
  (status, out, length (lines err)) `shouldBe` (2, "", 1)
  err `shouldSatisfy` (about `isInfixOf`)
  err `shouldSatisfy` ("pra-tactile: " `isPrefixOf`)
