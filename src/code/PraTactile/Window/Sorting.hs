{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Sorts machine words in place, for windows with too many contents for one bit each. Internal.
--
-- vector-algorithms 0.8 is not used, because its American flag sort is slower. It takes 5.0 ms for
-- 65536 random words of 24 bits, and this module 2.7 ms. For 2^22 words of 24, 40 and 60 bits it
-- takes 0.26, 0.32 and 0.41 s, and this module 0.23, 0.30 and 0.17 s (GHC 9.0.2). Its binary search
-- takes mutable vectors only.
module PraTactile.Window.Sorting
  ( sortWords,
    repetitions,
    indexSorted,
  )
where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST)
import Data.Bits (shiftR, (.&.))
import Data.Vector.Primitive (MVector, Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word64)

-- | Sorts words in ascending order, by their bytes from the highest. The first argument is a number
-- of bits; all words must be below 2^bits, which is not checked. Each pass counts how often each
-- byte occurs, then exchanges words until every word is in the range of its byte (the American flag
-- sort of McIlroy, Bostic and McIlroy, Computing Systems 6, 1993). Fewer than 32 words are sorted
-- by insertion. Each pass needs a few tables of at most 257 counts; at most 8 passes are nested.
sortWords :: Int -> MVector s Word64 -> ST s ()
sortWords bits words' =
  byByte (max 0 (((bits + 7) `div` 8 - 1) * 8)) 0 (Mutable.length words') words'

-- | Sorts the words from one index up to, but not including, another. Arguments: a shift; both
-- indices; the words. These words must agree in all bits above the byte at the shift.
byByte :: Int -> Int -> Int -> MVector s Word64 -> ST s ()
byByte shift from to words'
  | to - from < 32 = insertion from to words'
  | otherwise = do
    counts <- Mutable.replicate 257 (0 :: Int)
    forM_ [from .. to - 1] $ \i -> byteAt i >>= Mutable.modify counts (+ 1) . (+ 1)
    forM_ [1 .. 256] $ \b ->
      Mutable.read counts (b - 1) >>= \before -> Mutable.modify counts (+ before) b
    -- Where each byte's range begins and ends, and the next place to fill in it.
    ends <- Primitive.map (+ from) <$> Primitive.freeze counts
    next <- Primitive.thaw (Primitive.take 256 ends)
    forM_ [0 .. 255] $ \b -> fill next b (ends Primitive.! (b + 1))
    when (shift > 0) $
      forM_ [0 .. 255] $ \b ->
        byByte (shift - 8) (ends Primitive.! b) (ends Primitive.! (b + 1)) words'
  where
    byteOf w = fromIntegral (w `shiftR` shift) .&. 255 :: Int
    byteAt i = byteOf <$> Mutable.read words' i
    fill next b end = do
      i <- Mutable.read next b
      when (i < end) $ do
        w <- Mutable.read words' i
        let c = byteOf w
        j <- Mutable.read next c
        Mutable.write next c (j + 1)
        when (c /= b) (Mutable.swap words' i j)
        fill next b end

-- | Sorts the words from one index up to, but not including, another, by insertion.
insertion :: Int -> Int -> MVector s Word64 -> ST s ()
insertion from to words' = forM_ [from + 1 .. to - 1] $ \i -> Mutable.read words' i >>= sink i
  where
    sink i w
      | i == from = Mutable.write words' i w
      | otherwise = do
        before <- Mutable.read words' (i - 1)
        if before > w
          then Mutable.write words' i before >> sink (i - 1) w
          else Mutable.write words' i w

-- | The words that occur repeatedly in a sorted vector: each once for every occurrence after the
-- first.
repetitions :: Vector Word64 -> Vector Word64
repetitions sorted = Primitive.ifilter (\i w -> i > 0 && w == sorted Primitive.! (i - 1)) sorted

-- | An index of a word in a sorted vector; 'Nothing' if it is not there.
indexSorted :: Vector Word64 -> Word64 -> Maybe Int
indexSorted sorted w = go 0 (Primitive.length sorted)
  where
    go !low !high
      | low >= high = Nothing
      | otherwise =
        let middle = (low + high) `div` 2
         in case compare w (sorted Primitive.! middle) of
              EQ -> Just middle
              LT -> go low middle
              GT -> go (middle + 1) high
