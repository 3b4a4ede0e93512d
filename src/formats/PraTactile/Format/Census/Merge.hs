-- | Merges the shards of a census.
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

-- | The rows of a file, with their line numbers.
data Shard = Shard
  { shardFile :: FilePath,
    shardRows :: [(Int, Row)]
  }

-- | Why shards cannot be merged.
data MergeError
  = -- | No file has a row.
    NoEntries
  | -- | These two files have rows of different censuses. They may be the same file.
    DifferentCensuses FilePath FilePath
  | -- | An entry of the census is missing or repeated.
    EntriesApart PartsError
  | -- | The row on this line has another folding, shape or window than the entry with its number.
    NotAsNumbered FilePath Int
  deriving stock (Eq, Show)

-- | The rows of the whole census, in order. Refuses shards of different censuses, and missing or
-- repeated entries.
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

-- | The folding, shape and window of each entry by number, if the name is that of a census with
-- standard windows of this field and degree. For a census with chosen windows the name is not
-- enough.
standardPlace ::
  ByteString -> Natural -> RowSubject -> Maybe (Natural -> Maybe (Folding, Shape, Shape))
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
