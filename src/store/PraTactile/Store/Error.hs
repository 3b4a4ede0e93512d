{-# LANGUAGE DerivingStrategies #-}

-- | What can go wrong between a placement and a file that holds it.
module PraTactile.Store.Error
  ( StoreError (..)
  ) where

import PraTactile.Object.Placement (PlacementError)
import PraTactile.Object.Relation (RelationError, Table)

-- | Why a store cannot be written, opened or asked.
data StoreError
  = NoSuchFile FilePath
    -- ^ there is no such file to open
  | IsDirectory FilePath
    -- ^ a directory stands where a file is meant
  | CannotRead FilePath String
    -- ^ the system does not let the file be read, and says why
  | CannotWrite FilePath String
    -- ^ the file cannot be written, and the system or the database says why; whatever was there before still is
  | NotADatabase FilePath
    -- ^ the file does not begin as an SQLite database does
  | DamagedFile FilePath String
    -- ^ the file begins as a database, but it is cut off or overwritten; what the database says of it
  | NotAStore FilePath
    -- ^ a database, but without the metadata of a store
  | WrongSchemaVersion Int Int
    -- ^ the store's tables are of another version: found, then expected
  | ForeignProfile String String
    -- ^ the store was made for another profile: found, then expected
  | UnreadableRow Table
    -- ^ a row of this table refers to a row that is not there, or has a negative number where there can be none
  | InconsistentRows RelationError
    -- ^ the rows can be read, but they contradict each other
  | NotStorable Rational
    -- ^ a length in millimetres is no whole number of micrometres, or beyond a kilometre
  | TooLarge Integer
    -- ^ a number beyond the database's 64 bits
  | NotInStore PlacementError
    -- ^ the store has no such object, face or cell; what the placement itself would answer
  | DatabaseFailed String
    -- ^ the database does not carry out a statement, and says why
  deriving stock (Eq, Show)
