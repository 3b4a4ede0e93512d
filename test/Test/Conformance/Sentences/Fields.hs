{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | What impostors say of arithmetic and of polynomials.
module Test.Conformance.Sentences.Fields (spec, names) where

import Control.Monad (replicateM)
import Control.Monad.Trans.Except (runExceptT)
import Data.Bits (xor)
import Data.Foldable (for_)
import Data.List (elemIndex, find, genericReplicate, nub, sortOn)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array (area)
import PraTactile.Conformance
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))
import Test.Conformance.Sentences.Said
import Test.Hspec

spec :: Spec
spec = do
  describe "of sums and products" $ do
    sentencesHold fields arithmeticQuestions arithmetic
    anotherModulusSpec
  describe "of codes that are none" $
    sentencesHold fields (\about -> fieldQuestions about ++ codeQuestions about) [modulo]
  describe "of the field" $ sentencesHold fields fieldQuestions ofField
  describe "of polynomials" $ sentencesHold fields polynomialQuestions ofPolynomials

-- | The impostors of which something is said here.
names :: [String]
names =
  map fst (modulo : arithmetic ++ ofField ++ ofPolynomials)
    ++ ["reduces-by-another-modulus"]

-- | All sums and products, of codes and of the first number that is none; powers of low exponents.
arithmeticQuestions :: Known -> [SomeQuestion]
arithmeticQuestions about =
  concat
    [ [SomeQuestion (operation a b) | operation <- [Add, Multiply], a <- codes, b <- codes],
      [SomeQuestion (operation a) | operation <- [Negate, Inverse, Trace], a <- codes],
      [SomeQuestion (Logarithm a) | a <- codes],
      [SomeQuestion (Power a i) | a <- codes, i <- [-9 .. 9]]
    ]
  where
    codes = [0 .. profileOrder (knownProfile about)]

-- | The same, and powers of all exponents around the field's order and the ends of machine words.
fieldQuestions :: Known -> [SomeQuestion]
fieldQuestions about =
  arithmeticQuestions about
    ++ [ SomeQuestion (Power a i)
         | a <- [0 .. profileOrder (knownProfile about)],
           size <- [10 .. 20] ++ concatMap beside [32, 53, 63, 64, 65] ++ [10 ^ (30 :: Int)],
           i <- [size, -size]
       ]
    ++ otherQuestions about
  where
    beside bits = [2 ^ (bits :: Int) - 1 .. 2 ^ bits + 1 :: Integer]

-- | A question or two of each other operation.
otherQuestions :: Known -> [SomeQuestion]
otherQuestions about =
  [ SomeQuestion (Primitive (profilePolynomial p)),
    SomeQuestion (FirstPrimitive 2),
    SomeQuestion (Term 5),
    SomeQuestion (Terms 3 4),
    SomeQuestion (Cell 2 7),
    SomeQuestion (Pack codes),
    SomeQuestion (Unpack 5),
    SomeQuestion (Locate [map Just [0, 1]]),
    SomeQuestion (Nearest Nothing [[Just 1, Nothing, Just 0]]),
    SomeQuestion (Posterior [[Certainly 1, Unfelt]]),
    SomeQuestion (Prove ["##"]),
    SomeQuestion (Distance ["##"])
  ]
  where
    p = knownProfile about
    codes = take (fromIntegral (area (profileWindow p))) (cycle [1, 0, 0])

-- | Sums and products otherwise than is right, and what follows of them by definition.
by ::
  Known ->
  (Natural -> Natural -> Natural) ->
  (Natural -> Natural -> Natural) ->
  Question b ->
  Either Refusal b
by about plus times question = case question of
  Add a b -> plus <$> code a <*> code b
  Multiply a b -> times <$> code a <*> code b
  Inverse a -> code a >>= inverted
  Power a i -> code a >>= \x -> if i < 0 then raised (-i) <$> inverted x else Right (raised i x)
  Logarithm a ->
    code a >>= maybe (refused "out-of-range") (Right . fromIntegral) . (`elemIndex` powersOf base)
  Trace a -> foldr (plus . (`raised'` a)) 0 (take (degreeOf p) (iterate (* charOf p) 1)) <$ code a
  _ -> right about question
  where
    p = knownProfile about
    q = profileOrder p
    code a = if a < q then Right a else invalid
    raised i a = raised' (fromInteger i) a
    raised' i a = foldr times 1 (genericReplicate (i :: Natural) a)
    inverted a = case filter ((== 1) . times a) [1 .. q - 1] of
      b : _ -> Right b
      [] -> refused "division-by-zero"
    powersOf a = map (`raised'` a) [0 .. q - 2]
    -- The least element of which all powers are different, or else 1.
    base = head ([a | a <- [1 .. q - 1], nub (powersOf a) == powersOf a] ++ [1])

