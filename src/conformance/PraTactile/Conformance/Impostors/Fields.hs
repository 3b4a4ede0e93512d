-- | Mistakes in the arithmetic of the alphabet, and in polynomials over it.
module PraTactile.Conformance.Impostors.Fields
  ( arithmeticImpostors,
    fieldImpostors,
    polynomialImpostors,
  )
where

import Control.Monad (replicateM, zipWithM)
import Data.Bits (xor)
import Data.List (sortOn)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Impostors.Ways
import PraTactile.Profile (Profile (..))

-- | In sums and products, and so in all that is made of them.
arithmeticImpostors :: [Impostor]
arithmeticImpostors = sums ++ products

-- | In one operation of the field.
fieldImpostors :: [Impostor]
fieldImpostors = negatives ++ inverses ++ powers ++ logarithms ++ traces

sums :: [Impostor]
sums =
  [ misstepped "adds-modulo-q" "adds codes as numbers modulo q" $ \ways ->
      ways {plus = \p a b -> (a + b) `mod` order p},
    misstepped "adds-by-xor" "adds codes bit by bit, as in characteristic 2, whatever the field" $
      \ways ->
        ways {plus = \p a b -> (a `xor` b) `mod` order p},
    mistaken "takes-codes-modulo-q" "takes a code of q or more modulo q" $ \s ->
      let cut a = a `mod` profileOrder (profile s)
       in s
            { add = \a b -> add s (cut a) (cut b),
              multiply = \a b -> multiply s (cut a) (cut b),
              negation = negation s . cut,
              inverse = inverse s . cut,
              power = power s . cut,
              logarithm = logarithm s . cut,
              trace = trace s . cut,
              primitive = primitive s . map cut,
              pack = pack s . map cut,
              locate = locate s . map (map (fmap cut)),
              nearest = \radius -> nearest s radius . map (map (fmap cut))
            }
  ]
  where
    order p = fromIntegral (profileOrder p) :: Int

negatives :: [Impostor]
negatives =
  [ mistaken "keeps-the-second-summand" "takes the second summand for the sum" $ \s ->
      s {add = \a b -> add s a b >> add s b 0},
    mistaken "squares-the-second-factor" "multiplies by the second factor twice" $ \s ->
      s {multiply = \a b -> multiply s a b >>= \ab -> multiply s ab b},
    mistaken "negates-nothing" "takes an element for its own negative, as in characteristic 2" $
      \s ->
        s {negation = \a -> add s a 0},
    mistaken "negates-modulo-q" "takes q less the code for the negative" $ \s ->
      s
        { negation = \a ->
            add s a 0
              >> pure
                ((profileOrder (profile s) - a) `mod` profileOrder (profile s))
        }
  ]

products :: [Impostor]
products =
  [ misstepped "multiplies-modulo-q" "multiplies codes as numbers modulo q" $ \ways ->
      ways {times = \p a b -> (a * b) `mod` fromIntegral (profileOrder p)},
    misstepped "multiplies-digit-by-digit" "multiplies the digits of codes one by one" $ \ways ->
      ways {times = digitwise (*)},
    misstepped "reduces-by-another-modulus" "multiplies modulo another irreducible polynomial" $
      \ways ->
        ways {times = \p -> productModulo p (anotherModulus p)},
    misstepped "reads-the-modulus-backwards" "takes the modulus highest degree first" $ \ways ->
      ways {times = \p -> productModulo p (monicReversed p (profileModulus p))},
    misstepped
      "forgets-to-reduce"
      "drops the digits above the modulus's degree instead of reducing"
      $ \ways ->
        ways {times = \p -> productModulo p (map (const 0) (drop 1 (profileModulus p)) ++ [1])}
  ]

-- | Another irreducible polynomial of the same degree, where there is one.
anotherModulus :: Profile -> [Natural]
anotherModulus p = case (profileOrder p, profileModulus p) of
  (8, [1, 0, 1, 1]) -> [1, 1, 0, 1]
  (8, _) -> [1, 0, 1, 1]
  (9, [2, 1, 1]) -> [1, 0, 1]
  (9, _) -> [2, 1, 1]
  (_, modulus) -> modulus

