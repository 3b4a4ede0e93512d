{-# LANGUAGE OverloadedStrings #-}
-- | @locate@ with damage, as scripts use it.
module Test.CommandLine.Locate (spec) where

import Data.Aeson
import Data.Foldable (for_)
import Data.List (intercalate)
import qualified Data.Text as Text
import Test.CommandLine.Run
import Test.Hspec

spec :: Spec
spec = do
  it "locate corrects what the observed cells guarantee, and more only where told to" $ do
    (status, out, _) <- pra ["locate", "--json", "3 2 1 2 / 3 1 3 0 / 2 2 2 3 / 0 2 2 2"]
    (status, key ["outcome"] out, key ["reason"] out, key ["radius"] out, key ["minimum_distance"] out)
      `shouldBe` (1, Just "refused", Just "beyond-radius", Just (Number 4), Just (Number 9))
    (_, array, _) <- pra ["array", "--format", "csv"]
    let rows = map (map (\c -> if c == ',' then ' ' else c)) (lines array)
        cells r c h w = [take w (drop c (words row)) | row <- take h (drop r rows)]
        wrongAt (i, j) patch = [[if (i, j) == (a, b) then (if cell == "0" then "1" else "0") else cell | (b, cell) <- zip [0 ..] row] | (a, row) <- zip [0 :: Int ..] patch] :: [[String]]
        written = intercalate " / " . map unwords
        damaged = foldr wrongAt (cells 4 3 4 4) [(0, 0), (1, 2), (2, 1), (3, 3 :: Int)]
    prints ["locate", written damaged] ["row 4, column 3 (4 cells corrected)"]
    (refused, strict, _) <- pra ["locate", "--json", "--radius", "3", written damaged]
    (refused, key ["reason"] strict) `shouldBe` (1, Just "beyond-radius")
    for_ ["table", "search", "algebra"] $ \road -> do
      (located, exact, _) <- pra ["locate", "--json", "--road", road, written (cells 4 3 4 4)]
      (located, key ["road"] exact, key ["position", "row"] exact) `shouldBe` (0, Just (String (Text.pack road)), Just (Number 4))
      (contradicted, no, _) <- pra ["locate", "--json", "--road", road, written damaged]
      (contradicted, key ["reason"] no) `shouldBe` (1, Just "contradiction")
  it "locate takes probabilities as JSON" $ do
    prints ["locate", "--doubt", "0.2", "[[[0,0,0.1,0.9],2],[\"A^2\",1]]"] ["row 6, column 5"]
    (status, out, _) <- pra ["locate", "--json", "[[[0,0,0.1,0.9],2],[3,1]]"]
    (status, key ["reason"] out) `shouldBe` (1, Just "below-threshold")
    for_ ["[[[0,0,0.1],2],[3,1]]", "[[[0,0,2,-1],2],[3,1]]", "[[3.5]]", "[[3],[]]", "[3", "[[true]]"] $ \patch -> complains ["locate", patch] ""
