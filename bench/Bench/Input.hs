-- | The input of the benchmarks: pseudorandom numbers, the same that the programs in @bench/peers@
-- make.
module Bench.Input
  ( scrambled,
    mixed,
    sure,
  )
where

import Data.Bits (shiftR, xor)
import Data.Proxy (Proxy)
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word64)
import PraTactile.Field

-- | The result of a computation that cannot fail on the benchmark's own input; otherwise the
-- benchmark stops.
sure :: Show e => Either e a -> a
sure = either (errorWithoutStackTrace . ("bench: " ++) . show) id

-- | 10^7 codes below q in an irregular order, so that caches do not help. The peers make the same.
scrambled :: forall k. KnownField k => Proxy k -> Int -> Vector (GF k)
scrambled k multiplier =
  Primitive.generate
    10000000
    (\i -> sure (fromCode (((i * multiplier) `shiftR` 16) `mod` fieldOrder k)))

-- | The upper 32 bits of the number with this index in SplitMix64's sequence from seed 0 (Steele,
-- Lea and Flood, OOPSLA 2014).
mixed :: Int -> Word64
mixed i = (z2 `xor` (z2 `shiftR` 31)) `shiftR` 32
  where
    z0 = fromIntegral i * 0x9e3779b97f4a7c15 :: Word64
    z1 = (z0 `xor` (z0 `shiftR` 30)) * 0xbf58476d1ce4e5b9
    z2 = (z1 `xor` (z1 `shiftR` 27)) * 0x94d049bb133111eb
