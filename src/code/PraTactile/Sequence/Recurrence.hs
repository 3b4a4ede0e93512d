{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Runs a linear recurrence through memory, with one byte for each term. Powers of its polynomial
-- leave many terms independent, so that these are computed at once. Internal: used to fill
-- sequences and the grids of arrays.
module PraTactile.Sequence.Recurrence
  ( Recurrence,
    recurrenceOf,
    delayed,
    frobenius,
    spread,
    longestLag,
    stepwise,
    blockwise,
    continue,
  )
where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import Data.Bits (testBit, unsafeShiftL, unsafeShiftR, xor, (.&.))
import Data.List (intercalate)
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (MVector (..), Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word64)
import PraTactile.Field

-- | v(i) = a1 v(i - l1) + a2 v(i - l2) + ...: the lags l, each at least 1, with their nonzero
-- factors a.
newtype Recurrence (k :: Field) = Recurrence [(Int, GF k)]

-- | The recurrence of a monic polynomial, given by its lower coefficients c0, ..., c(n-1): v(i) = -
-- (c(n-1) v(i-1) + ... + c0 v(i-n)).
recurrenceOf :: KnownField k => [GF k] -> Recurrence k
recurrenceOf lower =
  Recurrence
    [(lag, negate c) | (lag, c) <- zip [length lower, length lower - 1 ..] lower, c /= zero]

-- | The recurrence with every lag multiplied by a number, at least 1. If the rows of a matrix obey
-- a recurrence, its cells in one line obey this one, with the length of a row as the number.
delayed :: Int -> Recurrence k -> Recurrence k
delayed times (Recurrence taps) = Recurrence [(max 1 times * lag, a) | (lag, a) <- taps]

-- | @frobenius e@ gives the recurrence of h^(p^e), which every sequence that obeys h also obeys.
-- The p-th power is additive, so this polynomial has as many terms as h, p^e times as far apart.
frobenius :: forall k. KnownField k => Int -> Recurrence k -> Recurrence k
frobenius e (Recurrence taps) = Recurrence [(lag * q, power a (fromIntegral q)) | (lag, a) <- taps]
  where
    q = fieldCharacteristic (Proxy :: Proxy k) ^ max 0 e

-- | The number of terms that the recurrence looks back.
longestLag :: Recurrence k -> Int
longestLag (Recurrence taps) = maximum (0 : map fst taps)

shortestLag :: Recurrence k -> Int
shortestLag (Recurrence taps) = minimum (maxBound : map fst taps)

-- | The first power of the recurrence whose shortest lag makes blocks worth their overhead, and in
-- characteristic 2 all of whose lags are whole words.
spread :: forall k. KnownField k => Recurrence k -> Recurrence k
spread = until ready (frobenius 1)
  where
    ready r@(Recurrence taps) =
      shortestLag r >= 1024 && (p /= 2 || all ((== 0) . (`mod` 8) . fst) taps)
    p = fieldCharacteristic (Proxy :: Proxy k)

-- | @continue r from to v@ writes v(from), ..., v(to - 1): first by the recurrence itself, then by
-- a power of it if there are many terms. Does nothing if a lag reaches before v(0), or v(to - 1) is
-- beyond the vector.
continue :: forall k s. KnownField k => Recurrence k -> Int -> Int -> MVector s (GF k) -> ST s ()
continue r from to v
  | to - start < 16384 = stepwise r from to v
  | otherwise = do
    stepwise r from start v
    blockwise far start to v
  where
    start = max from (longestLag far)
    far = spread r

-- | 'continue' term by term, as the definition.
stepwise :: forall k s. KnownField k => Recurrence k -> Int -> Int -> MVector s (GF k) -> ST s ()
stepwise r@(Recurrence taps) from to v = when (reaches r from to v) (go from)
  where
    count = length taps
    !lags = Primitive.fromListN count (map fst taps) :: Vector Int
    !factors = Primitive.fromListN count (map snd taps) :: Vector (GF k)
    go !i = when (i < to) (total i 0 zero)
    total !i !j !acc
      | j == count = Mutable.unsafeWrite v i acc >> go (i + 1)
      | otherwise = do
        s <- Mutable.unsafeRead v (i - Primitive.unsafeIndex lags j)
        total i (j + 1) (acc + Primitive.unsafeIndex factors j * s)

-- | Whether v(from), ..., v(to - 1) can be computed within the vector.
reaches :: Recurrence k -> Int -> Int -> MVector s (GF k) -> Bool
reaches r from to v = longestLag r <= from && to <= Mutable.length v

-- | 'continue' in blocks no longer than the shortest lag, so that terms of a block do not depend on
-- each other. In characteristic 2 it takes eight terms at a time where the lags allow.
blockwise :: forall k s. KnownField k => Recurrence k -> Int -> Int -> MVector s (GF k) -> ST s ()
blockwise r@(Recurrence taps) from to v@(MVector offset size bytes) =
  when (reaches r from to v) $
    if inWords
      then do
        let whole = min to (from + (-from) `mod` 8)
        byTerms whole
        inBlocks (shortestLag r `div` 8) (whole `div` 8) (to `div` 8) (wordPasses taps wordView)
        inBlocks 8 (max whole (8 * (to `div` 8))) to (termPasses taps v)
      else inBlocks (shortestLag r) from to (termPasses taps v)
  where
    inWords =
      fieldCharacteristic (Proxy :: Proxy k) == 2
        && all ((== 0) . (`mod` 8)) (offset : map fst taps)
    byTerms end = inBlocks (shortestLag r) from end (termPasses taps v)
    wordView = MVector (offset `div` 8) (size `div` 8) bytes

-- | An action on the places from the first number up to the second, exclusive.
type Pass s = Int -> Int -> ST s ()

-- | Runs all passes over one block after another.
inBlocks :: Int -> Int -> Int -> [Pass s] -> ST s ()
inBlocks shortest from to passes = go from
  where
    size = max 1 (min 4096 shortest)
    go i = when (i < to) $ do
      forM_ passes (\pass -> pass i (min to (i + size)))
      go (i + size)

-- | The sum for a recurrence: two of its terms in the first pass and one in each further pass, by
-- tables of two arguments.
termPasses :: forall k s. KnownField k => [(Int, GF k)] -> MVector s (GF k) -> [Pass s]
termPasses taps v = case taps of
  (l1, a1) : (l2, a2) : more -> combine a1 l1 a2 l2 : map (\(l, a) -> combine one 0 a l) more
  [(l, a)] -> [combine zero l a l]
  [] -> [\from to -> forM_ [from .. to - 1] (\i -> Mutable.write v i zero)]
  where
    -- v(i) := a1 v(i - l1) + a2 v(i - l2)
    combine :: GF k -> Int -> GF k -> Int -> Pass s
    combine a1 !l1 a2 !l2 =
      let !table = combinations a1 a2
          go !to !i = when (i < to) $ do
            x <- Mutable.unsafeRead v (i - l1)
            y <- Mutable.unsafeRead v (i - l2)
            Mutable.unsafeWrite v i (Primitive.unsafeIndex table (256 * toCode x + toCode y))
            go to (i + 1)
       in flip go

-- | The table in which entry 256 x + y is a x + b y; rows of 256 keep every index within it.
combinations :: KnownField k => GF k -> GF k -> Vector (GF k)
combinations a b = Primitive.create $ do
  table <- Mutable.replicate 65536 zero
  forM_ elements $ \x ->
    forM_ elements $ \y -> Mutable.write table (256 * toCode x + toCode y) (a * x + b * y)
  pure table

{- Note [Eight terms at a time]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   In characteristic 2 a code is the vector of its coefficients over GF(2), and a sum is an
   exclusive or, for eight codes in a machine word as for one. The product of s by a factor c = c0 +
   c1 A + ..., where A is the modulus's root, is c0 s + A (c1 s + A (c2 s + ...)). By Horner's rule,
   all terms whose factor contains the highest power A^b are added up, the sum is multiplied by A,
   the terms whose factor contains A^(b-1) are added, and so on. That takes m - 1 multiplications by
   A, whatever the number of terms. Multiplication by A moves each code up one bit and subtracts the
   modulus from codes that reach degree m. Bytes do not affect each other, so their order in a word
   does not matter. -}

-- | The sum for a recurrence whose lags are all multiples of 8, on words of eight terms. See Note
-- [Eight terms at a time].
wordPasses :: forall k s. KnownField k => [(Int, GF k)] -> MVector s Word64 -> [Pass s]
wordPasses taps v = clear : intercalate [each timesA] [addAll (wanted b) | b <- [m - 1, m - 2 .. 0]]
  where
    !m = fieldDegree (Proxy :: Proxy k)
    wanted b = [lag `div` 8 | (lag, a) <- taps, testBit (toCode a) b]
    clear from to = Mutable.set (Mutable.slice from (to - from) v) 0
    addAll lags = case lags of
      l1 : l2 : more ->
        each (\i w -> (\x y -> w `xor` x `xor` y) <$> back i l1 <*> back i l2) : addAll more
      [l] -> [each (\i w -> xor w <$> back i l)]
      [] -> []
    back i l = Mutable.unsafeRead v (i - l)
    timesA _ w =
      pure
        (((w .&. lower) `unsafeShiftL` 1) `xor` (((w `unsafeShiftR` (m - 1)) .&. ones) * reduced))
    !ones = 0x0101010101010101
    !lower = ones * (2 ^ (m - 1) - 1)
    -- A^m: the modulus without its leading term, as a code.
    !reduced =
      sum
        ( zipWith
            (*)
            (map fromIntegral (take m (fieldModulus (Proxy :: Proxy k))))
            (iterate (* 2) 1)
        )
    each :: (Int -> Word64 -> ST s Word64) -> Pass s
    each change = \from to ->
      let go !i = when (i < to) $ do
            w <- Mutable.unsafeRead v i
            change i w >>= Mutable.unsafeWrite v i
            go (i + 1)
       in go from
    {-# INLINE each #-}
