{-# LANGUAGE OverloadedStrings #-}

-- | Shapes as the command line takes them: shipped, by the field's order, or drawn in a file.
module Test.CommandLine.Shapes (spec) where

import Data.Aeson (Value (..))
import Data.Foldable (for_)
import Data.List (isInfixOf)
import System.FilePath ((</>))
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  for_
    [ ("shapes --q 6", "GF(6)"),
      ("shapes --q 11", "--shapes"),
      ("train --q 16 --output x", "--shapes"),
      ("shapes --q 257", "257"),
      ("register a.pgm b.pgm --step 8,0 --q 13", "--shapes"),
      ("stitch data/worked-example/frames --json --q 6", "GF(6)"),
      ( "probe --q 11 --polynomial 7,1,1 --shape 8x15 --window 1x2 --object sheet --seed 1 \
        \--output x",
        "--shapes"
      ),
      ("evaluate --q 11 --polynomial 7,1,1 --shape 8x15 --window 1x2 --presses 1", "--shapes"),
      ("decode data/worked-example/frames --shapes data/alphabets/gf5/shapes.txt", "has 5 shapes"),
      ("decode data/worked-example/frames --network data/alphabets/gf5/network.txt", "5"),
      ("shapes --check README.md", "line 1"),
      ("shapes --check data/network.txt", "line 1"),
      ("shapes --check no-such-file", "no-such-file"),
      ("shapes --design --shapes data/shapes.txt", "--design"),
      ("shapes --svg --json", "--json"),
      ("shapes --design --output no-such-folder/x", "no-such-folder")
    ]
    $ \(arguments, about) -> it arguments (words arguments `complains` about)
  it "drawings of more than 256 shapes, of other sizes, twice the same: one line" $
    inFolder $ \folder -> do
      let drawn name rows = unlines (("symbol " ++ name) : rows)
          -- As many as there are ways to emboss nine taxels.
          many =
            concat
              [ drawn (show i) (replicate 10 "........" ++ [bits (i `div` 256), bits (i `mod` 256)])
                | i <- [1 .. 257 :: Int]
              ]
          bits n = [if odd (n `div` 2 ^ k) then '#' else '.' | k <- [0 .. 7 :: Int]]
          full = replicate 12 "########"
      for_
        [ (["--check", "--shapes"], "many", many, "256"),
          (["--check", "--shapes"], "small", drawn "a" (drop 1 full), "12 rows"),
          (["--shapes"], "twice", drawn "a" full ++ drawn "b" full, "the same")
        ]
        $ \(options, name, text, about) -> do
          writeFile (folder </> name) text
          for_ options $ \option -> ["shapes", option, folder </> name] `complains` about
  it "what is wrong with drawings is an answer: exit status 1" $
    inFolder $ \folder -> do
      writeFile (folder </> "full") (unlines ("symbol a" : replicate 12 "########"))
      (status, out, err) <- pra ["shapes", "--check", folder </> "full"]
      (status, err) `shouldBe` (1, "")
      out `shouldSatisfy` ("fault: a: its area" `isInfixOf`)
      (good, _, _) <- pra ["shapes", "--check", "data/alphabets/gf9/shapes.txt"]
      good `shouldBe` 0
  it "over any shipped field: pressed, written, decoded; with the shapes in a file as without" $
    inFolder $ \folder -> for_ (byEffort [9] [3, 9 :: Int]) $ \q -> do
      -- The smaller region has four cells of the array.
      let profile = ["--profile", "data/profiles/gf" ++ show q ++ ".json"]
          own = ["--shapes", "data/alphabets/gf" ++ show q ++ "/shapes.txt"]
          frames = folder </> show q
          again = frames ++ "again"
          press at more =
            pra
              ( ["probe", "--object", "sheet", "--seed", "5", "--output", at]
                  ++ byEffort ["--at", "25.4,31.75", "--size", "32x40"] []
                  ++ profile
                  ++ more
              )
      (probed, _, _) <- press frames []
      (drawn, _, _) <- press again own
      (probed, drawn) `shouldBe` (0, 0)
      (status, out, _) <- pra (["decode", "--json", frames] ++ profile)
      (status, key ["outcome"] out, key ["object"] out)
        `shouldBe` (0, Just "located", Just (String "sheet"))
      (_, same, _) <- pra (["decode", "--json", again] ++ profile ++ own)
      let told line = map (`key` line) [["position"], ["doubt"]]
      told same `shouldBe` told out
  it "shapes that no shipped network knows are read by one that is named, or not at all" $
    inFolder $ \folder -> do
      let other = folder </> "shapes.txt"
          gf3 = "data/profiles/gf3.json"
          unread file =
            complains
              (words "decode data/worked-example/frames --profile" ++ [gf3, "--shapes", file])
              "--network"
          -- A symbol is its name and 12 rows, and an empty line parts two of them.
          three = unlines . take (14 + 14 + 13) . lines
      readFile "data/alphabets/gf5/shapes.txt" >>= writeFile other . three
      unread other
      whenFull $ do
        let designed = folder </> "designed.txt"
        (status, _, _) <-
          pra ["shapes", "--q", "3", "--design", "--seed", "1", "--output", designed]
        status `shouldBe` 0
        unread designed
