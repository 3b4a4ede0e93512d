{-# LANGUAGE OverloadedStrings #-}
-- | Census files and shards under hostile inputs.
module Test.Hostile.Census
  ( judgedCensus
  , judgedShard
  , judgedRows
  ) where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes8

import CensusFile
import Test.Hostile.Judgement
import Test.Hostile.Specimens

-- | The lines of a census as one file, which lacks none.
judgedCensus :: ByteString -> Judged
judgedCensus = mergedWith []

-- | The even entries of a census, merged with its odd ones.
judgedShard :: ByteString -> Judged
judgedShard = mergedWith [ ("odd.csv", found) | Right found <- map readLines (drop 1 shards) ]

mergedWith :: [(FilePath, [Line])] -> ByteString -> Judged
mergedWith others bytes = case readLines bytes >>= \found -> mergeShards (("given.csv", found) : others) of
  Left why -> Refused why
  Right merged -> Accepted
    [ ("every row of the whole census was there", all (`elem` Bytes8.lines bytes ++ map lineText (concatMap snd others)) merged)
    , ("its entries are 0, 1, 2, ...", fmap (map lineEntry) again == Right (zipWith const [0 ..] merged))
    , ("all entries are there", fmap (map lineEntries) again == Right (map (const (fromIntegral (length merged))) merged))
    , ("what is kept of a file that was cut off was there", either (const False) (\(Kept found _) -> length found <= length merged) keptOf) ]
    (show merged ++ show (provedLines merged))
    where
      again = readLines (Bytes8.unlines (censusHeader : merged))
      keptOf = wholeLines bytes

-- | A row that is read is one that was written: with a check in each row, no mutation of one is taken for a row.
judgedRows :: ByteString -> Judged
judgedRows bytes = case readLines bytes of
  Left why -> Refused why
  Right found -> Accepted [("every row is an original one", all ((`elem` originals) . lineText) found)] (show found)
  where originals = concatMap Bytes8.lines (censuses ++ shards)
