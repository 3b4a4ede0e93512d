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
import Options
import Options.Applicative.Help
  ( Chunk,
    Doc,
    isEmpty,
    renderHelp,
    stringChunk,
    vcatChunks,
    vsepChunks,
  )
import qualified Options.Applicative.Help.Core as Help (fullDesc)
import Paths_pra_tactile (version)
import PraTactile.Conformance.Version (suiteVersion)
import System.Environment (getArgs, getProgName)
import System.Exit (ExitCode (..))
import System.IO (hSetEncoding, stderr, stdout)
import System.Posix.Signals (Handler (Default), installHandler, sigPIPE)

main :: IO ()
main = do
  -- The same under every locale: names are UTF-8, and any other byte is kept as it is.
  mkTextEncoding "UTF-8//ROUNDTRIP" >>= setFileSystemEncoding
  lenient <- mkTextEncoding "UTF-8//TRANSLIT"
  hSetEncoding stdout lenient
  hSetEncoding stderr lenient
  -- If nobody reads the output to its end, end quietly, as cat does.
  _ <- installHandler sigPIPE Default Nothing
  runToExit (getArgs >>= answering)

-- | Run the command that these arguments name.
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
preferences = helpPreferences

-- | The wanted help; or 'Left' with one line, which says what is wrong with the arguments and names
-- the help. The first argument is the program's name.
misunderstood :: String -> ParserFailure ParserHelp -> Either String String
misunderstood name failure = case execFailure failure name of
  (explained, ExitSuccess, columns)
    | isEmpty (helpBody explained) -> Right (renderHelp columns explained)
    | otherwise -> Right (renderHelp columns explained {helpBody = bodyOf (asked explained)})
  (explained, ExitFailure _, _) ->
    Left (namingHelp (asked explained) (dropWhileEnd (== '.') complaint))
    where
      complaint
        -- The library would list all commands in place of COMMAND.
        | lacksCommand = "name a command"
        | otherwise =
          text
            mempty
              { helpError = helpError explained,
                helpSuggestions = if brief then helpSuggestions explained else mempty
              }
      lacksCommand = "Missing: COMMAND" `isPrefixOf` said
      -- Suggestions for a long word would take time and memory that grow with the word.
      brief = null (drop 500 said)
      said = text mempty {helpError = helpError explained}
  where
    -- The usage begins with the words of the command.
    asked explained =
      takeWhile
        (\word -> all (\c -> isLower c || c == '-') word && take 1 word /= "-")
        (drop 1 (words (text mempty {helpUsage = helpUsage explained})))
    text = unwords . words . renderHelp 100000

commandLine :: ParserInfo (IO ExitStatus)
commandLine =
  info (subparser (metavar "COMMAND" <> ofAll) <**> general) $
    fullDesc
      <> header
        "pra-tactile - recognise objects by touch, from the pseudorandom array embossed on their \
        \faces"
      <> progDesc "Each command has its own help: pra-tactile COMMAND --help"
      <> footer
        "Exit status: 0 answered; 1 well formed, but refused, ambiguous or refuted; 2 bad usage \
        \or bad input."
  where
    ofAll = foldMap (foldMap subcommandParser . snd) commands

-- | The options that the program has without a command.
general :: Parser (a -> a)
general = (flip (.) <$> helper) <*> versionOption
  where
    versionOption =
      infoOption
        ("pra-tactile " ++ showVersion version ++ ", suite " ++ suiteVersion)
        (long "version" <> help "Show the version")

-- | All commands, under the headings that the program's help has them under.
commands :: [(String, [Subcommand])]
commands =
  [ ( "Most used",
      [Command.Decode.command, Command.Locate.command, Command.Conform.command]
    ),
    ( "The code",
      [ Command.Array.command,
        Command.Prove.command,
        Command.Certificate.command,
        Command.Check.command,
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
    ),
    ( "Touch",
      [ Command.Probe.command,
        Command.Convert.command,
        Command.Register.command,
        Command.Stitch.command,
        Command.Segment.command,
        Command.Compare.command,
        Command.Evaluate.command,
        Command.Sensor.command,
        Command.Calibrate.command
      ]
    ),
    ( "Objects and symbols",
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
    ),
    ("Other implementations", [Command.Serve.command, Command.Vectors.command])
  ]

-- | The options of a command by its name, or of the program, as help lists them: for the program,
-- with a line for each command.
bodyOf :: [String] -> Chunk Doc
bodyOf asked = case asked of
  [_, name]
    | one : _ <- [one | (_, several) <- commands, one <- several, subcommandName one == name] ->
      subcommandBody one
  _ ->
    vsepChunks $
      vcatChunks
        [stringChunk "Available options:", Help.fullDesc preferences (pure () <**> general)] :
        [ vcatChunks (stringChunk (heading ++ ":") : map (stringChunk . line) several)
          | (heading, several) <- commands
        ]
  where
    line one = "  " ++ padded (subcommandName one) ++ "  " ++ subcommandBrief one
    padded name = name ++ replicate (11 - length name) ' '
