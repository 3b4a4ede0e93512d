-- | Options that several commands share, and how answers are printed.
module Options
  ( module Options.Applicative,
    module Readers,

    -- * Commands
    Subcommand (..),
    subcommand,
    Group (..),
    helpPreferences,

    -- * Forms of options
    valued,
    defaulting,
    usually,
    orAlias,
    orAliasFlag,
    fileOption,
    optionalFile,
    folderOption,
    pathArgument,
    outputFileOption,
    pictureOption,
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

import Counted (numberText)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import ExitStatus
import Numeric.Natural (Natural)
import Options.Applicative hiding (columns, command)
import qualified Options.Applicative as Parser (command)
import Options.Applicative.Help (Chunk (..), Doc, isEmpty, stringChunk, vcatChunks, vsepChunks)
import qualified Options.Applicative.Help.Core as Help (fullDesc)
import Options.Applicative.Types
  ( OptName (..),
    OptProperties (..),
    OptReader (..),
    OptVisibility (..),
    Option (..),
    Parser (..),
  )
import PraTactile.Array (Folding, Surface)
import PraTactile.Format.Name
import PraTactile.Locate (Radius (..))
import Readers

-- | A command of the program.
data Subcommand = Subcommand
  { subcommandName :: String,
    -- | what it does, in a few words
    subcommandBrief :: String,
    subcommandParser :: Mod CommandFields (IO ExitStatus),
    -- | the options, as the command's help lists them
    subcommandBody :: Chunk Doc
  }

-- | Options that a command's help lists under a heading of their own, after the command's own ones:
-- the heading, and the names of the options.
data Group = Group String [String]

-- | How help is shown.
helpPreferences :: ParserPrefs
helpPreferences = defaultPrefs

-- | A command: its name, what it does in a few words, what it does in full, the groups of options
-- that stand apart in its help, examples of its use, and its parser.
subcommand ::
  String -> String -> String -> [Group] -> [String] -> Parser (IO ExitStatus) -> Subcommand
subcommand name brief does groups examples options =
  Subcommand
    { subcommandName = name,
      subcommandBrief = brief,
      subcommandParser =
        Parser.command
          name
          (info parser (fullDesc <> progDesc does <> footerDoc (unChunk exampleText))),
      subcommandBody = optionsInGroups groups parser
    }
  where
    parser = helpNamed name (olderNames options) <$> options <**> helper
    exampleText = vcatChunks (map stringChunk (heading : map ("  " ++) examples))
    heading = if length examples == 1 then "Example:" else "Examples:"

-- | The options of a parser, those of no group first.
optionsInGroups :: [Group] -> Parser a -> Chunk Doc
optionsInGroups groups parser =
  vsepChunks $
    section "Available options" (not . (`elem` concat [names | Group _ names <- groups])) :
      [section heading (`elem` names) | Group heading names <- groups]
  where
    section heading wanted = case Help.fullDesc helpPreferences (showing wanted parser) of
      options
        | isEmpty options -> mempty
        | otherwise -> vcatChunks [stringChunk (heading ++ ":"), options]

-- | A parser whose help has those options alone whose long name is wanted; an argument has the
-- empty name.
showing :: (String -> Bool) -> Parser a -> Parser a
showing wanted = go
  where
    go :: Parser b -> Parser b
    go parser = case parser of
      NilP _ -> parser
      OptP one
        | any wanted (longNames (optMain one)) -> parser
        | otherwise -> OptP one {optProps = (optProps one) {propVisibility = Internal}}
      MultP f a -> MultP (go f) (go a)
      AltP a b -> AltP (go a) (go b)
      BindP a next -> BindP (go a) (go . next)

-- | The long names of an option; an argument has the empty name.
longNames :: OptReader a -> [String]
longNames what = case what of
  OptReader names _ _ -> [name | OptLong name <- names]
  FlagReader names _ -> [name | OptLong name <- names]
  _ -> [""]

-- | The options of a parser that have an older name, made by 'orAlias': name and older name.
olderNames :: Parser a -> [(String, String)]
olderNames parser = case parser of
  NilP _ -> []
  OptP _ -> []
  MultP f a -> olderNames f ++ olderNames a
  AltP (OptP old) new
    | propVisibility (optProps old) == Internal ->
      [ ("--" ++ name, "--" ++ older)
        | name <- take 1 (namesIn new),
          older <- longNames (optMain old)
      ]
        ++ olderNames new
  AltP a b -> olderNames a ++ olderNames b
  BindP a _ -> olderNames a
  where
    namesIn :: Parser b -> [String]
    namesIn one = case one of
      NilP _ -> []
      OptP found
        | propVisibility (optProps found) == Internal -> []
        | otherwise -> longNames (optMain found)
      MultP f a -> namesIn f ++ namesIn a
      AltP a b -> namesIn a ++ namesIn b
      BindP a _ -> namesIn a

-- | An option that also has an older name, which the help does not show: the older name, the
-- option's reader, its further properties, and the option.
orAlias :: String -> ReadM a -> Mod OptionFields a -> Parser a -> Parser a
orAlias name reader more new = option reader (long name <> internal <> more) <|> new

-- | A flag that also has an older name, which the help does not show: the older name, what the flag
-- stands for, and the flag.
orAliasFlag :: String -> a -> Parser a -> Parser a
orAliasFlag name meaning new = flag' meaning (long name <> internal) <|> new

-- | An option: its reader, its name, the metavariable of its value, and its help.
valued :: ReadM a -> String -> String -> String -> Parser a
valued reader name meta text = option reader (long name <> metavar meta <> help text)

-- | An option with a default, which its help shows.
defaulting :: Show a => a -> ReadM a -> String -> String -> String -> Parser a
defaulting standard reader name meta text =
  option
    reader
    (long name <> metavar meta <> value standard <> showDefaultWith plainly <> help text)

-- | An option with a default that its help shows. It is 'Nothing' if it was not given, so that the
-- command knows; the command itself takes the default.
usually :: Show a => a -> ReadM a -> String -> String -> String -> Parser (Maybe a)
usually standard reader name meta text =
  optional (valued reader name meta (text ++ " (default: " ++ plainly standard ++ ")"))

-- | A value as help shows it: numbers without an exponent.
plainly :: Show a => a -> String
plainly shown = case reads text of
  [(number, "")] | any (`elem` ".e") text -> numberText number
  _ -> text
  where
    text = show shown

-- | An option whose value is a file: its name, the metavariable of its value, and its help.
fileOption :: String -> String -> String -> Parser FilePath
fileOption name meta text =
  option pathReader (long name <> metavar meta <> action "file" <> help text)

-- | An option whose value is a file, and which may be left out.
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
outputFileOption = optionalFile "output" "FILE" "Write to this file instead of the standard output"

-- | @--picture FILE.svg@, given its older names, which the help does not show, and its help.
pictureOption :: [String] -> String -> Parser (Maybe FilePath)
pictureOption older text =
  optional $
    foldr
      (\name -> orAlias name pathReader (action "file"))
      (fileOption "picture" "FILE.svg" text)
      older

-- | @--shard I/K@: I from 1 to K; 'Nothing' is the whole.
shardOption :: Parser (Maybe (Natural, Natural))
shardOption =
  optional . option shard $
    long "shard"
      <> metavar "I/K"
      <> help "Do only the I-th of K parts; 'merge' joins them"
  where
    shard =
      pairReader '/' "--shard 1/8" >>= \(i, k) ->
        if 1 <= i && i <= (k :: Integer)
          then pure (fromInteger i, fromInteger k)
          else readerError "a shard is I/K with I from 1 to K, as in --shard 1/8"

-- | An option whose values have names. The arguments: what messages call such a value, the values
-- by their names, the option's name, its metavariable, its help, and further properties.
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
orderOption = valued naturalReader "q" "Q" "Order q of the field GF(q): a prime power up to 256"

-- | @--modulus@.
modulusOption :: Parser (Maybe [Natural])
modulusOption =
  optional . valued numbersReader "modulus" "C0,C1,.." $
    "Modulus of GF(p^m): coefficients, constant term first (default: the Conway polynomial)"

-- | @--folding@, with its help.
foldingOption :: String -> Parser (Maybe Folding)
foldingOption text =
  optional (choosing "folding" (allNamed foldingName) "folding" "FOLDING" text mempty)

-- | @--surface torus|twisted-torus|sheet@.
surfaceOption :: Parser (Maybe Surface)
surfaceOption =
  optional (choosing "surface" (allNamed surfaceName) "surface" "SURFACE" text mempty)
  where
    text =
      "Surface of the array: torus, twisted-torus or sheet (default: the one that the array states)"

-- | @--radius N@, with its help; the guaranteed radius without it.
radiusOption :: String -> Parser Radius
radiusOption text = maybe Guaranteed UpTo <$> optional (valued naturalReader "radius" "N" text)

-- | @--seed N@, with further properties.
seedOption :: Mod OptionFields Int -> Parser Int
seedOption more =
  option intReader (long "seed" <> metavar "N" <> help "Seed of all random draws" <> more)

-- | @--size WIDTHxHEIGHT@, taxels.
sizeOption :: Parser (Maybe (Int, Int))
sizeOption =
  optional . valued (pairReader 'x' "40x52") "size" "WIDTHxHEIGHT" $
    "Size of the region in taxels of 1.5875 mm (default: 40x52, or the sensor's size if that is \
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
