-- | The laws of the suite as @pra-tactile conform --list@ prints them.
module ConformList
  ( listText,
    listJson,
  )
where

import Data.Aeson (object, (.=))
import Data.ByteString (ByteString)
import Data.List (nub)
import Data.String (fromString)
import Json
import PraTactile.Conformance.Law
import PraTactile.Conformance.Question
import PraTactile.Conformance.Run

-- | A law: what is said of it, and under how many profiles, of how many, it exhausts its domain.
data Listed = Listed Work Int Int

-- | The laws that were chosen, each once.
listOfLaws :: Settings -> Suite about -> [Listed]
listOfLaws settings suite =
  [ Listed first (length (filter exhaustive own)) (length own)
    | name <- nub (map workId work),
      own@(first : _) <- [filter ((== name) . workId) work]
  ]
  where
    work = workOf settings [minBound ..] suite
    exhaustive one = case workCases one of
      Cases _ (Every _) _ -> True
      Cases _ (Some _ _) _ -> False

-- | A line a law and one for what holds.
listText :: Settings -> Suite about -> String
listText settings suite = concatMap shown (listOfLaws settings suite)
  where
    shown (Listed work full all') =
      workId work ++ asks work ++ domain full all' ++ "\n    " ++ workSentence work ++ "\n"
    asks work = case workNeeds work of
      [] -> ""
      needs -> ": " ++ unwords (map operationName needs)
    domain full all'
      | full == all' = ", exhaustive"
      | full == 0 = ""
      | otherwise = ", exhaustive under " ++ show full ++ " of " ++ show all' ++ " profiles"

-- | The same as JSON.
listJson :: Settings -> Suite about -> ByteString
listJson settings suite =
  encodeSchema "conform-laws/1" (fromString "laws" .= map one (listOfLaws settings suite))
  where
    one (Listed work full all') =
      object
        [ fromString "law" .= workId work,
          fromString "stage" .= stageName (workStage work),
          fromString "needs" .= map operationName (workNeeds work),
          fromString "sentence" .= workSentence work,
          fromString "source" .= workSource work,
          fromString "exhaustive" .= full,
          fromString "profiles" .= all'
        ]