monicReversed :: Profile -> [Natural] -> [Natural]
monicReversed p modulus = case reverse modulus of
  coefficients
    | last' coefficients == 1 -> coefficients
    | otherwise -> map ((`mod` base) . (* last' coefficients)) coefficients
  where
    base = fromIntegral (characteristic p)
    last' xs = case reverse xs of
      x : _ -> x
      [] -> 1

inverses :: [Impostor]
inverses =
  [ mistaken "inverts-one-power-too-far" "takes a^(q-1) for 1/a, not a^(q-2)" $ \s ->
      s {inverse = \a -> inverse s a >> power s a (toInteger (profileOrder (profile s)) - 1)},
    mistaken "inverts-as-it-negates" "takes the additive inverse for the multiplicative one" $ \s ->
      s {inverse = \a -> inverse s a >> negation s a},
    mistaken "inverts-zero" "has a power, 0, for the inverse of 0" $ \s ->
      s
        { inverse = \a ->
            power
              s
              a
              ( toInteger (profileOrder (profile s)) - 2
                  + (if profileOrder (profile s) == 2 then 1 else 0)
              )
        }
  ]

powers :: [Impostor]
powers =
  [ mistaken "takes-exponents-modulo-q" "reduces exponents modulo q, not q - 1" $ \s ->
      s {power = \a i -> power s a (i `mod` toInteger (profileOrder (profile s)))},
    mistaken "takes-exponents-modulo-q-less-one" "reduces exponents modulo q - 1 for 0 too" $ \s ->
      s {power = \a i -> power s a (i `mod` max 1 (toInteger (profileOrder (profile s)) - 1))},
    mistaken "forgets-the-exponents-sign" "raises to the magnitude of a negative exponent" $ \s ->
      s {power = \a i -> power s a (abs i)},
    mistaken "raises-by-sums" "multiplies by the exponent instead of raising" $ \s ->
      s
        { power = \a i ->
            multiply
              s
              a
              (fromInteger (i `mod` toInteger (characteristic (profile s))))
        },
    mistaken "has-zero-to-the-zero-zero" "takes 0 to the power 0 for 0: it starts from the base" $
      \s ->
        s
          { power = \a i ->
              if i >= 0
                then
                  power s a i >>= \x ->
                    power s a 1 >>= \y ->
                      if y == 0
                        then pure y
                        else pure x
                else power s a i
          },
    mistaken "takes-exponents-in-64-bits" "reads exponents in 64 bits, cut off" $ \s ->
      s {power = \a i -> power s a (signum i * (abs i `mod` 2 ^ (64 :: Int)))}
  ]

logarithms :: [Impostor]
logarithms =
  [ mistaken "takes-logarithms-to-the-root" "takes logarithms to the base of the modulus's root" $
      \s ->
        let q = profileOrder (profile s)
            root =
              if fromIntegral (characteristic (profile s)) == q
                then rootOfLinear (profile s)
                else fromIntegral (characteristic (profile s))
         in s {logarithm = \a -> logarithm s a >> firstPower s root a},
    mistaken "counts-logarithms-from-one" "has q - 1, not 0, for the logarithm of 1" $ \s ->
      s
        { logarithm = \a ->
            (\i -> if i == 0 then profileOrder (profile s) - 1 else i)
              <$> logarithm s a
        },
    mistaken "has-a-logarithm-of-zero" "ends its search for the logarithm of 0 at q - 1" $ \s ->
      s {logarithm = \a -> searched s a 0},
    mistaken
      "takes-the-largest-primitive-element"
      "takes logarithms to the largest code of order q - 1"
      $ \s ->
        s {logarithm = \a -> logarithm s a >>= largestBase s}
  ]
  where
    rootOfLinear p = case profileModulus p of
      c : _ -> (profileOrder p - c) `mod` profileOrder p
      [] -> 1
    firstPower s base a = go (0 :: Natural) (1 :: Natural)
      where
        go i x
          | x == a = pure i
          | i >= profileOrder (profile s) = refuse "out-of-range"
          | otherwise = multiply s x base >>= go (i + 1)
    searched s a i = do
      code <- add s a 0
      _ <- pure code
      if i + 1 >= profileOrder (profile s)
        then pure i
        else do
          base <- smallestBase s
          x <- power s base (toInteger i)
          if x == code then pure i else searched s a (i + 1)
    smallestBase s = baseAmong s [1 .. profileOrder (profile s) - 1]
    baseAmong s codes = case codes of
      [] -> pure 1
      a : rest -> do
        found <- ordered s a
        if found then pure a else baseAmong s rest
    ordered s a = do
      let n = toInteger (profileOrder (profile s)) - 1
      values <- traverse (power s a) [0 .. n - 1]
      pure (Set.size (Set.fromList values) == fromInteger n)
    largestBase s i = do
      let q = profileOrder (profile s)
      base <- baseAmong s (reverse [1 .. q - 1])
      smallest <- smallestBase s
      a <- power s smallest (toInteger i)
      firstPower s base a

traces :: [Impostor]
traces =
  [ mistaken "traces-one-power-short" "leaves the last conjugate out of the trace" $ \s ->
      s {trace = \a -> conjugates s a >>= foldSum s . dropLast},
    mistaken "takes-the-norm-for-the-trace" "multiplies the conjugates instead of adding them" $
      \s ->
        s {trace = \a -> conjugates s a >>= foldProduct s},
    mistaken "traces-copies" "adds the element as often as the degree says, without raising it" $
      \s ->
        s {trace = \a -> conjugates s a >>= foldSum s . map (const a)}
  ]
  where
    dropLast xs = take (max 1 (length xs - 1)) xs
    foldSum s = foldr (\a total -> total >>= add s a) (pure 0)
    foldProduct s = foldr (\a total -> total >>= multiply s a) (pure 1)
    conjugates s a = traverse (\i -> power s a (base ^ i)) [0 .. degree - 1 :: Int]
      where
        base = toInteger (characteristic (profile s))
        degree = length (profileModulus (profile s)) - 1

-- | In polynomials.
polynomialImpostors :: [Impostor]
polynomialImpostors =
  [ mistaken
      "takes-the-first-irreducible"
      "takes the first irreducible polynomial, or x + 1"
      $ \s ->
        s {firstPrimitive = \n -> if n == 1 then pure [1, 1] else firstPrimitive s n},
    mistaken
      "demands-a-linear-term"
      "takes only polynomials with a linear term for primitive"
      $ \s ->
        s {primitive = \h -> (&& any (/= 0) (take 1 (drop 1 h))) <$> primitive s h},
    mistaken "makes-polynomials-monic" "divides a polynomial by its leading coefficient first" $
      \s ->
        s
          { primitive = \codes -> mapM_ (\a -> add s a 0) codes >> madeMonic s codes >>= primitive s
          },
    mistaken "reads-polynomials-backwards" "takes polynomials highest degree first" $ \s ->
      s {primitive = primitive s . reverse, firstPrimitive = fmap reverse . firstPrimitive s},
    mistaken
      "takes-irreducible-for-primitive"
      "takes every polynomial without roots or factors for primitive"
      $ \s ->
        s
          { primitive = \codes ->
              primitive s codes >>= \yes ->
                if yes
                  then pure yes
                  else withoutFactors s codes
          },
    mistaken "looks-for-roots-only" "takes a polynomial without roots for primitive" $ \s ->
      s
        { primitive = \codes ->
            primitive s codes >>= \yes ->
              if yes
                then pure yes
                else withoutRoots s codes
        },
    mistaken
      "compares-from-the-lowest-degree"
      "orders polynomials by their lowest coefficients first"
      $ \s ->
        s {firstPrimitive = \n -> firstOf s n id},
    mistaken
      "takes-the-sparsest-polynomial"
      "takes the primitive polynomial with the fewest terms for the first"
      $ \s ->
        s {firstPrimitive = \n -> firstOf s n sparsest},
    mistaken
      "takes-the-constant-for-a-polynomial"
      "has a first primitive polynomial of degree 0: 1"
      $ \s ->
        s
          { firstPrimitive = \n ->
              if n < 1
                then pure (replicate (fromIntegral n + 1) 1)
                else firstPrimitive s n
          }
  ]
  where
    sparsest = sortOn (\codes -> (length (filter (/= 0) codes), reverse codes))
    firstOf s n order
      | n == 0 || profileOrder (profile s) ^ n > 5000 = firstPrimitive s n
      | otherwise =
        search s (order (candidates (profileOrder (profile s)) n))
          >>= maybe
            (refuse "invalid")
            pure
    candidates q n = map (++ [1]) (replicateM (fromIntegral n) [0 .. q - 1])
    search s codes = case codes of
      [] -> pure Nothing
      h : rest -> primitive s h >>= \yes -> if yes then pure (Just h) else search s rest

madeMonic :: Session -> [Code] -> Wire [Code]
madeMonic s codes = case reverse codes of
  c : _ | c > 0 -> inverse s c >>= \i -> traverse (multiply s i) codes
  _ -> pure codes

-- | Whether a monic polynomial of degree 2 or more, with a constant term, has no root.
withoutRoots :: Session -> [Code] -> Wire Bool
withoutRoots s codes = case (codes, reverse codes) of
  (c : _, 1 : _ : _ : _)
    | c > 0 ->
      notElem 0
        <$> traverse
          (valueAt s codes)
          [1 .. profileOrder (profile s) - 1]
  _ -> pure False

valueAt :: Session -> [Code] -> Code -> Wire Code
valueAt s codes x = foldr (\c total -> total >>= multiply s x >>= add s c) (pure 0) codes

-- | Without a factor of half the degree or less, by dividing through all.
withoutFactors :: Session -> [Code] -> Wire Bool
withoutFactors s codes = case reverse codes of
  1 : _ : _
    | 0 `notElem` take 1 codes ->
      noneDivides
        [g ++ [1] | n <- [1 .. degree `div` 2], g <- replicateM n [0 .. q - 1]]
  _ -> pure False
  where
    q = profileOrder (profile s)
    degree = length codes - 1
    noneDivides divisors = case divisors of
      [] -> pure True
      g : rest ->
        remainder (reverse codes) (reverse g) >>= \r ->
          if all (== 0) r
            then pure False
            else noneDivides rest
    -- Both with the leading coefficient first; the divisor is monic.
    remainder f g
      | length f < length g = pure f
      | otherwise = case f of
        [] -> pure []
        c : _ -> do
          taken <- traverse (multiply s c) g
          lower <- zipWithM (\a b -> negation s b >>= add s a) f (taken ++ repeat 0)
          remainder (drop 1 lower) g
