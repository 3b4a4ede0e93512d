-- | Options that several commands have, each said once, and how answers are printed.
module Options
  ( module Options.Applicative,
    module Readers,

    -- * Commands
    subcommand,

    -- * Forms of options
    valued,
    defaulting,
    usually,
    fileOption,
    optionalFile,
    folderOption,
    pathArgument,
    outputFileOption,
    shardOption,
    choosing,
    allNamed,

    -- * The code
    orderOption,
    modulusOption,
    foldingOption,
    surfaceOption,
    radiusOption,

    -- * Simulation
    seedOption,
    sizeOption,

    -- * Printing
    AnswerForm (..),
    jsonSwitch,
    printAs,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import ExitStatus
import Numeric.Natural (Natural)
import Options.Applicative hiding (columns, command)
import qualified Options.Applicative as Parser (command)
import Options.Applicative.Help.Chunk (stringChunk, unChunk, vcatChunks)
import PraTactile.Array (Folding, Surface)
import PraTactile.Format.Name
import PraTactile.Locate (Radius (..))
import Readers

-- | A command: its name, what it does in a sentence, examples of its use, and its options.
subcommand ::
  String -> String -> [String] -> Parser (IO ExitStatus) -> Mod CommandFields (IO ExitStatus)
subcommand name does examples options =
  Parser.command
    name
    (info (helpNamed name <$> options <**> helper) said)
  where
    said = fullDesc <> progDesc does <> footerDoc (unChunk exampleText)
    exampleText = vcatChunks (map stringChunk (heading : map ("  " ++) examples))
    heading = if length examples == 1 then "Example:" else "Examples:"

-- | An option with its reader, its name, what stands for its value, and its help.
valued :: ReadM a -> String -> String -> String -> Parser a
valued reader name meta text = option reader (long name <> metavar meta <> help text)

-- | An option with a default, which its help shows.
defaulting :: Show a => a -> ReadM a -> String -> String -> String -> Parser a
defaulting standard reader name meta text =
  option reader (long name <> metavar meta <> value standard <> showDefault <> help text)

-- | An option with a default, which its help shows and its command takes: 'Nothing' where it was
-- not given, so that a command can tell.
usually :: Show a => a -> ReadM a -> String -> String -> String -> Parser (Maybe a)
usually standard reader name meta text =
  optional (valued reader name meta (text ++ " (default: " ++ show standard ++ ")"))

-- | An option whose value is a file, likewise.
fileOption :: String -> String -> String -> Parser FilePath
fileOption name meta text =
  option pathReader (long name <> metavar meta <> action "file" <> help text)

-- | The same that may be left out.
optionalFile :: String -> String -> String -> Parser (Maybe FilePath)
optionalFile name meta = optional . fileOption name meta

-- | An option whose value is a folder.
folderOption :: String -> String -> Parser FilePath
folderOption name text =
  option pathReader (long name <> metavar "FOLDER" <> action "directory" <> help text)

-- | An argument that is a path, with its properties.
pathArgument :: Mod ArgumentFields FilePath -> Parser FilePath
pathArgument = argument pathReader

-- | @--output FILE@, in place of the standard output.
outputFileOption :: Parser (Maybe FilePath)
outputFileOption = optionalFile "output" "FILE" "Write to a file instead of the standard output"

-- | @--shard I/K@: I from 1 to K; the whole where nothing is said.
shardOption :: Parser (Maybe (Natural, Natural))
shardOption =
  optional . option shard $
    long "shard"
      <> metavar "I/K"
      <> help "Only the I-th of K parts, which 'merge' puts together"
  where
    shard =
      pairReader '/' "--shard 1/8" >>= \(i, k) ->
        if 1 <= i && i <= (k :: Integer)
          then pure (fromInteger i, fromInteger k)
          else readerError "a shard is I/K with I from 1 to K, as in --shard 1/8"

-- | An option whose values have names. The first argument is what a message calls such a value, the
-- second the values by their names; then the option's name, what stands for its value in the help,
-- its help, and further properties.
choosing ::
  String -> [(String, a)] -> String -> String -> String -> Mod OptionFields a -> Parser a
choosing what choices name meta text more =
  option (namedReader what choices) $
    long name <> metavar meta <> completeWith (map fst choices) <> help text <> more

-- | The values of a type by their names.
allNamed :: (Bounded a, Enum a) => (a -> String) -> [(String, a)]
allNamed nameOf = [(nameOf a, a) | a <- [minBound ..]]

-- | @--q@.
orderOption :: Parser Natural
orderOption = valued naturalReader "q" "Q" "Order of the field GF(q): a prime power up to 256"

-- | @--modulus@.
modulusOption :: Parser (Maybe [Natural])
modulusOption =
  optional . valued numbersReader "modulus" "C0,C1,.." $
    "Modulus of GF(p^m), constant term first (default: the Conway polynomial)"

-- | @--folding@, with its help.
foldingOption :: String -> Parser (Maybe Folding)
foldingOption text =
  optional (choosing "folding" (allNamed foldingName) "folding" "FOLDING" text mempty)

-- | @--surface torus|twisted-torus|sheet@.
surfaceOption :: Parser (Maybe Surface)
surfaceOption =
  optional (choosing "surface" (allNamed surfaceName) "surface" "SURFACE" text mempty)
  where
    text = "torus, twisted-torus or sheet (default: the folding's own)"

-- | @--radius N@, with its help; the guaranteed radius without it.
radiusOption :: String -> Parser Radius
radiusOption text = maybe Guaranteed UpTo <$> optional (valued naturalReader "radius" "N" text)

-- | @--seed N@, with more of it.
seedOption :: Mod OptionFields Int -> Parser Int
seedOption more =
  option intReader (long "seed" <> metavar "N" <> help "Seed of every random draw" <> more)

-- | @--size WIDTHxHEIGHT@, taxels.
sizeOption :: Parser (Maybe (Int, Int))
sizeOption =
  optional . valued (pairReader 'x' "40x52") "size" "WIDTHxHEIGHT" $
    "The region in taxels of 1.5875 mm (default 40x52, or the sensor's own size where that is \
    \larger)"

-- | How an answer is printed.
data AnswerForm = AsText | AsJson
  deriving stock (Eq, Show)

-- | @--json@, with its help.
jsonSwitch :: String -> Parser AnswerForm
jsonSwitch text = flag AsText AsJson (long "json" <> help text)

-- | Print an answer: its text, or its JSON on one line.
printAs :: AnswerForm -> String -> ByteString -> IO ()
printAs form text json = case form of
  AsText -> putStr text
  AsJson -> Bytes.putStrLn json
