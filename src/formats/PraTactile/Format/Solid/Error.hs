{-# OPTIONS_HADDOCK hide #-}

-- | The errors of reading polyhedra.
module PraTactile.Format.Solid.Error
  ( SolidFileError (..),
    Place (..),
    Fault (..),
  )
where

import PraTactile.Format.Error (FormatError)
import PraTactile.PlainText (OtherEncoding)

-- | Why a file of a polyhedron is refused.
data SolidFileError
  = -- | a fault with its place
    SolidFileError Place Fault
  | -- | a fault of the JSON format
    ObjectRefused FormatError
  deriving stock (Eq, Show)

-- | A place in a file.
data Place
  = -- | lines are counted from 1
    AtLine Int
  | -- | bytes are counted from 0
    AtByte Int
  deriving stock (Eq, Ord, Show)

-- | A fault at a place in a file.
data Fault
  = -- | this was expected, and something else is there
    Needed String
  | -- | the file ends where this was expected
    Ends String
  | -- | this is not a number
    NotNumber
  | -- | a coordinate is NaN or infinite
    NotFinite
  | -- | a coordinate is above 10^300, or has more than 400 decimal places
    TooLargeOrFine
  | -- | a face has this vertex, numbered as the format counts them; the file has only the second
    -- number of vertices
    NoSuchVertex Integer Int
  | -- | the file should have the first number of bytes by its number of triangles, but has the
    -- second
    LengthDiffers Integer Int
  | -- | the file is text in this encoding, not in UTF-8
    FileInEncoding OtherEncoding
  | -- | the common denominator of the fractions is too large to compute with
    NoCommonDenominator
  deriving stock (Eq, Show)
