-- | Where output goes, decided in one place for every command. A regular file is replaced whole or
-- not at all and keeps its mode; a link is followed; a device or a FIFO is written to as it is; @-@
-- is the standard output. What cannot be written is one line and status 2. Until it is whole, a
-- file is called NAME.part; what a run that was ended leaves there is used up by the next one.
-- Files that a next run continues are written in place instead ('writtenAfter'). A
-- folder is made whole in one of the run's own beside it, so that several runs do not meet.
module Output
  ( -- * Files
    writeWhole,
    orUnwritable,
    orUnwritableAmong,
    writtenTo,
    writtenAfter,
    sayBeside,
    sayWritten,
    leadsToStandardOutput,
    Target (..),
    targetOf,

    -- * Folders
    writeFolder,
    orTaken,

    -- * Complaints
    writeMessage,
  )
where

import Control.Exception (IOException, bracket, finally, onException, try)
import Control.Monad (forM_, unless, void, when)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_, traverse_)
import Data.List (nub, (\\))
import Data.Maybe (listToMaybe)
import ExitStatus
import GHC.IO.Handle (LockMode (..), hTryLock)
import GHC.IO.Handle.Lock (hUnlock)
import Interrupt
import System.Directory
import System.FilePath (dropTrailingPathSeparator, isRelative, takeDirectory, (</>))
import System.IO
import System.IO.Error
  ( doesNotExistErrorType,
    ioeSetErrorString,
    isDoesNotExistError,
    isPermissionError,
    mkIOError,
  )
import System.Posix.Files
import System.Posix.IO (stdOutput)
import System.Posix.Temp (mkdtemp)
import System.Posix.Types (FileMode)
import System.Posix.User (getEffectiveUserID)
import Visible (visibleName)

-- | The target of an output name.
data Target
  = StandardOutput
  | -- | a device or a FIFO: written to as it is
    Stream FilePath
  | -- | a regular file, links resolved: replaced whole, or new
    Regular FilePath (Maybe FileStatus)

-- | The target of a name; 'Left' with the complaint if nothing can be written there.
targetOf :: FilePath -> IO (Either String Target)
targetOf "-" = pure (Right StandardOutput)
targetOf name = either (Left . writeMessage name) id <$> try (resolved name >>= classified)
  where
    classified file = do
      there <- doesPathExist file
      if not there
        then pure (Right (Regular file Nothing))
        else do
          status <- getFileStatus file
          mayWrite <- fileAccess file False True False
          standard <- isStandardOutput status
          pure $ case () of
            _
              | standard -> Right StandardOutput
              | isRegularFile status,
                not mayWrite ->
                Left ("no permission to write " ++ visibleName name)
              | isRegularFile status -> Right (Regular file (Just status))
              | isDirectory status ->
                Left (visibleName name ++ " is a folder; a file is needed here")
              | isSocket status ->
                Left (visibleName name ++ " is a socket, which cannot be written to as a file")
              | otherwise -> Right (Stream file)

-- | Whether this file is the standard output, under any name.
isStandardOutput :: FileStatus -> IO Bool
isStandardOutput status = either none same <$> try (getFdStatus stdOutput)
  where
    same own = (deviceID own, fileID own) == (deviceID status, fileID status)
    none :: IOException -> Bool
    none _ = False

-- | The name at the end of a chain of symbolic links, which need not lead to anything.
resolved :: FilePath -> IO FilePath
resolved = go (40 :: Int)
  where
    go 0 file =
      ioError
        ( mkIOError doesNotExistErrorType "" Nothing (Just file)
            `ioeSetErrorString` "its links go round in a ring"
        )
    go steps file = do
      isLink <-
        either (const False) id <$> (try (pathIsSymbolicLink file) :: IO (Either IOException Bool))
      -- What the system itself keeps behind a link, such as an open descriptor, need have no name.
      direct <- if isLink then opensAsItIs file else pure True
      if direct
        then pure file
        else do
          next <- getSymbolicLinkTarget file
          go (steps - 1) (if isRelative next then takeDirectory file </> next else next)
    opensAsItIs file = do
      found <- try (getFileStatus file) :: IO (Either IOException FileStatus)
      pure
        (either (const False) (\status -> not (isRegularFile status || isDirectory status)) found)

