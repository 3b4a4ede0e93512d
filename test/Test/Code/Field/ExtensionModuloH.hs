-- | GF(q^n) modulo a primitive polynomial, and logarithms in it.
module Test.Code.Field.ExtensionModuloH (spec) where

import Control.Monad (forM_)
import Data.List (foldl')
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.DiscreteLog
import PraTactile.Extension
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Polynomial
import Test.Code.Generators
import Test.Effort
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe "GF(q^n)" $ do
    beforeAll paperPrimitive . it "alpha^i alpha^j = alpha^(i+j), with n coefficients" $ \h ->
      property $ \(NonNegative i) (NonNegative j) ->
        let power' e = powerOfRoot h (fromInteger e)
         in multiplyModulo h (power' i) (power' j) == power' (i + j)
              && length (residueCoefficients h (power' i)) == 4
    it "residues and their products equal those of polynomials by long division" $
      forM_ samples $ \(q, n, SomeField k) -> do
        h <- firstOver k n
        ( q,
          n,
          [ ()
            | (a, b) <- pairs h,
              residue h (a * b) /= multiplyModulo h (residue h a) (residue h b)
                || polynomial (residueCoefficients h (residue h (a * b))) /= remainder h (a * b)
          ]
          )
          `shouldBe` (q, n, [])
    it "a residue is shown as a Haskell expression, in parentheses as an argument" $ do
      h <- paperPrimitive
      let a = residue h (polynomial [one, primitive])
      showsPrec 11 a "" `shouldBe` "(" ++ show a ++ ")"
      showsPrec 10 a "" `shouldBe` show a
    it "sums equal the sums of polynomials" $
      forM_ samples $ \(q, n, SomeField k) -> do
        h <- firstOver k n
        ( q,
          n,
          [() | (a, b) <- pairs h, addModulo h (residue h a) (residue h b) /= residue h (a + b)]
          )
          `shouldBe` (q, n, [])
    it "powers of alpha equal powers of x by squaring and long division" $
      forM_ samples $ \(q, n, SomeField k) -> do
        h <- firstOver k n
        ( q,
          n,
          [ e
            | e <- [0 .. 20] ++ [200, 1003],
              powerOfRoot h e /= residue h (powerByDivision h variable e)
          ]
          )
          `shouldBe` (q, n, [])
    it "powers are repeated products; the powers 0 and q^n - 1 are 1, but for zero" $
      forM_ samples $ \(q, n, SomeField k) -> do
        h <- firstOver k n
        let some = [residue h a | (a, _) <- take 6 (pairs h)]
        ( q,
          n,
          [ e
            | a <- some,
              e <- [0 .. 20],
              powerOfResidue h a e /= iterate (multiplyModulo h a) (residue h 1) !! fromIntegral e
          ]
          )
          `shouldBe` (q, n, [])
        ( q,
          n,
          [ a
            | a <- some,
              powerOfResidue h a (period h) /= (if a == residue h 0 then a else residue h 1)
          ]
          )
          `shouldBe` (q, n, [])
    forM_ [(q, n) | (q, n, _) <- samples, q == 2 || n <= 7] $ \(q, n) ->
      it ("powers have exponents of up to 300 bits: GF(" ++ show q ++ "^" ++ show n ++ ")") $
        withMaxSuccess (byEffort 1 2) $
          ofField q $ \k ->
            whenRight (firstPrimitive n) (wideExponents . (`over` k))
    it "every element but zero has its inverse, for q^n up to 4096" $
      forM_
        [s | s@(q, n, _) <- samples, fromIntegral q ^ n <= (4096 :: Natural)]
        $ \(q, n, SomeField k) -> do
          h <- firstOver k n
          let everything =
                residue h 0 :
                take
                  (fromIntegral (period h))
                  (iterate (multiplyModulo h (powerOfRoot h 1)) (residue h 1))
          ( q,
            n,
            [ a
              | a <- everything,
                fmap (multiplyModulo h a) (inverseModulo h a)
                  /= (if a == residue h 0 then Left DivisionByZero else Right (residue h 1))
            ]
            )
            `shouldBe` (q, n, [])
    it "frobenius is the q-th power, an automorphism that fixes GF(q)" $
      forM_ samples $ \(q, n, SomeField k) -> do
        h <- firstOver k n
        ( q,
          n,
          [ ()
            | (a, b) <-
                pairs h,
              let f = frobeniusModulo h; r = residue h,
              f (r a) /= powerOfResidue h (r a) (fromIntegral q)
                || f (r (a + b))
                /= addModulo h (f (r a)) (f (r b))
                || f (r (a * b))
                /= multiplyModulo h (f (r a)) (f (r b))
          ]
          )
          `shouldBe` (q, n, [])
    it "the trace is the sum of the conjugates, the norm their product, and both lie in GF(q)" $
      forM_ samples $ \(q, n, SomeField k) -> do
        h <- firstOver k n
        ( q,
          n,
          [ ()
            | (a, _) <-
                pairs h,
              let conjugates = take (fromIntegral n) (iterate (frobeniusModulo h) (residue h a)),
              foldr (addModulo h) (residue h 0) conjugates
                /= residue h (constant (traceModulo h (residue h a)))
                || foldr (multiplyModulo h) (residue h 1) conjugates
                  /= residue h (constant (normModulo h (residue h a)))
          ]
          )
          `shouldBe` (q, n, [])
    it "the norm of alpha is (-1)^n h(0)" $
      forM_ samples $ \(q, n, SomeField k) -> do
        h <- firstOver k n
        (q, n, normModulo h (powerOfRoot h 1))
          `shouldBe` (q, n, power (-1) n * valueAt (primitivePolynomial h) 0)
    it "the traces of the powers of alpha obey the recurrence of h" $
      forM_ samples $ \(q, n, SomeField k) -> do
        h <- firstOver k n
        let traces = [traceModulo h (powerOfRoot h e) | e <- [0 .. 2 * n]]
        (q, n, take (fromIntegral n) traces) `shouldBe` (q, n, Primitive.toList (tracesOfPowers h))
        ( q,
          n,
          [ i
            | i <- [0 .. fromIntegral n],
              sum (zipWith (*) (coefficients (primitivePolynomial h)) (drop i traces)) /= 0
          ]
          )
          `shouldBe` (q, n, [])
    it "a residue of another h is taken as its representing polynomial" $ do
      small <- firstOver gf4 2
      large <- firstOver gf4 5
      let foreign' = powerOfRoot large 1000
          own = residue small (polynomial (residueCoefficients large foreign'))
      multiplyModulo small foreign' foreign' `shouldBe` multiplyModulo small own own
      multiplyModulo large own own
        `shouldBe` residue
          large
          (polynomial (residueCoefficients small own) * polynomial (residueCoefficients small own))
      length (residueCoefficients large own) `shouldBe` 5
  describe "discrete logarithms" logarithmSpec
  where
    over :: Primitive k -> Proxy k -> Primitive k
    over h _ = h

logarithmSpec :: Spec
logarithmSpec = do
  it "of alpha^t is t, for every t and the first primitive polynomial, q^n up to 1024" $
    forM_
      [(q, n, k) | (q, k) <- everyField, n <- takeWhile (\m -> toInteger q ^ m <= 1024) [1 ..]]
      $ \(q, n, SomeField k) -> do
        h <- firstOver k n
        logarithms <- right (prepareLogarithms h)
        let states =
              takeWhile' (period h) (iterate (multiplyModulo h (powerOfRoot h 1)) (residue h 1))
        (q, n, [t | (t, a) <- zip [0 ..] states, logarithmFrom logarithms a /= Right t])
          `shouldBe` (q, n, [])
  it "of all 255 states in the paper's field, one at a time" $ do
    h <- paperPrimitive
    [t | t <- [0 .. 254], discreteLogarithm h (powerOfRoot h t) /= Right t] `shouldBe` []
  it "of positions of any size, in fields from GF(9^13) to GF(2^64)" $ do
    -- 2^31 - 1 is prime itself.
    largeLogarithms gf2 31
    largeLogarithms gf2 64
    largeLogarithms (Proxy :: Proxy GF9) 13
    whenFull $ do
      largeLogarithms gf4 32
      largeLogarithms gf3 20
      largeLogarithms (Proxy :: Proxy GF5) 17
      largeLogarithms (Proxy :: Proxy GF16) 15
  it "for any number of stored baby steps, below or above the prime's root" $
    forM_ [(2, 8), (3, 4), (4, 4), (7, 3)] $ \(q, n) -> forM_ (lookup q everyField) $
      \(SomeField k) -> do
        h <- firstOver k n
        forM_ [0, 1, 2, 3, 4, 5, 16, 17, 1000] $ \most -> do
          logarithms <- right (prepareLogarithmsWith most h)
          let wrong = [t | t <- below (period h), failsAt logarithms h t]
          (q, n, most, wrong) `shouldBe` (q, n, most, [])
  it "by a small table if the largest prime is between 2^36 and 2^40" $ do
    -- (3^41 - 1) and (5^23 - 1) have such a prime r; modulo it these logarithms are small, so that
    -- their giant steps are few, but more than there are baby steps.
    farBeyond gf3 41 86950696619
    whenFull (farBeyond (Proxy :: Proxy GF5) 23 332207361361)
  it "of zero do not exist" $ do
    h <- paperPrimitive
    discreteLogarithm h (residue h 0) `shouldBe` Left LogarithmOfZero
  it "are refused if a prime beyond 2^40 divides q^n - 1, with that prime" $ do
    h <- firstOver gf2 61
    discreteLogarithm h (powerOfRoot h 5)
      `shouldBe` Left (LogarithmInfeasible (2 ^ (61 :: Int) - 1) (2 ^ (40 :: Int)))
    h' <- firstOver gf2 128
    discreteLogarithm h' (powerOfRoot h' 5)
      `shouldBe` Left (LogarithmInfeasible 67280421310721 (2 ^ (40 :: Int)))
  where
    takeWhile' count = map snd . takeWhile ((< count) . fst) . zip [0 ..]

farBeyond :: forall k. KnownField k => Proxy k -> Natural -> Natural -> Expectation
farBeyond k n r = do
  h <- firstOver k n
  maximum (map fst (periodFactors h)) `shouldBe` r
  forM_ [2 ^ (6 :: Int), 2 ^ (10 :: Int)] $ \most -> do
    logarithms <- right (prepareLogarithmsWith most h)
    let cofactor = period h `div` r
        some = [0, 1, most - 1, most, most + 1, most * most + 3, 17 * most * most `div` 2]
        failing =
          [ t
            | (i, small) <- zip [0 ..] some,
              let t = small + r * ((cofactor * i `div` 7 + i * i) `mod` cofactor),
              failsAt logarithms h t
          ]
    failing `shouldBe` []

-- | Whether what is told as the logarithm of alpha^t is another number, or none.
failsAt :: KnownField k => Logarithms k -> Primitive k -> Natural -> Bool
failsAt logarithms h t = logarithmFrom logarithms (powerOfRoot h t) /= Right t

largeLogarithms :: forall k. KnownField k => Proxy k -> Natural -> Expectation
largeLogarithms k n = do
  h <- firstOver k n
  logarithms <- right (prepareLogarithms h)
  let failing =
        [ t
          | i <- [0 .. 10],
            let t = (period h * i `div` 7 + i * i) `mod` period h,
            failsAt logarithms h t
        ]
  failing `shouldBe` []

-- | Powers of x and of a random polynomial modulo h, for exponents about every width of whole words
-- and some of 128 to 300 bits: the product of those squares of squares that the binary digits name.
wideExponents :: forall k. KnownField k => Primitive k -> Property
wideExponents h =
  forAll (vectorOf (primitiveDegree h) genElement) $ \a ->
    forAll ((++) <$> vectorOf each (QuickCheck.elements about) <*> vectorOf each between) $
      agree (squares variable) (polynomial a) (squares (polynomial a))
  where
    each = byEffort 1 3
    agree :: [Polynomial k] -> Polynomial k -> [Polynomial k] -> [Natural] -> Property
    agree ofX a ofA exponents =
      conjoin
        [ powerOfRoot h e === residue h (byDigits ofX e)
            .&&. powerOfResidue h (residue h a) e === residue h (byDigits ofA e)
          | e <- exponents
        ]
    squares a = iterate (\b -> times b b) (remainder h a)
    byDigits powers e = foldl' times (remainder h 1) [b | (b, d) <- zip powers (digits e), odd d]
    digits e = takeWhile (> 0) (iterate (`div` 2) e)
    times a b = remainder h (a * b)
    about = [2 ^ width + d - 1 | width <- [63, 64, 127, 128, 192, 256 :: Int], d <- [0, 1, 2]]
    between = do
      width <- choose (127, 299 :: Int)
      fromInteger . (2 ^ width +) <$> choose (0, 2 ^ width - 1)

-- | Fields and degrees, some about a machine word.
samples :: [(Int, Natural, SomeField)]
samples =
  [ (q, n, k)
    | (q, degrees) <-
        [ (2, [1, 2, 8, 10, 63, 64, 65]),
          (3, [1, 2, 7, 20]),
          (4, [1, 4, 5, 16]),
          (5, [3]),
          (8, [4]),
          (9, [3]),
          (25, [2]),
          (256, [1, 3])
        ],
      Just k <- [lookup q everyField],
      n <- degrees
  ]

-- | Some pairs of polynomials, of degrees up to about 1.5 n, zero and one among them.
pairs :: forall k. KnownField k => Primitive k -> [(Polynomial k, Polynomial k)]
pairs h = zip some (drop 3 (cycle some))
  where
    n = fromIntegral (primitiveDegree h)
    some =
      [0, 1, variable, -1]
        ++ take 4 (randomMonics 1 (n - 1))
        ++ take 2 (randomMonics 2 n)
        ++ take 2 (randomMonics 3 (n + n `div` 2))

remainder :: KnownField k => Primitive k -> Polynomial k -> Polynomial k
remainder h a = maybe a snd (quotientRemainder a (primitivePolynomial h))

powerByDivision :: KnownField k => Primitive k -> Polynomial k -> Natural -> Polynomial k
powerByDivision h a e
  | e == 0 = remainder h 1
  | otherwise =
    let root =
          powerByDivision h a (e `div` 2)
     in remainder h (root * root * (if odd e then a else 1))
