{-# OPTIONS_HADDOCK hide #-}

-- | Grey PNG images of 8 or 16 bits, by JuicyPixels.
module PraTactile.Image.File.Png
  ( isPng,
    pngSize,
    decodePngFile,
    encodePngFile,
  )
where

import Codec.Picture
import Control.Monad (unless)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Lazy as L
import qualified Data.Vector as Boxed
import qualified Data.Vector.Storable as V
import PraTactile.Image.Error (ImageError (..), PngProblem (..))
import PraTactile.Image.Images
import PraTactile.Image.Pgm.Type

-- | Whether a file begins like a PNG file.
isPng :: ByteString -> Bool
isPng = B.isPrefixOf (B.pack [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10])

-- | The width and the height in the header. Refuses a file that is too short ('PngBroken'), and
-- what 'checkSize' refuses.
pngSize :: ByteString -> Either ImageError (Int, Int)
pngSize file
  | B.length file < 29 = Left (PngRefused PngBroken)
  | otherwise = checkSize (number 16) (number 20)
  where
    number at = B.foldl' (\n byte -> 256 * n + fromIntegral byte) 0 (B.take 4 (B.drop at file))

-- | A grey image, or a colour image whose three channels are equal everywhere. Refuses, by the
-- header alone, palettes, transparency, and depths other than 8 and 16 bits; refuses other colours.
decodePngFile :: ByteString -> Either ImageError Images
decodePngFile file = do
  (w, h) <- pngSize file
  unless (B.index file 24 `elem` [8, 16]) (Left (PngRefused PngDepth))
  case B.index file 25 of
    0 -> Right ()
    2 -> Right ()
    3 -> Left (PngRefused PngPalette)
    _ -> Left (PngRefused PngTransparent)
  unless (roomFor w h) (Left (PngRefused PngBroken))
  pgm <- case decodePng file of
    Right (ImageY8 image) -> pgm8 255 image
    Right (ImageY16 image) -> pgm16 65535 image
    Right (ImageRGB8 image) -> grey (imageData image) >>= pgm8 255 . Image w h
    Right (ImageRGB16 image) -> grey (imageData image) >>= pgm16 65535 . Image w h
    _ -> Left (PngRefused PngBroken)
  Right (Images w h 1 (fromIntegral (pgmMaxval pgm)) Nothing (Several (Boxed.singleton pgm)))
  where
    -- Deflate expands by at most a factor of 1032, so a file that claims a larger image is refused.
    roomFor w h = h * (1 + w * channels * depth `div` 8) <= 1032 * B.length file
    channels = if B.index file 25 == 2 then 3 else 1
    depth = fromIntegral (B.index file 24)

-- | One of the three channels. Refuses channels that differ.
grey :: (Eq a, V.Storable a) => V.Vector a -> Either ImageError (V.Vector a)
grey samples
  | and [same k | k <- [0 .. V.length samples - 1]] =
    Right (V.ifilter (\k _ -> k `rem` 3 == 0) samples)
  | otherwise = Left (PngRefused PngColour)
  where
    same k = samples V.! k == samples V.! (k - k `rem` 3)

-- | A PNG file with the image's 8 or 16 bits per sample.
encodePngFile :: Pgm -> ByteString
encodePngFile = L.toStrict . either (const L.empty) id . encodeDynamicPng . pgmDynamic
