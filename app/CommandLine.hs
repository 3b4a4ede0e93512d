-- | The command line: one parser a command, each in its own module.
module CommandLine
  ( main,
    answering,
    commandLine,
    preferences,
    misunderstood,
  )
where

import qualified Command.Advise
import qualified Command.Array
import qualified Command.Calibrate
import qualified Command.Census
import qualified Command.Certificate
import qualified Command.Check
import qualified Command.Classify
import qualified Command.Compare
import qualified Command.Conform
import qualified Command.Convert
import qualified Command.Decode
import qualified Command.Draw
import qualified Command.Emboss
import qualified Command.Evaluate
import qualified Command.Experiment
import qualified Command.Field
import qualified Command.Images
import qualified Command.Locate
import qualified Command.Merge
import qualified Command.Nets
import qualified Command.Network
import qualified Command.Objects
import qualified Command.Place
import qualified Command.Polynomials
import qualified Command.Probe
import qualified Command.Profile
import qualified Command.Prove
import qualified Command.Rates
import qualified Command.Register
import qualified Command.Segment
import qualified Command.Sensor
import qualified Command.Sequence
import qualified Command.Serve
import qualified Command.Shapes
import qualified Command.Solid
import qualified Command.Stitch
import qualified Command.Synthesise
import qualified Command.Table
import qualified Command.Train
import qualified Command.Vectors
import Data.Char (isLower)
import Data.List (dropWhileEnd, isPrefixOf)
import Data.Version (showVersion)
import ExitStatus
import GHC.IO.Encoding (mkTextEncoding, setFileSystemEncoding)
import Options.Applicative
import Options.Applicative.Help (renderHelp)
import Paths_pra_tactile (version)
import PraTactile.Conformance.Version (suiteVersion)
import System.Environment (getArgs, getProgName)
import System.Exit (ExitCode (..))
import System.IO (hSetEncoding, stderr, stdout)
import System.Posix.Signals (Handler (Default), installHandler, sigPIPE)

main :: IO ()
main = do
  -- Alike under every locale: names are UTF-8, and a byte that is not comes back as it was.
  mkTextEncoding "UTF-8//ROUNDTRIP" >>= setFileSystemEncoding
  lenient <- mkTextEncoding "UTF-8//TRANSLIT"
  hSetEncoding stdout lenient
  hSetEncoding stderr lenient
  -- As cat does, end quietly where nobody reads on.
  _ <- installHandler sigPIPE Default Nothing
  runToExit (getArgs >>= answering)

-- | Do what these arguments ask for.
answering :: [String] -> IO ExitStatus
answering arguments = do
  name <- getProgName
  case execParserPure preferences commandLine arguments of
    Success run -> run
    Failure failure -> case misunderstood name failure of
      Right asked -> Answered <$ putStrLn asked
      Left complaint -> Unusable <$ warn complaint
    CompletionInvoked completion -> Answered <$ (execCompletion completion name >>= putStr)

-- | How arguments are parsed.
preferences :: ParserPrefs
preferences = defaultPrefs

-- | The help that was asked for; or 'Left' with what is wrong with the arguments and where to read
-- what is right, on one line. The name is the program's.
misunderstood :: String -> ParserFailure ParserHelp -> Either String String
misunderstood name failure = case execFailure failure name of
  (_, ExitSuccess, _) -> Right (fst (renderFailure failure name))
  (explained, ExitFailure _, _) ->
    Left (namingHelp asked (dropWhileEnd (== '.') complaint))
    where
      -- The usage begins with the words of the command.
      asked =
        takeWhile
          (\word -> all (\c -> isLower c || c == '-') word && take 1 word /= "-")
          (drop 1 (words (text mempty {helpUsage = helpUsage explained})))
      complaint
        -- What may stand for a command is a list of all of them, by no name.
        | lacksCommand = "name a command"
        | otherwise =
          text
            mempty
              { helpError = helpError explained,
                helpSuggestions = if brief then helpSuggestions explained else mempty
              }
      lacksCommand = "Missing: COMMAND" `isPrefixOf` said
      -- The words near to a longer one would be sought in a time and a memory that grow with it,
      -- for nothing.
      brief = null (drop 500 said)
      said = text mempty {helpError = helpError explained}
  where
    text = unwords . words . renderHelp 100000

commandLine :: ParserInfo (IO ExitStatus)
commandLine =
  info (commands <**> helper <**> versionOption) $
    fullDesc
      <> header
        "pra-tactile - recognise objects by touch from the pseudorandom array embossed on their \
        \faces"
      <> footer
        "Exit status: 0 answered; 1 well formed, but refused, ambiguous or refuted; 2 bad usage \
        \or bad input."

versionOption :: Parser (a -> a)
versionOption =
  infoOption
    ("pra-tactile " ++ showVersion version ++ ", suite " ++ suiteVersion)
    (long "version" <> help "Show the version")

commands :: Parser (IO ExitStatus)
commands =
  subparser
    ( commandGroup "The code:" <> metavar "COMMAND"
        <> mconcat
          [ Command.Array.command,
            Command.Prove.command,
            Command.Certificate.command,
            Command.Check.command,
            Command.Locate.command,
            Command.Rates.command,
            Command.Table.command,
            Command.Profile.command,
            Command.Sequence.command,
            Command.Synthesise.command,
            Command.Advise.command,
            Command.Field.command,
            Command.Polynomials.command,
            Command.Census.command,
            Command.Merge.command
          ]
    )
    <|> subparser
      ( commandGroup "Touch:" <> hidden
          <> mconcat
            [ Command.Probe.command,
              Command.Convert.command,
              Command.Register.command,
              Command.Stitch.command,
              Command.Segment.command,
              Command.Decode.command,
              Command.Compare.command,
              Command.Evaluate.command,
              Command.Sensor.command,
              Command.Calibrate.command
            ]
      )
    <|> subparser
      ( commandGroup "Objects and symbols:" <> hidden
          <> mconcat
            [ Command.Solid.command,
              Command.Objects.command,
              Command.Place.command,
              Command.Nets.command,
              Command.Draw.command,
              Command.Emboss.command,
              Command.Shapes.command,
              Command.Train.command,
              Command.Network.command,
              Command.Images.command,
              Command.Classify.command,
              Command.Experiment.command
            ]
      )
    <|> subparser
      ( commandGroup "Other implementations:" <> hidden
          <> mconcat [Command.Conform.command, Command.Serve.command, Command.Vectors.command]
      )
