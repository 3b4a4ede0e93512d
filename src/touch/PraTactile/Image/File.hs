-- | Files of images as people have them, told by what they begin with and not by their names: PGM,
-- PNG, arrays of numpy, matrices as text, and what Tekscan's programs export.
--
-- 0 is no contact. Full scale is the largest value of the type for integers, the maximum value of
-- PGM, 1 for numbers with a point and for text, and the saturation pressure of a calibrated export.
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
    Felt (..),
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

-- | The images of a file, each of at most this many pixels. Refuses what is no such file, each
-- cause with its own 'ImageError'; the memory taken is bounded by the file's own size and
-- 'maxPixels', whatever its header says.
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

-- | The reading of full contact of a PGM image in which all readings stand as they are; where they
-- are numbers with a point, the greatest there is.
imagesLevels :: Images -> Word16
imagesLevels images = case imagesReadings images of
  Several pgms -> fromIntegral (maximum (fmap pgmMaxval pgms))
  Packed number _ _ _ | numberFull number `elem` [255, 32767] -> round (numberFull number)
  _ -> maxBound

-- | The width and the height of a file's images, by its header where it has one.
imageSize :: ByteString -> Either ImageError (Int, Int)
imageSize file
  | isPng file = pngSize file
  | isPgm file = pgmSize file
  | otherwise = imagesSize <$> decodeImages maxPixels file

-- | Whether a file begins as PGM does.
isPgm :: ByteString -> Bool
isPgm file = any (`B.isPrefixOf` file) [C.pack "P2", C.pack "P5"]

-- | The width and the height of each.
imagesSize :: Images -> (Int, Int)
imagesSize images = (imagesColumns images, imagesRows images)

-- | The least and the greatest reading that may be full contact.
fullScales :: (Double, Double)
fullScales = (1e-9, 1e12)

-- | Whether a reading lies between them.
isFullScale :: Double -> Bool
isFullScale full = full >= fst fullScales && full <= snd fullScales

-- | The image of this number, from 0, or the only one, given the reading of full contact if the
-- file does not tell.
numberedImage :: Maybe Double -> Maybe Int -> Images -> Either ImageError Felt
numberedImage full number images = case number of
  Nothing
    | imagesCount images == 1 -> Right (imageAt full images 0)
    | otherwise -> Left (IsMovie (imagesCount images))
  Just i
    | i < imagesCount images -> Right (imageAt full images i)
    | otherwise -> Left (NoSuchImage i (imagesCount images))

-- | The forms in which an image is written.
data ImageFormat = Pgm | Png | Npy
  deriving stock (Eq, Show, Enum, Bounded)

-- | Its name, which is also the end of its files' names.
imageFormatName :: ImageFormat -> String
imageFormatName format = case format of
  Pgm -> "pgm"
  Png -> "png"
  Npy -> "npy"

-- | A file of an image, with its samples as they are.
encodeImage :: ImageFormat -> Pgm -> ByteString
encodeImage format pgm = case format of
  Pgm -> encodePgm Binary pgm
  Png -> encodePngFile pgm
  Npy -> encodeNumpy (pgmMaxval pgm > 255) (pgmWidth pgm) (pgmHeight pgm) (pgmSamples pgm)
