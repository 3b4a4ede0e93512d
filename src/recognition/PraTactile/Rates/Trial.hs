{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_GHC -O2 #-}

-- | One simulated reading of a patch.
module PraTactile.Rates.Trial
  ( Trial (..),
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
import PraTactile.Rates.Ground
import System.Random (StdGen)

-- | A patch as it was read, and where.
data Trial = Trial
  { -- | The index of the true position, row by row.
    trialPosition :: !Int,
    -- | For each limb: which cells were observed.
    trialSeen :: !(Vector Word64),
    -- | For each limb and binary digit: the digits of the likeliest symbols; 0 in cells that were
    -- not observed.
    trialSymbols :: !(Vector Word64),
    -- | For each cell and each symbol the logarithm of its probability, up to a number for each
    -- cell; 0 in cells that were not observed.
    trialEvidence :: !(Vector Double)
  }

-- | A patch at a random position, read as "PraTactile.Rates.Noise" has it: @drawTrial place sigma
-- missing@, with noise of the standard deviation sigma, each of its cells missing with this
-- probability.
drawTrial :: forall k. KnownField k => Ground k -> Double -> Double -> StdGen -> (Trial, StdGen)
drawTrial place sigma missing g0 = runST $ do
  seen <- Mutable.replicate limbs 0
  symbols <- Mutable.replicate (limbs * planes) 0
  evidence <- Mutable.replicate (n * q) 0
  g <- readCells seen symbols evidence 0 g1
  trial <-
    Trial position
      <$> Primitive.unsafeFreeze seen
      <*> Primitive.unsafeFreeze symbols
      <*> Primitive.unsafeFreeze evidence
  pure (trial, g)
  where
    n = groundCells place
    q = fieldOrder (Proxy :: Proxy k)
    limbs = groundLimbs place
    planes = groundPlanes place
    positions = groundPositions place
    (drawn, g1) = uniform g0
    position = min (positions - 1) (floor (drawn * fromIntegral positions))
    gain = 1 / (sigma * sigma)
    spread = 1 / sigma
    -- A cell j is in the limb j / 64, and its evidence from j q on.
    readCells ::
      MVector s Word64 ->
      MVector s Word64 ->
      MVector s Double ->
      Int ->
      StdGen ->
      ST s StdGen
    readCells seen symbols evidence = cell
      where
        cell !j !g
          | j == n = pure g
          | u < missing = cell (j + 1) g'
          | otherwise = do
            g'' <- noise (j * q) ((j + 1) * q) g'
            Mutable.unsafeModify
              evidence
              (+ gain)
              (fromIntegral (Primitive.unsafeIndex (groundContents place) (position * n + j)))
            symbol <- largest (j * q) 1 0
            Mutable.unsafeModify seen (.|. bit (j .&. 63)) (j `shiftR` 6)
            write j symbol 0
            cell (j + 1) g''
          where
            (u, g') = uniform g
        noise !i !end !g
          | i >= end = pure g
          | otherwise = do
            let ((a, b), g') = normalPair g
            Mutable.unsafeWrite evidence i (a * spread)
            when (i + 1 < end) (Mutable.unsafeWrite evidence (i + 1) (b * spread))
            noise (i + 2) end g'
        largest !from !b !best
          | b == q = pure best
          | otherwise = do
            x <- Mutable.unsafeRead evidence (from + b)
            y <- Mutable.unsafeRead evidence (from + best)
            largest from (b + 1) (if x > y then b else best)
        write !j !symbol !b
          | b == planes = pure ()
          | otherwise = do
            when
              (testBit (symbol :: Int) b)
              (Mutable.unsafeModify symbols (.|. bit (j .&. 63)) ((j `shiftR` 6) * planes + b))
            write j symbol (b + 1)
