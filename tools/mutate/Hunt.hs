-- | Hunts mutants: @hunt SPEC PROGRAM-FOLDER HOME MUTANTS RESULTS STATE [OPTIONS]@ ("Choice" has
-- the options). Each mutant is on while the groups of examples run that come to its site, the
-- quickest group first, up to the first that fails. A line of JSON each is appended to @RESULTS@.
-- What stands there already is not run again if it was found in this @STATE@ of the sources, or if
-- the mutant's file is the same and what noticed it still is in the suite. At the end the table by
-- module is printed.
module Main (main) where

import Choice
import Control.Concurrent
import Control.Monad (forM, forM_)
import Data.Aeson (decodeStrict, encode)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy
import qualified Data.IntSet as Set
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, mapMaybe)
import qualified Data.Set as Names
import Data.Time.Clock (UTCTime, diffUTCTime, getCurrentTime)
import Group
import Site
import System.Directory
import System.Environment (getArgs, getEnvironment)
import System.Exit (ExitCode (..), exitWith)
import System.FilePath (takeDirectory, (</>))
import System.IO
import Text.Printf (hPrintf, printf)

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
        hunt choice suite mutants results state
    _ -> do
      hPutStrLn
        stderr
        ("usage: hunt SPEC PROGRAM-FOLDER HOME MUTANTS RESULTS STATE " ++ usage)
      exitWith (ExitFailure 2)

hunt :: Choice -> (FilePath -> Suite) -> FilePath -> FilePath -> String -> IO ()
hunt choice suite mutantsFile resultsFile state = do
  mutants <- readMutants mutantsFile
  let folder = takeDirectory resultsFile
      (shard, shards) = choiceShard choice
      ours = [m | (i, m) <- zip [0 ..] mutants, i `mod` shards == shard - 1]
      bySource = Map.fromList [(mutantName m, siteSource (mutantSite m)) | m <- ours]
  createDirectoryIfMissing True (folder </> "scratch")
  examples <- Names.fromList <$> examplesOf (suite (folder </> "scratch"))
  groups <- measured (suite (folder </> "scratch")) (folder </> "groups.json")
  let holds r =
        Map.lookup (resultName r) bySource == Just (resultSource r)
          && (resultState r == state || any (`Names.member` examples) (noticedIn (resultOutcome r)))
  known <-
    Map.elems . Map.fromList . map (\r -> (resultName r, r)) . filter holds
      <$> readResults resultsFile
  let left = [m | m <- ours, mutantName m `Names.notMember` Names.fromList (map resultName known)]
  begun <- getCurrentTime
  queue <- newMVar left
  done <- newMVar known
  ended <- forM [1 .. choiceJobs choice] $ \worker -> do
    end <- newEmptyMVar
    let scratch = folder </> ("scratch-" ++ show worker)
        work = do
          next <- modifyMVar queue $ \waiting -> pure $ case waiting of
            [] -> ([], Nothing)
            one : more -> (more, Just one)
          forM_ next $ \mutant -> do
            result <- try' (suite scratch) state groups mutant
            modifyMVar_ done $ \results -> do
              Lazy.appendFile resultsFile (encode result <> Lazy.pack "\n")
              progress begun (length ours) (length left) (result : results)
              pure (result : results)
            work
    createDirectoryIfMissing True scratch
    end <$ forkFinally work (const (putMVar end ()))
  mapM_ takeMVar ended
  readMVar done >>= putStr . table

readResults :: FilePath -> IO [Result]
readResults file = do
  there <- doesFileExist file
  if there then mapMaybe decodeStrict . Bytes.lines <$> Bytes.readFile file else pure []

-- | Run the tests that come to a mutant's site.
try' :: Suite -> String -> [Group] -> Mutant -> IO Result
try' suite state groups mutant = do
  begun <- getCurrentTime
  outcome <- go (sortOn groupTook [g | g <- groups, Set.member (siteNumber site) (groupSites g)])
  now <- getCurrentTime
  pure
    Result
      { resultModule = siteModule site,
        resultMutant = mutantName mutant,
        resultFile = siteFile site,
        resultLine = siteLine site,
        resultKind = siteKind site,
        resultSource = siteSource site,
        resultState = state,
        resultOutcome = outcome,
        resultTook = realToFrac (diffUTCTime now begun)
      }
  where
    site = mutantSite mutant
    variables =
      [("PRA_TACTILE_MUTANT", show (siteNumber site) ++ "." ++ show (mutantVariant mutant))]
    go reached = case reached of
      [] -> pure Unreached
      _ -> through reached
    through left = case left of
      [] -> pure Survived
      group : more -> do
        ended <-
          run
            suite
            (20 + ceiling (4 * groupTook group))
            variables
            (groupPath group)
            (suiteScratch suite </> "log")
        case ended of
          _
            | runTimedOut ended -> pure (TimedOut (groupPath group))
            | runPassed ended -> through more
            | otherwise -> pure (Killed (fromMaybe (groupPath group) (runFailed ended)))

-- | How far it is, on the standard error: a line that is written over, on a terminal.
progress :: UTCTime -> Int -> Int -> [Result] -> IO ()
progress begun whole left results = do
  now <- getCurrentTime
  terminal <- hIsTerminalDevice stderr
  let ended = length results
      fresh = ended - (whole - left)
      rate = realToFrac (diffUTCTime now begun) / fromIntegral (max 1 fresh) :: Double
      minutes = ceiling (rate * fromIntegral (whole - ended) / 60) :: Int
      bar = take 30 (replicate (30 * ended `div` max 1 whole) '#' ++ repeat '.')
      noticed = length (filter (noticedBy . resultOutcome) results)
  hPrintf
    stderr
    "%s[%s] %d of %d, %d noticed, %d min left%s"
    (if terminal then "\r\ESC[K" else "")
    bar
    ended
    whole
    noticed
    minutes
    (if terminal then "" else "\n")
  hFlush stderr

noticedBy :: Outcome -> Bool
noticedBy = not . null . noticedIn

-- | The example that failed, or the group that took too long.
noticedIn :: Outcome -> [String]
noticedIn outcome = case outcome of
  Killed example -> [example]
  TimedOut group -> [group]
  Survived -> []
  Unreached -> []

-- | How many were noticed of each part of the library and of each module, as a table of Markdown;
-- then those that were not.
table :: [Result] -> String
table results =
  unlines $
    ["| part or module | mutants | noticed | of them by the time | % |", "|---|--:|--:|--:|--:|"]
      ++ map row (Map.toList (Map.fromListWith (++) (concatMap keys results)))
      ++ ["", "Not noticed:"]
      ++ [ printf "%s:%d: %s%s" (resultFile r) (resultLine r) (resultMutant r) (unreached r)
           | r <- sortOn (\r -> (resultFile r, resultLine r)) results,
             not (noticedBy (resultOutcome r))
         ]
  where
    keys r = [(part r, [r]), (part r ++ " " ++ resultModule r, [r])]
    part = takeWhile (/= '/') . drop 4 . resultFile
    unreached r = if resultOutcome r == Unreached then " (no test comes to it)" else ""
    row (key, those) =
      let noticed = length (filter (noticedBy . resultOutcome) those)
          late = length [() | r <- those, TimedOut _ <- [resultOutcome r]]
       in printf
            "| %s | %d | %d | %d | %.1f |"
            key
            (length those)
            noticed
            late
            (100 * fromIntegral noticed / fromIntegral (length those) :: Double)
