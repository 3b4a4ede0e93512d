-- | The errors of all formats of this library.
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

-- | Why bytes are refused.
data FormatError
  = -- | They are not accepted as JSON.
    JsonRefused JsonError
  | -- | The value at this path of keys and indices, the outermost first, does not fit the format.
    Misfit JSONPath Misfit
  | -- | They are not an intact census file.
    CensusFileRefused CensusFileError
  deriving stock (Eq, Show)

-- | Why a JSON text is refused.
data JsonError
  = -- | It is empty.
    NoText
  | -- | Brackets are nested deeper than 'PraTactile.Format.Json.Strict.deepest'.
    TooDeep
  | -- | A number has more consecutive digits than 'PraTactile.Format.Json.Strict.longestNumber'.
    TooLong
  | -- | It is not valid UTF-8.
    NotUtf8
  | -- | It is text in this encoding, not in UTF-8.
    JsonInEncoding OtherEncoding
  | -- | It is not JSON.
    NotJson
  | -- | An object in it repeats this key.
    RepeatedKey Text
  deriving stock (Eq, Show)

-- | How a JSON value does not fit the format.
data Misfit
  = -- | An object lacks this key.
    MissingKey Text
  | -- | Not an object.
    NotObject
  | -- | Not a list.
    NotList
  | -- | Not a text.
    NotText
  | -- | Not a text that can be a file name.
    NotFileName
  | -- | Neither true nor false.
    NotBool
  | -- | Not a natural number: neither a JSON number below 10^18 nor a decimal string.
    NotNatural
  | -- | Not an integer between -10^18 and 10^18.
    NotInteger
  | -- | A number with more digits than this.
    NaturalTooLong Int
  | -- | Not a number in the range of a double.
    NotReal
  | -- | A number above a million.
    BeyondMillion
  | -- | Not a list of two.
    NotPair
  | -- | Not a shard: a list of two numbers, where the first is between 1 and the second.
    NotShard
  | -- | An evaluation without a list of its presses.
    NotListed
  | -- | Not an outcome of a press: an object with one of three keys.
    NotOutcome
  | -- | Not a shape: a list of two numbers, rows and columns.
    NotShape
  | -- | Not a cell: a list of two numbers, row and column.
    NotCell
  | -- | Not a factor of a prime minus 1: a list of three numbers, prime, exponent and witness.
    NotPrimeWitness
  | -- | A text, the second one, that is not one of these names.
    NotAmong [String] String
  | -- | An object of the first schema instead of the second.
    OtherSchema String String
  | -- | An unknown kind of evidence.
    UnknownEvidence String
  | -- | Not an exact number: a text such as @127/4@ or @31.75@, or a JSON number, of at most 1000
    -- characters.
    NotExact
  | -- | Not a point: a list of three exact numbers.
    NotPoint
  | -- | Not a drawing of cells: texts of equal length, of @#@ and @.@.
    NotDrawnCells
  | -- | Not a vertex name: a text without spaces.
    NotVertexName
  | -- | Degrees other than 0, 90, 180 and 270.
    NotQuarterTurn
  | -- | Not a calibration: rows of equal length, positive gains, dead elements inside.
    NotCalibration
  | -- | The value with this name is repeated in a list where it may occur once.
    GivenTwice String
  | -- | A manifest without frames.
    NoFrame
  | -- | The value with this name, such as a sensor's constant, is outside the range from the first
    -- number to the second.
    OutOfRange String (Double, Double)
  | -- | The sensor's constant with this name has another unit than the second text, which is its
    -- own.
    OtherUnit String String
  | -- | Degrees outside [0, 360), or not equal to those of the quarter turn beside them.
    NotAngle
  | -- | Not a matrix with these numbers of rows and columns.
    NotMatrix Int Int
  | -- | The number is not this one.
    OtherCount Int
  | -- | The digest does not match the contents.
    OtherDigest
  | -- | A matrix that is not a rotation.
    NotRotation
  | -- | More taxels than this along a side of a region.
    RegionTooLarge Natural
  deriving stock (Eq, Show)

-- | Why a census file is refused. Lines are counted from 1, which is the header.
data CensusFileError
  = -- | It does not begin with the header line.
    NoCensusHeader
  | -- | The line with this number is not a valid row.
    DamagedLine Int RowError
  | -- | The entry on this line does not follow the one before it.
    OutOfOrder Int
  | -- | The last line is incomplete.
    CutOff
  | -- | It belongs to another census or shard.
    OtherCensus
  | -- | Before the row on this line, this entry is missing.
    EntryMissing Int Natural
  | -- | The row on this line does not belong to the entry whose number it has.
    OtherEntry Int
  | -- | The last line, which is incomplete, is not the beginning of the row that belongs there.
    NotContinued Int
  deriving stock (Eq, Show)

-- | Why a line is not a valid row.
data RowError
  = -- | It has the first number of fields instead of the second.
    FieldCount Int Int
  | -- | The check does not match the row.
    CheckFails
  | -- | This column has this invalid text.
    FieldForm ByteString ByteString
  | -- | These columns contradict each other.
    Contradicting [ByteString]
  deriving stock (Eq, Show)
