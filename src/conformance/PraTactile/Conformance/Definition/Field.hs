{-# OPTIONS_HADDOCK hide #-}

-- | Finite fields by definition. An element of GF(p^m) is a polynomial in A of degree below m over
-- the integers modulo p, where A is a root of the modulus. Its code is the integer whose base-p
-- digits are the coefficients, lowest degree first.
module PraTactile.Conformance.Definition.Field
  ( Field (..),
    field,
    add,
    multiply,
    negation,
    inverse,
    power,
    primitiveElement,
    logarithm,
    trace,
    digits,
  )
where

import Data.List (elemIndex, find, foldl')
import Data.Maybe (fromMaybe)
import Data.Vector.Unboxed (Vector)
import qualified Data.Vector.Unboxed as Vector

-- | A field with the tables of all sums and products, computed on first use.
data Field = Field
  { fieldOrder :: !Int,
    fieldCharacteristic :: !Int,
    fieldDegree :: !Int,
    fieldSums :: Vector Int,
    fieldProducts :: Vector Int
  }

-- | GF(q), 2 <= q <= 256, with the given modulus, constant term first. 'Nothing' if q is not a
-- power p^m of a prime; if the modulus is not monic of degree m over the integers modulo p; or if
-- it is reducible, so that an element other than 0 has no inverse.
field :: Integer -> [Integer] -> Maybe Field
field q modulus
  | q < 2 || q > 256 || p ^ m /= q = Nothing
  | length (take (m + 2) modulus) /= m + 1 || last modulus /= 1 = Nothing
  | any (\c -> c < 0 || c >= p) modulus = Nothing
  | any null [inverses made a | a <- [1 .. fieldOrder made - 1]] = Nothing
  | otherwise = Just made
  where
    p = fromMaybe q (find ((== 0) . (q `mod`)) [2 .. q])
    m = length (takeWhile (< q) (iterate (* p) 1))
    made = fieldOf (fromInteger q) (fromInteger p) m (map fromInteger modulus)

-- | The tables by definition.
fieldOf :: Int -> Int -> Int -> [Int] -> Field
fieldOf q p m modulus = Field q p m (table plus) (table times)
  where
    table operation =
      Vector.fromList [operation a b | a <- all', b <- all']
    all' = map (digits p m) [0 .. q - 1]
    plus a b = code (sum' a b)
    times a b = code (foldr (\digit rest -> sum' (map (* digit) a) (timesRoot rest)) nought b)
    sum' = zipWith (\a b -> (a + b) `mod` p)
    nought = replicate m 0
    -- By A^m = - (f0 + f1 A + ... + f(m-1) A^(m-1)).
    timesRoot a = zipWith (\c f -> (c - last a * f) `mod` p) (0 : a) (take m modulus)
    code = foldr (\digit rest -> digit + p * rest) 0

-- | The lowest digits of a number, lowest first. The arguments are the base, the number of digits,
-- and the number.
digits :: Integral a => a -> Int -> a -> [a]
digits base count number = take count (map (`mod` base) (iterate (`div` base) number))

-- | The sum of two codes.
add :: Field -> Int -> Int -> Int
add f a b = fieldSums f Vector.! (a * fieldOrder f + b)

-- | The product of two codes.
multiply :: Field -> Int -> Int -> Int
multiply f a b = fieldProducts f Vector.! (a * fieldOrder f + b)

-- | The additive inverse of a code.
negation :: Field -> Int -> Int
negation f a = head' [b | b <- elements f, add f a b == 0]
  where
    head' = sum . take 1

-- | The multiplicative inverse of a code; 'Nothing' for 0.
inverse :: Field -> Int -> Maybe Int
inverse f a = find (const True) (inverses f a)

inverses :: Field -> Int -> [Int]
inverses f a = [b | b <- elements f, multiply f a b == 1]

elements :: Field -> [Int]
elements f = [0 .. fieldOrder f - 1]

-- | A power of a code; 0^0 is 1. 'Nothing' for 0 to a negative exponent. Exponents are reduced by
-- a^(q-1) = 1.
power :: Field -> Int -> Integer -> Maybe Int
power f a exponent'
  | a /= 0 = Just (times (fromInteger (exponent' `mod` (toInteger (fieldOrder f) - 1))))
  | exponent' > 0 = Just 0
  | exponent' == 0 = Just 1
  | otherwise = Nothing
  where
    times count = foldl' (multiply f) 1 (replicate count a)

-- | The smallest code of multiplicative order q - 1.
primitiveElement :: Field -> Int
primitiveElement f = sum (take 1 (filter ((== fieldOrder f - 1) . length . powersOf f) [1 ..]))

-- | 1, g, g^2, ... up to the last power before 1 recurs.
powersOf :: Field -> Int -> [Int]
powersOf f g = 1 : takeWhile (/= 1) (drop 1 (iterate (multiply f g) 1))

-- | The least exponent with which 'primitiveElement' gives the element; 'Nothing' for 0.
logarithm :: Field -> Int -> Maybe Int
logarithm f a = elemIndex a (powersOf f (primitiveElement f))

-- | a + a^p + ... + a^(p^(m-1)).
trace :: Field -> Int -> Int
trace f a = foldl' (add f) 0 (take (fieldDegree f) (iterate frobenius a))
  where
    frobenius b = foldl' (multiply f) 1 (replicate (fieldCharacteristic f) b)
