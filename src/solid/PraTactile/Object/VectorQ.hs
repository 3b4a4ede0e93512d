{-# OPTIONS_HADDOCK hide #-}

-- | Exact vectors of fractions, where points move to places between the whole units.
module PraTactile.Object.VectorQ
  ( Q3,
    exactly,
    less,
    inner,
    plusTimes,
  )
where

import PraTactile.Object.Vector (V3 (..))

-- | A point or a vector of fractions of a unit.
type Q3 = (Rational, Rational, Rational)

-- | The same vector.
exactly :: V3 -> Q3
exactly (V3 x y z) = (fromInteger x, fromInteger y, fromInteger z)

-- | The difference of two vectors of fractions.
less :: Q3 -> Q3 -> Q3
less (a, b, c) (d, e, f) = (a - d, b - e, c - f)

-- | The scalar product of two vectors of fractions.
inner :: Q3 -> Q3 -> Rational
inner (a, b, c) (d, e, f) = a * d + b * e + c * f

-- | A vector of fractions and a number times another one.
plusTimes :: Q3 -> (Rational, Q3) -> Q3
plusTimes (a, b, c) (k, (x, y, z)) = (a + k * x, b + k * y, c + k * z)
