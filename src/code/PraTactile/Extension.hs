-- | GF(q^n) as GF(q)[x] modulo a primitive h. Positions correspond to its elements, since the state
-- of the shift register after t steps is alpha^t, where alpha is the class of x. Its size has no
-- limit.
--
-- Costs are numbers of operations in GF(q); n is the degree of h. Over GF(2), 64 coefficients are
-- multiplied at once. Powers use a table of n^2 bytes, which is made once for h in O(q n^2).
module PraTactile.Extension
  ( -- * Residues
    Residue,
    residue,
    residueCoefficients,
    residueVector,

    -- * Arithmetic
    addModulo,
    multiplyModulo,
    powerOfResidue,
    inverseModulo,
    frobeniusModulo,

    -- * Powers of the root
    powerOfRoot,

    -- * Down to GF(q)
    traceModulo,
    tracesOfPowers,
    normModulo,
  )
where

import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Polynomial
import PraTactile.Polynomial.Modulus
import PraTactile.Polynomial.Primitive (primitiveModulus)

-- | An element of GF(q)[x] / h, by its representative of degree less than n. A function that gets a
-- residue of another h takes the class of that representative modulo its own h.
newtype Residue (k :: Field) = Residue (Coefficients k)
  deriving stock (Eq, Ord)

type role Residue nominal

instance KnownField k => Show (Residue k) where
  showsPrec d (Residue a) = showParen (d > 10) (showString "residue " . shows (Primitive.toList a))

-- | The class of a polynomial. O(n d) for a polynomial of degree d >= n, O(n) for others.
residue :: KnownField k => Primitive k -> Polynomial k -> Residue k
residue h = Residue . residueFrom (primitiveModulus h) . coefficients

-- | The n coefficients of the representative, constant term first. O(n).
residueCoefficients :: KnownField k => Primitive k -> Residue k -> [GF k]
residueCoefficients h = Primitive.toList . residueVector h

-- | The n coefficients of the representative, constant term first, as bytes.
residueVector :: KnownField k => Primitive k -> Residue k -> Vector (GF k)
residueVector h (Residue a)
  | Primitive.length a == primitiveDegree h = a
  | otherwise = residueFrom (primitiveModulus h) (Primitive.toList a)

-- | The sum of two residues. O(n).
addModulo :: KnownField k => Primitive k -> Residue k -> Residue k -> Residue k
addModulo h a b = Residue (Primitive.zipWith (+) (residueVector h a) (residueVector h b))

-- | The product of two residues modulo h. O(n^2).
multiplyModulo :: KnownField k => Primitive k -> Residue k -> Residue k -> Residue k
multiplyModulo h a b =
  Residue (multiplyResidues (primitiveModulus h) (residueVector h a) (residueVector h b))

-- | A power with an exponent of any size; the power 0 is 1, also for zero. O(n^2 log e) for
-- exponent e.
powerOfResidue :: KnownField k => Primitive k -> Residue k -> Natural -> Residue k
powerOfResidue h a = Residue . powerOf (primitiveModulus h) (residueVector h a)

-- | The inverse of a residue, by Euclid's algorithm. Refuses zero ('DivisionByZero'). O(n^2).
inverseModulo :: KnownField k => Primitive k -> Residue k -> Either FieldError (Residue k)
inverseModulo h a
  | representative == 0 = Left DivisionByZero
  | otherwise = Right (residue h inverted)
  where
    representative = polynomial (residueCoefficients h a)
    -- h is irreducible, so the greatest common divisor is 1.
    (_, inverted, _) = bezout representative (primitivePolynomial h)

-- | The q-th power: the automorphism of GF(q^n) that fixes GF(q). O(n^2).
frobeniusModulo :: KnownField k => Primitive k -> Residue k -> Residue k
frobeniusModulo h = Residue . frobenius (primitiveModulus h) . residueVector h

-- | alpha^e, for an exponent of any size, by squaring. O((n^2 + q n) log e / log q).
--
-- For the paper's h, x^4 = x^2 + A x + A^2.
--
-- >>> import PraTactile.Field.Named (GF4)
-- >>> let reduced h = residueCoefficients h (powerOfRoot h 4)
-- >>> fmap reduced (firstPrimitive 4 :: Either PolynomialError (Primitive GF4))
-- Right [A^2,A,1,0]
powerOfRoot :: KnownField k => Primitive k -> Natural -> Residue k
powerOfRoot h = Residue . powerOfX (primitiveModulus h)

-- | The trace to GF(q), the sum of the n conjugates a^(q^i). It is linear, so its values at the
-- powers of alpha determine it. O(n^2).
traceModulo :: KnownField k => Primitive k -> Residue k -> GF k
traceModulo h a = Primitive.sum (Primitive.zipWith (*) (tracesOfPowers h) (residueVector h a))

-- | The traces of 1, alpha, ..., alpha^(n-1), by Newton's identities. Let h = x^n + c(n-1) x^(n-1)
-- + ..., and let p(k) be the sum of the k-th powers of the roots. Then p(k) = - (c(n-1) p(k-1) +
-- ... + c(n-k+1) p(1) + k c(n-k)). O(n^2).
tracesOfPowers :: KnownField k => Primitive k -> Vector (GF k)
tracesOfPowers h = Primitive.fromListN n (fromIntegral n : reverse (go 1 (take (n - 1) upper) []))
  where
    n = primitiveDegree h
    -- c(n-1), ..., c1, c0
    upper = drop 1 (reverse (coefficients (primitivePolynomial h)))
    -- The sums found so far, the last one first.
    go _ [] sums = sums
    go k (c : rest) sums =
      go (k + 1 :: Integer) rest (negate (sum (zipWith (*) upper sums) + fromInteger k * c) : sums)

-- | The norm to GF(q): the product of the n conjugates, which is the power (q^n - 1)/(q - 1).
-- O(n^3).
normModulo :: forall k. KnownField k => Primitive k -> Residue k -> GF k
normModulo h a = sum (take 1 (residueCoefficients h (powerOfResidue h a (period h `div` (q - 1)))))
  where
    q = fromIntegral (fieldOrder (Proxy :: Proxy k)) :: Natural
