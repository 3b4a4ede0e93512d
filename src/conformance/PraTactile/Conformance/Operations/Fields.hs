{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The operations of the field and of polynomials over it.
module PraTactile.Conformance.Operations.Fields
  ( add,
    multiply,
    negate',
    inverse,
    power,
    logarithm,
    trace,
    primitive,
    firstPrimitive,
  )
where

import Control.Monad (replicateM)
import Data.Either (isRight)
import Numeric.Natural (Natural)
import PraTactile.Array (naturalsBelow)
import PraTactile.Conformance.Answer
import PraTactile.Conformance.Definition.Array (ProfileFacts (..))
import PraTactile.Conformance.Definition.Field (Field)
import qualified PraTactile.Conformance.Definition.Field as Definition
import qualified PraTactile.Conformance.Definition.Polynomial as Definition
import PraTactile.Conformance.Forms
import PraTactile.Conformance.Library.Prepared
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations.Conventions
import PraTactile.Conformance.Question
import PraTactile.Conformance.Stage
import PraTactile.Conformance.Vectors.Draw
import PraTactile.Conformance.Vectors.Flag
import PraTactile.Field (GF, KnownField)
import qualified PraTactile.Field as Field
import qualified PraTactile.Field.Structure as Structure
import PraTactile.Format.Json.Codec hiding (integer, natural, refuse)
import PraTactile.Polynomial
  ( PolynomialError (OrderNotFactored),
    checkPrimitive,
    coefficients,
    polynomial,
    primitivePolynomial,
  )
import qualified PraTactile.Polynomial as Polynomial
import PraTactile.Profile (Profile (..))
import Test.QuickCheck (shrinkIntegral)

add :: Operation (Code, Code) Code
add =
  ofTwo
    "add"
    Definition.add
    (\p -> digitsOf p ++ "; digits are added modulo the characteristic")
    ("table of sums", "sums of polynomials modulo p")
    "sums, row by row"
    (+)

multiply :: Operation (Code, Code) Code
multiply =
  ofTwo
    "multiply"
    Definition.multiply
    (\p -> digitsOf p ++ ", multiplied as polynomials and reduced modulo " ++ modulusOf p)
    ("table of logarithms", "products of polynomials modulo the modulus")
    "products, row by row"
    (*)

-- | An operation on two elements: its name, its definition, why, the roads, the order of its table,
-- and this library's answer.
ofTwo ::
  String ->
  (Field -> Int -> Int -> Int) ->
  (Profile -> String) ->
  (String, String) ->
  String ->
  (forall k. KnownField k => GF k -> GF k -> GF k) ->
  Operation (Code, Code) Code
ofTwo name defined why ways order ours =
  Operation
    { operationName = name,
      operationStage = OnField,
      operationSays = "a code",
      operationInput = object ((,) <$> key "a" natural fst <*> key "b" natural snd),
      operationOutput = natural,
      operationReasons = [],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning byDefinition (of' why) ways (const (1, 1)))
            { typical = \k -> [(1, orderIn k - 1)],
              refused = \k -> [(orderIn k, 0)],
              smaller = pairsLess,
              asked = \k ->
                ofCode
                  (if isSmall k then Just ("All pairs of elements.", allPairs k) else Nothing)
                  (replicateM 128 ((,) <$> below (orderIn k) <*> below (orderIn k)))
                  [(orderIn k, 0), (0, orderIn k), (2 ^ (64 :: Int), 1)],
              tabled = \k -> if isSmall k then Nothing else Just (order, allPairs k, id),
              flags = \p (a, b) -> codeFlags p [a, b]
            }
          (\it (a, b) -> fromElement <$> (ours <$> element it a <*> element it b))
    }
  where
    byDefinition k (a, b) =
      fromIntegral <$> (defined (knownField k) <$> codeIn k a <*> codeIn k b)
    isSmall k = orderIn k <= 16
    allPairs k = let codes = naturalsBelow (orderIn k) in [(a, b) | a <- codes, b <- codes]

negate' :: Operation Code Code
negate' =
  ofOne
    "negate"
    "a code"
    []
    (\f a -> Right (Definition.negation f a))
    (\p -> digitsOf p ++ "; each digit is negated modulo the characteristic")
    ("table", "search for the element whose sum is 0")
    (pure . negate)

inverse :: Operation Code Code
inverse =
  ofOne
    "inverse"
    "a code"
    noInverse
    (\f a -> orRefusal "division-by-zero" (Definition.inverse f a))
    (\p -> "the product of an element and its inverse is 1, modulo " ++ modulusOf p)
    ("table", "search for the element whose product is 1")
    (orRefuse "division-by-zero" . Field.inverse)

noInverse :: [(String, String)]
noInverse = [("division-by-zero", "0 has no inverse")]

logarithm :: Operation Code Natural
logarithm =
  ofOneWith
    "logarithm"
    "the least i with A^i = a"
    [("out-of-range", "0 is not a power of A")]
    (\f a -> orRefusal "out-of-range" (fromIntegral <$> Definition.logarithm f a))
    ( \p ->
        "the least exponent; its base is the smallest code of order q - 1, modulo "
          ++ modulusOf p
    )
    ("table", "counting powers of the primitive element")
    (maybe (refuse "out-of-range") (pure . fromIntegral) . Field.logarithm)

trace :: Operation Code Code
trace =
  ofOne
    "trace"
    "a + a^p + a^(p^2) + ..., m summands"
    []
    (\f a -> Right (Definition.trace f a))
    ( \p ->
        "a + a^p + a^(p^2) + ..., one summand for each degree of the modulus " ++ modulusOf p
    )
    ("Frobenius by logarithms", "sum of repeated p-th powers")
    (pure . Structure.trace Structure.primeSubfield)

-- | An operation from an element to an element: its name, what it answers, the reasons, its
-- definition, why, the roads, and this library's answer.
ofOne ::
  String ->
  String ->
  [(String, String)] ->
  (Field -> Int -> Either Refusal Int) ->
  (Profile -> String) ->
  (String, String) ->
  (forall k. KnownField k => GF k -> Wire (GF k)) ->
  Operation Code Code
ofOne name says reasons defined why ways ours =
  ofOneWith
    name
    says
    reasons
    (\f a -> fromIntegral <$> defined f a)
    why
    ways
    (fmap fromElement . ours)

ofOneWith ::
  String ->
  String ->
  [(String, String)] ->
  (Field -> Int -> Either Refusal Natural) ->
  (Profile -> String) ->
  (String, String) ->
  (forall k. KnownField k => GF k -> Wire Natural) ->
  Operation Code Natural
ofOneWith name says reasons defined why ways ours =
  Operation
    { operationName = name,
      operationStage = OnField,
      operationSays = says,
      operationInput = alone "a" natural,
      operationOutput = natural,
      operationReasons = reasons,
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning (\k a -> codeIn k a >>= defined (knownField k)) (of' why) ways (const 1))
            { typical = \k -> [orderIn k - 1],
              refused = const [0 | not (null reasons)],
              smaller = lessNatural,
              asked = \k ->
                ofCode
                  (Just ("All elements.", naturalsBelow (orderIn k)))
                  (pure [])
                  [orderIn k, 2 ^ (64 :: Int)],
              flags = \p a -> codeFlags p [a]
            }
          (\it a -> element it a >>= ours)
    }

power :: Operation (Code, Integer) Code
power =
  Operation
    { operationName = "power",
      operationStage = OnField,
      operationSays = "a code; 0^0 = 1",
      operationInput = object ((,) <$> key "a" natural fst <*> key "exponent" integer snd),
      operationOutput = natural,
      operationReasons = noInverse,
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning byDefinition (of' why) ways (const (1, 1)))
            { typical = \k ->
                [ (orderIn k - 1, sign * toInteger i)
                  | i <- largeNumbers,
                    sign <- [1, -1]
                ],
              refused = const [(0, -1), (0, 0)],
              smaller = \(a, i) ->
                [(b, i) | b <- lessNatural a] ++ [(a, j) | j <- shrinkIntegral i],
              asked = \k ->
                let q = orderIn k
                    less n m = toInteger n - toInteger m
                    exponent' = less <$> below (4 * q) <*> below (2 * q)
                 in ofCode
                      Nothing
                      (replicateM 64 ((,) <$> below q <*> exponent'))
                      ( [ (a, i)
                          | a <- take 16 (naturalsBelow q),
                            i <- [-2 .. 3] ++ [toInteger q - 1, toInteger q]
                        ]
                          ++ [(a, i) | a <- [0, q - 1], i <- [huge, -huge]]
                          ++ [(q, 1)]
                      ),
              flags = \p (a, i) ->
                codeFlags p [a] ++ [NegativeExponent | i < 0] ++ [LargeNumber | isLarge (abs i)]
            }
          ( \it (a, i) -> do
              base <- element it a
              fromElement
                <$> if i < 0
                  then raised (negate i) <$> orRefuse "division-by-zero" (Field.inverse base)
                  else pure (raised i base)
          )
    }
  where
    byDefinition k (a, i) = do
      base <- codeIn k a
      orRefusal "division-by-zero" (fromIntegral <$> Definition.power (knownField k) base i)
    why p =
      "repeated multiplication modulo " ++ modulusOf p ++ "; a^-i = (1/a)^i; 0^0 = 1"
    ways = ("logarithm times exponent", "repeated multiplication")
    huge = 10 ^ (20 :: Int)
    raised i a = Field.power a (fromInteger i)

-- | The reason where the factors of q^n - 1 are not known.
notFactored :: (String, String)
notFactored = ("not-factored", "the prime factors of q^n - 1 are unknown")

primitive :: Operation [Code] Bool
primitive =
  Operation
    { operationName = "primitive",
      operationStage = OnPolynomial,
      operationSays =
        "whether it is primitive; `false` also if not monic, of degree 0, or with constant \
        \term 0",
      operationInput = alone "polynomial" (listOf natural),
      operationOutput = bool,
      operationReasons = [notFactored],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning byDefinition (const why) ways (const [1, 1]))
            { typical = \k -> [profilePolynomial (knownProfile k)],
              smaller = filter proper . lessList lessNatural,
              asked = \k -> ofCode Nothing (some (orderIn k)) (edges (knownProfile k)),
              flags = polynomialFlags . profileOrder
            }
          ( \it codes -> do
              h <- polynomial <$> traverse (element it) codes
              case checkPrimitive h of
                Left (OrderNotFactored _) -> refuse "not-factored"
                checked -> pure (isRight checked)
          )
    }
  where
    byDefinition k codes = Definition.isPrimitive (knownField k) <$> traverse (codeIn k) codes
    why = "a primitive polynomial is monic, of degree n > 0, and x has order q^n - 1 modulo it"
    ways = ("irreducible, and the order by the factors of q^n - 1", "walking the powers of x")
    -- One that ends in 0 states no degree.
    proper codes = not (null codes) && last codes /= 0
    some q = replicateM 64 $ do
      n <- below 4
      (++ [1]) <$> replicateM (fromIntegral n + 1) (below q)
    -- Polynomials that are primitive, and that are not for each reason.
    edges p =
      [h, reverse h, lower, 0 : drop 1 h, lower ++ [q - 1], h ++ [1], [], [0], [1], [0, 1]]
        ++ [[1, 1], [q - 1, 1], [q, 1], map (const 1) h, 1 : map (const 0) (drop 2 h) ++ [1]]
      where
        h = profilePolynomial p
        lower = take (length h - 1) h
        q = profileOrder p

firstPrimitive :: Operation Natural [Code]
firstPrimitive =
  Operation
    { operationName = "first-primitive",
      operationStage = OnPolynomial,
      operationSays =
        "the first primitive polynomial, comparing coefficients from the highest degree down; \
        \degree 0 is `invalid`",
      operationInput = alone "degree" natural,
      operationOutput = ofAtLeast 2 (listOf natural),
      operationReasons = [notFactored, tooLong],
      operationLeast = \n -> leastOfList (n + 1),
      operationWays =
        UnderProfile
          (meaning byDefinition (const why) ways (const 1))
            { smaller = lessNatural,
              asked = \k -> ofCode Nothing (pure []) [0 .. if orderIn k > 16 then 2 else 4],
              flags = \_ n -> [DegreeZero | n == 0]
            }
          ours
    }
  where
    byDefinition k n
      | n == 0 = refuseFor "invalid"
      | otherwise =
        Right (map fromIntegral (Definition.firstPrimitive (knownField k) (fromIntegral n)))
    why = "the first primitive polynomial; coefficients are compared from the highest degree down"
    ways = ("sieve of candidates", "all polynomials in order")
    ours :: forall k. KnownField k => Prepared k -> Natural -> Wire [Code]
    ours _ n = case Polynomial.firstPrimitive n of
      Left (OrderNotFactored _) -> refuse "not-factored"
      found -> do
        h <- orRefuse "invalid" found
        pure (map fromElement (coefficients (primitivePolynomial (h :: Polynomial.Primitive k))))
