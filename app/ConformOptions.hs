-- | The options of @pra-tactile conform@, and the settings that follow from them.
module ConformOptions
  ( Options (..),
    timeLimit,
    wholeLimit,
    parallelism,
    conformOptions,
    settingsOf,
  )
where

import Control.Monad (unless, when)
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (isSpace)
import Data.Foldable (for_)
import Data.List (dropWhileEnd)
import Data.Maybe (fromMaybe, isJust)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.Encoding.Error as Text
import ExitStatus
import Files (readBytesUpTo)
import Options
import PraTactile.Conformance.Law
import PraTactile.Conformance.Process (Mode (..), checkTexts)
import PraTactile.Conformance.Run
import PraTactile.Conformance.Run.Pattern
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Version
import PraTactile.PlainText (lineFeeds, withoutMark)
import Visible

-- | The options as they are given.
data Options = Options
  { mode :: Mode,
    stages :: [Stage],
    runPatterns :: [String],
    skipPatterns :: [String],
    skipMustFail :: Bool,
    knownFailures :: Maybe FilePath,
    profileFiles :: [FilePath],
    seedGiven :: Maybe Int,
    casesGiven :: Maybe Int,
    timeGiven :: Maybe Double,
    limitGiven :: Maybe Double,
    failFast :: Bool,
    parallelGiven :: Maybe Int,
    tokenGiven :: Maybe Token,
    listed :: Bool,
    form :: AnswerForm,
    junit :: Maybe FilePath,
    badge :: Maybe FilePath,
    -- | The program and its arguments.
    commandGiven :: [String]
  }

conformOptions :: Parser Options
conformOptions =
  Options
    <$> flag InSession OneShot (long "one-shot" <> help "Start a new process for each request")
    <*> (concat <$> many (choosing "stage" stagesNamed "stage" "NAME" stageHelp mempty))
    <*> many (patternOption "run" runHelp)
    <*> many (patternOption "skip" "Leave out the laws whose id matches; may be repeated")
    <*> switch (long "skip-must-fail" <> help "Try the skipped laws all the same; they must fail")
    <*> optionalFile "known-failures" "FILE" knownHelp
    <*> many (fileOption "profile" "FILE" profileHelp)
    <*> usually usualSeed intReader "seed" "N" "Seed of all random draws"
    <*> usually usualCases intReader "cases" "N" "Cases for each law that does not try all of them"
    <*> usually usualTimeout decimalReader "timeout" "SECONDS" "Time limit for each reply"
    <*> usually usualLimit decimalReader "limit" "SECONDS" "Time limit for the whole run"
    <*> switch
      ( long "fail-fast"
          <> help
            "End at the first law that fails or errs; first a few cases of each law are tried \
            \under all profiles"
      )
    <*> usually usualParallel intReader "parallel" "N" "Number of processes of COMMAND at once"
    <*> optional
      (valued tokenReader "replay" "TOKEN" "Try the case of this token of a report again")
    <*> switch (long "list" <> help "List the laws, and run nothing")
    <*> jsonSwitch "Print the report as JSON"
    <*> optionalFile "junit" "FILE" "Also write the report to this file, as XML of JUnit"
    <*> optionalFile
      "badge"
      "FILE"
      "Also write a badge's text to this file, as badge services read it"
    <*> many
      ( strArgument
          ( metavar "COMMAND ARGS..." <> action "command"
              <> help "The program to test, and its arguments, after --"
          )
      )
    <**> infoOption ("suite " ++ suiteVersion) (long "version" <> help "Show the suite's version")
  where
    stagesNamed =
      [(name, [stage]) | (name, stage) <- allNamed stageName]
        ++ [(name, own) | (name, own@(_ : _ : _)) <- stagesApart]
    stageHelp =
      "Try only the laws of this stage; may be repeated (default: all stages of the code). touch \
      \is register, stitch, segment and network"
    runHelp = "Try only the laws whose id matches, as in 'field/*' or commutes; may be repeated"
    knownHelp =
      "A file of laws that are known to fail: an id or a pattern on each line, # before a comment"
    profileHelp =
      "A profile as 'pra-tactile profile' prints it, in place of the suite's profiles; may be \
      \repeated"
    patternOption name text = strOption (long name <> metavar "PATTERN" <> help text)
    tokenReader = eitherReader $ \text ->
      maybe (Left (visible (take 40 text) ++ " is no token of a report")) Right (readToken text)

