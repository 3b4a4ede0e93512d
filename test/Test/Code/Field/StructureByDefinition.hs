{-# LANGUAGE RankNTypes #-}

-- | Orders, automorphisms, subfields, trace, norm, minimal polynomials, and one field in another.
module Test.Code.Field.StructureByDefinition (spec) where

import Control.Monad (forM_)
import Data.List (find, group, nub, sort)
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Embedding
import PraTactile.Field.Named
import PraTactile.Field.Structure
import PraTactile.Polynomial
import Test.Code.Generators
import Test.Hspec

spec :: Spec
spec = do
  describe "the multiplicative group, of every field up to 256" $ do
    it "the order of a is the least n >= 1 with a^n = 1; zero has none" $
      everyFieldHas $ \k -> exceptions [a | a <- elementsOf k, elementOrder a /= byMultiplying a]
    it "exponential (logarithm a) = a, and exponential (i + j) = exponential i exponential j" $
      everyFieldHas $ \k ->
        exceptions
          [ a
            | a <-
                drop 1 (elementsOf k),
              fmap (exponential . fromIntegral) (logarithm a) /= Just a
                || fmap (\l -> exponential (fromIntegral (negate l))) (logarithm a)
                  /= either (const Nothing) Just (inverse a)
          ]
    it "the primitive elements are those of order q - 1, and 'primitive' is the first of them" $
      everyFieldHas $ \k ->
        exceptions
          [() | find isPrimitiveElement (elementsOf k) /= Just (primitive `asTypeOf` oneOf k)]
  describe "the Frobenius automorphism, of every field up to 256" $ do
    it "the i-th is the p-th power, applied i times, for i of any size" $
      everyFieldHas $ \k ->
        exceptions
          [ (i, a)
            | i <-
                [0 .. 9],
              a <- elementsOf k,
              frobeniusPower (fromIntegral i) a
                /= iterate (\b -> power b (fromIntegral (fieldCharacteristic k))) a !! i
          ]
  describe "subfields, of every field up to 256" $ do
    it "each divisor d of m has one subfield, closed and with p^d elements" $
      everyFieldHas $ \k ->
        let m = fromIntegral (fieldDegree k)
         in exceptions $
              [() | map subfieldDegree (subfieldsOf k) /= [d | d <- [1 .. m], m `mod` d == 0]]
                ++ [ ()
                     | s <- subfieldsOf k,
                       let members = subfieldElements s,
                       fromIntegral (length members) /= subfieldOrder s
                         || or
                           [ not (inSubfield s (a + b) && inSubfield s (a * b))
                             | a <- members,
                               b <- members
                           ]
                   ]
    it "the smallest is GF(p), the codes below p" $
      everyFieldHas $ \k ->
        exceptions
          [ ()
            | map toCode (subfieldElements (primeSubfield `asTypeOf` primeOf k))
                /= [0 .. fieldCharacteristic k - 1]
          ]
    it "other degrees are refused" $
      everyFieldHas $ \k ->
        let m = fromIntegral (fieldDegree k)
         in exceptions $
              [d | d <- [0 .. 9], d == 0 || m `mod` d /= 0, subfieldIn k d /= Left (NoSubfield d m)]
    it "the trace lies in the subfield, is linear, and takes each value equally often" $
      everyFieldHas $ \k ->
        exceptions
          [ subfieldDegree s
            | s <-
                subfieldsOf k,
              let members = subfieldElements s; values = map (trace s) (elementsOf k),
              not (all (inSubfield s) values)
                || map length (group (sort values))
                  /= map (const (fieldOrder k `div` length members)) members
                || or
                  [ trace s (c * a + b) /= c * trace s a + trace s b
                    | c <- take 4 members,
                      a <- elementsOf k,
                      b <- take 8 (elementsOf k)
                  ]
          ]
    it "the norm is the power (q - 1)/(r - 1)" $
      everyFieldHas $ \k ->
        exceptions
          [ (subfieldDegree s, a)
            | s <- subfieldsOf k,
              let e = fromIntegral (fieldOrder k - 1) `div` (subfieldOrder s - 1),
              a <- elementsOf k,
              norm s a /= power a e
          ]
  describe "minimal polynomials, over every subfield" $ do
    it "have the element as root, coefficients in the subfield, and the right degree" $
      forM_ (fieldsUpTo 81) $ \(q, SomeField k) ->
        ( q,
          [ (subfieldDegree s, a)
            | s <-
                subfieldsOf k,
              a <- elementsOf k,
              let f = minimalPolynomial s a,
              not (isMonic f) || valueAt f a /= 0 || not (all (inSubfield s) (coefficients f))
                || polynomialDegree f
                  /= Just (length (conjugates s a))
          ]
        )
          `shouldBe` (q, [])
    it "no monic polynomial of lower degree over the subfield has the root, up to q = 32" $
      forM_ (fieldsUpTo 32) $ \(q, SomeField k) ->
        ( q,
          [ (subfieldDegree s, a)
            | s <-
                subfieldsOf k,
              a <- elementsOf k,
              let n = fromMaybe 0 (polynomialDegree (minimalPolynomial s a)),
              or
                [ valueAt (polynomial (lower ++ [1])) a == 0
                  | d <- [0 .. n - 1],
                    lower <- mapM (const (subfieldElements s)) [1 .. d]
                ]
          ]
        )
          `shouldBe` (q, [])
    it "the minimal polynomial of A over GF(p) is the modulus" $
      forM_ everyField $ \(q, SomeField k) ->
        ( q,
          map toCode (coefficients (minimalPolynomial primeSubfield (primitive `asTypeOf` oneOf k)))
        )
          `shouldBe` (q, map fromIntegral (fieldModulus k))
  describe "one field in another" embeddingSpec

embeddingSpec :: Spec
embeddingSpec = do
  it "every irreducible modulus of a field up to 64 is isomorphic to the default, in m ways" $
    forM_ (fieldsUpTo 64) $ \(q, SomeField k) ->
      forM_ (lookup (fieldCharacteristic k) everyField) $ \(SomeField p) ->
        forM_ (moduli p (fieldDegree k)) $ \f ->
          (q, f, withField (fromIntegral (fieldCharacteristic k)) f (isomorphisms k))
            `shouldBe` (q, f, Right (fieldDegree k, True))
  it "the inverse of an isomorphism undoes it" $
    withField 3 [1, 0, 1] (\k -> undone (Proxy :: Proxy GF9) k) `shouldBe` Right True
  it "GF(p^d) is in GF(p^m), in d ways, iff d divides m; its image is the subfield" $
    forM_
      [(i, j) | i <- fieldsUpTo 64, j <- fieldsUpTo 64]
      $ \((i, SomeField j), (q, SomeField k)) ->
        (i, q, contained j k) `shouldBe` (i, q, True)
  it "fields of different order are not isomorphic" $ do
    (() <$ (isomorphism :: Either StructureError (Embedding GF4 GF16)))
      `shouldBe` Left (NotIsomorphic (2, 2) (2, 4))
    (() <$ (isomorphism :: Either StructureError (Embedding GF4 GF9)))
      `shouldBe` Left (NotIsomorphic (2, 2) (3, 2))
    (() <$ (embedding :: Either StructureError (Embedding GF4 GF8)))
      `shouldBe` Left (NotContained (2, 2) (2, 3))
    ( (embedding :: Either StructureError (Embedding GF4 GF16))
        >>= fmap (const ()) . inverseEmbedding
      )
      `shouldBe` Left (NotIsomorphic (2, 2) (2, 4))

-- | How many isomorphisms there are, and whether all of them are: one to one, and respecting all
-- sums and products.
isomorphisms :: forall j k. (KnownField j, KnownField k) => Proxy j -> Proxy k -> (Int, Bool)
isomorphisms _ _ = (length maps, all good maps)
  where
    maps = embeddings :: [Embedding j k]
    good e = length (nub (map (embed e) elements)) == fieldOrder (Proxy :: Proxy k) && homomorphic e

homomorphic :: forall j k. (KnownField j, KnownField k) => Embedding j k -> Bool
homomorphic e =
  embed e one == one
    && and
      [ embed e (a + b) == embed e a + embed e b && embed e (a * b) == embed e a * embed e b
        | a <- elements,
          b <- elements
      ]

undone :: forall j k. (KnownField j, KnownField k) => Proxy j -> Proxy k -> Bool
undone _ _ = case isomorphism :: Either StructureError (Embedding j k) of
  Left _ -> False
  Right e -> case inverseEmbedding e of
    Left _ -> False
    Right back ->
      and [embed back (embed e a) == a && retract e (embed e a) == Just a | a <- elements]

contained :: forall j k. (KnownField j, KnownField k) => Proxy j -> Proxy k -> Bool
contained j k
  | fieldCharacteristic j == fieldCharacteristic k && fieldDegree k `mod` fieldDegree j == 0 =
    length maps == fieldDegree j && all homomorphic (take 1 maps) && all onSubfield maps
  | otherwise = null maps
  where
    maps = embeddings :: [Embedding j k]
    onSubfield e =
      Right (sort (map (embed e) elements))
        == fmap subfieldElements (subfieldIn k (fromIntegral (fieldDegree j)))

-- | All irreducible moduli of a degree over GF(p).
moduli :: forall p. KnownField p => Proxy p -> Int -> [[Natural]]
moduli _ m =
  [ map (fromIntegral . toCode) (coefficients f)
    | f <- irreduciblePolynomials (fromIntegral m) :: [Polynomial p]
  ]

-- | There are no exceptions in any field.
everyFieldHas :: (forall k. KnownField k => Proxy k -> [String]) -> Expectation
everyFieldHas among = forM_ everyField $ \(q, SomeField k) -> (q, among k) `shouldBe` (q, [])

-- | Some of the exceptions to a rule.
exceptions :: Show a => [a] -> [String]
exceptions = map show . take 3

elementsOf :: KnownField k => Proxy k -> [GF k]
elementsOf _ = elements

oneOf :: Proxy k -> GF k
oneOf _ = one

primeOf :: Proxy k -> Subfield k
primeOf _ = primeSubfield

subfieldsOf :: KnownField k => Proxy k -> [Subfield k]
subfieldsOf _ = subfields

subfieldIn :: KnownField k => Proxy k -> Natural -> Either StructureError (Subfield k)
subfieldIn _ = subfield

byMultiplying :: KnownField k => GF k -> Either StructureError Natural
byMultiplying a
  | a == zero = Left ZeroHasNoOrder
  | otherwise =
    maybe
      (Left ZeroHasNoOrder)
      (Right . fst)
      (find ((== one) . snd) (zip [1 .. 256] (iterate (* a) a)))
