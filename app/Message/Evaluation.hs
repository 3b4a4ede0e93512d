-- | What is wrong with the files of evaluations' shards, in words.
module Message.Evaluation
  ( evaluationFileMessage,
    otherEvaluationMessage,
    notMergedMessage,
  )
where

import Message.Census (partsMessage)
import Message.Format (formatMessage)
import PraTactile.Format.Evaluation
import Visible (visibleName)

-- | What is wrong with a file.
evaluationFileMessage :: FilePath -> EvaluationFileError -> String
evaluationFileMessage file fault = case fault of
  NoShard why -> formatMessage (visibleName file) "a file of 'pra-tactile evaluate --shard'" why
  DamagedPress line why -> formatMessage (on line) "a press" why
  CheckOfPress line -> on line ++ " is damaged: its check does not fit the rest"
  OtherPress line -> on line ++ " has another press than the one that belongs there"
  OtherEnding line -> on line ++ " is not what the presses before it come to"
  where
    on line = visibleName file ++ ": line " ++ show line

-- | Where a file is to be continued that has something else in it.
otherEvaluationMessage :: FilePath -> String
otherEvaluationMessage file =
  visibleName file
    ++ " is not an unfinished file of this evaluation and shard; give another --output"

-- | Why shards are not merged.
notMergedMessage :: MergeError -> String
notMergedMessage fault = case fault of
  DifferentEvaluations a b ->
    visibleName a ++ " and " ++ visibleName b ++ " are of different evaluations"
  Unfinished file -> visibleName file ++ " is cut off; run its shard again to finish it"
  PressesApart why -> partsMessage "press" "presses" why
