{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of primitive polynomials, and of the first of them.
module PraTactile.Conformance.Laws.Polynomials
  ( polynomialLaws,
  )
where

import Control.Monad (replicateM)
import Data.Aeson (Value (..), toJSON)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Ask (Ask)
import PraTactile.Conformance.Definition (ProfileFacts, expected, knownProfile)
import PraTactile.Conformance.Definition.Array (knownField)
import PraTactile.Conformance.Definition.Polynomial (primeDivisors, primitiveAndShort)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Forms
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Operations (operationsIn, smallerQuestions)
import PraTactile.Conformance.Operations.Conventions (lessList, lessNatural)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (listOf, natural)
import PraTactile.Profile (Profile (..))
import Test.QuickCheck hiding (listOf)

-- | The laws of polynomials over GF(q).
polynomialLaws :: [Law ProfileFacts]
polynomialLaws =
  definitionLaws ++ relationLaws
    ++ formLaws OnPolynomial (operationsIn OnPolynomial)
    ++ invalidLaws

definitionLaws :: [Law ProfileFacts]
definitionLaws =
  [ defined OnPolynomial "primitive-as-defined" Primitive primitiveSentence source $ \known ->
      Every (SomeQuestion . (Primitive :?) <$> smallPolynomials (knownProfile known)),
    defined OnPolynomial "primitive-of-drawn-ones" Primitive primitiveSentence source $ \known ->
      let degrees = [(9, drawn), (1, drawnUpTo (2 ^ (40 :: Int)))]
          draws = frequency [(often, draw (knownProfile known)) | (often, draw) <- degrees]
       in Some (SomeQuestion . (Primitive :?) <$> draws) smallerQuestions,
    defined
      OnPolynomial
      "primitive-of-high-degrees"
      Primitive
      ( "a polynomial is primitive only if its root has the order q^n - 1, and not "
          ++ "(q^n - 1) / r for a prime r, even a large one"
      )
      source
      $ \known -> Every (SomeQuestion . (Primitive :?) <$> highDegrees known),
    defined
      OnPolynomial
      "primitive-of-what-ends-in-zeros"
      Primitive
      "zero coefficients at a polynomial's end are ignored; no polynomial of degree 0 is \
      \primitive"
      source
      ( \known ->
          let p = knownProfile known
           in Every
                [ SomeQuestion (Primitive :? codes ++ replicate zeros 0)
                  | codes <- [[], [1], profilePolynomial p] ++ linear p,
                    zeros <- [0, 1, 3]
                ]
      ),
    defined
      OnPolynomial
      "first-primitive-as-defined"
      FirstPrimitive
      "the first primitive polynomial of a degree, comparing coefficients from the highest degree \
      \down"
      "the profile's order of polynomials"
      ( \known ->
          let q = profileOrder (knownProfile known)
           in Every [SomeQuestion (FirstPrimitive :? n) | n <- [1 .. 14], q ^ n <= 2 ^ (17 :: Int)]
      )
  ]

primitiveSentence :: String
primitiveSentence =
  "a polynomial of degree n > 0 is primitive if it is monic and x has the order q^n - 1 modulo it"

source :: String
source = "Lidl and Niederreiter, Finite Fields, theorem 3.16"

-- | Polynomials of degree 1.
linear :: Profile -> [[Code]]
linear p = [[a, 1] | a <- take 8 (elementsOf p)]

-- | All polynomials, monic or not, of the degrees with at most 700 of them.
smallPolynomials :: Profile -> [[Code]]
smallPolynomials p =
  [ reverse (leading : lower)
    | n <- [0 .. 8],
      (q - 1) * q ^ n <= 700,
      leading <- [1 .. q - 1],
      lower <- replicateM n (elementsOf p)
  ]
  where
    q = profileOrder p

-- | Primitive polynomials of high degrees, and polynomials whose root's order is too small by one
-- large prime. The degrees are the least for which q^n - 1 has a prime above 100, and for small
-- fields one above 2^16. For large fields q^n - 1 itself is above 2^53, with primes that are found
-- quickly.
highDegrees :: ProfileFacts -> [[Code]]
highDegrees known =
  [ map fromIntegral h
    | n <-
        withPrimeAbove 100
          ++ (if q <= 9 then withPrimeAbove (2 ^ (16 :: Int)) else [])
          ++ filter soonTold (take 1 [n | q >= 25, n <- [2 ..], q ^ n > 2 ^ (53 :: Int)]),
      h <- primitiveAndShort (knownField known) n
  ]
  where
    soonTold n = all (< 2 ^ (26 :: Int)) (primeDivisors (q ^ n - 1))
    withPrimeAbove bound =
      take 1 [n | n <- [2 .. 20 :: Int], any (> bound) (primeDivisors (q ^ n - 1))]
    q = toInteger (profileOrder (knownProfile known))

-- | A monic polynomial of a degree with q^n at most 5000.
drawn :: Profile -> Gen [Code]
drawn = drawnUpTo 5000

-- | A monic polynomial of a degree with q^n at most the given number.
drawnUpTo :: Natural -> Profile -> Gen [Code]
drawnUpTo most p = do
  n <- elements [n | n <- [1 .. 40 :: Int], q ^ n <= most]
  lower <- vectorOf n (upTo (q - 1))
  pure (lower ++ [1])
  where
    q = profileOrder p

relationLaws :: [Law ProfileFacts]
relationLaws =
  [ law
      OnPolynomial
      "first-primitive-is-primitive"
      [SomeOp FirstPrimitive, SomeOp Primitive]
      "the first primitive polynomial of a degree is primitive"
      source
      ( \known ->
          let q = profileOrder (knownProfile known)
           in Cases
                (listOf natural)
                (Every [[n] | n <- [1 .. 8], q ^ n <= 5000])
                (isPrimitive known)
      ),
    law
      OnPolynomial
      "reciprocals-are-primitive-alike"
      [SomeOp Primitive]
      "a monic polynomial and its reciprocal, made monic, are both primitive or both not \
      \primitive"
      source
      ( \known ->
          Cases
            (listOf natural)
            (Some (drawn (knownProfile known)) (filter monic . lessList lessNatural))
            (alike known)
      )
  ]
  where
    monic codes = length codes > 1 && last codes == 1
    isPrimitive known degrees = trial (mapM_ (first' known) degrees)
    first' known n = do
      h <- answer known (FirstPrimitive :? n)
      yes <- answer known (Primitive :? h)
      demand
        ( Because
            "the other answer of the same implementation"
            "it was given as the first one"
        )
        (Primitive :? h)
        True
        yes

alike :: ProfileFacts -> [Code] -> Ask Verdict
alike known codes = case inverted of
  Right factor -> trial $ do
    one' <- answer known (Primitive :? codes)
    let mirrored = traverse (expected known . (Multiply :?) . (,) factor) (reverse codes)
    case mirrored of
      Right backwards -> do
        other <- answer known (Primitive :? backwards)
        demand
          (Because "a theorem" "the roots of the reciprocal are the inverses of the roots")
          (Primitive :? backwards)
          one'
          (one' == other)
      Left _ -> inapplicable
  Left _ -> trial inapplicable
  where
    inverted = expected known (Inverse :? head' codes)
    head' xs = case xs of
      x : _ -> x
      [] -> 0

invalidLaws :: [Law ProfileFacts]
invalidLaws =
  [ invalid OnPolynomial "primitive-refuses-what-is-invalid" Primitive $ \known ->
      [ SomeQuestion (Primitive :? codes)
        | a <- noCodes (knownProfile known),
          codes <- [[a, 1], [1, a], [1, 0, a, 1]]
      ]
        ++ [rawWith (Primitive :? [1, 1]) "polynomial" (toJSON [-1, 1 :: Int])]
        ++ malformed (Primitive :? [1, 1]),
    invalid OnPolynomial "first-primitive-refuses-what-is-invalid" FirstPrimitive $ \_ ->
      SomeQuestion (FirstPrimitive :? 0) :
      rawWith (FirstPrimitive :? 1) "degree" (Number (-1)) :
      malformed (FirstPrimitive :? 1)
  ]
