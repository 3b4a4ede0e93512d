{-# LANGUAGE DerivingStrategies #-}

-- | Why a text is not read: one sum for all formats of this library.
module PraTactile.Format.Error
  ( FormatError (..)
  , Misfit (..)
  , CensusFileError (..)
  , RowError (..)
  ) where

import Data.Aeson.Types (JSONPath)
import Data.ByteString (ByteString)
import Data.Text (Text)
import Numeric.Natural (Natural)

-- | Why bytes are not what was to be read.
data FormatError
  = -- | They are no JSON; where and why, in the words of the JSON parser.
    NotJson String
  | -- | An object in them has this key twice.
    RepeatedKey Text
  | -- | At this place, from the top, stands something else than the format has there.
    Misfit JSONPath Misfit
  | -- | They are no undamaged census file.
    CensusFileRefused CensusFileError
  deriving stock (Eq, Show)

-- | What a JSON value is instead of what the format has in its place.
data Misfit
  = -- | A key is missing, or a value is of another type; in the words of the JSON library.
    OtherType String
  | -- | It has the first schema instead of the second.
    OtherSchema String String
  | -- | It is no number 0, 1, 2, ..., neither as a JSON number below 10^18 nor as a decimal string.
    NotNatural
  | -- | It is no shape: a list of two numbers, rows and columns.
    NotShape
  | -- | It is no cell of a mask: a list of two numbers, row and column.
    NotCell
  | -- | It is no factor of a prime less 1: a list of three numbers, prime, exponent and witness.
    NotPrimeWitness
  | -- | It is a text that is none of these names.
    NotAmong [String] String
  | -- | It is the name of no kind of evidence.
    UnknownEvidence String
  | -- | It is a number of degrees other than 0, 90, 180 and 270.
    NotQuarterTurn
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
