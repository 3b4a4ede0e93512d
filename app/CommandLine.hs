-- | The command line: one parser a command, each in its own module.
module CommandLine
  ( main
  , commandLine
  ) where

import qualified Command.Advise
import qualified Command.Array
import qualified Command.Census
import qualified Command.Certificate
import qualified Command.Check
import qualified Command.Compare
import qualified Command.Decode
import qualified Command.Evaluate
import qualified Command.Field
import qualified Command.Locate
import qualified Command.Merge
import qualified Command.Objects
import qualified Command.Polynomials
import qualified Command.Probe
import qualified Command.Profile
import qualified Command.Prove
import qualified Command.Rates
import qualified Command.Sequence
import qualified Command.Shapes
import qualified Command.Stitch
import qualified Command.Synthesise
import qualified Command.Table
import qualified Command.Train
import Data.Version (showVersion)
import Options.Applicative
import System.Environment (getArgs, getProgName)
import System.Exit (ExitCode (..))
import System.IO (hPutStrLn, hSetEncoding, stderr, stdout, utf8)

import Ending
import Paths_pra_tactile (version)

main :: IO ()
main = do
  hSetEncoding stdout utf8
  hSetEncoding stderr utf8
  arguments <- getArgs
  case execParserPure (prefs showHelpOnEmpty) commandLine arguments of
    Success run -> run >>= finish
    Failure failure -> do
      name <- getProgName
      case renderFailure failure name of
        (text, ExitSuccess) -> putStrLn text >> finish Answered
        (text, ExitFailure _) -> hPutStrLn stderr text >> finish Unusable
    CompletionInvoked completion -> getProgName >>= execCompletion completion >>= putStr >> finish Answered

commandLine :: ParserInfo (IO Ending)
commandLine = info (commands <**> helper <**> versionOption) $
  fullDesc
    <> header "pra-tactile - recognise objects by touch from the pseudorandom array embossed on their faces"
    <> footer "Exit status: 0 answered; 1 well formed, but refused, ambiguous or refuted; 2 bad usage or bad input."

versionOption :: Parser (a -> a)
versionOption = infoOption ("pra-tactile " ++ showVersion version) (long "version" <> help "Show the version")

commands :: Parser (IO Ending)
commands = subparser (commandGroup "The code:" <> metavar "COMMAND" <> mconcat
    [ Command.Array.command, Command.Prove.command, Command.Certificate.command, Command.Check.command
    , Command.Locate.command, Command.Rates.command, Command.Table.command, Command.Profile.command
    , Command.Sequence.command, Command.Synthesise.command, Command.Advise.command
    , Command.Field.command, Command.Polynomials.command, Command.Census.command, Command.Merge.command ])
  <|> subparser (commandGroup "Touch:" <> hidden <> mconcat
    [ Command.Probe.command, Command.Stitch.command, Command.Decode.command, Command.Compare.command, Command.Evaluate.command ])
  <|> subparser (commandGroup "Objects and symbols:" <> hidden <> mconcat
    [ Command.Objects.command, Command.Shapes.command, Command.Train.command ])
