-- | Running commands, for the tests of the command line: most in this process, through their
-- parser; as processes where streams, signals or the memory are what is tested.
module Test.CommandLine.Run
  ( Outcome,

    -- * In process
    pra,
    praWith,
    key,
    prints,
    locates,
    complains,
    refuses,
    workedExample,

    -- * As processes
    praAlone,
    praAloneWith,
    praUnder,
    scripted,
  )
where

import CommandLine (answering)
import Control.Concurrent.MVar
import Control.Exception (bracket, try)
import Data.Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.List (isInfixOf, isPrefixOf)
import Data.Void (absurd)
import Documents.Transcript (readText)
import ExitStatus (runToExit)
import GHC.IO.Handle (hDuplicate, hDuplicateTo)
import System.Environment (withArgs, withProgName)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO
import System.IO.Unsafe (unsafePerformIO)
import System.Process (readProcessWithExitCode)
import Test.Hspec
import Test.Support

-- | Status, standard output, standard error.
type Outcome = (Int, String, String)

-- | What a command answers, without an input. A test that uses this is not 'parallel': hspec
-- writes to the same standard output.
pra :: [String] -> IO Outcome
pra = (`praWith` "")

-- | What a command answers that reads this from the standard input.
praWith :: [String] -> String -> IO Outcome
praWith arguments input = withMVar turn $ \_ -> inFolder $ \folder -> do
  let file name = folder </> name
  withFile (file "input") WriteMode (\to -> hSetEncoding to utf8 >> hPutStr to input)
  code <-
    try . withProgName "pra-tactile" . withArgs arguments $
      replaced stdin (file "input") ReadMode . replaced stdout (file "output") WriteMode $
        replaced stderr (file "complaints") WriteMode (runToExit (answering arguments))
  outcome (either id absurd code) <$> readText (file "output") <*> readText (file "complaints")

-- | What @decode --json@ answers of the frames of the paper's worked example. Several tests compare
-- an answer with it; it is computed once.
workedExample :: Outcome
workedExample = unsafePerformIO (pra ["decode", "--json", "data/worked-example/frames"])
{-# NOINLINE workedExample #-}

-- | Only one command at a time has the process's standard streams and arguments.
turn :: MVar ()
turn = unsafePerformIO (newMVar ())
{-# NOINLINE turn #-}

-- | Go on with a file in the place of a standard stream.
replaced :: Handle -> FilePath -> IOMode -> IO a -> IO a
replaced stream file mode = bracket kept restored . const
  where
    kept = (,) <$> hDuplicate stream <*> hGetBuffering stream <* instead
    instead = withFile file mode (`hDuplicateTo` stream) >> hSetEncoding stream utf8
    restored (saved, buffering) = do
      hDuplicateTo saved stream
      hClose saved
      hSetBuffering stream buffering

-- | What a command answers as a process of its own. Tests that run beside others use this, and
-- those of commands that start processes.
praAlone :: [String] -> IO Outcome
praAlone = (`praAloneWith` "")

-- | What a command answers as a process of its own that reads this from the standard input.
praAloneWith :: [String] -> String -> IO Outcome
praAloneWith = process "pra-tactile"

-- | Status, output and errors of the program as a process under these options of the run-time
-- system, which it takes from its environment alone.
praUnder :: String -> [String] -> String -> IO Outcome
praUnder options arguments = process "env" (("GHCRTS=" ++ options) : "pra-tactile" : arguments)

process :: FilePath -> [String] -> String -> IO Outcome
process program arguments input = do
  (code, out, err) <- readProcessWithExitCode program arguments input
  pure (outcome code out err)

outcome :: ExitCode -> String -> String -> Outcome
outcome code out err = (case code of ExitSuccess -> 0; ExitFailure n -> n, out, err)

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
scripted folder script =
  process
    "timeout"
    ["60", "sh", "-c", "cd '" ++ folder ++ "'; pra() { pra-tactile \"$@\"; }; " ++ script]
    ""

-- | Nothing on the standard output, one line with this in it, status 2.
refuses :: Outcome -> String -> Expectation
refuses (status, out, err) about = do
  (status, out, length (lines err)) `shouldBe` (2, "", 1)
  err `shouldSatisfy` (about `isInfixOf`)
  err `shouldSatisfy` ("pra-tactile: " `isPrefixOf`)
