-- | Discrete logarithms in GF(q^n) to the base alpha: the step from the state of the shift register
-- to the position. The method is that of Pohlig and Hellman (IEEE Trans. Inf. Theory 24, 1978) with
-- Shanks's baby steps and giant steps. The cost grows with the square root of the largest prime
-- that divides q^n - 1; if that prime is too large the functions refuse.
module PraTactile.DiscreteLog
  ( -- * Logarithms
    discreteLogarithm,

    -- * Many logarithms to one base
    Logarithms,
    prepareLogarithms,
    prepareLogarithmsWith,
    logarithmFrom,

    -- * Limits
    LogarithmError (..),
    largestFeasiblePrime,
    mostBabySteps,
  )
where

import Data.List (foldl')
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Numeric.Natural (Natural)
import PraTactile.Extension
import PraTactile.Factorisation.Divisor (squareRoot)
import PraTactile.Field
import PraTactile.Polynomial

-- | Why there is no logarithm.
data LogarithmError
  = -- | Zero is not a power of alpha.
    LogarithmOfZero
  | -- | The first number, the largest prime that divides q^n - 1, exceeds the second,
    -- 'largestFeasiblePrime'.
    LogarithmInfeasible Natural Natural
  deriving stock (Eq, Show)

-- | The most baby steps that are kept for one prime, 2^18. Their table takes about 50 MB.
mostBabySteps :: Natural
mostBabySteps = 2 ^ (18 :: Int)

-- | 2^40. With 'mostBabySteps', up to 2^22 giant steps are made, which take some seconds.
largestFeasiblePrime :: Natural
largestFeasiblePrime = 2 ^ (40 :: Int)

-- | What is computed once for all logarithms to the base alpha, when needed.
data Logarithms (k :: Field) = Logarithms (Primitive k) [PrimePower k]

type role Logarithms nominal

-- | One prime power r^e of q^n - 1, with the tables for logarithms in the subgroup of order r.
data PrimePower k = PrimePower
  { partPrime :: Natural,
    partExponent :: Natural,
    -- | the number m of baby steps
    partSteps :: Natural,
    -- | gamma^j -> j, j < m, gamma = alpha^((q^n - 1)/r)
    partBaby :: Map (Residue k) Natural,
    -- | gamma^(-m)
    partGiant :: Residue k
  }

-- | Prepares logarithms to the base alpha, the root of h. Refuses if a prime that divides q^n - 1
-- is too large ('LogarithmInfeasible'). It is O(1) itself: the first logarithm makes min (sqrt r)
-- 'mostBabySteps' products of O(n^2) for each prime r that divides q^n - 1, and keeps them.
prepareLogarithms :: KnownField k => Primitive k -> Either LogarithmError (Logarithms k)
prepareLogarithms = prepareLogarithmsWith mostBabySteps

-- | 'prepareLogarithms' with at most the given number of baby steps for each prime, at least one.
-- With a smaller table each logarithm takes longer: one giant step for each m of r.
prepareLogarithmsWith ::
  KnownField k => Natural -> Primitive k -> Either LogarithmError (Logarithms k)
prepareLogarithmsWith most h
  | largest > largestFeasiblePrime = Left (LogarithmInfeasible largest largestFeasiblePrime)
  | otherwise = Right (Logarithms h (map part (periodFactors h)))
  where
    largest = maximum (1 : map fst (periodFactors h))
    part (r, e) =
      PrimePower
        r
        e
        m
        (Map.fromList (zip babies [0 .. m - 1]))
        (powerOfRoot h (period h - m * cofactor))
      where
        m = min (max 1 most) (squareRoot (r - 1) + 1)
        cofactor = period h `div` r
        gamma = powerOfRoot h cofactor
        babies = iterate (multiplyModulo h gamma) (powerOfRoot h 0)

-- | The exponent 0 <= t < q^n - 1 for which alpha^t is the residue. Refuses zero. O(k n^2 (s + n
-- log q)) for k prime factors of q^n - 1. The largest one, r, takes s = max (sqrt r) (r / m) steps,
-- where m is the number of baby steps that are kept.
logarithmFrom :: KnownField k => Logarithms k -> Residue k -> Either LogarithmError Natural
logarithmFrom (Logarithms h parts) a
  | a == residue h 0 = Left LogarithmOfZero
  | otherwise = Right (fst (foldl' chineseRemainder (0, 1) (map modulo (components h parts a))))
  where
    modulo (p, b) = (partLogarithm h p b, partPower p)

-- | r^e.
partPower :: PrimePower k -> Natural
partPower p = partPrime p ^ partExponent p

-- | For each r^e, the power a^(N/r^e), where N is the product of all r^e. They are computed by
-- halves, so that the powers for the other half are taken once.
components ::
  KnownField k =>
  Primitive k ->
  [PrimePower k] ->
  Residue k ->
  [(PrimePower k, Residue k)]
components h parts a = case splitAt (length parts `div` 2) parts of
  ([], ps) -> [(p, a) | p <- ps]
  (ps, ps') -> components h ps (powered ps') ++ components h ps' (powered ps)
  where
    powered = powerOfResidue h a . product . map partPower

-- | The logarithm modulo r^e, by its base-r digits, the lowest first. Let b = a^(N/r^e), and let x
-- be the digits below r^i. Then digit i is the logarithm to the base gamma of (b / alpha^(x
-- N/r^e))^(r^(e-1-i)).
partLogarithm :: KnownField k => Primitive k -> PrimePower k -> Residue k -> Natural
partLogarithm h p b = foldl' withDigit 0 [0 .. partExponent p - 1]
  where
    r = partPrime p
    cofactor = period h `div` partPower p
    withDigit x i =
      x + r ^ i * stepLogarithm h p (powerOfResidue h (without x) (r ^ (partExponent p - 1 - i)))
    without x
      | x == 0 = b
      | otherwise = multiplyModulo h b (powerOfRoot h ((partPower p - x) * cofactor))

-- | The logarithm to the base gamma of one of its powers. If i giant steps back end on the baby
-- step j, it is i m + j.
stepLogarithm :: KnownField k => Primitive k -> PrimePower k -> Residue k -> Natural
stepLogarithm h p d =
  sum (take 1 (mapMaybe found (zip giants (iterate (multiplyModulo h (partGiant p)) d))))
  where
    m = partSteps p
    giants = [0 .. partPrime p `div` m]
    found (i, c) = (+ i * m) <$> Map.lookup c (partBaby p)

-- | The number below m n that is x modulo m and y modulo n, for coprime m and n.
chineseRemainder :: (Natural, Natural) -> (Natural, Natural) -> (Natural, Natural)
chineseRemainder (x, m) (y, n) = (x + m * step, m * n)
  where
    step = fromInteger ((toInteger y - toInteger x) * inverted `mod` toInteger n)
    (inverted, _) = euclid (toInteger m) (toInteger n)
    -- u and v with u a + v b = gcd a b.
    euclid :: Integer -> Integer -> (Integer, Integer)
    euclid _ 0 = (1, 0)
    euclid s t =
      let (quotient, rest) = s `divMod` t; (u, v) = euclid t rest in (v, u - quotient * v)

-- | The logarithm of one residue to the base alpha. Refuses zero, and fields in which logarithms
-- are infeasible. Each call computes the baby steps anew; for many residues, use
-- 'prepareLogarithms' once.
--
-- >>> import PraTactile.Field.Named (GF4)
-- >>> let twice h = discreteLogarithm h (powerOfRoot h 123)
-- >>> fmap twice (firstPrimitive 4 :: Either PolynomialError (Primitive GF4))
-- Right (Right 123)
discreteLogarithm :: KnownField k => Primitive k -> Residue k -> Either LogarithmError Natural
discreteLogarithm h a = prepareLogarithms h >>= (`logarithmFrom` a)
