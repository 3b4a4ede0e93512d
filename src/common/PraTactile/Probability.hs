-- | Numerics of probabilities: sums of numbers given by their logarithms, and the normal
-- distribution with mean 0 and variance 1.
module PraTactile.Probability
  ( logSum,
    normalDensity,
    normalDistribution,
  )
where

import Data.List (foldl')

-- | The logarithm of the sum of numbers, given their logarithms (log-sum-exp); minus infinity for
-- an empty list.
--
-- >>> abs (logSum [log 2 - 1000, log 3 - 1000] - (log 5 - 1000)) < 1e-12
-- True
logSum :: [Double] -> Double
logSum logs
  | null logs || isInfinite top = -1 / 0
  | otherwise = top + log (sum [exp (l - top) | l <- logs])
  where
    top = maximum logs

-- | The density of the normal distribution with mean 0 and variance 1.
normalDensity :: Double -> Double
normalDensity x = exp (-x * x / 2) / sqrt (2 * pi)

-- | The probability that a normal variable with mean 0 and variance 1 is at most this, to 2e-16. It
-- is computed by a quotient of polynomials (J. F. Hart 1968, formula 5666; G. West, Wilmott
-- Magazine, May 2005), and beyond 7 by a continued fraction.
--
-- >>> abs (normalDistribution (-1) - 0.15865525393145705) < 1e-15
-- True
normalDistribution :: Double -> Double
normalDistribution x
  | x > 0 = 1 - beyond
  | otherwise = beyond
  where
    a = abs x
    beyond
      | a < 7.07106781186547 = exp (-a * a / 2) * horner above / horner below
      | otherwise = normalDensity a / (a + 1 / (a + 2 / (a + 3 / (a + 4 / (a + 0.65)))))
    horner = foldl' (\sofar c -> sofar * a + c) 0
    above =
      [ 0.0352624965998911,
        0.700383064443688,
        6.37396220353165,
        33.912866078383,
        112.079291497871,
        221.213596169931,
        220.206867912376
      ]
    below =
      [ 0.0883883476483184,
        1.75566716318264,
        16.064177579207,
        86.7807322029461,
        296.564248779674,
        637.333633378831,
        793.826512519948,
        440.413735824752
      ]
