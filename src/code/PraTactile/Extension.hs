{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE RoleAnnotations #-}

-- |
-- GF(q^n) as GF(q)[x] modulo a primitive h: where positions live, since the state of the
-- shift register after t steps is alpha^t, alpha being the class of x. Its size has no limit.
module PraTactile.Extension
  ( -- * Residues
    Residue
  , residueCoefficients
  , multiplyModulo

    -- * Powers of the root
  , powerOfRoot
  ) where

import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Polynomial

-- | An element of GF(q)[x] / h, by its representative of degree less than n.
newtype Residue (k :: Field) = Residue (Polynomial k)
  deriving stock (Eq, Ord)

type role Residue nominal

-- | The n coefficients of the representative, constant term first.
residueCoefficients :: Primitive k -> Residue k -> [GF k]
residueCoefficients h (Residue a) = take (primitiveDegree h) (coefficients a ++ repeat zero)

-- | The product of two residues modulo h.
multiplyModulo :: KnownField k => Primitive k -> Residue k -> Residue k -> Residue k
multiplyModulo h (Residue a) (Residue b) = reduce h (a * b)

-- | alpha^e, for an exponent of any size, by squaring.
--
-- For the paper's h, x^4 = x^2 + A x + A^2.
--
-- >>> import PraTactile.Field.Named (GF4)
-- >>> let reduced h = residueCoefficients h (powerOfRoot h 4)
-- >>> fmap reduced (firstPrimitive 4 :: Either PolynomialError (Primitive GF4))
-- Right [A^2,A,1,0]
powerOfRoot :: KnownField k => Primitive k -> Natural -> Residue k
powerOfRoot h = maybe (Residue 0) Residue . powerModulo (primitivePolynomial h) variable

-- A primitive h is not zero, so that the quotient always exists.
reduce :: KnownField k => Primitive k -> Polynomial k -> Residue k
reduce h a = Residue (maybe a snd (quotientRemainder a (primitivePolynomial h)))