usualSeed, usualCases, usualParallel :: Int
usualSeed = 1
usualCases = 100
usualParallel = 1

usualTimeout, usualLimit :: Double
usualTimeout = 5
usualLimit = 300

-- | The seed of all random draws.
seed :: Options -> Int
seed = fromMaybe usualSeed . seedGiven

-- | The number of cases for each law that does not try all of them.
cases :: Options -> Int
cases = fromMaybe usualCases . casesGiven

-- | The time limit for each reply, in seconds.
timeLimit :: Options -> Double
timeLimit = fromMaybe usualTimeout . timeGiven

-- | The time limit for the whole run, in seconds.
wholeLimit :: Options -> Double
wholeLimit = fromMaybe usualLimit . limitGiven

-- | The number of processes at once.
parallelism :: Options -> Int
parallelism = fromMaybe usualParallel . parallelGiven

-- | Refuses options that would change nothing: beside @--list@, which tries no law, and @--replay@,
-- which tries one case.
heeded :: Options -> IO ()
heeded options = do
  when (listed options) . leaveOut "--list tries no law" $
    ("--replay", isJust (tokenGiven options)) :
    ("--one-shot", mode options == OneShot) :
    ("--known-failures", isJust (knownFailures options)) :
    ("--skip-must-fail", skipMustFail options) :
    ("--junit", isJust (junit options)) :
    ("--badge", isJust (badge options)) :
    ("--timeout", isJust (timeGiven options)) :
    ("--limit", isJust (limitGiven options)) : ofMany
  when (isJust (tokenGiven options)) . leaveOut "--replay tries the case of a token alone" $
    ("--stage", not (null (stages options))) :
    ("--run", not (null (runPatterns options))) :
    ("--skip", not (null (skipPatterns options))) :
    ("--known-failures", isJust (knownFailures options)) : ofMany
  where
    ofMany =
      [ ("--seed", isJust (seedGiven options)),
        ("--cases", isJust (casesGiven options)),
        ("--fail-fast", failFast options),
        ("--parallel", isJust (parallelGiven options))
      ]

-- | Which laws are tried and how; leaves with status 2 if an option has an impossible value.
settingsOf :: Suite about -> Options -> IO Settings
settingsOf suite options = do
  heeded options
  for_ complaints misused
  known <- maybe (pure []) (fmap patternsIn . readBytesUpTo mebibyte) (knownFailures options)
  named "--run" (runPatterns options)
  named "--skip" (skipPatterns options)
  named "--known-failures" known
  pure
    standardSettings
      { settingSeed = seed options,
        settingCases = cases options,
        settingLimit = wholeLimit options,
        settingFailFast = failFast options,
        settingStages = stages options,
        settingRun = runPatterns options,
        settingSkip = skipPatterns options,
        settingSkipMustFail = skipMustFail options,
        settingKnown = known
      }
  where
    tried = if null (stages options) then codeStages else [minBound ..]
    ids = idsOf tried suite ++ map fst checkTexts
    named name patterns =
      for_ patterns $ \one ->
        unless (any (matches one) ids) . misused $
          name ++ ": "
            ++ case [set | (set, own) <- stagesApart, any (matches one) (idsOf own suite)] of
              set : _ -> quoted one ++ " is a law of " ++ set ++ "; it needs --stage " ++ set
              [] -> "no law is called " ++ quoted one ++ "; 'pra-tactile conform --list' has all"
    mebibyte = 1024 * 1024
    complaints =
      take 1 . concat $
        [ ["--cases must be a number, 1 or more" | cases options < 1],
          ["--parallel must be a number from 1 to 64" | parallelism options `notElem` [1 .. 64]],
          ["--timeout must be a number of seconds above 0" | timeLimit options <= 0],
          ["--limit must be a number of seconds above 0" | wholeLimit options <= 0],
          ["--skip-must-fail needs --skip" | skipMustFail options && null (skipPatterns options)]
        ]

-- | The patterns in a file, without its comments.
patternsIn :: Bytes.ByteString -> [String]
patternsIn =
  filter (not . null) . map (trimmed . takeWhile (/= '#')) . lines . Text.unpack
    . Text.decodeUtf8With Text.lenientDecode
    . lineFeeds
    . withoutMark
  where
    trimmed = dropWhileEnd isSpace . dropWhile isSpace
