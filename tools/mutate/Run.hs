-- | Running a part of the instrumented test suite, with limits.
module Run
  ( Suite (..),
    Limits (..),
    Run (..),
    run,
    dryRun,
  )
where

import Data.Char (isSpace)
import Data.List (isPrefixOf, stripPrefix)
import Data.Maybe (fromMaybe, isNothing, listToMaybe, mapMaybe)
import Data.Time.Clock (diffUTCTime, getCurrentTime)
import System.Directory (doesFileExist, removeFile)
import System.Exit (ExitCode (..))
import System.IO (IOMode (..), withFile)
import System.Posix.Signals (sigKILL, signalProcessGroup)
import System.Process
import System.Timeout (timeout)
import Text.Read (readMaybe)

-- | The instrumented suite, and the untouched sources in which it runs.
data Suite = Suite
  { suiteProgram :: FilePath,
    suiteHome :: FilePath,
    suiteScratch :: FilePath,
    suiteVariables :: [(String, String)]
  }

-- | At most so many seconds.
data Limits = Limits
  { -- | Of processor time, for the suite and each process that it starts. Other work on the machine
    -- does not count.
    limitWork :: Int,
    -- | By the clock, for what sleeps.
    limitWait :: Int
  }

-- | How a run of a group ended.
data Run = Run
  { runPassed :: Bool,
    runTimedOut :: Bool,
    -- | The path of an example that failed.
    runFailed :: Maybe String,
    -- | Seconds of processor time, of the suite and what it started.
    runTook :: Double,
    -- | Seconds by the clock.
    runWaited :: Double
  }
  deriving stock (Show)

-- | Run the examples whose path has this in it, with these environment variables.
run :: Suite -> Limits -> [(String, String)] -> String -> IO Run
run suite limits variables path = do
  begun <- getCurrentTime
  ended <- withFile output WriteMode $ \log' -> do
    (_, _, _, process) <-
      createProcess
        (inHome suite limits variables (options ++ ["--match", path]))
          { std_out = UseHandle log',
            std_err = UseHandle log',
            std_in = NoStream,
            create_group = True
          }
    code <- timeout (limitWait limits * 1000000) (waitForProcess process)
    case code of
      Just found -> pure (Just found)
      Nothing -> do
        getPid process >>= mapM_ (signalProcessGroup sigKILL)
        Nothing <$ waitForProcess process
  now <- getCurrentTime
  text <- readFile output >>= \all' -> length all' `seq` pure all'
  counted <- doesFileExist (times suite)
  took <- if counted then seconds <$> readFile (times suite) else pure Nothing
  length (show took) `seq` if counted then removeFile (times suite) else pure ()
  let waited = realToFrac (diffUTCTime now begun)
      passed = ended == Just ExitSuccess && not (any (isPrefixOf "0 examples") (lines text))
  pure
    Run
      { runPassed = passed,
        runTimedOut = isNothing ended || ended == Just outOfTime,
        runFailed = listToMaybe (mapMaybe rerun (lines text)),
        runTook = fromMaybe waited took,
        runWaited = waited
      }
  where
    output = suiteScratch suite ++ "/log"
    options = ["--no-color", "--seed", "1", "--fail-fast"]
    -- What a shell says of a process that SIGXCPU has ended.
    outOfTime = ExitFailure (128 + 24)
    rerun row =
      takeWhile (/= '"') <$> stripPrefix "To rerun use: --match \"" (dropWhile isSpace row)

times :: Suite -> FilePath
times suite = suiteScratch suite ++ "/times"

-- | The seconds of a shell's children, by what its command @times@ prints: in the second line, of
-- the forms @0m1.25s@.
seconds :: String -> Maybe Double
seconds text = case drop 1 (lines text) of
  row : _ | (_ : _) <- words row -> sum <$> mapM one (words row)
  _ -> Nothing
  where
    one word = case break (== 'm') word of
      (minutes, 'm' : rest) ->
        (\m s -> 60 * m + s) <$> readMaybe minutes <*> readMaybe (takeWhile (/= 's') rest)
      _ -> Nothing

-- | What the suite lists when no example is run.
dryRun :: Suite -> IO String
dryRun suite = readCreateProcess (inHome suite (Limits 60 600) [] ["--dry-run", "--no-color"]) ""

inHome :: Suite -> Limits -> [(String, String)] -> [String] -> CreateProcess
inHome suite limits variables arguments =
  (proc "sh" (["-c", script, suiteProgram suite] ++ arguments))
    { cwd = Just (suiteHome suite),
      env = Just (suiteVariables suite ++ variables)
    }
  where
    -- An endless mutant may take memory without end, too.
    script =
      "ulimit -c 0; ulimit -d 4000000; ulimit -S -t "
        ++ show (limitWork limits)
        ++ "; \"$0\" \"$@\"; code=$?; times > '"
        ++ times suite
        ++ "'; exit $code"
