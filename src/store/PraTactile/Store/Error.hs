-- | The errors of stores. Databases have the names that may be shown: a file's path, or an address
-- without a password.
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

-- | Why a store cannot be written, opened or queried.
data StoreError
  = -- | there is no such file to open
    NoSuchFile FilePath
  | -- | a directory stands where a file is expected
    IsDirectory FilePath
  | -- | the file cannot be read
    CannotRead FilePath Failure
  | -- | the file cannot be written; its former contents are unchanged
    CannotWrite FilePath Failure
  | -- | something other than a store is there, and is not replaced
    Occupied FilePath Occupant
  | -- | the file does not begin like an SQLite database
    NotADatabase FilePath
  | -- | the file begins like a database but is damaged
    DamagedFile FilePath Damage
  | -- | a database without the metadata of a store
    NotAStore FilePath
  | -- | a store that lacks a table or a column
    TablesDiffer FilePath
  | -- | the store's tables are of another version: found, then expected
    WrongSchemaVersion Int Int
  | -- | the store was made for another profile: found, then expected
    ForeignProfile String String
  | -- | a row of this table is missing, refers to a missing row, or has an invalid negative number
    UnreadableRow Table
  | -- | a row of this table was changed after it was written
    ChangedRow Table
  | -- | the rows of this table are not those that the other tables imply
    RowsDisagree Table
  | -- | the object's vertices and corners do not form a solid
    NotSolid ObjectName Defect
  | -- | the layings do not form a placement
    NotPlaced PlacementError
  | -- | a number beyond the database's 64 bits
    TooLarge Integer
  | -- | the store has no such object, face or cell; with the error of the placement
    NotInStore PlacementError
  | -- | the database cannot execute a statement
    DatabaseFailed Failure
  | -- | the name begins like an address but is malformed; it is not repeated, because it may
    -- contain a password
    UnreadableAddress
  | -- | the name begins with this scheme and @:\/\/@, which is not a scheme of addresses
    UnknownScheme String
  | -- | the program was built without support for servers
    WithoutServers String
  | -- | there is no connection to the server
    Unreachable String Failure
  | -- | the database on the server does not use UTF-8 but this encoding
    WrongEncoding String String
  | -- | the database cannot hold a text
    TextNotHeld String
  deriving stock (Eq, Show)

-- | How a database file is damaged.
data Damage
  = -- | parts of the file are overwritten or missing
    BrokenPages
  | -- | a value has another type than its column
    ForeignValue
  deriving stock (Eq, Show)

-- | Why a file or a server cannot be used.
data Failure
  = -- | another program holds it
    InUse
  | -- | this user lacks the permission
    NotPermitted
  | -- | the disk or the memory is full
    NoRoom
  | -- | there is no such folder, or it cannot be entered
    NoFolder
  | -- | the file's name is not valid text, as the database requires
    NameNotText
  | -- | no server answered
    NoServer
  | -- | the server refused the password, or requires one
    PasswordRefused
  | -- | another reason, whose text might contain a password
    ServerRefuses
  | -- | a parameter after the password is unknown
    UnknownParameter
  | -- | another reason, in the words of the server or the client library
    Refused String
  | -- | the connection to the server was lost
    ConnectionLost
  | -- | the system or the database refused for another reason
    SystemRefuses
  deriving stock (Eq, Show)

-- | The obstacle at the place of a new store.
data Occupant
  = -- | a broken link
    DanglingLink
  | -- | a device, a pipe or a socket
    NoRegularFile
  | -- | a file of another kind
    NoStore
  | -- | other tables with the same names
    OtherTables
  deriving stock (Eq, Show)

-- | The tables.
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

-- | The name of a table in the database.
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
