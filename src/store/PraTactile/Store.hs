-- | Objects, faces and their place on the array as a relational database in a file: \"the mapping
-- of the winged-edge object models to the encoding PRA is implemented as a relational database\"
-- (section II.B of the paper). The tables ("PraTactile.Store.Schema") and the look-ups
-- ("PraTactile.Store.Query") suit every SQL back end of persistent; only this module knows that the
-- file is SQLite's.
module PraTactile.Store
  ( -- * Making a store
    create,

    -- * Opening a store
    Store,
    withStore,
    storedProfile,
    storedPlacement,

    -- * Look-ups
    storedWhereabouts,
    storedPosition,

    -- * What can go wrong
    StoreError (..),
    Damage (..),
    Failure (..),
    Occupant (..),

    -- * Tables
    schemaVersion,
  )
where

import Control.Exception (SomeException, onException, throwIO, try)
import Control.Monad (unless, when)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Logger (runNoLoggingT)
import Control.Monad.Trans.Except (ExceptT (..), except, runExceptT, throwE, withExceptT)
import Control.Monad.Trans.Reader (ReaderT)
import Data.Bifunctor (first)
import Data.Foldable (for_)
import Data.Functor.Identity (Identity (..))
import Data.List (intercalate)
import Data.Text (Text)
import qualified Data.Text as Text
import Database.Persist.Sql (Single (..), SqlBackend, rawSql, runMigrationQuiet, runSqlConn)
import Database.Persist.Sqlite
  ( SqliteConnectionInfo,
    mkSqliteConnectionInfo,
    walEnabled,
    withSqliteConnInfo,
  )
import PraTactile.Array (Position, Shape)
import PraTactile.Object.Placement
import PraTactile.Object.Relation (placementOf, relation)
import PraTactile.Store.Contents (isSealed, sealed)
import PraTactile.Store.Error
import PraTactile.Store.Guard
import PraTactile.Store.Query
import PraTactile.Store.Rows
import PraTactile.Store.Rows.Read
import PraTactile.Store.Rows.Write
import PraTactile.Store.Schema (migrateAll, schemaVersion, tableColumns, textColumns)
import PraTactile.Store.Target
import System.Directory (doesDirectoryExist, doesPathExist, renameFile)
import System.FilePath (isRelative, (</>))
import System.IO (IOMode (..), SeekMode (..), hGetChar, hSeek, withBinaryFile)

-- | An open store, good while 'withStore' runs.
data Store = Store
  { storeFile :: FilePath,
    storeBackend :: SqlBackend,
    -- | the text of the profile that the store was made for
    storedProfile :: String,
    -- | the placement that the store's rows describe
    storedPlacement :: Placement
  }

-- | Write a placement to a file, with the text of the profile it belongs to. The path is a new
-- name, or that of a store, perhaps through a link, which is replaced, whole or not at all: the
-- rows go to a file beside it, named likewise with @.part@ after it, which takes its name once it
-- is complete. Anything else that is there is refused and stays.
create :: FilePath -> String -> Placement -> IO (Either StoreError ())
create path profile place = runExceptT $ do
  rows <- except (sealed <$> toRows profile (relation place))
  unless (speakable path) (throwE (CannotWrite path NameNotText))
  file <- target isStore path
  let part = partOf file
  unless (speakable part) (throwE (CannotWrite path NameNotText))
  clearPart part
  withExceptT (CannotWrite path . failureIn) (guarded (written rows part file))
  where
    written rows part file = (fill rows part >> renameFile part file) `onException` discardPart part
    fill rows part = withBackend part (runSqlConn (runMigrationQuiet migrateAll >> insertRows rows))

-- | Whether a regular file is a store, of whatever version. It is not opened as a database if that
-- could change it: when it is in SQLite's write-ahead mode, or has a journal beside it, neither of
-- which a store has.
isStore :: FilePath -> IO Bool
isStore path = do
  begins <- beginsAsDatabase path
  journal <- doesPathExist (path ++ "-journal")
  if begins /= Right (Just True) || journal || not (speakable path)
    then pure False
    else
      either (const False) id
        <$> runExceptT
          ( guarded
              ( do
                  modes <- withBinaryFile path ReadMode $ \handle -> do
                    hSeek handle AbsoluteSeek 18
                    sequence [hGetChar handle, hGetChar handle]
                  if modes /= "\1\1"
                    then pure False
                    else do
                      tables <-
                        withBackend
                          path
                          ( runSqlConn
                              ( rawSql
                                  (Text.pack "SELECT name FROM sqlite_master WHERE type = 'table'")
                                  []
                              )
                          )
                      pure (all ((`elem` map unSingle tables) . fst) tableColumns)
              )
          )

