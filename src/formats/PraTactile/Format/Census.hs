-- | The file of a census: CSV with one entry per line. The first three fields of a row are the
-- census, the entry's number and the number of entries. With them a file can be continued, and
-- shards of one census can be merged.
module PraTactile.Format.Census
  ( -- * Whole files
    encodeCensus,
    decodeCensus,

    -- * Contents
    Contents (..),
    contentsOf,
    beginsHeader,

    -- * Valid rows
    wholeRows,
    completeRows,
    keptRows,
  )
where

import Data.Bifunctor (first)
import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Either (isRight)
import Data.List (find)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Format.Census.Row
import PraTactile.Format.Error

-- | A census file with a header and these rows, to each of which its check is added.
encodeCensus :: [ByteString] -> Lazy.ByteString
encodeCensus bodies = Lazy.unlines (map Lazy.fromStrict (headerLine : map checked bodies))

-- | Reads the rows of a finished file. Refuses a file that is cut off, damaged or not a census.
decodeCensus :: ByteString -> Either FormatError [Row]
decodeCensus bytes =
  first CensusFileRefused (map snd <$> (contentsOf bytes >>= completeRows))

-- | The lines of a file.
data Contents = Contents
  { -- | whether the first line is the header
    contentsHeaderWhole :: Bool,
    -- | each line after the header with its number; the header is line 1
    contentsLines :: [(Int, Either RowError Row)],
    -- | the text after the last line end; it is empty if the last line is complete
    contentsRest :: ByteString
  }

-- | Splits a file into lines. A file with a wrong header is still a damaged census if it has a row
-- with a valid check; any other file is refused.
contentsOf :: ByteString -> Either CensusFileError Contents
contentsOf bytes = case Bytes.lines whole of
  header : others
    | contentsHeaderWhole contents || any (isRight . snd) (contentsLines contents) -> Right contents
    where
      contents =
        Contents
          { contentsHeaderWhole = header == headerLine,
            contentsLines = zip [2 ..] (map readRow others),
            contentsRest = rest
          }
  _ -> Left NoCensusHeader
  where
    (whole, rest) = Bytes.spanEnd (/= '\n') bytes

-- | Whether a file is empty or ends within its header.
beginsHeader :: ByteString -> Bool
beginsHeader = (`Bytes.isPrefixOf` headerLine)

-- | All complete rows with their line numbers. Refuses another header, an invalid line, and rows
-- that are not in ascending order of their entries.
wholeRows :: Contents -> Either CensusFileError [(Int, Row)]
wholeRows contents
  | not (contentsHeaderWhole contents) = Left NoCensusHeader
  | otherwise = do
    rows <- traverse whole (contentsLines contents)
    let descent = find (\((_, a), (_, b)) -> rowEntry b <= rowEntry a) (zip rows (drop 1 rows))
    maybe (Right rows) (\(_, (number, _)) -> Left (OutOfOrder number)) descent
  where
    whole (number, line) = either (Left . DamagedLine number) (Right . (,) number) line

-- | 'wholeRows' of a finished file: refuses an incomplete last line ('CutOff').
completeRows :: Contents -> Either CensusFileError [(Int, Row)]
completeRows contents = do
  rows <- wholeRows contents
  if Bytes.null (contentsRest contents) then Right rows else Left CutOff

-- | The valid rows with their line numbers, by entry; and the number of all other lines after the
-- header. An entry with two different rows is dropped.
keptRows :: Contents -> (Map.Map Natural (Int, Row), Int)
keptRows contents = (kept, length (contentsLines contents) - Map.size kept)
  where
    kept =
      Map.mapMaybe
        id
        ( Map.fromListWith
            same
            [(rowEntry row, Just (line, row)) | (line, Right row) <- contentsLines contents]
        )
    same a b = if fmap snd a == fmap snd b then a else Nothing
