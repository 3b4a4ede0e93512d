-- | Polynomials over GF(q), and which of them are primitive: those whose root alpha generates
-- GF(q^n), so that the shift register of the paper's section II runs through all q^n - 1 nonzero
-- states.
--
-- Costs are numbers of operations in GF(q), each a table look-up. n is the degree of the
-- polynomial, the higher one of two, or the requested one; N is q^n - 1. Making or reading a
-- polynomial takes O(n).
module PraTactile.Polynomial
  ( -- * Polynomials
    Polynomial,
    polynomial,
    polynomialFromCodes,
    coefficients,
    constant,
    variable,
    polynomialDegree,
    leadingCoefficient,
    isMonic,
    valueAt,

    -- * Division
    quotientRemainder,
    greatestCommonDivisor,
    bezout,
    powerModulo,

    -- * Irreducible polynomials
    isIrreducible,
    irreduciblePolynomials,
    countIrreducible,

    -- * Primitive polynomials
    Primitive,
    checkPrimitive,
    primitivePolynomial,
    primitiveDegree,
    period,
    periodFactors,
    reciprocal,
    PolynomialError (..),

    -- * Search
    primitivePolynomials,
    firstPrimitive,
    fewestTermsPrimitive,
    randomPrimitive,
    countPrimitive,
    primitiveAmong,

    -- * Candidates
    monicPolynomials,
    monicByTerms,
    randomMonics,
    ascendingCandidates,
    fewestTermsCandidates,
    reducibleRun,
  )
where

import PraTactile.Polynomial.Irreducible
import PraTactile.Polynomial.Primitive
import PraTactile.Polynomial.Reducible
import PraTactile.Polynomial.Ring
import PraTactile.Polynomial.Search
