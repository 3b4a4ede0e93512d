-- | The shards of a census as one file.
module PraTactile.Format.Census.Merge
  ( Shard (..),
    mergeShards,
    MergeError (..),
    standardPlace,
  )
where

import Control.Monad (forM_, unless, when)
import Data.Bifunctor (first)
import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.List (find)
import qualified Data.Sequence as Seq
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape)
import PraTactile.Census
import PraTactile.Format.Census.Contradiction
import PraTactile.Format.Census.Row
import PraTactile.Format.Shards

-- | The rows of a file, with the numbers of their lines.
data Shard = Shard
  { shardFile :: FilePath,
    shardRows :: [(Int, Row)]
  }

-- | Why shards are not one census.
data MergeError
  = -- | There is no row in any of them.
    NoEntries
  | -- | These two files have rows of different censuses; they may be the same file.
    DifferentCensuses FilePath FilePath
  | -- | The entries are not all of the census, each once.
    EntriesApart PartsError
  | -- | The row on this line does not have the folding, shape and window of the entry whose number
    -- it has.
    NotAsNumbered FilePath Int
  deriving stock (Eq, Show)

-- | The rows of the whole census, in order. The shards must be of one census, without a common
-- entry, and lack none.
mergeShards :: [Shard] -> Either MergeError [Row]
mergeShards shards = case [(shardFile shard, row) | shard <- shards, row <- shardRows shard] of
  [] -> Left NoEntries
  everything@((file, (_, one)) : _) -> do
    forM_ everything $ \(file', (_, row)) ->
      unless (identity row == identity one) (Left (DifferentCensuses file file'))
    forM_ everything $ \(file', (line, row)) ->
      unless (maybe True (isPlacedAt row) (standard one)) (Left (NotAsNumbered file' line))
    first EntriesApart $
      together 0 (rowEntries one) [(file', rowEntry row, row) | (file', (_, row)) <- everything]
  where
    identity row =
      let s = rowSubject row
          field = (subjectOrder s, subjectModulus s)
       in (rowCensus row, rowEntries row, field, length (subjectPolynomial s))
    standard one = standardPlace (rowCensus one) (rowEntries one) (rowSubject one)
    isPlacedAt row placed =
      let s = rowSubject row
       in placed (rowEntry row) == Just (subjectFolding s, subjectShape s, subjectWindow s)

-- | If a census has the name of one with the standard windows of this field and degree: what its
-- entries are of, by their numbers. Of a census with chosen windows the name alone does not tell.
standardPlace ::
  ByteString -> Natural -> Subject -> Maybe (Natural -> Maybe (Folding, Shape, Shape))
standardPlace name entries subject = do
  scope <-
    find
      ((== name) . Bytes.pack . censusName)
      [ Scope (subjectOrder subject) (subjectModulus subject) n foldings []
        | foldings <- [[Diagonal, RowMajor], [Diagonal], [RowMajor]]
      ]
  either (const Nothing) Just $ do
    size <- first (const ()) (censusSize scope)
    places <- Seq.fromList <$> first (const ()) (scopePlaces scope)
    when (Seq.null places) (Left ())
    let index i = fromIntegral (i `mod` fromIntegral (Seq.length places))
    pure (\i -> if size == entries then places Seq.!? index i else Nothing)
  where
    n = fromIntegral (max 1 (length (subjectPolynomial subject)) - 1)
