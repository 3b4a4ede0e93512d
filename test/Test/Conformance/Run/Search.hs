{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Tests the runner on laws made for it: its findings do not depend on how many trials run at
-- once, counterexamples are the first or the smallest, and tokens hold all that a replay needs.
module Test.Conformance.Run.Search (spec) where

import Control.Monad (forM, forM_, replicateM)
import Data.Aeson (Value (..), encode, toJSON)
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (intercalate, nub)
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..))
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.InProcess
import PraTactile.Conformance.Law
import PraTactile.Conformance.Question (Op (Terms), Question (..))
import PraTactile.Conformance.Run.Case
import PraTactile.Conformance.Run.Pattern
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Subject
import PraTactile.Format.Json.Codec (Codec, natural, pairOf, readValue)
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile
import Test.Hspec
import Test.QuickCheck (Gen, chooseInteger)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  it "an exhaustive law reports its first failing case, however many trials run at once" $ do
    found <- forM [1, 2, 7, 64] $ \window -> tried window (everyPairOf judged)
    map summary found `shouldBe` replicate 4 (Just (toJSON [3, 7 :: Natural], 0), 38)
  it "a drawn law reports a case that no step makes smaller, however many trials run at once" $ do
    found <- forM [1, 2, 7, 64] $ \window -> tried window drawnPair
    map (fmap failureCase . triedFailure) found
      `shouldBe` replicate 4 (Just (toJSON [3, 7 :: Natural]))
  it "a case is made smaller in steps of one, even if that takes more than fifty" $ do
    let slowly (a, b) = [(a - 1, b) | a > 0] ++ [(a, b - 1) | b > 0]
    found <- forM [1, 7, 64] $ \window ->
      tried window (Cases pair (Some (QuickCheck.elements [(60, 61), (40, 99)]) slowly) judged)
    map summary found `shouldSatisfy` all (maybe False ((> 50) . snd) . fst)
    forM_ found $ \one -> do
      Just case' <- pure (failureCase <$> triedFailure one)
      Right least <- pure (readValue pair case')
      (least, filter failing (slowly least)) `shouldSatisfy` \(a, less) -> failing a && null less
  it "cases to which a law does not apply are not counted" $ do
    found <- tried 7 (everyPairOf (const (pure Inapplicable)))
    summary found `shouldBe` (Nothing, 0)
  it "drawn cases to which the law does not apply are replaced by others" $ do
    found <- tried 7 (Cases pair (Some draws (const [])) halfMeant)
    triedCases found `shouldBe` 50
  it "readToken (writeToken token) = Just token, with any profile or none" $ do
    let other = canonicalProfile {profileShape = Shape 3 85}
        token = Token "field/some" (Just other) (toJSON [1 :: Int])
        alone = token {tokenProfile = Nothing}
    readToken (writeToken token) `shouldBe` Just token
    readToken (writeToken alone) `shouldBe` Just alone
    map readToken ["", "abc", take 20 (writeToken token), writeToken token ++ "/"]
      `shouldBe` replicate 4 Nothing
    -- Characters that equal valid ones in their last eight bits.
    let movedBy by = map (toEnum . (+ by) . fromEnum) (writeToken alone)
    map (readToken . movedBy) [256, 512, 1024] `shouldBe` replicate 3 Nothing
  it "a token has version 1, and its profile is a list of ten values" $ do
    Object keys <- pure (profileValue canonicalProfile)
    let whole =
          [ Lazy.unpack (encode value)
            | name <-
                ["q", "modulus", "polynomial", "reading", "state"]
                  ++ ["folding", "shape", "window", "surface", "packing"],
              Just value <- [KeyMap.lookup name keys]
          ]
        list parts = "[" ++ intercalate "," parts ++ "]"
        token parts = readToken (base64 (list parts))
        with profile' = ["1", show id', profile', "[1]"]
        id' = "field/some" :: String
        read' = Just (Token "field/some" (Just canonicalProfile) (toJSON [1 :: Int]))
    token (with (list whole)) `shouldBe` read'
    token (with "null") `shouldBe` (\one -> one {tokenProfile = Nothing}) <$> read'
    map (token . with . list) [init whole, whole ++ ["0"], whole ++ [last whole], [], drop 1 whole]
      `shouldBe` replicate 5 Nothing
    map token [drop 1 (with "null"), init (with "null"), with "null" ++ ["0"], with "{}", with "1"]
      `shouldBe` replicate 5 Nothing
    map (\n -> token (n : drop 1 (with "null"))) ["0", "2", "\"1\""] `shouldBe` replicate 3 Nothing
  it "a pattern with * or ? matches the whole id; one without matches any part of it" $
    map
      (`matches` "field/addition-commutes")
      ["field/*", "*commute", "commutes", "field/?ddition-*", ""]
      `shouldBe` [True, False, True, True, True]
  it "in a pattern * matches any text, ? any character, and every other character itself" $ do
    let texts alphabet = concat [replicateM n alphabet | n <- [0 .. 4]]
        -- The lengths of text that the pattern's characters so far can match.
        reached name = foldl (further name) [0]
        further name starts c =
          nub $
            concat
              [ case c of
                  '*' -> [at .. length name]
                  '?' -> [at + 1 | at < length name]
                  _ -> [at + 1 | take 1 (drop at name) == [c]]
                | at <- starts
              ]
    let wrong =
          [ (pattern', name)
            | pattern' <- texts "ab*?",
              any (`elem` ("*?" :: String)) pattern',
              name <- texts "ab",
              matches pattern' name /= (length name `elem` reached name pattern')
          ]
    wrong `shouldBe` []

-- | In the alphabet of URLs, without padding.
base64 :: String -> String
base64 = concatMap digits . groups
  where
    groups text = if null text then [] else let (a, b) = splitAt 3 text in a : groups b
    digits three =
      let n = sum (zipWith (*) [65536, 256, 1] (map fromEnum three))
       in [alphabet !! (n `div` d `mod` 64) | d <- take (length three + 1) [262144, 4096, 64, 1]]
    alphabet = ['A' .. 'Z'] ++ ['a' .. 'z'] ++ ['0' .. '9'] ++ "-_"

-- | A law that fails where a < b and the terms at both are 1. It asks two questions, one after the
-- other.
judged :: (Natural, Natural) -> Ask Verdict
judged (a, b) = do
  first <- ask (Terms :? (a, 1))
  second <- ask (Terms :? (b, 1))
  pure $
    if (first, second) == (Right [1], Right [1]) && a < b
      then Violated (Violation [] (Result (toJSON ())) "" "")
      else Holds

-- | Whether the law fails, by the implementation's sequence itself.
failing :: (Natural, Natural) -> Bool
failing (a, b) = a < b && all (\i -> i == 3 || i >= 7) [a, b]

halfMeant :: (Natural, Natural) -> Ask Verdict
halfMeant (a, b) = pure (if even (a + b) then Holds else Inapplicable)

everyPairOf :: ((Natural, Natural) -> Ask Verdict) -> Cases
everyPairOf = Cases pair (Every [(a, b) | a <- [0 .. 9], b <- [0 .. 9]])

drawnPair :: Cases
drawnPair = Cases pair (Some draws smaller) judged
  where
    smaller (a, b) = [(a', b) | a' <- below a] ++ [(a, b') | b' <- below b]
    below n = [0 | n > 0] ++ [n `div` 2 | n > 1] ++ [n - 1 | n > 0]

draws :: Gen (Natural, Natural)
draws = (,) <$> drawn <*> drawn
  where
    drawn = fromInteger <$> chooseInteger (0, 100)

pair :: Codec (Natural, Natural)
pair = pairOf natural

-- | Runs a law on an implementation whose sequence is 1 at 3 and from 7 on, and 0 elsewhere.
tried :: Int -> Cases -> IO Tried
tried window cases = do
  subject <- inProcess steps
  _ <- subjectProfile subject canonicalProfile
  tryLaw (Plan 1 50 window True) subject "some" cases

steps :: Implementation
steps =
  Implementation
    { implementationName = "steps",
      offered = [],
      open = const (pure onTerms),
      withoutProfile = answering (const notOffered)
    }
  where
    onTerms = answering $ \question -> case question of
      Terms :? (from, _) -> pure [if from == 3 || from >= 7 then 1 else 0]
      _ -> notOffered

summary :: Tried -> (Maybe (Value, Int), Int)
summary one =
  ((\failure -> (failureCase failure, failureShrinks failure)) <$> triedFailure one, triedCases one)
