-- | Reading folders of frames and images from disk. What their bytes hold is for
-- "PraTactile.Source" and "PraTactile.Format" to say.
module PraTactile.Files
  ( -- * Folders of frames
    readFolder,
    readFolderUpTo,
    hasManifest,

    -- * Images
    readImage,
    readFrame,

    -- * Whatever a path holds
    SourcePath (..),
    sourcePath,
    sourcePaths,
    readSource,
    readPoses,
    readMovie,

    -- * Bytes
    readUpTo,
    largestInput,

    -- * What can be wrong
    FilesError (..),
  )
where

import Control.Exception (try)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.List (nub)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import GHC.IO.Exception (IOException (..))
import PraTactile.Format (FormatError, decodeManifest)
import PraTactile.Sensor.Manifest
import PraTactile.Source (Folder (..), Source (..), SourceError, imagesNamed, movieFolder)
import System.Directory (doesDirectoryExist, doesFileExist, doesPathExist)
import System.FilePath (takeDirectory, takeFileName, (</>))
import System.IO (Handle, IOMode (..), hFileSize, stdin, withBinaryFile)
import System.IO.Error (isDoesNotExistError, isPermissionError)

-- | Why nothing was read; each names the path.
data FilesError
  = -- | There is no such file.
    NoSuchFile FilePath
  | -- | There is no such folder.
    NoSuchFolder FilePath
  | -- | There is neither a file nor a folder of this name.
    NoSuchPath FilePath
  | -- | It is a folder, where a file is needed.
    IsFolder FilePath
  | -- | It is a file, where a folder is needed.
    IsFile FilePath
  | -- | The folder holds no manifest ('manifestName', 'jsonManifestName').
    NoManifest FilePath
  | -- | The file is no manifest in the CSV form.
    ManifestRefused FilePath ManifestError
  | -- | The file is no manifest in the JSON form.
    JsonManifestRefused FilePath FormatError
  | -- | The file is no table of poses.
    PosesRefused FilePath ManifestError
  | -- | The file is no movie of which there are such poses.
    MovieRefused FilePath SourceError
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

-- | A folder's manifest, in its JSON form where there is one, else in its CSV form, and the images
-- that it names. Names that lead out of the folder are not read:
-- 'PraTactile.Source.folderFrames' refuses such a folder and says why.
readFolder :: FilePath -> IO (Either FilesError Folder)
readFolder = readFolderUpTo largestInput

-- | The same where the images may be so many bytes together.
readFolderUpTo :: Int -> FilePath -> IO (Either FilesError Folder)
readFolderUpTo limit = readListed limit (const True)

-- | The same of those frames alone whose files' names are wanted.
readListed :: Int -> (FilePath -> Bool) -> FilePath -> IO (Either FilesError Folder)
readListed limit wanted folder =
  readManifest folder `andThen` \manifest -> do
    let chosen =
          manifest {manifestEntries = filter (wanted . entryFile) (manifestEntries manifest)}
    fmap (Folder chosen) <$> readImages limit folder (imagesNamed chosen)

-- | Whether a folder has a manifest of either form.
hasManifest :: FilePath -> IO Bool
hasManifest folder =
  (||) <$> doesFileExist (folder </> manifestName) <*> doesFileExist (folder </> jsonManifestName)

readManifest :: FilePath -> IO (Either FilesError Manifest)
readManifest folder = do
  inJson <- doesFileExist json
  isFolder <- doesDirectoryExist folder
  isSomething <- doesPathExist folder
  inCsv <- doesPathExist csv
  case () of
    _
      | inJson -> parsed (first (JsonManifestRefused json) . decodeManifest) json
      | isFolder && inCsv -> parsed (first (ManifestRefused csv) . fmap listing . parseManifest) csv
      | isFolder -> pure (Left (NoManifest folder))
      | isSomething -> pure (Left (IsFile folder))
      | otherwise -> pure (Left (NoSuchFolder folder))
  where
    json = folder </> jsonManifestName
    csv = folder </> manifestName
    parsed parser file = (>>= parser) <$> readUpTo largestInput file

-- | These images of a folder, by their names, if they are no more than so many bytes together.
readImages :: Int -> FilePath -> [FilePath] -> IO (Either FilesError (Map FilePath ByteString))
readImages limit folder names = do
  files <- traverse fileOf names
  fmap Map.fromList <$> images limit (nub files)
  where
    -- A name that no file has may be that of a movie's frame.
    fileOf name = case frameOfMovie name of
      Just (movie, _) -> do
        whole <- doesPathExist (folder </> name)
        pure (if whole then name else movie)
      Nothing -> pure name
    images _ [] = pure (Right [])
    images room (name : others) = do
      read' <- readUpTo room (folder </> name)
      case read' of
        Right bytes -> fmap ((name, bytes) :) <$> images (room - Bytes.length bytes) others
        Left (TooLarge file _) ->
          pure (Left (TooLarge (if room < limit then folder else file) limit))
        Left other -> pure (Left other)

-- | An image's bytes.
readImage :: FilePath -> IO (Either FilesError ByteString)
readImage = readUpTo largestInput

