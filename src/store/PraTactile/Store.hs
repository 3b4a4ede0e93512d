-- | Objects, faces and their place on the array as a relational database in a file: \"the mapping
-- of the winged-edge object models to the encoding PRA is implemented as a relational database\"
-- (section II.B of the paper). The tables ("PraTactile.Store.Schema") and the look-ups
-- ("PraTactile.Store.Query") suit every SQL back end of persistent; only this module knows that the
-- file is SQLite's.
module PraTactile.Store
  ( -- * Making and changing a store
    create,
    change,

    -- * Opening a store
    Store,
    withStore,
    storedProfile,
    storedShape,
    storedPitch,
    storedPlacement,
    storedObjects,
    storedNear,

    -- * Look-ups
    storedWhereabouts,
    storedPosition,

    -- * What can go wrong
    StoreError (..),
    Damage (..),
    Failure (..),
    Occupant (..),
    Table (..),
    tableName,

    -- * Tables
    schemaVersion,
  )
where

import Control.Exception (SomeException, onException, throwIO, try)
import Control.Monad (unless, when)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Logger (runNoLoggingT)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT (..), except, runExceptT, throwE, withExceptT)
import Data.Bifunctor (first)
import Data.Foldable (for_)
import Data.Functor.Identity (Identity (..))
import Data.Int (Int64)
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
import PraTactile.Array (Position, Shape)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge (ObjectName)
import PraTactile.Store.Error
import PraTactile.Store.Guard
import PraTactile.Store.Older
import PraTactile.Store.Query
import PraTactile.Store.Rows
import PraTactile.Store.Rows.Read
import PraTactile.Store.Rows.Write
import PraTactile.Store.Schema
import PraTactile.Store.Target
import System.Directory (doesDirectoryExist, doesPathExist, renameFile)
import System.FilePath (isRelative, (</>))
import System.IO (IOMode (..), SeekMode (..), hGetChar, hSeek, withBinaryFile)

-- | An open store, good while 'withStore' runs.
data Store = Store
  { storeFile :: FilePath,
    -- | the text of the profile that the store was made for
    storedProfile :: String,
    -- | the rows and columns of the array
    storedShape :: Shape,
    -- | the distances between symbols
    storedPitch :: Pitch,
    storeContents :: Contents
  }

-- | What is asked.
data Contents
  = -- | the tables
    Tables SqlBackend
  | -- | what an older version held, which has been read
    Loaded Placement

-- | Write a placement to a file, with the text of the profile it belongs to. The path is a new
-- name, or that of a store, perhaps through a link, which is replaced, whole or not at all: the
-- rows go to a file beside it, named likewise with @.part@ after it, which takes its name once it
-- is complete. Anything else that is there is refused and stays.
create :: FilePath -> String -> Placement -> IO (Either StoreError ())
create path profile place = runExceptT $ do
  rows <- except (toRows profile (firstNumbers place) place)
  unless (speakable path) (throwE (CannotWrite path NameNotText))
  file <- target isStore path
  let part = partOf file
  unless (speakable part) (throwE (CannotWrite path NameNotText))
  clearPart part
  withExceptT (CannotWrite path . failureIn) (guarded (written rows part file))
  where
    written rows part file = (fill rows part >> renameFile part file) `onException` discardPart part
    fill rows part = withBackend part (runSqlConn (runMigrationQuiet migrateAll >> insertRows rows))

-- | Make the placement of a store another one, in one transaction, by a function of the placement
-- that it has. Objects and laid faces that stay keep their numbers,
-- and only rows that differ are written; nothing is where the function refuses. Another program
-- that is changing the store is waited for, up to ten seconds. A store of an older version is replaced,
-- whole or not at all, by one of this version.
change ::
  FilePath ->
  (Placement -> Either refusal Placement) ->
  IO (Either StoreError (Either refusal Placement))
change path function = runExceptT $ do
  checkFile path
  before <- liftIO (identityOf path)
  asking path (withBackend path (runSqlConn (runExceptT (changing before) >>= kept))) >>= except
  where
    changing before = do
      -- A transaction that no other program's changes can come into.
      lift (mapM_ ((`rawExecute` []) . Text.pack) ["COMMIT", "BEGIN IMMEDIATE"])
      now <- liftIO (identityOf path)
      unless (now == before) (throwE (CannotWrite path InUse))
      version <- schemaChecked path
      (profile, numbers, place, old) <- everything path version
      case function place of
        Left refusal -> pure (Left refusal)
        Right other -> do
          case old of
            Nothing -> ExceptT (liftIO (create path profile other))
            Just rows -> do
              new <- except (toRows profile (nextNumbers place numbers other) other)
              lift (changeRows rows new)
          pure (Right other)
    kept outcome = do
      case outcome of
        Right (Right _) -> pure ()
        _ -> transactionUndo
      pure outcome

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
                      pure (all (`elem` map unSingle tables) everyVersion)
              )
          )
  where
    -- The tables that stores of all versions have.
    everyVersion = Text.words (Text.pack "metadata object vertex face corner edge laying")

-- | Open a store, check that its tables are of a known version and that it was made for the profile
-- expected (if one is), and go on with it. Nothing else is read before it is asked for. Exceptions
-- of what goes on pass through; the file's own faults are answers.
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
  (profile, shape, between, contents) <-
    asked path backend $ do
      version <- schemaChecked path
      if version == schemaVersion
        then do
          sheet <- selectSheet
          shape <- except (shapeIn sheet)
          pure (Text.unpack (metadataProfile sheet), shape, pitchIn sheet, Tables backend)
        else do
          (profile, _, place, _) <- everything path version
          pure (profile, placementShape place, placementPitch place, Loaded place)
  for_ expected $ \wanted -> unless (profile == wanted) (throwE (ForeignProfile profile wanted))
  pure (Store path profile shape between contents)

