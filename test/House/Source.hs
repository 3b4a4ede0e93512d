{-# LANGUAGE DerivingStrategies #-}

-- | What a Haskell source says of itself without being compiled: the modules that it imports and the words that it uses.
-- Comments and strings say nothing.
module House.Source
  ( Wing (..)
  , wingName
  , wingFolder
  , Source (..)
  , source
  , readHouse
  , readText
    -- * Reading Haskell
  , tokens
  , importsIn
  ) where

import Data.Char (isAlphaNum, isSpace, isUpper)
import Data.List (isPrefixOf, isSuffixOf, sort)
import System.Directory (doesDirectoryExist, listDirectory)
import System.FilePath ((</>))
import System.IO (IOMode (..), hGetContents, hSetEncoding, utf8, withFile)

-- | The parts of the house.
data Wing = Common | Code | Touch | Recognition | Files | Formats | Store | Conformance | App
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | What a wing is called where the house is drawn.
wingName :: Wing -> String
wingName wing = case wing of
  Common -> "common"
  Code -> "code"
  Touch -> "touch"
  Recognition -> "recognition"
  Files -> "files"
  Formats -> "formats"
  Store -> "store"
  Conformance -> "conformance"
  App -> "app"

-- | The folder of a wing, from the top of the repository.
wingFolder :: Wing -> FilePath
wingFolder App = "app"
wingFolder wing = "src" </> wingName wing

-- | A module as it stands in the house.
data Source = Source
  { sourceName :: String
  , sourceWing :: Wing
  , sourceImports :: [String]
  , sourceTokens :: [String]
  }
  deriving stock (Eq, Show)

-- | A module of this name in this wing, by its text.
source :: Wing -> String -> String -> Source
source wing name text = Source name wing (importsIn found) found
  where found = tokens text

-- | All modules of the house that stands in this folder; a wing without a folder has none.
readHouse :: FilePath -> IO [Source]
readHouse root = concat <$> traverse wing [minBound ..]
  where
    wing which = do
      let folder = root </> wingFolder which
      there <- doesDirectoryExist folder
      files <- if there then under folder else pure []
      traverse (\file -> source which (named (drop (length folder + 1) file)) <$> readText file) (sort files)
    named = map (\letter -> if letter == '/' || letter == '\\' then '.' else letter) . dropEnd 3
    dropEnd n list = take (length list - n) list

under :: FilePath -> IO [FilePath]
under folder = listDirectory folder >>= fmap concat . traverse (visit . (folder </>))
  where
    visit path = do
      deeper <- doesDirectoryExist path
      if deeper then under path else pure [path | ".hs" `isSuffixOf` path]

-- | The text of a file, read at once and as UTF-8 whatever the locale.
readText :: FilePath -> IO String
readText file = withFile file ReadMode $ \handle -> do
  hSetEncoding handle utf8
  text <- hGetContents handle
  length text `seq` pure text

-- | The words and marks of a Haskell source, without comments; every literal text is one empty string.
--
-- >>> tokens "import Data.List {- (nub) -} (sort) -- import System.IO"
-- ["import","Data.List","(","sort",")"]
tokens :: String -> [String]
tokens text = case text of
  [] -> []
  '{' : '-' : more -> tokens (afterBlock (1 :: Int) more)
  '-' : '-' : more | comment more -> tokens (dropWhile (/= '\n') more)
  '"' : more -> "\"\"" : tokens (afterString more)
  '\'' : '\\' : _ : more -> tokens (drop 1 (dropWhile (/= '\'') more))
  '\'' : _ : '\'' : more -> tokens more
  letter : more
    | isSpace letter -> tokens more
    | wordly letter -> let (word, others) = span inWord text in word : tokens others
    | otherwise -> [letter] : tokens more
  where
    wordly letter = isAlphaNum letter || letter == '_'
    inWord letter = wordly letter || letter == '\'' || letter == '.'
    comment more = not (any (`elem` "!#$%&*+./<=>?@\\^|~:") (take 1 (dropWhile (== '-') more)))
    afterBlock depth more = case more of
      _ | depth == 0 -> more
      [] -> []
      '-' : '}' : others -> afterBlock (depth - 1) others
      '{' : '-' : others -> afterBlock (depth + 1) others
      _ : others -> afterBlock depth others
    afterString more = case more of
      [] -> []
      '\\' : _ : others -> afterString others
      '"' : others -> others
      _ : others -> afterString others

-- | The modules that the words of a source import.
importsIn :: [String] -> [String]
importsIn found = case found of
  [] -> []
  "import" : more -> take 1 (dropWhile decoration more) ++ importsIn more
  _ : more -> importsIn more
  where
    decoration word = word `elem` ["safe", "qualified"] || "\"" `isPrefixOf` word || not (any isUpper (take 1 word))
