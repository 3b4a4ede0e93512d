-- | A model of readings with a stated error rate and exact probabilities. A cell is read as q
-- numbers, one for each symbol: 1 for the true symbol and 0 for the others, plus independent normal
-- noise of standard deviation sigma. The likeliest symbol has the largest number. It is wrong with
-- a probability that depends on sigma, and then is any other symbol with equal probability. Given
-- the numbers y, symbol b has a probability proportional to exp(y(b) / sigma^2), by Bayes' theorem.
module PraTactile.Rates.Noise
  ( errorRate,
    noiseFor,
  )
where

import PraTactile.Probability

-- | The probability that the largest of q numbers is not the true symbol's, for noise of this
-- standard deviation: 1 minus the integral of phi(x) Phi(x + 1/sigma)^(q - 1). The trapezoidal rule
-- is exact to many digits for such integrands.
errorRate :: Int -> Double -> Double
errorRate q sigma =
  sum (map (\x -> step * normalDensity x * (1 - reached x ^ (q - 1))) points)
  where
    reached x = normalDistribution (x + 1 / sigma)
    step = 0.025
    points = map ((* step) . fromIntegral) [-360 .. 360 :: Int]

-- | The standard deviation of the noise for which symbols are wrong with this probability, by
-- bisection. The probability must be at least 0 and below 1 - 1/q. For 0 the result is the smallest
-- that is tried, 0.01, where an error is 70 standard deviations away.
noiseFor :: Int -> Double -> Double
noiseFor q wanted = go (80 :: Int) 0.01 1e6
  where
    go 0 low _ = low
    go k low high
      | errorRate q middle > wanted = go (k - 1) low middle
      | otherwise = go (k - 1) middle high
      where
        middle = sqrt (low * high)
