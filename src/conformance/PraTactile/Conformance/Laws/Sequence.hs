-- | The sequence obeys its recurrence, and is a maximal-length one (MacWilliams and Sloane, 1976).
module PraTactile.Conformance.Laws.Sequence
  ( sequenceLaws,
  )
where

import Control.Monad (foldM, join, zipWithM)
import Data.List (tails)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array (naturalsBelow)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Profile (Profile (..), Reading (..))
import Test.QuickCheck

-- | The laws of the sequence.
sequenceLaws :: [Law Session]
sequenceLaws = recurrenceLaws ++ countingLaws ++ shiftLaws

-- | What the polynomial and the state say.
recurrenceLaws :: [Law Session]
recurrenceLaws =
  [ Law
      "s(0), ..., s(n-1) are the initial state"
      (\s -> equal (traverse (term s) [0 .. degree s - 1]) (pure (profileState (profile s)))),
    Law
      "c0 s(i) + c1 s(i+1) + ... + cn s(i+n) = 0, with c read backwards for a reciprocal polynomial"
      ( \s ->
          let obeyed i =
                equal
                  (traverse (\k -> term s (i + k)) [0 .. degree s] >>= combination s (recurrence s))
                  (pure 0)
           in if isShort s
                then
                  once
                    (conjoin [counterexample (show i) (obeyed i) | i <- naturalsBelow (period s)])
                else forTerms s obeyed
      ),
    Law "s(i + q^n - 1) = s(i)" (\s -> forTerms s (\i -> equal (term s (i + period s)) (term s i)))
  ]
  where
    -- The reciprocal's coefficients are those of the polynomial backwards, up to a factor that does
    -- not matter here.
    recurrence s = case profileReading (profile s) of
      Characteristic -> polynomialOf s
      Reciprocal -> reverse (polynomialOf s)
    combination s coefficients values = zipWithM (multiply s) coefficients values >>= sumOf s

-- | What occurs how often in a period.
countingLaws :: [Law Session]
countingLaws =
  [ Law
      "in a period 0 occurs q^(n-1) - 1 times and every other element q^(n-1) times"
      ( \s ->
          let q = profileOrder (profile s)
           in isShort s
                ==> equal (counted <$> aPeriod s) (pure (allButOne q (q ^ (degree s - 1))))
      ),
    Law
      "in a period every n consecutive terms but 0 ... 0 occur once: span n"
      (\s -> isShort s ==> holds (hasSpan (degree s)) (aPeriod s)),
    Law
      "the traces of s(i+d) - s(i) are 0 once less often than each other value, unless q^n - 1 \
      \divides d: autocorrelation -1"
      ( \s ->
          let p = characteristic s
              difference d i = do
                later <- term s (i + d)
                now <- term s i
                negation s now >>= add s later >>= trace s
           in period s > 1
                && isShort s
                  ==> forShifts s
                $ \d ->
                  equal
                    (counted <$> traverse (difference d) [0 .. period s - 1])
                    (pure (allButOne p ((period s + 1) `div` p)))
      )
  ]
  where
    counted :: [Code] -> Map.Map Code Natural
    counted = Map.fromListWith (+) . map (\a -> (a, 1))
    -- 0 occurs once less often than this, and every other code below n this often.
    allButOne n often =
      Map.filter (> 0) (Map.fromList ((0, often - 1) : [(a, often) | a <- [1 .. n - 1]]))

-- | What sums and samples of the sequence are.
shiftLaws :: [Law Session]
shiftLaws =
  [ Law
      "s(i) + s(i+d) = s(i+e) for all i and some e, or is 0 for all i: shift and add"
      ( \s ->
          let sums d =
                traverse (\i -> join (add s <$> term s i <*> term s (i + d))) [0 .. period s - 1]
           in isShort s ==> forShifts s $ \d ->
                holds
                  (\(terms, added) -> all (== 0) added || added `isShiftOf` terms)
                  ((,) <$> aPeriod s <*> sums d)
      ),
    Law
      "s(d i) is a maximal-length sequence again, for d coprime to q^n - 1: decimation"
      ( \s ->
          isShort s ==> forShifts s $ \d ->
            gcd d (period s) == 1 ==> holds (hasSpan (degree s)) (everyNth s d)
      ),
    Law
      "s(q i) = s(i+e) for all i and some e"
      ( \s ->
          isShort s
            ==> holds
              (uncurry isShiftOf)
              ((,) <$> everyNth s (profileOrder (profile s)) <*> aPeriod s)
      )
  ]
  where
    everyNth s d = traverse (term s . (d *)) [0 .. period s - 1]
    sampled `isShiftOf` terms =
      any ((== sampled) . take (length terms)) (take (length terms) (tails (cycle terms)))

-- | For distances between terms, from 1 to less than a period.
forShifts :: Session -> (Natural -> Property) -> Property
forShifts s =
  withMaxSuccess 10 . forAll (fromInteger <$> chooseInteger (1, max 1 (toInteger (period s) - 1)))

-- | Whether every n consecutive terms of a period that is repeated occur once, and none of them are
-- all zeros.
hasSpan :: Natural -> [Code] -> Bool
hasSpan n terms = Set.size tuples == length terms && all (any (/= 0)) tuples
  where
    tuples = Set.fromList (zipWith const (map (take (fromIntegral n)) (tails (cycle terms))) terms)

-- | a + a^p + a^(p^2) + ..., a sum of m powers, where q = p^m; its code is below p.
trace :: Session -> Code -> Wire Code
trace s a = sequence (take m (iterate (>>= power) (pure a))) >>= sumOf s
  where
    p = characteristic s
    m = length (takeWhile (> 1) (iterate (`div` p) (profileOrder (profile s))))
    power b = foldM (\x _ -> multiply s x b) b [2 .. p]

sumOf :: Session -> [Code] -> Wire Code
sumOf s = foldM (add s) 0

aPeriod :: Session -> Wire [Code]
aPeriod s = traverse (term s) [0 .. period s - 1]

-- | Whether all terms of a period are looked at: up to 4096.
isShort :: Session -> Bool
isShort s = period s <= 4096

period :: Session -> Natural
period s = profileOrder (profile s) ^ degree s - 1

degree :: Session -> Natural
degree s = fromIntegral (length (polynomialOf s)) - 1

polynomialOf :: Session -> [Code]
polynomialOf = profilePolynomial . profile
