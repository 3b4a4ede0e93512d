{-# LANGUAGE RankNTypes #-}

-- | m-sequences.
module Test.Code.Sequence.MSequences (spec) where

import Control.Monad (forM_)
import Data.List (tails)
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import qualified Data.Set as Set
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Polynomial
import PraTactile.Sequence
import Test.Code.Generators
import Test.Hspec
import Test.Paper

-- | Fields and degrees with periods small enough to walk.
sizes :: [(Int, Natural)]
sizes =
  [(2, n) | n <- [1 .. 10]]
    ++ [(3, n) | n <- [1 .. 5]]
    ++ [(4, n) | n <- [1 .. 4]]
    ++ [(5, n) | n <- [1 .. 3]]
    ++ [(7, 2), (8, 2), (9, 1), (9, 2), (16, 2), (25, 2), (27, 2), (256, 1), (251, 1)]

-- | For the first few primitive polynomials of each size.
forSequences ::
  (forall k. KnownField k => Proxy k -> Primitive k -> [GF k] -> Expectation) ->
  Expectation
forSequences check =
  forM_ sizes $ \(q, n) -> overField q $ \k -> do
    found <- right (primitivePolynomials n)
    forM_ (take 3 found) $ \h -> check k h (mSequence h (canonicalState h))

spec :: Spec
spec = do
  it "s(i+n) = - (c0 s(i) + ... + c(n-1) s(i+n-1)), with its minus" $
    forSequences $ \_ h s -> do
      let n = primitiveDegree h
          obeys window = sum (zipWith (*) (coefficients (primitivePolynomial h)) window) == 0
      all (obeys . take (n + 1)) (take (2 * int (period h)) (tails s)) `shouldBe` True
      take n s `shouldBe` replicate (n - 1) 0 ++ [1]
  it "over GF(3), x^2 + x + 2 gives 0 1 2 2 0 2 1 1" $ do
    -- By hand: s(i+2) = - (2 s(i) + s(i+1)) = s(i) + 2 s(i+1).
    h <- right (polynomialFromCodes [2, 1, 1])
    p <- right (checkPrimitive (h :: Polynomial GF3))
    map toCode (take 9 (mSequence p (canonicalState p))) `shouldBe` [0, 1, 2, 2, 0, 2, 1, 1, 0]
  it "the period is q^n - 1 and no divisor of it" $
    forSequences $ \_ h s -> do
      let terms = int (period h)
          repeatsAfter d =
            take (terms + primitiveDegree h) s == take (terms + primitiveDegree h) (drop d s)
      [d | d <- [1 .. terms], terms `mod` d == 0, repeatsAfter d] `shouldBe` [terms]
  it "every non-zero n-tuple occurs once a period" $
    forSequences $ \k h s -> do
      let tuples = [map toCode (take (primitiveDegree h) t) | t <- take (int (period h)) (tails s)]
      Set.size (Set.fromList tuples) `shouldBe` fieldOrder k ^ primitiveDegree h - 1
      filter (all (== 0)) tuples `shouldBe` []
  it "a period has q^(n-1) of each symbol, and one 0 less" $
    forSequences $ \k h s -> do
      let counts = Map.fromListWith (+) [(toCode a, 1 :: Int) | a <- take (int (period h)) s]
          each = fieldOrder k ^ (primitiveDegree h - 1)
      [Map.findWithDefault 0 (toCode a) counts | a <- elementsOf k]
        `shouldBe` [if a == 0 then each - 1 else each | a <- elementsOf k]
  it "the vector form is the list form" $
    forSequences $ \_ h s ->
      forM_ [-1, 0, 1, primitiveDegree h, 300] $ \count ->
        Primitive.toList (sequenceVector h (canonicalState h) count) `shouldBe` take count s
  it "termAt jumps to the term that walking reaches" $
    forSequences $ \_ h s ->
      and (zipWith (\t a -> termAt h (canonicalState h) t == a) [0 .. 200] s) `shouldBe` True
  it "termAt is periodic, for exponents of any size" $ do
    h <- firstOver gf4 20
    let term = termAt h (canonicalState h)
    map (\t -> term (t + period h * 10 ^ (20 :: Int))) [0 .. 99]
      `shouldBe` take 100 (mSequence h (canonicalState h))
    -- and the recurrence holds in the middle of nowhere
    let t0 = 4 ^ (19 :: Int) + 12345
    sum (zipWith (*) (coefficients (primitivePolynomial h)) (map term [t0 ..])) `shouldBe` 0
  it "any initial state gives a shift of the same sequence" $ do
    h <- paperPrimitive
    let canonical = take 255 (mSequence h (canonicalState h))
        shifts = Set.fromList [map toCode (take 255 t) | t <- take 255 (tails (cycle canonical))]
        states = [s | s <- mapM (const elements) [1 .. 4 :: Int], any (/= 0) s]
    forM_ states $ \s -> do
      state <- right (initialState h s)
      stateElements state `shouldBe` s
      Set.member (map toCode (take 255 (mSequence h state))) shifts `shouldBe` True
  it "a state has n elements, and they are not all zero" $ do
    h <- paperPrimitive
    initialState h [0, 0, 0, 0] `shouldBe` Left StateZero
    initialState h [0, 0, 1] `shouldBe` Left (StateLength 3 4)
    initialState h [0, 0, 0, 1, 1] `shouldBe` Left (StateLength 5 4)
    initialState h (repeat 1) `shouldBe` Left (StateLength 5 4)
  it "the sum of two shifts is a shift, or zero: shift and add" $ do
    h <- paperPrimitive
    let s = Primitive.toList (sequenceVector h (canonicalState h) 255)
        shift i = take 255 (drop i (cycle s))
        shifts = Set.fromList [map toCode (shift i) | i <- [0 .. 254]]
    forM_ [1 .. 254] $ \i ->
      Set.member (map toCode (zipWith (+) s (shift i))) shifts `shouldBe` True
  where
    int = fromIntegral :: Natural -> Int
    elementsOf :: KnownField k => Proxy k -> [GF k]
    elementsOf _ = elements
