-- | Reading and writing files: a file that cannot be read is a plain message and status 2, and nothing is left half
-- written.
module Files
  ( -- * Reading
    readBytes
  , readBytesUpTo
    -- * Writing
  , writeWhole
  , orUnwritable
  , writeFolder
  ) where

import Control.Exception (IOException, bracketOnError, try)
import Control.Monad (forM_, unless, when)
import qualified Data.ByteString as Bytes
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import System.Directory
import System.FilePath (dropTrailingPathSeparator, takeDirectory, takeFileName, (</>))
import System.IO (IOMode (..), hClose, openBinaryTempFileWithDefaultPermissions, withBinaryFile)
import System.IO.Error (ioeGetErrorString, isDoesNotExistError, isPermissionError)

import Ending

-- | A file's bytes; at most 256 MiB.
readBytes :: FilePath -> IO ByteString
readBytes = readBytesUpTo (256 * 1024 * 1024)

-- | A file's bytes, if there are not more than so many; otherwise leaves with status 2.
readBytesUpTo :: Int -> FilePath -> IO ByteString
readBytesUpTo limit file = do
  isFolder <- doesDirectoryExist file
  when isFolder (unusable (file ++ " is a folder; a file is needed here"))
  outcome <- try (withBinaryFile file ReadMode readIt)
  either (unusable . readMessage file) (maybe (unusable tooLarge) pure) outcome
  where
    -- The size is not asked for beforehand, so that pipes can be read too.
    readIt handle = do
      bytes <- Lazy.hGet handle (limit + 1)
      pure (if Lazy.length bytes > fromIntegral limit then Nothing else Just (Lazy.toStrict bytes))
    tooLarge = file ++ " is larger than " ++ show (limit `div` (1024 * 1024)) ++ " MiB, which no input of this kind needs"

readMessage :: FilePath -> IOException -> String
readMessage file problem
  | isDoesNotExistError problem = "there is no file " ++ file
  | isPermissionError problem = "no permission to read " ++ file
  | otherwise = "cannot read " ++ file ++ ": " ++ ioeGetErrorString problem

-- | Write a file whole or not at all: beside it first, then renamed.
writeWhole :: FilePath -> Lazy.ByteString -> IO ()
writeWhole file bytes = do
  outcome <- try (bracketOnError (openBinaryTempFileWithDefaultPermissions (takeDirectory file) (takeFileName file)) discard writeIt)
  either (unusable . writeMessage file) pure outcome
  where
    writeIt (temporary, handle) = do
      Lazy.hPut handle bytes
      hClose handle
      renameFile temporary file
    discard (temporary, handle) = hClose handle >> removeFile temporary

-- | Leave with status 2 if a file cannot be written there, before the work that would be lost; nothing stays behind.
orUnwritable :: FilePath -> IO ()
orUnwritable file = do
  isFolder <- doesDirectoryExist file
  when isFolder (unusable (file ++ " is a folder; a file is needed here"))
  outcome <- try (openBinaryTempFileWithDefaultPermissions (takeDirectory file) (takeFileName file) >>= \(temporary, handle) -> hClose handle >> removeFile temporary)
  either (unusable . writeMessage file) pure outcome

-- | Write a new folder with these files, whole or not at all. Refuses a folder that is there and not empty.
writeFolder :: FilePath -> [(FilePath, ByteString)] -> IO ()
writeFolder path files = do
  taken <- doesPathExist folder
  if taken then refuseUnlessEmpty else pure ()
  outcome <- try $ do
    createDirectoryIfMissing True parent
    let building = parent </> ("." ++ takeFileName folder ++ ".part")
    removePathForcibly building
    createDirectory building
    forM_ files (\(name, bytes) -> Bytes.writeFile (building </> name) bytes)
    when taken (removeDirectory folder)
    renameDirectory building folder
  either (unusable . writeMessage folder) pure outcome
  where
    folder = dropTrailingPathSeparator path
    parent = takeDirectory folder
    refuseUnlessEmpty = do
      isFolder <- doesDirectoryExist folder
      unless isFolder (unusable (folder ++ " is a file; name a folder that is new or empty"))
      content <- try (listDirectory folder) :: IO (Either IOException [FilePath])
      case content of
        Right [] -> pure ()
        Right _ -> unusable (folder ++ " is not empty; name a folder that is new or empty")
        Left problem -> unusable (readMessage folder problem)

writeMessage :: FilePath -> IOException -> String
writeMessage file problem
  | isPermissionError problem = "no permission to write " ++ file
  | isDoesNotExistError problem = "cannot write " ++ file ++ ": its folder does not exist"
  | otherwise = "cannot write " ++ file ++ ": " ++ ioeGetErrorString problem
