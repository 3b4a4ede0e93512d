-- | Objects, faces and their places on the array in a relational database: \"the mapping of the
-- winged-edge object models to the encoding PRA is implemented as a relational database\" (section
-- II.B of the paper). A database is an SQLite file, named by its path, or is on a server, named by
-- an address that begins with @postgresql:\/\/@ ("PraTactile.Store.Address"). Both have the same
-- tables ("PraTactile.Store.Schema") and look-ups ("PraTactile.Store.Query"). Their differences are
-- in a 'PraTactile.Store.Backend.Backend'.
module PraTactile.Store
  ( -- * Creating and changing a store
    create,
    change,
    changeRemembering,
    Former,
    FormerFace (..),

    -- * Opening a store
    Store,
    withStore,
    storedProfile,
    storedShape,
    storedPitch,
    storedPlacement,
    storedObjects,
    storedNear,
    storedFirst,

    -- * Look-ups
    storedWhereabouts,
    storedPosition,

    -- * Names
    shownName,

    -- * Errors
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

import Control.Exception (SomeException, throwIO, try)
import Control.Monad (unless)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT, except, runExceptT, throwE)
import Data.Foldable (for_)
import qualified Data.Text as Text
import Database.Persist.Sql (SqlBackend)
import PraTactile.Array (Position, Shape)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge (ObjectName)
import PraTactile.Store.Address (shownName)
import PraTactile.Store.Backend
import PraTactile.Store.Error
import PraTactile.Store.Former
import PraTactile.Store.Known
import PraTactile.Store.Query
import PraTactile.Store.Rows
import PraTactile.Store.Rows.Read
import PraTactile.Store.Rows.Write
import PraTactile.Store.Schema

-- | An open store, valid while 'withStore' runs.
data Store = Store
  { storeBackend :: Backend,
    -- | the text of the store's profile
    storedProfile :: String,
    -- | the shape of the array
    storedShape :: Shape,
    -- | the distances between symbols
    storedPitch :: Pitch,
    storeConnection :: SqlBackend
  }

-- | Writes a placement and the text of its profile to a database, as a new store or in place of an
-- old one. It is atomic. Anything other than a store is refused and stays. In a file (or the target
-- of a link) the rows go first to a file beside it, with @.part@ appended to the name, which is
-- renamed when complete. On a server the rows come in one transaction.
create :: FilePath -> String -> Placement -> IO (Either StoreError ())
create name profile place = runExceptT $ do
  backend <- except (backendOf name)
  rows <- except (rowsFor backend profile (firstNumbers place) place)
  putRows backend rows

-- | The rows of a placement. Refuses texts that the database cannot hold.
rowsFor :: Backend -> String -> Numbers -> Placement -> Either StoreError Rows
rowsFor backend profile numbers place = do
  rows <- toRows profile numbers place
  if allTexts (holdsText backend) rows then Right rows else Left (TextNotHeld (backendName backend))

-- | Replaces a store's placement by a function of it, in one transaction. Objects and laid faces
-- that stay keep their numbers, and only rows that differ are written. If the function refuses,
-- nothing is written. It waits up to ten seconds for another program that is changing the store.
change ::
  forall refusal.
  FilePath ->
  (Placement -> Either refusal Placement) ->
  IO (Either StoreError (Either refusal Placement))
change name = fmap (fmap (fmap fst)) . changeRemembering name []

-- | 'change' that also returns the former places of objects that were added or moved. A store
-- remembers the places of objects that were taken out; only objects that now lie elsewhere are
-- returned. The named objects were placed deliberately and are never returned.
changeRemembering ::
  forall refusal.
  FilePath ->
  [ObjectName] ->
  (Placement -> Either refusal Placement) ->
  IO (Either StoreError (Either refusal (Placement, Former)))
changeRemembering name purposely function = runExceptT $ do
  backend <- except (backendOf name)
  begin <- liftIO (prepareWriting backend)
  connected backend (`transacted` changing backend begin) >>= except
  where
    changing :: Backend -> Query IO () -> Query IO (Either refusal (Placement, Former))
    changing backend begin = do
      schemaChecked backend
      begin
      schemaChecked backend
      (profile, numbers, place, rows) <- everything backend
      known <- rememberedBy backend
      case function place of
        Left refusal -> pure (Left refusal)
        Right other -> do
          let remembered = afterwards purposely known place other
          new <- except (rowsFor backend profile (nextNumbers place numbers other) other)
          lift (changeRows rows new)
          remember backend known remembered
          pure (Right (other, elsewhere remembered place other))

