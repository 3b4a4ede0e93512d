-- | Hunts mutants: @hunt SPEC PROGRAM-FOLDER HOME MUTANTS RESULTS STATE [OPTIONS]@ ("Choice" has
-- the options). Each mutant is on while the groups of examples run that come to its site, the
-- quickest group first, up to the first that fails. A line of JSON each is appended to @RESULTS@.
-- What stands there already is not run again if it was found in this @STATE@ of the sources, or if
-- the mutant's file is the same and what noticed it still is in the suite. Mutants that change
-- nothing that could be observed, by @tools/mutate/equivalent.txt@ in HOME, are not run. At the end
-- the table by module is printed.
module Main (main) where

import Choice
import Control.Concurrent
import Control.Monad (forM, forM_)
import Data.Aeson (decodeStrict, encode)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Char (isSpace)
import qualified Data.IntSet as Set
import Data.List (partition, sortOn)
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
        hunt choice suite home mutants results state
    _ -> do
      hPutStrLn
        stderr
        ("usage: hunt SPEC PROGRAM-FOLDER HOME MUTANTS RESULTS STATE " ++ usage)
      exitWith (ExitFailure 2)

hunt :: Choice -> (FilePath -> Suite) -> FilePath -> FilePath -> FilePath -> String -> IO ()
hunt choice suite home mutantsFile resultsFile state = do
  mutants <- readMutants mutantsFile
  let folder = takeDirectory resultsFile
      (shard, shards) = choiceShard choice
  equivalent <- readEquivalent (home </> "tools" </> "mutate" </> "equivalent.txt")
  let (same, ours) =
        partition
          ((`Map.member` equivalent) . mutantName)
          [m | (i, m) <- zip [0 ..] mutants, i `mod` shards == shard - 1]
      bySource = Map.fromList [(mutantName m, siteSource (mutantSite m)) | m <- ours]
  createDirectoryIfMissing True (folder </> "scratch")
  examples <- Names.fromList <$> examplesOf (suite (folder </> "scratch"))
  groups <- measured (suite (folder </> "scratch")) (folder </> "groups.jsonl")
  let holds r =
        Map.lookup (resultName r) bySource == Just (siteSource (resultSite r))
          && (resultState r == state || any (`Names.member` examples) (noticedIn (resultOutcome r)))
  known <-
    Map.elems . Map.fromList . map (\r -> (resultName r, r)) . filter holds
      <$> readResults resultsFile
  let left = [m | m <- ours, mutantName m `Names.notMember` Names.fromList (map resultName known)]
  begun <- getCurrentTime
  -- Those that quick groups do not notice wait until all others have been tried.
  queue <- newMVar [(mutant, Quick) | mutant <- left]
  done <- newMVar known
  ended <- forM [1 .. choiceJobs choice] $ \worker -> do
    end <- newEmptyMVar
    let scratch = folder </> ("scratch-" ++ show worker)
        work = do
          next <- modifyMVar queue $ \waiting -> pure $ case waiting of
            [] -> ([], Nothing)
            one : more -> (more, Just one)
          forM_ next $ \(mutant, pace) -> do
            tried <- try' (suite scratch) state pace groups mutant
            case tried of
              Nothing -> do
                hPutStrLn stderr ("not noticed by quick tests: " ++ mutantName mutant)
                modifyMVar_ queue (\waiting -> pure (waiting ++ [(mutant, Slow)]))
              Just result -> modifyMVar_ done $ \results -> do
                Lazy.appendFile resultsFile (encode result <> Lazy.pack "\n")
                progress begun (length ours) (length left) (result : results)
                pure (result : results)
            work
    createDirectoryIfMissing True scratch
    end <$ forkFinally work (const (putMVar end ()))
  mapM_ takeMVar ended
  readMVar done >>= putStr . table same

-- | The names of mutants in a file, each on a line of its own; the reason follows, indented.
readEquivalent :: FilePath -> IO (Map.Map String String)
readEquivalent file = do
  there <- doesFileExist file
  text <- if there then readFile file else pure ""
  pure (Map.fromList (entries (filter (not . all isSpace) (lines text))))
  where
    entries rows = case rows of
      [] -> []
      name : more ->
        let (reason, others) = span ((== " ") . take 1) more
         in (name, unwords (concatMap words reason)) : entries others

readResults :: FilePath -> IO [Result]
readResults file = do
  there <- doesFileExist file
  if there then mapMaybe decodeStrict . Bytes.lines <$> Bytes.readFile file else pure []

-- | Which groups run: those that take at most 'quickly' in all, from the quickest on; or the
-- others.
data Pace = Quick | Slow

-- | Seconds.
quickly :: Double
quickly = 20

-- | Run the tests that come to a mutant's site, or 'Nothing' if slow ones are left.
try' :: Suite -> String -> Pace -> [Group] -> Mutant -> IO (Maybe Result)
try' suite state pace groups mutant = do
  begun <- getCurrentTime
  outcome <- case pace of
    Quick -> go (map fst quick)
    Slow -> go (map fst slow)
  now <- getCurrentTime
  pure $ case (pace, outcome) of
    (Quick, Survived) | not (null slow) -> Nothing
    _ ->
      Just
        Result
          { resultMutant = mutant,
            resultState = state,
            resultOutcome = outcome,
            resultTook = realToFrac (diffUTCTime now begun)
          }
  where
    site = mutantSite mutant
    variables =
      [("PRA_TACTILE_MUTANT", show (siteNumber site) ++ "." ++ show (mutantVariant mutant))]
    reached = sortOn groupTook [g | g <- groups, Set.member (siteNumber site) (groupSites g)]
    (quick, slow) =
      span ((<= quickly) . snd) (zip reached (drop 1 (scanl (+) 0 (map groupTook reached))))
    go of' = if null reached then pure Unreached else through of'
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

-- | How many were noticed of each part of the library and of each module, as a table of Markdown,
-- beside those that change nothing; then those that were not noticed.
table :: [Mutant] -> [Result] -> String
table same results =
  unlines $
    [ "| part or module | mutants | change nothing | noticed | by the time | % of the others |",
      "|---|--:|--:|--:|--:|--:|"
    ]
      ++ map row (Map.toList (Map.unionWith (<>) ran equal))
      ++ ["", "Not noticed:"]
      ++ [ printf "%s:%d:%d: %s" (siteFile site) (siteLine site) (siteColumn site) (resultName r)
             ++ unreached r
           | r <- sortOn (\r -> (siteFile (resultSite r), siteLine (resultSite r))) results,
             not (noticedBy (resultOutcome r)),
             let site = resultSite r
         ]
  where
    ran = Map.fromListWith (<>) [(key, ([r], [])) | r <- results, key <- keys (resultSite r)]
    equal = Map.fromListWith (<>) [(key, ([], [m])) | m <- same, key <- keys (mutantSite m)]
    keys site = ["all", part (siteFile site), part (siteFile site) ++ " " ++ siteModule site]
    part = takeWhile (/= '/') . drop 4
    unreached r = if resultOutcome r == Unreached then " (no test comes to it)" else ""
    row :: (String, ([Result], [Mutant])) -> String
    row (key, (those, without)) =
      let noticed = length (filter (noticedBy . resultOutcome) those)
          late = length [() | r <- those, TimedOut _ <- [resultOutcome r]]
       in printf
            "| %s | %d | %d | %d | %d | %.1f |"
            key
            (length those + length without)
            (length without)
            noticed
            late
            (100 * fromIntegral noticed / fromIntegral (max 1 (length those)) :: Double)
