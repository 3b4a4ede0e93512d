{-# OPTIONS_HADDOCK hide #-}

-- | Exact vectors of fractions, for points that move between integer places.
module PraTactile.Object.VectorQ
  ( Q3,
    exactly,
    less,
    inner,
    plusTimes,
  )
where

import PraTactile.Object.Vector (V3 (..))

-- | A point or vector with rational coordinates.
type Q3 = (Rational, Rational, Rational)

-- | An integer vector as a vector of fractions.
exactly :: V3 -> Q3
exactly (V3 x y z) = (fromInteger x, fromInteger y, fromInteger z)

-- | The first vector minus the second.
less :: Q3 -> Q3 -> Q3
less (a, b, c) (d, e, f) = (a - d, b - e, c - f)

-- | The scalar product of two vectors of fractions.
inner :: Q3 -> Q3 -> Rational
inner (a, b, c) (d, e, f) = a * d + b * e + c * f

-- | A vector plus a number times another vector.
plusTimes :: Q3 -> (Rational, Q3) -> Q3
plusTimes (a, b, c) (k, (x, y, z)) = (a + k * x, b + k * y, c + k * z)
