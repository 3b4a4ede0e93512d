{-# LANGUAGE DerivingStrategies #-}

-- | What can go wrong between a placement and a file that holds it.
module PraTactile.Store.Error
  ( StoreError (..)
  , Damage (..)
  , Failure (..)
  , Occupant (..)
  ) where

import PraTactile.Object.Placement (PlacementError)
import PraTactile.Object.Relation (RelationError, Table)

-- | Why a store cannot be written, opened or asked.
data StoreError
  = NoSuchFile FilePath
    -- ^ there is no such file to open
  | IsDirectory FilePath
    -- ^ a directory stands where a file is meant
  | CannotRead FilePath Failure
    -- ^ the file cannot be read
  | CannotWrite FilePath Failure
    -- ^ the file cannot be written; whatever was there before still is
  | Occupied FilePath Occupant
    -- ^ what is there is no store, and so it is not replaced
  | NotADatabase FilePath
    -- ^ the file does not begin as an SQLite database does
  | DamagedFile FilePath Damage
    -- ^ the file begins as a database, but not all of it is one
  | NotAStore FilePath
    -- ^ a database, but without the metadata of a store
  | TablesDiffer FilePath
    -- ^ a store that lacks a table or a column
  | WrongSchemaVersion Int Int
    -- ^ the store's tables are of another version: found, then expected
  | ForeignProfile String String
    -- ^ the store was made for another profile: found, then expected
  | UnreadableRow Table
    -- ^ a row of this table refers to a row that is not there, or has a negative number where there can be none
  | InconsistentRows RelationError
    -- ^ the rows can be read, but they contradict each other
  | ChangedRows
    -- ^ the rows agree with each other, but they are not those that were written
  | NotStorable Rational
    -- ^ a length in millimetres is no whole number of micrometres, or beyond a kilometre
  | TooLarge Integer
    -- ^ a number beyond the database's 64 bits
  | NotInStore PlacementError
    -- ^ the store has no such object, face or cell; what the placement itself would answer
  | DatabaseFailed Failure
    -- ^ the database does not carry out a statement
  deriving stock (Eq, Show)

-- | In which way a file is not wholly a database.
data Damage
  = BrokenPages
    -- ^ parts of the file are overwritten or missing
  | ForeignValue
    -- ^ a value is not of its column's type
  deriving stock (Eq, Show)

-- | Why a file cannot be read or written.
data Failure
  = InUse
    -- ^ another program holds it
  | NotPermitted
    -- ^ this user may not
  | NoRoom
    -- ^ the disk or the memory is full
  | NoFolder
    -- ^ there is no such folder, or it cannot be entered
  | NameNotText
    -- ^ the file's name is not valid text, which the database needs
  | SystemRefuses
    -- ^ the system or the database refuses for another reason
  deriving stock (Eq, Show)

-- | What is where a store is to be written.
data Occupant
  = DanglingLink
    -- ^ a link to nothing
  | NoRegularFile
    -- ^ a device, a pipe or a socket
  | NoStore
    -- ^ a file of something else
  deriving stock (Eq, Show)
