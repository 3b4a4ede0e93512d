-- | Image files in common formats, recognised by their first bytes and not by their names: PGM,
-- PNG, numpy arrays, matrices as text, and exports of Tekscan's programs.
--
-- 0 is no contact. Full scale is the largest value of the type for integers, the maximum value of a
-- PGM, 1 for floating-point numbers and for text, and the saturation pressure of a calibrated
-- export.
module PraTactile.Image.File
  ( -- * Files
    Images,
    imagesSize,
    imagesCount,
    imagesSpacing,
    imagesLevels,
    decodeImages,
    imageSize,
    isPgm,

    -- * Full scale
    fullScales,
    isFullScale,

    -- * One image
    ScaledImage (..),
    numberedImage,

    -- * Writing
    ImageFormat (..),
    imageFormatName,
    encodeImage,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import qualified Data.Vector as Boxed
import Data.Word (Word16)
import PraTactile.Image.Error (ImageError (..))
import PraTactile.Image.File.Matrix
import PraTactile.Image.File.Numpy
import PraTactile.Image.File.Png
import PraTactile.Image.Images
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm)
import PraTactile.Image.Pgm.Decode (decodePgms, formatName, pgmSize)
import PraTactile.Image.Pgm.Type
import PraTactile.PlainText (withoutMark)

-- | The images of a file, each with at most the given number of pixels. Refuses other files, each
-- cause with its own 'ImageError'. The memory is bounded by the file's size and 'maxPixels',
-- whatever the header says.
decodeImages :: Int -> ByteString -> Either ImageError Images
decodeImages most file
  | isNumpy file = decodeNumpy file >>= small
  | isPng file = decodePngFile file >>= small
  | isTekscan file = decodeTekscan file >>= small
  | Nothing <- formatName file, beginsAsMatrix (withoutMark file) = decodeMatrix file >>= small
  | otherwise = do
    (one, others) <- decodePgms most file
    Right
      Images
        { imagesColumns = pgmWidth one,
          imagesRows = pgmHeight one,
          imagesCount = 1 + length others,
          imagesFull = fromIntegral (pgmMaxval one),
          imagesSpacing = Nothing,
          imagesReadings = Several (Boxed.fromList (one : others))
        }
  where
    small images
      | w * h > most = Left (LargerThanTouched most w h)
      | otherwise = Right images
      where
        (w, h) = imagesSize images

-- | A maximum value of PGM with which all readings can be written exactly; the greatest possible
-- one for floating-point readings.
imagesLevels :: Images -> Word16
imagesLevels images = case imagesReadings images of
  Several pgms -> fromIntegral (maximum (fmap pgmMaxval pgms))
  Packed number _ _ _ | numberFull number `elem` [255, 32767] -> round (numberFull number)
  _ -> maxBound

-- | The width and the height of a file's images, from the header alone if the format has one.
imageSize :: ByteString -> Either ImageError (Int, Int)
imageSize file
  | isPng file = pngSize file
  | isPgm file = pgmSize file
  | otherwise = imagesSize <$> decodeImages maxPixels file

-- | Whether a file begins like a PGM file.
isPgm :: ByteString -> Bool
isPgm file = any (`B.isPrefixOf` file) [C.pack "P2", C.pack "P5"]

-- | The width and the height of each image.
imagesSize :: Images -> (Int, Int)
imagesSize images = (imagesColumns images, imagesRows images)

-- | The least and the greatest permitted full scale.
fullScales :: (Double, Double)
fullScales = (1e-9, 1e12)

-- | Whether a reading is within 'fullScales'.
isFullScale :: Double -> Bool
isFullScale full = full >= fst fullScales && full <= snd fullScales

-- | One image of a file. The arguments are the full scale, which overrides the file's, and the
-- number of the image, from 0. Without a number, refuses ('IsMovie') a file with more images than
-- one.
numberedImage :: Maybe Double -> Maybe Int -> Images -> Either ImageError ScaledImage
numberedImage full number images = case number of
  Nothing
    | imagesCount images == 1 -> Right (imageAt full images 0)
    | otherwise -> Left (IsMovie (imagesCount images))
  Just i
    | i < imagesCount images -> Right (imageAt full images i)
    | otherwise -> Left (NoSuchImage i (imagesCount images))

-- | The formats in which an image is written.
data ImageFormat = Pgm | Png | Npy
  deriving stock (Eq, Show, Enum, Bounded)

-- | The format's name, which is also the extension of its files.
imageFormatName :: ImageFormat -> String
imageFormatName format = case format of
  Pgm -> "pgm"
  Png -> "png"
  Npy -> "npy"

-- | The file of an image in a format, with unchanged samples.
encodeImage :: ImageFormat -> Pgm -> ByteString
encodeImage format pgm = case format of
  Pgm -> encodePgm Binary pgm
  Png -> encodePngFile pgm
  Npy -> encodeNumpy (pgmMaxval pgm > 255) (pgmWidth pgm) (pgmHeight pgm) (pgmSamples pgm)
