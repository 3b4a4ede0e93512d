-- | A store in an SQLite file.
module PraTactile.Store.Sqlite
  ( sqlite,
    meaningInSqlite,
  )
where

import Control.Exception (SomeException, fromException, onException)
import Control.Monad (unless, void, when)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Logger (runNoLoggingT)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT (..), runExceptT, throwE, withExceptT)
import Data.Foldable (for_)
import Data.Functor.Identity (Identity (..))
import Data.List (intercalate)
import Data.Text (Text)
import qualified Data.Text as Text
import Database.Persist.Sql
import Database.Persist.Sqlite
  ( SqliteConnectionInfo,
    extraPragmas,
    mkSqliteConnectionInfo,
    walEnabled,
    withSqliteConnInfo,
  )
import Database.Sqlite (Error (..), SqliteException (..))
import PraTactile.Store.Backend
import PraTactile.Store.Error
import PraTactile.Store.Guard
import PraTactile.Store.Query (Query)
import PraTactile.Store.Rows
import PraTactile.Store.Schema
import PraTactile.Store.Target
import System.Directory (doesDirectoryExist, doesPathExist, getFileSize, renameFile)
import System.FilePath (isRelative, (</>))
import System.IO (IOMode (..), SeekMode (..), hGetChar, hSeek, withBinaryFile)
import System.Posix.Types (DeviceID, FileID)

