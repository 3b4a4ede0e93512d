-- | Hunts mutants: @hunt SPEC PROGRAM-FOLDER HOME MUTANTS RESULTS STATE [OPTIONS]@ ("Choice" has
-- the options). Each mutant is on while the groups of examples run in which it would have had
-- another value, the nearest group first, up to the first that fails. A line of JSON each is
-- appended to @RESULTS@. What stands there already is used where the mutant's file is the same:
-- what noticed it, if that example still is in the suite; else the groups that did not notice it,
-- which do not run again. Mutants that change nothing that could be observed, by
-- @tools/mutate/equivalent.txt@ in HOME, are not run. At the end the table by module is printed
-- ("Table").
module Main (main) where

import Choice
import Control.Concurrent
import Control.Monad (forM, forM_, unless, void)
import Data.Aeson (decodeStrict, encode)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Char (isAlpha, isLower, isSpace, toLower)
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
import Workers

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
-- these did not notice, for the seconds that each may take.
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
  suites <- forM [1 .. choiceJobs choice] $ \worker -> do
    let scratch = folder </> ("scratch-" ++ show worker)
    suite scratch <$ createDirectoryIfMissing True scratch
  paths <- concatMap pathsIn <$> headings (suite (folder </> "scratch-1"))
  earlier <- readResults resultsFile
  let examples = Names.fromList paths
      now = digestOf paths
      holds r = unchanged r && all (`Names.member` examples) (noticedIn (resultOutcome r))
      -- With other examples the seconds begin anew.
      anew r = if resultSuite r == now then r else r {resultSpent = 0}
  done <- newMVar (latest (map anew (filter holds earlier)))
  let stages = Quick : [Slow | not (choiceQuick choice)]
  forM_ stages $ \pace -> do
    let sites = Map.elems (Map.fromList [(siteNumber s, s) | s <- map mutantSite mutants])
        budget = case pace of
          Quick -> quickly
          Slow -> choiceSeconds choice
    groups <-
      measured
        suites
        state
        sites
        (choiceSeconds choice)
        pace
        (folder </> "groups.jsonl")
    known <- readMVar done
    -- First those of the modules that are tried as a whole, and last those that were tried before.
    let order m = (mutantDrawn m, Map.member (mutantName m) known)
        tries one near before m =
          (\r -> r {resultSuite = now}) <$> tryMutant pace budget groups one near before m
        left = sortOn order (filter (stillOpen pace budget groups known) ours)
    unless (null left) $
      stage suites tries (length ours) left earlier done resultsFile
  known <- readMVar done
  putStr (tables same ours known)
  where
    folder = takeDirectory resultsFile
    latest results = Map.fromList [(resultName r, r) | r <- results]
    stillOpen pace budget groups known m = case Map.lookup (mutantName m) known of
      Nothing -> True
      Just r
        | noticedBy (resultOutcome r) -> False
        | null left -> pace == Slow && resultOutcome r == Open
        | otherwise -> any ((<= budget - resultSpent r) . groupTook) left
        where
          left = untried groups m (resultTried r)

-- | All of these mutants, each by one of the suites that run side by side.
stage ::
  [Suite] ->
  (Suite -> (Group -> Int) -> Maybe Result -> Mutant -> IO Result) ->
  Int ->
  [Mutant] ->
  [Result] ->
  MVar (Map.Map String Result) ->
  FilePath ->
  IO ()
stage suites tries whole left earlier done resultsFile = do
  begun <- getCurrentTime
  count <- newMVar (0 :: Int)
  void . flip (sideBySide suites) left $ \suite mutant -> do
    known <- readMVar done
    let before = Map.lookup (mutantName mutant) known
        near = nearness (Map.elems known ++ earlier) mutant
    result <- tries suite near before mutant
    modifyMVar_ done $ \results -> do
      Lazy.appendFile resultsFile (encode result <> Lazy.pack "\n")
      let now = Map.insert (mutantName mutant) result results
      number <- modifyMVar count (\n -> pure (n + 1, n + 1))
      progress begun whole (length left) number (Map.elems now)
      pure now

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

-- | The groups in which a mutant would have another value, and that have not been tried, by their
-- keys.
untried :: [Group] -> Mutant -> [String] -> [Group]
untried groups mutant before =
  [g | g <- groups, feels g mutant, groupKey g `notElem` before]

-- | How near a group is to a mutant: how often it noticed others of the same file, and how many
-- words its headings share with the module's name, which count twice.
nearness :: [Result] -> Mutant -> Group -> Int
nearness results mutant = \group ->
  length (filter (groupPath group `isPrefixOf`) examples)
    + 2 * length (filter (`Names.member` Names.fromList (stems (groupPath group))) named)
  where
    named = stems (drop (length "PraTactile.") (siteModule (mutantSite mutant)))
    examples =
      [ example
        | r <- results,
          siteFile (resultSite r) == siteFile (mutantSite mutant),
          example <- noticedIn (resultOutcome r)
      ]

-- | How the words of a text begin, where one in small letters is followed by a capital as where no
-- letter stands between: what a module's name and a heading can share.
stems :: String -> [String]
stems text =
  Names.toList (Names.fromList [map toLower (take 5 word) | word <- apart text, length word >= 4])
  where
    apart letters = case dropWhile (not . isAlpha) letters of
      [] -> []
      first : more ->
        let (rest, after) = span (\letter -> isAlpha letter && isLower letter) more
         in (first : rest) : apart after

-- | Run the tests in which a mutant would have another value, as long as they take no more than
-- this many seconds, but for those that were tried before. The nearest come first: those that are
-- quick, come to few other sites, noticed other mutants of the file, and are named like its module.
tryMutant ::
  Pace -> Double -> [Group] -> Suite -> (Group -> Int) -> Maybe Result -> Mutant -> IO Result
tryMutant pace budget groups suite near known mutant = do
  begun <- getCurrentTime
  (outcome, tried, spent) <- through before already (affordable (budget - already) left)
  now <- getCurrentTime
  pure
    Result
      { resultMutant = mutant,
        resultOutcome = outcome,
        resultTried = tried,
        resultSpent = spent,
        resultSuite = "",
        resultTook = realToFrac (diffUTCTime now begun)
      }
  where
    site = mutantSite mutant
    variables =
      [("PRA_TACTILE_MUTANT", show (siteNumber site) ++ "." ++ show (mutantVariant mutant))]
    before = maybe [] resultTried known
    already = maybe 0 resultSpent known
    left = sortOn distance (untried groups mutant before)
    distance group =
      (0.1 + groupTook group) * fromIntegral (Set.size (groupMarks group))
        / fromIntegral (1 + near group) ^ (2 :: Int)
    affordable seconds those = case those of
      [] -> []
      group : more
        | groupTook group <= seconds -> group : affordable (seconds - groupTook group) more
        | otherwise -> affordable seconds more
    through tried spent those = case those of
      []
        | pace == Quick || any ((`notElem` tried) . groupKey) left -> pure (Open, tried, spent)
        | not (any (`comesTo` site) groups) -> pure (Unreached, tried, spent)
        | null tried -> pure (Unfelt, tried, spent)
        | otherwise -> pure (Survived, tried, spent)
      group : more -> do
        ended <- run suite (limitsOf group) variables (groupPath group)
        case ended of
          _
            | runTimedOut ended -> pure (TimedOut (groupPath group), [], spent)
            | runPassed ended ->
              through (groupKey group : tried) (spent + groupTook group) more
            | otherwise ->
              pure (Killed (fromMaybe (groupPath group) (runFailed ended)), [], spent)
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
