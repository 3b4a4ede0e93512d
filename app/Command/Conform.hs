-- | @pra-tactile conform@: is an implementation right, in whatever language?
module Command.Conform
  ( command,
  )
where

import ConformList
import ConformOptions
import Control.Monad (join)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isAlphaNum)
import Data.Foldable (for_)
import Data.IORef
import Data.List (isPrefixOf)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import ExitStatus
import FormatFile (readProfile)
import GHC.Clock (getMonotonicTime)
import Interrupt
import Message (formatMessage)
import Options
import Output
import PraTactile.Conformance.Definition (ProfileFacts)
import PraTactile.Conformance.Process
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Report
import PraTactile.Conformance.Report.Badge
import PraTactile.Conformance.Report.Json
import PraTactile.Conformance.Report.Junit
import PraTactile.Conformance.Report.Words
import PraTactile.Conformance.Run
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Suite
import PraTactile.Profile (Profile)
import Progress
import System.FilePath (takeBaseName)
import Visible

command :: Subcommand
command =
  subcommand
    "conform"
    "Test an implementation in any language by laws"
    "Test an implementation in any language against the laws. COMMAND is started and asked over \
    \JSON lines; the smallest case in which it is wrong is reported. docs/reference/protocol.md \
    \has the protocol. Exit status 0: certified, or all chosen laws held; 1: a law failed, or \
    \COMMAND erred, hung or crashed; 2: COMMAND cannot be started or never answers."
    []
    [ "pra-tactile conform --stage field -- pra-tactile serve",
      "pra-tactile conform --run 'array/*' --cases 20 --json -- pra-tactile serve",
      "pra-tactile conform --stage touch --cases 5 -- pra-tactile serve",
      "pra-tactile conform --list"
    ]
    (run <$> conformOptions)

run :: Options -> IO ExitStatus
run options = do
  profiles <- chosenProfiles (profileFiles options)
  suite <- orUnusable noSuiteText (standardSuite profiles)
  settings <- settingsOf suite options
  case (listed options, commandGiven options) of
    (True, []) ->
      Answered <$ printAs (form options) (listText settings suite) (listJson settings suite)
    (True, _) -> misused "--list runs no command; leave the command out"
    (False, []) -> misused "name the command to test, as in: conform -- ./decoder"
    (False, program : arguments) -> do
      for_ (junit options) orUnwritable
      for_ (badge options) orUnwritable
      report <- endingInOrder (conformed options settings suite (Command program arguments))
      told options report

-- | The profiles of the files, or the default ones.
chosenProfiles :: [FilePath] -> IO [(String, Profile)]
chosenProfiles files = case files of
  [] -> pure defaultProfiles
  _ -> traverse (\file -> (,) (name file) <$> readProfile file) files
  where
    -- A file descriptor has no name of its own.
    name file
      | "/dev/" `isPrefixOf` file = "profile"
      | otherwise = visibleName (takeBaseName file)

-- | Run the suite, or the case of a token, on the chosen number of processes.
conformed :: Options -> Settings -> Suite ProfileFacts -> Command -> IO Report
conformed options settings suite subject = do
  end <- (+ wholeLimit options) <$> getMonotonicTime
  let timeLeft = subtract <$> getMonotonicTime <*> pure end
      nested :: Int -> [Subject] -> IO (Either Fault Report)
      nested 0 started = do
        left <- timeLeft
        Right <$> tried settings {settingLimit = left} started
      nested more started = do
        left <- timeLeft
        join
          <$> withProcess
            (mode options)
            (Limits (timeLimit options) left)
            subject
            (\one -> nested (more - 1) (one : started))
  nested (parallelism options) [] >>= either (unusable . notStarted subject) pure
  where
    tried chosen started = case (tokenGiven options, started) of
      (Just token, one : _) -> replayed chosen suite token one
      _ -> whole chosen suite started

-- | The complaint about a subject that does not start.
notStarted :: Command -> Fault -> String
notStarted subject fault = case faultKind fault of
  CannotStart -> "cannot start " ++ name ++ ": " ++ faultDetail fault
  TooSlow -> name ++ " was still asked what it offers when the time of --limit was over"
  kind ->
    name ++ " never answered start: " ++ faultName kind ++ ", " ++ faultDetail fault
      ++ concat
        [ "; does it flush its standard output after each line?"
          | kind `elem` [TimedOut, NeverStarted, HalfLine]
        ]
  where
    name = visibleName (commandProgram subject)

-- | Try all chosen laws.
whole :: Settings -> Suite ProfileFacts -> [Subject] -> IO Report
whole settings suite started =
  withProgress (unevenly total "cases") $ \bar -> do
    done <- newIORef 0
    let counting _ = atomicModifyIORef' done (\n -> (n + 1, n + 1)) >>= tell bar
    runSuite settings suite counting started
  where
    total = sum (map (countWork settings suite) (take 1 started))

-- | Try the case of a token.
replayed :: Settings -> Suite ProfileFacts -> Token -> Subject -> IO Report
replayed settings suite token subject = do
  outcome <- replay settings suite token subject
  case outcome of
    Nothing -> misused ("--replay: there is no law " ++ visible (tokenLaw token))
    Just (Left why) -> unusable (formatMessage "the token's case" "a case of its law" why)
    Just (Right report) -> pure report

-- | Print the report; the status says whether the subject is certified.
told :: Options -> Report -> IO ExitStatus
told options report = do
  printAs (form options) (concatMap shown (lines (reportText again report))) (encodeReport report)
  for_ (junit options) $ \file ->
    writeWhole file (utf8 (junitText (failureText again) report))
  for_ (badge options) $ \file ->
    writeWhole file (Lazy.snoc (Lazy.fromStrict (encodeBadge report)) 10)
  pure (if certified report || reportPartial report && sound report then Answered else NotAnswered)
  where
    again token =
      unwords $
        ["pra-tactile conform --replay", token]
          ++ ["--one-shot" | mode options == OneShot]
          ++ ("--" : map shellWord (commandGiven options))
    shellWord text
      | not (null text) && all (\c -> isAlphaNum c || c `elem` "-_./:=+,@%") text = text
      | otherwise = "'" ++ concatMap (\c -> if c == '\'' then "'\\''" else [c]) text ++ "'"
    utf8 = Lazy.fromStrict . Text.encodeUtf8 . Text.pack
    shown text = visible text ++ "\n"
