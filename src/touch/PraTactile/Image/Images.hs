{-# OPTIONS_HADDOCK hide #-}

-- | The images of one file, all of one size, with the readings as stored.
module PraTactile.Image.Images
  ( Images (..),
    Readings (..),
    Number (..),
    numberBytes,
    numberFull,
    ScaledImage (..),
    imageAt,
  )
where

import qualified Data.Bits as Bits
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import Data.Int (Int16, Int32)
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import qualified Data.Vector as Boxed
import qualified Data.Vector.Storable as V
import Data.Word (Word16, Word64)
import GHC.Float (castWord32ToFloat, castWord64ToDouble, float2Double)
import PraTactile.Image (Raster, constant, raster)
import PraTactile.Image.Pgm.Type (Pgm, pgmMaxval, pgmSamples)
import PraTactile.Sensor.Dead (filled)

-- | One or more images of one size.
data Images = Images
  { imagesColumns :: !Int,
    imagesRows :: !Int,
    imagesCount :: !Int,
    -- | The full scale that the file gives. Each image of a PGM file has its own.
    imagesFull :: !Double,
    -- | The distance of neighbouring taxels in millimetres, if the file gives it.
    imagesSpacing :: !(Maybe Double),
    imagesReadings :: !Readings
  }
  deriving stock (Eq, Show)

-- | The readings of all images. NaN means that a reading is missing.
data Readings
  = -- | Consecutive machine numbers: their type; whether the most significant byte of each comes
    -- first; whether the last index, the column, varies fastest; their bytes.
    Packed !Number !Bool !Bool !ByteString
  | -- | The numbers of all images, one image after the other and row by row.
    Listed !(V.Vector Double)
  | -- | Each image as a PGM.
    Several !(Boxed.Vector Pgm)
  deriving stock (Eq, Show)

-- | A type of machine numbers: unsigned (U), signed (I) or floating-point (F), and the number of
-- its bytes.
data Number = U1 | U2 | I2 | I4 | F4 | F8
  deriving stock (Eq, Show, Enum, Bounded)

-- | The number of bytes of a type.
numberBytes :: Number -> Int
numberBytes number = case number of
  U1 -> 1
  U2 -> 2
  I2 -> 2
  I4 -> 4
  F4 -> 4
  F8 -> 8

-- | The full scale of a type: its largest integer, or 1 for floating-point numbers.
numberFull :: Number -> Double
numberFull number = case number of
  U1 -> 255
  U2 -> 65535
  I2 -> 32767
  I4 -> 2147483647
  F4 -> 1
  F8 -> 1

-- | An image as shares of full scale, 0 to 1.
data ScaledImage = ScaledImage
  { scaledImage :: !Raster,
    -- | Rows and columns (from 0) of taxels without a reading. Each has the mean of its nearest
    -- neighbours instead.
    scaledDead :: ![(Int, Int)],
    -- | The number of readings above full scale, which become 1.
    scaledClipped :: Int
  }
  deriving stock (Eq, Show)

-- | One image as shares of full scale. Arguments: the full scale, if it overrides the file's; the
-- images; the number of the image, from 0, which must exist.
imageAt :: Maybe Double -> Images -> Int -> ScaledImage
imageAt given images i =
  ScaledImage
    { scaledImage = either (const (constant w h 0)) id (raster w h shares),
      scaledDead = dead,
      scaledClipped = V.length (V.filter (> full) readings)
    }
  where
    (w, h) = (imagesColumns images, imagesRows images)
    full = fromMaybe (fullOf images i) given
    readings = readingsAt images i
    dead
      | whole (imagesReadings images) = []
      | otherwise = [k `quotRem` w | k <- V.toList (V.findIndices isNaN readings)]
    shares = filled (w, h) (Set.fromDistinctAscList dead) (V.map share readings)
    share reading
      | reading >= full = 1
      | reading > 0 = reading / full
      | otherwise = 0 -- what is not a number, too

-- | Whether the readings are integers, so that none is missing.
whole :: Readings -> Bool
whole readings = case readings of
  Packed number _ _ _ -> number `notElem` [F4, F8]
  Listed _ -> False
  Several _ -> True

-- | The full scale that the file gives for the image with this number.
fullOf :: Images -> Int -> Double
fullOf images i = case imagesReadings images of
  Several pgms -> fromIntegral (pgmMaxval (pgms Boxed.! i))
  _ -> imagesFull images

-- | The readings of the image with this number, row by row.
readingsAt :: Images -> Int -> V.Vector Double
readingsAt images i = case imagesReadings images of
  Several pgms -> V.map fromIntegral (pgmSamples (pgms Boxed.! i))
  Listed numbers -> V.slice (i * w * h) (w * h) numbers
  Packed number big rowMajor bytes
    | rowMajor -> numbersAt (i * w * h +)
    | otherwise -> numbersAt (\k -> i + imagesCount images * (k `quot` w + h * (k `rem` w)))
    where
      numbersAt place = case number of
        U1 -> V.generate (w * h) (fromIntegral . B.index bytes . place)
        U2 -> V.generate (w * h) (\k -> fromIntegral (fromIntegral (word 2 k) :: Word16))
        I2 -> V.generate (w * h) (\k -> fromIntegral (fromIntegral (word 2 k) :: Int16))
        I4 -> V.generate (w * h) (\k -> fromIntegral (fromIntegral (word 4 k) :: Int32))
        F4 -> V.generate (w * h) (float2Double . castWord32ToFloat . fromIntegral . word 4)
        F8 -> V.generate (w * h) (castWord64ToDouble . word 8)
        where
          word :: Int -> Int -> Word64
          word size k = go 0 0
            where
              go n high
                | n == size = high
                | otherwise = go (n + 1) (Bits.unsafeShiftL high 8 Bits..|. byte n)
              byte n = fromIntegral (B.index bytes (place k * size + nth n))
              nth n = if big then n else size - 1 - n
      {-# INLINE numbersAt #-}
  where
    (w, h) = (imagesColumns images, imagesRows images)
