{-# LANGUAGE RankNTypes #-}
{-# OPTIONS_GHC -O1 #-}

-- | The fast forms of sequences, each against its definition.
module Test.Code.Sequence.FastFormsAsDefined (spec) where

import Control.Monad (forM_)
import Control.Monad.ST (ST)
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Sequence.Jump
import PraTactile.Sequence.Recurrence
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  describe "a vector filled by a recurrence" $ do
    it "in blocks equals the one filled term by term, over every field" $
      withMaxSuccess 4 (forEveryField (`filledAlike` 0))
    it "in blocks equals the one filled term by term, at any offset in memory" $
      forAll (choose (1, 17)) $ \offset ->
        conjoin
          [ filledAlike gf2 offset,
            filledAlike (Proxy :: Proxy GF8) offset,
            filledAlike (Proxy :: Proxy GF9) offset
          ]
    it "with an m-sequence is the sequence, up to 40000 terms, over six fields" $
      forM_ [(2, 17), (3, 10), (4, 9), (9, 5), (251, 2), (256, 2)] $ \(q, n) ->
        overField q $ \k -> do
          h <- firstOver k n
          forM_ [h, reciprocal h] $ \g -> forM_ [-1, 0, 1, 40000] $ \count ->
            ( q,
              count,
              Primitive.toList (sequenceVector g (canonicalState g) count)
                == take count (mSequence g (canonicalState g))
            )
              `shouldBe` (q, count, True)
    it "is unchanged if the recurrence would read outside it, and continued otherwise" $
      forM_ [(from, to) | from <- [-1 .. 11], to <- [-1 .. 11]] $ \(from, to) -> do
        -- v(i) = v(i-1) + v(i-3).
        let r = recurrenceOf [1, 0, 1 :: GF GF2]
            start = [1, 1, 0, 0, 1, 1, 0, 1, 1, 1]
            goneOn v i
              | i < to =
                goneOn (take i v ++ [v !! (i - 1) + v !! (i - 3)] ++ drop (i + 1) v) (i + 1)
              | otherwise = v
            expected = if from >= 3 && to <= 10 then goneOn start from else start
            come way = Primitive.toList (runWay way r from to start)
        (from, to, map come [Way stepwise, Way blockwise, Way continue])
          `shouldBe` (from, to, replicate 3 expected)
  describe "a jump" $ do
    it "to s(t) combines the initial state by the coefficients of x^t, over every field" $
      forM_ everyField $ \(q, SomeField k) -> forM_ (if q > 16 then [1, 2] else [1 .. 5]) $ \n -> do
        h <- firstOver k n
        let state = take (primitiveDegree h) (cycle (drop (q `div` 3) elements))
        ( q,
          n,
          [ t
            | t <- [0 .. 40] ++ map (10 ^) [3 .. 24 :: Int],
              jump h state t /= byDefinition h state t
          ]
          )
          `shouldBe` (q, n, [])
    it "in packed words equals the general one: GF(2), degrees to 20, near 32 and 64" $
      forM_ ([1 .. 20] ++ [31 .. 33] ++ [61 .. 66]) $ \n -> do
        h <- right (firstPrimitive n :: Either PolynomialError (Primitive GF2))
        let state = stateElements (canonicalState h)
            ts =
              [0 .. 40]
                ++ map (period h +) [0 .. 10]
                ++ take 20 (iterate (\t -> t * 6364136223846793005 + 1442695040888963407) n)
        (n, [t | t <- ts, jump h state t /= generalJump h state t]) `shouldBe` (n, [])
        (n, [t | t <- take 3 (reverse ts), jump h state t /= byDefinition h state t])
          `shouldBe` (n, [])
    it "to the 10^18th term and beyond obeys the recurrence there" $
      forM_ [(2, 64), (3, 40), (4, 31), (5, 27), (9, 20)] $ \(q, n) ->
        overField q $ \k -> do
          h <- firstOver k n
          forM_ [10 ^ (18 :: Int), 10 ^ (18 :: Int) + 12345678987654321, 10 ^ (30 :: Int)] $ \t ->
            sum
              ( zipWith
                  (*)
                  (coefficients (primitivePolynomial h))
                  (map (termAt h (canonicalState h)) [t ..])
              )
              `shouldBe` 0

-- | For every field of at most 256 elements.
forEveryField :: Testable prop => (forall k. KnownField k => Proxy k -> prop) -> Property
forEveryField check =
  conjoin [counterexample ("q = " ++ show q) (check k) | (q, SomeField k) <- everyField]

-- | A way to continue a vector by a recurrence.
newtype Way k = Way (forall s. Recurrence k -> Int -> Int -> Mutable.MVector s (GF k) -> ST s ())

-- | The vector of these elements, changed.
runWay :: Way k -> Recurrence k -> Int -> Int -> [GF k] -> Primitive.Vector (GF k)
runWay (Way way) r from to start = Primitive.modify (way r from to) (Primitive.fromList start)

-- | A recurrence with a few or with many lags, its power, and a vector that it continues, which
-- begins at an offset in memory.
filledAlike :: KnownField k => Proxy k -> Int -> Property
filledAlike (k :: Proxy k) offset =
  forAll (choose (1, 9)) $ \n ->
    forAll (genElements n) $ \lower ->
      forAll (choose (0, if fieldCharacteristic k < 8 then 4 else 1)) $ \e ->
        let r = frobenius e (recurrenceOf (lower :: [GF k]))
            from = longestLag r
         in forAll (genElements (offset + from)) $ \start ->
              forAll (choose (0, 9000)) $ \more ->
                let filled (Way way) =
                      runWay
                        (Way (\_ _ _ v -> way r from (from + more) (Mutable.drop offset v)))
                        r
                        0
                        0
                        (start ++ replicate more one)
                 in filled (Way stepwise) == filled (Way blockwise)
                      && filled (Way stepwise) == filled (Way continue)

-- | r0 s(0) + ... + r(n-1) s(n-1), where x^t = r0 + ... + r(n-1) x^(n-1) modulo h.
byDefinition :: KnownField k => Primitive k -> [GF k] -> Natural -> GF k
byDefinition h state t = sum (zipWith (*) residue state)
  where
    residue = maybe [] coefficients (powerModulo (primitivePolynomial h) variable t)
