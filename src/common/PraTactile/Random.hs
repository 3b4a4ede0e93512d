-- | Random draws for the simulation and the training. Each function takes a generator and returns
-- the next one.
--
-- The draws are made from the generator's 64-bit words alone, so that one seed gives one result
-- under every version of the random package.
module PraTactile.Random
  ( -- * Uniform
    uniform,

    -- * Normal
    normal,
    normalPair,
    normals,
  )
where

import Data.Bits (shiftR)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import System.Random (RandomGen, genWord64)

-- | A draw from the multiples of 2^-53 in [0, 1), with equal probabilities.
uniform :: RandomGen g => g -> (Double, g)
uniform g = (fromIntegral (word `shiftR` 11) / 9007199254740992, g')
  where
    (word, g') = genWord64 g
{-# INLINE uniform #-}

-- | Two independent draws from the normal distribution of mean 0 and variance 1, by Box and
-- Muller's formula (Ann. Math. Statist. 29, 1958): sqrt (-2 ln u) times the cosine and the sine of
-- 2 pi v, for u in (0, 1] and v in [0, 1).
normalPair :: RandomGen g => g -> ((Double, Double), g)
normalPair g = ((radius * cos angle, radius * sin angle), g'')
  where
    (u, g') = uniform g
    (v, g'') = uniform g'
    radius = sqrt (-2 * log (1 - u))
    angle = 2 * pi * v
{-# INLINE normalPair #-}

-- | One draw from the normal distribution of mean 0 and variance 1: the first of a 'normalPair'.
normal :: RandomGen g => g -> (Double, g)
normal g = let ((a, _), g') = normalPair g in (a, g')
{-# INLINE normal #-}

-- | This number of draws from the normal distribution with mean 0 and variance 1, two from each
-- 'normalPair'. A negative number counts as 0.
normals :: RandomGen g => Int -> g -> (Vector Double, g)
normals n g0 = (V.fromListN n' (take n' drawn), end)
  where
    n' = max 0 n
    (drawn, end) = go ((n' + 1) `div` 2) g0
    go :: RandomGen g => Int -> g -> ([Double], g)
    go 0 g = ([], g)
    go k g =
      let ((a, b), g') = normalPair g
          (rest, g'') = go (k - 1) g'
       in (a : b : rest, g'')
{-# INLINEABLE normals #-}
