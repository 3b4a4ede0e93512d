{-# LANGUAGE DerivingStrategies #-}
-- | The file of a census: CSV, one line an entry. The first three fields say of which census it is, which entry, and
-- of how many, so that a file can be continued and shards of one census can be merged.
module CensusFile
  ( -- * What is in a file
    Contents (..)
  , contentsOf
  , beginsHeader
    -- * What is kept of it
  , wholeRows
  , completeRows
  , keptRows
  , FileFault (..)
  ) where

import qualified Data.ByteString.Char8 as Bytes
import Data.ByteString.Char8 (ByteString)
import Data.Either (isRight)
import Data.List (find)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)

import CensusFile.Row

-- | The lines of a file.
data Contents = Contents
  { contentsForm :: Form
  , contentsHeaderWhole :: Bool
  , contentsLines :: [(Int, Either RowFault Row)]   -- ^ those after the header, by their numbers from 1
  , contentsRest :: ByteString                      -- ^ what follows the last end of line
  }

-- | Why a file is not taken.
data FileFault
  = NoCensus                    -- ^ it does not begin with the header line
  | DamagedLine Int RowFault    -- ^ the line with this number is no whole row
  | OutOfOrder Int              -- ^ the entry on this line does not come after the one before it
  | CutOff                      -- ^ its last line is not complete
  | NotOfThis                   -- ^ it is of another census or shard
  | EntryMissing Int Natural    -- ^ before the row on this line this entry is missing
  | NotThisEntry Int            -- ^ the row on this line is not of the entry whose number it has
  | NotContinued Int
    -- ^ the last line, which has no end, is not the beginning of the row that belongs there
  deriving stock (Eq, Show)

-- | What is in a file. Of which form it is, its header says. With another first line it is still the damaged file of a
-- census if there is a row with a good check in it; 'Nothing' is any other file.
contentsOf :: ByteString -> Maybe Contents
contentsOf bytes = case Bytes.lines whole of
  header : others
    | Just form <- formOf header -> Just (contents form True others)
    | damaged <- contents Checked False others, any (isRight . snd) (contentsLines damaged) -> Just damaged
  _ -> Nothing
  where
    (whole, rest) = Bytes.spanEnd (/= '\n') bytes
    contents form headerWhole others = Contents form headerWhole (zip [2 ..] (map (readRow form) others)) rest

-- | Whether a file was cut off while its header was written, or is empty.
beginsHeader :: ByteString -> Bool
beginsHeader bytes = any ((bytes `Bytes.isPrefixOf`) . headerOf) [minBound ..]

-- | All rows with the numbers of their lines, by ascending entries, if every line is a whole row.
wholeRows :: Contents -> Either FileFault [(Int, Row)]
wholeRows contents
  | not (contentsHeaderWhole contents) = Left NoCensus
  | otherwise = do
      rows <- traverse whole (contentsLines contents)
      let descent = find (\((_, a), (_, b)) -> rowEntry b <= rowEntry a) (zip rows (drop 1 rows))
      maybe (Right rows) (\(_, (number, _)) -> Left (OutOfOrder number)) descent
  where
    whole (number, line) = either (Left . DamagedLine number) (Right . (,) number) line

-- | As 'wholeRows', where the last line must have an end.
completeRows :: Contents -> Either FileFault [(Int, Row)]
completeRows contents = do
  rows <- wholeRows contents
  if Bytes.null (contentsRest contents) then Right rows else Left CutOff

-- | The rows that are whole, with their lines, by their entries, and how many lines are not among them. An entry with two different rows
-- has neither.
keptRows :: Contents -> (Map.Map Natural (Int, Row), Int)
keptRows contents = (kept, length (contentsLines contents) - Map.size kept)
  where
    kept = Map.mapMaybe id (Map.fromListWith same
      [ (rowEntry row, Just (line, row)) | (line, Right row) <- contentsLines contents ])
    same a b = if fmap snd a == fmap snd b then a else Nothing
