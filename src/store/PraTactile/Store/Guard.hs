-- | What a database, its binding and the system throw, as answers.
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

-- | What is thrown, by what it means.
data Objection
  = -- | the content is not what it should be
    Damaged Damage
  | -- | the database knows no such table or column
    Unknown
  | -- | it cannot be read or written now
    Failed Failure

-- | Run an action on a database, given what the exceptions of the database mean; whatever it
-- throws, but for what other threads throw at it, is an objection.
guarded :: (SomeException -> Maybe Objection) -> IO a -> ExceptT Objection IO a
guarded meaning action =
  ExceptT $
    (Right <$> action)
      `catches` [ Handler $ \fault -> throwIO (fault :: SomeAsyncException),
                  Handler $ \fault -> pure (Left (fromMaybe (ofSystem fault) (meaning fault)))
                ]

-- | An exception of the system. Values that are not of their column's type, among them text that is
-- not UTF-8, are objected to in many ways, by exceptions of any other kind.
ofSystem :: SomeException -> Objection
ofSystem fault = case fromException fault of
  Just told | not (isUserError told) -> Failed (failureOf told)
  _ -> Damaged ForeignValue

-- | What the system's objection means.
failureOf :: IOException -> Failure
failureOf fault
  | isPermissionError fault = NotPermitted
  | isFullError fault = NoRoom
  | isAlreadyInUseError fault = InUse
  | isDoesNotExistError fault = NoFolder
  | otherwise = SystemRefuses

-- | An objection as the failure to read or write.
failureIn :: Objection -> Failure
failureIn objection = case objection of
  Failed failure -> failure
  _ -> SystemRefuses
