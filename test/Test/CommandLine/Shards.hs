{-# LANGUAGE OverloadedStrings #-}

-- | Evaluations in shards, as scripts use them.
module Test.CommandLine.Shards (spec) where

import Control.Monad (forM, forM_)
import Data.Aeson (Value (..))
import Data.List (isInfixOf)
import System.FilePath ((</>))
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  it "evaluate: the shards of an evaluation, merged, are one run to the byte" $
    forM_ settings $ \setting -> inFolder $ \folder -> do
      (_, whole, _) <- pra (setting ++ ["--json"])
      forM_ (byEffort [3] [1, 2, 6]) $ \count -> do
        names <- forM [1 .. count] $ \i -> do
          let name = folder </> show count ++ "-" ++ show i
          (status, _, err) <- pra (shardOf setting i count ++ ["--output", name])
          (status, err) `shouldBe` (0, "")
          pure name
        pra ("merge" : reverse names) `shouldReturn` (0, whole, "")
        (status, out, _) <- pra ("merge" : names ++ ["--output", folder </> "m", "--json"])
        merged <- readFile (folder </> "m")
        (status, key ["presses"] out, merged) `shouldBe` (0, Just (Number 5), whole)
  it "evaluate: a shard's JSON is its file, and a file cut off is continued to the same bytes" $
    inFolder $ \folder -> do
      let asked = shardOf plain 2 2
          file = folder </> "part"
      (_, whole, _) <- pra (asked ++ ["--json"])
      let begins = length (takeWhile (/= '\n') whole)
      forM_ ([0, begins - 1, begins + 20, length whole] ++ byEffort [] [1, begins .. begins + 9]) $
        \end -> do
          writeFile file (take end whole)
          (status, out, _) <- pra (asked ++ ["--output", file])
          again <- readFile file
          (end, status, length (lines out), again) `shouldBe` (end, 0, 4, whole)
  it "evaluate: another file is refused and not touched; merge refuses what is not whole" $
    inFolder $ \folder -> do
      let file name = folder </> name
      forM_ [1, 2 :: Int] $ \i -> pra (shardOf plain i 2 ++ ["--output", file (show i)])
      one <- readFile (file "1")
      let continuing name = shardOf plain 1 2 ++ ["--output", file name]
          damaged =
            [ ("precious\n", "is not an unfinished file"),
              (firstReplaced "\"seed\":1" "\"seed\":2" one, "and shard (other seed)"),
              (firstReplaced "\"press\":3" "\"press\":5" one, "line 3 is damaged: its check"),
              (firstReplaced "right" "wrong" one, "line 2 is damaged: its check"),
              ( firstReplaced ",\"right\":3," ",\"right\":2," one,
                "is not what the presses before it come to"
              ),
              ( unlines (onLine 2 (const (drop 1 (lines one !! 2))) (lines one)),
                "line 2 has another press"
              ),
              (firstReplaced "\n," "\n" one, "line 3 is not a press")
            ]
      forM_ damaged $ \(content, why) -> do
        writeFile (file "bad") content
        complains (continuing "bad") why
        readFile (file "bad") `shouldReturn` content
      complains (shardOf plain 2 2 ++ ["--output", file "1"]) "and shard (other shard)"
      writeFile (file "bad") (firstReplaced "\"seed\":1" "\"seed\":2" one)
      complains ["merge", file "bad"] "line 2 is damaged: its check"
      writeFile (file "bad") ""
      complains ["merge", file "1", file "bad"] "bad is cut off"
      complains ["merge", file "1", "Makefile"] "is not a file of"
      complains ["merge", file "1"] "2 of 5 presses are missing: 2, 4;"
      complains ["merge", file "1", file "2", file "2"] "press 2 is in"
      writeFile (file "cut") (take (length one - 9) one)
      complains ["merge", file "cut", file "2"] "is cut off"
      _ <- pra (shardOf (plain ++ words "--noise 0.2") 2 2 ++ ["--output", file "n"])
      complains ["merge", file "1", file "n"] "of different evaluations: other noise, objects"
      complains ["merge", file "1", file "2", "--keep-whole"] "leave out --keep-whole"
      complains (plain ++ ["--shard", "6/5"]) "a shard is I/K"
      complains (plain ++ ["--shard", "1/1000000001"]) "at most a billion parts"
      readFile (file "1") `shouldReturn` one
  it "evaluate: shards with regions of other sizes are of different evaluations" $
    inFolder $ \folder -> do
      let file name = folder </> name
          sized = words "evaluate --presses 2 --seed 1 --size 44x52 --shard 2/2 --output"
      _ <- pra (words "evaluate --presses 2 --seed 1 --shard 1/2 --output" ++ [file "a"])
      _ <- pra (sized ++ [file "b"])
      (_, _, err) <- pra ["merge", file "a", file "b"]
      err `shouldSatisfy` isInfixOf "different evaluations"
  where
    plain = words "evaluate --presses 5 --seed 1"
    settings =
      plain :
      byEffort
        []
        [ words "evaluate --presses 5 --seed 3 --sensor real --any-angle --foreign 0.5 --untold",
          words "evaluate --presses 5 --seed 2 --bend 80 --object sheet"
        ]
    shardOf :: [String] -> Int -> Int -> [String]
    shardOf setting i count = setting ++ ["--shard", show i ++ "/" ++ show count]