-- | The version of the tables, which are those of that version; refuses what is no store.
schemaChecked :: FilePath -> Query IO Int64
schemaChecked path = do
  tables <- ask "SELECT name FROM sqlite_master WHERE type = 'table' AND name = 'metadata'"
  when (null (tables :: [Text])) (throwE (NotAStore path))
  columns <- columnsOf "metadata"
  unless (Text.pack "schema_version" `elem` columns) (throwE (NotAStore path))
  versions <- ask "SELECT MAX(schema_version) FROM metadata"
  case versions of
    [Just version]
      | version == schemaVersion -> do
        for_ parts $ \part -> do
          there <- columnsOf (partName part)
          unless (there == map fst (partColumns part)) (throwE (TablesDiffer path))
        pure version
      | version `elem` [1, 2] -> pure version
      | otherwise -> throwE (WrongSchemaVersion (fromIntegral version) (fromIntegral schemaVersion))
    _ -> throwE (UnreadableRow MetadataTable)
  where
    columnsOf table = ask ("SELECT name FROM pragma_table_info('" ++ table ++ "') ORDER BY cid")

-- | All that a store of this version has, and its rows where the version is the present one: that
-- the file is whole, that values are of their columns' types, and what 'fromRows' asks, is checked.
everything :: FilePath -> Int64 -> Query IO (String, Numbers, Placement, Maybe Rows)
everything path version = do
  verdict <- ask "PRAGMA integrity_check"
  unless (take 1 verdict == [Text.pack "ok"]) (throwE (DamagedFile path BrokenPages))
  if version == schemaVersion
    then current path
    else
      (\(profile, place) -> (profile, firstNumbers place, place, Nothing))
        <$> selectOlder
          version

current :: FilePath -> Query IO (String, Numbers, Placement, Maybe Rows)
current path = do
  -- SQLite holds values of any type in any column, and the binding rounds numbers.
  for_ parts $ \part -> do
    let typed (column, kind) =
          "typeof(" ++ Text.unpack column ++ ") NOT IN ('null', '" ++ kind ++ "')"
    foreigners <-
      ask
        ( "SELECT COUNT(*) FROM "
            ++ partName part
            ++ " WHERE "
            ++ intercalate " OR " (map typed (partColumns part))
        )
    unless (foreigners == [0 :: Int]) (throwE (DamagedFile path ForeignValue))
  rows <- lift selectRows
  (profile, numbers, place) <- except (fromRows rows)
  pure (profile, numbers, place, Just rows)

ask :: PersistField value => String -> Query IO [value]
ask sql = map unSingle <$> lift (rawSql (Text.pack sql) [])

-- | All of the placement, read and proved.
storedPlacement :: Store -> IO (Either StoreError Placement)
storedPlacement store = case storeContents store of
  Loaded place -> pure (Right place)
  Tables backend -> fmap placed <$> query store backend (everything (storeFile store) schemaVersion)
  where
    placed (_, _, place, _) = place

-- | The placement of the objects of these names alone; refuses names that there are not.
storedObjects :: Store -> [ObjectName] -> IO (Either StoreError Placement)
storedObjects store names = case storeContents store of
  Loaded place -> pure (place <$ mapM_ (first NotInStore . findObject place) names)
  Tables backend ->
    query store backend (selectObjects (storedShape store) (storedPitch store) names)

-- | The placement of those objects alone that have cells of any window of this shape that has one
-- of these cells of the array.
storedNear :: Store -> Shape -> [Position] -> IO (Either StoreError Placement)
storedNear store window cells = case storeContents store of
  Loaded place -> pure (Right place)
  Tables backend ->
    query store backend (selectNear (storedShape store) (storedPitch store) window cells)

-- | Where the window of the given shape at the given position is; as 'whereabouts' answers.
storedWhereabouts :: Store -> Shape -> Position -> IO (Either StoreError Whereabouts)
storedWhereabouts store window at = case storeContents store of
  Loaded place -> pure (Right (whereabouts place window at))
  Tables backend ->
    query store backend (selectWhereabouts (storedShape store) (storedPitch store) window at)

-- | Where on the array a cell of a face's block lies; as 'arrayPosition' answers.
storedPosition :: Store -> Face -> Position -> IO (Either StoreError Position)
storedPosition store face cell = case storeContents store of
  Loaded place -> pure (first NotInStore (arrayPosition place face cell))
  Tables backend -> query store backend (selectPosition (storedShape store) face cell)

query :: Store -> SqlBackend -> Query IO a -> IO (Either StoreError a)
query store backend statements = runExceptT (asked (storeFile store) backend statements)

-- In a transaction of its own.
asked :: FilePath -> SqlBackend -> Query IO a -> ExceptT StoreError IO a
asked path backend statements =
  asking path (runSqlConn (runExceptT statements) backend) >>= except

-- Statements are logged nowhere, and no write-ahead log is kept: the store is one file.
withBackend :: FilePath -> (SqlBackend -> IO a) -> IO a
withBackend path action = runNoLoggingT (withSqliteConnInfo (connection path) (liftIO . action))

connection :: FilePath -> SqliteConnectionInfo
connection path =
  runIdentity
    ( walEnabled (const (Identity False)) (mkSqliteConnectionInfo (Text.pack plain))
        >>= extraPragmas (const (Identity [Text.pack "PRAGMA busy_timeout = 10000"]))
    )
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
