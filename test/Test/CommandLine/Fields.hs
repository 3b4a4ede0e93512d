{-# LANGUAGE OverloadedStrings #-}

-- | The commands field and polynomials, as scripts use them.
module Test.CommandLine.Fields (spec) where

import Data.Aeson
import Data.Foldable (for_)
import Data.List (isInfixOf, sort)
import Test.CommandLine.Run
import Test.Hspec

spec :: Spec
spec = do
  describe "field" $ do
    it "--json: GF(4) with A^2 = A + 1, by hand" $ do
      (status, out, err) <- pra (words "field --q 4 --json")
      (status, err) `shouldBe` (0, "")
      for_
        [ ("schema", "\"pra-tactile/field/1\""),
          ("q", "4"),
          ("modulus", "[1,1,1]"),
          ("primitive", "2"),
          ("add", "[[0,1,2,3],[1,0,3,2],[2,3,0,1],[3,2,1,0]]"),
          ("multiply", "[[0,0,0,0],[0,1,2,3],[0,2,3,1],[0,3,1,2]]"),
          ("negate", "[0,1,2,3]"),
          ("inverse", "[null,1,3,2]"),
          ("powers", "[1,2,3]"),
          ("log", "[null,0,1,2]")
        ]
        $ \(name, expected) -> (name, key [name] out) `shouldBe` (name, decode expected)
    it "--modulus: GF(9) with A^2 = -1, whose root is not primitive; 1 + A is" $ do
      (status, out, _) <- pra (words "field --q 9 --modulus 1,0,1 --json")
      status `shouldBe` 0
      (key ["modulus"] out, key ["primitive"] out) `shouldBe` (decode "[1,0,1]", Just (Number 4))
      -- (1 + A)^2 = 2 A, (1 + A)^4 = -1.
      key ["powers"] out `shouldBe` decode "[1,4,6,7,2,8,3,5]"
    it "for people: every element, and the tables of a small field" $ do
      (status, out, _) <- pra ["field", "--q", "4"]
      status `shouldBe` 0
      map words (lines out)
        `shouldContain` [words "3 A^2 3 2 3 1 1 x^2 + x + 1"]
      map words (lines out) `shouldContain` [words "3 0 3 1 2"]
    it "refuses what is no field, in one line" $ do
      complains ["field", "--q", "6"] "6 is not a prime power"
      complains ["field", "--q", "0"] "0 is not a prime power"
      complains ["field", "--q", "257"] "256"
      complains (words "field --q 9 --modulus 2,0,1") "factors over GF(3)"
      complains (words "field --q 9 --modulus 1,1") "degree 1"
      complains (words "field --q 4 --modulus 1,2,1") "not below p = 2"
      complains (words "field --q 4 --modulus 1,1,0") "not monic"
  describe "polynomials" $ do
    it "--primitive: the 32 quartics over GF(4), each accepted by --polynomial" $ do
      (status, out, err) <- pra (words "polynomials --q 4 --degree 4 --primitive")
      (status, err, take 1 (lines out), length (lines out)) `shouldBe` (0, "", ["3,2,1,0,1"], 32)
      (proved, _, _) <-
        pra ["prove", "--q", "4", "--polynomial", last (lines out), "--shape", "15x17"]
      proved `shouldBe` 0
    it "--count, --first, --fewest-terms: 60 irreducible quartics over GF(4), 32 primitive" $ do
      prints (words "polynomials --q 4 --degree 4 --count") ["32"]
      prints (words "polynomials --q 4 --degree 4 --irreducible --count") ["60"]
      prints (words "polynomials --q 4 --degree 4 --first") ["3,2,1,0,1"]
      prints (words "polynomials --q 2 --degree 4 --fewest-terms") ["1,1,0,0,1"]
      prints
        (words "polynomials --q 2 --degree 4 --irreducible")
        ["1,1,0,0,1", "1,0,0,1,1", "1,1,1,1,1"]
      prints
        (words "polynomials --q 3 --degree 1 --irreducible --fewest-terms")
        ["0,1"]
    it "--random: one of them, the same for the same seed" $ do
      (_, everything, _) <- pra (words "polynomials --q 3 --degree 4")
      drawn <-
        mapM
          ( \seed ->
              pra (words "polynomials --q 3 --degree 4 --random" ++ [show (seed :: Int)])
          )
          [1 .. 6]
      again <- pra (words "polynomials --q 3 --degree 4 --random 1")
      take 1 drawn `shouldBe` [again]
      for_ drawn $ \(status, out, _) ->
        (status, filter (`notElem` lines everything) (lines out), length (lines out))
          `shouldBe` (0, [], 1)
      length (filter (/= again) drawn) `shouldSatisfy` (> 0)
    it "--json: with the field and the degree; large counts as decimal strings" $ do
      (_, out, _) <- pra (words "polynomials --q 4 --degree 2 --irreducible --json")
      (key ["schema"] out, key ["kind"] out, key ["degree"] out, key ["modulus"] out)
        `shouldBe` ( Just "pra-tactile/polynomials/1",
                     Just "irreducible",
                     Just (Number 2),
                     decode "[1,1,1]"
                   )
      fmap (\found -> sort (found :: [[Int]])) (key ["polynomials"] out >>= fromValue)
        `shouldBe` Just (sort [[2, 1, 1], [3, 1, 1], [1, 2, 1], [2, 2, 1], [1, 3, 1], [3, 3, 1]])
      (_, counted, _) <- pra (words "polynomials --q 2 --degree 64 --count --json")
      -- phi(2^64 - 1)/64 = 2 4 16 256 640 65536 6700416 / 64
      key ["count"] counted `shouldBe` Just "143890337947975680"
    it "the degree 128 over GF(2) is within reach" $
      prints
        (words "polynomials --q 2 --degree 128 --first")
        ["1,1,1,0,0,0,0,1," ++ concat (replicate 120 "0,") ++ "1"]
    it "--modulus: the codes are those of the chosen field" $ do
      prints (words "polynomials --q 9 --modulus 1,0,1 --degree 1 --first") ["4,1"]
    it "refuses a degree of 0, one beyond all bounds, and what is no field" $ do
      complains (words "polynomials --q 2 --degree 0") "degree is 0"
      complains (words "polynomials --q 2 --degree 10001") "it must be 1 to 10000"
      (status, _, err) <- pra (words "polynomials --q 2 --degree 10000")
      (status, "2^10000 - 1" `isInfixOf` err) `shouldBe` (1, True)
      complains (words "polynomials --q 12 --degree 2") "12 is not a prime power"
  where
    fromValue v = case fromJSON v of Success a -> Just a; Error _ -> Nothing
