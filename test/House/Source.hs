-- | The modules of the house as they stand on the disk: which wing each is in, and what it imports.
module House.Source
  ( Wing (..),
    wingName,
    Source (..),
    readHouse,
    readText,
  )
where

import Data.List (isSuffixOf, sort)
import Data.Maybe (mapMaybe)
import System.Directory (doesDirectoryExist, listDirectory)
import System.FilePath (dropExtension, (</>))
import System.IO (IOMode (..), hGetContents, hSetEncoding, utf8, withFile)

-- | The parts of the house, those below first.
data Wing
  = Common
  | Code
  | Touch
  | Simulation
  | Solid
  | Recognition
  | Formats
  | Files
  | Store
  | Conformance
  | App
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | What a wing is called where the house is drawn; but for the last, its folder in @src@.
wingName :: Wing -> String
wingName wing = case wing of
  Common -> "common"
  Code -> "code"
  Touch -> "touch"
  Simulation -> "simulation"
  Solid -> "solid"
  Recognition -> "recognition"
  Formats -> "formats"
  Files -> "files"
  Store -> "store"
  Conformance -> "conformance"
  App -> "app"

-- | A module as it stands in the house.
data Source = Source
  { sourceName :: String,
    sourceWing :: Wing,
    sourceImports :: [String],
    sourceText :: String
  }

-- | All modules of the house that stands in this folder; a wing without a folder has none.
readHouse :: FilePath -> IO [Source]
readHouse root = concat <$> traverse wing [minBound ..]
  where
    wing which = do
      let folder = root </> (if which == App then "app" else "src" </> wingName which)
      there <- doesDirectoryExist folder
      files <- if there then under folder else pure []
      traverse
        (\file -> source which (drop (length folder + 1) file) <$> readText file)
        (sort files)
    source which file text =
      Source (map dotted (dropExtension file)) which (mapMaybe imported (lines text)) text
    dotted letter = if letter `elem` "/\\" then '.' else letter

-- | The module that a line imports, in the forms that hlint and the compiler's warnings leave.
imported :: String -> Maybe String
imported line = case words line of
  "import" : "qualified" : name : _ -> Just (upToList name)
  "import" : name : _ -> Just (upToList name)
  _ -> Nothing
  where
    upToList = takeWhile (/= '(')

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
