-- | The structure of a field: orders of elements, the Frobenius automorphism, subfields, and trace,
-- norm and minimal polynomial over them (Lidl and Niederreiter, Finite Fields, chapter 2).
module PraTactile.Field.Structure
  ( -- * The multiplicative group
    exponential,
    elementOrder,
    isPrimitiveElement,

    -- * The Frobenius automorphism
    frobeniusPower,

    -- * Subfields
    Subfield,
    subfield,
    subfields,
    primeSubfield,
    subfieldDegree,
    subfieldOrder,
    inSubfield,
    subfieldElements,

    -- * Down to a subfield
    conjugates,
    trace,
    norm,
    minimalPolynomial,

    -- * Errors
    StructureError (..),
  )
where

import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Polynomial

-- | Why an element has no order, or a field no such subfield, embedding or isomorphism.
data StructureError
  = -- | No power of zero is 1.
    ZeroHasNoOrder
  | -- | There is no subfield of degree d, the first number, over GF(p), because it does not divide
    -- m, the second.
    NoSubfield Natural Natural
  | -- | GF(p^d), the first pair, is not in GF(r^m), the second: p and r differ, or d does not
    -- divide m.
    NotContained (Natural, Natural) (Natural, Natural)
  | -- | GF(p^d), the first pair, and GF(r^m), the second, are different fields.
    NotIsomorphic (Natural, Natural) (Natural, Natural)
  deriving stock (Eq, Show)

-- | 'primitive' to any power: the inverse of 'logarithm'.
--
-- >>> import PraTactile.Field.Named (GF4)
-- >>> map exponential [-1, 0, 1, 2, 3] :: [GF GF4]
-- [A^2,1,A,A^2,1]
exponential :: forall k. KnownField k => Integer -> GF k
exponential e =
  power primitive (fromInteger (e `mod` (toInteger (fieldOrder (Proxy :: Proxy k)) - 1)))

-- | The least n >= 1 with a^n = 1. Refuses zero.
elementOrder :: forall k. KnownField k => GF k -> Either StructureError Natural
elementOrder a = case logarithm a of
  Nothing -> Left ZeroHasNoOrder
  Just l -> Right (fromIntegral (units `div` gcd units l))
  where
    units = fieldOrder (Proxy :: Proxy k) - 1

-- | Whether the powers of an element are all nonzero elements.
isPrimitiveElement :: forall k. KnownField k => GF k -> Bool
isPrimitiveElement a = elementOrder a == Right (fromIntegral (fieldOrder (Proxy :: Proxy k)) - 1)

-- | @frobeniusPower i a@ is a^(p^i). For i = 0, ..., m - 1 these are all the automorphisms of
-- GF(p^m).
frobeniusPower :: forall k. KnownField k => Natural -> GF k -> GF k
frobeniusPower i a =
  power a (fromIntegral (fieldCharacteristic k) ^ (i `mod` fromIntegral (fieldDegree k)))
  where
    k = Proxy :: Proxy k

-- | A subfield GF(p^d) of the field k = GF(p^m), where d divides m: the roots of x^(p^d) = x. Only
-- functions of this module make one.
newtype Subfield (k :: Field) = Subfield Natural
  deriving stock (Eq, Ord, Show)

type role Subfield nominal

-- | The subfield of a degree d over GF(p). Refuses a d that does not divide m.
subfield :: forall k. KnownField k => Natural -> Either StructureError (Subfield k)
subfield d
  | d > 0 && m `mod` d == 0 = Right (Subfield d)
  | otherwise = Left (NoSubfield d m)
  where
    m = fromIntegral (fieldDegree (Proxy :: Proxy k))

-- | All subfields, from GF(p) to the field itself. O(m).
subfields :: forall k. KnownField k => [Subfield k]
subfields = [Subfield d | d <- [1 .. m], m `mod` d == 0]
  where
    m = fromIntegral (fieldDegree (Proxy :: Proxy k))

-- | GF(p).
primeSubfield :: Subfield k
primeSubfield = Subfield 1

-- | d, with p^d the number of elements of the subfield.
subfieldDegree :: Subfield k -> Natural
subfieldDegree (Subfield d) = d

-- | p^d.
subfieldOrder :: forall k. KnownField k => Subfield k -> Natural
subfieldOrder (Subfield d) = fromIntegral (fieldCharacteristic (Proxy :: Proxy k)) ^ d

-- | Whether an element lies in the subfield.
inSubfield :: KnownField k => Subfield k -> GF k -> Bool
inSubfield (Subfield d) a = frobeniusPower d a == a

-- | The elements of the subfield by increasing code. O(q).
subfieldElements :: KnownField k => Subfield k -> [GF k]
subfieldElements s = filter (inSubfield s) elements

-- | The different images of an element under the automorphisms that fix the subfield: a, a^r,
-- a^(r^2), ... with r = p^d. Their number is the degree of the minimal polynomial. O(m).
conjugates :: KnownField k => Subfield k -> GF k -> [GF k]
conjugates (Subfield d) a = a : takeWhile (/= a) (drop 1 (iterate (frobeniusPower d) a))

-- | The trace to the subfield: the sum of a^(r^i), i < m/d, r = p^d. It is linear over the subfield
-- and takes each of its values equally often. O(m).
trace :: KnownField k => Subfield k -> GF k -> GF k
trace s = sum . images s

-- | The norm to the subfield: the product of a^(r^i), i < m/d, r = p^d. O(m).
norm :: KnownField k => Subfield k -> GF k -> GF k
norm s = product . images s

-- | The m/d images of an element under the automorphisms over the subfield, equal ones too.
images :: forall k. KnownField k => Subfield k -> GF k -> [GF k]
images (Subfield d) a = [frobeniusPower i a | i <- [0, d .. m - 1]]
  where
    m = fromIntegral (fieldDegree (Proxy :: Proxy k))

-- | The monic polynomial of least degree over the subfield that has the element as a root. Its
-- coefficients lie in the subfield, over which it is irreducible. O(m^3).
--
-- Over GF(2), the minimal polynomial of A in GF(4) is x^2 + x + 1.
--
-- >>> import PraTactile.Field.Named (GF4)
-- >>> minimalPolynomial primeSubfield (primitive :: GF GF4)
-- polynomial [1,1,1]
minimalPolynomial :: KnownField k => Subfield k -> GF k -> Polynomial k
minimalPolynomial s a = product [polynomial [negate b, one] | b <- conjugates s a]
