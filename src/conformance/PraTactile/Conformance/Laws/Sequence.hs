{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of the sequence: it obeys the profile's recurrence from the profile's state at any
-- index, and has maximal length (MacWilliams and Sloane, 1976).
module PraTactile.Conformance.Laws.Sequence
  ( sequenceLaws,
  )
where

import Control.Monad (foldM, zipWithM)
import Data.Aeson (Value (..))
import Data.List (tails)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..), naturalsBelow)
import PraTactile.Conformance.Definition (ProfileFacts, expected, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Forms
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Order
import PraTactile.Conformance.Operations (operationsIn, smallerQuestions)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (Codec, natural)
import PraTactile.Profile (Profile (..), Reading (..), canonicalProfile)
import Test.QuickCheck hiding (listOf)

-- | The laws of the sequence.
sequenceLaws :: [Law ProfileFacts]
sequenceLaws =
  definitionLaws ++ recurrenceLaws ++ countingLaws ++ shiftLaws
    ++ [orderLaw OnSequence (operationsIn OnSequence)]
    ++ formLaws OnSequence (operationsIn OnSequence)
    ++ invalidLaws

definitionLaws :: [Law ProfileFacts]
definitionLaws =
  [ defined OnSequence "term-as-defined" Term "s(i) for all i of a period" recurrence $ \known ->
      let p = knownProfile known
       in if isShort p
            then Every (SomeQuestion . (Term :?) <$> naturalsBelow (periodOf p))
            else Some (SomeQuestion . (Term :?) <$> upTo (periodOf p)) smallerQuestions,
    defined
      OnSequence
      "term-of-any-index"
      Term
      "s(i) for indices of any size: s(i + q^n - 1) = s(i)"
      recurrence
      ( \known ->
          Some (SomeQuestion . (Term :?) <$> anyIndex (knownProfile known)) smallerQuestions
      ),
    defined
      OnSequence
      "terms-as-defined"
      Terms
      "s(i), ..., s(i + length - 1) for indices and lengths up to two more than the degree; no \
      \terms for length 0; many periods of short sequences"
      recurrence
      ( \known ->
          let p = knownProfile known
              n = degreeOf p + 2
           in Every $
                [SomeQuestion (Terms :? (i, count)) | count <- [0 .. n], i <- [0 .. n]]
                  ++ [SomeQuestion (Terms :? (n, 65537)) | p == canonicalProfile || periodOf p < 25]
      ),
    defined
      OnSequence
      "terms-of-any-index"
      Terms
      "terms from indices of any size, also across the end of a period"
      recurrence
      ( \known ->
          Some
            (SomeQuestion . (Terms :?) <$> ((,) <$> anyIndex (knownProfile known) <*> anyLength))
            smallerQuestions
      )
  ]

recurrence :: String
recurrence =
  "MacWilliams and Sloane (1976), section II; the profile's polynomial, reading and \
  \state"

-- | A number of terms, mostly small.
anyLength :: Gen Natural
anyLength = frequency [(19, upTo 40), (1, upTo 4000)]

-- | An index near the end of a period, or any.
anyIndex :: Profile -> Gen Natural
anyIndex p =
  oneof
    [ (+) (periodOf p - min (periodOf p) 20) <$> upTo 40,
      anyNatural
    ]

recurrenceLaws :: [Law ProfileFacts]
recurrenceLaws =
  [ ofIndex "begins-with-the-state" "s(0), ..., s(n-1) are the profile's state" [0] $ \known i -> do
      let p = knownProfile known
          question = Terms :? (i, degreeOf p)
      got <- answer known question
      demand
        (Because "the profile's state" "the sequence begins with it")
        question
        (profileState p)
        (got == profileState p),
    ofIndex
      "obeys-the-recurrence"
      "c0 s(i) + c1 s(i+1) + ... + cn s(i+n) = 0, with c read backwards for a reciprocal polynomial"
      [0 .. 600]
      ( \known i -> do
          let p = knownProfile known
              question = Terms :? (i, degreeOf p + 1)
          got <- answer known question
          demand
            ( Because
                "the profile's polynomial"
                "the sum of the terms, each times its coefficient, is 0"
            )
            question
            (either (const []) id (expected known question))
            (combination known (coefficientsOf p) got == Right 0)
      )
  ]
  where
    -- The reciprocal's coefficients are the polynomial's in reverse order, up to a factor that does
    -- not matter here.
    coefficientsOf p = case profileReading p of
      Characteristic -> profilePolynomial p
      Reciprocal -> reverse (profilePolynomial p)
    combination known coefficients values =
      traverse (expected known . (Multiply :?)) (zip coefficients values)
        >>= foldM (\a b -> expected known (Add :? (a, b))) 0

-- | A law about the terms from each of these indices on, within a period.
ofIndex ::
  String ->
  String ->
  [Natural] ->
  (ProfileFacts -> Natural -> Trial ()) ->
  Law ProfileFacts
ofIndex what sentence indices held =
  law OnSequence what [SomeOp Terms] sentence recurrence $ \known ->
    Cases
      index
      (Every (takeWhile (< periodOf (knownProfile known)) indices))
      (trial . held known)

-- | A law about a whole period, for sequences of which one is short enough.
ofPeriod ::
  String ->
  String ->
  (Profile -> [Natural]) ->
  (ProfileFacts -> Natural -> [Code] -> Bool) ->
  Law ProfileFacts
ofPeriod what sentence distances held =
  law OnSequence what [SomeOp Terms] sentence "MacWilliams and Sloane (1976), section II" $
    \known -> Cases index (Every (distances (knownProfile known))) $ \d -> trial $ do
      let p = knownProfile known
          question = Terms :? (0, periodOf p)
      if isShort p && d > 0
        then do
          got <- answer known question
          demand
            (Because "a theorem on maximal-length sequences" sentence)
            question
            (either (const []) id (expected known question))
            (length got == fromIntegral (periodOf p) && held known d got)
        else inapplicable

index :: Codec Natural
index = natural

countingLaws :: [Law ProfileFacts]
countingLaws =
  [ ofPeriod
      "counts-every-symbol"
      "in a period 0 occurs q^(n-1) - 1 times and every other element q^(n-1) times"
      (const [1])
      ( \known _ terms ->
          let p = knownProfile known
              q = profileOrder p
           in counted terms == allButOne q (q ^ (degreeOf p - 1))
      ),
    ofPeriod
      "has-span-n"
      "in a period every n consecutive terms except 0 ... 0 occur exactly once (span n)"
      (const [1])
      (\known _ terms -> hasSpan (degreeOf (knownProfile known)) terms),
    ofPeriod
      "autocorrelates-by-minus-one"
      "among the traces of s(i+d) - s(i), 0 occurs once less often than each other value, unless \
      \q^n - 1 divides d; for long periods some d are tried"
      shiftsOf
      ( \known d terms ->
          let p = knownProfile known
              difference later now =
                expected known (Negate :? now) >>= expected known . (Add :?) . (,) later
                  >>= expected known
                    . (Trace :?)
              characteristic = characteristicOf p
           in fmap counted (zipWithM difference (shifted d terms) terms)
                == Right (allButOne characteristic ((periodOf p + 1) `div` characteristic))
                || d `mod` periodOf p
                == 0
      )
  ]
  where
    counted :: [Code] -> Map.Map Code Natural
    counted = Map.fromListWith (+) . map (\a -> (a, 1))
    -- 0 occurs once less often than @often@, and every other code below n occurs @often@ times.
    allButOne n often =
      Map.filter (> 0) (Map.fromList ((0, often - 1) : [(a, often) | a <- [1 .. n - 1]]))

shiftLaws :: [Law ProfileFacts]
shiftLaws =
  [ ofPeriod
      "shifts-and-adds"
      "s(i) + s(i+d) = s(i+e) for all i and some e, or is 0 for all i"
      shiftsOf
      ( \known d terms -> case zipWithM (sum' known) terms (shifted d terms) of
          Right added -> all (== 0) added || added `isShiftOf` terms
          Left _ -> False
      ),
    ofPeriod
      "decimates"
      "s(d i) is a maximal-length sequence again, for d coprime to q^n - 1"
      shiftsOf
      ( \known d terms ->
          gcd d (periodOf (knownProfile known)) /= 1
            || hasSpan (degreeOf (knownProfile known)) (everyNth d terms)
      ),
    ofPeriod
      "is-its-own-qth-decimation"
      "s(q i) = s(i+e) for all i and some e"
      (const [1])
      (\known _ terms -> everyNth (profileOrder (knownProfile known)) terms `isShiftOf` terms)
  ]
  where
    sum' known a b = expected known (Add :? (a, b))
    everyNth d terms =
      let looked = Map.fromDistinctAscList (zip [0 :: Natural ..] terms)
          period = fromIntegral (length terms)
       in [Map.findWithDefault 0 ((d * i) `mod` period) looked | i <- naturalsBelow period]
    sampled `isShiftOf` terms =
      any ((== sampled) . take (length terms)) (take (length terms) (tails (cycle terms)))

shifted :: Natural -> [Code] -> [Code]
shifted d terms =
  zipWith
    const
    (drop (fromIntegral d `mod` max 1 (length terms)) (cycle terms))
    terms

-- | Shifts from 1 to less than a period; only some if the period is above 100.
shiftsOf :: Profile -> [Natural]
shiftsOf p
  | period <= 100 = [1 .. period - 1]
  | otherwise = Set.toAscList (Set.fromList (filter (< period) several))
  where
    period = periodOf p
    Shape n1 n2 = profileShape p
    several = [1, 2, 3, 5, 7, 11, profileOrder p, n1, n2, period `div` 2, period - 1]

-- | Whether every n consecutive terms of a repeated period occur exactly once and are never all
-- zeros.
hasSpan :: Natural -> [Code] -> Bool
hasSpan n terms = Set.size tuples == length terms && all (any (/= 0)) tuples
  where
    tuples = Set.fromList (zipWith const (map (take (fromIntegral n)) (tails (cycle terms))) terms)

-- | Whether all terms of a period are asked for: at most 4096.
isShort :: Profile -> Bool
isShort p = periodOf p <= 4096

invalidLaws :: [Law ProfileFacts]
invalidLaws =
  [ invalid OnSequence "term-refuses-what-is-invalid" Term $ \_ ->
      rawWith (Term :? 0) "index" (Number (-1)) : malformed (Term :? 1),
    invalid OnSequence "terms-refuses-what-is-invalid" Terms $ \_ ->
      [rawWith (Terms :? (0, 1)) name (Number (-1)) | name <- ["from", "length"]]
        ++ malformed (Terms :? (1, 1))
  ]