-- | Open a store, check that its file is whole, that its tables are of this version, that it was
-- made for the profile expected (if one is), and that its rows make a placement ('placementOf'),
-- and go on with it. Exceptions of what goes on pass through; the file's own faults are answers.
withStore :: FilePath -> Maybe String -> (Store -> IO a) -> IO (Either StoreError a)
withStore path expected action = do
  outcome <- runExceptT $ do
    checkFile path
    asking path $
      withBackend path $ \backend ->
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
  there <- liftIO (doesPathExist path)
  unless (there && speakable path) (throwE (NoSuchFile path))
  -- A pipe would be waited for, and a device read from.
  regular <- liftIO (isRegular path)
  unless regular (throwE (NotADatabase path))
  begins <- withExceptT (CannotRead path . failureOf) (ExceptT (beginsAsDatabase path))
  unless (begins == Just True) (throwE (NotADatabase path))

open :: FilePath -> Maybe String -> SqlBackend -> ExceptT StoreError IO Store
open path expected backend = do
  verdict <- ask "PRAGMA integrity_check"
  unless (take 1 verdict == [Text.pack "ok"]) (throwE (DamagedFile path BrokenPages))
  tables <- ask "SELECT name FROM sqlite_master WHERE type = 'table' AND name = 'metadata'"
  when (null (tables :: [Text])) (throwE (NotAStore path))
  versions <- ask "SELECT schema_version FROM metadata" `orElse` NotAStore path
  for_ (take 1 (filter (/= schemaVersion) versions)) (throwE . (`WrongSchemaVersion` schemaVersion))
  -- SQLite takes the name of a column that is missing for a text, holds values of any type in any
  -- column, and the binding rounds numbers.
  for_ tableColumns $ \(name, columns) -> do
    there <- ask ("SELECT name FROM pragma_table_info('" ++ Text.unpack name ++ "') ORDER BY cid")
    unless (there == columns) (throwE (TablesDiffer path))
    let typeOf column = if column `elem` textColumns then "text" else "integer"
        typed column = "typeof(" ++ Text.unpack column ++ ") <> '" ++ typeOf column ++ "'"
    foreigners <-
      ask
        ( "SELECT COUNT(*) FROM "
            ++ Text.unpack name
            ++ " WHERE "
            ++ intercalate " OR " (map typed columns)
        )
    unless (foreigners == [0 :: Int]) (throwE (DamagedFile path ForeignValue))
  rows <- asking path (runSqlConn selectRows backend)
  (profile, given) <- except (fromRows rows)
  for_ expected $ \wanted -> unless (profile == wanted) (throwE (ForeignProfile profile wanted))
  place <- except (first InconsistentRows (placementOf given))
  unless (isSealed rows) (throwE ChangedRows)
  pure (Store path backend profile place)
  where
    ask sql = map unSingle <$> asking path (runSqlConn (rawSql (Text.pack sql) []) backend)
    orElse question other =
      withExceptT (\why -> if why == TablesDiffer path then other else why) question

-- | Where the window of the given shape at the given position is, by the database alone; as
-- 'whereabouts' answers.
storedWhereabouts :: Store -> Shape -> Position -> IO (Either StoreError Whereabouts)
storedWhereabouts store window at =
  query store (selectWhereabouts (placementShape (storedPlacement store)) window at)

-- | Where on the array a cell of a face's block lies, by the database alone; as 'arrayPosition'
-- answers.
storedPosition :: Store -> Face -> Position -> IO (Either StoreError Position)
storedPosition store face cell = query store (selectPosition face cell)

query :: Store -> ReaderT SqlBackend IO (Either StoreError a) -> IO (Either StoreError a)
query store statements =
  runExceptT (asking (storeFile store) (runSqlConn statements (storeBackend store)) >>= except)

-- Statements are logged nowhere, and no write-ahead log is kept: the store is one file.
withBackend :: FilePath -> (SqlBackend -> IO a) -> IO a
withBackend path action = runNoLoggingT (withSqliteConnInfo (connection path) (liftIO . action))

connection :: FilePath -> SqliteConnectionInfo
connection path =
  runIdentity (walEnabled (const (Identity False)) (mkSqliteConnectionInfo (Text.pack plain)))
  where
    -- so that no file's name is one of SQLite's own: @:memory:@, @file:...@
    plain = if isRelative path then "." </> path else path

-- Whether the database can be given the file's name.
speakable :: FilePath -> Bool
speakable path = Text.unpack (Text.pack path) == path && '\0' `notElem` path

asking :: FilePath -> IO a -> ExceptT StoreError IO a
asking path = withExceptT objection . guarded
  where
    objection (Damaged damage) = DamagedFile path damage
    objection Unknown = TablesDiffer path
    objection (Failed failure) = DatabaseFailed failure
