{-# OPTIONS_HADDOCK hide #-}

-- | Why bytes are no polyhedron of a format.
module PraTactile.Format.Solid.Error
  ( SolidFileError (..),
    Place (..),
    Fault (..),
  )
where

import PraTactile.Format.Error (FormatError)
import PraTactile.PlainText (OtherEncoding)

-- | What is wrong, and where.
data SolidFileError
  = SolidFileError Place Fault
  | -- | of JSON
    ObjectRefused FormatError
  deriving stock (Eq, Show)

-- | A place in a file.
data Place
  = -- | lines are counted from 1
    AtLine Int
  | -- | bytes are counted from 0
    AtByte Int
  deriving stock (Eq, Ord, Show)

-- | What is wrong there.
data Fault
  = -- | this is needed, and something else is there
    Needed String
  | -- | the file ends, and this is still to come
    Ends String
  | -- | this is no number
    NotNumber
  | -- | a coordinate is not a number, or infinite
    NotFinite
  | -- | a coordinate is beyond 10^300, or has more than 400 decimal places
    TooLargeOrFine
  | -- | a face has this vertex, as the format counts them, and there are so many
    NoSuchVertex Integer Int
  | -- | a file with so many triangles has the first number of bytes, and this one the second
    LengthDiffers Integer Int
  | -- | the file is text in this encoding, and not in UTF-8
    FileInEncoding OtherEncoding
  | -- | the fractions have no common denominator of a size that one can compute with
    NoCommonDenominator
  deriving stock (Eq, Show)
