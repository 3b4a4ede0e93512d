-- | The file of a census: CSV, one line an entry. The first three fields say of which census it is,
-- which entry, and of how many, so that a file can be continued and shards of one census can be
-- merged.
module PraTactile.Format.Census
  ( -- * Whole files
    encodeCensus,
    decodeCensus,

    -- * What is in a file
    Contents (..),
    contentsOf,
    beginsHeader,

    -- * What is kept of it
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

-- | A file with rows of these bodies.
encodeCensus :: [ByteString] -> Lazy.ByteString
encodeCensus bodies = Lazy.unlines (map Lazy.fromStrict (headerLine : map checked bodies))

-- | The rows of a finished file. Refuses a file that is cut off, damaged or no census.
decodeCensus :: ByteString -> Either FormatError [Row]
decodeCensus bytes =
  first CensusFileRefused (map snd <$> (contentsOf bytes >>= completeRows))

-- | The lines of a file.
data Contents = Contents
  { -- | whether the first line is the header
    contentsHeaderWhole :: Bool,
    -- | those after the header, by their numbers from 1
    contentsLines :: [(Int, Either RowError Row)],
    -- | what follows the last end of line
    contentsRest :: ByteString
  }

-- | What is in a file. With another first line than the header it is still the damaged file of a
-- census if there is a row with a good check in it; any other file is refused.
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

-- | Whether a file was cut off while its header was written, or is empty.
beginsHeader :: ByteString -> Bool
beginsHeader = (`Bytes.isPrefixOf` headerLine)

-- | All rows with the numbers of their lines, by ascending entries. Refuses a file in which a line
-- is no whole row.
wholeRows :: Contents -> Either CensusFileError [(Int, Row)]
wholeRows contents
  | not (contentsHeaderWhole contents) = Left NoCensusHeader
  | otherwise = do
    rows <- traverse whole (contentsLines contents)
    let descent = find (\((_, a), (_, b)) -> rowEntry b <= rowEntry a) (zip rows (drop 1 rows))
    maybe (Right rows) (\(_, (number, _)) -> Left (OutOfOrder number)) descent
  where
    whole (number, line) = either (Left . DamagedLine number) (Right . (,) number) line

-- | As 'wholeRows', where the last line must have an end.
completeRows :: Contents -> Either CensusFileError [(Int, Row)]
completeRows contents = do
  rows <- wholeRows contents
  if Bytes.null (contentsRest contents) then Right rows else Left CutOff

-- | The rows that are whole, with their lines, by their entries, and how many lines are not among
-- them. An entry with two different rows has neither.
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
