{-# LANGUAGE OverloadedStrings #-}

-- | The commands on sequences, foldings and the choice of arrays, as scripts use them.
module Test.CommandLine.Sequences (spec) where

import Data.Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (for_, toList)
import Data.List (isInfixOf)
import Test.CommandLine.Run
import Test.Hspec

spec :: Spec
spec = do
  describe "sequence" $ do
    it "prints codes: the paper's sequence from 0, from before it, and a period later" $ do
      let first = "0 0 0 1 0 1 2 2 0"
      prints ["sequence", "--length", "9"] [first]
      prints (words "sequence --from=-255 --length 9") [first]
      prints (words "sequence --from 255000000000000000000000 --length 9") [first]
      prints (words "sequence --q 4 --polynomial 3,2,1,0,1 --length 9") [first]
      prints
        (words "sequence --q 4 --polynomial 3,2,1,0,1 --state 3,1,0,2 --length 4")
        ["3 1 0 2"]
    it "--json: the terms from the 10^18th on, which is the 10^18 mod 255 = 100th" $ do
      (status, out, _) <-
        pra (words "sequence --json --from 1000000000000000000 --length 40")
      (_, early, _) <- pra (words "sequence --json --from 100 --length 40")
      status `shouldBe` 0
      key ["terms"] out `shouldBe` key ["terms"] early
      key ["from"] out `shouldBe` Just "1000000000000000000"
      (key ["schema"] out, key ["length"] out)
        `shouldBe` (Just "pra-tactile/sequence/1", Just (Number 40))
    it "of a register of 64 stages, far from its start" $ do
      (_, out, _) <-
        pra
          [ "sequence",
            "--q",
            "2",
            "--polynomial",
            lfsr64,
            "--from",
            "1000000000000000000",
            "--length",
            "200"
          ]
      (status, found, _) <- praWith (words "synthesise --q 2 --json") out
      (status, key ["length"] found, key ["primitive"] found)
        `shouldBe` (0, Just (Number 64), Just (Bool True))
    it "refuses a length that is no number, and a polynomial that is not primitive" $ do
      (status, _, err) <- pra ["sequence", "--length", "many"]
      (status, null err) `shouldBe` (2, False)
      complains (words "sequence --q 2 --polynomial 1,0,1") "not primitive"
  describe "synthesise" $ do
    it "finds the paper's polynomial from 8 symbols, as codes or powers, with any separators" $
      for_ ["0 0 0 1 0 1 2 2", "0,0,0,1,0,1,2,2\n", "0 0 0 1\n0 1 A A\n"] $ \symbols ->
        praWith ["synthesise", "--q", "4"] symbols
          `shouldReturn` ( 0,
                           unlines
                             [ "polynomial 3,2,1,0,1",
                               "length     4",
                               "determined yes",
                               "primitive  yes",
                               "state      0,0,0,1"
                             ],
                           ""
                         )
    it "--json, and what it prints chooses the sequence that it was given" $ do
      let symbols = "1 2 0 2 2 1 0 1 1 2"
      (status, out, _) <- praWith (words "synthesise --q 3 --json") symbols
      status `shouldBe` 0
      map
        (`key` out)
        [["polynomial"], ["length"], ["determined"], ["primitive"], ["symbols"], ["state"]]
        `shouldBe` map
          Just
          [toJSON [2, 2, 1 :: Int], Number 2, Bool True, Bool True, Number 10, toJSON [1, 2 :: Int]]
      prints
        (words "sequence --q 3 --polynomial 2,2,1 --state 1,2 --length 10")
        [symbols]
    it "says that too few symbols determine nothing, with status 1" $ do
      (status, out, _) <- praWith ["synthesise", "--q", "2"] "0 0 1 0 1"
      status `shouldBe` 1
      lines out `shouldContain` ["determined no: 6 symbols would determine it, and there are 5"]
    it "refuses an empty input, an invalid symbol and an invalid alphabet" $ do
      complainsWith "" ["synthesise", "--q", "4"] "no symbols"
      complainsWith "0 1 2 4" ["synthesise", "--q", "4"] "symbol 4"
      complainsWith "0 1" ["synthesise", "--q", "6"] "6 is not a prime power"
      complainsWith "0 1" (words "synthesise --q 4 --modulus 1,0,1") "factors"
      complainsWith "0 1" (words "synthesise --q 4 --modulus 1,1,0,1") "degree 2"
  describe "advise" $ do
    it "lists 63x65 and others for 30 rows and 40 columns over GF(4), the smallest first" $ do
      (status, out, _) <- pra (words "advise --rows 30 --columns 40 --q 4 --json")
      status `shouldBe` 0
      let options = maybe [] elementsOf (key ["possible"] out)
      map (at "shape") options `shouldContain` [Just (toJSON [63, 65 :: Int])]
      map (at "arrays") options `shouldSatisfy` all (== Just (Number 1))
    it "explains that 15x273 is not coprime, and offers what works instead" $ do
      (status, out, _) <-
        pra
          (words "advise --rows 15 --columns 273 --q 4 --window 2x3 --json")
      status `shouldBe` 0
      let refused =
            [ o
              | o <- maybe [] elementsOf (key ["impossible"] out),
                at "reason" o == Just "not-coprime"
            ]
          windows o = map (at "window") (maybe [] elementsOf (at "windows" o))
          instead = concatMap (maybe [] elementsOf . at "instead") refused
      map (at "shape") refused `shouldBe` [Just (toJSON [15, 273 :: Int])]
      map (at "divisor") refused `shouldBe` [Just (Number 3)]
      [(at "layout" o, at "arrays" o, at "shape" o, take 1 (windows o)) | o <- instead]
        `shouldBe` [ ( Just "diagonal",
                       Just (Number 1),
                       Just (toJSON [63, 65 :: Int]),
                       [Just (toJSON [3, 2 :: Int])]
                     ),
                     ( Just "row-major",
                       Just (Number 1),
                       Just (toJSON [15, 273 :: Int]),
                       [Just (toJSON [2, 3 :: Int])]
                     ),
                     ( Just "joint",
                       Just (Number 3),
                       Just (toJSON [15, 91 :: Int]),
                       [Just (toJSON [2, 3 :: Int])]
                     )
                   ]
    it "in words ends with a command that proves the first of them" $ do
      (_, out, _) <-
        pra (words "advise --rows 15 --columns 273 --q 4 --window 2x3")
      let proving =
            drop
              1
              (words (concat [drop 13 line | line <- lines out, take 13 line == "For example: "]))
      proving `shouldSatisfy` (not . null)
      (proved, _, _) <- pra proving
      proved `shouldBe` 0
    it "ends with status 1 where nothing is possible, and 2 where there is no alphabet" $ do
      (status, out, _) <-
        pra (words "advise --rows 100 --columns 100 --q 2 --window 3x4")
      (status, "14 are needed" `isInfixOf` out) `shouldBe` (1, True)
      complains (words "advise --rows 1 --columns 1 --q 6") "6 is not a prime power"
      complains
        (words "advise --rows 1 --columns 1 --q 4 --window 0x4")
        "no cells"
  describe "--folding" $ do
    it "row-major lays the sequence row by row, and its surface is the twisted torus" $ do
      (_, terms, _) <- pra ["sequence", "--length", "34"]
      (status, out, _) <- pra (words "array --folding row-major --format csv")
      status `shouldBe` 0
      concatMap (words . map (\c -> if c == ',' then ' ' else c)) (take 2 (lines out))
        `shouldBe` words terms
      (_, profile, _) <- pra ["profile", "--folding", "row-major"]
      (key ["folding"] profile, key ["surface"] profile)
        `shouldBe` (Just "row-major", Just "twisted-torus")
    it "prove: 15x273 with 2x3 windows on the twisted torus; plain wrapping collides" $ do
      let large =
            words "prove --json --q 4 --polynomial 2,1,1,0,0,0,1 --shape 15x273"
      (proved, out, _) <- pra (large ++ ["--folding", "row-major"])
      (proved, key ["surface"] out, key ["windows"] out)
        `shouldBe` (0, Just "twisted-torus", Just (Number 4095))
      (refuted, plain, _) <- pra (large ++ words "--folding row-major --surface torus")
      (refuted, key ["proved"] plain, key ["windows"] plain)
        `shouldBe` (1, Just (Bool False), Just (Number 4065))
      fmap (length . elementsOf) (key ["collision"] plain) `shouldBe` Just 2
      complains (filter (/= "--json") large) "divisible by 3"
    it "locate: the window at (6, 5) of the row-major array, across the seam too" $ do
      (_, out, _) <- pra (words "array --folding row-major --format csv")
      let cells = map (words . map (\c -> if c == ',' then ' ' else c)) (lines out)
          cell r c =
            unwords
              ( take
                  1
                  ( drop
                      ((c `mod` 17) :: Int)
                      (concat (take 1 (drop ((r + c `div` 17) `mod` 15) cells)))
                  )
              )
          look r c = unwords [cell r c, cell r (c + 1), "/", cell (r + 1) c, cell (r + 1) (c + 1)]
      locates ["locate", "--folding", "row-major", look 6 5] ["row 6, column 5"]
      locates ["locate", "--folding", "row-major", look 6 16] ["row 6, column 16"]
    it "refuses an unknown name, and a profile file beside it" $ do
      (status, _, err) <- pra ["array", "--folding", "spiral"]
      (status, "diagonal or row-major" `isInfixOf` err) `shouldBe` (2, True)
      complains (words "array --profile some.json --folding diagonal") "--folding"
  where
    lfsr64 = concatMap (\i -> if i `elem` [0, 1, 3, 4 :: Int] then "1," else "0,") [0 .. 63] ++ "1"
    elementsOf value = case value of Array items -> toList items; _ -> []
    at name value = case value of Object o -> KeyMap.lookup name o; _ -> Nothing
    complainsWith input arguments about = do
      (status, out, err) <- praWith arguments input
      (status, out, about `isInfixOf` err, length (lines err)) `shouldBe` (2, "", True, 1)
