-- | The census of all arrays of a size.
module Test.Code.Census.AllArraysOfASize (spec) where

import Control.Monad (forM_)
import Data.List (nub, sort, sortOn)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Census
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Polynomial
import PraTactile.Window
import PraTactile.Window.Distance
import PraTactile.Window.Proof
import Test.Code.Generators
import Test.Hspec

spec :: Spec
spec = do
  it "has every primitive polynomial, shape and window once, numbered from 0" $
    forM_ [(2, 4), (3, 2), (4, 2), (5, 2), (9, 1), (2, 6)] $ \(q, n) -> do
      scope <- right (standardScope q n)
      entries <- right (census (const True) scope)
      size <- right (censusSize scope)
      map entryNumber entries `shouldBe` takeWhile (< size) [0 ..]
      let keys = [(entryPolynomial e, entryFolding e, entryShape e, entryWindow e) | e <- entries]
      length (nub (sort keys)) `shouldBe` length keys
  it "of quartics over GF(4) has 32 polynomials, coprime sides, and all shapes row by row" $ do
    scope <- right (standardScope 4 4)
    entries <- right (census (const True) scope)
    quartics <- right (primitivePolynomials 4 :: Either PolynomialError [Primitive GF4])
    nub (map entryPolynomial entries)
      `shouldBe` map (map (fromIntegral . toCode) . coefficients . primitivePolynomial) quartics
    let shapes folding = nub [rows (entryShape e) | e <- entries, entryFolding e == folding]
        divisorsOf255 = [d | d <- [1 .. 255], 255 `mod` d == 0]
    shapes Diagonal `shouldBe` [d | d <- divisorsOf255, gcd d (255 `div` d) == 1]
    shapes RowMajor `shouldBe` divisorsOf255
  it "has the paper's array, with distance 1 for 2 x 2 and 2 for 2 x 3 and 3 x 2 windows" $ do
    scope <- right (standardScope 4 4)
    entries <-
      right
        ( census
            (const True)
            scope
              { scopeFoldings = [Diagonal],
                scopeWindows = [Shape 2 2, Shape 2 3, Shape 3 2]
              }
        )
    let found window =
          [ (fmap proved (entryVerdict e), fmap distance (entryDistance e))
            | e <- entries,
              entryShape e == Shape 15 17,
              entryWindow e == window
          ]
    found (Shape 2 2) `shouldBe` replicate 32 (Right True, Right 1)
    take 1 (found (Shape 2 3)) `shouldBe` [(Right True, Right 2)]
    take 1 (found (Shape 3 2)) `shouldBe` [(Right True, Right 2)]
  it "finds windows distinct exactly if the distance is not 0, and both methods agree" $
    forM_ [(2, 6), (3, 4), (4, 3), (5, 2), (8, 2)] $ \(q, n) -> do
      scope <- right (standardScope q n)
      entries <- right (census (const True) scope)
      forM_ entries $ \e -> do
        verdict <- right (entryVerdict e)
        found <- right (entryDistance e)
        (enumeration verdict, rankDecision verdict)
          `shouldBe` (Just (distance found > 0), Just (distance found > 0))
        proved verdict `shouldBe` (distance found > 0)
  it "in parts equals the whole" $ do
    scope <- right (standardScope 3 2)
    whole <- right (census (const True) scope)
    parts <- mapM (\i -> right (census (\number -> number `mod` 3 == i) scope)) [0, 1, 2 :: Natural]
    sortOn entryNumber (concat parts) `shouldBe` whole
  it "decides by rank alone if an array is too large to visit" $ do
    scope <- right (standardScope 2 40)
    entries <- right (census (< 1) scope {scopeFoldings = [RowMajor], scopeWindows = [Shape 1 40]})
    let seen =
          [ (fmap proved (entryVerdict e), fmap enumeration (entryVerdict e), entryDistance e)
            | e <- take 1 entries
          ]
    seen `shouldBe` [(Right True, Right Nothing, Right (Distance 1 [Position 0 0]))]
  it "refuses impossible alphabets, moduli, degrees and windows" $ do
    standardScope 6 2 `shouldBe` Left (CensusField (NotAPrimePower 6))
    scope <- right (standardScope 4 2)
    censusSize scope {scopeModulus = [1, 1]} `shouldBe` Left (CensusModulus 1 2)
    censusSize scope {scopeModulus = [1, 0, 1]}
      `shouldBe` Left (CensusField (ModulusReducible 2 [1, 0, 1]))
    censusSize scope {scopeDegree = 0} `shouldBe` Left (CensusPolynomial PolynomialConstant)
    (() <$ census (const True) scope {scopeWindows = [Shape 0 2]})
      `shouldBe` Left (CensusWindow WindowEmpty)
  it "tries all divisors of q^n - 1 up to 2^16 of them, and refuses more" $ do
    -- The numbers of divisors were counted from what GNU factor says of 173^18 - 1 and 2^120 - 1.
    most <- right (standardScope 173 18)
    let shapes folding =
          length <$> scopePlaces most {scopeFoldings = [folding], scopeWindows = [Shape 1 1]}
    shapes RowMajor `shouldBe` Right (2 ^ (16 :: Int))
    -- One of two coprime sides has a prime or the other one, and there are 14.
    shapes Diagonal `shouldBe` Right (2 ^ (14 :: Int))
    more <- right (standardScope 2 120)
    scopePlaces more `shouldBe` Left (CensusTooManyShapes 73728 65536)
  it "describes different scopes by different texts" $ do
    scope <- right (standardScope 4 4)
    let others =
          [ scope,
            scope {scopeOrder = 2},
            scope {scopeModulus = [1, 1]},
            scope {scopeDegree = 3},
            scope {scopeFoldings = [Diagonal]},
            scope {scopeFoldings = [RowMajor]},
            scope {scopeWindows = [Shape 2 2]}
          ]
    length (nub (map scopeText others)) `shouldBe` length others
    countPrimitive gf4 4 `shouldBe` Right 32
