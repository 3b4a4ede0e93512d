{-# LANGUAGE DerivingStrategies #-}

-- |
-- How often decoding to the guaranteed radius is right, wrong and refused, from the weights of a
-- code, when each observed cell is wrong with the same probability, every wrong symbol being equally
-- likely. With A(w) words of weight w and P(w) the probability that an error takes a word within the radius t of
-- a given word w cells away,
--
-- > right = sum_(e <= t) C(n, e) p^e (1 - p)^(n - e),   wrong + refused as zero = sum_(w > 0) A(w) P(w)
--
-- (F. J. MacWilliams and N. J. A. Sloane 1977, chapter 16). A window is any of the words but zero, all equally often, so
-- that of the other words that an error can lead to, one in (number of windows) is zero, which is refused.
module PraTactile.Locate.Rates
  ( -- * Rates
    Rates (..)
  , decodingRates
  , reachProbability

    -- * With erasures
  , erasedRates
  , ErasureRule (..)
  , mostErasedCells
  ) where

import Data.Bits (popCount, (.&.))
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)

-- | Probabilities that add up to 1.
data Rates = Rates
  { rateRight :: Double
  , rateWrong :: Double
  , rateRefused :: Double
  }
  deriving stock (Eq, Show)

-- | @decodingRates q n weights t p@: of words of n observed cells over q symbols, with so many words of each weight, zero among
-- them; decoded to the radius t, which must be a guaranteed one (2 t less than the least weight, or 0); each cell wrong with
-- probability p. Every word but zero must be one position, as where the cells have rank n.
decodingRates :: Int -> Int -> Map Natural Natural -> Int -> Double -> Rates
decodingRates q n weights t p = Rates right wrong (max 0 (1 - right - wrong))
 where
  right = sum [fromInteger (binomial n e) * p ^ e * (1 - p) ^ (n - e) | e <- [0 .. t]]
  reached = sum [fromIntegral count * reachProbability q n t p (fromIntegral w) | (w, count) <- Map.toList weights, w > 0]
  windows = fromIntegral (sum (Map.elems weights)) - 1
  wrong = reached * (1 - 1 / windows)

-- | @reachProbability q n t p w@: that an error on n cells ends within t of one given word that differs in w of them: a of these w cells become
-- other wrong symbols, b stay right, and c of the other n - w become wrong, a + b + c <= t.
reachProbability :: Int -> Int -> Int -> Double -> Int -> Double
reachProbability q n t p w =
  sum
    [ fromInteger (binomial w a * binomial (w - a) b * binomial (n - w) c * toInteger (q - 2) ^ a * toInteger (q - 1) ^ c)
        * (p / fromIntegral (q - 1)) ^ (w - b + c)
        * (1 - p) ^ (n - w + b - c)
    | a <- [0 .. min t w]
    , b <- [0 .. min (t - a) (w - a)]
    , c <- [0 .. min (t - a - b) (n - w)]
    ]

binomial :: Int -> Int -> Integer
binomial n k = product [toInteger (n - k + 1) .. toInteger n] `div` product [1 .. toInteger k]

-- | How far words with erasures are decoded.
data ErasureRule
  = -- | To the radius of the cells that were observed.
    ByObserved
  | -- | To what the whole window promises: with distance d and s erasures, all e with 2 e + s < d.
    ByWindow
  deriving stock (Eq, Show, Enum, Bounded)

-- | 16: the most cells for which all sets of erasures are visited.
mostErasedCells :: Int
mostErasedCells = 16

-- | @erasedRates rule q supports n p s@: as 'decodingRates' when each of the n cells is also missing with probability s, independently; by
-- visiting all 2^n sets of missing cells. The supports are those of all words but zero: bit i for the cell i, if it is not zero. Patches that
-- do not tell all positions apart are refused. 'Nothing' beyond 'mostErasedCells'.
erasedRates :: ErasureRule -> Int -> [Int] -> Int -> Double -> Double -> Maybe Rates
erasedRates rule q supports n p s
  | n > mostErasedCells = Nothing
  | otherwise = Just (Map.foldrWithKey add (Rates 0 0 0) patterns)
 where
  whole = minimum (maxBound : map popCount supports)
  -- How probable each number of observed cells with each distribution of weights is.
  patterns = Map.fromListWith (+) [(classOf observed, chance (popCount observed)) | observed <- [0 .. 2 ^ n - 1 :: Int]]
  chance m = (1 - s) ^ m * s ^ (n - m)
  classOf observed = (popCount observed, Map.toList (Map.fromListWith (+) [(fromIntegral (popCount (x .&. observed)), 1) | x <- supports]))
  add (m, counted) weight (Rates a b c) = Rates (a + weight * a') (b + weight * b') (c + weight * c')
   where
    Rates a' b' c' = case radius of
      Nothing -> Rates 0 0 1
      Just t -> decodingRates q m (Map.insertWith (+) 0 1 (Map.fromList counted)) t p
    d = minimum (maxBound : map (fromIntegral . fst) counted) :: Int
    radius
      | d == 0 || null counted = Nothing
      | otherwise = case rule of
          ByObserved -> Just ((d - 1) `div` 2)
          ByWindow | n - m < whole -> Just ((whole - (n - m) - 1) `div` 2)
          ByWindow -> Nothing