-- | An image's bytes, and its number where the path is that of a movie's frame ('frameOfMovie').
readFrame :: FilePath -> IO (Either FilesError (ByteString, Maybe Int))
readFrame path = do
  whole <- doesPathExist path
  case frameOfMovie path of
    Just (movie, number) | not whole -> numbered (Just number) movie
    _ -> numbered Nothing path
  where
    numbered number file = fmap (\bytes -> (bytes, number)) <$> readImage file

-- | Where a source is.
data SourcePath
  = -- | a folder of frames with its manifest
    FolderPath FilePath
  | -- | those frames of a folder, by their files' names, as its manifest has them
    FramePaths FilePath [FilePath]
  | -- | one image that is a whole composite; @-@ is the standard input
    ImagePath FilePath
  | -- | a movie, with the file of its poses
    MoviePath FilePath FilePath
  deriving stock (Eq, Show)

-- | The path that stands for a source: its file or its folder.
sourcePath :: SourcePath -> FilePath
sourcePath source = case source of
  FolderPath folder -> folder
  FramePaths folder _ -> folder
  ImagePath file -> file
  MoviePath _ file -> file

-- | Paths as sources: folders and whole images each by itself, in their order; then, folder by
-- folder, the files that the manifest beside them lists, which belong together. Refuses a path
-- where nothing is, and a manifest that is none beside a file.
sourcePaths :: [FilePath] -> IO (Either FilesError [SourcePath])
sourcePaths paths = do
  found <- traverse sourceAt paths
  pure (grouped <$> sequence found)
  where
    grouped found =
      [source | source <- found, not (isFrame source)]
        ++ [ FramePaths folder (concat [names | FramePaths beside names <- found, beside == folder])
             | folder <- nub [folder | FramePaths folder _ <- found]
           ]
    isFrame source = case source of
      FramePaths _ _ -> True
      _ -> False

-- | The source that one path is of.
sourceAt :: FilePath -> IO (Either FilesError SourcePath)
sourceAt "-" = pure (Right (ImagePath "-"))
sourceAt path = do
  isFolder <- doesDirectoryExist path
  isFile <- doesFileExist path
  listed <- hasManifest folder
  case () of
    _
      | isFolder -> pure (Right (FolderPath path))
      | listed -> (>>= besideOthers isFile) <$> readManifest folder
      | otherwise -> pure (alone isFile)
  where
    folder = takeDirectory path
    name = takeFileName path
    alone isFile = if isFile then Right (ImagePath path) else Left (NoSuchPath path)
    -- A movie stands for all its frames that are listed.
    besideOthers isFile manifest = case filter (isOf . entryFile) (manifestEntries manifest) of
      [] -> alone isFile
      entries -> Right (FramePaths folder (map entryFile entries))
    isOf listed = listed == name || fmap fst (frameOfMovie listed) == Just name

-- | What a source holds.
readSource :: SourcePath -> IO (Either FilesError Source)
readSource source = case source of
  FolderPath folder -> fmap FrameFolder <$> readFolder folder
  FramePaths folder names -> fmap FrameFolder <$> readListed largestInput (`elem` names) folder
  ImagePath file -> fmap WholeImage <$> readImage file
  MoviePath poses file ->
    readPoses poses `andThen` \entries -> fmap FrameFolder <$> readMovie (Just entries) file

-- | The poses of a movie's frames.
readPoses :: FilePath -> IO (Either FilesError [Entry])
readPoses file = (>>= first (PosesRefused file) . parsePoses) <$> readUpTo largestInput file

-- | The folder that a movie is, given its poses if it is told where it was pressed.
readMovie :: Maybe [Entry] -> FilePath -> IO (Either FilesError Folder)
readMovie entries file =
  (>>= first (MovieRefused file) . movieFolder (takeFileName file) entries) <$> readImage file

-- | A file's bytes, if there are not more than so many; of a pipe or a device as well. @-@ is the
-- standard input.
readUpTo :: Int -> FilePath -> IO (Either FilesError ByteString)
readUpTo limit "-" = maybe (Left (TooLarge "the standard input" limit)) Right <$> most limit 0 stdin
readUpTo limit file = do
  isFolder <- doesDirectoryExist file
  if isFolder
    then pure (Left (IsFolder file))
    else do
      outcome <- try (withBinaryFile file ReadMode bytesOf)
      pure (either (Left . problemOf) (maybe (Left (TooLarge file limit)) Right) outcome)
  where
    bytesOf handle = do
      -- A pipe has no size to be asked for; it is read as far as it may go.
      size <- either unknown id <$> try (hFileSize handle)
      if size > toInteger limit then pure Nothing else most limit (fromInteger size) handle
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

-- | All that there is to be read, if it is not more than so many bytes. Those that are known to be
-- there, so many, are in memory once.
most :: Int -> Int -> Handle -> IO (Maybe ByteString)
most limit known handle = do
  begin <- Bytes.hGet handle known
  others <- Lazy.hGet handle (limit + 1 - Bytes.length begin)
  pure $
    if Bytes.length begin + fromIntegral (Lazy.length others) > limit
      then Nothing
      else Just (if Lazy.null others then begin else begin <> Lazy.toStrict others)

-- | One reading after the other, if the first succeeds.
andThen :: IO (Either e a) -> (a -> IO (Either e b)) -> IO (Either e b)
andThen one next = one >>= either (pure . Left) next
