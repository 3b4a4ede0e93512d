{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Reading an array that anybody made: a CSV file of symbol codes, one row a line.
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
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Unsafe as Bytes
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word8)
import Ending
import Files (readBytes)
import Message (gridMessage)
import Numeric.Natural (Natural)
import PraTactile.Grid

-- | The array in a file, over an alphabet of this size, or else of the largest code and one more;
-- leaves with status 2 and the reason where there is none.
readGrid :: Maybe Natural -> FilePath -> IO Grid
readGrid q file = readBytes file >>= orUnusable ((file ++ ": ") ++) . parseGrid q

-- | Codes 0 ... 255 parted by commas, rows by ends of line (LF or CR LF); spaces and empty lines at
-- the end do not matter.
parseGrid :: Maybe Natural -> ByteString -> Either String Grid
parseGrid q bytes = do
  (shape, codes) <- parseCodes (fromMaybe bytes (Bytes.stripPrefix "\xEF\xBB\xBF" bytes))
  let inferred = max 2 (Primitive.foldl' (\n c -> max n (fromIntegral c + 1)) 0 codes)
  when (maybe False (> 256) q) (Left ("an alphabet has 2 to 256 symbols, not " ++ maybe "" show q))
  either (Left . gridMessage) Right (gridFromVector (maybe inferred fromIntegral q) shape codes)

-- | What surrounds a byte.
data Place
  = -- | no digit of the cell yet
    Before
  | -- | between its digits
    Within
  | -- | a space after its digits
    After

-- | The shape and the codes. A number has no more bytes than the text, and each is followed by at
-- least one other.
parseCodes :: ByteString -> Either String (Shape, Primitive.Vector Word8)
parseCodes bytes = runST $ do
  codes <- Mutable.new (size `div` 2 + 1)
  outcome <- line codes 0 1 0 0
  case outcome of
    Left why -> pure (Left why)
    Right (height, width) -> do
      filled <- Primitive.freeze (Mutable.take (height * width) codes)
      pure (Right (Shape (fromIntegral height) (fromIntegral width), filled))
  where
    size = Bytes.length bytes
    at i = if i < size then Bytes.unsafeIndex bytes i else 10
    -- A line: where it begins, its number, how many cells there were before, and how many the first
    -- line has.
    line :: Mutable.MVector s Word8 -> Int -> Int -> Int -> Int -> ST s (Either String (Int, Int))
    line codes start number cells width
      | blank start = pure $ case () of
        _
          | not (restIsBlank start) -> Left ("line " ++ show number ++ " is empty")
          | cells == 0 -> Left "there are no cells"
          | otherwise -> Right (number - 1, width)
      | otherwise = do
        outcome <- cellsOf codes start number cells Before 0
        case outcome of
          Left why -> pure (Left why)
          Right (next, cells')
            | number > 1 && cells' - cells /= width ->
              pure
                ( Left
                    ( "line "
                        ++ show number
                        ++ " has "
                        ++ show (cells' - cells)
                        ++ " cells, the first has "
                        ++ show width
                    )
                )
            | otherwise ->
              line codes next (number + 1) cells' (if number == 1 then cells' - cells else width)
    -- The cells of a line, to the byte after its end.
    cellsOf ::
      Mutable.MVector s Word8 ->
      Int ->
      Int ->
      Int ->
      Place ->
      Int ->
      ST s (Either String (Int, Int))
    cellsOf codes = go
      where
        go !i !number !cells place !value = case (at i, place) of
          (c, Before) | digit c -> go (i + 1) number cells Within (fromIntegral c - 48)
          (c, Within)
            | digit c ->
              let value' = 10 * value + fromIntegral c - 48
               in if value' > 255
                    then wrong "is more than 255, the largest code"
                    else go (i + 1) number cells Within value'
          (c, Before) | space c -> go (i + 1) number cells Before 0
          (c, _) | space c -> go (i + 1) number cells After value
          (44, Before) -> wrong "is empty"
          (10, Before) -> wrong "is empty"
          (44, _) -> put >> go (i + 1) number (cells + 1) Before 0
          (10, _) -> put >> pure (Right (i + 1, cells + 1))
          _ -> wrong "is not a code 0, 1, 2, ..."
          where
            put =
              when (cells < Mutable.length codes) (Mutable.write codes cells (fromIntegral value))
            wrong why = pure (Left ("line " ++ show number ++ ": a cell " ++ why))
    digit c = 48 <= c && c <= 57
    space c = c == 32 || c == 9 || c == 13
    blank i = at (skip i) == 10
    skip i = if i < size && space (at i) then skip (i + 1) else i
    restIsBlank i = Bytes.all (\c -> space c || c == 10) (Bytes.drop i bytes)