charOf :: Profile -> Natural
charOf p = head [l | l <- [2 ..], profileOrder p `mod` l == 0]

-- | The degree of the field over its prime field.
degreeOf :: Profile -> Int
degreeOf p = length (takeWhile (< profileOrder p) (iterate (* charOf p) 1))

digitsOf :: Profile -> Natural -> [Natural]
digitsOf p a = [a `div` charOf p ^ i `mod` charOf p | i <- [0 .. degreeOf p - 1]]

codeOf :: Profile -> [Natural] -> Natural
codeOf p = foldr (\digit higher -> digit + charOf p * higher) 0

-- | The product of two polynomials over the prime field, and its remainder by long division.
productModulo :: Profile -> [Natural] -> Natural -> Natural -> Natural
productModulo p modulus a b = codeOf p (remainder full)
  where
    l = charOf p
    m = length modulus - 1
    full =
      [ sum [x * y | (i, x) <- numbered a, (j, y) <- numbered b, i + j == k] `mod` l
        | k <- [0 .. 2 * degreeOf p - 2]
      ]
    numbered x = zip [0 :: Int ..] (digitsOf p x)
    remainder cs
      | length cs <= m = cs
      | otherwise =
        let (lower, upper) = splitAt (length cs - 1 - m) cs
            leading = last cs
            without c f = (c + (l - 1) * leading * f) `mod` l
         in remainder (lower ++ zipWith without (init upper) modulus)

arithmetic :: [Sentence]
arithmetic =
  [ otherwise' "adds-modulo-q" (\p a b -> (a + b) `mod` profileOrder p) times,
    otherwise' "adds-by-xor" (\p a b -> (a `xor` b) `mod` profileOrder p) times,
    otherwise' "multiplies-modulo-q" plus (\p a b -> a * b `mod` profileOrder p),
    otherwise' "multiplies-digit-by-digit" plus $ \p a b ->
      codeOf p (zipWith (\x y -> x * y `mod` charOf p) (digitsOf p a) (digitsOf p b)),
    otherwise' "reads-the-modulus-backwards" plus $ \p ->
      let backwards = reverse (profileModulus p)
          factor = head [k | k <- [1 ..], k * last backwards `mod` charOf p == 1]
       in productModulo p (map (\c -> c * factor `mod` charOf p) backwards),
    otherwise' "forgets-to-reduce" plus $ \p -> productModulo p (replicate (degreeOf p) 0 ++ [1])
  ]
  where
    otherwise' name plus' times' =
      saying name $ \about -> let p = knownProfile about in by about (plus' p) (times' p)
    plus p a b = codeOf p (zipWith (\x y -> (x + y) `mod` charOf p) (digitsOf p a) (digitsOf p b))
    times p = productModulo p (profileModulus p)

-- | It multiplies modulo a polynomial that is irreducible and not the profile's; where there is no
-- other, and over prime fields, it is right.
anotherModulusSpec :: Spec
anotherModulusSpec = it "reduces-by-another-modulus" $ do
  one <- maybe (fail "no such impostor") pure (find ((== name) . impostorName) impostors)
  for_ fields $ \p -> do
    session <- runExceptT (open (impostorMake one library) p) >>= either (fail . show) pure
    let q = profileOrder p
        table times = [(a, b, times a b) | a <- [0 .. q - 1], b <- [0 .. q - 1]]
        withoutZeros modulus =
          and [productModulo p modulus a b /= 0 | a <- [1 .. q - 1], b <- [1 .. q - 1]]
        possible =
          filter withoutZeros (map (++ [1]) (replicateM (degreeOf p) [0 .. charOf p - 1]))
        others = if degreeOf p == 1 then [] else filter (/= profileModulus p) possible
        tables = map (table . productModulo p) (if null others then [profileModulus p] else others)
    came <- runExceptT (sequence [(,,) a b <$> multiply session a b | (a, b, _) <- table (+)])
    (p, either (const False) (`elem` tables) came) `shouldBe` (p, True)
  where
    name = "reduces-by-another-modulus"

-- | Where codes are asked about, what is none is taken modulo q; not where probabilities are.
modulo :: Sentence
modulo = saying "takes-codes-modulo-q" $ \about question ->
  let cut a = a `mod` profileOrder (knownProfile about)
   in case question of
        Add a b -> right about (Add (cut a) (cut b))
        Multiply a b -> right about (Multiply (cut a) (cut b))
        Negate a -> right about (Negate (cut a))
        Inverse a -> right about (Inverse (cut a))
        Power a i -> right about (Power (cut a) i)
        Logarithm a -> right about (Logarithm (cut a))
        Trace a -> right about (Trace (cut a))
        Primitive codes -> right about (Primitive (map cut codes))
        Pack codes -> right about (Pack (map cut codes))
        Locate patch -> right about (Locate (map (map (fmap cut)) patch))
        Nearest radius patch -> right about (Nearest radius (map (map (fmap cut)) patch))
        _ -> right about question

