-- | Tests which laws of a suite the runner tries, under which profiles and in which order.
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
  it "the order is: laws of profiles, laws of the code under each profile with an array, touch" $ do
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
  it "laws are chosen by stage and pattern; those left out or not offered give the reason" $ do
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
  it "a run is complete if no law is named and each of code, touch, objects is whole or left out" $
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
  it "by default each law has 100 cases, drawn from seed 1, and the run has 300 seconds" $ do
    let settings = standardSettings
    (settingSeed settings, settingCases settings, settingLimit settings) `shouldBe` (1, 100, 300)
    (settingStages settings, settingFailFast settings, settingSkipMustFail settings)
      `shouldBe` ([], False, False)
    concatMap ($ settings) [settingRun, settingSkip, settingKnown] `shouldBe` []
  it "known failures must fail, and so must skipped laws if that is requested" $ do
    let settings = standardSettings {settingKnown = ["a"], settingSkip = ["b", "c"]}
    mustFail settings `shouldBe` ["a"]
    mustFail settings {settingSkipMustFail = True} `shouldBe` ["a", "b", "c"]
  it "a token's law is found under its profile, by the profile's name if the suite knows it" $ do
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

-- | No stage, single stages, some, and all.
stageChoices :: [[Stage]]
stageChoices =
  map concat (subsequences stageSets)
    ++ map pure [minBound ..]
    ++ [drop 1 codeStages, drop 1 touchStages, codeStages ++ take 1 touchStages]
