{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | A store on a PostgreSQL server: ten tables in the user's default schema.
--
-- A reading transaction sees a constant state (repeatable read). A writing transaction locks the
-- placement's tables against other writers before it reads the first row; readers still see the
-- former state. It waits for a lock up to ten seconds, or as long as a @lock_timeout@ other than 0
-- of the address or the server says. It waits for a connection up to ten seconds.
module PraTactile.Store.Postgresql
  ( postgresql,
  )
where

import Control.Exception (SomeException, bracket, fromException)
import Control.Monad (unless, when)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT (..), except, runExceptT, throwE, withExceptT)
import Control.Monad.Trans.Reader (runReaderT)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.Foldable (for_, toList)
import Data.List (intercalate, isInfixOf)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8With, encodeUtf8)
import Data.Text.Encoding.Error (lenientDecode)
import Database.Persist.Postgresql (openSimpleConn)
import Database.Persist.Sql
import Database.PostgreSQL.LibPQ (disableNoticeReporting)
import Database.PostgreSQL.Simple (SqlError (..), close, connectPostgreSQL)
import Database.PostgreSQL.Simple.Internal (withConnection)
import PraTactile.Store.Address
import PraTactile.Store.Backend
import PraTactile.Store.Error
import PraTactile.Store.Guard
import PraTactile.Store.Query (Query)
import PraTactile.Store.Rows
import System.IO.Error (isUserError)
import System.Timeout (timeout)

-- | The database at an address.
postgresql :: Address -> Backend
postgresql address = backend
  where
    name = shownAddress address
    backend =
      Backend
        { backendName = name,
          connected = \action ->
            throughout address $ \connection -> runExceptT (answering backend (action connection)),
          meaningOf = meaningInPostgresql,
          columnsOf = columnsOfVisible,
          -- No query makes a server check its files.
          integrity = pure (),
          valuesTyped = do
            differ <- concat <$> traverse typesThatDiffer parts
            unless (null differ) (throwE (DamagedFile name ForeignValue)),
          prepareWriting = pure (beginWriting >> holdTables),
          makeFormer = execute (tableIn formerPart),
          -- PostgreSQL's texts cannot contain NUL.
          holdsText = Text.all (/= '\0'),
          putRows = putTables address
        }

-- | Runs an action with a connection to the database at an address. Refuses a database that cannot
-- hold a store.
throughout ::
  Address -> (SqlBackend -> IO (Either StoreError a)) -> ExceptT StoreError IO a
throughout address action =
  ExceptT (bracket (runExceptT reached) (either (const (pure ())) close) (runExceptT . going))
  where
    name = shownAddress address
    going outcome = do
      connection <- except outcome
      -- Otherwise libpq would print the server's notices.
      known (withConnection connection disableNoticeReporting)
      backend <- known (openSimpleConn (\_ _ _ _ -> pure ()) connection)
      found <- known (runReaderT (rawSql settings []) backend)
      for_ (map encodingIn found) $ \encoding ->
        unless (encoding == "UTF8") (throwE (WrongEncoding name (Text.unpack encoding)))
      ExceptT (action backend)
    encodingIn :: (Single Text, Single Text, Single Text) -> Text
    encodingIn (Single encoding, _, _) = encoding
    known = unreachable . guarded meaningInPostgresql
    unreachable = withExceptT (Unreachable name . failureIn)
    -- The binding does not use the blocking call to which libpq's own timeout applies.
    reached = do
      answered <-
        unreachable . guarded (meaningOfRefusal address) . timeout (10 * 1000000) $
          connectPostgreSQL (encodeUtf8 (Text.pack (connectionString keptAlive address)))
      maybe (throwE (Unreachable name NoServer)) pure answered
    settings =
      "SELECT current_setting('server_encoding'), \
      \set_config('lock_timeout', COALESCE(NULLIF(current_setting('lock_timeout'), '0'), '10s'), \
      \false), set_config('default_transaction_isolation', 'repeatable read', false)"

-- | Notices a broken network within half a minute.
keptAlive :: [(String, String)]
keptAlive =
  [ ("keepalives_idle", "10"),
    ("keepalives_interval", "5"),
    ("keepalives_count", "3"),
    ("tcp_user_timeout", "25000")
  ]

