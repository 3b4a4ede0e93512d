{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Packs words over GF(q) into few bits, to count quickly where two of them differ.
module PraTactile.LinearCode.Packed
  ( Packed,
    packed,
    differences,
  )
where

import Data.Bits (popCount, unsafeShiftL, unsafeShiftR, xor, (.&.), (.|.))
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Vector, unsafeIndex)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word64)
import PraTactile.Field

-- | Words of one length, one after the other, with as few bits for each element as its code needs:
-- the number of bits, 1, 2, 4 or 8; the number of machine words for each word; and the machine
-- words.
data Packed = Packed !Int !Int !(Vector Word64)

-- | Packs words, which must all have one length; this is not checked.
packed :: forall k. KnownField k => [Vector (GF k)] -> Packed
packed rows =
  Packed bits width (Primitive.concat (map (\x -> Primitive.generate width (machineWord x)) rows))
  where
    q = fieldOrder (Proxy :: Proxy k)
    bits = if q <= 2 then 1 else if q <= 4 then 2 else if q <= 16 then 4 else 8
    each = 64 `div` bits
    width = (maximum (0 : map Primitive.length rows) + each - 1) `div` each
    machineWord x i = Primitive.ifoldl' place 0 (Primitive.take each (Primitive.drop (i * each) x))
    place acc j a = acc .|. fromIntegral (toCode a) `unsafeShiftL` (j * bits)
{-# INLINE packed #-}

-- | The number of elements in which two words differ. Arguments: packed words; the index of one of
-- them; a packed word of the same length; a limit. Counting stops when the number exceeds the
-- limit, so the result may then be too small.
differences :: Packed -> Int -> Packed -> Int -> Int
differences (Packed bits width rows) !index (Packed _ _ single) !most = go 0 0
  where
    base = index * width
    go :: Int -> Int -> Int
    go !j !n
      | j >= width || n > most = n
      | otherwise =
        go (j + 1) (n + popCount (marks (unsafeIndex rows (base + j) `xor` unsafeIndex single j)))
    -- One bit for each nonzero element.
    marks x = case bits of
      1 -> x
      2 -> (x .|. x `unsafeShiftR` 1) .&. 0x5555555555555555
      4 -> let y = x .|. x `unsafeShiftR` 1 in (y .|. y `unsafeShiftR` 2) .&. 0x1111111111111111
      _ ->
        let y = x .|. x `unsafeShiftR` 1
            z = y .|. y `unsafeShiftR` 2
         in (z .|. z `unsafeShiftR` 4) .&. 0x0101010101010101
{-# INLINE differences #-}
