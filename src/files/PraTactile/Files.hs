-- | Reading folders of frames and images from disk. Only bytes are read here: what they hold is for
-- "PraTactile.Source" to say.
module PraTactile.Files
  ( -- * Reading
    readFolder,
    readChosen,
    readImages,
    readImage,
    readUpTo,
    largestInput,

    -- * What can be wrong
    FilesError (..),
  )
where

import Control.Exception (try)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import GHC.IO.Exception (IOException (..))
import PraTactile.Source (Folder (..), manifestName, namedImages)
import System.Directory (doesDirectoryExist, doesPathExist)
import System.FilePath ((</>))
import System.IO (IOMode (..), hFileSize, withBinaryFile)
import System.IO.Error (isDoesNotExistError, isPermissionError)

-- | Why bytes were not read; each names the path.
data FilesError
  = -- | There is no such file.
    NoSuchFile FilePath
  | -- | There is no such folder.
    NoSuchFolder FilePath
  | -- | It is a folder, where a file is needed.
    IsFolder FilePath
  | -- | It is a file, where a folder is needed.
    IsFile FilePath
  | -- | The folder holds no manifest ('manifestName').
    NoManifest FilePath
  | -- | The file may not be read.
    NotPermitted FilePath
  | -- | The file, or the folder's images together, is larger than this many bytes.
    TooLarge FilePath Int
  | -- | It cannot be read for another reason, in the system's words.
    Unreadable FilePath String
  deriving stock (Eq, Show)

-- | 256 MiB: the largest image or manifest that is read, and the most that the images of one folder
-- may be together. A frame is some hundred bytes.
largestInput :: Int
largestInput = 256 * 1024 * 1024

-- | A folder's manifest, and the images that it names. Names that lead out of the folder are not
-- read, nor is anything if the manifest is wrong: 'PraTactile.Source.folderFrames' refuses such a
-- folder and says why.
readFolder :: FilePath -> IO (Either FilesError Folder)
readFolder = readChosen (const True)

-- | A folder's manifest, and those images that it names whose names are wanted.
readChosen :: (FilePath -> Bool) -> FilePath -> IO (Either FilesError Folder)
readChosen wanted folder = do
  isFolder <- doesDirectoryExist folder
  isSomething <- doesPathExist folder
  hasManifest <- doesPathExist (folder </> manifestName)
  case () of
    _
      | isFolder && hasManifest ->
        readUpTo largestInput (folder </> manifestName) >>= either (pure . Left) named
      | isFolder -> pure (Left (NoManifest folder))
      | isSomething -> pure (Left (IsFile folder))
      | otherwise -> pure (Left (NoSuchFolder folder))
  where
    named manifest = fmap (Folder manifest) <$> readImages wanted folder (namedImages manifest)

-- | Those images of a folder, by their names, whose names are wanted.
readImages ::
  (FilePath -> Bool) -> FilePath -> [FilePath] -> IO (Either FilesError (Map FilePath ByteString))
readImages wanted folder = fmap (fmap Map.fromList) . images largestInput . filter wanted
  where
    images _ [] = pure (Right [])
    images room (name : names) = do
      read' <- readUpTo room (folder </> name)
      case read' of
        Right bytes -> fmap ((name, bytes) :) <$> images (room - Bytes.length bytes) names
        Left (TooLarge file _) ->
          pure (Left (TooLarge (if room < largestInput then folder else file) largestInput))
        Left other -> pure (Left other)

-- | An image's bytes.
readImage :: FilePath -> IO (Either FilesError ByteString)
readImage = readUpTo largestInput

-- | A file's bytes, if there are not more than so many; of a pipe or a device as well.
readUpTo :: Int -> FilePath -> IO (Either FilesError ByteString)
readUpTo limit file = do
  isFolder <- doesDirectoryExist file
  if isFolder
    then pure (Left (IsFolder file))
    else do
      outcome <- try (withBinaryFile file ReadMode bytesOf)
      pure (either (Left . problemOf) id outcome)
  where
    bytesOf handle = do
      -- A pipe has no size to be asked for; it is read as far as it may go.
      size <- either unknown id <$> try (hFileSize handle)
      bytes <-
        if size > toInteger limit then pure Nothing else Just <$> Lazy.hGet handle (limit + 1)
      pure $ case bytes of
        Just whole | Lazy.length whole <= fromIntegral limit -> Right (Lazy.toStrict whole)
        _ -> Left (TooLarge file limit)
    unknown :: IOException -> Integer
    unknown _ = 0
    -- The system's own words, without the names of the library's functions.
    reason words' = case words' of
      [] -> "the system does not say why"
      letter : others -> toLower letter : others
    problemOf :: IOException -> FilesError
    problemOf problem
      | isDoesNotExistError problem = NoSuchFile file
      | isPermissionError problem = NotPermitted file
      | otherwise = Unreadable file (reason (ioe_description problem))
