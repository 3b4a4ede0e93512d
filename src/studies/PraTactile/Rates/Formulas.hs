-- | How often decoding to the guaranteed radius is right, wrong or refused, from the weights of a
-- code. Each observed cell is wrong with the same probability, and every wrong symbol is equally
-- probable. Let A(w) be the number of words with weight w. Let P(w) be the probability that an
-- error takes a word within the radius t of a given word that differs in w cells. Then
--
-- > right = sum_(e <= t) C(n, e) p^e (1 - p)^(n - e)
-- > wrong + refused as zero = sum_(w > 0) A(w) P(w)
--
-- (F. J. MacWilliams and N. J. A. Sloane 1977, chapter 16). Windows are the nonzero words, with
-- equal frequency. So among the other words that an error can lead to, one in (number of windows)
-- is zero, which is refused.
module PraTactile.Rates.Formulas
  ( -- * Rates
    Rates (..),
    BoundedDistance (..),
    decodingRates,
    reachProbability,
    mostCells,

    -- * With erasures
    erasedRates,
    ErasureRule (..),
  )
where

import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.LinearCode.Punctured
import PraTactile.Rates.Damage (Damage (..))

-- | Probabilities that add up to 1.
data Rates = Rates
  { rateRight :: Double,
    rateWrong :: Double,
    rateRefused :: Double
  }
  deriving stock (Eq, Show)

-- | The most cells of a word for which all numbers here stay within the range of a Double, 1000.
mostCells :: Natural
mostCells = 1000

-- | The parameters q, n, t and p of the formulas.
data BoundedDistance = BoundedDistance
  { -- | q, the number of symbols
    boundedSymbols :: !Int,
    -- | n, the number of observed cells in a word, at most 'mostCells'
    boundedCells :: !Int,
    -- | t, the number of wrong cells that are corrected
    boundedRadius :: !Int,
    -- | p, the probability that a cell is wrong
    boundedErrors :: !Double
  }
  deriving stock (Eq, Show)

-- | The rates, given the number of words of each weight, including zero. The radius must be
-- guaranteed: 2 t is less than the least weight, or t is 0. Every nonzero word must be one
-- position, as when the cells have rank n.
decodingRates :: BoundedDistance -> Map Natural Natural -> Rates
decodingRates decoding weights =
  radiusRates
    decoding
    (misled (windows - 1) [reachProbability decoding w * fromIntegral k | (w, k) <- others])
  where
    others = [(fromIntegral w, k) | (w, k) <- Map.toList weights, w > 0]
    windows = fromIntegral (sum (Map.elems weights))

-- | The share that are positions among the words that an error can lead to, given the number of
-- positions.
misled :: Double -> [Double] -> Double
misled positions reached = sum reached * (1 - 1 / positions)

-- | The rates, given the rate of wrong answers. Refusals are summed directly, because 1 minus the
-- others would lose small values.
radiusRates :: BoundedDistance -> Double -> Rates
radiusRates (BoundedDistance _ n t p) wrong = Rates (upTo t) wrong (max 0 (beyond - wrong))
  where
    upTo k = sum [binomialProbability n p e | e <- [0 .. k]]
    beyond = sum [binomialProbability n p e | e <- [t + 1 .. n]]

-- | The probability that an error on n cells ends within t of a given word that differs in w of
-- them. The remaining distance consists of those of these w cells that do not change to this word's
-- symbols, and of those other cells that are wrong.
reachProbability :: BoundedDistance -> Int -> Double
reachProbability (BoundedDistance q n t p) w =
  sum
    [ binomialProbability w hit (w - apart) * binomialProbability (n - w) p wrong
      | apart <- [0 .. min t w],
        wrong <- [0 .. min (t - apart) (n - w)]
    ]
  where
    hit = p / fromIntegral (q - 1)

-- | The probability that k of n independent events of probability p happen. A power of p may
-- underflow where the result does not. So powers are taken of significands, which leaves at least
-- 2^-n, and the exponents are added last.
binomialProbability :: Int -> Double -> Int -> Double
binomialProbability n p k =
  scaleFloat
    (exponent p * k + exponent (1 - p) * (n - k))
    (fromInteger choices * significand p ^ k * significand (1 - p) ^ (n - k))
  where
    choices = product [toInteger (n - k + 1) .. toInteger n] `div` product [1 .. toInteger k]

-- | The radius to which words with erasures are decoded.
data ErasureRule
  = -- | The guaranteed radius of the observed cells.
    ByObserved
  | -- | The radius that the whole window guarantees: with distance d and s erasures, all e with 2 e
    -- + s < d.
    ByWindow
  deriving stock (Eq, Show, Enum, Bounded)

-- | @erasedRates rule q code damage@ gives the rates when cells are also missing, each with the
-- damage's probability. Observed cells that are equal at two positions are refused, except zeros
-- that occur at only one position.
erasedRates :: ErasureRule -> Int -> Punctured -> Damage -> Rates
erasedRates rule q code (Damage p s) = Rates (total rateRight) (total rateWrong) (total rateRefused)
  where
    total rate =
      sum
        [ chance (classCells c) * fromIntegral (classSets c) * rate (classRates c)
          | c <- puncturedClasses code
        ]
    chance m = (1 - s) ^ m * s ^ (puncturedCells code - m)
    positions = fromIntegral (puncturedWords code)
    classRates c = case radiusOf c of
      Just t -> radiusRates (to t) (misled positions (reached t))
      -- Only zeros are an answer. A word of weight w becomes zero with the probability of reaching
      -- a word that differs in w cells.
      Nothing | classLoneZero c && m > 0 -> case splitAt 1 (reached 0) of
        (lone, others) -> certain (sum lone / positions) (sum others / positions)
      Nothing -> Rates 0 0 1
      where
        m = classCells c
        to t = BoundedDistance q m t p
        -- The average for one set over the sets of the class.
        reached t =
          [ reachProbability (to t) w * fromIntegral k / fromIntegral (classSets c)
            | (w, k) <- classWeights c
          ]
        certain right wrong = Rates right wrong (1 - right - wrong)
    radiusOf c
      | classDistance c == 0 = Nothing
      | otherwise = case rule of
        ByObserved -> Just ((classDistance c - 1) `div` 2)
        ByWindow | missing < whole -> Just ((whole - missing - 1) `div` 2)
        ByWindow -> Nothing
      where
        whole = puncturedDistance code
        missing = puncturedCells code - classCells c
