-- | Objects, faces and their place on the array as a relational database: \"the mapping of the
-- winged-edge object models to the encoding PRA is implemented as a relational database\" (section
-- II.B of the paper). A database is named by the path of a file, which is SQLite's, or by an
-- address that begins with @postgresql:\/\/@ ("PraTactile.Store.Address"). The tables
-- ("PraTactile.Store.Schema") and the look-ups ("PraTactile.Store.Query") are the same for both;
-- what differs is a 'PraTactile.Store.Backend.Backend'.
module PraTactile.Store
  ( -- * Making and changing a store
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

-- | An open store, good while 'withStore' runs.
data Store = Store
  { storeBackend :: Backend,
    -- | the text of the profile that the store was made for
    storedProfile :: String,
    -- | the rows and columns of the array
    storedShape :: Shape,
    -- | the distances between symbols
    storedPitch :: Pitch,
    storeConnection :: SqlBackend
  }

-- | Write a placement to a database, with the text of the profile it belongs to: a new one, or in
-- the place of a store, which is replaced, whole or not at all. Anything else that is there is
-- refused and stays. In a file, which may be the end of a link, the rows go to a file beside it,
-- named likewise with @.part@ after it, which takes its name once it is complete; on a server they
-- come in one transaction.
create :: FilePath -> String -> Placement -> IO (Either StoreError ())
create name profile place = runExceptT $ do
  backend <- except (backendOf name)
  rows <- except (rowsFor backend profile (firstNumbers place) place)
  putRows backend rows

-- | The rows of a placement, if the database can hold them.
rowsFor :: Backend -> String -> Numbers -> Placement -> Either StoreError Rows
rowsFor backend profile numbers place = do
  rows <- toRows profile numbers place
  if allTexts (holdsText backend) rows then Right rows else Left (TextNotHeld (backendName backend))

-- | Make the placement of a store another one, in one transaction, by a function of the placement
-- that it has. Objects and laid faces that stay keep their numbers, and only rows that differ are
-- written; nothing is where the function refuses. Another program that is changing the store is
-- waited for, up to ten seconds.
change ::
  forall refusal.
  FilePath ->
  (Placement -> Either refusal Placement) ->
  IO (Either StoreError (Either refusal Placement))
change name = fmap (fmap (fmap fst)) . changeRemembering name []

-- | 'change', which answers also with where objects lay before that were added or moved and lie
-- elsewhere now: of those that were taken out before, the store remembers it. Objects of the names
-- given are laid on purpose, and are none of these.
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

-- | Open a store, check that its tables are of this version and that it was made for the profile
-- expected (if one is), and go on with it. Nothing else is read before it is asked for. Exceptions
-- of what goes on pass through; the file's own faults are answers.
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

-- | Refuses what is no store, tables of another version, and tables that differ from those of this
-- version.
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

-- | All that a store has, and its rows. Refuses a database that is not whole, values that are not
-- of their columns' types, and what 'fromRows' refuses.
everything :: Backend -> Query IO (String, Numbers, Placement, Rows)
everything backend = do
  integrity backend
  valuesTyped backend
  _ <- rememberedBy backend
  rows <- lift selectRows
  (profile, numbers, place) <- except (fromRows rows)
  pure (profile, numbers, place, rows)

-- | All of the placement, read and proved.
storedPlacement :: Store -> IO (Either StoreError Placement)
storedPlacement store = fmap placed <$> query store (everything (storeBackend store))
  where
    placed (_, _, place, _) = place

-- | The placement of the objects of these names alone; refuses names that there are not.
storedObjects :: Store -> [ObjectName] -> IO (Either StoreError Placement)
storedObjects store = query store . selectObjects (storedShape store) (storedPitch store)

-- | The placement of those objects alone that have cells of any window of this shape that has one
-- of these cells of the array.
storedNear :: Store -> Shape -> [Position] -> IO (Either StoreError Placement)
storedNear store window = query store . selectNear (storedShape store) (storedPitch store) window

-- | The placement of those objects alone that have cells of the first so many laid faces, or within
-- so many rows and columns of their blocks on the array. Those faces are the first of it.
storedFirst :: Store -> Int -> Shape -> IO (Either StoreError Placement)
storedFirst store count reach = do
  some <- query store (selectFirstLaid (storedShape store) (storedPitch store) count reach)
  either (pure . Left) (maybe (storedPlacement store) (pure . Right)) some

-- | Where the window of the given shape at the given position is; as 'whereabouts' answers.
storedWhereabouts :: Store -> Shape -> Position -> IO (Either StoreError Whereabouts)
storedWhereabouts store window =
  query store . selectWhereabouts (storedShape store) (storedPitch store) window

-- | Where on the array a cell of a face's block lies; as 'arrayPosition' answers.
storedPosition :: Store -> Face -> Position -> IO (Either StoreError Position)
storedPosition store face = query store . selectPosition (storedShape store) face

query :: Store -> Query IO a -> IO (Either StoreError a)
query store = runExceptT . asked (storeBackend store) (storeConnection store)

-- In a transaction of its own.
asked :: Backend -> SqlBackend -> Query IO a -> ExceptT StoreError IO a
asked backend connection statements =
  answering backend (transacted connection statements) >>= except
