{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE PatternSynonyms #-}
{-# OPTIONS_HADDOCK hide #-}

-- | A valid PGM image: width and height at least 1, at most 'maxPixels' pixels, samples within the
-- maximum value.
module PraTactile.Image.Pgm.Type
  ( Pgm,
    pattern Pgm8,
    pattern Pgm16,
    pgm8,
    pgm16,
    pgmWidth,
    pgmHeight,
    pgmMaxval,
    pgmSamples,
    pgmDynamic,
    checkSize,
    maxPixels,
  )
where

import Codec.Picture (DynamicImage (..), Image (..), Pixel16, Pixel8)
import Codec.Picture.Types (PixelBaseComponent)
import Control.Monad (when)
import qualified Data.Vector.Storable as V
import Data.Word (Word16, Word8)
import Numeric.Natural (Natural)
import PraTactile.Image.Error (ImageError (..))

-- | A grey image with its maximum value, in JuicyPixels' type: 8 bits per sample for maximum
-- values up to 255, 16 above.
data Pgm
  = Eight !Word8 !(Image Pixel8)
  | Sixteen !Word16 !(Image Pixel16)
  deriving stock (Eq)

instance Show Pgm where
  showsPrec d pgm = showParen (d > 10) $ case pgm of
    Eight m image -> shown "Pgm8 " m image
    Sixteen m image -> shown "Pgm16 " m image
    where
      shown name m (Image w h samples) =
        showString name . shows m . showString (size w h) . shows samples . showChar ')'
      size w h = " (Image " ++ show w ++ " " ++ show h ++ " "

-- | The maximum value, 1 to 255, and the image. For matching only; 'pgm8' builds one.
pattern Pgm8 :: Word8 -> Image Pixel8 -> Pgm
pattern Pgm8 m image <- Eight m image

-- | The maximum value, 256 to 65535, and the image. For matching only; 'pgm16' builds one.
pattern Pgm16 :: Word16 -> Image Pixel16 -> Pgm
pattern Pgm16 m image <- Sixteen m image

{-# COMPLETE Pgm8, Pgm16 #-}

-- | A PGM with a maximum value of 1 to 255. Refuses a maximum value of 0, an empty or too large
-- image, a sample above the maximum value, and a number of samples that is not the number of
-- pixels.
pgm8 :: Word8 -> Image Pixel8 -> Either ImageError Pgm
pgm8 m image
  | m < 1 = Left (MaxvalOutOfRange 0)
  | otherwise = Eight m <$> checked m image

-- | A PGM with a maximum value of 256 to 65535. Refuses what 'pgm8' refuses, and smaller maximum
-- values, whose samples take 8 bits.
pgm16 :: Word16 -> Image Pixel16 -> Either ImageError Pgm
pgm16 m image
  | m < 256 = Left (MaxvalOutOfRange (fromIntegral m))
  | otherwise = Sixteen m <$> checked m image

-- | The image, if its size and all its samples are valid.
checked ::
  (Integral (PixelBaseComponent p), V.Storable (PixelBaseComponent p)) =>
  PixelBaseComponent p ->
  Image p ->
  Either ImageError (Image p)
checked m image@(Image w h samples) = do
  (w', h') <- checkSize (natural w) (natural h)
  when (V.length samples /= w' * h') (Left (WrongValueCount w h (V.length samples)))
  case firstAbove of
    Just (i, s) ->
      Left (SampleAboveMaxval (i `rem` w', i `quot` w') (fromIntegral s) (fromIntegral m))
    Nothing -> Right image
  where
    firstAbove = V.findIndex (> m) samples >>= \i -> (,) i <$> samples V.!? i
    natural = fromIntegral . max 0

-- | The number of columns.
pgmWidth :: Pgm -> Int
pgmWidth (Eight _ image) = imageWidth image
pgmWidth (Sixteen _ image) = imageWidth image

-- | The number of rows.
pgmHeight :: Pgm -> Int
pgmHeight (Eight _ image) = imageHeight image
pgmHeight (Sixteen _ image) = imageHeight image

-- | The sample that means full scale, 1 to 65535.
pgmMaxval :: Pgm -> Int
pgmMaxval (Eight m _) = fromIntegral m
pgmMaxval (Sixteen m _) = fromIntegral m

-- | The samples, row by row.
pgmSamples :: Pgm -> V.Vector Word16
pgmSamples (Eight _ image) = V.map fromIntegral (imageData image)
pgmSamples (Sixteen _ image) = imageData image

-- | The image in the type of JuicyPixels' writers, 'ImageY8' or 'ImageY16'. The samples stay
-- unchanged and the maximum value is lost.
pgmDynamic :: Pgm -> DynamicImage
pgmDynamic (Eight _ image) = ImageY8 image
pgmDynamic (Sixteen _ image) = ImageY16 image

-- | The width and height of an image. Refuses 0 ('ZeroSize') and more than 'maxPixels' pixels
-- ('TooManyPixels').
checkSize :: Natural -> Natural -> Either ImageError (Int, Int)
checkSize w h
  | w == 0 || h == 0 = Left (ZeroSize w h)
  | w * h > fromIntegral maxPixels = Left (TooManyPixels w h)
  | otherwise = Right (fromIntegral w, fromIntegral h)

-- | The greatest number of pixels of an image: 2^24, far above any composite.
maxPixels :: Int
maxPixels = 16777216
