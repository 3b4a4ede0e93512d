{-# LANGUAGE DerivingStrategies #-}

-- | Objects, faces and their place on the array as a relational database in a file: \"the mapping of the winged-edge
-- object models to the encoding PRA is implemented as a relational database\" (section II.B of the paper). The tables
-- ("PraTactile.Store.Schema") and the look-ups ("PraTactile.Store.Query") suit every SQL back end of persistent; only
-- this module knows that the file is SQLite's.
module PraTactile.Store
  ( -- * Making a store
    create
    -- * Opening a store
  , Store
  , withStore
  , storedProfile
  , storedPlacement
    -- * Look-ups
  , storedWhereabouts
  , storedPosition
    -- * What can go wrong
  , StoreError (..)
    -- * Tables
  , schemaVersion
  ) where

import Control.Exception (ErrorCall, Handler (..), IOException, SomeException, catches, onException, throwIO, try)
import Control.Monad (unless, when)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Logger (runNoLoggingT)
import Control.Monad.Trans.Except (ExceptT (..), except, runExceptT, throwE, withExceptT)
import Control.Monad.Trans.Reader (ReaderT)
import Data.Bifunctor (first)
import Data.Foldable (for_)
import Data.Functor.Identity (Identity (..))
import Data.Text (Text)
import qualified Data.Text as Text
import Database.Persist.Sql (PersistException, Single (..), SqlBackend, rawSql, runMigrationQuiet, runSqlConn)
import Database.Persist.Sqlite (SqliteConnectionInfo, mkSqliteConnectionInfo, walEnabled, withSqliteConnInfo)
import Database.Sqlite (Error (..), SqliteException (..))
import System.Directory (doesDirectoryExist, doesFileExist, removeFile, renameFile)
import System.FilePath (isRelative, takeDirectory, takeFileName, (</>))
import System.IO (IOMode (..), hClose, hGetChar, openBinaryTempFileWithDefaultPermissions, withBinaryFile)
import System.IO.Error (ioeGetErrorString, isEOFError, isUserError)

import PraTactile.Array (Position, Shape)
import PraTactile.Object.Placement
import PraTactile.Object.Relation (placementOf, relation)
import PraTactile.Store.Error
import PraTactile.Store.Query
import PraTactile.Store.Rows
import PraTactile.Store.Schema (migrateAll, schemaVersion)

-- | An open store, good while 'withStore' runs.
data Store = Store
  { storeFile :: FilePath
  , storeBackend :: SqlBackend
  , storedProfile :: String
    -- ^ the text of the profile that the store was made for
  , storedPlacement :: Placement
    -- ^ the placement that the store's rows describe
  }

-- | Write a placement to a file, with the text of the profile it belongs to. A file that is there already is replaced,
-- whole or not at all: the rows go to another file beside it, which takes its name once it is complete.
create :: FilePath -> String -> Placement -> IO (Either StoreError ())
create path profile place = runExceptT $ do
  rows <- except (toRows profile (relation place))
  directory <- liftIO (doesDirectoryExist path)
  when directory (throwE (IsDirectory path))
  unless (speakable path) (throwE (CannotWrite path "the file's name is not valid text"))
  withExceptT (CannotWrite path . reason) (guarded (written rows))
  where
    written rows = do
      (part, handle) <- openBinaryTempFileWithDefaultPermissions (takeDirectory path) (takeFileName path ++ ".part")
      fill part handle rows `onException` removeFile part
    fill part handle rows = do
      hClose handle
      withBackend part (runSqlConn (runMigrationQuiet migrateAll >> insertRows rows))
      renameFile part path

-- | Open a store, check that its file is whole, that its tables are of this version, that it was made for the profile
-- expected (if one is), and that its rows make a placement ('placementOf'), and go on with it. Exceptions of what goes on
-- pass through; the file's own faults are answers.
withStore :: FilePath -> Maybe String -> (Store -> IO a) -> IO (Either StoreError a)
withStore path expected action = do
  outcome <- runExceptT $ do
    checkFile path
    asking path $ withBackend path $ \backend ->
      runExceptT (open path expected backend) >>= traverse (try . action)
  case outcome of
    Left fault -> pure (Left fault)
    Right (Left fault) -> pure (Left fault)
    Right (Right (Left exception)) -> throwIO (exception :: SomeException)
    Right (Right (Right result)) -> pure (Right result)

checkFile :: FilePath -> ExceptT StoreError IO ()
checkFile path = do
  directory <- liftIO (doesDirectoryExist path)
  when directory (throwE (IsDirectory path))
  there <- liftIO (doesFileExist path)
  unless (there && speakable path) (throwE (NoSuchFile path))
  withExceptT unreadable (ExceptT (try (withBinaryFile path ReadMode (for_ magic . expect))))
  where
    magic = "SQLite format 3\0"
    expect handle letter = do
      found <- hGetChar handle
      unless (found == letter) (ioError (userError "not a database"))
    unreadable fault
      | isEOFError fault || isUserError fault = NotADatabase path
      | otherwise = CannotRead path (ioeGetErrorString fault)

open :: FilePath -> Maybe String -> SqlBackend -> ExceptT StoreError IO Store
open path expected backend = do
  verdict <- ask "PRAGMA integrity_check"
  for_ (take 1 (filter (/= Text.pack "ok") verdict)) (throwE . DamagedFile path . oneLine)
  tables <- ask "SELECT name FROM sqlite_master WHERE type = 'table' AND name = 'metadata'"
  when (null (tables :: [Text])) (throwE (NotAStore path))
  versions <- ask "SELECT schema_version FROM metadata"
  for_ (take 1 (filter (/= schemaVersion) versions)) (throwE . (`WrongSchemaVersion` schemaVersion))
  rows <- asking path (runSqlConn selectRows backend)
  (profile, given) <- except (fromRows rows)
  for_ expected $ \wanted -> unless (profile == wanted) (throwE (ForeignProfile profile wanted))
  Store path backend profile <$> except (first InconsistentRows (placementOf given))
  where
    ask sql = map unSingle <$> asking path (runSqlConn (rawSql (Text.pack sql) []) backend)
    oneLine = unwords . lines . Text.unpack

-- | Where the window of the given shape at the given position is, by the database alone; as 'whereabouts' answers.
storedWhereabouts :: Store -> Shape -> Position -> IO (Either StoreError Whereabouts)
storedWhereabouts store window at = query store (selectWhereabouts (placementShape (storedPlacement store)) window at)

-- | Where on the array a cell of a face's block lies, by the database alone; as 'arrayPosition' answers.
storedPosition :: Store -> Face -> Position -> IO (Either StoreError Position)
storedPosition store face cell = query store (selectPosition face cell)

query :: Store -> ReaderT SqlBackend IO (Either StoreError a) -> IO (Either StoreError a)
query store statements =
  runExceptT (asking (storeFile store) (runSqlConn statements (storeBackend store)) >>= except)

-- Statements are logged nowhere, and no write-ahead log is kept: the store is one file.
withBackend :: FilePath -> (SqlBackend -> IO a) -> IO a
withBackend path action = runNoLoggingT (withSqliteConnInfo (connection path) (liftIO . action))

connection :: FilePath -> SqliteConnectionInfo
connection path = runIdentity (walEnabled (const (Identity False)) (mkSqliteConnectionInfo (Text.pack plain)))
  where
    -- so that no file's name is one of SQLite's own: @:memory:@, @file:...@
    plain = if isRelative path then "." </> path else path

-- Whether the database can be told the file's name.
speakable :: FilePath -> Bool
speakable path = Text.unpack (Text.pack path) == path && '\0' `notElem` path

-- What the database or the system objects, as they put it.
data Objection
  = Damaged String
  | Failed String
  | System String

reason :: Objection -> String
reason (Damaged why) = why
reason (Failed why) = why
reason (System why) = why

-- Note [SQLite's error codes]
-- The binding calls SQLite's code 26, "not a database", ErrorNotAConnection; it takes the codes 11, "corrupt", and 12,
-- "not found", for each other; and on a code that it does not know it throws an ErrorCall. Nothing asked here can be
-- "not found", so both count as damage.
guarded :: IO a -> ExceptT Objection IO a
guarded action = ExceptT $ (Right <$> action) `catches`
  [ Handler $ \fault -> pure . Left $
      (if seError fault `elem` [ErrorCorrupt, ErrorNotFound, ErrorNotAConnection] then Damaged else Failed) (saying fault)
  , Handler $ \fault -> pure (Left (Damaged (show (fault :: PersistException))))
  , Handler $ \fault -> pure (Left (Failed (show (fault :: ErrorCall))))
  , Handler $ \fault -> pure . Left $
      (if isUserError fault then Damaged else System) (ioeGetErrorString (fault :: IOException))
  ]
  where saying = Text.unpack . Text.dropWhile (`elem` ": ") . seDetails

asking :: FilePath -> IO a -> ExceptT StoreError IO a
asking path = withExceptT objection . guarded
  where
    objection (Damaged why) = DamagedFile path why
    objection (Failed why) = DatabaseFailed why
    objection (System why) = CannotRead path why
