{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | GF(q)[x] modulo a polynomial h on unboxed coefficients: the fast form of what division with
-- remainder defines. It serves the tests of irreducibility and order, and the positions in GF(q^n).
-- Internal. A residue has n coefficients, where n is the degree of h; that is not checked. Powers
-- use Horner's rule on the base-q digits of the exponent. The q-th power is a linear map of
-- residues, whose matrix is made once for each h.
module PraTactile.Polynomial.Modulus
  ( Modulus,
    modulusFrom,
    modulusDegree,

    -- * Residues
    Coefficients,
    residueFrom,
    residueOne,

    -- * Arithmetic
    timesRoot,
    multiplyResidues,
    frobenius,
    powerOfX,
    powerOf,
  )
where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import Data.List (foldl')
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Vector, unsafeIndex)
import qualified Data.Vector.Primitive as Primitive
import Data.Vector.Primitive.Mutable (MVector)
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word8)
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Polynomial.Bits

-- | The n coefficients of a residue, the constant term first.
type Coefficients k = Vector (GF k)

type Buffer s k = MVector s (GF k)

-- | A polynomial h of degree n >= 1, with results that are computed from it once.
data Modulus (k :: Field) = Modulus
  { -- | n
    modulusDegree :: !Int,
    -- | x^n modulo h
    reduced :: !(Coefficients k),
    -- | n residues one after the other: x^0, x^q, ..., x^(q (n-1)) modulo h
    powersOfPowers :: Vector (GF k),
    -- | the form for GF(2), with 64 coefficients in a word
    binary :: Maybe BitModulus
  }

type role Modulus nominal

-- | The modulus x^n - (c0 + ... + c(n-1) x^(n-1)), n >= 1, from c0, ..., c(n-1).
modulusFrom :: forall k. KnownField k => [GF k] -> Modulus k
modulusFrom lower = modulus
  where
    modulus = Modulus n h table (if q == 2 then Just (bitModulus (bytes h)) else Nothing)
    h = Primitive.fromList lower
    n = Primitive.length h
    q = fieldOrder (Proxy :: Proxy k)
    table = Primitive.create $ do
      rows <- Mutable.new (n * n)
      ofX <- Primitive.thaw (residueOne modulus)
      forM_ [0 .. n - 1] $ \i -> do
        Mutable.unsafeCopy (Mutable.unsafeSlice (i * n) n rows) ofX
        forM_ [1 .. q] (const (timesX modulus ofX))
      pure rows

-- | The codes of elements.
bytes :: Vector (GF k) -> Vector Word8
bytes = Primitive.map (fromIntegral . toCode)

-- | A residue over GF(2) from its bits.
fromBits :: Modulus k -> Bits -> Coefficients k
fromBits modulus =
  Primitive.map (\b -> if b == 0 then zero else one) . unpackBits (modulusDegree modulus)

-- | The residue of 1.
residueOne :: Modulus k -> Coefficients k
residueOne modulus = Primitive.generate (modulusDegree modulus) (\i -> if i == 0 then one else zero)

-- | The residue of a polynomial, given by any number of coefficients, the constant term first.
residueFrom :: KnownField k => Modulus k -> [GF k] -> Coefficients k
residueFrom modulus coefficients
  | null beyond = padded
  | otherwise = foldl' step (Primitive.replicate n zero) (reverse coefficients)
  where
    n = modulusDegree modulus
    beyond = drop n coefficients
    padded = Primitive.fromListN n (coefficients ++ repeat zero)
    step acc c =
      let shifted = timesRoot modulus acc in shifted Primitive.// [(0, shifted Primitive.! 0 + c)]

-- | The product of a residue with x.
timesRoot :: KnownField k => Modulus k -> Coefficients k -> Coefficients k
timesRoot modulus a = Primitive.create $ do
  buffer <- Primitive.thaw a
  timesX modulus buffer
  pure buffer

-- | Multiplies a residue by x in place: all coefficients move up, and the one that leaves
-- contributes its multiple of x^n modulo h.
timesX :: KnownField k => Modulus k -> Buffer s k -> ST s ()
timesX modulus buffer = do
  top <- Mutable.unsafeRead buffer (n - 1)
  let go i
        | i == 0 = Mutable.unsafeWrite buffer 0 (top * unsafeIndex h 0)
        | otherwise = do
          below <- Mutable.unsafeRead buffer (i - 1)
          Mutable.unsafeWrite buffer i (below + top * unsafeIndex h i)
          go (i - 1)
  go (n - 1)
  where
    n = modulusDegree modulus
    h = reduced modulus

