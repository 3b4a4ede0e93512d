-- | What the database, its binding and the system throw, as answers.
module PraTactile.Store.Guard
  ( Objection (..),
    guarded,
    failureOf,
    failureIn,
  )
where

import Control.Exception
  ( Handler (..),
    IOException,
    SomeAsyncException,
    SomeException,
    catches,
    throwIO,
  )
import Control.Monad.Trans.Except (ExceptT (..))
import Database.Sqlite (Error (..), SqliteException (..))
import PraTactile.Store.Error
import System.IO.Error
  ( isAlreadyInUseError,
    isDoesNotExistError,
    isFullError,
    isPermissionError,
    isUserError,
  )

-- | What is thrown, by what it means.
data Objection
  = -- | the file's content is not what it should be
    Damaged Damage
  | -- | the database knows no such table or column
    Unknown
  | -- | the file cannot be read or written now
    Failed Failure

-- Note [SQLite's error codes] The binding calls SQLite's code 26, "not a database",
-- ErrorNotAConnection; it takes the codes 11, "corrupt", and 12, "not found", for each other; and
-- on a code that it does not know it throws an ErrorCall. Nothing asked here can be "not found", so
-- both count as damage. Code 1 is the one for statements that do not fit the tables.

-- | Run an action on a database; whatever it throws, but for what other threads throw at it, is an
-- objection.
guarded :: IO a -> ExceptT Objection IO a
guarded action =
  ExceptT $
    (Right <$> action)
      `catches` [ Handler $ \fault -> throwIO (fault :: SomeAsyncException),
                  Handler $ \fault -> pure (Left (ofDatabase (seError fault))),
                  Handler $ \fault ->
                    pure
                      ( Left
                          ( if isUserError fault
                              then Damaged ForeignValue
                              else Failed (failureOf fault)
                          )
                      ),
                  Handler anythingElse
                ]
  where
    -- Values that are not of their column's type, among them text that is not UTF-8, are objected
    -- to in many ways.
    anythingElse :: SomeException -> IO (Either Objection a)
    anythingElse _ = pure (Left (Damaged ForeignValue))

ofDatabase :: Error -> Objection
ofDatabase code = case code of
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

-- | What the system's objection means.
failureOf :: IOException -> Failure
failureOf fault
  | isPermissionError fault = NotPermitted
  | isFullError fault = NoRoom
  | isAlreadyInUseError fault = InUse
  | isDoesNotExistError fault = NoFolder
  | otherwise = SystemRefuses

-- | An objection as the failure to read or write a file.
failureIn :: Objection -> Failure
failureIn objection = case objection of
  Failed failure -> failure
  _ -> SystemRefuses
