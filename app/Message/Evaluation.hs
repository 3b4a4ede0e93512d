-- | Messages about the files of evaluations' shards.
module Message.Evaluation
  ( evaluationFileMessage,
    otherEvaluationMessage,
    notMergedMessage,
  )
where

import Data.List (intercalate)
import Message.Format (formatMessage)
import Message.Shards (partsMessage)
import PraTactile.Format.Evaluation
import Visible (visibleName)

-- | The message about a file.
evaluationFileMessage :: FilePath -> EvaluationFileError -> String
evaluationFileMessage file fault = case fault of
  NoShard why -> formatMessage (visibleName file) "a file of 'pra-tactile evaluate --shard'" why
  DamagedPress line why -> formatMessage (on line) "a press" why ++ cut
  CheckOfPress line -> on line ++ " is damaged: its check does not fit the rest" ++ cut
  OtherPress line -> on line ++ " has another press than the one that belongs there" ++ cut
  OtherEnding line -> on line ++ " is not what the presses before it come to" ++ cut
  where
    on line = visibleName file ++ ": line " ++ show line
    cut = "; delete it and all lines after it, and run its shard again"

-- | The message about a file that cannot be continued, perhaps since it belongs to another shard;
-- given the keys in which its first line differs.
otherEvaluationMessage :: FilePath -> [String] -> String
otherEvaluationMessage file keys =
  visibleName file
    ++ " is not an unfinished file of this evaluation and shard"
    ++ (if null keys then "" else " (" ++ keysText keys ++ ")")
    ++ "; give another --output"

-- | The keys in which shards differ, in words.
keysText :: [String] -> String
keysText keys = "other " ++ intercalate ", " (map told keys)
  where
    told name = case name of
      "setting" -> "objects, shapes, sizes, tolerance or version"
      _ -> name

-- | Why shards are not merged.
notMergedMessage :: MergeError -> String
notMergedMessage fault = case fault of
  DifferentEvaluations a b keys ->
    visibleName a ++ " and " ++ visibleName b ++ " are of different evaluations: " ++ keysText keys
  Unfinished file -> visibleName file ++ " is cut off; run its shard again to finish it"
  PressesApart why -> partsMessage "press" "presses" why
