-- | The program run on hostile inputs, in a folder of its own, with a bound on its memory and on
-- its time.
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

-- | What is run: the arguments, the standard input, and the files that are there, below the folder
-- that it is run in.
data Run = Run
  { runArguments :: [String],
    runInput :: ByteString,
    runFiles :: [(FilePath, ByteString)]
  }
  deriving stock (Eq, Show)

-- | What came of it: the status, if it ended within 20 seconds; the standard output and error; the
-- files that are there.
data Ran = Ran
  { ranStatus :: Maybe Int,
    ranOutput :: ByteString,
    ranError :: ByteString,
    ranFiles :: [FilePath]
  }
  deriving stock (Eq, Show)

-- | Run the program with a heap of at most 300 MB; beyond it, its runtime system ends it with
-- status 251.
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

-- | That it ended in time, in memory, with one of the three statuses, and said what is wrong on a
-- line of its own words; that nothing is on the standard output where nothing was answered, unless
-- of a batch; and that nothing half written is left.
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
              "it ends within 20 seconds with status 0, 1 or 2"
              (ranStatus found `elem` map Just [0, 1, 2]),
            counterexample
              "bad input: nothing is answered"
              (not refused || batch || Bytes.null (ranOutput found)),
            counterexample
              "bad input: a line"
              (not refused || batch || length (lines said) == 1),
            counterexample
              "bad input: it names the program"
              (not refused || batch || all named (lines said)),
            counterexample "otherwise: a line at most" (refused || length (lines said) <= 1),
            counterexample "in words of our own" (not (any (`isInfixOf` said) internals)),
            counterexample
              "nothing half written is left"
              (not (any (".part" `isInfixOf`) (ranFiles found)))
          ]
  where
    named line = "pra-tactile: " `isPrefixOf` line
