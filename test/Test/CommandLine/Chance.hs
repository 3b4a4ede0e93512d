{-# LANGUAGE OverloadedStrings #-}

-- | What @locate@ and @decode@ say of their answers' worth, as scripts see it. That it is so is
-- tested in "Test.Code.Locate.ChanceByEnumeration".
module Test.CommandLine.Chance (spec) where

import Control.Monad (forM_)
import Data.Aeson
import Data.List (isInfixOf)
import Data.Ratio ((%))
import Test.CommandLine.Run
import Test.Hspec

spec :: Spec
spec = do
  it "locate --json: exact, or at most with a larger radius or unknown orientation, or null" $
    do
      let told options text = do
            (_, out, _) <- pra (["locate", "--json"] ++ options ++ [text])
            pure (key ["chance"] out, key ["chance_is"] out)
          number share = Just (toJSON (fromRational share :: Double))
          zeros h w = unwords (drop 1 (concat (replicate h ("/" : replicate w "0"))))
      forM_
        [ (2, 2, 255 % 4 ^ (4 :: Int)),
          (2, 3, 255 % 4 ^ (6 :: Int)),
          (3, 3, 255 * 28 % 4 ^ (9 :: Int)),
          (3, 4, 255 * (1 + 36 + 594) % 4 ^ (12 :: Int))
        ]
        $ \(h, w, share) ->
          told [] (zeros h w) `shouldReturn` (number share, Just "exact")
      told ["--surface", "sheet"] "3 2 / 3 1" `shouldReturn` (number (224 % 256), Just "exact")
      told ["--radius", "1"] "3 2 / 3 1" `shouldReturn` (number 1, Just "at-most")
      told ["--radius", "2"] (zeros 3 3)
        `shouldReturn` (number (255 * (1 + 27 + 324) % 4 ^ (9 :: Int)), Just "at-most")
      told ["--orientation", "turned"] (zeros 2 3)
        `shouldReturn` (number (4 * 255 % 4096), Just "at-most")
      told [] "3 2" `shouldReturn` (number 1, Just "at-most")
      told [] "[[[0,0,0.1,0.9],2],[3,1]]" `shouldReturn` (number 1, Just "at-most")
      told [] "? ? / ? ?" `shouldReturn` (Just Null, Just Null)
      (_, batch, _) <- praWith ["locate", "--batch"] "3 2 / 3 1\n3 2 //\n"
      map (\line -> (key ["chance"] line, key ["chance_is"] line)) (lines batch)
        `shouldBe` [(number (255 % 256), Just "exact"), (Just Null, Just Null)]
  it "locate --json: on 2^60 cells, 8 x 8 of them" $ do
    (_, first', _) <- pra (words "polynomials --q 4 --degree 30 --first")
    (_, out, _) <-
      pra
        ( words "locate --json --q 4 --polynomial"
            ++ [ concat (take 1 (lines first')),
                 "--shape",
                 "1073741823x1073741825",
                 "--window",
                 "15x2",
                 "--road",
                 "algebra",
                 unwords (drop 1 (concat (replicate 8 ("/" : replicate 8 "1"))))
               ]
        )
    (key ["chance"] out, key ["chance_is"] out)
      `shouldBe` ( Just
                     (toJSON (fromRational ((4 ^ (30 :: Int) - 1) % 4 ^ (64 :: Int)) :: Double)),
                   Just "exact"
                 )
  it "locate warns where more than one random patch in a hundred would be located" $
    do
      forM_
        [ ("3 2 / 3 1", "of random symbols 99.6 % would be located"),
          ("3 2 0 / 3 1 2", "of random symbols 6.2 %")
        ]
        $ \(text, about) -> do
          (status, out, err) <- pra ["locate", text]
          (status, length (lines out), length (lines err)) `shouldBe` (0, 1, 1)
          err
            `shouldSatisfy` \warned ->
              "pra-tactile: warning: " `isInfixOf` warned && about `isInfixOf` warned
      (_, _, silent) <- pra ["locate", "--json", "3 2 / 3 1"]
      silent `shouldBe` ""
      (refused, _, none) <- pra ["locate", "0 0 / 0 0"]
      (refused, none) `shouldBe` (1, "")
      (sure, _, quiet) <- pra ["locate", "3 2 0 1 / 3 0 2 1 / 0 1 3 ? / 1 3 2 2"]
      (sure, quiet) `shouldBe` (0, "")
  it "decode tells it of the certain symbols and parts, at most" $ do
    (status, out, _) <- pra ["decode", "--json", "data/worked-example/composite.pgm"]
    -- Eight, of which one may be wrong.
    (status, key ["agreeing"] out, key ["radius"] out)
      `shouldBe` (0, Just (Number 8), Just (Number 1))
    (key ["chance"] out, key ["chance_is"] out)
      `shouldBe` (Just (toJSON (255 * 25 / 4 ^ (8 :: Int) :: Double)), Just "at-most")
    (_, text, _) <- pra ["decode", "data/worked-example/composite.pgm"]
    lines text `shouldContain` ["chance    of random symbols at most 9.7 % would be located"]
