{-# LANGUAGE OverloadedStrings #-}

-- | The census as scripts use it: in one run, continued, and in shards.
module Test.CommandLine.Census (spec) where

import Control.Monad (forM_)
import Data.Aeson (Value (..))
import System.Directory (createFileLink, doesPathExist)
import System.FilePath ((</>))
import System.Posix.Files (createLink)
import Test.CommandLine.Run
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  it "census: one line for each entry, and the paper's array is proved by both methods" $
    inFolder $ \folder -> do
      (status, out, err) <- pra (census folder "c.csv" ++ ["--json"])
      -- 32 polynomials, 6 shapes, 2 windows; with 3 rows or 3 columns the powers of alpha down or
      -- across lie in GF(4), so that two cells tell no more than one.
      (status, key ["entries"] out, key ["proved"] out, err)
        `shouldBe` (0, Just (Number 384), Just (Number 256), "")
      whole <- lines <$> readFile (folder </> "c.csv")
      length whole `shouldBe` 385
      -- The check at the end is that of the rest, by a definition of its own in
      -- "Test.Code.Certificate.IssuedAndChecked".
      let found =
            [ take 16 (drop 1 line)
              | line <- map fields (drop 1 whole),
                take 2 (drop 7 line) `elem` [["15x17", "2x2"], ["15x17", "2x3"]],
                drop 5 (take 6 line) == ["3 2 1 0 1"]
            ]
      found
        `shouldBe` [ words' "4;384;4;1 1 1;3 2 1 0 1;diagonal;15x17;2x2;yes;yes;yes;4;4;255;255;1",
                     words' "5;384;4;1 1 1;3 2 1 0 1;diagonal;15x17;2x3;yes;yes;yes;4;4;255;255;2"
                   ]
  it "census: cut off anywhere, it is continued to the same bytes; complete, it stays as it is" $
    inFolder $ \folder -> do
      _ <- pra (census folder "whole.csv")
      whole <- readFile (folder </> "whole.csv")
      let file = folder </> "cut.csv"
          ends = length whole : [0, 1, 100, 137, 138, 139, 1000, length whole - 1]
      forM_ ends $ \end -> do
        writeFile file (take end whole)
        (status, _, _) <- pra (census folder "cut.csv")
        again <- readFile file
        (end, status, again == whole) `shouldBe` (end, 0, True)
  it "census, merge: a row changed from yes,yes,yes to no,yes,yes is refused" $
    inFolder $ \folder -> do
      _ <- pra (small folder "c.csv")
      whole <- readFile (folder </> "c.csv")
      let changed = unlines (onLine 3 (firstReplaced "yes,yes,yes" "no,yes,yes") (lines whole))
          file = folder </> "new.csv"
      writeFile file changed
      changed `shouldNotBe` whole
      complains ["merge", file] "line 3 is damaged: its check does not fit"
      complains (small folder "new.csv") "line 3"
      readFile file `shouldReturn` changed
  it "census --keep-whole: damaged lines are made again" $
    inFolder $ \folder -> do
      _ <- pra (small folder "c.csv")
      whole <- readFile (folder </> "c.csv")
      let file = folder </> "d.csv"
          ls = lines whole
          damaged =
            [ unlines (onLine 3 (firstReplaced "yes,yes,yes" "no,yes,yes") ls),
              unlines (take 4 ls ++ drop 5 ls),
              unlines (take 4 ls ++ drop 3 ls),
              unlines (take 3 ls ++ reverse (drop 3 ls)),
              take (length whole - 40) whole ++ "Z",
              unlines (take 4 ls ++ ["x"] ++ take 2 (drop 4 ls))
            ]
      forM_ damaged $ \text -> do
        writeFile file text
        (status, _, err) <- pra (small folder "d.csv")
        (status, length (lines err)) `shouldBe` (2, 1)
        readFile file `shouldReturn` text
        (kept, _, _) <- pra (small folder "d.csv" ++ ["--keep-whole"])
        again <- readFile file
        (kept, again) `shouldBe` (0, whole)
      writeFile (folder </> "mine") "precious\n"
      complains (small folder "mine" ++ ["--keep-whole"]) "first line"
      writeFile (folder </> "other.csv") whole
      complains
        (words "census --q 2 --degree 4 --output" ++ [folder </> "other.csv", "--keep-whole"])
        "not an unfinished file"
      readFile (folder </> "other.csv") `shouldReturn` whole
  it "census --keep-whole: a census with a damaged first line is known by the rows' checks" $
    inFolder $ \folder -> do
      _ <- pra (small folder "c.csv")
      whole <- readFile (folder </> "c.csv")
      writeFile (folder </> "d.csv") ('C' : drop 1 whole)
      complains (small folder "d.csv") "first line"
      (status, _, _) <- pra (small folder "d.csv" ++ ["--keep-whole"])
      again <- readFile (folder </> "d.csv")
      (status, again) `shouldBe` (0, whole)
  it "merge --keep-whole: whole rows are taken, and missing ones are named" $
    inFolder $ \folder -> do
      let file name = folder </> name
      forM_ [1, 2 :: Int] $ \i ->
        pra (small folder ("part" ++ show i) ++ ["--shard", show i ++ "/2"])
      whole <- pra (small folder "c.csv") >> readFile (file "c.csv")
      part <- readFile (file "part1")
      writeFile (file "bad") (unlines (onLine 3 (firstReplaced "yes" "no") (lines part)))
      complains ["merge", "--keep-whole", file "bad", file "part2"] "entries are missing: 2;"
      writeFile (file "bad") (unlines (lines part ++ ["garbage"]))
      complains ["merge", file "bad", file "part2"] "is damaged: it has 1 fields, not 18"
      (status, out, err) <- pra ["merge", "--keep-whole", file "bad", file "part2"]
      (status, out, length (lines err)) `shouldBe` (0, whole, 1)
  it "merge: an output that is one of the shards is refused, under any spelling" $
    inFolder $ \folder -> do
      let file name = folder </> name
      _ <- pra (small folder "c.csv")
      whole <- readFile (file "c.csv")
      createFileLink (file "c.csv") (file "soft.csv")
      createLink (file "c.csv") (file "hard.csv")
      forM_
        [file "c.csv", folder </> "." </> "c.csv", file "soft.csv", file "hard.csv"]
        $ \output -> do
          complains ["merge", file "c.csv", "--output", output] "is the shard"
          complains ["merge", file "soft.csv", "--output", output] "is the shard"
          readFile (file "c.csv") `shouldReturn` whole
  it "census: another census's file, or any other file, is refused and not touched" $
    inFolder $ \folder -> do
      _ <- pra (census folder "whole.csv")
      whole <- readFile (folder </> "whole.csv")
      let file = folder </> "other"
      forM_
        ["precious\n", whole ++ "1\n", unlines (swapped (lines whole)), take 300 whole ++ "\nx\n"]
        $ \content -> do
          writeFile file content
          (status, _, err) <- pra (census folder "other")
          (status, length (lines err)) `shouldBe` (2, 1)
          readFile file `shouldReturn` content
      writeFile file whole
      complains (words "census --q 4 --degree 3 --output" ++ [file]) "not an unfinished file"
      complains (census folder "other" ++ ["--shard", "1/2"]) "not an unfinished file"
  it "merge: shards in any order give the bytes of one run" $
    inFolder $ \folder -> do
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
  it "merge: incomplete, overlapping, unfinished and foreign shards are refused" $
    inFolder $ \folder -> do
      let file name = folder </> name
      forM_ [1, 2, 3 :: Int] $ \i ->
        pra (census folder ("part" ++ show i) ++ ["--shard", show i ++ "/3"])
      complains ["merge", file "part1", file "part3"] "128 of 384 entries are missing"
      complains ["merge", file "part1", file "part2", file "part3", file "part2"] "entry 1 is in"
      _ <- pra (words "census --q 2 --degree 4 --output" ++ [file "other"])
      complains ["merge", file "part1", file "other"] "different censuses"
      part <- readFile (file "part1")
      writeFile (file "cut") (take (length part - 3) part)
      complains ["merge", file "cut", file "part2", file "part3"] "cut off"
      complains ["merge", file "none"] "none"
      complains ["merge", "data/shapes.txt"] "first line"
      complains
        ["merge", file "part1", file "part2", file "part3", "--output", file "no/such"]
        "folder does not exist"
  it "census: an impossible scope is status 2 with the reason" $
    inFolder $ \folder -> do
      complains
        (words "census --q 6 --degree 2 --output" ++ [folder </> "x"])
        "6 is not a prime power"
      complains (words "census --q 4 --degree 0 --output" ++ [folder </> "x"]) "degree 0"
      complains
        (words "census --q 4 --modulus 1,0,1 --degree 2 --output" ++ [folder </> "x"])
        "factors"
      complains
        (words "census --q 2 --degree 3 --output" ++ [folder </> "no" </> "x"])
        "cannot write"
      complains
        (words "census --q 2 --degree 1000000 --output" ++ [folder </> "x"])
        "2^1000000 - 1"
      complains
        (words "census --q 4 --degree 100 --output" ++ [folder </> "x"])
        "524288 divisors"
      doesPathExist (folder </> "x") `shouldReturn` False
      forM_ (words "0/2 3/2 1 a/b") $ \shard -> do
        (status, out, _) <- pra (census folder "x" ++ ["--shard", shard])
        (status, out) `shouldBe` (2, "")
  where
    small folder name = words "census --q 2 --degree 3 --output" ++ [folder </> name]
    census folder name =
      words "census --q 4 --degree 4 --folding diagonal --window 2x2 --window 2x3 --output"
        ++ [folder </> name]
    fields line = words' (map (\c -> if c == ',' then ';' else c) line)
    words' text = case break (== ';') text of
      (field, _ : rest) -> field : words' rest
      (field, []) -> [field]
    swapped ls = take 1 ls ++ reverse (drop 1 ls)
