-- | Polynomials over GF(q), irreducible and primitive ones.
module Test.Code.Polynomial.RingAndOrders (spec) where

import Control.Monad (forM_)
import Data.List (find)
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Polynomial
import Test.Code.Generators
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  forM_ [4, 5, 9] $ \q -> forM_ (lookup q everyField) $ \(SomeField k) ->
    describe ("polynomials over GF(" ++ show q ++ ")") (ringSpec k)
  describe "the greatest common divisor over an extension field" $ do
    -- In a well-known library Euclid's algorithm does not end over GF(4): a remainder that is a
    -- constant other than 1 is never recognised as the last one.
    it "ends for all pairs of small degree, and is the largest monic common divisor" $
      forM_ [(4, 2), (9, 1)] $ \(q, top) -> overField q $ \k ->
        (q, take 1 (wrongDivisors k top)) `shouldBe` (q, [])
    it "is 1 where a remainder is a constant other than 1, in either order" $
      forM_ [4, 9, 16, 25] $ \q -> overField q $ \k ->
        ( q,
          [ c
            | c <- drop 1 (elementsIn k),
              or
                [ greatestCommonDivisor a b /= 1
                  | let f = variable * variable + variable,
                    (a, b) <-
                      [ (f + constant c, f),
                        (f, f + constant c),
                        (constant c, f),
                        (f, constant c),
                        (constant c, constant c)
                      ]
                ]
          ]
        )
          `shouldBe` (q, [])
  describe "irreducible polynomials" $ do
    it "are those that are not products: GF(2), GF(3), GF(4), GF(5), to degree 4, 3, 3, 2" $
      forM_ [(2, 4), (3, 3), (4, 3), (5, 2)] $ \(q, top) ->
        overField q $ \k ->
          forM_ [1 .. top] $ \n -> (q, n, irreducible k n) `shouldBe` (q, n, notProducts k n)
  describe "powers modulo h, unboxed and packed, equal those by long division" $
    forM_
      [ (2, [1, 2, 5, 63, 64, 65, 127, 128, 129]),
        (3, [1, 2, 7, 20]),
        (4, [1, 3, 32]),
        (25, [1, 4]),
        (256, [1, 2, 5])
      ]
      $ \(q, degrees) -> forM_ degrees $ \n ->
        it ("over GF(" ++ show q ++ "), degree " ++ show n) $
          withMaxSuccess 4 (ofField q (`powersAgree` n))
  describe "primitive polynomials" $ do
    it "are shown as Haskell expressions, in parentheses as an argument" $ do
      let h = polynomial [1, 1, 0, 1] :: Polynomial GF2
      [showsPrec d h "" | d <- [0, 10, 11]]
        `shouldBe` ["polynomial [1,1,0,1]", "polynomial [1,1,0,1]", "(polynomial [1,1,0,1])"]
      (signum h, signum (h - h), abs h) `shouldBe` (1, 0, h)
    it "do not exist in degree 0" $
      forM_ (fieldsUpTo 9) $ \(q, SomeField k) ->
        (q, countPrimitive k 0) `shouldBe` (q, Left PolynomialConstant)
    it "the paper's x^4 + x^2 + A x + A^2 is the first of 32 quartics over GF(4)" $ do
      paper <- paperPrimitive
      firstPrimitive 4 `shouldBe` Right paper
      fmap length (primitivePolynomials 4 :: Either PolynomialError [Primitive GF4])
        `shouldBe` Right 32
      map toCode (coefficients (primitivePolynomial paper)) `shouldBe` [3, 2, 1, 0, 1]
    it "have primitive reciprocals, and the reciprocal of the reciprocal is the polynomial" $
      forM_ [(2, 6), (3, 3), (4, 4), (9, 2)] $ \(q, n) ->
        overField q $ \k ->
          forM_ (primitives k n) $ \h -> do
            checkPrimitive (primitivePolynomial (reciprocal h)) `shouldBe` Right (reciprocal h)
            reciprocal (reciprocal h) `shouldBe` h
    it "one of degree 20 over GF(4) is found" $
      fmap period (firstPrimitive 20 :: Either PolynomialError (Primitive GF4))
        `shouldBe` Right (4 ^ (20 :: Int) - 1)
  describe "refusals" $ do
    let check :: [Natural] -> Either PolynomialError [Int]
        check codes =
          either (const (Left PolynomialConstant)) Right (polynomialFromCodes codes) >>= \h ->
            map toCode . coefficients . primitivePolynomial <$> checkPrimitive (h :: Polynomial GF4)
    it "constants, and the zero polynomial" $
      map check [[], [0], [1], [3]] `shouldBe` replicate 4 (Left PolynomialConstant)
    it "polynomials that are not monic" $
      check [3, 2, 1, 0, 2] `shouldBe` Left (PolynomialNotMonic 2)
    it "polynomials divisible by x, and x itself" $
      map check [[0, 1], [0, 2, 1]] `shouldBe` replicate 2 (Left ConstantTermZero)
    it "reducible polynomials" $ check [1, 0, 1] `shouldBe` Left PolynomialReducible
    it "irreducible polynomials whose root has a lower order, which is given" $
      -- x + 1 has the root 1; x^4 + x^3 + x^2 + x + 1 divides x^5 - 1.
      [check [1, 1], check2 [1, 1, 1, 1, 1]]
        `shouldBe` [Left (PolynomialNotPrimitive 1), Left (PolynomialNotPrimitive 5)]
    it "degree 0 has no primitive polynomials" $
      (() <$ (primitivePolynomials 0 :: Either PolynomialError [Primitive GF4]))
        `shouldBe` Left PolynomialConstant
    it "codes that are not elements" $
      (polynomialFromCodes [1, 4, 1] :: Either FieldError (Polynomial GF4))
        `shouldBe` Left (CodeOutOfRange 4 4)
  where
    check2 codes =
      either (const (Left PolynomialConstant)) Right (polynomialFromCodes codes) >>= \h ->
        map toCode . coefficients . primitivePolynomial <$> checkPrimitive (h :: Polynomial GF2)

