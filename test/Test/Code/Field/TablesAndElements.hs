{-# OPTIONS_GHC -O1 #-}

-- | The fields: the tables of all of them beside the definition, the default moduli, elements and
-- refusals. That each operation is what it should be, field axioms among it, is a law of the
-- conformance suite.
module Test.Code.Field.TablesAndElements (spec) where

import Control.Monad (forM_)
import Data.Either (isRight)
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Field
import qualified PraTactile.Field.Definition as Definition
import PraTactile.Field.Named
import PraTactile.Field.Vector
import Test.Code.Generators
import Test.Effort
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe "the tables equal the definition" $ do
    it "for sums and products of all 70 fields up to 256 elements" $
      forM_ everyField $ \(q, SomeField k) -> (q, differences k) `shouldBe` (q, [])
    it "for the fields of the named types" $
      forM_ namedFields $ \(q, SomeField k) -> (q, differences k) `shouldBe` (q, [])
    it "for fields chosen at run time with a modulus that is not the default one" $
      forM_
        [(2, [1, 0, 0, 1, 1]), (3, [1, 0, 1]), (5, [2, 0, 1]), (2, [1, 1, 0, 1, 1, 0, 0, 0, 1])]
        $ \(p, f) ->
          withField p f (\k -> (fieldModulus k, differences k)) `shouldBe` Right (f, [])
  it "vectors are combined element by element, up to the end of the shorter one" $
    forM_ [2, 3, 4, 9, 16, 256] $ \q -> overField q $ \(_ :: Proxy k) -> do
      let some n = take n (cycle (drop (n `mod` q) elements)) :: [GF k]
          packed = Primitive.fromList
          both f g = \a b -> (Primitive.toList (f (packed a) (packed b)), zipWith g a b)
      forM_ [(some i, some j) | i <- [0, 1, 5, 300], j <- [0, 1, 7, 299]] $ \(a, b) -> do
        let ways = [both addVectors (+), both subtractVectors (-), both multiplyVectors (*)]
        forM_ [way a b | way <- ways] $ \(fast, plain) -> fast `shouldBe` plain
        forM_ (take 4 elements) $ \c ->
          Primitive.toList (scaleVector c (Primitive.fromList a)) `shouldBe` map (c *) a
  describe "default moduli" $ do
    it "exist for each prime power up to 256 and for no other order" $
      [q | q <- [0 .. 256], isRight (conwayModulus q)] `shouldBe` primePowers
    it "the named types carry them" $
      [ (q, Just (fromIntegral (fieldCharacteristic k), fieldModulus k))
        | (q, SomeField k) <- namedFields
      ]
        `shouldBe` [(q, lookup q conwayModuli) | (q, _) <- namedFields]
    it "the primitive element is A, the root of the modulus" $
      forM_ everyField $ \(q, SomeField k) -> (q, toCode (primitiveOf k)) `shouldBe` (q, rootCode k)
  describe "elements" elementSpec
  describe "refusals" refusalSpec

primitiveOf :: KnownField k => Proxy k -> GF k
primitiveOf _ = primitive

-- | The code of A: x itself, or for a prime field the root of x + c.
rootCode :: KnownField k => Proxy k -> Int
rootCode k
  | fieldDegree k == 1 =
    (fieldOrder k - fromIntegral (sum (take 1 (fieldModulus k)))) `mod` fieldOrder k
  | otherwise = fieldCharacteristic k

-- | The pairs of codes whose sum or product is not that of the definition. In a quick run each
-- element of a larger field is paired with some.
differences :: forall k. KnownField k => Proxy k -> [(Int, Int)]
differences k =
  [ (toCode a, toCode b)
    | (a, a') <- both,
      (b, b') <- byEffort some id both,
      fromIntegral (toCode (a + b)) /= Definition.toCode ring (Definition.add ring a' b')
        || fromIntegral (toCode (a * b)) /= Definition.toCode ring (Definition.multiply ring a' b')
  ]
  where
    ring = Definition.Ring (fromIntegral (fieldCharacteristic k)) (fieldModulus k)
    some = map snd . filter (\(i, _) -> i < few || i `mod` 7 == 0) . zip [0 ..]
    few = if fieldOrder k <= 32 then 32 else 4 :: Int
    both = [(a, Definition.fromCode ring (fromIntegral (toCode a))) | a <- elements :: [GF k]]

isPrime' :: Natural -> Bool
isPrime' p = p > 1 && all (\d -> p `mod` d /= 0) [2 .. p - 1]

primePowers :: [Natural]
primePowers =
  [ q
    | q <- [2 .. 256],
      let p = smallestDivisor q,
      all (\d -> d `mod` p == 0) [d | d <- [2 .. q], q `mod` d == 0]
  ]
  where
    smallestDivisor q = foldr const q [d | d <- [2 .. q], q `mod` d == 0]

elementSpec :: Spec
elementSpec = do
  it "fromCode . toCode = Right, and no other code is accepted" $
    forM_ everyField $ \(q, SomeField k) ->
      [c | c <- [-3 .. 300], isRight (codeIn k c)] `shouldBe` [0 .. q - 1]
  it "parseElement . showElement = Right, in every field" $
    forM_ everyField $ \(q, SomeField k) -> (q, roundTrips k) `shouldBe` (q, True)
  it "parseElement reads the code of every element" $
    forM_ everyField $ \(q, SomeField k) -> (q, readsCodes k) `shouldBe` (q, True)
  it "GF(4) prints as 0, 1, A, A^2 and GF(5) as 0, 1, A, A^3, A^2" $ do
    map showElement (elements :: [GF GF4]) `shouldBe` ["0", "1", "A", "A^2"]
    map showElement (elements :: [GF GF5]) `shouldBe` ["0", "1", "A", "A^3", "A^2"]
  it "exponents and leading zeros of any length are read" $ do
    (parseElement ("A^" ++ show (10 ^ (40 :: Int) + 2 :: Integer)) :: Either FieldError (GF GF4))
      `shouldBe` Right 1
    (parseElement (replicate 50 '0' ++ "3") :: Either FieldError (GF GF4)) `shouldBe` fromCode 3
  it "other texts are refused" $
    forM_
      ["", " ", "A^", "A^-1", "a", "B", "-1", "1.0", "A2", "A^A", "1 ", "+1", "0x1", "A^1 "]
      $ \text ->
        (parseElement text :: Either FieldError (GF GF4)) `shouldBe` Left (ElementUnreadable text)
  it "codes not below q are refused as such" $
    forM_ [4, 5, 255, 1000, 1004, 10 ^ (30 :: Int)] $ \c ->
      (parseElement (show c) :: Either FieldError (GF GF4)) `shouldBe` Left (CodeOutOfRange c 4)
  it "fromInteger is the ring map from Z" $
    forAll (QuickCheck.elements (map fst (fieldsUpTo 27))) $ \q -> ofField q ringMap
  it "2 is 0 in GF(4) and -1 is 2 in GF(3)" $ do
    (2 :: GF GF4) `shouldBe` zero
    map toCode [-1 :: GF GF3] `shouldBe` [2]
  it "signum is 0 for 0, and 1 for all other elements" $
    forM_ everyField $ \(q, SomeField k) ->
      (q, map signum (elementsOf k)) `shouldBe` (q, zero : map (const one) (drop 1 (elementsOf k)))
  it "abs x * signum x = x" $
    forM_ everyField $ \(q, SomeField k) ->
      (q, [() | x <- elementsOf k, abs x * signum x /= x]) `shouldBe` (q, [])

elementsOf :: KnownField k => Proxy k -> [GF k]
elementsOf _ = elements

codeIn :: KnownField k => Proxy k -> Int -> Either FieldError Int
codeIn k c = toCode . (`asTypeOf` primitiveOf k) <$> fromCode c

roundTrips, readsCodes :: KnownField k => Proxy k -> Bool
roundTrips k = and [parseElement (showElement a) == Right a | a <- elementsOf k]
readsCodes k = and [parseElement (show (toCode a)) == Right a | a <- elementsOf k]

ringMap :: forall k. KnownField k => Proxy k -> Property
ringMap k = property $ \m n ->
  (fromInteger (m + n) :: GF k) == fromInteger m + fromInteger n
    && (fromInteger (m * n) :: GF k) == fromInteger m * fromInteger n
    && fromInteger (m * toInteger (fieldCharacteristic k)) == (zero :: GF k)

refusalSpec :: Spec
refusalSpec = do
  it "p must be a prime: everything else up to 256 is refused" $
    [p | p <- [0 .. 256], refusal p [0, 1] /= Just (NotPrime p)]
      `shouldBe` filter isPrime' [2 .. 256]
  it "the order must not exceed 256, however large p or the degree are" $ do
    refusal 257 [3, 1] `shouldBe` Just (FieldTooLarge 257 1)
    refusal (10 ^ (100 :: Int)) [1, 1] `shouldBe` Just (FieldTooLarge (10 ^ (100 :: Int)) 1)
    refusal 17 [3, 1, 1] `shouldBe` Just (FieldTooLarge 17 2)
    refusal 2 (replicate 10 1) `shouldBe` Just (FieldTooLarge 2 9)
    refusal 2 (repeat 1) `shouldBe` Just (FieldTooLarge 2 9)
  it "the modulus must have degree at least 1" $ do
    refusal 2 [] `shouldBe` Just (ModulusConstant [])
    refusal 2 [1] `shouldBe` Just (ModulusConstant [1])
  it "the modulus must be monic" $ do
    refusal 3 [1, 0, 2] `shouldBe` Just (ModulusNotMonic 2)
    refusal 2 [1, 1, 0] `shouldBe` Just (ModulusNotMonic 0)
  it "its coefficients must be below p" $
    refusal 2 [1, 2, 1] `shouldBe` Just (CoefficientOutOfRange 2 2)
  it "it must be irreducible: of all monic moduli, exactly the products are refused" $
    forM_ [(2, 2), (2, 3), (2, 4), (2, 5), (3, 2), (3, 3), (5, 2), (7, 2)] $ \(p, m) ->
      [f | f <- monic p m, refusal p f == Just (ModulusReducible p f)]
        `shouldBe` filter (`elem` products p m) (monic p m)
  it "all other moduli of these degrees give fields" $
    forM_ [(2, 4), (3, 3), (5, 2)] $ \(p, m) ->
      [f | f <- monic p m, isRight (withField p f (const ()))]
        `shouldBe` filter (`notElem` products p m) (monic p m)
  it "a / b times b is a, and division by 0 is refused, in any field" $
    forM_ everyField $ \(q, SomeField k) -> do
      let wrong a b =
            either (== DivisionByZero) (const False) (divide a b) /= (b == zero)
              || either (const False) ((/= a) . (* b)) (divide a b)
      (q, [(a, b) | a <- take 20 (elementsOf k), b <- elementsOf k, wrong a b]) `shouldBe` (q, [])
  it "orders that are not prime powers, or too large, have no default modulus" $ do
    conwayModulus 6 `shouldBe` Left (NotAPrimePower 6)
    conwayModulus 1 `shouldBe` Left (NotAPrimePower 1)
    conwayModulus 289 `shouldBe` Left (FieldTooLarge 289 1)
  where
    refusal p f = either Just (const Nothing) (withField p f (const ()))
    monic :: Natural -> Int -> [[Natural]]
    monic p m = map (++ [1]) (mapM (const [0 .. p - 1]) [1 .. m])
    products p m = [times p f g | d <- [1 .. m `div` 2], f <- monic p d, g <- monic p (m - d)]
    times p f g =
      [ sum [a * b | (i, a) <- zip [0 :: Int ..] f, (j, b) <- zip [0 ..] g, i + j == l] `mod` p
        | l <- [0 .. length f + length g - 2]
      ]
