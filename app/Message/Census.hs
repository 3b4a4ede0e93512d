-- | Messages about census files.
module Message.Census
  ( censusFileMessage,
    mergeMessage,
    keptMessage,
  )
where

import qualified Data.ByteString.Char8 as Bytes
import Data.List (intercalate)
import Message.Code (numeral)
import Message.Shards (partsMessage)
import PraTactile.Format.Census.Merge
import PraTactile.Format.Error

-- | The message about a file, with its name in front.
censusFileMessage :: FilePath -> CensusFileError -> String
censusFileMessage file fault = case fault of
  NoCensusHeader -> file ++ ": its first line is not that of a census"
  DamagedLine line why ->
    file
      ++ ": line "
      ++ show line
      ++ " is damaged: "
      ++ rowMessage why
      ++ "; --keep-whole keeps the other lines"
  OutOfOrder line ->
    file
      ++ ": line "
      ++ show line
      ++ " is out of order, or there twice; --keep-whole puts the lines in order"
  CutOff -> file ++ ": its last line is cut off; run its census again to finish it"
  OtherCensus -> file ++ " is not an unfinished file of this census or shard; give another --output"
  EntryMissing line entry ->
    file
      ++ ": entry "
      ++ numeral entry
      ++ " is missing before line "
      ++ show line
      ++ "; --keep-whole makes it again"
  OtherEntry line ->
    file
      ++ ": line "
      ++ show line
      ++ " is damaged: it does not have the polynomial, folding, shape and window of its entry; \
         \--keep-whole keeps the other lines"
  NotContinued line ->
    file
      ++ ": line "
      ++ show line
      ++ " has no end and is not the beginning of the row that belongs there; --keep-whole keeps \
         \the lines before it"

rowMessage :: RowError -> String
rowMessage fault = case fault of
  FieldCount there needs -> "it has " ++ show there ++ " fields, not " ++ show needs
  CheckFails -> "its check does not fit the rest"
  FieldForm column text ->
    "it has "
      ++ show (Bytes.unpack (Bytes.take 40 text))
      ++ " in the column "
      ++ Bytes.unpack column
  Contradicting columns ->
    "its columns " ++ intercalate ", " (map Bytes.unpack columns) ++ " contradict each other"

-- | Why shards are not merged.
mergeMessage :: MergeError -> String
mergeMessage fault = case fault of
  NoEntries -> "there are no entries in these files"
  DifferentCensuses a b
    | a == b -> a ++ " has rows of different censuses"
    | otherwise -> a ++ " and " ++ b ++ " are of different censuses"
  EntriesApart why -> partsMessage "entry" "entries" why
  NotAsNumbered file line ->
    file
      ++ ": line "
      ++ show line
      ++ " is damaged: it does not have the folding, shape and window of its entry"

-- | The notice that damaged lines are left out, with the numbers of kept rows and of lost lines.
keptMessage :: FilePath -> Int -> Int -> String
keptMessage file kept left =
  file
    ++ ": whole rows kept: "
    ++ show kept
    ++ "; damaged or repeated lines left out: "
    ++ show left