-- | Begins a new transaction, in which each statement sees what was committed before it.
beginWriting :: Query IO ()
beginWriting = lift (mapM_ (`rawExecute` []) ["COMMIT", "BEGIN ISOLATION LEVEL READ COMMITTED"])

-- | Excludes other writers until the transaction ends. Readers need not wait.
holdTables :: Query IO ()
holdTables = execute ("LOCK TABLE " <> listed <> " IN EXCLUSIVE MODE")

-- | Creates the tables, or empties those of an old store, and fills them, in one transaction.
-- Refuses tables of these names with other columns. While there is no table to lock, an advisory
-- lock keeps out other programs that create them.
putTables :: Address -> Rows -> ExceptT StoreError IO ()
putTables address given = throughout address $ \backend ->
  runExceptT
    (withExceptT objection (guarded meaningInPostgresql (transacted backend putting)) >>= except)
  where
    name = shownAddress address
    objection Unknown = Occupied name OtherTables
    objection other = CannotWrite name (failureIn other)
    putting = do
      beginWriting
      _ <- ask ("SELECT 1 FROM pg_advisory_xact_lock(" ++ show turn ++ ")") :: Query IO [Int]
      taken <-
        ask $
          "SELECT relname::text FROM pg_catalog.pg_class WHERE relname IN ("
            ++ intercalate ", " ["'" ++ partName part ++ "'" | part <- allParts]
            ++ ") AND relnamespace = \
               \(SELECT oid FROM pg_catalog.pg_namespace WHERE nspname = current_schema())"
      if null (taken :: [Text]) then makeTables else emptyTables
      lift (insertRows given)
      -- The first look-up is then planned for the number of rows.
      execute ("ANALYZE " <> listed)
    emptyTables = do
      there <- traverse (columnsOfVisible . partName) parts
      former <- columnsOfVisible (partName formerPart)
      unless
        ( there == map (map fst . partColumns) parts
            && former `elem` [[], map fst (partColumns formerPart)]
        )
        (throwE (Occupied name OtherTables))
      holdTables
      when (null former) (execute (tableIn formerPart))
      for_ (reverse allParts) $ \part -> execute ("DELETE FROM " <> Text.pack (partName part))
    -- The arbitrary, constant number that writers of this program lock.
    turn = 7072617461637469 :: Int

-- | Creates the tables. Persistent's own way looks at the tables of all schemas.
makeTables :: Query IO ()
makeTables = do
  mapM_ (execute . tableIn) allParts
  -- Deleting a laying searches the runs for it.
  execute "CREATE INDEX run_laying ON run (laying)"

