{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_GHC -O2 #-}

-- | One simulated reading of a patch.
module PraTactile.Rates.Trial
  ( PatchTrial (..),
    drawTrial,
  )
where

import Control.Monad (when)
import Control.Monad.ST (ST, runST)
import Data.Bits (bit, shiftR, testBit, (.&.), (.|.))
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Data.Vector.Primitive.Mutable (MVector)
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word64)
import PraTactile.Field
import PraTactile.Random (normalPair, uniform)
import PraTactile.Rates.Setup
import System.Random (StdGen)

-- | A reading of a patch, and its true position.
data PatchTrial = PatchTrial
  { -- | The index of the true position, row by row.
    trialPosition :: !Int,
    -- | For each limb: the cells that were observed.
    trialSeen :: !(Vector Word64),
    -- | For each limb and binary digit: that digit of the likeliest symbols; 0 in cells that were
    -- not observed.
    trialSymbols :: !(Vector Word64),
    -- | For each cell and each symbol its log-probability, up to a constant for each cell; 0 in
    -- cells that were not observed.
    trialEvidence :: !(Vector Double)
  }

-- | Reads a patch at a random position by the model of "PraTactile.Rates.Noise". In @drawTrial
-- setup sigma missing@ the noise has standard deviation sigma, and each cell is missing with the
-- given probability.
drawTrial ::
  forall k. KnownField k => TrialSetup k -> Double -> Double -> StdGen -> (PatchTrial, StdGen)
drawTrial setup sigma missing g0 = runST $ do
  seen <- Mutable.replicate limbs 0
  symbols <- Mutable.replicate (limbs * planes) 0
  evidence <- Mutable.replicate (n * q) 0
  let -- Cell j is in limb j / 64, and its evidence begins at j q.
      readCells !j !g
        | j == n = pure g
        | u < missing = readCells (j + 1) g'
        | otherwise = do
          g'' <- drawNoise spread evidence (j * q) ((j + 1) * q) g'
          Mutable.unsafeModify evidence (+ gain) (trueSymbol j)
          symbol <- largestOf q evidence (j * q)
          Mutable.unsafeModify seen (.|. bit (j .&. 63)) (j `shiftR` 6)
          writeDigits planes symbols j symbol
          readCells (j + 1) g''
        where
          (u, g') = uniform g
  g <- readCells 0 g1
  trial <-
    PatchTrial position
      <$> Primitive.unsafeFreeze seen
      <*> Primitive.unsafeFreeze symbols
      <*> Primitive.unsafeFreeze evidence
  pure (trial, g)
  where
    n = setupCells setup
    q = fieldOrder (Proxy :: Proxy k)
    limbs = setupLimbs setup
    planes = setupPlanes setup
    positions = setupPositions setup
    (drawn, g1) = uniform g0
    position = min (positions - 1) (floor (drawn * fromIntegral positions))
    gain = 1 / (sigma * sigma)
    spread = 1 / sigma
    trueSymbol j = fromIntegral (Primitive.unsafeIndex (setupContents setup) (position * n + j))

-- | Draws normal numbers with this standard deviation into the entries from one index up to
-- another.
drawNoise :: Double -> MVector s Double -> Int -> Int -> StdGen -> ST s StdGen
drawNoise spread evidence = go
  where
    go !i !end !g
      | i >= end = pure g
      | otherwise = do
        let ((a, b), g') = normalPair g
        Mutable.unsafeWrite evidence i (a * spread)
        when (i + 1 < end) (Mutable.unsafeWrite evidence (i + 1) (b * spread))
        go (i + 2) end g'
{-# INLINE drawNoise #-}

-- | The offset of the largest of q entries from this index on, the first one if there are several.
largestOf :: Int -> MVector s Double -> Int -> ST s Int
largestOf q evidence = \from -> go from 1 0
  where
    go !from !b !best
      | b == q = pure best
      | otherwise = do
        x <- Mutable.unsafeRead evidence (from + b)
        y <- Mutable.unsafeRead evidence (from + best)
        go from (b + 1) (if x > y then b else best)
{-# INLINE largestOf #-}

-- | Sets the bit of a cell in those planes of its limb for which its symbol has the binary digit 1.
writeDigits :: Int -> MVector s Word64 -> Int -> Int -> ST s ()
writeDigits planes symbols = \j symbol -> go j symbol 0
  where
    go !j !symbol !b
      | b == planes = pure ()
      | otherwise = do
        when
          (testBit symbol b)
          (Mutable.unsafeModify symbols (.|. bit (j .&. 63)) ((j `shiftR` 6) * planes + b))
        go j symbol (b + 1)
{-# INLINE writeDigits #-}
