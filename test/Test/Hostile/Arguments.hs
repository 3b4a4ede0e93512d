-- | Hostile argument lists. Commands and options are read from the program's own help, so that new
-- ones are tried without being listed here.
module Test.Hostile.Arguments
  ( -- * What there is
    Command (..),
    Option (..),
    commandsOfHelp,

    -- * Argument lists
    argumentList,
    valueFor,
    word,

    -- * What becomes of them
    judgedArguments,
  )
where

import CommandLine
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Char (chr, isLower)
import Data.List (dropWhileEnd, intercalate, isPrefixOf)
import Options.Applicative (ParserResult (..), execParserPure)
import Test.Hostile.Judgement
import Test.Hostile.Mutation (hostileNumbers, hostileWords)
import Test.QuickCheck hiding (Failure, Success)

-- | A command with its options, and the names of its arguments.
data Command = Command
  { commandName :: String,
    commandOptions :: [Option],
    commandArguments :: [String]
  }
  deriving stock (Eq, Show)

-- | An option, and the name of its value if it has one.
data Option = Option
  { optionName :: String,
    optionValue :: Maybe String
  }
  deriving stock (Eq, Show)

-- | All commands in the help: each begins a line, indented by two spaces; its usage has its options
-- and arguments.
commandsOfHelp :: [Command]
commandsOfHelp =
  [ uncurry (Command name) (inUsage (drop 3 (usageOf name)))
    | line <- lines (helpOf ["--help"]),
      Just name <- [nameOn line]
  ]
  where
    nameOn line = case words line of
      name : _ : _
        | "  " `isPrefixOf` line,
          take 3 line /= "   ",
          all (\c -> isLower c || c == '-') name,
          any isLower (take 1 name) ->
          Just name
      _ -> Nothing
    usageOf name = case lines (helpOf [name, "--help"]) of
      usage : others -> words (unwords (usage : takeWhile ("   " `isPrefixOf`) others))
      [] -> []
    helpOf arguments = case execParserPure preferences commandLine arguments of
      Failure failure -> either id id (misunderstood "pra-tactile" failure)
      _ -> ""

-- | The options and the arguments in the words of a usage.
inUsage :: [String] -> ([Option], [String])
inUsage given = case given of
  [] -> ([], [])
  "|" : others -> inUsage others
  token : others
    | not ("--" `isPrefixOf` bare token) -> ([], [bare token]) <> inUsage others
    | closed token -> ([Option (bare token) Nothing], []) <> inUsage others
    | value : others' <-
        others,
      not (opened value) ->
      ([Option (bare token) (Just (bare value))], []) <> inUsage others'
    | otherwise -> ([Option (bare token) Nothing], []) <> inUsage others
  where
    bare = dropWhileEnd (`elem` "]).") . dropWhile (`elem` "[(")
    closed token = any (`elem` "])") (take 1 (reverse token))
    opened value = value == "|" || any (`elem` "[(") (take 1 value) || "--" `isPrefixOf` value

-- | Argument lists for these commands, with values that suit their names: the required ones, some
-- others, and then perhaps one left out, repeated, exchanged or inserted.
argumentList :: (String -> Gen String) -> [Command] -> Gen [String]
argumentList values given = do
  command <- elements given
  named <- frequency [(30, pure (commandName command)), (1, word)]
  chosen <-
    sublistOf (commandOptions command)
      >>= shuffle
      >>= \options -> flip take options <$> choose (0, 5)
  options <- concat <$> traverse option chosen
  arguments <-
    traverse values (commandArguments command)
      >>= \found ->
        frequency [(3, pure found), (1, pure (take 1 found)), (1, pure (found ++ found))]
  spoilt . (named :)
    =<< frequency [(4, pure (options ++ arguments)), (1, pure (arguments ++ options))]
  where
    option (Option name value) = case value of
      Nothing -> pure [name]
      Just called ->
        values called
          >>= \text ->
            frequency [(4, pure [name, text]), (1, pure [name ++ "=" ++ text]), (1, pure [name])]
    spoilt list =
      frequency
        [ (8, pure list),
          (2, at list >>= \i -> pure (take i list ++ drop (i + 1) list)),
          (1, at list >>= \i -> pure (take i list ++ take 1 (drop i list) ++ drop i list)),
          (2, at list >>= \i -> word >>= \one -> pure (take i list ++ [one] ++ drop i list)),
          (1, shuffle list)
        ]
    at list = choose (0, length list)

-- | A value for this name, valid or not.
valueFor :: String -> Gen String
valueFor called = frequency [(3, elements (fine called)), (2, word)]
  where
    fine name
      | '|' `elem` name = alternatives name
      | otherwise = case name of
        "Q" -> words "2 4 9 16 6"
        "C0,C1," -> words "1,1,1 3,2,1,0,1 1,1,0,0,1 2,1,1,0,0,0,1"
        "S0,S1," -> ["0,0,0,1", "1,0,0,0", "0,0"]
        "ROWSxCOLUMNS" -> words "15x17 2x2 3x5 1x4 0x0 255x1"
        "FOLDING" -> ["diagonal", "row-major"]
        "SURFACE" -> ["torus", "twisted-torus", "sheet"]
        "DRAWING" -> words "##./.## # . #/## ##/##"
        "FORMAT" -> words "text csv json pgm svg c mem"
        "ROW,COLUMN" -> words "6,5 0,0 14,16 15,17"
        "X,Y" -> ["0,0", "12.7,60", "-1,1e3"]
        "WIDTHxHEIGHT" -> ["40x52", "16x16", "0x0"]
        "NAME" -> ["cube", "parallelepiped"]
        "VERTICES" -> ["C1 C2 C3 C4", "P2 P6 P7 P3"]
        "I/K" -> words "1/1 2/8 0/0 9/8"
        "PATCH" -> ["3 2 / 3 1", "0 0 / 0 0", "3 2 / 3 1 ; 0,3: 1 1 / 1 1", "[[3,2],[3,1]]"]
        _ -> words "0 1 3 0.5 input"
    alternatives name = case break (== '|') name of
      (one, _ : others) -> one : alternatives others
      (one, []) -> [one]

-- | Any single argument. Bytes that are not ASCII are encoded as in a file's name.
word :: Gen String
word =
  oneof
    [ asArgument <$> elements (hostileNumbers ++ hostileWords),
      intercalate "," <$> parts,
      intercalate "x" <$> parts,
      intercalate "/" <$> parts,
      elements
        [ "--",
          "-",
          "---",
          "-x",
          "-h",
          "--help",
          "--version",
          "--nothing",
          "--q",
          "--json",
          "+RTS",
          "-RTS",
          "--bash-completion-index",
          "--bash-completion-script"
        ]
    ]
  where
    parts = choose (1, 3) >>= \n -> vectorOf n (asArgument <$> elements hostileNumbers)

asArgument :: ByteString -> String
asArgument bytes =
  [chr (if b < 128 then fromIntegral b else 0xDC00 + fromIntegral b) | b <- Bytes.unpack bytes]

-- | What the option parsers make of an argument list; nothing is run.
judgedArguments :: [String] -> Judged
judgedArguments arguments = case execParserPure preferences commandLine arguments of
  Success run -> run `seq` Accepted [] ""
  CompletionInvoked _ -> Accepted [] ""
  Failure failure -> case misunderstood "pra-tactile" failure of
    Right help -> Accepted [] help
    Left complaint -> Refused complaint
