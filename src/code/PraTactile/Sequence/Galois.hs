{-# OPTIONS_HADDOCK hide #-}

-- | The Galois form of the shift register: its content is a residue modulo h, and a step multiplies
-- it by x. The register of "PraTactile.Sequence" (the Fibonacci form) adds its stages up into one;
-- this one adds its output to its stages. Both give the same sequences; 'toGalois' and
-- 'toFibonacci' convert the states (Golomb, Shift Register Sequences, 1967).
module PraTactile.Sequence.Galois
  ( -- * States
    GaloisState,
    galoisState,
    galoisElements,

    -- * The register
    galoisNext,
    galoisPrevious,
    galoisOutput,
    galoisSequence,

    -- * The same sequence in both forms
    toGalois,
    toFibonacci,
  )
where

import Data.List (foldl')
import PraTactile.Field
import PraTactile.Polynomial
import PraTactile.Sequence

-- | The nonzero residue g0 + g1 x + ... + g(n-1) x^(n-1).
newtype GaloisState (k :: Field) = GaloisState [GF k]
  deriving stock (Eq)

type role GaloisState nominal

instance KnownField k => Show (GaloisState k) where
  showsPrec d (GaloisState g) = showsPrec d g

-- | The state g0, ..., g(n-1) for a polynomial of degree n. Refuses another number of elements, and
-- all zeros.
galoisState :: Primitive k -> [GF k] -> Either SequenceError (GaloisState k)
galoisState h g = GaloisState . stateElements <$> initialState h g

-- | The elements g0, ..., g(n-1) of a state.
galoisElements :: GaloisState k -> [GF k]
galoisElements (GaloisState g) = g

-- | One step: the product by x, modulo h = x^n + c(n-1) x^(n-1) + ... + c0. The stages move up, the
-- stage of x^(n-1) is the output, and c(j) times the output is subtracted from each stage j.
galoisNext :: KnownField k => Primitive k -> GaloisState k -> GaloisState k
galoisNext h state@(GaloisState g) =
  GaloisState (zipWith (\c below -> below - c * galoisOutput state) (lower h) (zero : g))

-- | One step back: the state from which 'galoisNext' leads to this one.
galoisPrevious :: KnownField k => Primitive k -> GaloisState k -> GaloisState k
galoisPrevious h (GaloisState g) =
  GaloisState (zipWith (\c above -> above + c * out) (drop 1 (lower h)) (drop 1 g) ++ [out])
  where
    -- g0 = - c0 out; c0 is not zero, so its inverse is c0^(q - 2).
    out = negate (sum (take 1 g) * power (sum (take 1 (lower h))) (fromIntegral (fieldOrder h - 2)))

-- | The output of the register's next step: the coefficient of x^(n-1).
galoisOutput :: GaloisState k -> GF k
galoisOutput (GaloisState g) = foldl' (\_ a -> a) zero g

-- | The endless output of the register from this state on. Its term i is a linear function, the
-- same for all i, of x^i g modulo h; so the terms obey the recurrence of h.
--
-- >>> import PraTactile.Field.Named (GF4)
-- >>> let terms h = take 9 (galoisSequence h (toGalois h (canonicalState h)))
-- >>> fmap terms (firstPrimitive 4 :: Either PolynomialError (Primitive GF4))
-- Right [0,0,0,1,0,1,A,A,0]
galoisSequence :: KnownField k => Primitive k -> GaloisState k -> [GF k]
galoisSequence h = map galoisOutput . iterate (galoisNext h)

-- | The Galois state with the same output as the Fibonacci register in its state s(0), ..., s(n-1):
-- g(n-1-j) = s(j) + c(n-1) s(j-1) + ... + c(n-j) s(0).
toGalois :: KnownField k => Primitive k -> State k -> GaloisState k
toGalois h s = GaloisState (map stage [primitiveDegree h, primitiveDegree h - 1 .. 1])
  where
    -- The list @downwards@ is 1, c(n-1), c(n-2), ...; @stage j@ is g(n-j), a sum of j terms.
    downwards = reverse (coefficients (primitivePolynomial h))
    stage j = sum (zipWith (*) downwards (reverse (take j (stateElements s))))

-- | The state s(0), ..., s(n-1) of the Fibonacci register with the same output as the Galois
-- register. It never refuses a state of h's own degree.
toFibonacci :: KnownField k => Primitive k -> GaloisState k -> Either SequenceError (State k)
toFibonacci h = initialState h . take (primitiveDegree h) . galoisSequence h

-- | The coefficients c0, ..., c(n-1).
lower :: Primitive k -> [GF k]
lower h = take (primitiveDegree h) (coefficients (primitivePolynomial h))
