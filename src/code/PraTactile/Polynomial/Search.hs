{-# OPTIONS_HADDOCK hide #-}

-- | Orders in which polynomials are searched: ascending, by the number of terms, and at random.
-- Internal; "PraTactile.Polynomial" exports it.
module PraTactile.Polynomial.Search
  ( -- * Candidates
    monicPolynomials,
    monicByTerms,
    randomMonics,
    ascendingCandidates,
    fewestTermsCandidates,

    -- * Irreducible and primitive ones
    irreduciblePolynomials,
    primitivePolynomials,
    firstPrimitive,
    fewestTermsPrimitive,
    randomPrimitive,

    -- * Random words
    splitMix,
  )
where

import Data.Bits (shiftR, xor)
import Data.List (genericSplitAt, genericTake, unfoldr)
import Data.Proxy (Proxy (..))
import Data.Word (Word64)
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Polynomial.Irreducible
import PraTactile.Polynomial.Primitive
import PraTactile.Polynomial.Reducible
import PraTactile.Polynomial.Ring

-- | All q^n monic polynomials of a degree, ascending, computed lazily. Coefficients are compared
-- from the highest degree down. O(n) each.
monicPolynomials :: KnownField k => Natural -> [Polynomial k]
monicPolynomials = monicFrom 0

-- | 'monicPolynomials' without a beginning that is known to contain no irreducible ones
-- ('reducibleRun').
ascendingCandidates :: forall k. KnownField k => Natural -> [Polynomial k]
ascendingCandidates n = monicFrom (reducibleRun (Proxy :: Proxy k) (fromIntegral n)) n

-- | The monic polynomials of a degree n, ascending, from x^n + x^i on; all of them for i = 0.
monicFrom :: forall k. KnownField k => Int -> Natural -> [Polynomial k]
monicFrom i n = map monicOf [if i == 0 then 0 else q ^ i .. q ^ n - 1]
  where
    q = toInteger (fieldOrder (Proxy :: Proxy k))
    monicOf index = polynomial (genericTake n (unfoldr digit index ++ repeat zero) ++ [one])
    digit 0 = Nothing
    digit j = Just (either (const zero) id (fromCode (fromInteger (j `mod` q))), j `div` q)

-- | The monic polynomials of degree n >= 1 with nonzero constant term, by the number of terms, then
-- ascending. For degree 1, x comes first. O(n) each.
monicByTerms :: KnownField k => Natural -> [Polynomial k]
monicByTerms = byTerms 0

-- | 'monicByTerms' without those that 'ascendingCandidates' leaves out.
fewestTermsCandidates :: forall k. KnownField k => Natural -> [Polynomial k]
fewestTermsCandidates n = byTerms (reducibleRun (Proxy :: Proxy k) (fromIntegral n)) n

-- | 'monicByTerms' without the polynomials whose terms are x^n and others below x^i; all for i = 0.
byTerms :: forall k. KnownField k => Int -> Natural -> [Polynomial k]
byTerms i n
  | n == 0 = []
  | otherwise = [variable | n == 1] ++ concatMap withTerms [1 .. fromIntegral n]
  where
    withTerms terms =
      [polynomial (reverse (one : lower)) | lower <- choose i (fromIntegral n) terms]
    -- @choose least size terms@ lists the coefficients, highest first, of which there are size. As
    -- many as terms are nonzero, including the last. At least least coefficients follow the first
    -- nonzero one.
    choose :: Int -> Int -> Int -> [[GF k]]
    choose least size terms
      | terms == 0 || terms > size || size <= least = []
      | size == 1 = map (: []) units
      | otherwise =
        map (zero :) (choose least (size - 1) terms)
          ++ [c : rest | c <- units, rest <- choose 0 (size - 1) (terms - 1)]
    units = drop 1 elements

-- | An endless list of monic polynomials of degree n, drawn independently and uniformly from a
-- seed. The draws are those of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014). Each coefficient,
-- constant term first, is the upper 32 bits of a draw modulo q. Values at the end of the 2^32,
-- which would favour small codes, are skipped. O(n) each.
randomMonics :: forall k. KnownField k => Word64 -> Natural -> [Polynomial k]
randomMonics seed n = go coefficientsDrawn
  where
    go drawn = let (lower, rest) = genericSplitAt n drawn in polynomial (lower ++ [one]) : go rest
    coefficientsDrawn =
      map (element . (`mod` q)) (filter (< limit) (map (`shiftR` 32) (splitMix seed)))
    element = either (const zero) id . fromCode . fromIntegral
    q = fromIntegral (fieldOrder (Proxy :: Proxy k)) :: Word64
    limit = 2 ^ (32 :: Int) `div` q * q

-- | The outputs of SplitMix64 from a seed.
splitMix :: Word64 -> [Word64]
splitMix seed = map mix (drop 1 (iterate (+ 0x9e3779b97f4a7c15) seed))
  where
    mix z0 =
      let z1 = (z0 `xor` (z0 `shiftR` 30)) * 0xbf58476d1ce4e5b9
          z2 = (z1 `xor` (z1 `shiftR` 27)) * 0x94d049bb133111eb
       in z2 `xor` (z2 `shiftR` 31)

-- | The monic irreducible polynomials of a degree, ascending, computed lazily. Each takes n tests
-- by 'isIrreducible' on average.
irreduciblePolynomials :: KnownField k => Natural -> [Polynomial k]
irreduciblePolynomials = filter isIrreducible . ascendingCandidates

-- | The primitive polynomials of a degree n >= 1, ascending, computed lazily. Refuses what
-- 'primitiveAmong' refuses. The cost is as there; one candidate in n N / phi(N) is primitive, where
-- phi is Euler's function.
primitivePolynomials :: KnownField k => Natural -> Either PolynomialError [Primitive k]
primitivePolynomials n = primitiveAmong n (ascendingCandidates n)

-- | The first of 'primitivePolynomials'. Over GF(4) with degree 4, it is the paper's x^4 + x^2 + A
-- x + A^2. About n N / phi(N) candidates are tested, each at the cost of 'primitiveAmong'.
firstPrimitive :: KnownField k => Natural -> Either PolynomialError (Primitive k)
firstPrimitive n = firstOf n ascendingCandidates

-- | The first primitive polynomial among those with the fewest terms: the shift register with the
-- fewest taps. The cost is that of 'firstPrimitive'.
fewestTermsPrimitive :: KnownField k => Natural -> Either PolynomialError (Primitive k)
fewestTermsPrimitive n = firstOf n fewestTermsCandidates

-- | A primitive polynomial drawn uniformly from a seed. The average cost is that of
-- 'firstPrimitive'.
randomPrimitive :: KnownField k => Word64 -> Natural -> Either PolynomialError (Primitive k)
randomPrimitive seed n = firstOf n (randomMonics seed)

firstOf ::
  KnownField k =>
  Natural ->
  (Natural -> [Polynomial k]) ->
  Either PolynomialError (Primitive k)
firstOf n candidates =
  primitiveAmong n (candidates n) >>= \found -> case found of
    h : _ -> Right h
    [] -> Left (NoPrimitivePolynomial n)
