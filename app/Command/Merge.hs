{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile merge@: the shards of a census as one file, or those of an evaluation counted.
module Command.Merge
  ( command,
  )
where

import CensusChoice
import Control.Exception (IOException, try)
import Control.Monad (filterM, unless)
import Data.Aeson ((.=))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (for_)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import ExitStatus
import Files (largestWork, readBytesUpTo)
import Json (sayWrittenAs)
import Message.Census
import Message.Evaluation
import Options
import Output
import PraTactile.Format.Census
import PraTactile.Format.Census.Contradiction (foundProved)
import PraTactile.Format.Census.Merge
import PraTactile.Format.Census.Row
import PraTactile.Format.Evaluation (Evaluation (..), MergeError (..), encodeEvaluation, merged)
import qualified PraTactile.Format.Evaluation as Evaluation
import System.Posix.Files (deviceID, fileID, getFileStatus)

command :: Subcommand
command =
  subcommand
    "merge"
    "Join the shards of a census or an evaluation"
    "Join the shards of a census or of an evaluation. The result is the file, or the JSON, that \
    \one run would have made. Shards must be undamaged and complete, belong to one census or \
    \evaluation, and have nothing in common."
    []
    [ "pra-tactile merge part1.csv part2.csv part3.csv --output census.csv",
      "pra-tactile merge part1.json part2.json part3.json"
    ]
    ( run
        <$> some
          ( pathArgument
              ( metavar "FILE..."
                  <> action "file"
                  <> help "Files of 'census --shard', or of 'evaluate --shard'"
              )
          )
        <*> keepWholeSwitch
          "Take the whole rows of damaged census files; entries that are then missing are reported"
        <*> optionalFile
          "output"
          "FILE"
          "Write to this file, which is none of the shards, instead of the standard output"
        <*> jsonSwitch "With --output, report as JSON what was written"
    )

run :: [FilePath] -> Damage -> Maybe FilePath -> AnswerForm -> IO ExitStatus
run files damage output form = do
  unless (isJust output) $
    leaveOut "without --output the result itself is printed" [("--json", form == AsJson)]
  for_ output $ \file -> do
    inputs <- filterM (sameFile file) files
    for_ (take 1 inputs) $ \input ->
      misused
        ( "the output "
            ++ file
            ++ " is the shard "
            ++ input
            ++ ", which would be lost; give another --output"
        )
  contents <- mapM (readBytesUpTo largestWork) files
  let written bytes = maybe (Lazy8.putStr bytes) (`writeWhole` bytes) output
  case zip files contents of
    one : others | any (isJson . snd) (one : others) -> do
      leaveOut "an evaluation's file is whole or refused" [("--keep-whole", damage == Repaired)]
      shards <- traverse (\(file, bytes) -> (,) file <$> evaluationShard file bytes) (one :| others)
      (evaluation, counts) <- orUnusable notMergedMessage (merged shards)
      written (Lazy8.fromStrict (encodeEvaluation evaluation counts) <> "\n")
      for_ output $ \file ->
        sayWrittenAs
          form
          file
          (": " ++ show (evaluationPresses evaluation) ++ " presses")
          "evaluate-written/1"
          ("presses" .= evaluationPresses evaluation)
    given -> do
      (shards, notes) <- unzip <$> mapM (uncurry (shard damage)) given
      rows <- orUnusable mergeMessage (mergeShards shards)
      mapM_ warn (concat notes)
      written (encodeCensus (map rowText rows))
      for_ output $ \file ->
        sayCensus
          form
          file
          (fromIntegral (length rows))
          (length (filter (foundProved . rowFindings) rows))
  pure Answered
  where
    -- A census never begins with a brace.
    isJson = ("{" `Bytes.isPrefixOf`)
    evaluationShard file bytes
      | Bytes.null bytes = unusable (notMergedMessage (Unfinished file))
      | otherwise = orUnusable (evaluationFileMessage file) (Evaluation.contentsOf bytes)

-- | The rows of a file, and notices about them. A damaged file leaves with status 2; with
-- 'Repaired', its whole rows are taken.
shard :: Damage -> FilePath -> ByteString -> IO (Shard, [String])
shard damage file bytes = do
  contents <- orUnusable (censusFileMessage file) (contentsOf bytes)
  case completeRows contents of
    Right rows -> pure (Shard file rows, [])
    Left _
      | damage == Repaired ->
        let (kept, left) = keptRows contents
            lost = left + length [() | not (Bytes.null (contentsRest contents))]
         in pure (Shard file (Map.elems kept), [keptMessage file (Map.size kept) lost])
    Left fault -> unusable (censusFileMessage file fault)

-- | Whether both paths lead to the same file, in any spelling and over any symbolic or hard links.
-- A file that does not exist equals no other.
sameFile :: FilePath -> FilePath -> IO Bool
sameFile a b = (\x y -> Just True == ((==) <$> x <*> y)) <$> identity a <*> identity b
  where
    identity path =
      either none (\status -> Just (deviceID status, fileID status)) <$> try (getFileStatus path)
    none :: IOException -> Maybe a
    none _ = Nothing
