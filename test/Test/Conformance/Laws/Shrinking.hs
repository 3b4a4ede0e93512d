{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | What is tried in place of a failing case is smaller, and is still a case of the law; a failing
-- one ends as a small one.
module Test.Conformance.Laws.Shrinking (spec) where

import Data.Aeson (Value (..), object, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (for_, toList)
import qualified Data.Text as Text
import PraTactile.Array (Shape (..))
import PraTactile.Conformance
import PraTactile.Conformance.Definition
import PraTactile.Conformance.InProcess (inProcess)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run
import PraTactile.Conformance.Suite (noSuiteText, standardSuite)
import PraTactile.Format.Json.Codec (readValue, writeValue)
import PraTactile.Profile
import Test.Conformance.Laws.Trials
import Test.Hspec
import Text.Read (readMaybe)

spec :: Spec
spec = do
  it "what is tried is smaller, and a case of which the law holds where all is answered rightly" $
    for_ (over37 : [p | (name, p) <- defaultProfiles, name `elem` small]) $ \p -> do
      Right about <- pure (known p)
      for_ laws $ \law -> case lawCases law about of
        Cases form (Some gen smaller) trial ->
          for_ (draws 6 gen) $ \one -> for_ (smaller one) $ \less -> do
            let (whole, part) = (writeValue form one, writeValue form less)
            (lawId law, whole, part, size part < size whole)
              `shouldBe` (lawId law, whole, part, True)
            (lawId law, writeValue form <$> readValue form part)
              `shouldBe` (lawId law, Right part)
            (lawId law, part, fst (askedBy (expected about) (trial less)))
              `shouldSatisfy` \(_, _, verdict) -> verdict `elem` [Holds, Inapplicable]
        Cases _ (Every _) _ -> pure ()
  it "of touch, whatever is tried next, it comes to an end, and of objects what is tried first" $
    for_ lawsWithoutProfile $ \law -> case lawCases law () of
      Cases form (Some gen smaller) _ ->
        for_ (draws 12 gen) $ \one -> for_ (choices (lawStage law)) $ \choice -> do
          let steps = takeWhile (not . null) (iterate (smaller . choice) [one])
          (lawId law, writeValue form one, length (take 2000 steps))
            `shouldSatisfy` \(_, _, count) -> count < 2000
      Cases _ (Every _) _ -> pure ()
  for_ failing $ \(law, wrong, smallest) ->
    it (law ++ ": a failing case ends as " ++ show smallest) $ do
      suite <- either (fail . noSuiteText) pure (standardSuite (take 1 defaultProfiles))
      subject <- inProcess (refusing wrong)
      report <- runSuite standardSettings {settingRun = [law]} suite (const (pure ())) [subject]
      let asked =
            [ KeyMap.lookup "input" request
              | Just found <- map lawReportCounterexample (reportLaws report),
                Object request <- counterRequests found
            ]
      asked `shouldBe` [Just (object smallest)]
  where
    small = ["paper", "gf3-2x13"]
    choices stage = head : [last | stage /= OnObjects]
    failing =
      [ ( "sequence/term-of-any-index",
          \(SomeQuestion question) -> case question of
            Term i -> i > 1000
            _ -> False,
          ["index" .= (1001 :: Int)]
        ),
        ( "damage/stated-radius",
          \(SomeQuestion question) -> case question of
            Nearest _ patch -> any (elem (Just 1)) patch
            _ -> False,
          ["patch" .= [[1 :: Int]], "radius" .= (0 :: Int)]
        ),
        ( "proof/prove-drawn-masks",
          \(SomeQuestion question) -> case question of
            Prove mask -> length mask > 1
            _ -> False,
          ["mask" .= ("./#" :: String)]
        )
      ]

-- | The library, but that it refuses some questions for no reason that there is.
refusing :: (SomeQuestion -> Bool) -> Implementation
refusing wrong = library {open = fmap otherwise' . open library}
  where
    otherwise' session = answering $ \question ->
      if wrong (SomeQuestion question) then refuse "wrong" else answerTo session question

-- | A profile over a field of which laws draw elements instead of trying all. 37 is prime, and
-- x + 35 has the root 2, primitive modulo 37.
over37 :: Profile
over37 =
  canonicalProfile
    { profileOrder = 37,
      profileModulus = [35, 1],
      profilePolynomial = [5, 1, 1],
      profileState = [0, 1],
      profileShape = Shape 8 171,
      profileWindow = Shape 1 2
    }

-- | How much there is in a case: cells and elements, and how large the numbers are. Of a damaged
-- patch only the damage counts.
size :: Value -> Rational
size value = case value of
  Null -> 1
  Bool _ -> 1
  Number n -> amount (toRational n)
  String text -> case readMaybe (Text.unpack text) of
    Just n -> amount (fromInteger n)
    Nothing -> fromIntegral (Text.length text + Text.count "#" text)
  Array items -> 1 + 2 * sum (map size (toList items))
  Object fields -> case (KeyMap.lookup "true" fields, KeyMap.lookup "patch" fields) of
    (Just true, Just patch) ->
      fromIntegral (length (filter id (zipWith (/=) (cells true) (cells patch))))
    _ -> sum (map size (KeyMap.elems fields))
  where
    amount n = 2 + abs n + (if n < 0 then 1 / 2 else 0)
    cells several = concatMap parts (parts several)
    parts several = case several of
      Array some -> toList some
      _ -> []
