{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of the field: every operation on all codes, and the axioms on all triples (drawn ones
-- for fields of more than 10 elements).
module PraTactile.Conformance.Laws.Field
  ( fieldLaws,
  )
where

import Control.Monad (replicateM)
import Data.Aeson (Value (Number))
import Numeric.Natural (Natural)
import PraTactile.Conformance.Definition (ProfileFacts, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Forms
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Order
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Operations.Conventions (lessList, lessNatural)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (listOf, natural)
import PraTactile.Profile (Profile (..))
import Test.QuickCheck (elements, vectorOf)

-- | The laws of GF(q).
fieldLaws :: [Law ProfileFacts]
fieldLaws =
  operationLaws ++ powerLaws ++ additionAxioms ++ multiplicationAxioms ++ otherLaws
    ++ [orderLaw OnField (operationsIn OnField)]
    ++ formLaws OnField (operationsIn OnField)
    ++ invalidLaws

-- | Each operation on all codes.
operationLaws :: [Law ProfileFacts]
operationLaws =
  [ ofCodes "addition-as-defined" Add 2 "a + b is the sum of polynomials over the prime field" two,
    ofCodes
      "multiplication-as-defined"
      Multiply
      2
      "a b is the product of polynomials modulo the profile's modulus"
      two,
    ofCodes "negation-as-defined" Negate 1 "-a is the element whose sum with a is 0" id,
    ofCodes
      "inverse-as-defined"
      Inverse
      1
      "1/a is the element whose product with a is 1; 1/0 is refused: division-by-zero"
      id,
    ofCodes
      "logarithm-as-defined"
      Logarithm
      1
      "log a is the least i with A^i = a, where A is the smallest code of order q - 1; log 0 is \
      \refused: out-of-range"
      id,
    ofCodes
      "trace-as-defined"
      Trace
      1
      "the trace of a to the prime field is a + a^p + a^(p^2) + ..."
      id
  ]
  where
    two codes = [(a, b) | [a, b] <- [codes]]

-- | A law that an operation is answered by definition, on all lists of @count@ codes.
ofCodes :: Show i => String -> Op i o -> Int -> String -> ([Code] -> [i]) -> Law ProfileFacts
ofCodes what operation count sentence inputs =
  defined OnField what operation sentence byModulus $ \known ->
    case codesDomain count (knownProfile known) of
      Every every -> Every (every >>= questions)
      Some draw _ -> Some (draw >>= elements . questions) smallerQuestions
  where
    questions codes = [SomeQuestion (operation :? input) | input <- inputs codes]

byModulus :: String
byModulus = "Lidl and Niederreiter, Finite Fields, chapter 2; the profile's modulus"

-- | All lists of the given number of codes, the last one changing first; drawn ones if there are
-- more than 1024.
codesDomain :: Int -> Profile -> Domain [Code]
codesDomain count p
  | profileOrder p ^ count <= 1024 = Every (replicateM count (elementsOf p))
  | otherwise =
    Some
      (vectorOf count (upTo (profileOrder p - 1)))
      (filter ((== count) . length) . lessList lessNatural)

powerLaws :: [Law ProfileFacts]
powerLaws =
  [ defined
      OnField
      "power-as-defined"
      Power
      "a^i for i from -q to q; a^0 = 1, also 0^0 = 1; 0^-i is refused: division-by-zero"
      byModulus
      ( \known ->
          let q = toInteger (profileOrder (knownProfile known))
           in Every
                [ SomeQuestion (Power :? (a, i))
                  | i <- 0 : concat [[j, -j] | j <- [1 .. min 32 q]],
                    a <- take 32 (elementsOf (knownProfile known))
                ]
      ),
    defined
      OnField
      "power-of-any-exponent"
      Power
      "a^i = a^(i mod (q - 1)) for a other than 0 and i of any size"
      "Lidl and Niederreiter, Finite Fields, lemma 2.3"
      ( \known ->
          Some
            ( do
                a <- upTo (profileOrder (knownProfile known) - 1)
                i <- toInteger <$> anyNatural
                sign <- upTo 1
                pure (SomeQuestion (Power :? (a, if sign == 0 then i else -i)))
            )
            smallerQuestions
      )
  ]

-- | A law that two trials give the same result, for all lists of the given number of codes. It
-- needs the operations.
equation ::
  String ->
  [SomeOp] ->
  Int ->
  String ->
  (ProfileFacts -> [Code] -> Trial ()) ->
  Law ProfileFacts
equation what needs count sentence held =
  law OnField what needs sentence "the axioms of a field; Lidl and Niederreiter, chapter 1" $
    \known ->
      Cases (listOf natural) (codesDomain count (knownProfile known)) (trial . held known)

add :: ProfileFacts -> Code -> Code -> Trial Code
add known a b = answer known (Add :? (a, b))

multiply :: ProfileFacts -> Code -> Code -> Trial Code
multiply known a b = answer known (Multiply :? (a, b))

-- | Requires that the last answer equals the given code.
same :: String -> Code -> Code -> Trial ()
same sentence wanted got =
  demand
    (Because "an axiom of fields, with the other answers of the same implementation" sentence)
    (Add :? (0, 0))
    wanted
    (wanted == got)

-- | A law that an operation is associative.
associates ::
  String -> Op i o -> (ProfileFacts -> Code -> Code -> Trial Code) -> String -> Law ProfileFacts
associates name operation ask sentence =
  equation (name ++ "-associates") [SomeOp operation] 3 sentence $ \known codes -> case codes of
    [a, b, c] -> do
      left <- ask known b c >>= ask known a
      right <- ask known a b >>= \ab -> ask known ab c
      same sentence left right
    _ -> inapplicable

-- | A law that an operation is commutative.
commutes ::
  String ->
  Op i o ->
  (ProfileFacts -> Code -> Code -> Trial Code) ->
  String ->
  Law ProfileFacts
commutes name operation ask sentence =
  equation (name ++ "-commutes") [SomeOp operation] 2 sentence $ \known codes -> case codes of
    [a, b] -> do
      left <- ask known a b
      right <- ask known b a
      same sentence left right
    _ -> inapplicable

additionAxioms :: [Law ProfileFacts]
additionAxioms =
  [ associates "addition" Add add "a + (b + c) = (a + b) + c",
    commutes "addition" Add add "a + b = b + a",
    equation "zero-is-neutral" [SomeOp Add] 1 "a + 0 = a" $ \known codes -> case codes of
      [a] -> add known a 0 >>= same "a + 0 = a" a
      _ -> inapplicable,
    equation "negation-inverts-addition" [SomeOp Add, SomeOp Negate] 1 "a + (-a) = 0" $
      \known codes -> case codes of
        [a] -> answer known (Negate :? a) >>= add known a >>= same "a + (-a) = 0" 0
        _ -> inapplicable
  ]

multiplicationAxioms :: [Law ProfileFacts]
multiplicationAxioms =
  [ associates "multiplication" Multiply multiply "a (b c) = (a b) c",
    commutes "multiplication" Multiply multiply "a b = b a",
    equation "one-is-neutral" [SomeOp Multiply] 1 "1 a = a" $ \known codes -> case codes of
      [a] -> multiply known 1 a >>= same "1 a = a" a
      _ -> inapplicable,
    equation
      "inverse-inverts-multiplication"
      [SomeOp Multiply, SomeOp Inverse]
      1
      "a (1/a) = 1 for a other than 0"
      $ \known codes -> case codes of
        [a] | a > 0 -> answer known (Inverse :? a) >>= multiply known a >>= same "a (1/a) = 1" 1
        _ -> inapplicable,
    equation "multiplication-distributes" [SomeOp Add, SomeOp Multiply] 3 "a (b + c) = a b + a c" $
      \known
       codes ->
          case codes of
            [a, b, c] -> do
              left <- add known b c >>= multiply known a
              ab <- multiply known a b
              ac <- multiply known a c
              right <- add known ab ac
              same "a (b + c) = a b + a c" left right
            _ -> inapplicable
  ]

-- | The relations of characteristic, powers, logarithms and traces to sums and products.
otherLaws :: [Law ProfileFacts]
otherLaws =
  [ equation "characteristic-is-p" [SomeOp Add] 1 "a + a + ... + a = 0 with p summands" $
      \known codes -> case codes of
        [a] -> do
          total <- multiple known (characteristicOf (knownProfile known)) a
          same "p times a is 0, p the characteristic" 0 total
        _ -> inapplicable,
    equation
      "power-is-repeated-multiplication"
      [SomeOp Power, SomeOp Multiply]
      2
      "a^(i+1) = a a^i"
      $ \known codes -> case codes of
        [a, i] -> do
          before <- answer known (Power :? (a, toInteger i))
          product' <- multiply known a before
          after <- answer known (Power :? (a, toInteger i + 1))
          same "a^(i+1) = a a^i" product' after
        _ -> inapplicable,
    equation
      "logarithm-of-a-product"
      [SomeOp Logarithm, SomeOp Multiply]
      2
      "log (a b) = log a + log b modulo q - 1"
      $ \known codes -> case codes of
        [a, b] | a > 0 && b > 0 -> do
          la <- answer known (Logarithm :? a)
          lb <- answer known (Logarithm :? b)
          lab <- multiply known a b >>= answer known . (Logarithm :?)
          same "log (a b) = log a + log b" (modulo known (la + lb)) lab
        _ -> inapplicable,
    equation "trace-is-additive" [SomeOp Trace, SomeOp Add] 2 "Tr (a + b) = Tr a + Tr b" $
      \known codes -> case codes of
        [a, b] -> do
          right <- add known a b >>= answer known . (Trace :?)
          ta <- answer known (Trace :? a)
          tb <- answer known (Trace :? b)
          left <- add known ta tb
          same "Tr (a + b) = Tr a + Tr b" right left
        _ -> inapplicable,
    equation "trace-of-a-pth-power" [SomeOp Trace, SomeOp Power] 1 "Tr (a^p) = Tr a" $
      \known
       codes -> case codes of
          [a] -> do
            ta <- answer known (Trace :? a)
            raised <- answer known (Power :? (a, toInteger (characteristicOf (knownProfile known))))
            answer known (Trace :? raised) >>= same "Tr (a^p) = Tr a" ta
          _ -> inapplicable
  ]
  where
    modulo known n = n `mod` max 1 (profileOrder (knownProfile known) - 1)
    -- By doubling, so that a large characteristic needs few sums.
    multiple :: ProfileFacts -> Natural -> Code -> Trial Code
    multiple known count a
      | count == 0 = pure 0
      | otherwise = do
        half <- multiple known (count `div` 2) a
        twice <- add known half half
        if odd count then add known twice a else pure twice

-- | The laws of invalid codes and of malformed inputs.
invalidLaws :: [Law ProfileFacts]
invalidLaws =
  [ none Add (1, 1) (\a -> [(a, 0), (0, a)]),
    none Multiply (1, 1) (\a -> [(a, 0), (0, a)]),
    none Negate 1 pure,
    none Inverse 1 pure,
    none Power (1, 1) (\a -> [(a, i) | i <- [0, 1, 2, -1]]),
    none Logarithm 1 pure,
    none Trace 1 pure
  ]
  where
    none :: Show i => Op i o -> i -> (Code -> [i]) -> Law ProfileFacts
    none operation input tooLarge =
      invalid OnField (nameOf (SomeOp operation) ++ "-refuses-what-is-invalid") operation $
        \known ->
          [ SomeQuestion (operation :? other)
            | a <- noCodes (knownProfile known),
              other <- tooLarge a
          ]
            ++ [rawWith (operation :? input) "a" (Number (-1))]
            ++ malformed (operation :? input)
