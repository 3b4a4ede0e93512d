{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}

-- | Fields, polynomials and factors against the facts in test/data, which were computed elsewhere;
-- each file says by what.
module Test.Code.Field.FactsFromElsewhere (spec) where

import Control.Monad (forM_)
import Data.Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (Parser, parseEither)
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Factorisation
import PraTactile.Field
import PraTactile.Field.Named (conwayModulus)
import PraTactile.Field.Structure
import PraTactile.Polynomial
import Test.Code.Generators (SomeField (..), everyField)
import Test.Hspec

spec :: Spec
spec = do
  describe "fields" $ do
    it "the default moduli" $
      records "fields" "conway" $ \o -> do
        q <- o .: "q"
        modulus <- (,) <$> o .: "p" <*> o .: "modulus"
        pure ((q :: Natural, conwayModulus q) `shouldBe` (q, Right modulus))
    it "sums, products, negatives, inverses, powers and orders" $
      records "fields" "fields" $ \o -> inField o $ \k -> do
        let everything = elementsOf k
            codes = map toCode
        negatives <- o .: "negatives"
        inverses <- o .: "inverses"
        powers <- o .: "powers"
        orders <- o .: "orders"
        generator <- o .: "primitive"
        sums <- o .:? "sums"
        products <- o .:? "products"
        rows <- o .:? "rows"
        pure $ do
          codes (map negate everything) `shouldBe` negatives
          map (either (const Nothing) (Just . toCode) . inverse) everything `shouldBe` inverses
          toCode (primitive `asTypeOf` oneOf k) `shouldBe` generator
          [toCode (exponential e `asTypeOf` oneOf k) | e <- [0 .. toInteger (fieldOrder k) - 2]]
            `shouldBe` powers
          map (either (const Nothing) Just . elementOrder) everything `shouldBe` orders
          fromMaybe [] sums
            `shouldBe` [codes [a + b | b <- everything] | a <- everything, Just _ <- [sums]]
          fromMaybe [] products
            `shouldBe` [codes [a * b | b <- everything] | a <- everything, Just _ <- [products]]
          forM_ (maybe [] KeyMap.toList rows) $ \(row, expected) ->
            either
              (const [])
              (\a -> codes [a `asTypeOf` oneOf k * b | b <- everything])
              (parseElement (Key.toString row))
              `shouldBe` expected
    it "traces, norms and minimal polynomials over GF(p)" $
      records "fields" "maps" $ \o -> inField o $ \k -> do
        let everything = elementsOf k
        traces <- o .: "traces"
        norms <- o .: "norms"
        minimal <- o .:? "minimal"
        pure $ do
          map (toCode . trace primeSubfield) everything `shouldBe` traces
          map (toCode . norm primeSubfield) everything `shouldBe` norms
          forM_ minimal (map (codesOf . minimalPolynomial primeSubfield) everything `shouldBe`)
  describe "polynomials" $ do
    it "all primitive polynomials of a degree, in their order" $
      records "polynomials" "primitives" $ \o -> inField o $ \k -> do
        n <- o .: "degree"
        expected <- o .: "polynomials"
        pure
          ( fmap (map (codesOf . primitivePolynomial)) (primitivePolynomials n `over` k)
              `shouldBe` Right expected
          )
    it "the first primitive polynomial of a degree" $
      records "polynomials" "first_primitives" $ \o -> inField o $ \k -> do
        n <- o .: "degree"
        expected <- o .: "polynomial"
        pure
          (fmap (codesOf . primitivePolynomial) (firstPrimitive n `at` k) `shouldBe` Right expected)
    it "the numbers of irreducible and of primitive polynomials" $
      records "polynomials" "counts" $ \o -> inField o $ \k -> do
        n <- o .: "degree"
        irreducible <- o .: "irreducible"
        primitives <- o .: "primitive"
        pure ((countIrreducible k n, countPrimitive k n) `shouldBe` (irreducible, Right primitives))
    it "quotients, remainders and greatest common divisors" $
      records "polynomials" "arithmetic" $ \o -> inField o $ \k -> do
        a <- inRing k =<< o .: "a"
        b <- inRing k =<< o .: "b"
        quotient <- o .: "quotient"
        remainder <- o .: "remainder"
        divisor <- o .: "gcd"
        pure $ do
          fmap (\(u, v) -> (codesOf u, codesOf v)) (quotientRemainder a b)
            `shouldBe` Just (trimmed quotient, trimmed remainder)
          codesOf (greatestCommonDivisor a b) `shouldBe` divisor
  describe "factors" $
    it "of p^n - 1, except 2^121 - 1, which has a factor not proved prime" $
      records "factorisations" "factorisations" $ \o -> do
        p <- o .: "p"
        n <- o .: "n"
        factors <- o .: "factors"
        let known = [(read prime, e) | (prime, e) <- factors]
        pure $
          (p, n, factorisePowerMinusOne p n)
            `shouldBe` ( p,
                         n,
                         if (p, n) == (2, 121)
                           then Left (PrimalityUndecided (maximum (map fst known)))
                           else Right known
                       )
  where
    over :: Either PolynomialError [Primitive k] -> Proxy k -> Either PolynomialError [Primitive k]
    over found _ = found
    at :: Either PolynomialError (Primitive k) -> Proxy k -> Either PolynomialError (Primitive k)
    at found _ = found
    inRing :: KnownField k => Proxy k -> [Natural] -> Parser (Polynomial k)
    inRing _ = either (fail . show) pure . polynomialFromCodes
    -- The zero polynomial is written 0 there.
    trimmed codes = if codes == [0] then [] else codes

-- | Check every record under a key of a file.
records :: FilePath -> Key -> (Object -> Parser Expectation) -> Expectation
records file name check = do
  content <- eitherDecodeFileStrict ("test/data/" ++ file ++ ".json") >>= either fail pure
  found <- either fail pure (parseEither (.: name) content) :: IO [Object]
  found `shouldSatisfy` (not . null)
  forM_ found (either expectationFailure id . parseEither check)

-- | In the field of a record, whose modulus must be the default one.
inField :: Object -> (forall k. KnownField k => Proxy k -> Parser a) -> Parser a
inField o use = do
  q <- o .: "q"
  modulus <- o .: "modulus"
  case lookup q everyField of
    Just (SomeField k) | fieldModulus k == modulus -> use k
    _ -> fail ("no default field of " ++ show q ++ " elements has the modulus " ++ show modulus)

codesOf :: Polynomial k -> [Int]
codesOf = map toCode . coefficients

elementsOf :: KnownField k => Proxy k -> [GF k]
elementsOf _ = elements

oneOf :: Proxy k -> GF k
oneOf _ = one
