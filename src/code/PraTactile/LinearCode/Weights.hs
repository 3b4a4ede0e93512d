{-# OPTIONS_HADDOCK hide #-}

-- | The number of codewords of a linear code with each weight.
module PraTactile.LinearCode.Weights
  ( weight,
    weights,
    weightsOfDual,
  )
where

import Control.Monad (forM_)
import Data.List (tails, uncons)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Vector (addScaled)
import PraTactile.LinearCode
import PraTactile.LinearCode.Elimination

-- | The number of nonzero elements of a word.
weight :: Row k -> Int
weight = Primitive.foldl' (\n a -> if a == zero then n else n + 1) 0

-- | The binomial coefficient n over k; 0 if k is negative or above n.
binomial :: Int -> Int -> Natural
binomial n k
  | k < 0 || k > n = 0
  | otherwise =
    product (map fromIntegral [n - k + 1 .. n]) `div` product (map fromIntegral [1 .. k])

-- | The number of codewords with each weight that occurs. It visits one codeword of each class of
-- q - 1 nonzero multiples: (q^d - 1) / (q - 1) in all for dimension d.
weights :: forall k. KnownField k => LinearCode k -> Map Int Natural
weights code = Map.insert 0 1 (Map.map (units *) (Map.filter (> 0) counted))
  where
    units = fromIntegral (fieldOrder code - 1)
    counted = Map.fromDistinctAscList (zip [0 ..] (map fromIntegral (Primitive.toList tally)))
    tally = Primitive.create $ do
      counts <- Mutable.replicate (codeLength code + 1) (0 :: Int)
      let visit x others = case others of
            [] -> Mutable.modify counts (+ 1) (weight x)
            y : rest -> forM_ (elements :: [GF k]) $ \a -> visit (addScaled a y x) rest
      forM_ (tails (codeBasis code)) $ mapM_ (uncurry visit) . uncons
      pure counts

-- | The number of codewords of the dual code with each weight. Arguments: q; the code's length; its
-- own number of codewords with each weight. The formula is the identity of MacWilliams, with
-- Krawtchouk's polynomials.
weightsOfDual :: Int -> Int -> Map Int Natural -> Map Int Natural
weightsOfDual q size own =
  Map.filter
    (> 0)
    (Map.fromDistinctAscList [(j, fromInteger (total j `div` codewords)) | j <- [0 .. size]])
  where
    codewords = toInteger (sum (Map.elems own))
    total j = sum [toInteger count * krawtchouk j i | (i, count) <- Map.toList own]
    krawtchouk :: Int -> Int -> Integer
    krawtchouk j i =
      sum
        [ (-1) ^ s
            * toInteger (q - 1) ^ (j - s)
            * toInteger (binomial i s)
            * toInteger (binomial (size - i) (j - s))
          | s <- [0 .. j]
        ]
