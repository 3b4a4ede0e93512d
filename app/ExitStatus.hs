-- | How a command ends: the exit statuses, on which scripts rely, and the form of complaints.
module ExitStatus
  ( -- * Exit statuses
    ExitStatus (..),
    leave,

    -- * Bad usage and bad input
    misused,
    leaveOut,
    namingHelp,
    helpNamed,
    unusable,
    orUnusable,
    warn,
    systemReason,

    -- * Running a program
    runToExit,
  )
where

import Control.Exception
import Control.Monad (void)
import Data.Char (isAlphaNum, toLower)
import Data.List (stripPrefix)
import GHC.IO.Exception (IOException (..))
import System.Environment (getArgs, getProgName)
import System.Exit (ExitCode (..), exitWith)
import System.IO (hFlush, hPutStrLn, stderr, stdout)
import Visible

-- | The exit status.
data ExitStatus
  = -- | 0
    Answered
  | -- | 1: well formed, but refused, ambiguous or refuted
    NotAnswered
  | -- | 2: bad usage or bad input
    Unusable
  deriving stock (Eq, Ord, Show)

-- | Leave with a status.
leave :: ExitStatus -> IO a
leave status = exitWith $ case status of
  Answered -> ExitSuccess
  NotAnswered -> ExitFailure 1
  Unusable -> ExitFailure 2

-- | A complaint about arguments, each of which could be read.
newtype Misused = Misused String
  deriving stock (Show)

instance Exception Misused

-- | Refuse given options, by their names, that would change nothing; the text says why. No option
-- is silently ignored.
leaveOut :: String -> [(String, Bool)] -> IO ()
leaveOut why options = case [name | (name, True) <- options] of
  [] -> pure ()
  given -> misused (why ++ "; leave out " ++ enumerated given)
  where
    enumerated names = case names of
      [one, other] -> one ++ " and " ++ other
      one : others@(_ : _) -> one ++ ", " ++ enumerated others
      _ -> concat names

-- | Say what is wrong with the arguments of a command, and where to read what is right; leaves with
-- status 2. 'helpNamed' knows the command.
misused :: String -> IO a
misused = throwIO . Misused

-- | A command by its name, in which arguments may be 'misused'; given which of its options have an
-- older name. A complaint names an option as it was given.
helpNamed :: String -> [(String, String)] -> IO a -> IO a
helpNamed name older run =
  run `catch` \(Misused complaint) -> do
    program <- getProgName
    arguments <- getArgs
    unusable (namingHelp [program, name] (inNamesGiven older arguments complaint))

-- | A complaint in which an option has its older name, if that is among the arguments.
inNamesGiven :: [(String, String)] -> [String] -> String -> String
inNamesGiven older arguments complaint = foldl renamed complaint given
  where
    given = [names | names@(_, old) <- older, any ((== old) . takeWhile (/= '=')) arguments]
    renamed text names@(new, old) = case text of
      [] -> []
      c : others -> case stripPrefix new text of
        Just rest | not (any continues (take 1 rest)) -> old ++ renamed rest names
        _ -> c : renamed others names
    continues c = isAlphaNum c || c == '-'

-- | What is wrong with arguments, with the words of the command whose help says what is right.
namingHelp :: [String] -> String -> String
namingHelp asked complaint = complaint ++ "; try '" ++ unwords asked ++ " --help'"

-- | Say on the standard error what is wrong and what to do, and leave with status 2.
unusable :: String -> IO a
unusable message = warn message >> leave Unusable

-- | The value, or 'unusable' with the error in words.
orUnusable :: (e -> String) -> Either e a -> IO a
orUnusable inWords = either (unusable . inWords) pure

-- | A line on the standard error, after everything on the standard output, without the passwords of
-- the command line. A failure to write it is ignored.
warn :: String -> IO ()
warn message = do
  arguments <- getArgs
  whatever (hFlush stdout)
  whatever . hPutStrLn stderr . visibleLine $
    "pra-tactile: " ++ withoutPasswords arguments message
  where
    whatever action = void (try action :: IO (Either IOException ()))

-- | What the system says of an error, without the names of the library's functions.
systemReason :: IOException -> String
systemReason problem = case ioe_description problem of
  [] -> show (ioe_type problem)
  first : others -> toLower first : others

-- | Run a command to its end and leave with its status; with status 2 and a line if its output
-- cannot be written, or an unexpected exception occurs.
runToExit :: IO ExitStatus -> IO a
runToExit command =
  (command <* hFlush stdout >>= leave) `catch` \problem -> case fromException problem of
    Just code -> hFlush stdout `catch` outputLost >> throwIO (code :: ExitCode)
    Nothing
      | Just asynchronous <- fromException problem -> throwIO (asynchronous :: SomeAsyncException)
      | Just io <- fromException problem, ioe_handle io == Just stdout -> outputLost io
      | Just io <- fromException problem ->
        unusable ("cannot go on: " ++ systemReason io ++ maybe "" (": " ++) (ioe_filename io))
      | otherwise ->
        unusable ("this should not have happened, please report it: " ++ displayException problem)
  where
    outputLost io = unusable ("cannot write the standard output: " ++ systemReason io)
