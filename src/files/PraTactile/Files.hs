-- | Reads folders of frames, images and movies from disk. "PraTactile.Source" and
-- "PraTactile.Format" interpret their bytes.
module PraTactile.Files
  ( -- * Folders of frames
    readFolder,
    readFolderUpTo,
    hasManifest,

    -- * Images
    readImage,
    readFrame,

    -- * Any path
    SourcePath (..),
    sourcePath,
    sourcePaths,
    readSource,
    readPoses,
    readMovie,

    -- * Bytes
    readUpTo,
    largestInput,

    -- * Errors
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

-- | Why nothing was read. Each constructor names the path.
data FilesError
  = -- | There is no such file.
    NoSuchFile FilePath
  | -- | There is no such folder.
    NoSuchFolder FilePath
  | -- | There is neither a file nor a folder with this name.
    NoSuchPath FilePath
  | -- | It is a folder, where a file is needed.
    IsFolder FilePath
  | -- | It is a file, where a folder is needed.
    IsFile FilePath
  | -- | The folder holds no manifest ('manifestName', 'jsonManifestName').
    NoManifest FilePath
  | -- | The file is not a valid CSV manifest.
    ManifestRefused FilePath ManifestError
  | -- | The file is not a valid JSON manifest.
    JsonManifestRefused FilePath FormatError
  | -- | The file is not a valid table of poses.
    PosesRefused FilePath ManifestError
  | -- | The file is not a movie that fits these poses.
    MovieRefused FilePath SourceError
  | -- | The file may not be read.
    NotPermitted FilePath
  | -- | The file, or all images of the folder together, are larger than this number of bytes.
    TooLarge FilePath Int
  | -- | It cannot be read for another reason, in the system's words.
    Unreadable FilePath String
  deriving stock (Eq, Show)

-- | The greatest size of an image or manifest, and of all images of a folder together: 256 MiB. A
-- frame has some hundred bytes.
largestInput :: Int
largestInput = 256 * 1024 * 1024

-- | Reads a folder's manifest (the JSON form if there is one, else the CSV form) and the images
-- that it names. Names that lead out of the folder are not read; 'PraTactile.Source.folderFrames'
-- refuses such a folder.
readFolder :: FilePath -> IO (Either FilesError Folder)
readFolder = readFolderUpTo largestInput

-- | 'readFolder' with the given limit, in bytes, for all images together.
readFolderUpTo :: Int -> FilePath -> IO (Either FilesError Folder)
readFolderUpTo limit = readListed limit (const True)

-- | 'readFolderUpTo' for only those frames whose file names satisfy the test.
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

-- | Reads the named images of a folder. Refuses more than the given number of bytes together.
readImages :: Int -> FilePath -> [FilePath] -> IO (Either FilesError (Map FilePath ByteString))
readImages limit folder names = do
  files <- traverse fileOf names
  fmap Map.fromList <$> images limit (nub files)
  where
    -- A name without a file of that name may mean a frame of a movie.
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

-- | Reads the bytes of an image of at most 'largestInput'.
readImage :: FilePath -> IO (Either FilesError ByteString)
readImage = readUpTo largestInput

-- | Reads the bytes of an image, and the frame number if the path means a frame of a movie
-- ('frameOfMovie').
readFrame :: FilePath -> IO (Either FilesError (ByteString, Maybe Int))
readFrame path = do
  whole <- doesPathExist path
  case frameOfMovie path of
    Just (movie, number) | not whole -> numbered (Just number) movie
    _ -> numbered Nothing path
  where
    numbered number file = fmap (\bytes -> (bytes, number)) <$> readImage file

-- | The path of a source of frames.
data SourcePath
  = -- | a folder of frames with its manifest
    FolderPath FilePath
  | -- | some frames of a folder, by their file names in the manifest
    FramePaths FilePath [FilePath]
  | -- | one image that is a whole composite; @-@ is standard input
    ImagePath FilePath
  | -- | a file of poses and the movie that it belongs to
    MoviePath FilePath FilePath
  deriving stock (Eq, Show)

-- | The file or folder of a source.
sourcePath :: SourcePath -> FilePath
sourcePath source = case source of
  FolderPath folder -> folder
  FramePaths folder _ -> folder
  ImagePath file -> file
  MoviePath _ file -> file

-- | Groups paths into sources. Folders and whole images are one source each, in their order. Then
-- follow the files that a manifest beside them lists, grouped by folder. Refuses a path that does
-- not exist, and an invalid manifest beside a file.
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

-- | The source of one path.
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
    -- The name of a movie means all its listed frames.
    besideOthers isFile manifest = case filter (isOf . entryFile) (manifestEntries manifest) of
      [] -> alone isFile
      entries -> Right (FramePaths folder (map entryFile entries))
    isOf listed = listed == name || fmap fst (frameOfMovie listed) == Just name

-- | Reads the frames or the image of a source.
readSource :: SourcePath -> IO (Either FilesError Source)
readSource source = case source of
  FolderPath folder -> fmap FrameFolder <$> readFolder folder
  FramePaths folder names -> fmap FrameFolder <$> readListed largestInput (`elem` names) folder
  ImagePath file -> fmap WholeImage <$> readImage file
  MoviePath poses file ->
    readPoses poses `andThen` \entries -> fmap FrameFolder <$> readMovie (Just entries) file

-- | Reads the poses of a movie's frames.
readPoses :: FilePath -> IO (Either FilesError [Entry])
readPoses file = (>>= first (PosesRefused file) . parsePoses) <$> readUpTo largestInput file

-- | Reads a movie as a folder of frames. The poses are given if they are known.
readMovie :: Maybe [Entry] -> FilePath -> IO (Either FilesError Folder)
readMovie entries file =
  (>>= first (MovieRefused file) . movieFolder (takeFileName file) entries) <$> readImage file

-- | Reads a file, pipe or device; @-@ is standard input. Refuses more than the given number of
-- bytes.
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
      -- A pipe has no known size, so it is read up to the limit.
      size <- either unknown id <$> try (hFileSize handle)
      if size > toInteger limit then pure Nothing else most limit (fromInteger size) handle
    unknown :: IOException -> Integer
    unknown _ = 0
    -- The system's own words, without names of library functions.
    reason words' = case words' of
      [] -> "the system does not say why"
      letter : others -> toLower letter : others
    problemOf :: IOException -> FilesError
    problemOf problem
      | isDoesNotExistError problem = NoSuchFile file
      | isPermissionError problem = NotPermitted file
      | otherwise = Unreadable file (reason (ioe_description problem))

-- | Reads everything from a handle; 'Nothing' if it is more than the limit. The second number of
-- bytes is known to be there and is held in memory only once.
most :: Int -> Int -> Handle -> IO (Maybe ByteString)
most limit known handle = do
  begin <- Bytes.hGet handle known
  others <- Lazy.hGet handle (limit + 1 - Bytes.length begin)
  pure $
    if Bytes.length begin + fromIntegral (Lazy.length others) > limit
      then Nothing
      else Just (if Lazy.null others then begin else begin <> Lazy.toStrict others)

-- | Runs the second action if the first succeeds.
andThen :: IO (Either e a) -> (a -> IO (Either e b)) -> IO (Either e b)
andThen one next = one >>= either (pure . Left) next
