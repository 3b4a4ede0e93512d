-- | Looking for polynomials: in which order, how many there are, and certificates of what was
-- found.
module Test.Code.Polynomial.OrderAndCount (spec) where

import Control.Monad (forM_)
import Data.List (nub, sort, sortOn)
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Polynomial
import PraTactile.Polynomial.Certificate
import Test.Code.Generators
import Test.Effort
import Test.Hspec
import Test.Paper

spec :: Spec
spec = do
  describe "every field, every degree with q^n up to 4096" $ do
    it "enumeration finds phi(q^n - 1)/n primitive polynomials" $
      forM_ small $ \(q, n, SomeField k) ->
        (q, n, fmap (fromIntegral . length) (primitives k n)) `shouldBe` (q, n, countPrimitive k n)
    it "enumeration finds the irreducible polynomials of Gauss's formula, with all primitive ones" $
      forM_ small $ \(q, n, SomeField k) -> do
        let found = irreducibles k n
        (q, n, fromIntegral (length found)) `shouldBe` (q, n, countIrreducible k n)
        (q, n, fmap (filter (`notElem` found) . map primitivePolynomial) (primitives k n))
          `shouldBe` (q, n, Right [])
    it "the primitive polynomial of fewest terms is the first with that many terms" $
      forM_ small $ \(q, n, SomeField k) ->
        (q, n, primitivePolynomial <$> fewestTermsPrimitive n)
          `shouldBe` ( q,
                       n,
                       minimumOn (\h -> (terms h, h)) . map primitivePolynomial =<< primitives k n
                     )
  describe "candidates" $ do
    it "monicByTerms has each monic polynomial once, fewest terms first, then ascending" $
      forM_
        [(q, n, k) | (q, n, k) <- small, n >= 2, fromIntegral q ^ n <= (256 :: Natural)]
        $ \(q, n, SomeField k) ->
          (q, n, monicByTerms n)
            `shouldBe` ( q,
                         n,
                         sortOn (\h -> (terms h, h)) (filter ((/= 0) . (`valueAt` 0)) (monicIn k n))
                       )
    it "for degree 1, x comes first" $
      monicByTerms 1 `shouldBe` [polynomial [c, 1] | c <- elements :: [GF GF9]]
    it "randomMonics rejects draws that would favour small codes: 2^32 - 1 over GF(3)" $
      -- The seed was found by taking SplitMix64 back from an output with that upper half; the next
      -- upper halves are 1703949545, 804010876, 385077386, 3775114207, 3119737611 and 2590479931.
      take 1 (randomMonics 6204490082765445028 6)
        `shouldBe` [ polynomial
                       [either (const 0) id (fromCode c) | c <- [2, 1, 2, 1, 0, 1, 1]] ::
                       Polynomial GF3
                   ]
    it "randomMonics draws by SplitMix64: the published outputs, upper halves modulo q" $ do
      -- Outputs of Vigna's reference implementation in C.
      let published =
            [ 6457827717110365317,
              3203168211198807973,
              9817491932198370423,
              4593380528125082431,
              16408922859458223821
            ] ::
              [Integer]
      take 1 (randomMonics 1234567 5)
        `shouldBe` [ polynomial
                       ( map
                           ( either (const 0) id
                               . fromCode
                               . fromInteger
                               . (`mod` 256)
                               . (`div` 2 ^ (32 :: Int))
                           )
                           published
                           ++ [1]
                       ) ::
                       Polynomial
                         GF256
                   ]
      map
        toCode
        (concatMap (take 1 . coefficients) (take 5 (randomMonics 1234567 1 :: [Polynomial GF4])))
        `shouldBe` map (fromInteger . (`mod` 4) . (`div` 2 ^ (32 :: Int))) published
    it "randomPrimitive gives all primitive polynomials equally often: 4 quadratics" $ do
      let drawn =
            [ h
              | seed <- [1 .. 400],
                Right h <- [randomPrimitive seed 2 :: Either PolynomialError (Primitive GF4)]
            ]
      found <- right (primitivePolynomials 2)
      map (\h -> length (filter (== h) drawn)) found
        `shouldSatisfy` all (\times -> 70 <= times && times <= 130)
      length drawn `shouldBe` 400
    it "a draw depends on the seed alone, and different seeds give different draws" $ do
      let draw seed = randomPrimitive seed 40 :: Either PolynomialError (Primitive GF2)
      draw 7 `shouldBe` draw 7
      length (nub (map draw [1 .. 10])) `shouldBe` 10
  describe "leading coefficients without an irreducible polynomial" $ do
    it "no polynomial that the search skips is irreducible, each tested by itself" $
      [ (q, n, h :: String)
        | (q, SomeField k) <- everyField,
          n <- [1 .. byEffort 18 33],
          let run = reducibleRun k n,
          run > 0,
          (fromIntegral q :: Natural) ^ run <= byEffort 2000 5000,
          h <- map show (filter isIrreducible (take (q ^ run) (monicIn k (fromIntegral n))))
      ]
        `shouldBe` []
    it "affine x^(p^k) + ... + c are irreducible for k <= 1 and for p = k = 2 only" $
      forM_
        [ (2, 1),
          (2, 2),
          (2, 3),
          (2, 4),
          (2, 5),
          (4, 1),
          (4, 2),
          (4, 3),
          (4, 4),
          (8, 2),
          (8, 3),
          (16, 2),
          (3, 1),
          (3, 2),
          (3, 3),
          (9, 1),
          (9, 2),
          (27, 2),
          (5, 1),
          (5, 2),
          (7, 1),
          (7, 2)
        ]
        $ \(q, height) -> overField q $ \k -> do
          let p = fieldCharacteristic k
          (q, height, any isIrreducible (affine k p height))
            `shouldBe` (q, height, height <= 1 || p == 2 && height == 2)
    it "the search skips by three coefficients over GF(2^m) in degree 8 m', else by two" $
      [ (q, [(n, run) | n <- [1 .. 28], let run = reducibleRun k n, run > 0])
        | (q, SomeField k) <- everyField,
          q `elem` [2, 256, 3, 5, 243]
      ]
        `shouldBe` [ (2, [(8, 3), (10, 2), (16, 3), (18, 2), (24, 3), (26, 2)]),
                     (3, [(n, 2) | n <- [7, 9, 12, 19, 24, 27]]),
                     (5, [(n, 2) | n <- [10, 20, 25]]),
                     (243, [(n, 2) | n <- [7, 9, 12, 19, 24, 27]]),
                     (256, (6, 2) : [(n, if n `mod` 4 == 0 then 3 else 2) | n <- [8, 10 .. 28]])
                   ]
    it "every search finds the same without skipping, over GF(4), GF(3) and GF(2)" $ do
      let same :: forall k. KnownField k => Proxy k -> Natural -> Expectation
          same k n = do
            (n, take 100 (irreducibles k n))
              `shouldBe` (n, take 100 (filter isIrreducible (monicIn k n)))
            (n, fmap (take 20) (primitives k n))
              `shouldBe` (n, take 20 <$> primitiveAmong n (monicIn k n))
            (n, fmap (: []) (fewestTermsPrimitive n :: Either PolynomialError (Primitive k)))
              `shouldBe` (n, take 1 <$> primitiveAmong n (monicByTerms n))
      mapM_ (same gf4) [6, 8]
      mapM_ (same gf3) [7, 9]
      same gf2 16
    it "the first primitive polynomials of degrees 8 and 12 over GF(256) come at once" $ do
      codesOf (firstPrimitive 8 :: Either PolynomialError (Primitive GF256))
        `shouldBe` Right [9, 1, 0, 1, 0, 0, 0, 0, 1]
      h <- firstOver (Proxy :: Proxy GF256) 12
      drop 3 (coefficients (primitivePolynomial h)) `shouldBe` [1, 0, 0, 0, 0, 0, 0, 0, 0, 1]
  describe "known polynomials" $ do
    it "x^128 + x^7 + x^2 + x + 1 is the first primitive one, and of fewest terms" $ do
      h <- firstOver gf2 128
      exponents h `shouldBe` [0, 1, 2, 7, 128]
      fmap exponents (fewestTermsPrimitive 128 :: Either PolynomialError (Primitive GF2))
        `shouldBe` Right [0, 1, 2, 7, 128]
    it "those of fewest terms over GF(2) are the known trinomials, in degree 8 the pentanomial" $
      forM_
        [ (2, [1]),
          (3, [1]),
          (4, [1]),
          (5, [2]),
          (6, [1]),
          (7, [1]),
          (8, [2, 3, 4]),
          (9, [4]),
          (10, [3]),
          (11, [2]),
          (15, [1]),
          (17, [3]),
          (31, [3]),
          (89, [38])
        ]
        $ \(n, middle) ->
          fmap
            exponents
            (fewestTermsPrimitive (fromIntegral n) :: Either PolynomialError (Primitive GF2))
            `shouldBe` Right ([0] ++ middle ++ [n])
  describe "certificates" certificateSpec
  where
    codesOf = fmap (map toCode . coefficients . primitivePolynomial)
    -- Every one of degree p^height.
    affine :: forall k. KnownField k => Proxy k -> Int -> Int -> [Polynomial k]
    affine _ p height =
      [ polynomial (place 0 (c : lower ++ [one]))
        | c <- elements,
          lower <- mapM (const elements) [1 .. height]
      ]
      where
        -- The coefficients at the exponents 0, 1, p, p^2, ...
        place _ [] = []
        place at (c : others) = c : replicate (gap at others) zero ++ place (next at) others
        gap at others = if null others then 0 else next at - at - 1
        next at = if at == 0 then 1 else at * p
    exponents h = [i | (i, c) <- zip [0 :: Int ..] (coefficients (primitivePolynomial h)), c /= 0]

