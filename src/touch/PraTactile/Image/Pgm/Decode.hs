{-# OPTIONS_HADDOCK hide #-}

-- | Reading PGM files as the netpbm manual (pgm(5)) defines them and libnetpbm reads them.
module PraTactile.Image.Pgm.Decode
  ( decodePgm,
    decodePgmUpTo,
    decodePgms,
    pgmSize,
    formatName,
  )
where

import Codec.Picture (Image (..))
import Control.Monad (unless, when)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Data.Char (isDigit)
import Data.List (find)
import qualified Data.Vector.Storable as V
import Data.Word (Word16)
import Numeric.Natural (Natural)
import PraTactile.Image.Error (HeaderField (..), ImageError (..))
import PraTactile.Image.Pgm.Type

-- | The image in a PGM file: plain (P2) or raw (P5), 8 or 16 bits (the more significant byte
-- first). Comments may stand wherever white space may stand in the header and, in plain files,
-- among the samples. Refuses everything else, each cause with its own 'ImageError'; the memory
-- taken is bounded by the file's own size and 'PraTactile.Image.Pgm.maxPixels', whatever the header
-- says.
--
-- >>> import PraTactile.Image.Pgm.Type (pgmMaxval)
-- >>> pgmMaxval <$> decodePgm (Data.ByteString.Char8.pack "P2 # two pixels\n2 1 9\n0 9\n")
-- Right 9
decodePgm :: ByteString -> Either ImageError Pgm
decodePgm = decodePgmUpTo maxPixels

-- | 'decodePgm' for images with at most the given number of pixels. Refuses a larger one by its
-- header, before reading samples.
decodePgmUpTo :: Int -> ByteString -> Either ImageError Pgm
decodePgmUpTo most file = do
  (pgm, rest) <- firstPgm most file
  unless (B.null rest) (Left (TrailingData (B.length rest)))
  Right pgm

-- | All images of a file (the first, then the others), each with at most the given number of
-- pixels. Refuses what 'decodePgmUpTo' refuses, and images of different sizes.
decodePgms :: Int -> ByteString -> Either ImageError (Pgm, [Pgm])
decodePgms most file = do
  (pgm, rest) <- firstPgm most file
  (,) pgm <$> others (pgmWidth pgm, pgmHeight pgm) rest
  where
    others size rest
      | B.null rest = Right []
      | Left _ <- samplesOf rest = Left (TrailingData (B.length rest))
      | otherwise = do
        (pgm, after) <- firstPgm most rest
        let found = (pgmWidth pgm, pgmHeight pgm)
        when (found /= size) (Left (SizesDiffer size found))
        (pgm :) <$> others size after

-- | The first image of a file, and the bytes after it and its white space.
firstPgm :: Int -> ByteString -> Either ImageError (Pgm, ByteString)
firstPgm most file = do
  Header w h maxval samplesIn start <- headerOf file
  when (w * h > most) (Left (LargerThanTouched most w h))
  (samples, rest) <- samplesIn w (w * h) maxval start
  pgm <-
    if maxval < 256
      then pgm8 (fromIntegral maxval) (Image w h (V.map fromIntegral samples))
      else pgm16 (fromIntegral maxval) (Image w h samples)
  Right (pgm, rest)

-- | The width and height of the image in a PGM file, by its header alone. Refuses an invalid
-- header.
pgmSize :: ByteString -> Either ImageError (Int, Int)
pgmSize file = do
  Header w h _ _ _ <- headerOf file
  pure (w, h)

-- | Width, height, maximum value, the reader of the samples, and the bytes after the header.
data Header = Header !Int !Int !Int Samples !ByteString

headerOf :: ByteString -> Either ImageError Header
headerOf file = do
  samplesIn <- samplesOf file
  (width, afterWidth) <- headerNumber HeaderWidth (B.drop 2 file)
  (height, afterHeight) <- headerNumber HeaderHeight afterWidth
  (maxval, afterMaxval) <- headerNumber HeaderMaxval afterHeight
  (w, h) <- checkSize width height
  when (maxval < 1 || maxval > 65535) (Left (MaxvalOutOfRange maxval))
  pure (Header w h (fromIntegral maxval) samplesIn afterMaxval)

-- | The reader of the samples, chosen by the file's first bytes.
samplesOf :: ByteString -> Either ImageError Samples
samplesOf file = case (C.unpack (B.take 2 file), endsToken (B.drop 2 file)) of
  ("P2", True) -> Right plainSamples
  ("P5", True) -> Right rawSamples
  _ -> Left (NotPgm (B.take 8 file))

-- | Reads samples. The arguments are the width, the number of samples, the maximum value, and the
-- bytes after the header; the result includes the bytes after the samples and their white space.
type Samples = Int -> Int -> Int -> ByteString -> Either ImageError (V.Vector Word16, ByteString)

-- | The samples of a raw file, one or two bytes each, after a single white space (or comment, see
-- the Note).
rawSamples :: Samples
rawSamples _ count maxval rest = do
  bytes <- delimiter
  let found = B.length bytes
      needed = size * count
  when (found < needed) (Left (Truncated count (found `div` size)))
  Right (V.unfoldrN count sample bytes, C.dropWhile isWhite (B.drop needed bytes))
  where
    size = if maxval < 256 then 1 else 2
    sample bytes
      | maxval < 256 = byte bytes
      | otherwise = do
        (high, more) <- byte bytes
        (low, after) <- byte more
        Just (256 * high + low, after)
    byte = fmap (first fromIntegral) . B.uncons
    -- Note [The byte after the maximum value]
    delimiter = case C.uncons rest of
      Just ('#', comment) -> Right (B.drop 1 (C.dropWhile (not . isLineEnd) comment))
      Just (_, bytes) -> Right bytes
      Nothing -> Left (Truncated count 0)

{- Note [The byte after the maximum value] "A single whitespace character (usually a newline)"
   separates the maximum value from the samples. No second one may be skipped, because it would be a
   sample. 'number' has checked that the character is white space or begins a comment. A comment
   that directly follows the maximum value's last digit counts, with its line end, as that
   character, as in libnetpbm (pm_getc reads every header byte and turns a comment into its line
   end). A comment after a blank already belongs to the image. -}

-- | The samples of a plain file: decimal numbers separated by white space, with comments allowed.
plainSamples :: Samples
plainSamples width count maxval rest0 = do
  rest <- check 0 rest0
  Right (V.unfoldrN count (fmap (first fromIntegral) . number . skipWhite) rest0, skipWhite rest)
  where
    -- One pass checks and a second one converts, so a large image is never held as a list.
    check i rest
      | i >= count = Right rest
      | B.null start = Left (Truncated count i)
      | otherwise = case number start of
        Nothing -> Left (BadSample i (B.take 8 start))
        Just (value, after)
          | value > fromIntegral maxval ->
            Left (SampleAboveMaxval (i `rem` width, i `quot` width) value maxval)
          | otherwise -> check (i + 1) after
      where
        start = skipWhite rest

-- | A number of the header and the bytes after it.
headerNumber :: HeaderField -> ByteString -> Either ImageError (Natural, ByteString)
headerNumber field rest = maybe (Left (BadHeader field (B.take 8 start))) Right (number start)
  where
    start = skipWhite rest

-- | The decimal number at the beginning of a string, and the rest, which must be white space, a
-- comment or empty. Numbers with more than 18 digits become 10^18, which is too large for every
-- use, so a header of a million digits costs no arithmetic.
number :: ByteString -> Maybe (Natural, ByteString)
number start
  | B.null digits || not (endsToken rest) = Nothing
  | B.length significant > 18 = Just (10 ^ (18 :: Int), rest)
  | otherwise =
    Just (C.foldl' (\n c -> 10 * n + fromIntegral (fromEnum c - fromEnum '0')) 0 significant, rest)
  where
    (digits, rest) = C.span isDigit start
    significant = C.dropWhile (== '0') digits

-- | Whether a token of the header ends here.
endsToken :: ByteString -> Bool
endsToken = maybe True (\(c, _) -> isWhite c || c == '#') . C.uncons

-- | The string without leading white space and comments.
skipWhite :: ByteString -> ByteString
skipWhite string = case C.uncons string of
  Just (c, rest)
    | isWhite c -> skipWhite (C.dropWhile isWhite rest)
    | c == '#' -> skipWhite (C.dropWhile (not . isLineEnd) rest)
  _ -> string

-- | White space by pgm(5): blank, tab, carriage return and line feed.
isWhite :: Char -> Bool
isWhite c = c == ' ' || c == '\t' || isLineEnd c

isLineEnd :: Char -> Bool
isLineEnd c = c == '\n' || c == '\r'

-- | The name of a file format that is often mistaken for PGM, by the file's first bytes.
--
-- >>> formatName (Data.ByteString.pack [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10])
-- Just "PNG"
formatName :: ByteString -> Maybe String
formatName file = fst <$> find (any (`B.isPrefixOf` file) . snd) formats
  where
    formats =
      [ ("PNG", [B.pack [0x89, 0x50, 0x4e, 0x47]]),
        ("JPEG", [B.pack [0xff, 0xd8, 0xff]]),
        ("GIF", [C.pack "GIF8"]),
        ("TIFF", [B.pack [0x49, 0x49, 0x2a, 0], B.pack [0x4d, 0x4d, 0, 0x2a]]),
        ("BMP", [C.pack "BM"]),
        ("PBM", map C.pack ["P1", "P4"]),
        ("PPM", map C.pack ["P3", "P6"]),
        ("PAM", [C.pack "P7"]),
        ("gzip", [B.pack [0x1f, 0x8b]]),
        ("PDF", [C.pack "%PDF"])
      ]
