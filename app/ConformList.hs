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
import PraTactile.Conformance.Operations (allOperations, nameOf)
import PraTactile.Conformance.Process (checkTexts)
import PraTactile.Conformance.Question (SomeOp)
import PraTactile.Conformance.Run
import PraTactile.Conformance.Run.Pattern
import PraTactile.Conformance.Version

-- | A law: its description, and under how many of the profiles it exhausts its domain.
data Listed = Listed
  { listedId :: String,
    listedStage :: Stage,
    listedNeeds :: [SomeOp],
    listedSentence :: String,
    listedSource :: String,
    listedFull :: Int,
    listedProfiles :: Int
  }

-- | The chosen laws, each once, and the checks of how a process is spoken to.
listOfLaws :: Settings -> Suite about -> [Listed]
listOfLaws settings suite =
  [ Listed name OnProtocol [] sentence "the protocol" 1 1
    | OnProtocol `elem` stagesTried settings,
      (name, sentence) <- checkTexts,
      null (settingRun settings) || any (`matches` name) (settingRun settings)
  ]
    ++ [ listed first (length (filter exhaustive own)) (length own)
         | name <- nub (map workId work),
           own@(first : _) <- [filter ((== name) . workId) work]
       ]
  where
    work = workOf settings allOperations suite
    listed one =
      Listed (workId one) (workStage one) (workNeeds one) (workSentence one) (workSource one)
    exhaustive one = case workCases one of
      Cases _ (Every _) _ -> True
      Cases _ (Some _ _) _ -> False

-- | Two lines for each law: its id and what it states.
listText :: Settings -> Suite about -> String
listText settings suite = concatMap shown (listOfLaws settings suite)
  where
    shown one =
      listedId one ++ asks one ++ domain (listedFull one) (listedProfiles one) ++ "\n    "
        ++ listedSentence one
        ++ "\n"
    asks one = case listedNeeds one of
      [] -> ""
      needs -> ": " ++ unwords (map nameOf needs)
    domain full all'
      | full == all' = ", exhaustive"
      | full == 0 = ""
      | otherwise = ", exhaustive under " ++ show full ++ " of " ++ show all' ++ " profiles"

-- | The chosen laws as JSON.
listJson :: Settings -> Suite about -> ByteString
listJson settings suite =
  encodeSchema "conform-laws/1" $
    fromString "suite" .= suiteVersion
      <> fromString "laws" .= map one (listOfLaws settings suite)
  where
    one law =
      object
        [ fromString "law" .= listedId law,
          fromString "stage" .= stageName (listedStage law),
          fromString "needs" .= map nameOf (listedNeeds law),
          fromString "sentence" .= listedSentence law,
          fromString "source" .= listedSource law,
          fromString "exhaustive" .= listedFull law,
          fromString "profiles" .= listedProfiles law
        ]
