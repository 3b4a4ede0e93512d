-- | How often decoding to the guaranteed radius is right, wrong and refused, from the weights of a
-- code, when each observed cell is wrong with the same probability, every wrong symbol being
-- equally likely. With A(w) words of weight w and P(w) the probability that an error takes a word
-- within the radius t of a given word w cells away,
--
-- > right = sum_(e <= t) C(n, e) p^e (1 - p)^(n - e)
-- > wrong + refused as zero = sum_(w > 0) A(w) P(w)
--
-- (F. J. MacWilliams and N. J. A. Sloane 1977, chapter 16). A window is any of the words but zero,
-- all equally often, so that of the other words that an error can lead to, one in (number of
-- windows) is zero, which is refused.
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

-- | 1000: the most cells of a word for which all numbers here stay within a double's range.
mostCells :: Natural
mostCells = 1000

-- | Words that are decoded to a radius: q, n, t and p of the formulas.
data BoundedDistance = BoundedDistance
  { -- | q, the number of symbols
    boundedSymbols :: !Int,
    -- | n, of how many observed cells a word is: at most 'mostCells'
    boundedCells :: !Int,
    -- | t, how many wrong cells are corrected
    boundedRadius :: !Int,
    -- | p, how probable it is of each cell that it is wrong
    boundedErrors :: !Double
  }
  deriving stock (Eq, Show)

-- | The rates given the number of words of each weight, zero among them. The radius must be a
-- guaranteed one (2 t less than the least weight, or 0), and every word but zero one position, as
-- where the cells have rank n.
decodingRates :: BoundedDistance -> Map Natural Natural -> Rates
decodingRates decoding weights =
  radiusRates
    decoding
    (misled (windows - 1) [reachProbability decoding w * fromIntegral k | (w, k) <- others])
  where
    others = [(fromIntegral w, k) | (w, k) <- Map.toList weights, w > 0]
    windows = fromIntegral (sum (Map.elems weights))

-- | Of all that an error can lead to, the part that is a position, given the number of these.
misled :: Double -> [Double] -> Double
misled positions reached = sum reached * (1 - 1 / positions)

-- | The rates given how often an answer is wrong. What is refused is added up by itself, as the
-- difference of 1 and the others would lose it where it is small.
radiusRates :: BoundedDistance -> Double -> Rates
radiusRates (BoundedDistance _ n t p) wrong = Rates (upTo t) wrong (max 0 (beyond - wrong))
  where
    upTo k = sum [binomialProbability n p e | e <- [0 .. k]]
    beyond = sum [binomialProbability n p e | e <- [t + 1 .. n]]

-- | The probability that an error on n cells ends within t of one given word that differs in w of
-- them. It stays away from it by those of these w cells that do not turn into just
-- this word's symbols, and by those of the others that are wrong.
reachProbability :: BoundedDistance -> Int -> Double
reachProbability (BoundedDistance q n t p) w =
  sum
    [ binomialProbability w hit (w - apart) * binomialProbability (n - w) p wrong
      | apart <- [0 .. min t w],
        wrong <- [0 .. min (t - apart) (n - w)]
    ]
  where
    hit = p / fromIntegral (q - 1)

-- | That of n independent events of probability p, k happen. A power of p may be less than any
-- double where the whole is not: so powers are taken of significands, which leaves 2^-n at least,
-- and the exponents are added last.
binomialProbability :: Int -> Double -> Int -> Double
binomialProbability n p k =
  scaleFloat
    (exponent p * k + exponent (1 - p) * (n - k))
    (fromInteger choices * significand p ^ k * significand (1 - p) ^ (n - k))
  where
    choices = product [toInteger (n - k + 1) .. toInteger n] `div` product [1 .. toInteger k]

-- | How far words with erasures are decoded.
data ErasureRule
  = -- | To the radius of the cells that were observed.
    ByObserved
  | -- | To what the whole window promises: with distance d and s erasures, all e with 2 e + s < d.
    ByWindow
  deriving stock (Eq, Show, Enum, Bounded)

-- | @erasedRates rule q code damage@: as 'decodingRates' when cells are also missing, each with the
-- probability that the damage has. Observed cells that are alike at two positions are refused, but
-- for zeros that occur at one position only.
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
      -- Only zeros are an answer, in which a word of weight w ends with the probability of reaching
      -- a word as far away.
      Nothing | classLoneZero c && m > 0 -> case splitAt 1 (reached 0) of
        (lone, others) -> certain (sum lone / positions) (sum others / positions)
      Nothing -> Rates 0 0 1
      where
        m = classCells c
        to t = BoundedDistance q m t p
        -- Of one set, on the average over those of the class.
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
