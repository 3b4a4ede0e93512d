{-# LANGUAGE RankNTypes #-}
{-# OPTIONS_HADDOCK hide #-}

-- | What one kind of database does otherwise than another. All else (tables, rows, seals,
-- look-ups, what refuses) is the same for each.
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

-- | A database of some kind, under a name.
data Backend = Backend
  { -- | its name as it is shown, without a password
    backendName :: String,
    -- | go on with a connection to what there is; each transaction on it sees one state throughout
    connected :: forall a. (SqlBackend -> IO a) -> ExceptT StoreError IO a,
    -- | what an exception of the database or its binding means; 'Nothing' for any other
    meaningOf :: SomeException -> Maybe Objection,
    -- | the columns of a table in their order; none where there is no such table
    columnsOf :: String -> Query IO [Text],
    -- | refuses a database that is not whole, as far as the database itself can tell
    integrity :: Query IO (),
    -- | refuses values that are not of their columns' types
    valuesTyped :: Query IO (),
    -- | looks at what there is, and answers with what ends a transaction and begins one that no
    -- other program's changes can come into; that waits for at most ten seconds, and refuses what
    -- has come in the place of what there was
    prepareWriting :: IO (Query IO ()),
    -- | makes the table of what is remembered
    makeFormer :: Query IO (),
    -- | whether a column can hold a text
    holdsText :: Text -> Bool,
    -- | write a new store, or in the place of one, whole or not at all; refuses whatever else there
    -- is
    putRows :: Rows -> ExceptT StoreError IO ()
  }

-- | An action on a database; whatever it throws is an answer.
answering :: Backend -> IO a -> ExceptT StoreError IO a
answering backend = withExceptT objection . guarded (meaningOf backend)
  where
    objection (Damaged damage) = DamagedFile (backendName backend) damage
    objection Unknown = TablesDiffer (backendName backend)
    objection (Failed failure) = DatabaseFailed failure

-- | Statements in a transaction of their own, of which nothing is kept where one refuses.
transacted :: SqlBackend -> Query IO a -> IO (Either StoreError a)
transacted backend statements = runSqlConn (runExceptT statements >>= kept) backend
  where
    kept outcome = outcome <$ either (const transactionUndo) (const (pure ())) outcome

-- | The only column of what a question finds.
ask :: PersistField value => String -> Query IO [value]
ask sql = map unSingle <$> lift (rawSql (Text.pack sql) [])
