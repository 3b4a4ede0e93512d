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
import Control.Monad.Trans.Except (ExceptT (..), except, runExceptT, throwE)
import Data.Bifunctor (first)
import Data.Foldable (for_)
import Data.Int (Int64)
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
import PraTactile.Store.Older
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
    storeContents :: Contents
  }

-- | What is asked.
data Contents
  = -- | the tables
    Tables SqlBackend
  | -- | what an older version held, which has been read
    Loaded Placement

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
-- waited for, up to ten seconds. A store of an older version is replaced, whole or not at all, by
-- one of this version.
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
      _ <- schemaChecked backend
      begin
      version <- schemaChecked backend
      (profile, numbers, place, old) <- everything backend version
      known <- if version == schemaVersion then rememberedBy backend else pure mempty
      case function place of
        Left refusal -> pure (Left refusal)
        Right other -> do
          let remembered = afterwards purposely known place other
          case old of
            Nothing -> do
              rows <- except (rowsFor backend profile (firstNumbers other) other)
              former <- except (formerRowsOf remembered)
              ExceptT (liftIO (runExceptT (putRows backend rows {formerRows = former})))
            Just rows -> do
              new <- except (rowsFor backend profile (nextNumbers place numbers other) other)
              lift (changeRows rows new)
              remember backend known remembered
          pure (Right (other, elsewhere remembered place other))

-- | Open a store, check that its tables are of a known version and that it was made for the profile
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
  (profile, shape, between, contents) <-
    asked backend connection $ do
      version <- schemaChecked backend
      if version == schemaVersion
        then do
          sheet <- selectSheet
          shape <- except (shapeIn sheet)
          pure (Text.unpack (metadataProfile sheet), shape, pitchIn sheet, Tables connection)
        else do
          (profile, _, place, _) <- everything backend version
          pure (profile, placementShape place, placementPitch place, Loaded place)
  for_ expected $ \wanted -> unless (profile == wanted) (throwE (ForeignProfile profile wanted))
  pure (Store backend profile shape between contents)

-- | The version of the tables, which are those of that version; refuses what is no store.
schemaChecked :: Backend -> Query IO Int64
schemaChecked backend = do
  columns <- columnsOf backend "metadata"
  unless (Text.pack "schema_version" `elem` columns) (throwE (NotAStore (backendName backend)))
  versions <- ask "SELECT MAX(schema_version) FROM metadata"
  case versions of
    [Just version]
      | version == schemaVersion -> do
        for_ parts $ \part -> do
          there <- columnsOf backend (partName part)
          unless (there == map fst (partColumns part)) (throwE (TablesDiffer (backendName backend)))
        pure version
      | version `elem` olderVersions backend -> pure version
      | otherwise -> throwE (WrongSchemaVersion (fromIntegral version) (fromIntegral schemaVersion))
    _ -> throwE (UnreadableRow MetadataTable)

-- | All that a store of this version has, and its rows where the version is the present one: that
-- the database is whole, that values are of their columns' types, and what 'fromRows' asks, is
-- checked.
everything :: Backend -> Int64 -> Query IO (String, Numbers, Placement, Maybe Rows)
everything backend version = do
  integrity backend
  if version == schemaVersion
    then do
      valuesTyped backend
      _ <- rememberedBy backend
      rows <- lift selectRows
      (profile, numbers, place) <- except (fromRows rows)
      pure (profile, numbers, place, Just rows)
    else do
      (profile, place) <- selectOlder version
      pure (profile, firstNumbers place, place, Nothing)

-- | All of the placement, read and proved.
storedPlacement :: Store -> IO (Either StoreError Placement)
storedPlacement store = case storeContents store of
  Loaded place -> pure (Right place)
  Tables connection ->
    fmap placed <$> query store connection (everything (storeBackend store) schemaVersion)
  where
    placed (_, _, place, _) = place

-- | The placement of the objects of these names alone; refuses names that there are not.
storedObjects :: Store -> [ObjectName] -> IO (Either StoreError Placement)
storedObjects store names = case storeContents store of
  Loaded place -> pure (place <$ mapM_ (first NotInStore . findObject place) names)
  Tables connection ->
    query store connection (selectObjects (storedShape store) (storedPitch store) names)

-- | The placement of those objects alone that have cells of any window of this shape that has one
-- of these cells of the array.
storedNear :: Store -> Shape -> [Position] -> IO (Either StoreError Placement)
storedNear store window cells = case storeContents store of
  Loaded place -> pure (Right place)
  Tables connection ->
    query store connection (selectNear (storedShape store) (storedPitch store) window cells)

-- | The placement of those objects alone that have cells of the first so many laid faces, or within
-- so many rows and columns of their blocks on the array. Those faces are the first of it.
storedFirst :: Store -> Int -> Shape -> IO (Either StoreError Placement)
storedFirst store count reach = case storeContents store of
  Loaded place -> pure (Right place)
  Tables connection -> do
    some <-
      query store connection (selectFirstLaid (storedShape store) (storedPitch store) count reach)
    either (pure . Left) (maybe (storedPlacement store) (pure . Right)) some

-- | Where the window of the given shape at the given position is; as 'whereabouts' answers.
storedWhereabouts :: Store -> Shape -> Position -> IO (Either StoreError Whereabouts)
storedWhereabouts store window at = case storeContents store of
  Loaded place -> pure (Right (whereabouts place window at))
  Tables connection ->
    query store connection (selectWhereabouts (storedShape store) (storedPitch store) window at)

-- | Where on the array a cell of a face's block lies; as 'arrayPosition' answers.
storedPosition :: Store -> Face -> Position -> IO (Either StoreError Position)
storedPosition store face cell = case storeContents store of
  Loaded place -> pure (first NotInStore (arrayPosition place face cell))
  Tables connection -> query store connection (selectPosition (storedShape store) face cell)

query :: Store -> SqlBackend -> Query IO a -> IO (Either StoreError a)
query store connection statements = runExceptT (asked (storeBackend store) connection statements)

-- In a transaction of its own.
asked :: Backend -> SqlBackend -> Query IO a -> ExceptT StoreError IO a
asked backend connection statements =
  answering backend (transacted connection statements) >>= except
