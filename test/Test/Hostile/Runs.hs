-- | Runs the program on hostile inputs, in a new folder, with bounds on its memory and its time.
module Test.Hostile.Runs
  ( Run (..),
    Ran (..),
    ran,
    judgedRun,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf)
import System.Directory
import System.Environment (getEnvironment)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, (</>))
import System.IO (IOMode (..), withBinaryFile)
import System.Process
import System.Timeout (timeout)
import Test.Hostile.Judgement
import Test.QuickCheck
import Test.Support

-- | A run: the arguments, the standard input, and the files that exist below the folder in which it
-- runs.
data Run = Run
  { runArguments :: [String],
    runInput :: ByteString,
    runFiles :: [(FilePath, ByteString)]
  }
  deriving stock (Eq, Show)

-- | The outcome of a run: the status, if it ended within 20 seconds; the standard output and error;
-- the files that exist.
data Ran = Ran
  { ranStatus :: Maybe Int,
    ranOutput :: ByteString,
    ranError :: ByteString,
    ranFiles :: [FilePath]
  }
  deriving stock (Eq, Show)

-- | Runs the program with a heap of at most 300 MB. Its runtime system ends it with status 251
-- beyond that.
ran :: Run -> IO Ran
ran run = inFolder $ \folder -> do
  let here = folder </> "here"
      input = folder </> "input"
      printed = folder </> "printed"
      complaints = folder </> "complaints"
  createDirectory here
  for_ (runFiles run) $ \(name, bytes) -> do
    createDirectoryIfMissing True (takeDirectory (here </> name))
    Bytes.writeFile (here </> name) bytes
  Bytes.writeFile input (runInput run)
  surroundings <- getEnvironment
  status <- withBinaryFile input ReadMode $ \i -> withBinaryFile printed WriteMode $ \o ->
    withBinaryFile complaints WriteMode $ \c ->
      withCreateProcess
        (proc "pra-tactile" (runArguments run))
          { cwd = Just here,
            env = Just (("GHCRTS", "-M300m") : filter ((/= "GHCRTS") . fst) surroundings),
            std_in = UseHandle i,
            std_out = UseHandle o,
            std_err = UseHandle c
          }
        (\_ _ _ handle -> timeout 20000000 (waitForProcess handle))
  Ran (numeric <$> status)
    <$> Bytes.readFile printed
    <*> Bytes.readFile complaints
    <*> listDirectory here
  where
    numeric code = case code of
      ExitSuccess -> 0
      ExitFailure n -> n

-- | Demands that a run ends in time and in memory, with one of the three statuses, and says what is
-- wrong on a line of its own words. A run without an answer writes nothing to the standard output,
-- unless it is of a batch. No half-written file is left.
judgedRun :: Run -> Property
judgedRun run = ioProperty $ do
  found <- ran run
  let said = Bytes8.unpack (ranError found)
      refused = ranStatus found == Just 2
      batch = "--batch" `elem` runArguments run
      status = maybe "no end" (("status " ++) . show) (ranStatus found)
  pure $
    classify True status $
      counterexample (show (found {ranOutput = Bytes.take 300 (ranOutput found)})) $
        conjoin
          [ counterexample
              "it does not end within 20 seconds with status 0, 1 or 2"
              (ranStatus found `elem` map Just [0, 1, 2]),
            counterexample
              "bad input: the standard output is not empty"
              (not refused || batch || Bytes.null (ranOutput found)),
            counterexample
              "bad input: the standard error is not one line"
              (not refused || batch || length (lines said) == 1),
            counterexample
              "bad input: the standard error does not name the program"
              (not refused || batch || all named (lines said)),
            counterexample "otherwise: more than a line" (refused || length (lines said) <= 1),
            counterexample "it has words of libraries" (not (any (`isInfixOf` said) internals)),
            counterexample
              "a half-written file is left"
              (not (any (".part" `isInfixOf`) (ranFiles found)))
          ]
  where
    named line = "pra-tactile: " `isPrefixOf` line
