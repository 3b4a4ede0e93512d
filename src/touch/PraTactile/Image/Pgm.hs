{-# LANGUAGE PatternSynonyms #-}

-- | PGM files, the format of frames and composites: P2 and P5, 8 and 16 bits, to and from
-- JuicyPixels' images and 'Raster's.
--
-- 0 is no contact, the maximum value full scale.
module PraTactile.Image.Pgm
  ( -- * PGM images
    Pgm,
    pattern Pgm8,
    pattern Pgm16,
    pgm8,
    pgm16,
    pgmWidth,
    pgmHeight,
    pgmMaxval,
    pgmDynamic,
    maxPixels,
    ImageError (..),
    HeaderField (..),

    -- * Files
    decodePgm,
    decodePgmUpTo,
    pgmSize,
    PgmFormat (..),
    encodePgm,
    formatName,

    -- * Intensities
    pgmIntensity,
    pgmFromIntensity,

    -- * PNG
    rasterPng,
  )
where

import Codec.Picture (Image (..), Pixel8, encodePng)
import Data.Bits (shiftR)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as L
import Data.List (intersperse)
import qualified Data.Vector.Storable as V
import Data.Word (Word16, Word8)
import PraTactile.Image (Raster, generate, rasterHeight, rasterValues, rasterWidth)
import PraTactile.Image.Error (HeaderField (..), ImageError (..))
import PraTactile.Image.Pgm.Decode (decodePgm, decodePgmUpTo, formatName, pgmSize)
import PraTactile.Image.Pgm.Type

-- | The two forms of a PGM file.
data PgmFormat
  = -- | P2: decimal numbers. An image row takes one or more lines of at most 70 characters.
    Plain
  | -- | P5: one byte per sample, or two with the most significant first.
    Binary
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The file of an image. 'decodePgm' restores the image with its maximum value.
encodePgm :: PgmFormat -> Pgm -> ByteString
encodePgm format pgm = L.toStrict (Builder.toLazyByteString (magic <> header <> body))
  where
    magic = Builder.string7 (case format of Plain -> "P2"; Binary -> "P5")
    header =
      Builder.string7
        ( "\n"
            ++ show (pgmWidth pgm)
            ++ " "
            ++ show (pgmHeight pgm)
            ++ "\n"
            ++ show (pgmMaxval pgm)
            ++ "\n"
        )
    body = case (format, pgm) of
      (Binary, Pgm8 _ image) ->
        let samples = imageData image in bytes (V.length samples) (samples V.!)
      (Binary, Pgm16 _ image) ->
        let samples = imageData image
            half k = if even k then (`shiftR` 8) else id
         in bytes (2 * V.length samples) (\k -> fromIntegral (half k (samples V.! (k `quot` 2))))
      (Plain, Pgm8 _ image) ->
        plain (imageWidth image) (V.toList (V.map fromIntegral (imageData image)))
      (Plain, Pgm16 _ image) -> plain (imageWidth image) (V.toList (imageData image))

-- | The given number of bytes, each a function of its index.
bytes :: Int -> (Int -> Word8) -> Builder.Builder
bytes count byte = Builder.byteString (fst (B.unfoldrN count (\k -> Just (byte k, k + 1)) 0))

-- | Numbers in lines. At most eleven numbers of five digits fit into the 70 characters that pgm(5)
-- allows.
plain :: Int -> [Word16] -> Builder.Builder
plain width samples = mconcat (concatMap line (chunks width samples))
  where
    line row = [spaced part <> Builder.char7 '\n' | part <- chunks 11 row]
    spaced = mconcat . intersperse (Builder.char7 ' ') . map Builder.word16Dec

chunks :: Int -> [a] -> [[a]]
chunks n list = case splitAt n list of
  ([], _) -> []
  (part, rest) -> part : chunks n rest

-- | The samples as shares of the maximum value, 0 to 1.
pgmIntensity :: Pgm -> Raster
pgmIntensity pgm = case pgm of
  Pgm8 m image -> shares (fromIntegral m) (V.map fromIntegral (imageData image))
  Pgm16 m image -> shares (fromIntegral m) (V.map fromIntegral (imageData image))
  where
    w = pgmWidth pgm
    shares :: Double -> V.Vector Double -> Raster
    shares full samples =
      generate w (pgmHeight pgm) (\x y -> maybe 0 (/ full) (samples V.!? (y * w + x)))

-- | The PGM of a raster with the given maximum value. Values are clipped to 0..1, multiplied by
-- the maximum value and rounded (ties to even); NaN becomes 0. Refuses a maximum value of 0, and an
-- empty or too large raster. It inverts 'pgmIntensity'.
pgmFromIntensity :: Word16 -> Raster -> Either ImageError Pgm
pgmFromIntensity m image = do
  (w, h) <- checkSize (fromIntegral (rasterWidth image)) (fromIntegral (rasterHeight image))
  if m < 256
    then
      pgm8
        (fromIntegral m)
        (Image w h (V.map (fromIntegral . level (fromIntegral m)) (rasterValues image)))
    else pgm16 m (Image w h (V.map (fromIntegral . level (fromIntegral m)) (rasterValues image)))

-- | A share of full scale as a whole number of steps.
level :: Double -> Double -> Int
level full share
  | share > 0 = round (full * min 1 share)
  | otherwise = 0 -- what is not a number, too

-- | The raster as an 8-bit grey PNG file, values clipped to 0..1.
rasterPng :: Raster -> L.ByteString
rasterPng image = encodePng (Image (rasterWidth image) (rasterHeight image) samples :: Image Pixel8)
  where
    samples = V.map (fromIntegral . level 255) (rasterValues image)