-- | Adds a multiple of a part of a vector to a part of a buffer. Arguments: the number of entries;
-- the factor; the vector and the index of its first entry; the buffer and the index of its first
-- entry.
addMultiple :: KnownField k => Int -> GF k -> Vector (GF k) -> Int -> Buffer s k -> Int -> ST s ()
addMultiple n c vector from buffer at = when (c /= zero) (go 0)
  where
    go !j = when (j < n) $ do
      old <- Mutable.unsafeRead buffer (at + j)
      Mutable.unsafeWrite buffer (at + j) (old + c * unsafeIndex vector (from + j))
      go (j + 1)

-- | The product of two residues: the coefficients of the polynomials' product, of which the upper
-- ones are reduced from the top.
multiplyResidues :: KnownField k => Modulus k -> Coefficients k -> Coefficients k -> Coefficients k
multiplyResidues modulus a b = case binary modulus of
  Just bits -> fromBits modulus (multiplyBits bits (packBits (bytes a)) (packBits (bytes b)))
  Nothing -> Primitive.create $ do
    buffer <- Mutable.replicate (2 * n - 1) zero
    forM_ [0 .. n - 1] $ \i -> addMultiple n (unsafeIndex a i) b 0 buffer i
    forM_ [2 * n - 2, 2 * n - 3 .. n] $ \i -> do
      c <- Mutable.unsafeRead buffer i
      addMultiple n c (reduced modulus) 0 buffer (i - n)
    pure (Mutable.slice 0 n buffer)
  where
    n = modulusDegree modulus

-- | The q-th power of a residue: the coefficient c of x^i contributes c x^(q i), since c^q = c.
frobenius :: KnownField k => Modulus k -> Coefficients k -> Coefficients k
frobenius modulus a = case binary modulus of
  Just bits -> fromBits modulus (squareBits bits (packBits (bytes a)))
  Nothing -> Primitive.create $ do
    buffer <- Mutable.new (modulusDegree modulus)
    frobeniusInto modulus a buffer
    pure buffer

-- | Writes the q-th power of a residue to a buffer.
frobeniusInto :: KnownField k => Modulus k -> Coefficients k -> Buffer s k -> ST s ()
frobeniusInto modulus a buffer = do
  Mutable.set buffer zero
  forM_ [0 .. n - 1] $ \i ->
    addMultiple n (unsafeIndex a i) (powersOfPowers modulus) (i * n) buffer 0
  where
    n = modulusDegree modulus

-- | The residue of x^e for an exponent e of any size: a q-th power for each base-q digit of e, from
-- the highest down, each followed by as many multiplications by x as the digit says.
powerOfX :: forall k. KnownField k => Modulus k -> Natural -> Coefficients k
powerOfX modulus e = case binary modulus of
  Just bits -> fromBits modulus (powerOfXBits bits e)
  Nothing -> case digits of
    [] -> residueOne modulus
    first : rest -> foldl' step (shifted first (residueOne modulus)) rest
  where
    digits = digitsOf (fromIntegral (fieldOrder (Proxy :: Proxy k))) e
    step acc digit = shifted digit (frobenius modulus acc)
    shifted 0 a = a
    shifted times a = Primitive.create $ do
      buffer <- Primitive.thaw a
      forM_ [1 .. times] (const (timesX modulus buffer))
      pure buffer

-- | A power of any residue: a q-th power for each base-q digit of the exponent, from the highest
-- down, and a product for each nonzero digit.
powerOf :: forall k. KnownField k => Modulus k -> Coefficients k -> Natural -> Coefficients k
powerOf modulus a e = case digitsOf q e of
  [] -> residueOne modulus
  first : rest -> foldl' step (bySquaring first) rest
  where
    q = fromIntegral (fieldOrder (Proxy :: Proxy k)) :: Natural
    step acc digit = multiplyBy digit (frobenius modulus acc)
    multiplyBy digit acc
      | digit == 0 = acc
      | otherwise = multiplyResidues modulus acc (bySquaring digit)
    -- a^digit, for a digit from 1 to q - 1.
    bySquaring :: Int -> Coefficients k
    bySquaring d
      | d == 1 = a
      | even d = square (bySquaring (d `div` 2))
      | otherwise = multiplyResidues modulus a (square (bySquaring (d `div` 2)))
    square b = multiplyResidues modulus b b

-- | The digits of a number to a base of at least 2, the most significant first; none for 0.
digitsOf :: Natural -> Natural -> [Int]
digitsOf base = go []
  where
    go digits 0 = digits
    go digits m = let (rest, digit) = m `quotRem` base in go (fromIntegral digit : digits) rest
