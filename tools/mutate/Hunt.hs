-- | Hunts mutants: @hunt SPEC PROGRAM-FOLDER HOME MUTANTS RESULTS STATE [OPTIONS]@ ("Choice" has
-- the options). Each mutant is on while the groups of examples run that come to its site, the
-- nearest group first, up to the first that fails. A line of JSON each is appended to @RESULTS@.
-- What stands there already is used where the mutant's file is the same: what noticed it, if that
-- example still is in the suite; else the groups that did not notice it, which do not run again.
-- Mutants that change nothing that could be observed, by @tools/mutate/equivalent.txt@ in HOME, are
-- not run. At the end the table by module is printed ("Table").
module Main (main) where

import Choice
import Control.Concurrent
import Control.Exception (throwIO)
import Control.Monad (forM, forM_, unless)
import Data.Aeson (decodeStrict, encode)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Char (isSpace)
import qualified Data.IntSet as Set
import Data.List (isPrefixOf, partition, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, mapMaybe)
import qualified Data.Set as Names
import Data.Time.Clock (UTCTime, diffUTCTime, getCurrentTime)
import Group
import Run
import Site
import System.Directory
import System.Environment (getArgs, getEnvironment)
import System.Exit (ExitCode (..), exitWith)
import System.FilePath (takeDirectory, (</>))
import System.IO
import Table
import Text.Printf (hPrintf)

main :: IO ()
main = do
  arguments <- getArgs
  case arguments of
    spec : program : home : mutants : results : state : options
      | Just choice <- chooseFrom options -> do
        variables <- getEnvironment
        let path = maybe program ((program ++ ":") ++) (lookup "PATH" variables)
            suite scratch =
              Suite spec home scratch (("PATH", path) : filter ((/= "PATH") . fst) variables)
        hunt choice suite home mutants results state
    _ -> do
      hPutStrLn
        stderr
        ("usage: hunt SPEC PROGRAM-FOLDER HOME MUTANTS RESULTS STATE " ++ usage)
      exitWith (ExitFailure 2)

-- | First all mutants with the groups that do not take long; then, with those that take long, what
-- these did not notice.
hunt :: Choice -> (FilePath -> Suite) -> FilePath -> FilePath -> FilePath -> String -> IO ()
hunt choice suite home mutantsFile resultsFile state = do
  mutants <- readMutants mutantsFile
  equivalent <- readEquivalent (home </> "tools" </> "mutate" </> "equivalent.txt")
  let (shard, shards) = choiceShard choice
      (same, ours) =
        partition
          ((`Names.member` equivalent) . mutantName)
          [m | (i, m) <- zip [0 ..] mutants, i `mod` shards == shard - 1]
      bySource = Map.fromList [(mutantName m, siteSource (mutantSite m)) | m <- ours]
      unchanged r = Map.lookup (resultName r) bySource == Just (siteSource (resultSite r))
  createDirectoryIfMissing True (folder </> "scratch")
  examples <- Names.fromList . concatMap pathsIn <$> headings (suite (folder </> "scratch"))
  earlier <- readResults resultsFile
  let holds r = unchanged r && all (`Names.member` examples) (noticedIn (resultOutcome r))
  done <- newMVar (latest (filter holds earlier))
  let stages = Quick : [Slow | not (choiceQuick choice)]
  forM_ stages $ \pace -> do
    groups <- measured (suite (folder </> "scratch")) state pace (folder </> "groups.jsonl")
    known <- readMVar done
    -- First those of the modules that are tried as a whole, and last those that were tried before.
    let order m = (mutantDrawn m, Map.member (mutantName m) known)
        left = sortOn order (filter (stillOpen pace groups known) ours)
    unless (null left) $
      stage (choiceJobs choice) suite folder pace groups (length ours) left earlier done resultsFile
  known <- readMVar done
  putStr (tables same ours known)
  where
    folder = takeDirectory resultsFile
    latest results = Map.fromList [(resultName r, r) | r <- results]
    stillOpen pace groups known m = case Map.lookup (mutantName m) known of
      Nothing -> True
      Just r
        | noticedBy (resultOutcome r) -> False
        | otherwise ->
          pace == Slow && resultOutcome r == Open
            || any (fits pace) (untried groups m (resultTried r))

-- | All of these mutants, each by one of the workers.
stage ::
  Int ->
  (FilePath -> Suite) ->
  FilePath ->
  Pace ->
  [Group] ->
  Int ->
  [Mutant] ->
  [Result] ->
  MVar (Map.Map String Result) ->
  FilePath ->
  IO ()
