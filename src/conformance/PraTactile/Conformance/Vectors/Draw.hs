-- | Random draws for test vectors, from 64-bit words only, so that a seed gives the same vectors
-- under every version of the random package.
module PraTactile.Conformance.Vectors.Draw
  ( Draw,
    drawn,
    below,
    chosen,
    shareOf,
  )
where

import Control.Monad.Trans.State.Strict (State, evalState, state)
import Numeric.Natural (Natural)
import System.Random (StdGen, genWord64, mkStdGen)

-- | Something drawn.
type Draw = State StdGen

-- | The value drawn from a seed.
drawn :: Int -> Draw a -> a
drawn seed draw = evalState draw (mkStdGen seed)

-- | A number below n > 0. The deviation from uniformity is below 2^-32 for n below 2^32.
below :: Natural -> Draw Natural
below n = (`mod` n) <$> number
  where
    words' = 1 + length (takeWhile (>= 2 ^ (32 :: Int)) (iterate (`div` 2 ^ (64 :: Int)) n))
    number = foldr joined 0 <$> traverse (const word) [1 .. words']
    joined w total = 2 ^ (64 :: Int) * total + w
    word = fromIntegral <$> state genWord64

-- | One of the values, uniformly.
chosen :: a -> [a] -> Draw a
chosen first others = pick . fromIntegral <$> below (fromIntegral (1 + length others))
  where
    pick i = case drop i (first : others) of
      a : _ -> a
      [] -> first

-- | The first draw with the given probability in hundredths, otherwise the second.
shareOf :: Natural -> Draw a -> Draw a -> Draw a
shareOf hundredths a b = below 100 >>= \n -> if n < hundredths then a else b