-- | Write the bytes to where the name says, whole or not at all where that is a file; leaves with
-- status 2 if that cannot be done.
writeWhole :: FilePath -> Lazy.ByteString -> IO ()
writeWhole name bytes = writtenTo name (`Lazy.hPut` bytes)

-- | Write to where the name says by an action on a handle, whole or not at all for a file; leaves
-- with status 2 if that fails.
writtenTo :: FilePath -> (Handle -> IO a) -> IO a
writtenTo name write = do
  target <- targetOf name >>= orUnusable id
  case target of
    -- The end of the program reports errors of the standard output.
    StandardOutput -> write stdout <* hFlush stdout
    Stream file -> guarded (bracket (openBinaryFile file WriteMode) hClose write)
    Regular file status -> guarded $ do
      (part, handle) <- openPart name file
      -- Closing a handle whose last bytes could not be written fails once more.
      let discard = removeFile part >> void (try (hClose handle) :: IO (Either IOException ()))
      result <-
        (mapM_ (keepingMode part) status >> write handle <* closed handle) `onException` discard
      renameFile part file `onException` removeFile part
      pure result
  where
    guarded action = try action >>= either (unusable . writeMessage name) pure
    -- Programs started in the meantime would keep the lock.
    closed handle = hFlush handle >> hUnlock handle >> hClose handle

-- | Continue a regular file, given its size and the number of bytes to keep: truncate it to these,
-- and write after them. Leaves with status 2 if another run is writing it. Anything but a regular
-- file is written to directly.
writtenAfter :: FilePath -> (Int, Int) -> (Handle -> IO a) -> IO a
writtenAfter name (size, kept) write = do
  target <- targetOf name >>= orUnusable id
  case target of
    Regular file _ -> do
      outcome <- try $
        withBinaryFile file ReadWriteMode $ \handle -> do
          ours <- hTryLock handle ExclusiveLock
          now <- hFileSize handle
          unless (ours && now == toInteger size) . unusable $
            "another run is writing " ++ visibleName name
          hSetFileSize handle (toInteger kept)
          hSeek handle SeekFromEnd 0
          (write handle <* hFlush handle) `finally` hUnlock handle
      either (unusable . writeMessage name) pure outcome
    _ -> writtenTo name write

-- | Print a notice about a written file: on the standard output, or on the standard error if the
-- file is the standard output.
sayBeside :: FilePath -> String -> IO ()
sayBeside name text = do
  standard <- leadsToStandardOutput name
  hPutStr (if standard then stderr else stdout) text

-- | Whether this name leads to the standard output.
leadsToStandardOutput :: FilePath -> IO Bool
leadsToStandardOutput "-" = pure True
leadsToStandardOutput name =
  either none id <$> try (doesPathExist name >>= \there -> if there then same else pure False)
  where
    same = getFileStatus name >>= isStandardOutput
    none :: IOException -> Bool
    none _ = False

-- | Say on the standard output that a file was written, and what is in it; nothing where the file
-- is the standard output.
sayWritten :: FilePath -> String -> IO ()
sayWritten name content = do
  standard <- leadsToStandardOutput name
  unless standard (putStrLn ("wrote " ++ visibleName name ++ content))

-- | The file beside it that will take its name, empty, and only ours while it is open.
openPart :: FilePath -> FilePath -> IO (FilePath, Handle)
openPart name file = do
  inTheWay <-
    either (const False) (not . isRegularFile)
      <$> (try (getSymbolicLinkStatus part) :: IO (Either IOException FileStatus))
  when
    inTheWay
    ( unusable
        ( "cannot write " ++ visibleName name
            ++ (": " ++ visibleName part ++ " is in the way; remove it")
        )
    )
  handle <- openBinaryFile part ReadWriteMode
  ours <- hTryLock handle ExclusiveLock
  unless ours (unusable ("another run is writing " ++ visibleName name))
  still <- doesPathExist part
  -- It was given its name by another run since it was opened.
  if still
    then hSetFileSize handle 0 >> pure (part, handle)
    else hClose handle >> openPart name file
  where
    part = file ++ ".part"