-- | Opens a store, checks the version of its tables and its profile (if one is expected), and runs
-- the action. Nothing else is read before it is needed. Exceptions of the action pass through;
-- faults of the file are returned.
withStore :: FilePath -> Maybe String -> (Store -> IO a) -> IO (Either StoreError a)
withStore name expected action = do
  outcome <- runExceptT $ do
    backend <- except (backendOf name)
    connected backend $ \connection ->
      runExceptT (open backend expected connection) >>= traverse (try . action)
  case outcome of
    Left fault -> pure (Left fault)
    Right (Left fault) -> pure (Left fault)
    Right (Right (Left exception)) -> throwIO (exception :: SomeException)
    Right (Right (Right result)) -> pure (Right result)

open :: Backend -> Maybe String -> SqlBackend -> ExceptT StoreError IO Store
open backend expected connection = do
  (sheet, shape) <-
    asked backend connection $ do
      schemaChecked backend
      sheet <- selectSheet
      (,) sheet <$> except (shapeIn sheet)
  let profile = Text.unpack (metadataProfile sheet)
  for_ expected $ \wanted -> unless (profile == wanted) (throwE (ForeignProfile profile wanted))
  pure (Store backend profile shape (pitchIn sheet) connection)

-- | Refuses a database that is not a store, another version of the tables, and tables that differ
-- from this version's.
schemaChecked :: Backend -> Query IO ()
schemaChecked backend = do
  columns <- columnsOf backend "metadata"
  unless (Text.pack "schema_version" `elem` columns) (throwE (NotAStore (backendName backend)))
  versions <- ask "SELECT MAX(schema_version) FROM metadata"
  case versions of
    [Just version]
      | version == schemaVersion ->
        for_ parts $ \part -> do
          there <- columnsOf backend (partName part)
          unless (there == map fst (partColumns part)) (throwE (TablesDiffer (backendName backend)))
      | otherwise -> throwE (WrongSchemaVersion (fromIntegral version) (fromIntegral schemaVersion))
    _ -> throwE (UnreadableRow MetadataTable)

-- | The whole contents of a store, with its rows. Refuses a damaged database, values of wrong
-- types, and what 'fromRows' refuses.
everything :: Backend -> Query IO (String, Numbers, Placement, Rows)
everything backend = do
  integrity backend
  valuesTyped backend
  _ <- rememberedBy backend
  rows <- lift selectRows
  (profile, numbers, place) <- except (fromRows rows)
  pure (profile, numbers, place, rows)

-- | The whole placement, read and verified.
storedPlacement :: Store -> IO (Either StoreError Placement)
storedPlacement store = fmap placed <$> query store (everything (storeBackend store))
  where
    placed (_, _, place, _) = place

-- | The placement of only the named objects. Refuses unknown names.
storedObjects :: Store -> [ObjectName] -> IO (Either StoreError Placement)
storedObjects store = query store . selectObjects (storedShape store) (storedPitch store)

-- | The placement of only those objects that have cells in a window of the given shape that
-- contains one of the given cells of the array.
storedNear :: Store -> Shape -> [Position] -> IO (Either StoreError Placement)
storedNear store window = query store . selectNear (storedShape store) (storedPitch store) window

-- | The placement of only those objects that have cells in the first laid faces (the given number
-- of them), or within the given number of rows and columns around their blocks. Those laid faces
-- come first.
storedFirst :: Store -> Int -> Shape -> IO (Either StoreError Placement)
storedFirst store count reach = do
  some <- query store (selectFirstLaid (storedShape store) (storedPitch store) count reach)
  either (pure . Left) (maybe (storedPlacement store) (pure . Right)) some

-- | The whereabouts of a window, by its shape and position, as 'whereabouts' gives them.
storedWhereabouts :: Store -> Shape -> Position -> IO (Either StoreError Whereabouts)
storedWhereabouts store window =
  query store . selectWhereabouts (storedShape store) (storedPitch store) window

-- | The position on the array of a cell of a face's block, as 'arrayPosition' gives it.
storedPosition :: Store -> Face -> Position -> IO (Either StoreError Position)
storedPosition store face = query store . selectPosition (storedShape store) face

query :: Store -> Query IO a -> IO (Either StoreError a)
query store = runExceptT . asked (storeBackend store) (storeConnection store)

-- In its own transaction.
asked :: Backend -> SqlBackend -> Query IO a -> ExceptT StoreError IO a
asked backend connection statements =
  answering backend (transacted connection statements) >>= except
