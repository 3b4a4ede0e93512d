{-# LANGUAGE FlexibleInstances #-}

-- | Sums of rational multiples of square roots, exactly: what points on slanted faces and corners
-- of an unfolded polyhedron have for coordinates. Any whole numbers are products of the elements of
-- a 'coprimeBase' of theirs, and the root of one is a whole multiple of the root of a product of
-- such elements, each once, of those that are no squares. The roots of different products of that
-- kind are linearly independent over the rationals (Besicovitch 1940), so that a sum is 0 only
-- where all its coefficients are.
module PraTactile.Object.Radicals
  ( -- * Bases
    Base,
    coprimeBase,
    rootIn,

    -- * Sums
    Radicals,
    radical,
    fraction,
    terms,
    asFraction,
  )
where

import Control.Applicative (liftA2)
import Control.Monad (guard)
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import PraTactile.Object.Number
import PraTactile.Object.Vector (exactRoot)

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

-- | The root of one of the numbers of which the base was made: what is before the root, and what is
-- under it, 1 where the number is a square.
--
-- >>> rootIn (coprimeBase [12, 75, 3]) 75
-- (5 % 1,3)
rootIn :: Base -> Integer -> (Rational, Integer)
rootIn (Base base) number = foldl' split (1, 1) base
  where
    split (before, under) (b, root) = case root of
      Just r -> (before * r ^ e, under)
      Nothing
        | even e -> (before * power, under)
        | otherwise -> (before * power, under * b)
      where
        e = exponentOf number
        power = fromInteger (b ^ (e `quot` 2))
        exponentOf n = case n `quotRem` b of
          (q, 0) -> 1 + exponentOf q
          _ -> 0 :: Int

-- | A sum of rational multiples of the roots of products of elements of one base. Sums over
-- different bases have nothing to do with each other.
newtype Radicals = Radicals (Map.Map Integer Rational)

-- | So many times the root of a number that 'rootIn' has under the root.
radical :: Rational -> Integer -> Radicals
radical q under = Radicals (if q == 0 then Map.empty else Map.singleton under q)

-- | A rational number.
fraction :: Rational -> Radicals
fraction q = radical q 1

-- | The coefficients, none of which is 0, each with what is under its root. Two sums are equal if
-- and only if these are.
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
