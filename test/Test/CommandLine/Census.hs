{-# LANGUAGE OverloadedStrings #-}
-- | The census as scripts use it: in one run, continued, and in shards.
module Test.CommandLine.Census (spec) where

import Control.Monad (forM_)
import Data.Aeson (Value (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.CommandLine.Run
import Test.Hspec

spec :: Spec
spec = do
  it "census: one line an entry; the paper's array is in it, proved by both roads" $ inFolder $ \folder -> do
    (status, out, err) <- pra (census folder "c.csv" ++ ["--json"])
    -- 32 polynomials, 6 shapes, 2 windows; with 3 rows or 3 columns the powers of alpha down or across lie in
    -- GF(4), so that two cells tell no more than one.
    (status, key ["entries"] out, key ["proved"] out, err) `shouldBe` (0, Just (Number 384), Just (Number 256), "")
    whole <- lines <$> readFile (folder </> "c.csv")
    length whole `shouldBe` 385
    [drop 1 line | line <- map fields (drop 1 whole), take 2 (drop 7 line) `elem` [["15x17", "2x2"], ["15x17", "2x3"]], drop 5 (take 6 line) == ["3 2 1 0 1"]]
      `shouldBe` [ words' "4;384;4;1 1 1;3 2 1 0 1;diagonal;15x17;2x2;yes;yes;yes;4;4;255;255;1"
                 , words' "5;384;4;1 1 1;3 2 1 0 1;diagonal;15x17;2x3;yes;yes;yes;4;4;255;255;2" ]
  it "census: cut off anywhere, it is continued to the same bytes; complete, it stays as it is" $ inFolder $ \folder -> do
    _ <- pra (census folder "whole.csv")
    whole <- readFile (folder </> "whole.csv")
    let file = folder </> "cut.csv"
        ends = length whole : [0, 1, 100, 131, 132, 133, 1000, length whole - 1]
    forM_ ends $ \end -> do
      writeFile file (take end whole)
      (status, _, _) <- pra (census folder "cut.csv")
      again <- readFile file
      (end, status, again == whole) `shouldBe` (end, 0, True)
  it "census: another census's file, or any other file, is refused and not touched" $ inFolder $ \folder -> do
    _ <- pra (census folder "whole.csv")
    whole <- readFile (folder </> "whole.csv")
    let file = folder </> "other"
    forM_ ["precious\n", whole ++ "1\n", unlines (swapped (lines whole)), take 300 whole ++ "\nx\n"] $ \content -> do
      writeFile file content
      (status, _, err) <- pra (census folder "other")
      (status, length (lines err)) `shouldBe` (2, 1)
      readFile file `shouldReturn` content
    writeFile file whole
    complains ["census", "--q", "4", "--degree", "3", "--output", file] "not an unfinished file"
    complains (census folder "other" ++ ["--shard", "1/2"]) "not an unfinished file"
  it "merge: shards in any order are the census in one run, byte by byte" $ inFolder $ \folder -> do
    _ <- pra (census folder "whole.csv")
    whole <- readFile (folder </> "whole.csv")
    forM_ [1, 2, 5 :: Int] $ \k -> do
      let part i = "part" ++ show i ++ "-" ++ show k
          names = map ((folder </>) . part) [1 .. k]
      forM_ [1 .. k] $ \i -> pra (census folder (part i) ++ ["--shard", show i ++ "/" ++ show k])
      pra ("merge" : reverse names) `shouldReturn` (0, whole, "")
      (status, _, _) <- pra ("merge" : names ++ ["--output", folder </> "merged.csv"])
      again <- readFile (folder </> "merged.csv")
      (status, again == whole) `shouldBe` (0, True)
  it "merge: incomplete, overlapping, unfinished and foreign shards are refused" $ inFolder $ \folder -> do
    let file name = folder </> name
    forM_ [1, 2, 3 :: Int] $ \i -> pra (census folder ("part" ++ show i) ++ ["--shard", show i ++ "/3"])
    complains ["merge", file "part1", file "part3"] "128 of 384 entries are missing"
    complains ["merge", file "part1", file "part2", file "part3", file "part2"] "entry 1 is in"
    _ <- pra ["census", "--q", "2", "--degree", "4", "--output", file "other"]
    complains ["merge", file "part1", file "other"] "different censuses"
    part <- readFile (file "part1")
    writeFile (file "cut") (take (length part - 3) part)
    complains ["merge", file "cut", file "part2", file "part3"] "cut off"
    complains ["merge", file "none"] "none"
    complains ["merge", "data/shapes.txt"] "first line"
    complains ["merge", file "part1", file "part2", file "part3", "--output", file "no/such"] "folder does not exist"
  it "census: an impossible scope is status 2 with the reason" $ inFolder $ \folder -> do
    complains ["census", "--q", "6", "--degree", "2", "--output", folder </> "x"] "6 is not a prime power"
    complains ["census", "--q", "4", "--degree", "0", "--output", folder </> "x"] "degree 0"
    complains ["census", "--q", "4", "--modulus", "1,0,1", "--degree", "2", "--output", folder </> "x"] "factors"
    complains ["census", "--q", "2", "--degree", "3", "--output", folder </> "no" </> "x"] "cannot write"
    forM_ ["0/2", "3/2", "1", "a/b"] $ \shard -> do
      (status, out, _) <- pra (census folder "x" ++ ["--shard", shard])
      (status, out) `shouldBe` (2, "")
 where
  census folder name = words "census --q 4 --degree 4 --folding diagonal --window 2x2 --window 2x3 --output" ++ [folder </> name]
  inFolder = withSystemTempDirectory "pra-tactile"
  fields line = words' (map (\c -> if c == ',' then ';' else c) line)
  words' text = case break (== ';') text of
    (field, _ : rest) -> field : words' rest
    (field, []) -> [field]
  swapped ls = take 1 ls ++ reverse (drop 1 ls)