genPolynomial :: KnownField k => Gen (Polynomial k)
genPolynomial = polynomial <$> (choose (0, 8) >>= genElements)

shrinkPolynomial :: KnownField k => Polynomial k -> [Polynomial k]
shrinkPolynomial = map polynomial . shrinkElements . coefficients

ringSpec :: forall k. KnownField k => Proxy k -> Spec
ringSpec _ = do
  it "a = b * quotient + remainder, and the remainder has a lower degree than b" $
    forAll2 $ \a b -> case quotientRemainder a b of
      Nothing -> b === 0
      Just (quotient, remainder) ->
        a === b * quotient + remainder
          .&&. property (polynomialDegree remainder < polynomialDegree b)
  it "gcd divides both and is monic, and gcd (a c) (b c) = c gcd a b, made monic" $
    forAll2 $ \a b ->
      let g = greatestCommonDivisor a b
          divides x = if g == 0 then x == 0 else fmap snd (quotientRemainder x g) == Just 0
          c = variable + 1
       in divides a
            && divides b
            && (g == 0 || isMonic g)
            && greatestCommonDivisor (a * c) (b * c) == g * c
  it "bezout a b = (g, u, v) with u a + v b = g = gcd a b" $
    forAll2 $ \a b ->
      let (g, u, v) =
            bezout a b
       in u * a + v * b === g .&&. g === greatestCommonDivisor a b
  it "u and v have least degree: u is 0 or of lower degree than b / g, and v than a / g" $
    forAll2 $ \a b ->
      a /= 0 && b /= 0
        ==> let (g, u, v) = bezout a b
                count p = length (coefficients p)
                lower p q = p == 0 || count p <= max 1 (count q - count g)
             in counterexample (show (g, u, v)) (lower u b && lower v a)
  it "the value at c is the remainder of division by x - c" $
    forAll2 $ \a _ ->
      forAll genElement $ \c ->
        Just (constant (valueAt a c)) === fmap snd (quotientRemainder a (polynomial [negate c, 1]))
  it "a (b + c) = a b + a c, a - b = a + negate b" $
    forAll2 $ \a b -> a * (b + a + 1) === a * b + a * a + a .&&. a - b === a + negate b
  it "the leading coefficient is not zero, and the coefficients make the polynomial again" $
    forAll2 $ \a b ->
      polynomial (coefficients (a * b)) === a * b
        .&&. property (take 1 (reverse (coefficients (a * b))) /= [zero])
  it "powerModulo h a e is a^e modulo h, by repeated multiplication" $
    forAll2 $ \a h -> forAll (choose (0, 12)) $ \e ->
      powerModulo h a (fromIntegral (e :: Int))
        === fmap snd (quotientRemainder (product (replicate e a)) h)
  where
    forAll2 :: Testable p => (Polynomial k -> Polynomial k -> p) -> Property
    forAll2 p =
      forAllShrink genPolynomial shrinkPolynomial $ \a ->
        forAllShrink genPolynomial shrinkPolynomial $ \b -> p a b

