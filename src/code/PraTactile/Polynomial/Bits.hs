{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | GF(2)[x] modulo h with 64 coefficients in a word. This is "PraTactile.Polynomial.Modulus" for
-- the binary field. Internal. A residue is a vector of words, with coefficient i in bit i mod 64 of
-- word i div 64. Its degree is below that of h.
module PraTactile.Polynomial.Bits
  ( -- * Packing
    Bits,
    packBits,
    unpackBits,

    -- * Arithmetic modulo h
    BitModulus,
    bitModulus,
    multiplyBits,
    squareBits,
    powerOfXBits,
  )
where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import Data.Bits hiding (Bits)
import Data.Vector.Primitive (Vector, unsafeIndex)
import qualified Data.Vector.Primitive as Primitive
import Data.Vector.Primitive.Mutable (MVector)
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word64, Word8)
import Numeric.Natural (Natural)

-- | Coefficients as bits of words.
type Bits = Vector Word64

type Buffer s = MVector s Word64

-- | Packs bytes that are 0 or 1 into bits: 64 in a word, the first in the least significant bit.
packBits :: Vector Word8 -> Bits
packBits bytes = Primitive.generate ((n + 63) `div` 64) word
  where
    n = Primitive.length bytes
    word w = Primitive.ifoldl' withBit 0 (Primitive.slice (64 * w) (min 64 (n - 64 * w)) bytes)
    withBit acc i b = acc .|. (fromIntegral b `unsafeShiftL` i)

-- | The first n bits, each as a byte.
unpackBits :: Int -> Bits -> Vector Word8
unpackBits n bits = Primitive.generate n (\i -> if bitAt bits i then 1 else 0)

-- | Whether a bit is set.
bitAt :: Bits -> Int -> Bool
bitAt bits i = testBit (bits Primitive.! (i `div` 64)) (i `mod` 64)

-- | A polynomial h of degree n >= 1 with what is computed from it once.
data BitModulus = BitModulus
  { -- | n
    degree :: !Int,
    -- | the number of words in a residue
    limbs :: !Int,
    -- | x^n modulo h
    reduced :: !Bits,
    -- | n residues one after the other: x^0, x^2, ..., x^(2n-2) modulo h
    squares :: Bits
  }

-- | The modulus h from its n >= 1 coefficients below the leading one.
bitModulus :: Vector Word8 -> BitModulus
bitModulus lower = modulus
  where
    modulus = BitModulus n (Primitive.length h) h table
    n = Primitive.length lower
    h = packBits lower
    table = Primitive.create $ do
      rows <- Mutable.replicate (n * limbs modulus) 0
      ofX <- oneBuffer modulus
      forM_ [0 .. n - 1] $ \i -> do
        Mutable.unsafeCopy (Mutable.unsafeSlice (i * limbs modulus) (limbs modulus) rows) ofX
        timesX modulus ofX
        timesX modulus ofX
      pure rows

-- | A new buffer with the residue of 1.
oneBuffer :: BitModulus -> ST s (Buffer s)
oneBuffer modulus = do
  buffer <- Mutable.replicate (limbs modulus) 0
  Mutable.write buffer 0 1
  pure buffer

-- | Multiplies a residue by x in place: all bits move up, and if the bit that leaves is set, x^n
-- modulo h is added.
timesX :: BitModulus -> Buffer s -> ST s ()
timesX modulus buffer = do
  top <- Mutable.unsafeRead buffer lastWord
  let leaves = testBit top lastBit
  shiftUp lastWord
  when leaves $ do
    high <- Mutable.unsafeRead buffer lastWord
    Mutable.unsafeWrite buffer lastWord (high .&. mask)
    addFrom (limbs modulus) (reduced modulus) 0 buffer
  where
    lastWord = limbs modulus - 1
    lastBit = (degree modulus - 1) `mod` 64
    mask = (2 `shiftL` lastBit) - 1
    shiftUp 0 = Mutable.unsafeRead buffer 0 >>= Mutable.unsafeWrite buffer 0 . (`unsafeShiftL` 1)
    shiftUp i = do
      low <- Mutable.unsafeRead buffer (i - 1)
      high <- Mutable.unsafeRead buffer i
      Mutable.unsafeWrite buffer i ((high `unsafeShiftL` 1) .|. (low `unsafeShiftR` 63))
      shiftUp (i - 1)

-- | Adds words of a vector to a buffer. Arguments: the number of words; the vector and the index of
-- its first word; the buffer, of which the first words are changed.
addFrom :: Int -> Bits -> Int -> Buffer s -> ST s ()
addFrom count vector from buffer = go 0
  where
    go !j = when (j < count) $ do
      old <- Mutable.unsafeRead buffer j
      Mutable.unsafeWrite buffer j (old `xor` unsafeIndex vector (from + j))
      go (j + 1)
{-# INLINE addFrom #-}

-- | Writes the square of the residue in the first buffer to the second. Squaring is linear, so the
-- squares of the powers of x are added.
squareInto :: BitModulus -> Buffer s -> Buffer s -> ST s ()
squareInto modulus source target = Mutable.set target 0 >> eachWord 0
  where
    eachWord !w = when (w < limbs modulus) $ do
      Mutable.unsafeRead source w >>= eachBit (64 * w)
      eachWord (w + 1)
    eachBit !_ 0 = pure ()
    eachBit base word = do
      addFrom
        (limbs modulus)
        (squares modulus)
        ((base + countTrailingZeros word) * limbs modulus)
        target
      eachBit base (word .&. (word - 1))

-- | The square of a residue.
squareBits :: BitModulus -> Bits -> Bits
squareBits modulus a = Primitive.create $ do
  source <- Primitive.thaw a
  target <- Mutable.new (limbs modulus)
  squareInto modulus source target
  pure target

-- | The product of two residues, by Horner's rule on the bits of the second one.
multiplyBits :: BitModulus -> Bits -> Bits -> Bits
multiplyBits modulus a b = Primitive.create $ do
  buffer <- Mutable.replicate (limbs modulus) 0
  forM_ [degree modulus - 1, degree modulus - 2 .. 0] $ \i -> do
    timesX modulus buffer
    when (bitAt b i) (addFrom (limbs modulus) a 0 buffer)
  pure buffer

-- | x^e modulo h for an exponent of any size: a square for each binary digit, from the highest
-- down, and a shift for each 1.
powerOfXBits :: BitModulus -> Natural -> Bits
powerOfXBits modulus e = Primitive.create $ do
  start <- oneBuffer modulus
  spare <- Mutable.new (limbs modulus)
  go (bitLength e - 1) start spare
  where
    go :: Int -> Buffer s -> Buffer s -> ST s (Buffer s)
    go !i current spare
      | i < 0 = pure current
      | otherwise = do
        squareInto modulus current spare
        when (testBit e i) (timesX modulus spare)
        go (i - 1) spare current

-- | The number of binary digits of a number; 0 for 0.
bitLength :: Natural -> Int
bitLength n
  | high == 0 = 64 - countLeadingZeros (fromIntegral n :: Word64)
  | otherwise = 64 + bitLength high
  where
    high = n `shiftR` 64