-- | The statement that creates a table as "PraTactile.Store.Schema" defines it. Texts are ordered
-- by their characters, whatever the database's collation.
tableIn :: TableRows -> Text
tableIn part =
  Text.concat ["CREATE TABLE ", Text.pack (partName part), " (", Text.intercalate ", " parts', ")"]
  where
    entity = partEntity part
    parts' =
      map column (getEntityFieldsDatabase entity)
        ++ ["PRIMARY KEY " <> among (map fieldDB (toList (getEntityKeyFields entity)))]
        ++ map unique (getEntityUniques entity)
        ++ map reference (getEntityForeignDefs entity)
    column field =
      unFieldNameDB (fieldDB field)
        <> (if fieldSqlType field == SqlString then " varchar COLLATE \"C\"" else " bigint")
        <> (if isFieldNullable field == NotNullable then " NOT NULL" else "")
    unique it = "UNIQUE " <> among (map snd (toList (uniqueFields it)))
    reference it =
      Text.concat
        [ "FOREIGN KEY ",
          among (map (snd . fst) (foreignFields it)),
          " REFERENCES ",
          unEntityNameDB (foreignRefTableDBName it),
          " ",
          among (map (snd . snd) (foreignFields it))
        ]
    among columns = "(" <> Text.intercalate ", " (map unFieldNameDB columns) <> ")"

allParts :: [TableRows]
allParts = parts ++ [formerPart]

execute :: Text -> Query IO ()
execute sql = lift (rawExecute sql [])

listed :: Text
listed = Text.intercalate ", " (map (Text.pack . partName) parts)

-- | The columns of the table that a statement would use for this name.
columnsOfVisible :: String -> Query IO [Text]
columnsOfVisible table = map unSingle <$> columnsBy "attname::text" table

-- | The columns of a table that have a wrong type.
typesThatDiffer :: TableRows -> Query IO [Text]
typesThatDiffer part = do
  there <- columnsBy "attname::text, format_type(atttypid, atttypmod)" (partName part)
  pure
    [ column
      | (Single column, Single found) <- there,
        Just kind <- [lookup column (partColumns part)],
        found /= (if kind == SqlString then "character varying" else "bigint" :: Text)
    ]

columnsBy :: RawSql row => Text -> String -> Query IO [row]
columnsBy what table =
  lift . (`rawSql` []) $
    "SELECT " <> what
      <> " FROM pg_catalog.pg_attribute WHERE attrelid = (SELECT oid FROM pg_catalog.pg_class \
         \WHERE oid = to_regclass('"
      <> Text.pack table
      <> "') AND relkind = 'r') AND attnum > 0 AND NOT attisdropped ORDER BY attnum"

-- | The meaning of an exception while there is a connection. System exceptions, and exceptions
-- without a server's state code, mean that the connection was lost.
meaningInPostgresql :: SomeException -> Maybe Objection
meaningInPostgresql fault
  | Just told <- fromException fault = Just (ofState (sqlState told))
  | Just system <- fromException fault, not (isUserError system) = Just (Failed ConnectionLost)
  | otherwise = Nothing

-- | The meaning of an exception before there is a connection. libpq gives only words, which never
-- repeat the password. A refused password and servers that do not answer are recognised by these
-- words. Other words are passed on, unless they contain a part of the address that must not be
-- shown ('withheld').
meaningOfRefusal :: Address -> SomeException -> Maybe Objection
meaningOfRefusal address fault
  | Just told <- fromException fault = Just (Failed (inWords (sqlErrorMsg told)))
  | Just system <- fromException fault =
    Just (Failed (inWords (Bytes.pack (show (system :: IOError)))))
  | otherwise = Nothing
  where
    inWords bytes
      | any (`Bytes.isInfixOf` bytes) noPassword = PasswordRefused
      | not (null attempts) && all isUnanswered attempts = NoServer
      | any (`isInfixOf` text) (withheld address) =
        if any (`isInfixOf` text) unknown then UnknownParameter else ServerRefuses
      | otherwise = Refused text
      where
        -- libpq writes one line per server, sometimes with an indented second line.
        text =
          intercalate "; " . filter (not . null) . map (unwords . words) . lines . Text.unpack $
            ownWords (decodeUtf8With lenientDecode bytes)
        -- The binding puts libpq's words in parentheses.
        ownWords said =
          fromMaybe said (Text.stripPrefix "libpq: failed (" said >>= Text.stripSuffix ")")
        attempts = drop 1 (Text.splitOn "connection to server" (Text.pack text))
    isUnanswered attempt = "Is the server running" `Text.isInfixOf` attempt
    noPassword = ["password authentication failed", "no password supplied", "empty password"]
    unknown = ["invalid connection option", "invalid URI query parameter"]

-- | The meaning of the server's codes (appendix A of its manual, "PostgreSQL Error Codes").
ofState :: ByteString -> Objection
ofState state
  | state `elem` ["55P03", "55006", "40P01", "40001"] = Failed InUse
  | state `elem` ["42501", "25006"] = Failed NotPermitted
  | state `elem` ["53100", "53200"] = Failed NoRoom
  | state `elem` ["57P01", "57P02", "57P03", "57P05"] = Failed ConnectionLost
  | state `elem` ["XX001", "XX002", "58P01"] = Damaged BrokenPages
  | otherwise = case Bytes.take 2 state of
    "" -> Failed ConnectionLost
    "08" -> Failed ConnectionLost
    "22" -> Damaged ForeignValue
    "42" -> Unknown
    _ -> Failed SystemRefuses
