-- | Factors and primes of integers.
module Test.Code.Factorisation.FactorsAndPrimes (spec) where

import Control.Monad (forM_)
import Data.List (tails)
import Numeric.Natural (Natural)
import PraTactile.Factorisation
import PraTactile.Factorisation.Divisor (squareRoot)
import PraTactile.Factorisation.Prime (pocklington)
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  describe "isPrime" $ do
    it "agrees with trial division up to 20000" $
      [n | n <- [0 .. 20000], isPrime n /= Right (byTrial n)] `shouldBe` []
    it "is not deceived by the least strong pseudoprimes to the first 1 ... 13 prime bases" $
      -- OEIS A014233.
      forM_ strongPseudoprimes $ \n -> (n, isPrime n) `shouldBe` (n, Right False)
    it "proves the Mersenne primes of exponent 61, 89, 107 and 127" $
      forM_ [61, 89, 107, 127 :: Int] $ \e -> (e, isPrime (2 ^ e - 1)) `shouldBe` (e, Right True)
    it "finds the Mersenne numbers of exponent 67, 83, 97 and 101 composite" $
      forM_ [67, 83, 97, 101 :: Int] $ \e -> (e, isPrime (2 ^ e - 1)) `shouldBe` (e, Right False)
  describe "pocklington" $ do
    it "is true of no composite number, and of every prime, from 3 to 3000" $
      [n | n <- [3 .. 3000], pocklington n /= byTrial n] `shouldBe` []
    it "is true of no product of two primes that are 1 modulo the same large F" $
      [ n
        | (a, b) <- pairs [k | k <- [2, 4 .. 600], byTrial (k * f + 1)],
          let n = (a * f + 1) * (b * f + 1),
          pocklington n
      ]
        `shouldBe` []
  describe "squareRoot" $
    it "is the largest number whose square is no larger, near squares of any size" $
      forAll (choose (0, 600 :: Int)) $ \width ->
        forAll (fromInteger . (2 ^ width +) <$> choose (0, 2 ^ width - 1)) $ \r ->
          map squareRoot [r * r - 1, r * r, r * r + 2 * r, r * r + 2 * r + 1]
            === [r - 1, r, r, r + 1]
  describe "factorise" $ do
    it "agrees with trial division up to 5000" $
      [n | n <- [1 .. 5000], factorise n /= Right (factorsByTrial n)] `shouldBe` []
    it "refuses 0 and gives no primes for 1" $ do
      factorise 0 `shouldBe` Left FactorisationOfZero
      factorise 1 `shouldBe` Right []
    it "splits 2^64 - 1 and 4^30 - 1" $ do
      factorise (2 ^ (64 :: Int) - 1)
        `shouldBe` Right [(p, 1) | p <- [3, 5, 17, 257, 641, 65537, 6700417]]
      factorise (4 ^ (30 :: Int) - 1)
        `shouldBe` Right
          ([(3, 2), (5, 2)] ++ [(p, 1) | p <- [7, 11, 13, 31, 41, 61, 151, 331, 1321]])
    it "splits the product of two primes of 31 bits, also when they are equal" $ do
      factorise (2147483647 * 2147483629) `shouldBe` Right [(2147483629, 1), (2147483647, 1)]
      factorise (2147483647 ^ (2 :: Int)) `shouldBe` Right [(2147483647, 2)]
    it "splits products of two primes of 12 digits" $
      -- Primes by the test of Miller and Rabin to the first 12 prime bases, which decides below
      -- 3.3e24.
      forM_ [(100000000003, 200000000041), (300000000077, 400000000019)] $ \(p, q) ->
        factorise (p * q) `shouldBe` Right [(p, 1), (q, 1)]
    it "the product of the prime powers is the number, and the primes ascend and are prime" $
      property $
        forAll (choose (1, 10 ^ (15 :: Int) :: Integer)) $ \m ->
          let n = fromInteger m :: Natural
           in case factorise n of
                Left e -> counterexample (show e) False
                Right factors ->
                  counterexample (show factors) $
                    product [p ^ e | (p, e) <- factors] == n
                      && all ((== Right True) . isPrime . fst) factors
                      && all ((> 0) . snd) factors
                      && and (zipWith (<) (map fst factors) (drop 1 (map fst factors)))
  describe "factorisePowerMinusOne" $ do
    it "is the factorisation of b^n - 1" $
      [(b, n) | b <- [2 .. 9], n <- [1 .. 12], factorisePowerMinusOne b n /= factorise (b ^ n - 1)]
        `shouldBe` []
    it "is so for a large base, and for the largest exponent" $ do
      forM_ [1025, 10 ^ (9 :: Int) + 7, 2 ^ (64 :: Int)] $ \b ->
        factorisePowerMinusOne b 2 `shouldBe` factorise (b * b - 1)
      factorisePowerMinusOne 2 1025 `shouldBe` Left (PowerTooLarge 2 1025)
      factorisePowerMinusOne (2 ^ (512 :: Int) + 1) 2
        `shouldBe` Left (PowerTooLarge (2 ^ (512 :: Int) + 1) 2)
    it "refuses b^n - 1 = 0" $ do
      factorisePowerMinusOne 1 5 `shouldBe` Left FactorisationOfZero
      factorisePowerMinusOne 7 0 `shouldBe` Left FactorisationOfZero
    it "reaches 4^64 - 1, which is 2^128 - 1, and 3^20 - 1" $ do
      factorisePowerMinusOne 4 64 `shouldBe` factorisePowerMinusOne 2 128
      factorisePowerMinusOne 3 20 `shouldBe` Right [(2, 4), (5, 2), (11, 2), (61, 1), (1181, 1)]
    it "proves each prime that it finds, and their product, for 2^1 - 1 ... 2^120 - 1" $
      forM_ [1 .. 120] $ \n -> case factorisePowerMinusOne 2 n of
        Left e -> expectationFailure (show (n, e))
        Right factors -> do
          (n, product [p ^ e | (p, e) <- factors]) `shouldBe` (n, 2 ^ n - 1)
          [p | (p, _) <- factors, isPrime p /= Right True] `shouldBe` []
    it "splits into cyclotomic values, whose product over the divisors of d is b^d - 1" $
      [ (b, n, d)
        | b <-
            [2 .. 7],
          n <- [1 .. 30],
          d <- [1 .. n],
          n `mod` d == 0,
          product [v | (e, v) <- cyclotomicValues b n, d `mod` e == 0] /= b ^ d - 1
      ]
        `shouldBe` []
    it "reaches 2^128 - 1 by its algebraic factors" $
      fmap (map fst) (factorisePowerMinusOne 2 128)
        `shouldBe` Right [3, 5, 17, 257, 641, 65537, 274177, 6700417, 67280421310721]
  describe "totient" $
    it "counts the units, for all n up to 300" $
      [ n
        | n <- [1 .. 300],
          fmap totient (factorise n)
            /= Right (fromIntegral (length (filter ((== 1) . gcd n) [1 .. n])))
      ]
        `shouldBe` []

byTrial :: Natural -> Bool
byTrial n = n > 1 && all (\d -> n `mod` d /= 0) (takeWhile (\d -> d * d <= n) [2 ..])

factorsByTrial :: Natural -> [(Natural, Natural)]
factorsByTrial n = [(p, exponent' p n) | p <- [2 .. n], n `mod` p == 0, byTrial p]
  where
    exponent' p m = if m `mod` p == 0 then 1 + exponent' p (m `div` p) else 0

-- | 2^20.
f :: Natural
f = 1048576

-- | The pairs of a list, each with its elements in their order.
pairs :: [a] -> [(a, a)]
pairs list = [(a, b) | a : rest <- tails list, b <- a : rest]

strongPseudoprimes :: [Natural]
strongPseudoprimes =
  [ 2047,
    1373653,
    25326001,
    3215031751,
    2152302898747,
    3474749660383,
    341550071728321,
    3825123056546413051,
    318665857834031151167461,
    3317044064679887385961981
  ]
