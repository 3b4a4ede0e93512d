-- | Census files and shards under hostile inputs.
module Test.Hostile.Census
  ( judgedCensus,
    judgedShard,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes8
import Message.Census
import PraTactile.Format.Census
import PraTactile.Format.Census.Merge
import PraTactile.Format.Census.Row
import PraTactile.Format.Error
import Test.Hostile.Judgement
import Test.Hostile.Specimens

-- | A file as the only shard of a census.
judgedCensus :: ByteString -> Judged
judgedCensus = mergedWith []

-- | The even entries of a census, merged with its odd ones.
judgedShard :: ByteString -> Judged
judgedShard = mergedWith [odds | Right odds <- map (shardOf "odd.csv") (drop 1 shards)]

shardOf :: FilePath -> ByteString -> Either CensusFileError Shard
shardOf file bytes = do
  contents <- contentsOf bytes
  Shard file <$> completeRows contents

-- With a check in each row, no mutation of one is taken for a row.
mergedWith :: [Shard] -> ByteString -> Judged
mergedWith others bytes = case shardOf file bytes of
  Left why -> Refused (censusFileMessage file why)
  Right given -> case mergeShards (given : others) of
    Left why -> Refused (mergeMessage why)
    Right merged ->
      Accepted
        [ ("every row is an original one", all ((`elem` originals) . checked . rowText) merged),
          ("its entries are 0, 1, 2, ...", map rowEntry merged == zipWith const [0 ..] merged),
          ("all entries are there", all ((== length merged) . fromIntegral . rowEntries) merged)
        ]
        (show merged)
  where
    file = "given.csv"
    originals = concatMap Bytes8.lines (censuses ++ shards)
