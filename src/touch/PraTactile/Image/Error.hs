{-# OPTIONS_HADDOCK hide #-}

-- | The error sum of the image layer: what can be wrong with an image as numbers
-- ("PraTactile.Image") or as a file ("PraTactile.Image.Pgm").
module PraTactile.Image.Error
  ( -- * The error sum
    ImageError (..),
    HeaderField (..),
    PngProblem (..),
  )
where

import Data.ByteString (ByteString)
import Numeric.Natural (Natural)
import PraTactile.PlainText (OtherEncoding)

-- | Why there is no image. One constructor a cause.
data ImageError
  = -- | The rows differ in length: the zero-based row, its length, the first row's length.
    RaggedRow !Int !Int !Int
  | -- | Width, height and a number of values that is not their product.
    WrongValueCount !Int !Int !Int
  | -- | Two rasters that must agree in size: width and height of the one and of the other.
    SizesDiffer !(Int, Int) !(Int, Int)
  | -- | A rectangle (x, y, width, height) that does not lie in an image of that width and height.
    OutsideImage !(Int, Int, Int, Int) !(Int, Int)
  | -- | A width or height of zero, where an image is needed.
    ZeroSize !Natural !Natural
  | -- | More pixels than 'PraTactile.Image.Pgm.maxPixels': width and height.
    TooManyPixels !Natural !Natural
  | -- | More pixels than this many, which are the most of an image of what was touched: width and
    -- height.
    LargerThanTouched !Int !Int !Int
  | -- | The file does not begin with a PGM's @P2@ or @P5@; its first bytes (at most eight).
    NotPgm !ByteString
  | -- | A number of the header is missing or malformed: which one, and the bytes found there (at
    -- most eight).
    BadHeader !HeaderField !ByteString
  | -- | A maximum value outside 1 to 65535.
    MaxvalOutOfRange !Natural
  | -- | Something other than a number among the samples of a plain (P2) file: the zero-based
    -- sample, and the bytes found there (at most eight).
    BadSample !Int !ByteString
  | -- | The file ends too soon: samples needed, samples found.
    Truncated !Int !Int
  | -- | A sample above the maximum value: zero-based x and y, the sample, the maximum value.
    SampleAboveMaxval !(Int, Int) !Natural !Int
  | -- | Something other than white space follows the image: how many bytes there are from it on.
    TrailingData !Int
  | -- | The file has this many images, where one is needed.
    IsMovie !Int
  | -- | The file's image of this number, from 0, was asked for, and it has so many.
    NoSuchImage !Int !Int
  | -- | A file that begins as numpy's has no header that can be read.
    NumpyHeader
  | -- | A file of numpy's has numbers of another type than is read: its description.
    NumpyType !ByteString
  | -- | A file of numpy's has this shape, neither of two dimensions nor of three.
    NumpyShape ![Integer]
  | -- | A PNG file is none that is read.
    PngRefused !PngProblem
  | -- | A text is in this encoding, and not in UTF-8.
    ImageInEncoding !OtherEncoding
  | -- | The line and the field of a text, from 1, that is no number; what it is.
    NotNumber !Int !Int !ByteString
  | -- | The line, from 1, with a decimal comma; what has it.
    DecimalComma !Int !ByteString
  | -- | An export of Tekscan's lacks a key of its header, or has another value than can be.
    TekscanHeader !String
  | -- | An export of Tekscan's lacks the frame of this number, or some rows of it.
    TekscanFrame !Integer
  | -- | Columns and rows are not equally far apart, millimetres.
    UnequalSpacing !Double !Double
  deriving stock (Eq, Show)

-- | Why a PNG file is not read.
data PngProblem
  = -- | It cannot be decoded.
    PngBroken
  | -- | It has neither 8 nor 16 bits a sample.
    PngDepth
  | -- | It has colours, or transparency.
    PngPalette
  | PngTransparent
  | PngColour
  deriving stock (Eq, Show, Enum, Bounded)

-- | A number of the PGM header.
data HeaderField = HeaderWidth | HeaderHeight | HeaderMaxval
  deriving stock (Eq, Show, Enum, Bounded)
