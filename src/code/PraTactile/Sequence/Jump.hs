{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Distant terms of a sequence: s(t) for any t, from a table of low powers of the root that is
-- made once for a polynomial. Internal; users need 'PraTactile.Sequence.termAt'.
module PraTactile.Sequence.Jump
  ( jump,
    generalJump,
  )
where

import Data.Bits (popCount, setBit, shiftL, testBit, unsafeShiftR, xor, (.&.))
import Data.List (foldl', unfoldr)
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word64)
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Polynomial

{- Note [Powers by Horner's rule]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   Let Q be a power of q, and t = (...(d1 Q + d2) Q + ...) Q + dm. The power Q is linear over GF(q)
   in the coefficients g0, ..., g(n-1) of a residue. So if alpha^t = sum of g(j) alpha^j, then
   alpha^(t Q + d) = sum of g(j) alpha^(Q j + d). Each base-Q digit of t thus costs one sum of n
   rows from a table of alpha^e, e < Q n, and no multiplication modulo h. Finally s(t) = g0 s(0) +
   ... + g(n-1) s(n-1), because both sides obey the recurrence. -}

-- | @jump h s@ maps t to s(t), given s(0), ..., s(n-1). Apply it once to h and s, and then to many
-- t: it makes the table of Note [Powers by Horner's rule], of at most a MiB or q n^2 bytes, when
-- first used. A term takes time n^2 log t, less for GF(2).
jump :: forall k. KnownField k => Primitive k -> [GF k] -> Natural -> GF k
jump h s
  | fieldOrder (Proxy :: Proxy k) == 2 && primitiveDegree h <= 64 = packedJump h s
  | otherwise = generalJump h s

-- | 'jump' by the general method, for every field.
generalJump :: forall k. KnownField k => Primitive k -> [GF k] -> Natural -> GF k
generalJump h s = \t -> sum (zipWith (*) (Primitive.toList (rootPower (t `mod` period h))) s)
  where
    n = primitiveDegree h
    q = fieldOrder (Proxy :: Proxy k)
    base = baseFor q (min n (2 ^ (20 :: Int) `div` (n * n)))
    -- Row e holds the coefficients of alpha^e.
    !table = Primitive.fromListN (base * n * n) (concat (take (base * n) rows)) :: Vector (GF k)
    rows = iterate timesRoot (one : replicate (n - 1) zero)
    timesRoot g = case splitAt (n - 1) g of
      (lower, top) ->
        zipWith (\c a -> a - sum top * c) (coefficients (primitivePolynomial h)) (zero : lower)
    rootPower t = foldl' step (row 0) (digitsTo base t)
    row e = Primitive.slice (e * n) n table
    -- Rows Q j + d, for j < n and d < Q, are within the table.
    step g d = Primitive.generate n (\i -> total g (d * n + i) 0 zero)
    total :: Vector (GF k) -> Int -> Int -> GF k -> GF k
    total !g !at !j !acc
      | j == n = acc
      | otherwise =
        total
          g
          (at + base * n)
          (j + 1)
          (acc + Primitive.unsafeIndex g j * Primitive.unsafeIndex table at)

-- | 'jump' for GF(2) and n up to 64: a residue is a word, in which bit j is the coefficient of
-- alpha^j.
packedJump :: forall k. KnownField k => Primitive k -> [GF k] -> Natural -> GF k
packedJump h s =
  \t -> if odd (popCount (rootPower (t `mod` period h) .&. word s)) then one else zero
  where
    n = primitiveDegree h
    base = baseFor 2 16
    word = foldl' setBit 0 . map fst . filter ((/= zero) . snd) . zip [0 ..] :: [GF k] -> Word64
    modulus = word (take n (coefficients (primitivePolynomial h)))
    timesRoot g = ((g `shiftL` 1) .&. below) `xor` (if testBit g (n - 1) then modulus else 0)
    below = if n == 64 then maxBound else 2 ^ n - 1
    !table = Primitive.fromListN (base * n) (iterate timesRoot 1) :: Vector Word64
    rootPower t = foldl' step 1 (digitsTo base t)
    step :: Word64 -> Int -> Word64
    step g d = total g d 0
    total !g !at !acc
      | g == 0 = acc
      | otherwise =
        -- All ones or all zeros, as bit 0 is.
        let chosen = negate (g .&. 1) .&. Primitive.unsafeIndex table at
         in total (g `unsafeShiftR` 1) (at + base) (acc `xor` chosen)

-- | The largest power of q up to the limit, or q.
baseFor :: Int -> Int -> Int
baseFor q limit = until (\b -> b * q > limit) (* q) q

-- | The digits to a base, most significant first; none for 0.
digitsTo :: Int -> Natural -> [Int]
digitsTo base = reverse . unfoldr digit
  where
    digit 0 = Nothing
    digit t = Just (fromIntegral (t `mod` fromIntegral base), t `div` fromIntegral base)
