{-# OPTIONS_HADDOCK hide #-}

-- | The errors of the image layer: of images as numbers ("PraTactile.Image") and of image files
-- ("PraTactile.Image.File").
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

-- | Why an image is refused. Each cause has one constructor.
data ImageError
  = -- | The rows differ in length: the zero-based row, its length, the first row's length.
    RaggedRow !Int !Int !Int
  | -- | The number of values is not width times height: width, height, number of values.
    WrongValueCount !Int !Int !Int
  | -- | Two rasters differ in size: width and height of each.
    SizesDiffer !(Int, Int) !(Int, Int)
  | -- | A rectangle (x, y, width, height) does not lie in the image, whose width and height
    -- follow.
    OutsideImage !(Int, Int, Int, Int) !(Int, Int)
  | -- | The width or the height is zero.
    ZeroSize !Natural !Natural
  | -- | More pixels than 'PraTactile.Image.Pgm.maxPixels': width and height.
    TooManyPixels !Natural !Natural
  | -- | More pixels than the largest composite may have: that limit, width and height.
    LargerThanTouched !Int !Int !Int
  | -- | The file does not begin with @P2@ or @P5@; its first bytes (at most eight).
    NotPgm !ByteString
  | -- | A number of the header is missing or malformed: which one, and the bytes found there (at
    -- most eight).
    BadHeader !HeaderField !ByteString
  | -- | A maximum value of PGM outside 1 to 65535.
    MaxvalOutOfRange !Natural
  | -- | A sample of a plain (P2) file is not a number: the zero-based sample, and the bytes found
    -- there (at most eight).
    BadSample !Int !ByteString
  | -- | The file ends too soon: samples needed, samples found.
    Truncated !Int !Int
  | -- | A sample above the maximum value: zero-based x and y, the sample, the maximum value.
    SampleAboveMaxval !(Int, Int) !Natural !Int
  | -- | Something other than white space follows the image: the number of bytes after it.
    TrailingData !Int
  | -- | The file has this many images; exactly one was expected.
    IsMovie !Int
  | -- | The file has no image with this number (counted from 0), since it has that many.
    NoSuchImage !Int !Int
  | -- | A numpy file with an unreadable header.
    NumpyHeader
  | -- | A numpy file with an unsupported number type: its description.
    NumpyType !ByteString
  | -- | A numpy file with a shape that has neither two nor three dimensions.
    NumpyShape ![Integer]
  | -- | A PNG file that is not supported.
    PngRefused !PngProblem
  | -- | A text file in this encoding, not in UTF-8.
    ImageInEncoding !OtherEncoding
  | -- | A field of a text file is not a number: line and field (from 1), and its text.
    NotNumber !Int !Int !ByteString
  | -- | A number with a decimal comma: its line (from 1) and its text.
    DecimalComma !Int !ByteString
  | -- | A Tekscan export lacks this key in its header, or the key's value is invalid. It is @COLS@
    -- if the first row has another number of values.
    TekscanHeader !String
  | -- | A Tekscan export lacks the frame with this number, or some of its rows.
    TekscanFrame !Integer
  | -- | Columns and rows have different spacings, in millimetres.
    UnequalSpacing !Double !Double
  deriving stock (Eq, Show)

-- | Why a PNG file is refused.
data PngProblem
  = -- | It cannot be decoded.
    PngBroken
  | -- | It has neither 8 nor 16 bits per sample.
    PngDepth
  | -- | It has a palette, transparency or colours.
    PngPalette
  | PngTransparent
  | PngColour
  deriving stock (Eq, Show, Enum, Bounded)

-- | A number of the PGM header.
data HeaderField = HeaderWidth | HeaderHeight | HeaderMaxval
  deriving stock (Eq, Show, Enum, Bounded)