-- | Codes that are none, wherever there are codes.
codeQuestions :: Known -> [SomeQuestion]
codeQuestions about =
  concat
    [ [ SomeQuestion (Add a 1),
        SomeQuestion (Multiply 1 a),
        SomeQuestion (Negate a),
        SomeQuestion (Inverse a),
        SomeQuestion (Power a 3),
        SomeQuestion (Logarithm a),
        SomeQuestion (Trace a),
        SomeQuestion (Primitive [a, a, 1]),
        SomeQuestion (Pack (take k (a : repeat 1))),
        SomeQuestion (Locate (replicate 2 [Just a, Just 1, Just 0])),
        SomeQuestion (Nearest (Just 1) [[Just a, Nothing, Just 1]]),
        SomeQuestion (Posterior [[Certainly a]])
      ]
      | a <- [q - 1, q, q + 1, 2 * q + 1, 10 ^ (20 :: Int)]
    ]
  where
    p = knownProfile about
    q = profileOrder p
    k = fromIntegral (area (profileWindow p))

ofField :: [Sentence]
ofField =
  [ saying "keeps-the-second-summand" $ \about question -> case question of
      Add a b -> b <$ right about (Add a b)
      _ -> right about question,
    saying "squares-the-second-factor" $ \about question -> case question of
      Multiply a b -> right about (Multiply a b) >>= right about . Multiply b
      _ -> right about question,
    saying "negates-nothing" $ \about question -> case question of
      Negate a -> a <$ right about (Negate a)
      _ -> right about question,
    saying "negates-modulo-q" $ \about question -> case question of
      Negate a -> (if a == 0 then 0 else order about - a) <$ right about (Negate a)
      _ -> right about question,
    -- a^(q-1) is 1.
    saying "inverts-one-power-too-far" $ \about question -> case question of
      Inverse a -> 1 <$ right about (Inverse a)
      _ -> right about question,
    saying "inverts-as-it-negates" $ \about question -> case question of
      Inverse a -> right about (Inverse a) >> right about (Negate a)
      _ -> right about question,
    saying "inverts-zero" $ \about question -> case question of
      Inverse 0 -> Right 0
      _ -> right about question,
    saying "takes-exponents-modulo-q" $ \about question -> case question of
      Power a i -> right about (Power a (i `mod` toInteger (order about)))
      _ -> right about question,
    -- So that 0 has powers of negative exponents, and 0^(q-1) is 1; over GF(2) all exponents are 0.
    saying "takes-exponents-modulo-q-less-one" $ \about question -> case question of
      Power a i -> right about (Power a (i `mod` (toInteger (order about) - 1)))
      _ -> right about question,
    saying "forgets-the-exponents-sign" $ \about question -> case question of
      Power a i -> right about (Power a (abs i))
      _ -> right about question,
    saying "raises-by-sums" $ \about question -> case question of
      Power a i ->
        right about (Multiply a (fromInteger (i `mod` toInteger (charOf (knownProfile about)))))
      _ -> right about question,
    saying "has-zero-to-the-zero-zero" $ \about question -> case question of
      Power 0 0 -> Right 0
      _ -> right about question,
    saying "takes-exponents-in-64-bits" $ \about question -> case question of
      Power a i
        | i < 0 -> right about (Power a (negate (negate i `mod` 18446744073709551616)))
        | otherwise -> right about (Power a (i `mod` 18446744073709551616))
      _ -> right about question,
    ofTrace "traces-one-power-short" $ \about a ->
      let powers = conjugates about a
       in summed about (if length powers > 1 then init powers else powers),
    ofTrace "takes-the-norm-for-the-trace" $ \about a ->
      foldr (\x y -> either (const 0) id (right about (Multiply x y))) 1 (conjugates about a),
    ofTrace "traces-copies" $ \about a ->
      summed about (replicate (degreeOf (knownProfile about)) a)
  ]
  where
    order = profileOrder . knownProfile
    ofTrace :: String -> (Known -> Code -> Code) -> Sentence
    ofTrace name answer = saying name $ \about question -> case question of
      Trace a -> answer about a <$ right about (Trace a)
      _ -> right about question
    conjugates about a =
      [ b
        | i <- [0 .. degreeOf (knownProfile about) - 1],
          Right b <- [right about (Power a (toInteger (charOf (knownProfile about)) ^ i))]
      ]
    summed about = foldr (\x y -> either (const 0) id (right about (Add x y))) 0

