-- | Numbers r + s sqrt a: the coordinates of a face's corners in the face's own frame, where the
-- length of a side need not be rational; exact, so that ties are decided and not estimated.
module PraTactile.Object.Surd
  ( Surd,
    surd,
    fraction,
    asFraction,
    nearestDouble,
    ahead,
    beyond,
    times,

    -- * Signs
    signOf,

    -- * Squares of distances
    Square,
    squareOf,
  )
where

import PraTactile.Object.Vector (exactRoot, squareRoot)

-- | A rational part, and a rational multiple of the root of a number: 0 of 0 where that root is
-- rational, so that equal numbers over one root are equal.
data Surd = Surd !Rational !Rational !Rational
  deriving stock (Eq, Ord, Show)

-- | r + s sqrt a, of r, s and a, which is not negative.
--
-- >>> surd 1 2 9 == fraction 7
-- True
surd :: Rational -> Rational -> Rational -> Surd
surd r s a = case exactRoot a of
  Just root -> fraction (r + s * root)
  Nothing | s == 0 -> fraction r
  Nothing -> Surd r s a

-- | A rational number.
fraction :: Rational -> Surd
fraction r = Surd r 0 0

-- | The number, where it is rational.
asFraction :: Surd -> Maybe Rational
asFraction (Surd r s _) = if s == 0 then Just r else Nothing

-- | The nearest machine number of a rational one, and of another one within some units in the last
-- place of its parts.
--
-- >>> nearestDouble (surd 1 1 2)
-- 2.414213562373095
nearestDouble :: Surd -> Double
nearestDouble (Surd r s a)
  | s == 0 = fromRational r
  | otherwise = fromRational r + fromRational (signum s) * squareRoot (s * s * a)

-- | So much further.
ahead :: Rational -> Surd -> Surd
ahead more (Surd r s a) = Surd (r + more) s a

-- | By how much the second is more than the first; both over one root, or one of them rational.
beyond :: Surd -> Surd -> Surd
beyond (Surd r s a) (Surd r' s' a') = surd (r' - r) (s' - s) (max a a')

-- | So many times the number.
times :: Rational -> Surd -> Surd
times k (Surd r s a) = surd (k * r) (k * s) a

-- | The sign of r + s sqrt a + t sqrt b, where a and b are not negative.
signOf :: (Ord n, Num n) => n -> n -> n -> n -> n -> n
signOf a b r s t
  | first * signum t >= 0 = signum (first + signum t)
  | otherwise = first * sign2 a (r * r + s * s * a - t * t * b) (2 * r * s)
  where
    first = sign2 a r s
{-# SPECIALIZE signOf :: Integer -> Integer -> Integer -> Integer -> Integer -> Integer #-}

-- | The sign of r + s sqrt a.
sign2 :: (Ord n, Num n) => n -> n -> n -> n
sign2 a r s
  | a == 0 || s == 0 = signum r
  | signum r * signum s >= 0 = signum (signum r + signum s)
  | otherwise = signum r * signum (r * r - s * s * a)
{-# SPECIALIZE sign2 :: Integer -> Integer -> Integer -> Integer #-}

-- | The square of a length in the plane, r + s sqrt a + t sqrt b; those over one pair of roots
-- compare.
data Square = Square !Rational !(Rational, Rational) !(Rational, Rational)

instance Eq Square where
  p == q = compare p q == EQ

instance Ord Square where
  compare (Square r (s, a) (t, b)) (Square r' (s', a') (t', b')) =
    compare (signOf (max a a') (max b b') (r - r') (s - s') (t - t')) 0

-- | (r + s sqrt a)^2 + (u + v sqrt b)^2.
squareOf :: Surd -> Surd -> Square
squareOf (Surd r s a) (Surd u v b) =
  Square (r * r + s * s * a + u * u + v * v * b) (2 * r * s, a) (2 * u * v, b)
