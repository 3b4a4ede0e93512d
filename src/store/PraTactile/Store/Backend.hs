{-# LANGUAGE RankNTypes #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The operations in which kinds of databases differ. Tables, rows, seals, look-ups and refusals
-- are common to all.
module PraTactile.Store.Backend
  ( Backend (..),
    answering,
    transacted,
    ask,
  )
where

import Control.Exception (SomeException)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT, runExceptT, withExceptT)
import Data.Text (Text)
import qualified Data.Text as Text
import Database.Persist.Sql
  ( PersistField,
    Single (..),
    SqlBackend,
    rawSql,
    runSqlConn,
    transactionUndo,
  )
import PraTactile.Store.Error
import PraTactile.Store.Guard
import PraTactile.Store.Query (Query)
import PraTactile.Store.Rows (Rows)

-- | A named database of some kind.
data Backend = Backend
  { -- | its name for messages, without a password
    backendName :: String,
    -- | runs an action with a connection; each transaction on it sees a constant state
    connected :: forall a. (SqlBackend -> IO a) -> ExceptT StoreError IO a,
    -- | interprets an exception of the database or its binding; 'Nothing' for any other
    meaningOf :: SomeException -> Maybe Objection,
    -- | the columns of a table in their order; empty if there is no such table
    columnsOf :: String -> Query IO [Text],
    -- | refuses a damaged database, as far as the database itself can tell
    integrity :: Query IO (),
    -- | refuses values of wrong types
    valuesTyped :: Query IO (),
    -- | looks at the present database, and returns the action that ends a transaction and begins
    -- one that excludes other writers. The action waits up to ten seconds, and refuses a database
    -- that has been replaced in the meantime
    prepareWriting :: IO (Query IO ()),
    -- | creates the table of former places
    makeFormer :: Query IO (),
    -- | whether a column can hold the text
    holdsText :: Text -> Bool,
    -- | writes a store atomically, as a new one or in place of an old one; refuses anything else
    -- that is there
    putRows :: Rows -> ExceptT StoreError IO ()
  }

-- | Runs an action on a database and turns its exceptions into errors.
answering :: Backend -> IO a -> ExceptT StoreError IO a
answering backend = withExceptT objection . guarded (meaningOf backend)
  where
    objection (Damaged damage) = DamagedFile (backendName backend) damage
    objection Unknown = TablesDiffer (backendName backend)
    objection (Failed failure) = DatabaseFailed failure

-- | Runs statements in their own transaction, which is rolled back if one refuses.
transacted :: SqlBackend -> Query IO a -> IO (Either StoreError a)
transacted backend statements = runSqlConn (runExceptT statements >>= kept) backend
  where
    kept outcome = outcome <$ either (const transactionUndo) (const (pure ())) outcome

-- | The values of a query with a single column.
ask :: PersistField value => String -> Query IO [value]
ask sql = map unSingle <$> lift (rawSql (Text.pack sql) [])
