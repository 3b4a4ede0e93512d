{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Reading an array of any origin: a CSV file of symbol codes, one row a line.
--
-- Not by cassava, which reads the manifests: it takes 3.9 s and 1.2 GB for 1024 x 4096 cells, and
-- this 0.1 s and 60 MB, the proof after it included (GHC 9.0.2).
module CsvGrid
  ( readGrid,
    parseGrid,
  )
where

import Control.Monad (when)
import Control.Monad.ST (ST, runST)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Unsafe as Bytes
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word8)
import ExitStatus
import Files (readBytes)
import Message (gridMessage)
import Message.Format (encodingMessage)
import Numeric.Natural (Natural)
import PraTactile.Grid
import PraTactile.PlainText (plainText)

-- | The array in a file, over an alphabet of this size, or else of the largest code plus one;
-- leaves with status 2 and the reason if the file holds no array.
readGrid :: Maybe Natural -> FilePath -> IO Grid
readGrid q file = readBytes file >>= orUnusable ((file ++ ": ") ++) . parseGrid q

-- | Codes 0 ... 255 separated by commas or semicolons, rows by ends of line; spaces and empty lines
-- at the end do not matter.
parseGrid :: Maybe Natural -> ByteString -> Either String Grid
parseGrid q bytes = do
  text <- first (("it" ++) . encodingMessage) (plainText bytes)
  (shape, codes) <- parseCodes text
  let inferred = max 2 (Primitive.foldl' (\n c -> max n (fromIntegral c + 1)) 0 codes)
  when (maybe False (> 256) q) (Left ("an alphabet has 2 to 256 symbols, not " ++ maybe "" show q))
  either (Left . gridMessage) Right (gridFromVector (maybe inferred fromIntegral q) shape codes)

-- | The shape and the codes. A number has no more bytes than the text, and each is followed by at
-- least one other.
parseCodes :: ByteString -> Either String (Shape, Primitive.Vector Word8)
parseCodes bytes = runST $ do
  codes <- Mutable.new (Bytes.length bytes `div` 2 + 1)
  parseLines bytes codes >>= traverse (filled codes)
  where
    filled codes (high, wide) =
      (,) (Shape (fromIntegral high) (fromIntegral wide))
        <$> Primitive.freeze (Mutable.take (high * wide) codes)

-- | All lines into the vector; how many there are, and how many cells each has.
parseLines :: ByteString -> Mutable.MVector s Word8 -> ST s (Either String (Int, Int))
parseLines bytes codes = go 0 (1 :: Int) 0 0
  where
    -- Where a line begins, its number, how many cells there were before, and how many the first
    -- line has.
    go start number cells width
      | byteAt bytes (skip start) == 10 = pure (end start number cells width)
      | otherwise = parseCells bytes codes number start cells >>= either (pure . Left) next
      where
        next (start', cells')
          | number > 1 && cells' - cells /= width =
            pure . Left $
              "line "
                ++ show number
                ++ " has "
                ++ show (cells' - cells)
                ++ " cells, the first has "
                ++ show width
          | otherwise = go start' (number + 1) cells' (if number == 1 then cells' else width)
    -- A line without cells ends the text.
    end start number cells width
      | not (Bytes.all (\c -> space c || c == 10) (Bytes.drop start bytes)) =
        Left ("line " ++ show number ++ " is empty")
      | cells == 0 = Left "there are no cells"
      | otherwise = Right (number - 1, width)
    skip i = if i < Bytes.length bytes && space (byteAt bytes i) then skip (i + 1) else i

-- | Where a byte stands in the text of its cell.
data InCell
  = -- | no digit of the cell yet
    Before
  | -- | between its digits
    Within
  | -- | a space after its digits
    After

-- | The cells of the line of this number into the vector, from this byte on and after this many
-- other cells; the byte after its end, and how many cells there are then.
parseCells ::
  ByteString -> Mutable.MVector s Word8 -> Int -> Int -> Int -> ST s (Either String (Int, Int))
parseCells bytes codes number start before = go start before Before (0 :: Int)
  where
    go !i !cells at !value = case (byteAt bytes i, at) of
      (c, Before) | digit c -> go (i + 1) cells Within (fromIntegral c - 48)
      (c, Within)
        | digit c ->
          let value' = 10 * value + fromIntegral c - 48
           in if value' > 255
                then wrong "is more than 255, the largest code"
                else go (i + 1) cells Within value'
      (c, Before) | space c -> go (i + 1) cells Before 0
      (c, _) | space c -> go (i + 1) cells After value
      (c, Before) | separates c || c == 10 -> wrong "is empty"
      (c, _) | separates c -> put >> go (i + 1) (cells + 1) Before 0
      (10, _) -> put >> pure (Right (i + 1, cells + 1))
      _ -> wrong "is not a code 0, 1, 2, ..."
      where
        put = when (cells < Mutable.length codes) (Mutable.write codes cells (fromIntegral value))
    wrong why = pure (Left ("line " ++ show number ++ ": a cell " ++ why))
    digit c = 48 <= c && c <= 57
    -- A comma or a semicolon.
    separates c = c == 44 || c == 59

-- | A byte of a text that ends with the end of a line.
byteAt :: ByteString -> Int -> Word8
byteAt bytes i = if i < Bytes.length bytes then Bytes.unsafeIndex bytes i else 10

-- | Spaces and tabulators.
space :: Word8 -> Bool
space c = c == 32 || c == 9