elementsIn :: KnownField k => Proxy k -> [GF k]
elementsIn _ = elements

-- | The pairs of polynomials up to a degree whose greatest common divisor is not the monic
-- polynomial of highest degree that divides both.
wrongDivisors :: forall k. KnownField k => Proxy k -> Int -> [(Polynomial k, Polynomial k)]
wrongDivisors _ top = [(a, b) | a <- list, b <- list, greatestCommonDivisor a b /= bySearch a b]
  where
    list = map polynomial (mapM (const elements) [0 .. top])
    monic =
      concatMap monicPolynomials [fromIntegral top, fromIntegral top - 1 .. 0] :: [Polynomial k]
    bySearch a b
      | a == 0 && b == 0 = 0
      | otherwise = fromMaybe 0 (find (\d -> divides d a && divides d b) monic)
    divides d a = fmap snd (quotientRemainder a d) == Just 0

-- | On random h of a degree, a and exponents.
powersAgree :: forall k. KnownField k => Proxy k -> Int -> Property
powersAgree _ n =
  forAll (vectorOf n genElement) $ \lower ->
    forAll (genElement `suchThat` (/= zero)) $ \leading ->
      forAll (vectorOf (n + 2) genElement) $ \a ->
        forAll (choose (0, if n > 32 then 10 ^ (4 :: Int) else 10 ^ (9 :: Int) :: Integer)) $ \e ->
          let h = polynomial (lower ++ [leading]) :: Polynomial k
              agreeing b =
                powerModulo h b (fromInteger e) === powerByDivision h b (fromInteger e)
           in agreeing (polynomial a) .&&. agreeing variable

-- | a^e modulo h by the definition: squaring and long division.
powerByDivision :: KnownField k => Polynomial k -> Polynomial k -> Natural -> Maybe (Polynomial k)
powerByDivision h a = go
  where
    reduce b = snd <$> quotientRemainder b h
    go 0 = reduce 1
    go e = do
      root <- go (e `div` 2)
      reduce (root * root * (if odd e then a else 1))

irreducible, notProducts :: KnownField k => Proxy k -> Natural -> [Polynomial k]
irreducible _ n = filter isIrreducible (monicPolynomials n)
notProducts _ n = [h | h <- monicPolynomials n, h `notElem` products]
  where
    products =
      [f * g | d <- [1 .. n `div` 2], f <- monicPolynomials d, g <- monicPolynomials (n - d)]

primitives :: KnownField k => Proxy k -> Natural -> [Primitive k]
primitives _ = either (const []) id . primitivePolynomials
