-- | What the runner tries of a suite: which laws, under which profiles, in which order.
module Test.Conformance.Run.Choice (spec) where

import Control.Monad (forM_)
import Data.Aeson (Value (..))
import Data.List (nub, sort, subsequences)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Run
import PraTactile.Conformance.Run.Token
import Test.Conformance.Run.SmallSuite
import Test.Hspec

spec :: Spec
spec = do
  it "laws of profiles, those of the code under each profile that has an array, then touch" $ do
    let works = workOf everything codeAndTouch suite
    [(workId work, fst <$> workProfile work, workLeftOut work) | work <- works]
      `shouldBe` [ ("profile/opens", Nothing, Nothing),
                   ("field/sums", Just "one", Nothing),
                   ("sequence/terms", Just "one", Nothing),
                   ("field/sums", Just "two", Nothing),
                   ("sequence/terms", Just "two", Nothing),
                   ("segment/none", Nothing, Nothing)
                 ]
    map workStage works
      `shouldBe` [OnProfile, OnField, OnSequence, OnField, OnSequence, OnSegment]
    forM_ stageChoices $ \stages ->
      idsOf stages suite
        `shouldBe` [ lawName
                     | (lawName, stage) <-
                         [ ("profile/opens", OnProfile),
                           ("field/sums", OnField),
                           ("sequence/terms", OnSequence),
                           ("segment/none", OnSegment)
                         ],
                       stage `elem` stages
                   ]
  it "what is chosen by stage and by pattern; what is skipped, or not offered, says so" $ do
    let ids settings = nub (map workId (workOf settings codeAndTouch suite))
        left settings offers =
          nub
            [ (workId work, why)
              | work <- workOf settings offers suite,
                Just why <- [workLeftOut work]
            ]
    ids standardSettings `shouldBe` ["profile/opens", "field/sums", "sequence/terms"]
    ids everything {settingStages = [OnSegment, OnField]} `shouldBe` ["field/sums", "segment/none"]
    ids everything {settingRun = ["field/*", "opens"]} `shouldBe` ["profile/opens", "field/sums"]
    ids everything {settingRun = ["no"]} `shouldBe` ["segment/none"]
    left everything {settingSkip = ["field/*"]} codeAndTouch `shouldBe` [("field/sums", "left out")]
    left everything {settingSkip = ["field/*"], settingSkipMustFail = True} codeAndTouch
      `shouldBe` []
    left everything [SomeOp Term]
      `shouldBe` [ ("field/sums", "not offered: add"),
                   ("sequence/terms", "not offered: terms"),
                   ("segment/none", "not offered: segment")
                 ]
    left everything {settingSkip = ["sums"]} [SomeOp Add]
      `shouldBe` [ ("field/sums", "left out"),
                   ("sequence/terms", "not offered: term terms"),
                   ("segment/none", "not offered: segment")
                 ]
  it "all is chosen where no law is named, and of code, touch and objects all stages or none" $
    forM_ stageChoices $ \stages ->
      forM_ [([], []), (["field/*"], []), ([], ["field/*"])] $ \(run, skip) -> do
        let settings =
              standardSettings {settingStages = stages, settingRun = run, settingSkip = skip}
            tried = if null stages then codeStages else stages
        stagesTried settings `shouldBe` tried
        choosesAll settings
          `shouldBe` ( null run && null skip
                         && sort tried `elem` map concat (drop 1 (subsequences stageSets))
                     )
        operationsOf tried
          `shouldBe` [o | o <- codeOperations, any (`elem` codeStages) tried]
            ++ [o | o <- operationsOf touchStages, any (`elem` touchStages) tried]
            ++ [o | o <- operationsOf objectStages, any (`elem` objectStages) tried]
  it "unless they are told, 100 cases of each law are drawn from the seed 1, in 300 seconds" $ do
    let settings = standardSettings
    (settingSeed settings, settingCases settings, settingLimit settings) `shouldBe` (1, 100, 300)
    (settingStages settings, settingFailFast settings, settingSkipMustFail settings)
      `shouldBe` ([], False, False)
    concatMap ($ settings) [settingRun, settingSkip, settingKnown] `shouldBe` []
  it "laws must fail that are known to, and those that are skipped if that is said" $ do
    let settings = standardSettings {settingKnown = ["a"], settingSkip = ["b", "c"]}
    mustFail settings `shouldBe` ["a"]
    mustFail settings {settingSkipMustFail = True} `shouldBe` ["a", "b", "c"]
  it "a token's law is found under its profile, which has its name if the suite knows it" $ do
    let found name profile = do
          work <- workFor suite (Token name profile Null)
          pure (workId work, fst <$> workProfile work, snd <$> workProfile work)
        under name profile = Just (name, fst <$> profile, snd <$> profile)
    found "field/sums" (Just one) `shouldBe` under "field/sums" (Just ("one", one))
    found "sequence/terms" (Just two) `shouldBe` under "sequence/terms" (Just ("two", two))
    found "field/sums" (Just other) `shouldBe` under "field/sums" (Just ("the token's", other))
    found "field/sums" (Just impossible) `shouldBe` Nothing
    found "profile/opens" Nothing `shouldBe` under "profile/opens" Nothing
    found "segment/none" Nothing `shouldBe` under "segment/none" Nothing
    found "field/sums" Nothing `shouldBe` Nothing
    found "profile/opens" (Just one) `shouldBe` Nothing
    found "field/sum" (Just one) `shouldBe` Nothing

stageSets :: [[Stage]]
stageSets = [codeStages, touchStages, objectStages]

-- | No stage, single ones, some, and all.
stageChoices :: [[Stage]]
stageChoices =
  map concat (subsequences stageSets)
    ++ map pure [minBound ..]
    ++ [drop 1 codeStages, drop 1 touchStages, codeStages ++ take 1 touchStages]
