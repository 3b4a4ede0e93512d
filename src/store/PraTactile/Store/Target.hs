{-# OPTIONS_HADDOCK hide #-}

-- | The file to which a store may be written: a new name, or an old store, which is replaced. Any
-- other file stays as it is.
module PraTactile.Store.Target
  ( target,
    isRegular,
    identityOf,
    beginsAsDatabase,

    -- * Beside it
    partOf,
    clearPart,
    discardPart,
  )
where

import Control.Exception (IOException, try)
import Control.Monad (unless, when)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Trans.Except (ExceptT (..), throwE, withExceptT)
import Data.Foldable (for_)
import PraTactile.Store.Error
import PraTactile.Store.Guard (failureOf)
import System.Directory (canonicalizePath, removeFile)
import System.IO (IOMode (..), hGetChar, hIsEOF, withBinaryFile)
import System.IO.Error (isDoesNotExistError)
import System.Posix.Files
  ( FileStatus,
    deviceID,
    fileID,
    getFileStatus,
    getSymbolicLinkStatus,
    isDirectory,
    isRegularFile,
    isSymbolicLink,
  )
import System.Posix.Types (DeviceID, FileID)

-- | The file to write for a path: the path itself if nothing is there, or if the action recognises
-- a store there; for a link, its target under the same conditions. Refuses everything else. Devices
-- and pipes are not opened.
target :: (FilePath -> IO Bool) -> FilePath -> ExceptT StoreError IO FilePath
target isStore path = do
  itself <- status path (getSymbolicLinkStatus path)
  case itself of
    Nothing -> pure path
    Just entry -> do
      end <- status path (getFileStatus path) >>= maybe (throwE (Occupied path DanglingLink)) pure
      when (isDirectory end) (throwE (IsDirectory path))
      unless (isRegularFile end) (throwE (Occupied path NoRegularFile))
      file <- if isSymbolicLink entry then system path (canonicalizePath path) else pure path
      known <- liftIO (isStore file)
      unless known (throwE (Occupied path NoStore))
      pure file

-- | Whether the path, after links, is a regular file.
isRegular :: FilePath -> IO Bool
isRegular path = either nothing isRegularFile <$> try (getFileStatus path)
  where
    nothing :: IOException -> Bool
    nothing = const False

-- | The identity of the file at a path, if there is one.
identityOf :: FilePath -> IO (Maybe (DeviceID, FileID))
identityOf path = either nothing (\it -> Just (deviceID it, fileID it)) <$> try (getFileStatus path)
  where
    nothing :: IOException -> Maybe a
    nothing = const Nothing

-- | The status of a path; 'Nothing' if nothing is there.
status :: FilePath -> IO FileStatus -> ExceptT StoreError IO (Maybe FileStatus)
status path ask = do
  outcome <- liftIO (try ask)
  case outcome of
    Right found -> pure (Just found)
    Left fault
      | isDoesNotExistError fault -> pure Nothing
      | otherwise -> throwE (CannotWrite path (failureOf fault))

system :: FilePath -> IO a -> ExceptT StoreError IO a
system path = withExceptT (CannotWrite path . failureOf) . ExceptT . try

-- | Whether a file begins with the 16 bytes of every SQLite database; 'Nothing' if it is shorter
-- and agrees with them so far.
beginsAsDatabase :: FilePath -> IO (Either IOException (Maybe Bool))
beginsAsDatabase path = try (withBinaryFile path ReadMode (expect "SQLite format 3\0"))
  where
    expect [] _ = pure (Just True)
    expect (letter : others) handle = do
      ended <- hIsEOF handle
      if ended
        then pure Nothing
        else do
          found <- hGetChar handle
          if found == letter then expect others handle else pure (Just False)

-- | The name of the temporary file beside a store, which the next run finds again.
partOf :: FilePath -> FilePath
partOf = (++ ".part")

-- | Removes the temporary file of an interrupted run. Refuses anything else with its name. The
-- journal goes first, because SQLite would apply it to the next temporary file.
clearPart :: FilePath -> ExceptT StoreError IO ()
clearPart part = for_ (journalsOf part ++ [part]) $ \file -> do
  there <- status file (getSymbolicLinkStatus file)
  for_ there $ \entry -> do
    unless (isRegularFile entry) (throwE (Occupied file NoRegularFile))
    when (file == part) $ do
      begins <- withExceptT (CannotWrite file . failureOf) (ExceptT (beginsAsDatabase file))
      when (begins == Just False) (throwE (Occupied file NoStore))
    system file (removeFile file)

-- | Removes a temporary file that did not become a store.
discardPart :: FilePath -> IO ()
discardPart part = for_ (journalsOf part ++ [part]) (\file -> try (removeFile file) >>= ignored)
  where
    ignored :: Either IOException () -> IO ()
    ignored _ = pure ()

journalsOf :: FilePath -> [FilePath]
journalsOf file = map (file ++) ["-journal", "-wal", "-shm"]