-- | The database in the file with this path.
sqlite :: FilePath -> Backend
sqlite path = backend
  where
    backend =
      Backend
        { backendName = path,
          connected = \action -> checkFile path >> answering backend (withFile' path action),
          meaningOf = meaningInSqlite,
          columnsOf = \table ->
            ask ("SELECT name FROM pragma_table_info('" ++ table ++ "') ORDER BY cid"),
          integrity = do
            verdict <- ask "PRAGMA integrity_check"
            -- SQLite reads the missing end of a cut file as zeros, which make an empty page.
            whole <- product . concat <$> traverse ask ["PRAGMA page_count", "PRAGMA page_size"]
            size <- liftIO (getFileSize path)
            unless (take 1 verdict == [Text.pack "ok"] && size >= toInteger (whole :: Int)) $
              throwE (DamagedFile path BrokenPages),
          valuesTyped = typedIn path,
          prepareWriting = do
            before <- identityOf path
            pure (beginWriting path (== before)),
          makeFormer = lift (void (runMigrationQuiet migrateFormer)),
          holdsText = const True,
          putRows = putFile path
        }

-- | Begins a transaction that excludes other writers, if the file's identity passes the test.
beginWriting :: FilePath -> (Maybe (DeviceID, FileID) -> Bool) -> Query IO ()
beginWriting path same = do
  lift (mapM_ ((`rawExecute` []) . Text.pack) ["COMMIT", "BEGIN IMMEDIATE"])
  now <- liftIO (identityOf path)
  unless (same now) (throwE (CannotWrite path InUse))

-- | Writes a store to a new path or over an old store, also through a link. The rows go first to a
-- file beside it, with @.part@ appended to the name, which is renamed when complete.
putFile :: FilePath -> Rows -> ExceptT StoreError IO ()
putFile path rows = do
  unless (speakable path) (throwE (CannotWrite path NameNotText))
  file <- target isStore path
  let part = partOf file
  unless (speakable part) (throwE (CannotWrite path NameNotText))
  clearPart part
  withExceptT
    (CannotWrite path . failureIn)
    (guarded meaningInSqlite (written part file))
  where
    written part file = (fill part >> renameFile part file) `onException` discardPart part
    fill part =
      withFile' part . runSqlConn $
        runMigrationQuiet (migrateAll >> migrateFormer) >> insertRows rows

-- | Whether a regular file is a store of any version. It is not opened as a database if that could
-- change it: if it is in SQLite's write-ahead mode or has a journal beside it. A store has neither.
isStore :: FilePath -> IO Bool
isStore path = do
  begins <- beginsAsDatabase path
  journal <- doesPathExist (path ++ "-journal")
  if begins /= Right (Just True) || journal || not (speakable path)
    then pure False
    else either (const False) id <$> runExceptT (guarded meaningInSqlite (unchanged >>= asked))
  where
    unchanged = withBinaryFile path ReadMode $ \handle -> do
      hSeek handle AbsoluteSeek 18
      (== "\1\1") <$> sequence [hGetChar handle, hGetChar handle]
    asked False = pure False
    asked True = do
      tables <-
        withFile' path . runSqlConn $
          rawSql (Text.pack "SELECT name FROM sqlite_master WHERE type = 'table'") []
      pure (all (`elem` map unSingle tables) everyVersion)
    -- The tables that stores of every version have.
    everyVersion = Text.words (Text.pack "metadata object vertex face corner edge laying")

checkFile :: FilePath -> ExceptT StoreError IO ()
checkFile path = do
  directory <- liftIO (doesDirectoryExist path)
  when directory (throwE (IsDirectory path))
  there <- liftIO (doesPathExist path)
  unless (there && speakable path) (throwE (NoSuchFile path))
  -- Otherwise a pipe would block, and a device would be read.
  regular <- liftIO (isRegular path)
  unless regular (throwE (NotADatabase path))
  begins <- withExceptT (CannotRead path . failureOf) (ExceptT (beginsAsDatabase path))
  unless (begins == Just True) (throwE (NotADatabase path))

-- | Checks the types of all values, because SQLite holds any type in any column and the binding
-- rounds numbers.
typedIn :: FilePath -> Query IO ()
typedIn path = for_ parts $ \part -> do
  foreigners <-
    ask
      ( "SELECT COUNT(*) FROM "
          ++ partName part
          ++ " WHERE "
          ++ intercalate " OR " (map typed (partColumns part))
      )
  unless (foreigners == [0 :: Int]) (throwE (DamagedFile path ForeignValue))
  where
    typed :: (Text, SqlType) -> String
    typed (column, kind) =
      "typeof(" ++ Text.unpack column ++ ") NOT IN ('null', '"
        ++ (if kind == SqlString then "text" else "integer")
        ++ "')"

-- Without logging of statements and without a write-ahead log, so the store is a single file.
withFile' :: FilePath -> (SqlBackend -> IO a) -> IO a
withFile' path action = runNoLoggingT (withSqliteConnInfo (connection path) (liftIO . action))

connection :: FilePath -> SqliteConnectionInfo
connection path =
  runIdentity
    ( walEnabled (const (Identity False)) (mkSqliteConnectionInfo (Text.pack plain))
        >>= extraPragmas (const (Identity [Text.pack "PRAGMA busy_timeout = 10000"]))
    )
  where
    -- so that no file name is special for SQLite: @:memory:@, @file:...@
    plain = if isRelative path then "." </> path else path

-- Whether the file name can be passed to the database.
speakable :: FilePath -> Bool
speakable path = Text.unpack (Text.pack path) == path && '\0' `notElem` path

-- Note [SQLite's error codes] The binding calls SQLite's code 26, "not a database",
-- ErrorNotAConnection. It exchanges the codes 11, "corrupt", and 12, "not found". For an unknown
-- code it throws an ErrorCall. No statement here can be "not found", so both count as damage. Code
-- 1 means that a statement does not fit the tables.

-- | The meaning of an exception of SQLite.
meaningInSqlite :: SomeException -> Maybe Objection
meaningInSqlite = fmap (ofCode . seError) . fromException

ofCode :: Error -> Objection
ofCode code = case code of
  ErrorCorrupt -> Damaged BrokenPages
  ErrorNotFound -> Damaged BrokenPages
  ErrorNotAConnection -> Damaged BrokenPages
  ErrorFormat -> Damaged BrokenPages
  ErrorMismatch -> Damaged ForeignValue
  ErrorError -> Unknown
  ErrorBusy -> Failed InUse
  ErrorLocked -> Failed InUse
  ErrorPermission -> Failed NotPermitted
  ErrorReadOnly -> Failed NotPermitted
  ErrorAuthorization -> Failed NotPermitted
  ErrorFull -> Failed NoRoom
  ErrorNoMemory -> Failed NoRoom
  ErrorCan'tOpen -> Failed NoFolder
  _ -> Failed SystemRefuses
