-- | Hostile inputs: whatever is put in, there is an answer or a refusal in words, soon and in little memory; and what is accepted
-- obeys the laws. The number of inputs is PRA_TACTILE_HOSTILE, 100 000 without it; a hundredth of it are runs of the program.
module Test.Hostile (spec) where

import Control.Monad (forM_)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSize)
import Test.QuickCheck

import Test.Hostile.Arguments
import Test.Hostile.Judgement
import Test.Hostile.Mutation
import Test.Hostile.Parsers
import Test.Hostile.Processes
import Test.Hostile.Runs

spec :: Spec
spec = modifyMaxSize (const 60) $ do
  describe "in process" $ do
    forM_ kinds $ \kind -> do
      it (kindName kind ++ ": the specimens are accepted") $
        once $ conjoin [ counterexample (show bytes) (judgedBy answer .&&. counterexample (show answer) (accepted answer)) | bytes <- kindSpecimens kind, let answer = kindJudged kind bytes ]
          .&&. not (null (kindSpecimens kind))
      share <- runIO (shareOf (kindShare kind))
      it (kindName kind ++ ": every input is answered or refused, in words, soon and in little memory") $
        withMaxSuccess share $ forAllShrinkShow (hostile (length (kindSpecimens kind))) lessHostile (shownOf kind) $
          \given -> judgedBy (kindJudged kind (specimenOf (kindSpecimens kind) given))
    it "the help names the commands and their options" $ do
      length commandsOfHelp `shouldSatisfy` (>= 22)
      [ option | command <- commandsOfHelp, commandName command == "locate", option <- commandOptions command, optionName option `elem` ["--json", "--q"] ]
        `shouldMatchList` [Option "--json" Nothing, Option "--q" (Just "Q")]
      [ commandArguments command | command <- commandsOfHelp, commandName command `elem` ["check", "locate"] ] `shouldBe` [["FILE"], ["PATCH"]]
    share <- runIO (shareOf 150)
    it "arguments: every list is understood or refused, in words, soon and in little memory" $
      withMaxSuccess share $ forAllShrink (argumentList valueFor commandsOfHelp) (shrinkList (const [])) (judgedBy . judgedArguments)
  describe "as processes" $ beforeAll readExamples $
    forM_ runKinds $ \kind -> do
      share <- runIO (shareOf (runKindShare kind))
      it (runKindName kind ++ ": the program ends with an answer or a refusal, in words, soon and in little memory") $ \examples ->
        withMaxSuccess (max 1 (share `div` 100)) $ forAllBlind (hostileRun examples kind) $ \run -> counterexample (show run) (judgedRun run)
  where
    shownOf kind given = show given ++ "\n" ++ show (specimenOf (kindSpecimens kind) given)
    accepted answer = case answer of
      Accepted _ _ -> True
      Refused _ -> False
