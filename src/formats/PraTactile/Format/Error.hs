-- | Why a text is not read: one sum for all formats of this library.
module PraTactile.Format.Error
  ( FormatError (..),
    JsonError (..),
    Misfit (..),
    CensusFileError (..),
    RowError (..),
  )
where

import Data.Aeson.Types (JSONPath)
import Data.ByteString (ByteString)
import Data.Text (Text)
import Numeric.Natural (Natural)
import PraTactile.PlainText (OtherEncoding)

-- | Why bytes are not what was to be read.
data FormatError
  = -- | They are no JSON that is read.
    JsonRefused JsonError
  | -- | At this place, from the outermost, stands something else than the format has there.
    Misfit JSONPath Misfit
  | -- | They are no undamaged census file.
    CensusFileRefused CensusFileError
  deriving stock (Eq, Show)

-- | Why a JSON text is not read.
data JsonError
  = -- | It is empty.
    NoText
  | -- | More brackets are within each other than 'PraTactile.Format.Json.Strict.deepest'.
    TooDeep
  | -- | A number has more digits on end than 'PraTactile.Format.Json.Strict.longestNumber'.
    TooLong
  | -- | It holds bytes that are no UTF-8.
    NotUtf8
  | -- | It is text in this encoding, and not in UTF-8.
    JsonInEncoding OtherEncoding
  | -- | It is no JSON.
    NotJson
  | -- | An object in it has this key twice.
    RepeatedKey Text
  deriving stock (Eq, Show)

-- | What a JSON value is instead of what the format has in its place.
data Misfit
  = -- | An object without this key.
    MissingKey Text
  | NotObject
  | NotList
  | NotText
  | -- | Not a text that can be a file's name.
    NotFileName
  | -- | Neither true nor false.
    NotBool
  | -- | No number 0, 1, 2, ..., neither as a JSON number below 10^18 nor as a decimal string.
    NotNatural
  | -- | No whole number of less than 10^18 either way.
    NotInteger
  | -- | A number of more digits than this.
    NaturalTooLong Int
  | -- | No number that a double can have.
    NotReal
  | -- | A number of more than a million.
    BeyondMillion
  | -- | No list of two.
    NotPair
  | -- | No shard: a list of two numbers, the first of them from 1 to the second.
    NotShard
  | -- | No evaluation that lists its presses.
    NotListed
  | -- | No outcome of a press: an object with one of three keys.
    NotOutcome
  | -- | No shape: a list of two numbers, rows and columns.
    NotShape
  | -- | No cell: a list of two numbers, row and column.
    NotCell
  | -- | No factor of a prime less 1: a list of three numbers, prime, exponent and witness.
    NotPrimeWitness
  | -- | A text that is none of these names.
    NotAmong [String] String
  | -- | An object of the first schema instead of the second.
    OtherSchema String String
  | -- | Evidence of no known kind.
    UnknownEvidence String
  | -- | No exact number: a text such as @127/4@ or @31.75@, or a JSON number, of at most 1000
    -- characters.
    NotExact
  | -- | No point: a list of three exact numbers.
    NotPoint
  | -- | No drawing of cells: texts of one length, of @#@ and @.@.
    NotDrawnCells
  | -- | No name of a vertex: a text without spaces.
    NotVertexName
  | -- | Degrees other than 0, 90, 180 and 270.
    NotQuarterTurn
  | -- | No calibration: rows of one length, gains above 0, dead elements among the others.
    NotCalibration
  | -- | Something that may be in a list once and is there already; its name.
    GivenTwice String
  | -- | A manifest without frames.
    NoFrame
  | -- | What this names, such as a constant of a sensor, is not a number from the one to the other.
    OutOfRange String (Double, Double)
  | -- | A constant of a sensor, of this name, in another unit than this, its own.
    OtherUnit String String
  | -- | Degrees that are not from 0 up to 360, or not those of the quarter turn beside them.
    NotAngle
  | -- | No matrix of so many rows and columns.
    NotMatrix Int Int
  | -- | Another number than this one.
    OtherCount Int
  | -- | A digest that is not that of what it stands beside.
    OtherDigest
  | -- | A matrix that is no rotation.
    NotRotation
  | -- | More taxels than this along the side of a region.
    RegionTooLarge Natural
  deriving stock (Eq, Show)

-- | Why a census file is refused; lines are counted from 1, the header's.
data CensusFileError
  = -- | It does not begin with the header line.
    NoCensusHeader
  | -- | The line with this number is no whole row.
    DamagedLine Int RowError
  | -- | The entry on this line does not come after the one before it.
    OutOfOrder Int
  | -- | Its last line has no end.
    CutOff
  | -- | It is of another census or shard.
    OtherCensus
  | -- | Before the row on this line this entry is missing.
    EntryMissing Int Natural
  | -- | The row on this line is not of the entry whose number it has.
    OtherEntry Int
  | -- | The last line, which has no end, is not the beginning of the row that belongs there.
    NotContinued Int
  deriving stock (Eq, Show)

-- | Why a line is no whole row.
data RowError
  = -- | It has the first number of fields instead of the second.
    FieldCount Int Int
  | -- | The check is not that of the row.
    CheckFails
  | -- | This column has this text, which it cannot have.
    FieldForm ByteString ByteString
  | -- | What these columns say cannot all be true.
    Contradicting [ByteString]
  deriving stock (Eq, Show)
