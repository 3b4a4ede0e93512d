{-# LANGUAGE FlexibleInstances #-}

-- | Exact sums of rational multiples of square roots. They are the coordinates of a face's corners
-- in its own frame, of points on slanted faces, and of corners of an unfolded polyhedron.
--
-- Any integers are products of elements of their 'coprimeBase'. So the root of such an integer is
-- an integer multiple of the root of a product of distinct base elements that are not squares. The
-- roots of different products of this kind are linearly independent over the rationals (Besicovitch
-- 1940). So a sum is 0 only if all its coefficients are.
module PraTactile.Object.Radicals
  ( -- * Roots
    Base,
    coprimeBase,
    rootIn,

    -- * Sums
    Radicals,
    fraction,
    terms,
    asFraction,

    -- * Signs and rounding
    sign,
    signOf,
    nearest,
    nearestDouble,
  )
where

import Control.Applicative (liftA2)
import Control.Monad (guard)
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import PraTactile.Object.Enclosure
import PraTactile.Object.Number
import PraTactile.Object.Vector (exactRoot, squareRoot)

-- | Pairwise coprime integers above 1, each with its root if it is a square.
newtype Base = Base [(Integer, Maybe Rational)]

-- | A base that generates all these positive numbers as products. O(n^2) greatest common divisors.
coprimeBase :: [Integer] -> Base
coprimeBase numbers = Base [(b, exactRoot (fromInteger b)) | b <- foldl' insert [] numbers]
  where
    insert base 1 = base
    insert [] n = [n]
    insert (b : others) n
      | g == 1 = b : insert others n
      | otherwise = foldl' insert others [g, b `quot` g, n `quot` g]
      where
        g = gcd b n

-- | The root of one of the numbers from which the base was made.
--
-- >>> terms (rootIn (coprimeBase [12, 75, 3]) 75)
-- [(5 % 1,3)]
rootIn :: Base -> Integer -> Radicals
rootIn (Base base) number = Radicals (Map.singleton under before)
  where
    (before, under) = foldl' split (1, 1) base
    split (k, n) (b, root) = case root of
      Just r -> (k * r ^ e, n)
      Nothing
        | even e -> (k * power, n)
        | otherwise -> (k * power, n * b)
      where
        e = exponentOf number
        power = fromInteger (b ^ (e `quot` 2))
        exponentOf m = case m `quotRem` b of
          (q, 0) -> 1 + exponentOf q
          _ -> 0 :: Int

-- | A sum of rational multiples of roots of products of elements of one base: the number under each
-- root, and its nonzero coefficient. Sums over different bases must not be combined.
newtype Radicals = Radicals (Map.Map Integer Rational)
  deriving stock (Eq, Show)

-- | Ordered by value.
instance Ord Radicals where
  compare a b = compare (sign (minus a b)) 0

-- | A rational number as a sum.
fraction :: Rational -> Radicals
fraction q = Radicals (if q == 0 then Map.empty else Map.singleton 1 q)

-- | The nonzero coefficients, each with the number under its root.
terms :: Radicals -> [(Rational, Integer)]
terms (Radicals sums) = [(q, under) | (under, q) <- Map.toAscList sums]

-- | The number as a fraction; 'Nothing' if it is irrational.
asFraction :: Radicals -> Maybe Rational
asFraction it = case terms it of
  [] -> Just 0
  [(q, 1)] -> Just q
  _ -> Nothing

instance Number Radicals where
  plus (Radicals a) (Radicals b) = Radicals (summed a b)
  minus a b = plus a (times (-1) b)
  product' (Radicals a) (Radicals b) =
    Radicals (foldl' summed Map.empty [part m p | (m, p) <- Map.toList a])
    where
      -- Products of elements of the base: common factors leave the root.
      part m p =
        Map.fromList
          [ (m `quot` g * (n `quot` g), p * q * fromInteger g)
            | (n, q) <- Map.toList b,
              let g = gcd m n
          ]
  times k (Radicals a) = Radicals (if k == 0 then Map.empty else Map.map (k *) a)

-- | The sum of two sums, by the numbers under the roots, without zero coefficients.
summed :: Map.Map Integer Rational -> Map.Map Integer Rational -> Map.Map Integer Rational
summed = Map.mergeWithKey (\_ p q -> if p + q == 0 then Nothing else Just (p + q)) id id

-- | 'Nothing' for a product of too many pairs of terms, and for everything computed from it.
instance Number (Maybe Radicals) where
  plus = liftA2 plus
  minus = liftA2 minus
  product' a b = do
    (Radicals few, Radicals others) <- (,) <$> a <*> b
    guard (Map.size few * Map.size others <= mostPairs)
    pure (product' (Radicals few) (Radicals others))
  times k = fmap (times k)

-- | The most pairs of terms for which a product is computed.
mostPairs :: Int
mostPairs = 4096

-- | The sign: -1, 0 or 1.
sign :: Radicals -> Int
sign number@(Radicals sums) = case Map.toList (Map.delete 1 sums) of
  [] -> truncate (signum rational)
  [(a, s)] -> truncate (signOf (fromInteger a) 0 rational s 0)
  [(a, s), (b, t)] -> truncate (signOf (fromInteger a) (fromInteger b) rational s t)
  _ -> nearest (truncate . signum) number
  where
    rational = Map.findWithDefault 0 1 sums

-- | The sign of r + s sqrt a + t sqrt b, given a, b, r, s and t. Neither a nor b may be negative.
signOf :: (Ord n, Num n) => n -> n -> n -> n -> n -> n
signOf a b r s t
  | first * signum t >= 0 = signum (first + signum t)
  | otherwise = first * sign2 a (r * r + s * s * a - t * t * b) (2 * r * s)
  where
    first = sign2 a r s
{-# SPECIALIZE signOf :: Integer -> Integer -> Integer -> Integer -> Integer -> Integer #-}

-- | The sign of r + s sqrt a, given a, r and s. a must not be negative.
sign2 :: (Ord n, Num n) => n -> n -> n -> n
sign2 a r s
  | a == 0 || s == 0 = signum r
  | signum r * signum s >= 0 = signum (signum r + signum s)
  | otherwise = signum r * signum (r * r - s * s * a)
{-# SPECIALIZE sign2 :: Integer -> Integer -> Integer -> Integer #-}

-- | Rounds a number by a function that is monotonic and constant between certain fractions, such as
-- rounding to the nearest machine number, or the sign.
nearest :: Eq a => (Rational -> a) -> Radicals -> a
nearest rounding number = maybe (decided 64) rounding (asFraction number)
  where
    -- The number lies strictly between two fractions at which the function changes.
    decided digits
      | below == rounding (middle it + radius it) = below
      | otherwise = decided (2 * digits)
      where
        below = rounding (middle it - radius it)
        it = foldl' plus (enclosed digits 0 1) (map (uncurry (enclosed digits)) (terms number))

-- | The nearest machine number. For irrational numbers it may be off by some units in the last
-- place of the terms.
--
-- >>> nearestDouble (fraction 1 `plus` rootIn (coprimeBase [2]) 2)
-- 2.414213562373095
nearestDouble :: Radicals -> Double
nearestDouble = foldl' (+) 0 . map worth . terms
  where
    worth (q, under)
      | under == 1 = fromRational q
      | otherwise = fromRational (signum q) * squareRoot (q * q * fromInteger under)