-- | Give a file the mode of another one, and its owner if that is permitted.
keepingMode :: FilePath -> FileStatus -> IO ()
keepingMode part status = do
  user <- getEffectiveUserID
  when (user == 0) (setOwnerAndGroup part (fileOwner status) (fileGroup status))
  setFileMode part (fileMode status `intersectFileModes` permissions)
  where
    permissions = 0o7777 :: FileMode

-- | Leave with status 2 if something cannot be written to where these names say, or two of them say
-- the same, before the work that would be lost; nothing stays behind.
orUnwritableAmong :: [FilePath] -> IO ()
orUnwritableAmong names = do
  places <- traverse (\name -> if name == "-" then pure name else canonicalizePath name) names
  for_ (listToMaybe (places \\ nub places)) $ \twice ->
    misused
      ( "two outputs go to "
          ++ if twice == "-" then "the standard output" else visibleName twice
      )
  traverse_ orUnwritable names

-- | Leave with status 2 if nothing can be written there, before the work that would be lost;
-- nothing stays behind.
orUnwritable :: FilePath -> IO ()
orUnwritable name = do
  target <- targetOf name >>= orUnusable id
  case target of
    Regular file _ -> do
      outcome <- try (openPart name file >>= \(part, handle) -> hClose handle >> removeFile part)
      either (unusable . writeMessage name) pure outcome
    _ -> pure ()

-- | Write a new folder with these files, whole or not at all. Refuses whatever is there, unless it
-- is an empty folder. Where several runs write the same folder, one does, and the others are
-- refused. Nothing else is left, but by a run that was killed.
writeFolder :: FilePath -> [(FilePath, ByteString)] -> IO ()
writeFolder path files = do
  orTaken path
  outcome <- try . endingInOrder $ do
    folder <- resolved asked
    createDirectoryIfMissing True (takeDirectory folder)
    bracket (mkdtemp (folder ++ ".part")) removePathForcibly $ \own -> do
      let building = own </> "whole"
      createDirectory building
      forM_ files (\(name, bytes) -> Bytes.writeFile (building </> name) bytes)
      there <- doesDirectoryExist folder
      when there (getFileStatus folder >>= keepingMode building)
      -- The system itself refuses to put it in the place of anything but an empty folder.
      renameDirectory building folder
  case outcome of
    Right () -> pure ()
    Left problem -> orTaken path >> unusable (writeMessage path problem)
  where
    asked = dropTrailingPathSeparator path

-- | Leave with status 2 if anything but an empty folder is there.
orTaken :: FilePath -> IO ()
orTaken path = do
  taken <-
    either (const False) (const True)
      <$> (try (getSymbolicLinkStatus asked) :: IO (Either IOException FileStatus))
  when taken refuseUnlessEmpty
  where
    asked = dropTrailingPathSeparator path
    needed = "; name a folder that is new or empty"
    refuseUnlessEmpty = do
      content <- try (listDirectory asked) :: IO (Either IOException [FilePath])
      isFolder <- doesDirectoryExist asked
      case content of
        Right [] -> pure ()
        Right _ -> unusable (visibleName path ++ " is not empty" ++ needed)
        Left problem
          | isFolder ->
            unusable ("cannot read " ++ visibleName path ++ ": " ++ systemReason problem)
          | otherwise -> unusable (visibleName path ++ " is not a folder" ++ needed)

-- | Why a file or folder cannot be written.
writeMessage :: FilePath -> IOException -> String
writeMessage name problem
  | isPermissionError problem && reason == "permission denied" =
    "no permission to write " ++ visibleName name
  | isDoesNotExistError problem && reason == "no such file or directory" =
    "cannot write " ++ visibleName name ++ ": its folder does not exist"
  | otherwise = "cannot write " ++ visibleName name ++ ": " ++ reason
  where
    reason = systemReason problem
