-- | What can go wrong between a placement and a database that holds it. A database has the name
-- under which it is shown: a file's path, or an address without a password.
module PraTactile.Store.Error
  ( StoreError (..),
    Damage (..),
    Failure (..),
    Occupant (..),
    Table (..),
    tableName,
  )
where

import PraTactile.Object.Placement (PlacementError)
import PraTactile.Object.WingedEdge (Defect, ObjectName)

-- | Why a store cannot be written, opened or asked.
data StoreError
  = -- | there is no such file to open
    NoSuchFile FilePath
  | -- | a directory stands where a file is meant
    IsDirectory FilePath
  | -- | the file cannot be read
    CannotRead FilePath Failure
  | -- | the file cannot be written; whatever was there before still is
    CannotWrite FilePath Failure
  | -- | what is there is no store, and so it is not replaced
    Occupied FilePath Occupant
  | -- | the file does not begin as an SQLite database does
    NotADatabase FilePath
  | -- | the file begins as a database, but not all of it is one
    DamagedFile FilePath Damage
  | -- | a database, but without the metadata of a store
    NotAStore FilePath
  | -- | a store that lacks a table or a column
    TablesDiffer FilePath
  | -- | the store's tables are of another version: found, then expected
    WrongSchemaVersion Int Int
  | -- | the store was made for another profile: found, then expected
    ForeignProfile String String
  | -- | a row of this table is missing, refers to a row that is not there, or has a negative number
    -- where there can be none
    UnreadableRow Table
  | -- | a row of this table is not as it was written
    ChangedRow Table
  | -- | the rows of this table are not those that the others imply
    RowsDisagree Table
  | -- | the object's vertices and corners make no solid
    NotSolid ObjectName Defect
  | -- | the layings make no placement
    NotPlaced PlacementError
  | -- | a number beyond the database's 64 bits
    TooLarge Integer
  | -- | the store has no such object, face or cell; what the placement itself would answer
    NotInStore PlacementError
  | -- | the database does not carry out a statement
    DatabaseFailed Failure
  | -- | the name begins as an address does, and is none; it is not repeated, for a password could
    -- be anywhere in it
    UnreadableAddress
  | -- | the name begins with this scheme and @:\/\/@, which no address does
    UnknownScheme String
  | -- | the program was built without what asks a server
    WithoutServers String
  | -- | there is no connection to the server
    Unreachable String Failure
  | -- | the database on the server has texts in another encoding than UTF-8: this one
    WrongEncoding String String
  | -- | a text that the database cannot hold
    TextNotHeld String
  deriving stock (Eq, Show)

-- | In which way a file is not wholly a database.
data Damage
  = -- | parts of the file are overwritten or missing
    BrokenPages
  | -- | a value is not of its column's type
    ForeignValue
  deriving stock (Eq, Show)

-- | Why a file cannot be read or written.
data Failure
  = -- | another program holds it
    InUse
  | -- | this user may not
    NotPermitted
  | -- | the disk or the memory is full
    NoRoom
  | -- | there is no such folder, or it cannot be entered
    NoFolder
  | -- | the file's name is not valid text, which the database needs
    NameNotText
  | -- | no server answers
    NoServer
  | -- | the server refuses the password, or that there is none
    PasswordRefused
  | -- | there is no connection for another reason, which would tell what may be a password
    ServerRefuses
  | -- | the parameters that follow the password are not all known
    UnknownParameter
  | -- | there is no connection for another reason: the server's or the client library's own words
    Refused String
  | -- | the server, or the way to it, is gone
    ConnectionLost
  | -- | the system or the database refuses for another reason
    SystemRefuses
  deriving stock (Eq, Show)

-- | What is where a store is to be written.
data Occupant
  = -- | a link to nothing
    DanglingLink
  | -- | a device, a pipe or a socket
    NoRegularFile
  | -- | a file of something else
    NoStore
  | -- | tables of something else, of the same names
    OtherTables
  deriving stock (Eq, Show)

-- | The tables, by the names that the database gives them.
data Table
  = MetadataTable
  | ObjectTable
  | VertexTable
  | FaceTable
  | CornerTable
  | EdgeTable
  | LayingTable
  | BandTable
  | RunTable
  | FormerTable
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | As the database has it.
tableName :: Table -> String
tableName table = case table of
  MetadataTable -> "metadata"
  ObjectTable -> "object"
  VertexTable -> "vertex"
  FaceTable -> "face"
  CornerTable -> "corner"
  EdgeTable -> "edge"
  LayingTable -> "laying"
  BandTable -> "band"
  RunTable -> "run"
  FormerTable -> "former_laying"
