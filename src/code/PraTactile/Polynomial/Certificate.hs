{-# OPTIONS_HADDOCK hide #-}

-- | Proofs, as data that a stranger can check, that a polynomial is primitive or irreducible.
-- Checking needs no search and no factorisation, and the checker recomputes every number in a
-- certificate.
module PraTactile.Polynomial.Certificate
  ( -- * Primitive polynomials
    PrimitiveCertificate (..),
    certifyPrimitive,
    verifyPrimitive,

    -- * Irreducible polynomials
    IrreducibleCertificate (..),
    certifyIrreducible,
    verifyIrreducible,

    -- * What can be wrong
    CertificateFault (..),
  )
where

import Control.Monad (forM_, unless, when)
import Data.Bifunctor (first)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Factorisation
import PraTactile.Field
import PraTactile.Polynomial.Irreducible
import PraTactile.Polynomial.Modulus
import PraTactile.Polynomial.Primitive
import PraTactile.Polynomial.Ring

-- | Why a certificate does not prove its claim.
data CertificateFault
  = -- | The polynomial is constant, not monic, or divisible by x.
    PolynomialUnfit
  | -- | The product of the prime powers, the first number, is not q^n - 1, the second.
    FactorsDoNotMultiply Natural Natural
  | -- | This factor is not a prime, or is listed twice.
    FactorNotPrime Natural
  | -- | Whether this factor is prime could not be decided.
    FactorUndecided FactorError
  | -- | x^(q^n - 1) is not 1, for a primitive polynomial; or x^(q^n) is not x, for an irreducible
    -- one.
    PowerDoesNotClose
  | -- | There is no residue or witness for this prime.
    EntryMissing Natural
  | -- | The residue or witness for this prime is wrong.
    EntryWrong Natural
  | -- | The residue of this prime is 1, so the order of the root is lower.
    OrderLower Natural
  deriving stock (Eq, Show)

-- | A proof that h is primitive. The root has order N = q^n - 1, because its N-th power is 1, and
-- its (N/r)-th power is not 1 for any prime r that divides N.
data PrimitiveCertificate (k :: Field) = PrimitiveCertificate
  { -- | h
    certifiedPrimitive :: Polynomial k,
    -- | the primes that divide q^n - 1, each with its exponent
    certifiedFactors :: [(Natural, Natural)],
    -- | for each of those primes r, x^((q^n - 1)/r) modulo h
    certifiedResidues :: [(Natural, Polynomial k)]
  }
  deriving stock (Eq, Show)

type role PrimitiveCertificate nominal

-- | The certificate of a primitive polynomial.
--
-- >>> import PraTactile.Field.Named (GF2)
-- >>> import PraTactile.Polynomial (firstPrimitive)
-- >>> let h = firstPrimitive 4 :: Either PolynomialError (Primitive GF2)
-- >>> fmap (certifiedResidues . certifyPrimitive) h
-- Right [(3,polynomial [0,1,1]),(5,polynomial [0,0,0,1])]
certifyPrimitive :: KnownField k => Primitive k -> PrimitiveCertificate k
certifyPrimitive h =
  PrimitiveCertificate
    { certifiedPrimitive = primitivePolynomial h,
      certifiedFactors = periodFactors h,
      certifiedResidues =
        [(r, fromResidue (powerOfX modulus (period h `div` r))) | (r, _) <- periodFactors h]
    }
  where
    modulus = primitiveModulus h

-- | Checks a certificate and returns the primitive polynomial. It decides anew that the factors are
-- prime. Refuses a certificate that does not prove its claim.
verifyPrimitive ::
  forall k.
  KnownField k =>
  PrimitiveCertificate k ->
  Either CertificateFault (Primitive k)
verifyPrimitive (PrimitiveCertificate h factors residues) = do
  modulus <- fitModulus h
  let full = fromIntegral (fieldOrder (Proxy :: Proxy k)) ^ modulusDegree modulus - 1
      multiplied = product [r ^ e | (r, e) <- factors]
      primes = map fst factors
  when (multiplied /= full) (Left (FactorsDoNotMultiply multiplied full))
  forM_ (zip [0 ..] primes) $ \(i, r) -> do
    prime <- first FactorUndecided (isPrime r)
    unless (prime && r `notElem` take i primes) (Left (FactorNotPrime r))
  when (powerOfX modulus full /= residueOne modulus) (Left PowerDoesNotClose)
  forM_ primes $ \r -> do
    given <- maybe (Left (EntryMissing r)) Right (lookup r residues)
    when (given /= fromResidue (powerOfX modulus (full `div` r))) (Left (EntryWrong r))
    when (given == 1) (Left (OrderLower r))
  pure (Primitive h factors modulus)

-- | A proof that h is irreducible, by Rabin's test: x^(q^n) = x modulo h, and for each prime l that
-- divides n, h is coprime to a = x^(q^(n/l)) - x modulo h, because u h + v a = 1.
data IrreducibleCertificate (k :: Field) = IrreducibleCertificate
  { -- | h
    certifiedIrreducible :: Polynomial k,
    -- | for each of those primes l, the polynomials u and v
    certifiedWitnesses :: [(Natural, (Polynomial k, Polynomial k))]
  }
  deriving stock (Eq, Show)

type role IrreducibleCertificate nominal

-- | The certificate of an irreducible polynomial; 'Nothing' for any other.
certifyIrreducible :: KnownField k => Polynomial k -> Maybe (IrreducibleCertificate k)
certifyIrreducible h
  | isIrreducible h = IrreducibleCertificate h . witnesses <$> modulusOf h
  | otherwise = Nothing
  where
    witnesses modulus =
      [ (fromIntegral l, (u, v))
        | l <- primeDivisors (modulusDegree modulus),
          let (_, u, v) = bezout h (powerMinusX modulus (modulusDegree modulus `div` l))
      ]

-- | Checks a certificate. Refuses one that does not prove its claim.
verifyIrreducible :: KnownField k => IrreducibleCertificate k -> Either CertificateFault ()
verifyIrreducible (IrreducibleCertificate h witnesses) = do
  modulus <- maybe (Left PolynomialUnfit) Right (modulusOf h)
  let n = modulusDegree modulus
  when (powerMinusX modulus n /= 0) (Left PowerDoesNotClose)
  forM_ (primeDivisors n) $ \l -> do
    let prime = fromIntegral l
    (u, v) <- maybe (Left (EntryMissing prime)) Right (lookup prime witnesses)
    when (u * h + v * powerMinusX modulus (n `div` l) /= 1) (Left (EntryWrong prime))

-- | The arithmetic modulo a polynomial. Refuses polynomials that are constant, not monic, or
-- divisible by x.
fitModulus :: KnownField k => Polynomial k -> Either CertificateFault (Modulus k)
fitModulus h = case modulusOf h of
  Just modulus | isMonic h && valueAt h zero /= zero -> Right modulus
  _ -> Left PolynomialUnfit
