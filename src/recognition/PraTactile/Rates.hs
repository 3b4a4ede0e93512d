{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE ScopedTypeVariables #-}
-- | How often damaged patches are located right, wrong, or refused: simulated readings of patches at random positions, decoded from symbols
-- alone (hard) and from the same cells' class probabilities (soft).
--
-- A cell is read as q numbers, one a symbol: the true symbol's is 1 and the others' 0, each with normal noise of one standard deviation
-- added. The likeliest symbol is that of the largest number; it is wrong with a probability that the noise sets, and then any of the
-- others alike. The honest probabilities of the symbols are proportional to exp(number / variance).
module PraTactile.Rates
  ( -- * Damage
    Damage (..)
  , noiseFor
  , errorRate
    -- * Trials
  , simulate
  , Tally (..)
  , merge
    -- * Rates
  , hardRates
  , softRates
  , softRatesAtMost
  , wrongAmong
  ) where

import Data.List (foldl')
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import System.Random (StdGen, mkStdGen)

import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Book
import PraTactile.Locate.Nearest
import PraTactile.Locate.Rates
import PraTactile.Locate.Soft
import PraTactile.Random (normal, uniform)

-- | What befalls each cell, independently.
data Damage = Damage
  { damageErrors :: !Double     -- ^ the probability that the likeliest symbol of an observed cell is wrong
  , damageErasures :: !Double   -- ^ the probability that a cell is not observed
  }
  deriving stock (Eq, Show)

-- | The probability that the largest of q numbers is not the true symbol's, with noise of this standard deviation: 1 less the integral of
-- phi(x) Phi(x + 1/sigma)^(q - 1), by the trapezoidal rule, which for such integrands is exact to many digits.
errorRate :: Int -> Double -> Double
errorRate q sigma = sum [step * density x * (1 - distribution (x + 1 / sigma) ^ (q - 1)) | i <- [-360 .. 360 :: Int], let x = step * fromIntegral i]
  where
    step = 0.025

density :: Double -> Double
density x = exp (-x * x / 2) / sqrt (2 * pi)

-- | The normal distribution, by its Taylor series (G. Marsaglia, J. Stat. Softw. 11, 2004).
distribution :: Double -> Double
distribution x
  | x < -8 = 0
  | x > 8 = 1
  | otherwise = 0.5 + density x * go x x 3
  where
    go term total k =
      let term' = term * x * x / k
      in if total + term' == total then total else go term' (total + term') (k + 2 :: Double)

-- | The noise, as a standard deviation, with which symbols are wrong with this probability, which is between 0 and 1 - 1/q: by bisection.
noiseFor :: Int -> Double -> Double
noiseFor q wanted = go (60 :: Int) 0.01 100
  where
    go 0 low _ = low
    go k low high
      | errorRate q middle > wanted = go (k - 1) low middle
      | otherwise = go (k - 1) middle high
      where
        middle = sqrt (low * high)

-- | Counts of trials.
data Tally = Tally
  { tallyTrials :: !Int
  , tallyRight :: !Int        -- ^ by hard decoding
  , tallyWrong :: !Int        -- ^ by hard decoding; the others were refused
  , tallyDoubts :: !(Map Int Soft)
    -- ^ soft decoding: by doubt, in 50ths of a power of ten
  }
  deriving stock (Eq, Show)

-- | Of the trials with about the same doubt: how many, in how many the likeliest position was the true one, and the sum of the doubts, which
-- is the number of wrong ones to be expected.
data Soft = Soft !Int !Int !Double
  deriving stock (Eq, Show)

-- | The counts together.
merge :: [Tally] -> Tally
merge = foldl' add (Tally 0 0 0 Map.empty)
  where
    add (Tally n a b m) (Tally n' a' b' m') = Tally (n + n') (a + a') (b + b') (Map.unionWith plus m m')

plus :: Soft -> Soft -> Soft
plus (Soft n a s) (Soft n' a' s') = Soft (n + n') (a + a') (s + s')

-- | Simulate so many trials with patches of this shape, from a seed.
simulate :: forall k. KnownField k => Book k -> Shape -> Damage -> Int -> Int -> Tally
simulate shelf size damage trials seed = go trials (mkStdGen seed) (Tally 0 0 0 Map.empty)
  where
    q = fieldOrder (Proxy :: Proxy k)
    sigma = noiseFor q (damageErrors damage)
    go :: Int -> StdGen -> Tally -> Tally
    go 0 _ !counts = counts
    go left g !counts =
      let (place, readings, g') = draw shelf size sigma (damageErasures damage) g
      in go (left - 1) g' (count place readings counts)
    count place readings counts = either (const counts) (judge counts place) $ do
      soft <- softPatch readings
      hard <- hardened soft
      Right (decisionOutcome (nearest shelf Guaranteed hard), posterior shelf soft)
    judge (Tally n right wrong doubts) place (outcome, found) = Tally (n + 1) (right + hit) (wrong + miss) (Map.insertWith plus bin soft doubts)
      where
        (hit, miss) = case outcome of
          Located at _ | at == place -> (1, 0)
          Located _ _ -> (0, 1)
          _ -> (0, 0)
        doubt = posteriorDoubt found
        bin = max 0 (min 1000 (if doubt <= 0 then 1000 else floor (-50 * logBase 10 doubt)))
        soft = Soft 1 (if posteriorBest found == Just place then 1 else 0) doubt

-- | A patch at a random position, read with noise.
draw :: forall k. KnownField k => Book k -> Shape -> Double -> Double -> StdGen -> (Position, [[Maybe (Belief k)]], StdGen)
draw shelf (Shape high wide) sigma erased g0 = (place, readings, g3)
  where
    array = bookArray shelf
    (r, g1) = below (rows (arrayShape array)) g0
    (c, g2) = below (columns (arrayShape array)) g1
    place = Position r c
    below n g = let (u, g') = uniform g in (min (n - 1) (floor (u * fromIntegral n)), g')
    (readings, g3) = through (\i g -> through (\j -> readCell (cellAt array (Position (r + i) (c + j)))) (upTo wide) g) (upTo high) g2
    upTo n = takeWhile (< n) [0 ..]
    readCell a g
      | u < erased = (Nothing, g')
      | otherwise = (either (const Nothing) Just (belief (map (/ total) weights)), g'')
      where
        (u, g') = uniform g
        (numbers, g'') = through (\b h -> let (noise, h') = normal h in ((if b == a then 1 else 0) + sigma * noise, h')) elements g'
        largest = maximum numbers
        weights = map (\y -> exp ((y - largest) / (sigma * sigma))) numbers
        total = sum weights

-- | One after another, the generator handed on.
through :: (a -> StdGen -> (b, StdGen)) -> [a] -> StdGen -> ([b], StdGen)
through _ [] g = ([], g)
through f (x : xs) g = let (y, g') = f x g; (ys, g'') = through f xs g' in (y : ys, g'')

-- | The rates of hard decoding to the radius of the cells observed.
hardRates :: Tally -> Rates
hardRates tally = ratesOf tally (tallyRight tally) (tallyWrong tally)

-- | The rates of soft decoding where this probability of a wrong answer is tolerated, to a 50th of a power of ten.
softRates :: Double -> Tally -> Rates
softRates tolerated tally = answered tally (Map.elems (tolerable tolerated tally))

-- | The rates of soft decoding that answers where the doubt is least, as often as the wrong answers to be expected stay at most this share of
-- all trials.
softRatesAtMost :: Double -> Tally -> Rates
softRatesAtMost share tally = answered tally (go 0 (map snd (Map.toDescList (tallyDoubts tally))))
  where
    budget = share * fromIntegral (tallyTrials tally)
    go _ [] = []
    go spent (soft@(Soft _ _ doubts) : others)
      | spent + doubts > budget = []
      | otherwise = soft : go (spent + doubts) others

-- | Among the answers of soft decoding where this probability of a wrong answer is tolerated: how many, how many wrong ones are to be expected, and how many
-- there were.
wrongAmong :: Double -> Tally -> (Int, Double, Int)
wrongAmong tolerated tally = (count, doubts, count - right)
  where
    Soft count right doubts = foldl' plus (Soft 0 0 0) (Map.elems (tolerable tolerated tally))

tolerable :: Double -> Tally -> Map Int Soft
tolerable tolerated = Map.filterWithKey (\bin _ -> bin >= least) . tallyDoubts
  where
    least = ceiling (-50 * logBase 10 tolerated - 1e-9) :: Int

answered :: Tally -> [Soft] -> Rates
answered tally given = ratesOf tally right (count - right)
  where
    Soft count right _ = foldl' plus (Soft 0 0 0) given

ratesOf :: Tally -> Int -> Int -> Rates
ratesOf tally right wrong = Rates (share right) (share wrong) (share (tallyTrials tally - right - wrong))
  where
    share n = fromIntegral n / fromIntegral (max 1 (tallyTrials tally))