-- | All polynomials of few coefficients, monic or not, with zeros at their ends and without; and
-- the first primitive ones of all degrees of which there are at most some thousands.
polynomialQuestions :: Known -> [SomeQuestion]
polynomialQuestions about =
  [ SomeQuestion (Primitive h)
    | n <- [0 .. longest],
      h <- replicateM n [0 .. q - 1]
  ]
    ++ [SomeQuestion (Primitive h) | h <- [[q, 1], [1, q, 1], [1, 1, q]]]
    ++ [SomeQuestion (Primitive (h ++ [1])) | h <- replicateM longest [0 .. q - 1]]
    ++ [SomeQuestion (FirstPrimitive n) | n <- 0 : [n | n <- [1 .. 8], q ^ n <= 5000]]
    ++ filter notPolynomial (otherQuestions about)
  where
    q = profileOrder (knownProfile about)
    longest = length (takeWhile (<= 200) (iterate (* q) 1)) - 1
    notPolynomial (SomeQuestion question) = operationOf question /= OfPrimitive

ofPolynomials :: [Sentence]
ofPolynomials =
  [ saying "takes-the-first-irreducible" $ \about question -> case question of
      FirstPrimitive 1 -> Right [1, 1]
      _ -> right about question,
    saying "demands-a-linear-term" $ \about question -> case question of
      Primitive h -> (&& drop 1 (take 2 h) `notElem` [[], [0]]) <$> right about (Primitive h)
      _ -> right about question,
    saying "makes-polynomials-monic" $ \about question -> case question of
      Primitive h
        | all (< order about) h,
          c : _ <- reverse h,
          Right i <- right about (Inverse c) ->
          traverse (right about . Multiply i) h >>= right about . Primitive
      _ -> right about question,
    saying "reads-polynomials-backwards" $ \about question -> case question of
      Primitive h -> right about (Primitive (reverse h))
      FirstPrimitive n -> reverse <$> right about (FirstPrimitive n)
      _ -> right about question,
    ( "takes-irreducible-for-primitive",
      \about ->
        let these = map (irreducible about) [0 ..]
         in Says $ \question -> case question of
              Primitive h ->
                (|| (not (null h) && h `Set.member` (these !! (length h - 1))))
                  <$> right about (Primitive h)
              _ -> right about question
    ),
    saying "looks-for-roots-only" $ \about question -> case question of
      Primitive h -> (|| monicWithoutRoot about h) <$> right about (Primitive h)
      _ -> right about question,
    ofFirst "compares-from-the-lowest-degree" id,
    ofFirst "takes-the-sparsest-polynomial" (sortOn (\h -> (length (filter (> 0) h), reverse h))),
    saying "takes-the-constant-for-a-polynomial" $ \about question -> case question of
      FirstPrimitive 0 -> Right [1]
      _ -> right about question
  ]
  where
    order = profileOrder . knownProfile
    ofFirst :: String -> ([[Code]] -> [[Code]]) -> Sentence
    ofFirst name order' = saying name $ \about question -> case question of
      FirstPrimitive n
        | n > 0 ->
          maybe (refused "invalid") Right $
            find ((== Right True) . right about . Primitive) (order' (monics about n))
      _ -> right about question

monics :: Known -> Natural -> [[Code]]
monics about n = map (++ [1]) (replicateM (fromIntegral n) (elementsOf about))

elementsOf :: Known -> [Code]
elementsOf about = [0 .. profileOrder (knownProfile about) - 1]

-- | The monic polynomials of a degree with a constant term that are no product of two of lower
-- degree.
irreducible :: Known -> Int -> Set.Set [Code]
irreducible about n
  | n < 1 = Set.empty
  | otherwise =
    Set.fromList (filter ((> 0) . head) (monics about (fromIntegral n)))
      `Set.difference` Set.fromList
        [ product' f g
          | k <- [1 .. n `div` 2],
            f <- monics about (fromIntegral k),
            g <- monics about (fromIntegral (n - k))
        ]
  where
    product' f g =
      [ foldr
          (\(a, b) total -> plus (times a b) total)
          0
          [(f !! i, g !! (k - i)) | i <- [0 .. k], i < length f, k - i < length g]
        | k <- [0 .. length f + length g - 2]
      ]
    plus a b = either (const 0) id (right about (Add a b))
    times a b = either (const 0) id (right about (Multiply a b))

-- | Of a degree of 2 or more, and 0 at no element.
monicWithoutRoot :: Known -> [Code] -> Bool
monicWithoutRoot about h =
  length h > 2 && last h == 1 && all ((/= Right 0) . value) (elementsOf about)
  where
    value x = foldr (plusTimes x) (Right 0) h
    plusTimes x c total = total >>= right about . Multiply x >>= right about . Add c
