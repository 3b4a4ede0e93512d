-- | Converts exceptions of a database, its binding and the system to errors.
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
    fromException,
    throwIO,
  )
import Control.Monad.Trans.Except (ExceptT (..))
import Data.Maybe (fromMaybe)
import PraTactile.Store.Error
import System.IO.Error
  ( isAlreadyInUseError,
    isDoesNotExistError,
    isFullError,
    isPermissionError,
    isUserError,
  )

-- | The meaning of an exception.
data Objection
  = -- | the contents are damaged
    Damaged Damage
  | -- | a table or column is unknown
    Unknown
  | -- | the database cannot be read or written now
    Failed Failure

-- | Runs an action on a database. The function interprets the database's exceptions. All
-- exceptions become objections, except asynchronous ones.
guarded :: (SomeException -> Maybe Objection) -> IO a -> ExceptT Objection IO a
guarded meaning action =
  ExceptT $
    (Right <$> action)
      `catches` [ Handler $ \fault -> throwIO (fault :: SomeAsyncException),
                  Handler $ \fault -> pure (Left (fromMaybe (ofSystem fault) (meaning fault)))
                ]

-- | The meaning of an exception of the system. A value of a wrong type, such as text that is not
-- UTF-8, can cause exceptions of any other kind.
ofSystem :: SomeException -> Objection
ofSystem fault = case fromException fault of
  Just told | not (isUserError told) -> Failed (failureOf told)
  _ -> Damaged ForeignValue

-- | The failure that a system exception means.
failureOf :: IOException -> Failure
failureOf fault
  | isPermissionError fault = NotPermitted
  | isFullError fault = NoRoom
  | isAlreadyInUseError fault = InUse
  | isDoesNotExistError fault = NoFolder
  | otherwise = SystemRefuses

-- | The failure to read or write that an objection means.
failureIn :: Objection -> Failure
failureIn objection = case objection of
  Failed failure -> failure
  _ -> SystemRefuses