-- | Each field and degree with q^n at most 4096.
small :: [(Int, Natural, SomeField)]
small = [(q, n, k) | (q, k) <- everyField, n <- takeWhile (\m -> toInteger q ^ m <= 4096) [1 ..]]

primitives :: KnownField k => Proxy k -> Natural -> Either PolynomialError [Primitive k]
primitives _ = primitivePolynomials

irreducibles, monicIn :: KnownField k => Proxy k -> Natural -> [Polynomial k]
irreducibles _ = irreduciblePolynomials
monicIn _ = monicPolynomials

terms :: Polynomial k -> Int
terms = length . filter (/= zero) . coefficients

minimumOn :: Ord b => (a -> b) -> [a] -> Either PolynomialError a
minimumOn f list = case sortOn f list of
  a : _ -> Right a
  [] -> Left (NoPrimitivePolynomial 0)

certificateSpec :: Spec
certificateSpec = do
  it "of every primitive polynomial with q^n up to 512 are accepted" $
    forM_
      [s | s@(q, n, _) <- small, fromIntegral q ^ n <= (512 :: Natural)]
      $ \(q, n, SomeField k) ->
        ( q,
          n,
          fmap (filter (\h -> verifyPrimitive (certifyPrimitive h) /= Right h)) (primitives k n)
        )
          `shouldBe` (q, n, Right [])
  it "exist for every irreducible polynomial with q^n up to 512, and for no other one" $
    forM_
      [s | s@(q, n, _) <- small, fromIntegral q ^ n <= (512 :: Natural)]
      $ \(q, n, SomeField k) ->
        ( q,
          n,
          [ h
            | h <- monicIn k n,
              fmap verifyIrreducible (certifyIrreducible h)
                /= (if isIrreducible h then Just (Right ()) else Nothing)
          ]
        )
          `shouldBe` (q, n, [])
  it "of x^128 + x^7 + x^2 + x + 1 have residues for the nine primes of 2^128 - 1" $ do
    h <- firstOver gf2 128
    map fst (certifiedResidues (certifyPrimitive h))
      `shouldBe` [3, 5, 17, 257, 641, 65537, 274177, 6700417, 67280421310721]
    verifyPrimitive (certifyPrimitive h) `shouldBe` Right h
  it "of a primitive polynomial are refused if changed, with the reason" $ do
    h <- paperPrimitive
    let good = certifyPrimitive h
        verdict = either Just (const Nothing) . verifyPrimitive
        a = primitive :: GF GF4
    certifiedFactors good `shouldBe` [(3, 1), (5, 1), (17, 1)]
    verdict good `shouldBe` Nothing
    verdict good {certifiedPrimitive = polynomial [a]} `shouldBe` Just PolynomialUnfit
    verdict good {certifiedPrimitive = polynomial [a * a, a, 1, 0, a]}
      `shouldBe` Just PolynomialUnfit
    verdict good {certifiedPrimitive = polynomial [0, a, 1, 0, 1]} `shouldBe` Just PolynomialUnfit
    -- x^4 + 1 = (x + 1)^4.
    verdict good {certifiedPrimitive = polynomial [1, 0, 0, 0, 1]} `shouldBe` Just PowerDoesNotClose
    verdict good {certifiedFactors = [(3, 1), (5, 1)]} `shouldBe` Just (FactorsDoNotMultiply 15 255)
    verdict good {certifiedFactors = [(15, 1), (17, 1)]} `shouldBe` Just (FactorNotPrime 15)
    verdict good {certifiedFactors = [(1, 9), (3, 1), (5, 1), (17, 1)]}
      `shouldBe` Just (FactorNotPrime 1)
    verdict good {certifiedFactors = [(3, 1), (5, 1), (17, 1), (3, 0)]}
      `shouldBe` Just (FactorNotPrime 3)
    verdict good {certifiedResidues = drop 1 (certifiedResidues good)}
      `shouldBe` Just (EntryMissing 3)
    verdict good {certifiedResidues = (3, 1) : drop 1 (certifiedResidues good)}
      `shouldBe` Just (EntryWrong 3)
  it "do not exist for an irreducible polynomial that is not primitive" $ do
    -- x^4 + x^3 + x^2 + x + 1 divides x^5 - 1.
    let h = polynomial [1, 1, 1, 1, 1] :: Polynomial GF2
        residues = [(r, fromMaybe 0 (powerModulo h variable (15 `div` r))) | r <- [3, 5]]
    fmap (const ()) (verifyPrimitive (PrimitiveCertificate h [(3, 1), (5, 1)] residues))
      `shouldBe` Left (OrderLower 3)
  it "of an irreducible polynomial are refused if changed" $ do
    let h = polynomial [1, 1, 0, 0, 0, 0, 1] :: Polynomial GF2
    good <- maybe (fail "x^6 + x + 1 is irreducible") pure (certifyIrreducible h)
    sort (map fst (certifiedWitnesses good)) `shouldBe` [2, 3]
    verifyIrreducible good `shouldBe` Right ()
    verifyIrreducible good {certifiedIrreducible = 1} `shouldBe` Left PolynomialUnfit
    verifyIrreducible good {certifiedIrreducible = h + variable} `shouldBe` Left PowerDoesNotClose
    verifyIrreducible good {certifiedWitnesses = drop 1 (certifiedWitnesses good)}
      `shouldBe` Left (EntryMissing 2)
    verifyIrreducible
      good
        { certifiedWitnesses = [(l, (v, u)) | (l, (u, v)) <- certifiedWitnesses good]
        }
      `shouldBe` Left (EntryWrong 2)
