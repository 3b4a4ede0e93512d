{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}

-- | One answer in the place of another, anywhere: the law that asks for it says so, at that case,
-- and says what was to be expected.
module Test.Conformance.Laws.OneWrongAnswer (spec) where

import Control.Monad (unless)
import Control.Monad.Trans.State.Strict (State, get, put, runState)
import Data.Aeson (toJSON)
import Data.Foldable (for_)
import Data.List (isPrefixOf, isSuffixOf)
import Data.Traversable (for)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Impostors.Score
import PraTactile.Conformance.Law
import PraTactile.Conformance.Run.Case (Plan (..), Share (..), trialsOf)
import PraTactile.Conformance.Wire (answerValue, questionInput)
import PraTactile.Format.Json.Codec (readValue)
import PraTactile.Profile
import Test.Hspec

spec :: Spec
spec = do
  it "a law that exhausts its domain finds one wrong answer, at the case that asks for it" $
    for_ [about | (name, _, about) <- comparedProfiles, name == "gf2-3x5"] $ \about ->
      for_ [law | law <- laws, "-as-defined" `isSuffixOf` lawId law] $ \law -> do
        let trials = trialsUnder about law
            count = length trials
            at = filter (\i -> i >= 1 && i <= count) [1, 2, count `div` 2, count]
        for_ at $ \i -> do
          found <- liedTo about i trials
          (lawId law, i, found) `shouldBe` (lawId law, i, Just i)
  it "another last answer than the definition's is found, in whatever part it is another one" $
    for_ [about | (name, _, about) <- comparedProfiles, name `elem` ["gf2-3x5", "gf3-2x13"]] $
      \about -> for_ laws $ \one -> do
        let trials = take 8 (trialsUnder about one)
            meant = [asking | asking <- trials, fst (answeredBy (expected about) asking) == Holds]
        found <- for meant $ \asking -> do
          let asked = snd (answeredBy (expected about) asking)
              lie i = answeredAs (lyingAt about (length asked) i) asking
              lies = takeWhile ((/= asked) . snd) (map lie [0 ..])
          for lies $ \(verdict, others') -> do
            let told' = case verdict of
                  Violated violation -> [(violationAsked violation, violationExpected violation)]
                  _ -> []
                wanted = exchangeReply (last asked)
            [violationRoad violation | Violated violation <- [verdict]]
              `shouldSatisfy` all (\road -> any (`isPrefixOf` road) roads)
            -- All that was asked is told, and what the last answer should have been.
            unless (lawId one `elem` byOthers) $
              (lawId one, filter (/= (others', wanted)) told') `shouldBe` (lawId one, [])
            pure (verdict == Holds)
        let held = length (filter id (concat found))
        if lawId one `elem` notAlways
          then (lawId one, held < length (concat found)) `shouldBe` (lawId one, True)
          else (lawId one, held) `shouldBe` (lawId one, 0)
  it "a refusal that the definition does not have is told, whichever question of a trial it is of" $
    for_ [about | (name, _, about) <- comparedProfiles, name == "gf2-3x5"] $ \about -> do
      let trials =
            [ (lawId one, i, asking)
              | one <- laws,
                (i, asking) <- take 4 (zip [1 :: Int ..] (trialsUnder about one))
            ]
      for_ trials $ \(name, i, asking) -> do
        let asked = snd (answeredBy (expected about) asking)
        for_ [1 .. length asked] $ \at -> do
          let (verdict, lied) = answeredBy' (expected about) at asking
              told' = case verdict of
                Violated violation -> Just (violationAsked violation, violationExpected violation)
                _ -> Nothing
          (name, i, told') `shouldBe` (name, i, Just (lied, exchangeReply (asked !! (at - 1))))
  it "what a wrong answer leads to may be refused, of which a law says nothing, for that reason" $
    for_ [about | (name, _, about) <- comparedProfiles, name == "gf2-3x5"] $ \about -> do
      [one] <- pure [one | one <- laws, lawId one == "window/unpack-inverts-pack"]
      let Shape h w = profileWindow (knownProfile about)
          tooLarge = 2 ^ (h * w) :: Natural
      for_ (take 3 (trialsUnder about one)) $ \asking -> do
        let answers :: String -> Question b -> Either Refusal b
            answers reason other = case other of
              Pack _ -> Right tooLarge
              Unpack _ -> Left (Refusal reason)
              _ -> expected about other
        fst (answeredBy (answers "out-of-range") asking) `shouldBe` Inapplicable
        let (verdict, asked) = answeredBy (answers "invalid") asking
        Violated violation <- pure verdict
        (violationAsked violation, violationExpected violation)
          `shouldBe` (asked, RefusedFor "out-of-range")
  it "places told by number and dimension hold if both are right: the degree less the rank" $ do
    Just paper <- pure (lookup "paper" defaultProfiles)
    Right about <- pure (known paper)
    Right narrow <- pure (known paper {profileWindow = Shape 1 2})
    let small = "damage/small-patches"
    -- Cells side by side are independent, up to the degree, 4.
    for_
      [ (about, small, Nearest (Just 0) [[Just 1]], (64, 3)),
        (about, small, Nearest (Just 0) [[Just 1, Just 0]], (16, 2)),
        (about, small, Nearest (Just 0) [[Just 1, Nothing, Just 0, Just 2]], (4, 1)),
        (narrow, "locate/every-window", Locate [[Just 1, Just 0]], (16, 2)),
        (narrow, "locate/every-window", Locate [[Just 1, Just 0, Just 2]], (4, 1))
      ]
      $ \(with, name, question, (count :: Natural, dimension)) -> do
        [Cases form _ asking] <- pure [lawCases one with | one <- laws, lawId one == name]
        let asked = toJSON [toJSON (operationName (operationOf question)), questionInput question]
        Right one <- pure (readValue form asked)
        fromIntegral (length (placesOf (expected with question))) `shouldBe` count
        for_ [(c, d) | c <- [count - 1 .. count + 1], d <- [0 .. 6 :: Natural]] $ \(c, d) -> do
          let answers :: Question b -> Either Refusal b
              answers other = case other of
                Locate _ -> Right (Coset c d)
                Nearest _ _ -> Right (Coset c d)
                _ -> Left (Refusal "")
          (asked, c, d, fst (answeredBy answers (asking one)) == Holds)
            `shouldBe` (asked, c, d, (c, d) == (count, dimension))
  it "windows and masks have 1 to 4096 cells, arrays at most 2^20" $ do
    Just paper <- pure (lookup "paper" defaultProfiles)
    let why' answer = either Just (const Nothing) answer
        sized shape = why' (known paper {profileWindow = shape})
    map sized [Shape 64 64, Shape 4096 1, Shape 1 1] `shouldBe` [Nothing, Nothing, Nothing]
    map sized [Shape 4097 1, Shape 64 65, Shape 0 5, Shape 5 0]
      `shouldBe` replicate 4 (Just NoArray)
    Right about <- pure (known paper)
    let asked mask = refusalReason <$> why' (expected about (Prove mask))
    asked [replicate 4096 '#'] `shouldBe` Nothing
    asked [replicate 4097 '#'] `shouldBe` Just "invalid"
    asked (replicate 64 (replicate 64 '#')) `shouldBe` Nothing
    asked ("#" : replicate 64 (replicate 64 '#')) `shouldBe` Just "invalid"
    asked [replicate 9000 '.'] `shouldBe` Just "invalid"
    asked ['.' <$ [1 .. 9000 :: Int], '#' <$ [1 .. 9000 :: Int]] `shouldBe` Just "invalid"
    -- Of x^n + 1, which is never primitive.
    let long n =
          paper
            { profileOrder = 2,
              profileModulus = [0, 1],
              profilePolynomial = 1 : replicate (n - 1) 0 ++ [1],
              profileState = 1 : replicate (n - 1) 0,
              profileShape = Shape 1 (2 ^ n - 1),
              profileWindow = Shape 1 (fromIntegral n)
            }
    map (why' . known . long) [20, 21, 22]
      `shouldBe` [Just NoArray, Just TooManyCells, Just TooManyCells]
  where
    -- What one term is decides only if its coefficient is not 0; of two others in a period the
    -- differences may be as often as before, and it may be the same one a step further; a distance
    -- that is not coprime to the period decimates nothing.
    -- How it begins by which road a law knows what should have come.
    roads =
      ["the definition", "a theorem", "an axiom of fields", "the folding", "the other answer"]
        ++ ["the profile's ", "the protocol", "the window was read there"]
    notAlways =
      [ -- Of a probability below 10^-9 any other such is as good.
        "chances/bayes",
        "sequence/obeys-the-recurrence",
        "sequence/autocorrelates-by-minus-one",
        "sequence/is-its-own-qth-decimation",
        "sequence/decimates"
      ]
    -- Told is what would fit to the other answers; of several places the one that was looked at.
    byOthers = ["proof/distance-is-0-where-the-rank-is-less", "locate/inverse-of-looking"]
    placesOf came = case came of
      Right (OneOf places) -> places
      _ -> []

-- | The trials of a law.
trialsUnder :: Known -> Law Known -> [Ask Verdict]
trialsUnder about law = fst (trialsOf plan (lawId law) (lawCases law about))
  where
    plan = Plan 1 40 1 False Whole

-- | At which case somebody is found who answers as the definition does, but for one answer: the
-- first one that this case asks for.
liedTo :: Known -> Int -> [Ask Verdict] -> IO (Maybe Int)
liedTo about i trials = go 1 trials
  where
    go n those = case those of
      [] -> pure Nothing
      one : rest -> do
        verdict <- answerAll (const (pure (Right ()))) (pure . answered n) one
        case verdict of
          Violated _ -> pure (Just (n :: Int))
          _ -> go (n + 1) rest
    answered :: Int -> Question b -> Either Refusal b
    answered n question
      | n == i = case expected about question of
        Left _ -> Left (Refusal "not-offered")
        Right _ -> Left (Refusal "contradiction")
      | otherwise = expected about question

-- | The verdict, and what was asked with the replies, where all is answered so.
answeredBy :: (forall b. Question b -> Either Refusal b) -> Ask Verdict -> (Verdict, [Exchange])
answeredBy answers = answeredBy' answers 0

-- | The same where this question, counted from 1, is refused for a reason of one's own.
answeredBy' ::
  (forall b. Question b -> Either Refusal b) -> Int -> Ask Verdict -> (Verdict, [Exchange])
answeredBy' answers at =
  answeredAs $ \i question ->
    if i == at then Left (Refusal "a reason of one's own") else answers question

-- | The right answers, but for the question of that number, which has this one of the others.
lyingAt :: Known -> Int -> Int -> Int -> Question b -> Either Refusal b
lyingAt about count which i question = case expected about question of
  Right answer
    | i == count, other : _ <- drop which (others about question answer) -> Right other
  came -> came

-- | Other answers: another number, one element another one, one less or more, another part.
others :: Known -> Question b -> b -> [b]
others about question answer = case question of
  Add _ _ -> code answer
  Multiply _ _ -> code answer
  Negate _ -> code answer
  Inverse _ -> code answer
  Power _ _ -> code answer
  Logarithm _ -> [answer + 1]
  Trace _ -> code answer
  Primitive _ -> [not answer]
  FirstPrimitive _ -> list answer
  Term _ -> code answer
  Terms _ _ -> list answer
  Cell _ _ -> code answer
  Pack _ -> [answer + 1]
  Unpack _ -> list answer
  Locate _ -> place answer
  Nearest _ _ -> place answer
  Posterior _ -> [(at, x / 2) : more | (at, x) : more <- [answer]]
  Prove _ ->
    [ answer {proofHolds = not (proofHolds answer)},
      answer {proofWindows = proofWindows answer + 1}
    ]
  Distance _ -> [if answer == 0 then 1 else 0]
  _ -> []
  where
    q = profileOrder (knownProfile about)
    Shape n1 n2 = profileShape (knownProfile about)
    next a = (a + 1) `mod` q
    code :: Code -> [Code]
    code a = [next a]
    list :: [Code] -> [[Code]]
    list codes =
      [take i codes ++ next a : drop (i + 1) codes | (i, a) <- zip [0 ..] codes]
        ++ [take (length codes - 1) codes | not (null codes)]
        ++ [codes ++ [0]]
    place :: Location -> [Location]
    place found = case found of
      At (Position r c) ->
        [At (Position ((r + 1) `mod` n1) c), At (Position r ((c + 1) `mod` n2))]
      OneOf places -> [OneOf (drop 1 places)]
      Coset _ _ -> []

-- | The same where each question, counted from 1, is answered so.
answeredAs ::
  (forall b. Int -> Question b -> Either Refusal b) -> Ask Verdict -> (Verdict, [Exchange])
answeredAs answers asking =
  reverse <$> runState (answerAll (const (pure (Right ()))) reply asking) []
  where
    reply :: Question b -> State [Exchange] (Either Refusal b)
    reply question = do
      before' <- get
      let came = answers (length before' + 1) question
      came <$ put (exchangeOf question came : before')
    exchangeOf question came =
      Exchange
        (Just (operationOf question))
        (questionInput question)
        (either (RefusedFor . refusalReason) (Result . answerValue question) came)
