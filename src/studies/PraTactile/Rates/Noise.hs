-- | Readings of a cell with a stated error rate and exact probabilities. A cell is read as q
-- numbers, one for each symbol: the true symbol's is 1 and the others' are 0, plus independent
-- normal noise of standard deviation sigma. The likeliest symbol is that of the largest number; it
-- is wrong with a probability that sigma sets, and then any of the others alike. Given the numbers
-- y, the symbol b has a probability proportional to exp(y(b) / sigma^2), by Bayes' theorem.
module PraTactile.Rates.Noise
  ( errorRate,
    noiseFor,
  )
where

import PraTactile.Probability

-- | The probability that the largest of q numbers is not the true symbol's, with noise of this
-- standard deviation: 1 less the integral of phi(x) Phi(x + 1/sigma)^(q - 1), by the trapezoidal
-- rule, which for such integrands is exact to many digits.
errorRate :: Int -> Double -> Double
errorRate q sigma =
  sum (map (\x -> step * normalDensity x * (1 - reached x ^ (q - 1))) points)
  where
    reached x = normalDistribution (x + 1 / sigma)
    step = 0.025
    points = map ((* step) . fromIntegral) [-360 .. 360 :: Int]

-- | The noise, as a standard deviation, with which symbols are wrong with this probability, which
-- is at least 0 and less than 1 - 1/q: by bisection. For 0 it is the least that is tried, 0.01,
-- where an error is one of 70 standard deviations.
noiseFor :: Int -> Double -> Double
noiseFor q wanted = go (80 :: Int) 0.01 1e6
  where
    go 0 low _ = low
    go k low high
      | errorRate q middle > wanted = go (k - 1) low middle
      | otherwise = go (k - 1) middle high
      where
        middle = sqrt (low * high)
