{-# LANGUAGE FlexibleInstances #-}

-- | Sums of rational multiples of square roots, exactly: the coordinates of a face's corners in the
-- face's own frame, of points on slanted faces, and of corners of an unfolded polyhedron.
--
-- Any whole numbers are products of the elements of a 'coprimeBase' of theirs, and the root of one
-- is a whole multiple of the root of a product of such elements, each once, of those that are no
-- squares. The roots of different products of that kind are linearly independent over the rationals
-- (Besicovitch 1940), so that a sum is 0 only where all its coefficients are.
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

-- | Whole numbers above 1, no two of which have a divisor in common, each with its root where it is
-- a square.
newtype Base = Base [(Integer, Maybe Rational)]

-- | A base of which all these positive numbers are products. O(n^2) greatest common divisors.
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

-- | The root of one of the numbers of which the base was made.
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

-- | A sum of rational multiples of the roots of products of elements of one base: what is under
-- each root, and the coefficient, which is not 0. Sums over different bases have nothing to do with
-- each other.
newtype Radicals = Radicals (Map.Map Integer Rational)
  deriving stock (Eq, Show)

-- | By size.
instance Ord Radicals where
  compare a b = compare (sign (minus a b)) 0

-- | A rational number.
fraction :: Rational -> Radicals
fraction q = Radicals (if q == 0 then Map.empty else Map.singleton 1 q)

-- | The coefficients, none of which is 0, each with what is under its root.
terms :: Radicals -> [(Rational, Integer)]
terms (Radicals sums) = [(q, under) | (under, q) <- Map.toAscList sums]

-- | The number, where it is rational.
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
      -- Products of elements of the base: what both have leaves the root.
      part m p =
        Map.fromList
          [ (m `quot` g * (n `quot` g), p * q * fromInteger g)
            | (n, q) <- Map.toList b,
              let g = gcd m n
          ]
  times k (Radicals a) = Radicals (if k == 0 then Map.empty else Map.map (k *) a)

summed :: Map.Map Integer Rational -> Map.Map Integer Rational -> Map.Map Integer Rational
summed = Map.mergeWithKey (\_ p q -> if p + q == 0 then Nothing else Just (p + q)) id id

-- | 'Nothing' of a product that would be one of too many pairs of terms, and of what comes of it.
instance Number (Maybe Radicals) where
  plus = liftA2 plus
  minus = liftA2 minus
  product' a b = do
    (Radicals few, Radicals others) <- (,) <$> a <*> b
    guard (Map.size few * Map.size others <= mostPairs)
    pure (product' (Radicals few) (Radicals others))
  times k = fmap (times k)

-- | No product is made of sums that have more pairs of terms.
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

-- | The sign of r + s sqrt a + t sqrt b, of a, b, r, s and t, where a and b are not negative.
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

-- | The number rounded by a function that does not fall and is constant between some fractions,
-- such as to the nearest machine number, or to its sign.
nearest :: Eq a => (Rational -> a) -> Radicals -> a
nearest rounding number = maybe (decided 64) rounding (asFraction number)
  where
    -- It lies between two of the fractions at which the rounded number changes.
    decided digits
      | below == rounding (middle it + radius it) = below
      | otherwise = decided (2 * digits)
      where
        below = rounding (middle it - radius it)
        it = foldl' plus (enclosed digits 0 1) (map (uncurry (enclosed digits)) (terms number))

-- | The nearest machine number of a rational one, and of another one within some units in the last
-- place of its terms.
--
-- >>> nearestDouble (fraction 1 `plus` rootIn (coprimeBase [2]) 2)
-- 2.414213562373095
nearestDouble :: Radicals -> Double
nearestDouble = foldl' (+) 0 . map worth . terms
  where
    worth (q, under)
      | under == 1 = fromRational q
      | otherwise = fromRational (signum q) * squareRoot (q * q * fromInteger under)
