{-# OPTIONS_HADDOCK hide #-}

-- | Primitive polynomials by definition: their root generates the multiplicative group of GF(q^n).
module PraTactile.Conformance.Definition.Polynomial
  ( isPrimitive,
    firstPrimitive,
    primitiveAndShort,
    primeDivisors,
    degreeOf,
  )
where

import Data.List (dropWhileEnd, find, foldl')
import PraTactile.Conformance.Definition.Field

-- | The degree of a polynomial, constant term first, without trailing zero coefficients. -1 for
-- the zero polynomial.
degreeOf :: [Int] -> Int
degreeOf = subtract 1 . length . dropWhileEnd (== 0)

-- | Whether a polynomial over the field, constant term first, is primitive: monic, of degree n >=
-- 1, with a constant term other than 0, and with x of order q^n - 1 modulo it. (Then the powers of
-- x are all nonzero residues, all of these have inverses, and the polynomial is irreducible.)
isPrimitive :: Field -> [Int] -> Bool
isPrimitive f stated = n >= 1 && last h == 1 && take 1 h /= [0] && orderIsFull
  where
    h = take (n + 1) stated
    n = degreeOf stated
    full = toInteger (fieldOrder f) ^ n - 1 :: Integer
    unit = 1 : replicate (n - 1) 0
    orderIsFull
      | full <= 2 ^ (12 :: Int) = fromInteger full == stepsTo unit
      | otherwise =
        powerOfX f h full == unit
          && all ((/= unit) . powerOfX f h . div full) (primeDivisors full)
    -- The number of steps after which the powers of x return to 1.
    stepsTo one = 1 + length (takeWhile (/= one) (drop 1 (take bound (iterate (timesX f h) one))))
    bound = fromInteger full + 1

-- For larger ones: x has the order q^n - 1 if that power of x is 1 and no power (q^n - 1) / r is,
-- for primes r.

-- | A power of x modulo h.
powerOfX :: Field -> [Int] -> Integer -> [Int]
powerOfX f h e
  | e == 0 = take (length h - 1) (1 : repeat 0)
  | even e = half
  | otherwise = timesX f h half
  where
    half = let root = powerOfX f h (e `div` 2) in timesModulo f h root root

-- | x times a residue modulo a monic polynomial h of degree n. Residues have n coefficients.
timesX :: Field -> [Int] -> [Int] -> [Int]
timesX f h a = zipWith (\c b -> add f c (multiply f top b)) (0 : a) (init h)
  where
    top = negation f (last a)

timesModulo :: Field -> [Int] -> [Int] -> [Int] -> [Int]
timesModulo f h a = foldr step (map (const 0) a)
  where
    step digit rest = zipWith (add f) (map (multiply f digit) a) (timesX f h rest)

-- | The first primitive polynomial of degree n, followed by polynomials with a smaller order. For
-- each prime r of q^n - 1, the minimal polynomial of the r-th power of its root has the order (q^n
-- - 1) / r. It is left out if its degree is below n.
primitiveAndShort :: Field -> Int -> [[Int]]
primitiveAndShort f n =
  h : [short | r <- primeDivisors full, Just short <- [minimalOf (powersOfX r)]]
  where
    h = firstPrimitive f n
    full = toInteger (fieldOrder f) ^ n - 1
    unit = 1 : replicate (n - 1) 0
    powersOfX r = take (n + 1) (iterate (timesModulo f h (powerOfX f h r)) unit)
    -- Each power with the combination of powers that gives it; eliminated one by one.
    minimalOf powers = go [] (zip powers (unitVectors (n + 1)))
    go _ [] = Nothing
    go done ((vector, parts) : later) = case foldr reduce (vector, parts) done of
      (rest, told)
        | all (== 0) rest -> if null later then Just (monic told) else Nothing
        | otherwise -> go ((rest, told) : done) later
    reduce (pivot, parts) (vector, told) =
      let i = length (takeWhile (== 0) pivot)
          factor = negation f (multiply f (vector !! i) (inverseOf (pivot !! i)))
          plus = zipWith (\a b -> add f a (multiply f factor b))
       in (plus vector pivot, plus told parts)
    monic told = map (multiply f (inverseOf (last told))) told
    inverseOf a = sum (inverse f a)
    unitVectors size = [[if i == j then 1 else 0 | i <- [1 .. size]] | j <- [1 .. size]]

-- | The prime divisors of a number, ascending.
primeDivisors :: Integer -> [Integer]
primeDivisors = go 2
  where
    go p n
      | n == 1 = []
      | p * p > n = [n]
      | n `mod` p == 0 = p : go (p + 1) (foldl' (\m _ -> reduced p m) n [()])
      | otherwise = go (p + 1) n
    reduced p m = if m `mod` p == 0 then reduced p (m `div` p) else m

-- | The first primitive polynomial of a degree of at least 1, in the order of coefficients from
-- the highest degree down.
firstPrimitive :: Field -> Int -> [Int]
firstPrimitive f n = concat (find (isPrimitive f) (map monic [0 .. q ^ n - 1]))
  where
    q = toInteger (fieldOrder f)
    monic index = map fromInteger (digits q n index) ++ [1]
