{-# LANGUAGE GADTs #-}

-- | What a failure depends on: made subjects that remember, of which it is known what makes them
-- err.
module Test.Conformance.Run.Fresh (spec) where

import Data.IORef
import Numeric.Natural (Natural)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Run.Fresh
import PraTactile.Conformance.Subject
import Test.Conformance.Run.SmallSuite
import Test.Hspec

spec :: Spec
spec = do
  it "what fails in a fresh process too depends on itself alone" $
    dependsOn (const True) [0 .. 9] `shouldReturn` "OnItself"
  it "of what was asked before, as little is told as makes it fail" $ do
    dependsOn (elem 5) [0 .. 9] `shouldReturn` told [5]
    dependsOn (\asked -> elem 3 asked && elem 8 asked) [0 .. 40] `shouldReturn` told [3, 8]
    dependsOn ((>= 4) . length) [0 .. 40] `shouldReturn` told [38, 39, 40]
  it "what was asked so long before that it is forgotten is not told" $
    dependsOn (elem 5) (5 : replicate 1000 6) `shouldReturn` "OnUnknown"
  it "no more is asked than may be, fresh processes among it; else it is unknown" $ do
    dependsWithin 200 (elem 5) [0 .. 9] `shouldReturn` "OnUnknown"
    dependsWithin 1000 (elem 5) [0 .. 9] `shouldReturn` told [5]
  it "what only the next request shows is told too" $
    dependsOn ((== [5]) . take 1 . drop 1 . reverse) [0 .. 40] `shouldReturn` told [5]
  where
    told :: [Natural] -> String
    told indices = show (OnEarlier [AskedQuestion (SomeQuestion (Term i)) | i <- indices])

-- | What a failure of the 100th term depends on, as it is shown: of a subject that errs there if
-- this holds of what it was asked, the 100th term included; and that is asked these terms first.
dependsOn :: ([Natural] -> Bool) -> [Natural] -> IO String
dependsOn = dependsWithin 20000

-- | The same where so many requests may be asked for that.
dependsWithin :: Int -> ([Natural] -> Bool) -> [Natural] -> IO String
dependsWithin most errs earlier = do
  asked <- newIORef ([] :: [Natural])
  let answer :: SomeQuestion -> IO (Either Fault Response)
      answer question = case question of
        SomeQuestion (Term i) -> do
          modifyIORef asked (++ [i])
          wrong <- errs <$> readIORef asked
          pure (result (if i == 100 && wrong then 1 else 0))
        _ -> pure (result 0)
  (subject, past, _, _) <-
    remembering
      (answering allZero)
        { subjectAsk = traverse answer,
          subjectFresh = Just (writeIORef asked [])
        }
  _ <- subjectAsk subject [SomeQuestion (Term i) | i <- earlier]
  remembered <- past
  enough <- newIORef most
  show
    <$> dependence enough subject Nothing remembered (wrongIn <$> subjectAsk subject [hundredth])
  where
    hundredth = SomeQuestion (Term 100)
    wrongIn = (/= [result 0])
