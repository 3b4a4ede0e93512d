{-# LANGUAGE OverloadedStrings #-}

-- | Groups of examples of the test suite, how long each takes and which sites it comes to; and
-- running one with a mutant on.
module Group
  ( Suite (..),
    Group (..),
    measured,
    examplesOf,
    Run (..),
    run,
  )
where

import Data.Aeson
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Char (isSpace)
import qualified Data.IntSet as Set
import Data.List (isPrefixOf, stripPrefix, (\\))
import Data.Maybe (isNothing, listToMaybe, mapMaybe)
import Data.Time.Clock (diffUTCTime, getCurrentTime)
import System.Directory (doesFileExist, removeFile)
import System.Exit (ExitCode (..))
import System.IO (IOMode (..), hPutStrLn, stderr, withFile)
import System.Process
import System.Timeout (timeout)

-- | The instrumented suite, and the untouched sources in which it runs.
data Suite = Suite
  { suiteProgram :: FilePath,
    suiteHome :: FilePath,
    suiteScratch :: FilePath,
    suiteVariables :: [(String, String)]
  }

-- | Examples under one heading of the suite.
data Group = Group
  { -- | As hspec's @--match@ takes it.
    groupPath :: String,
    -- | Seconds, without a mutant.
    groupTook :: Double,
    groupPasses :: Bool,
    groupSites :: Set.IntSet
  }

instance ToJSON Group where
  toJSON g =
    object
      [ "path" .= groupPath g,
        "seconds" .= groupTook g,
        "passes" .= groupPasses g,
        "sites" .= Set.toList (groupSites g)
      ]

instance FromJSON Group where
  parseJSON = withObject "group" $ \o ->
    Group
      <$> o .: "path"
      <*> o .: "seconds"
      <*> o .: "passes"
      <*> (Set.fromList <$> o .: "sites")

-- | The groups that pass without a mutant, as far as they are known from the file, where those that
-- are not are added, an object a line. Those that fail take no part, and are named on the standard
-- error.
measured :: Suite -> FilePath -> IO [Group]
measured suite file = do
  there <- doesFileExist file
  known <- if there then mapMaybe decodeStrict . Bytes.lines <$> Bytes.readFile file else pure []
  listed <- readCreateProcess (inHome suite [] ["--dry-run", "--no-color"]) ""
  more <- traverse measure (headings (lines listed) \\ map groupPath known)
  pure (filter groupPasses (known ++ more))
  where
    measure path = do
      let trace = suiteScratch suite ++ "/sites"
      ended <- run suite 1200 [("PRA_TACTILE_SITES", trace)] path (suiteScratch suite ++ "/log")
      traced <- doesFileExist trace
      sites <- if traced then map read . lines <$> readFile trace else pure []
      length sites `seq` if traced then removeFile trace else pure ()
      let group = Group path (runTook ended) (runPassed ended) (Set.fromList sites)
      hPutStrLn
        stderr
        (path ++ ": " ++ show (Set.size (groupSites group)) ++ " sites, " ++ show ended)
      group <$ Lazy.appendFile file (encode group <> "\n")

-- | The paths of all examples and headings.
examplesOf :: Suite -> IO [String]
examplesOf suite = do
  listed <- readCreateProcess (inHome suite [] ["--dry-run", "--no-color"]) ""
  pure (go [] (filter (not . all isSpace) (lines listed)))
  where
    go above rows = case rows of
      [] -> []
      row : more ->
        let (indent, title) = span (== ' ') row
            here = take (length indent `div` 2) above ++ [title]
         in (concatMap ('/' :) here ++ "/") : go here more

-- | The headings of the first and second rank, as paths; of a first one without second ones itself.
headings :: [String] -> [String]
headings rows = case dropWhile blank rows of
  [] -> []
  top : more ->
    let (body, others) = break (\row -> not (blank row) && depth row == 0) more
        seconds =
          [drop 2 a | (a, b) <- zip body (drop 1 body), depth a == 2, not (blank a), depth b > 2]
     in if depth top == 0 && not (null body)
          then
            ( if null seconds
                then ["/" ++ top ++ "/"]
                else ["/" ++ top ++ "/" ++ s ++ "/" | s <- seconds]
            )
              ++ headings others
          else headings others
  where
    blank = all isSpace
    depth = length . takeWhile (== ' ')

-- | How a run of a group ended.
data Run = Run
  { runPassed :: Bool,
    runTimedOut :: Bool,
    -- | The path of an example that failed.
    runFailed :: Maybe String,
    runTook :: Double
  }
  deriving stock (Show)

-- | Run a group, at most this many seconds, with these environment variables; its output goes to
-- the file.
run :: Suite -> Int -> [(String, String)] -> String -> FilePath -> IO Run
run suite seconds variables path output = do
  begun <- getCurrentTime
  ended <- withFile output WriteMode $ \log' -> do
    (_, _, _, process) <-
      createProcess
        (inHome suite variables ["--no-color", "--seed", "1", "--fail-fast", "--match", path])
          { std_out = UseHandle log',
            std_err = UseHandle log',
            std_in = NoStream,
            create_group = True
          }
    code <- timeout (seconds * 1000000) (waitForProcess process)
    case code of
      Just found -> pure (Just found)
      Nothing -> do
        interruptProcessGroupOf process
        _ <- timeout 5000000 (waitForProcess process)
        terminateProcess process
        Nothing <$ waitForProcess process
  now <- getCurrentTime
  text <- readFile output >>= \all' -> length all' `seq` pure all'
  let failed = listToMaybe (mapMaybe rerun (lines text))
      passed = ended == Just ExitSuccess && not (any (isPrefixOf "0 examples") (lines text))
  pure (Run passed (isNothing ended) failed (realToFrac (diffUTCTime now begun)))
  where
    rerun row =
      takeWhile (/= '"') <$> stripPrefix "To rerun use: --match \"" (dropWhile isSpace row)

inHome :: Suite -> [(String, String)] -> [String] -> CreateProcess
inHome suite variables arguments =
  -- An endless mutant may take memory without end, too.
  (proc "sh" (["-c", "ulimit -d 4000000; exec \"$0\" \"$@\"", suiteProgram suite] ++ arguments))
    { cwd = Just (suiteHome suite),
      env = Just (suiteVariables suite ++ variables)
    }
