{-# OPTIONS_HADDOCK hide #-}

-- | The term of the sequence that a cell holds, by the Chinese remainder theorem. Internal: used by
-- arrays, array codes and the adviser.
module PraTactile.Array.Remainder
  ( Weights,
    diagonalWeights,
    weightedIndex,
  )
where

import Numeric.Natural (Natural)

-- | (u, v): the cell in row r and column c holds the term of index r u + c v.
type Weights = (Natural, Natural)

-- | The weights of the diagonal of n1 x n2 cells, for coprime n1 and n2: the index i with i = r
-- modulo n1 and i = c modulo n2 is r u + c v modulo n1 n2.
--
-- >>> diagonalWeights 3 5
-- (10,6)
diagonalWeights :: Natural -> Natural -> Weights
diagonalWeights n1 n2 = (n2 * inverseModulo n1 n2, n1 * inverseModulo n2 n1)

-- | @weightedIndex period (u, v) r c@ is r u + c v modulo the period.
weightedIndex :: Natural -> Weights -> Natural -> Natural -> Natural
weightedIndex terms (u, v) r c = (r * u + c * v) `mod` max 1 terms

-- | @inverseModulo m a@ is the inverse of a modulo m. Both must be coprime, which is not checked. 0
-- modulo 1.
inverseModulo :: Natural -> Natural -> Natural
inverseModulo m a =
  fromInteger (go (toInteger m, 0) (toInteger a `mod` toInteger m, 1) `mod` toInteger m)
  where
    -- Each pair (r, t) keeps t a = r modulo m.
    go :: (Integer, Integer) -> (Integer, Integer) -> Integer
    go (_, t) (0, _) = t
    go (r, t) (r', t') = go (r', t') (r - (r `div` r') * r', t - (r `div` r') * t')
