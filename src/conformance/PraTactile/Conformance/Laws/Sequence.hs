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
sequenceLaws =
  [ Law
      "s(0), ..., s(n-1) are the initial state"
      (\s -> equal (traverse (term s) [0 .. degree s - 1]) (pure (profileState (profile s)))),
    Law
      "c0 s(i) + c1 s(i+1) + ... + cn s(i+n) = 0, with c read backwards for a reciprocal polynomial"
      ( \s ->
          let obeyed i =
                equal
                  (combination s (recurrence s) (traverse (\k -> term s (i + k)) [0 .. degree s]))
                  (pure 0)
           in if period s <= 4096
                then
                  once
                    (conjoin [counterexample (show i) (obeyed i) | i <- naturalsBelow (period s)])
                else forTerms s obeyed
      ),
    Law "s(i + q^n - 1) = s(i)" (\s -> forTerms s (\i -> equal (term s (i + period s)) (term s i))),
    Law
      "in a period 0 occurs q^(n-1) - 1 times and every other element q^(n-1) times"
      ( \s ->
          period s <= 4096
            ==> let often = profileOrder (profile s) ^ (degree s - 1)
                    expected =
                      Map.fromList
                        ( filter
                            ((> 0) . snd)
                            ( (0, often - 1) :
                                [(a, often) | a <- [1 .. profileOrder (profile s) - 1]]
                            )
                        )
                 in equal (counted <$> aPeriod s) (pure expected)
      ),
    Law
      "in a period every n consecutive terms but 0 ... 0 occur once: span n"
      ( \s ->
          period s <= 4096 ==> holds (spans s) (aPeriod s)
      ),
    Law
      "s(i) + s(i+d) = s(i+e) for all i and some e, or is 0 for all i: shift and add"
      ( \s ->
          period s <= 4096
            ==> withMaxSuccess
              10
              ( forShifts
                  s
                  ( \d ->
                      holds
                        (\(terms, sums) -> all (== 0) sums || sums `isShiftOf` terms)
                        ( (,)
                            <$> aPeriod s
                            <*> traverse
                              (\i -> join (add s <$> term s i <*> term s (i + d)))
                              [0 .. period s - 1]
                        )
                  )
              )
      ),
    Law
      "the traces of s(i+d) - s(i) are 0 once less often than each other value, unless q^n - 1 \
      \divides d: autocorrelation -1"
      ( \s ->
          (period s > 1 && period s <= 4096)
            ==> withMaxSuccess
              10
              ( forShifts
                  s
                  ( \d ->
                      let p = characteristic s
                          often = (period s + 1) `div` p
                          expected =
                            Map.fromList
                              ( filter
                                  ((> 0) . snd)
                                  ((0, often - 1) : [(a, often) | a <- [1 .. p - 1]])
                              )
                          difference i =
                            do
                              later <-
                                term s (i + d)
                              now <- term s i
                              negation s now >>= add s later >>= trace s
                       in equal
                            (counted <$> traverse difference [0 .. period s - 1])
                            (pure expected)
                  )
              )
      ),
    Law
      "s(d i) is a maximal-length sequence again, for d coprime to q^n - 1: decimation"
      ( \s ->
          period s <= 4096
            ==> withMaxSuccess
              10
              ( forShifts
                  s
                  ( \d ->
                      gcd d (period s) == 1
                        ==> holds (spans s) (traverse (term s . (d *)) [0 .. period s - 1])
                  )
              )
      ),
    Law
      "s(q i) = s(i+e) for all i and some e"
      ( \s ->
          period s <= 4096
            ==> holds
              (uncurry isShiftOf)
              ( (,)
                  <$> traverse (term s . (profileOrder (profile s) *)) [0 .. period s - 1]
                  <*> aPeriod s
              )
      )
  ]
  where
    aPeriod s = traverse (term s) [0 .. period s - 1]
    counted :: [Code] -> Map.Map Code Natural
    counted = Map.fromListWith (+) . map (\a -> (a, 1))
    -- Every n consecutive terms of a period that is repeated, each once, and none of them all
    -- zeros.
    spans s terms =
      let tuples = Set.fromList (tuplesOf (fromIntegral (degree s)) terms)
       in Set.size tuples == length terms && all (any (/= 0)) tuples
    tuplesOf n terms = [take n rest | (rest, _) <- zip (tails (cycle terms)) terms]
    ours `isShiftOf` terms =
      any ((== ours) . take (length terms)) (take (length terms) (tails (cycle terms)))
    forShifts s = forAll (fromInteger <$> chooseInteger (1, max 1 (toInteger (period s) - 1)))
    characteristic s =
      let q =
            profileOrder (profile s)
       in minimum (q : [d | d <- takeWhile (< q) [2 ..], q `mod` d == 0])
    -- a + a^p + a^(p^2) + ..., a sum of m powers, where q = p^m; its code is below p.
    trace s a = do
      let p = characteristic s
          m = length (takeWhile (> 1) (iterate (`div` p) (profileOrder (profile s))))
          power b = foldM (\x _ -> multiply s x b) b [2 .. p]
      conjugates <- sequence (take m (iterate (>>= power) (pure a)))
      foldM (add s) 0 conjugates
    polynomialOf = profilePolynomial . profile
    degree :: Session -> Natural
    degree s = fromIntegral (length (polynomialOf s)) - 1
    period s = profileOrder (profile s) ^ degree s - 1
    -- The reciprocal's coefficients are those of the polynomial backwards, up to a factor that does
    -- not matter here.
    recurrence s = case profileReading (profile s) of
      Characteristic -> polynomialOf s
      Reciprocal -> reverse (polynomialOf s)
    combination s coefficients terms = do
      values <- terms
      products <- zipWithM (multiply s) coefficients values
      foldM (add s) 0 products