stage jobs suite folder pace groups whole left earlier done resultsFile = do
  begun <- getCurrentTime
  queue <- newMVar left
  count <- newMVar (0 :: Int)
  ended <- forM [1 .. jobs] $ \worker -> do
    end <- newEmptyMVar
    let scratch = folder </> ("scratch-" ++ show worker)
        work = do
          next <- modifyMVar queue $ \waiting -> pure $ case waiting of
            [] -> ([], Nothing)
            one : more -> (more, Just one)
          forM_ next $ \mutant -> do
            known <- readMVar done
            let before = maybe [] resultTried (Map.lookup (mutantName mutant) known)
                near = noticedNear (Map.elems known ++ earlier) mutant
            result <- tryMutant (suite scratch) pace groups near before mutant
            modifyMVar_ done $ \results -> do
              Lazy.appendFile resultsFile (encode result <> Lazy.pack "\n")
              let now = Map.insert (mutantName mutant) result results
              number <- modifyMVar count (\n -> pure (n + 1, n + 1))
              progress begun whole (length left) number (Map.elems now)
              pure now
            work
    createDirectoryIfMissing True scratch
    end <$ forkFinally work (putMVar end)
  mapM_ (\end -> takeMVar end >>= either throwIO pure) ended

-- | The names of mutants in a file, each on a line of its own; the reason follows, indented.
readEquivalent :: FilePath -> IO (Names.Set String)
readEquivalent file = do
  there <- doesFileExist file
  text <- if there then readFile file else pure ""
  pure (Names.fromList [row | row@(c : _) <- lines text, not (isSpace c)])

readResults :: FilePath -> IO [Result]
readResults file = do
  there <- doesFileExist file
  if there then mapMaybe decodeStrict . Bytes.lines <$> Bytes.readFile file else pure []

-- | Seconds of processor time that a mutant may take at the quick pace.
quickly :: Double
quickly = 6

fits :: Pace -> Group -> Bool
fits pace group = pace == Slow || groupTook group <= quickly

-- | The groups that come to a mutant's site and have not been tried, by their keys.
untried :: [Group] -> Mutant -> [String] -> [Group]
untried groups mutant before =
  [ g
    | g <- groups,
      Set.member (siteNumber (mutantSite mutant)) (groupSites g),
      groupKey g `notElem` before
  ]

-- | How often a group noticed mutants of the same file.
noticedNear :: [Result] -> Mutant -> Group -> Int
noticedNear results mutant = \group -> length (filter (groupPath group `isPrefixOf`) examples)
  where
    examples =
      [ example
        | r <- results,
          siteFile (resultSite r) == siteFile (mutantSite mutant),
          example <- noticedIn (resultOutcome r)
      ]

-- | Run the tests that come to a mutant's site, but for those of these keys. The nearest come
-- first: those that are quick, come to few other sites, and noticed other mutants of the file.
tryMutant :: Suite -> Pace -> [Group] -> (Group -> Int) -> [String] -> Mutant -> IO Result
tryMutant suite pace groups near before mutant = do
  begun <- getCurrentTime
  (outcome, tried) <- through before chosen
  now <- getCurrentTime
  pure
    Result
      { resultMutant = mutant,
        resultOutcome = outcome,
        resultTried = tried,
        resultTook = realToFrac (diffUTCTime now begun)
      }
  where
    site = mutantSite mutant
    variables =
      [("PRA_TACTILE_MUTANT", show (siteNumber site) ++ "." ++ show (mutantVariant mutant))]
    chosen = affordable quickly (sortOn distance (untried groups mutant before))
    distance group =
      (0.1 + groupTook group) * fromIntegral (Set.size (groupSites group))
        / fromIntegral (1 + near group) ^ (2 :: Int)
    affordable left those = case those of
      [] -> []
      group : more
        | pace == Slow || took <= left -> group : affordable (left - took) more
        | otherwise -> affordable left more
        where
          took = groupTook group
    through tried left = case left of
      []
        | pace == Quick -> pure (Open, tried)
        | null tried -> pure (Unreached, tried)
        | otherwise -> pure (Survived, tried)
      group : more -> do
        ended <- run suite (limitsOf group) variables (groupPath group)
        case ended of
          _
            | runTimedOut ended -> pure (TimedOut (groupPath group), [])
            | runPassed ended -> through (groupKey group : tried) more
            | otherwise -> pure (Killed (fromMaybe (groupPath group) (runFailed ended)), [])
    limitsOf group =
      Limits (10 + ceiling (4 * groupTook group)) (60 + ceiling (8 * groupWaited group))

-- | How far it is, on the standard error: a line that is written over, on a terminal.
progress :: UTCTime -> Int -> Int -> Int -> [Result] -> IO ()
progress begun whole left ended results = do
  now <- getCurrentTime
  terminal <- hIsTerminalDevice stderr
  let rate = realToFrac (diffUTCTime now begun) / fromIntegral ended :: Double
      minutes = ceiling (rate * fromIntegral (left - ended) / 60) :: Int
      at = whole - left + ended
      bar = take 30 (replicate (30 * at `div` max 1 whole) '#' ++ repeat '.')
      noticed = length (filter (noticedBy . resultOutcome) results)
  hPrintf
    stderr
    "%s[%s] %d of %d, %d noticed, %d min left%s"
    (if terminal then "\r\ESC[K" else "")
    bar
    at
    whole
    noticed
    minutes
    (if terminal then "" else "\n")
  hFlush stderr
