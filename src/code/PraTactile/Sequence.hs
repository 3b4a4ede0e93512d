{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE RoleAnnotations #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Maximal-length sequences (m-sequences) from a shift register with feedback (section II
-- of the paper; MacWilliams and Sloane 1976). With h(x) = x^n + c(n-1) x^(n-1) + ... + c0 the
-- characteristic polynomial, s(i+n) = - (c0 s(i) + ... + c(n-1) s(i+n-1)).
module PraTactile.Sequence
  ( -- * States
    State
  , initialState
  , canonicalState
  , stateElements
  , SequenceError (..)

    -- * Sequences
  , mSequence
  , sequenceVector
  , termAt
  ) where

import Control.Monad (forM_)
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Extension
import PraTactile.Field
import PraTactile.Polynomial

-- | Why a state does not start an m-sequence.
data SequenceError
  = -- | There are as many elements as the first number says instead of n, the second.
    StateLength Int Int
  | -- | All elements are 0, and so would all terms be.
    StateZero
  deriving stock (Eq, Show)

-- | The content s(0), ..., s(n-1) of the shift register: n elements, not all 0.
newtype State (k :: Field) = State [GF k]
  deriving stock (Eq)

type role State nominal

instance KnownField k => Show (State k) where
  showsPrec d (State s) = showsPrec d s

-- | The state s(0), ..., s(n-1) for a polynomial of degree n. Refuses another number of elements, and
-- all zeros.
initialState :: Primitive k -> [GF k] -> Either SequenceError (State k)
initialState h s
  | given /= n = Left (StateLength given n)
  | all (== zero) s = Left StateZero
  | otherwise = Right (State s)
 where
  n = primitiveDegree h
  given = length (take (n + 1) s)

-- | The state 0, ..., 0, 1.
canonicalState :: Primitive k -> State k
canonicalState h = State (replicate (primitiveDegree h - 1) zero ++ [one])

-- | s(0), ..., s(n-1).
stateElements :: State k -> [GF k]
stateElements (State s) = s

-- | The endless m-sequence, of period q^n - 1, as the recurrence states it.
--
-- >>> import PraTactile.Field.Named (GF4)
-- >>> let terms h = take 9 (mSequence h (canonicalState h))
-- >>> fmap terms (firstPrimitive 4 :: Either PolynomialError (Primitive GF4))
-- Right [0,0,0,1,0,1,A,A,0]
mSequence :: KnownField k => Primitive k -> State k -> [GF k]
mSequence h (State s0) = go s0
 where
  lower = init' (coefficients (primitivePolynomial h))
  init' cs = take (primitiveDegree h) cs
  go s = case s of
    oldest : younger -> oldest : go (younger ++ [negate (sum (zipWith (*) lower s))])
    [] -> []

-- | The first terms s(0), ..., s(count - 1), in one byte each; a negative count gives none.
sequenceVector :: KnownField k => Primitive k -> State k -> Int -> Vector (GF k)
sequenceVector h (State s0) count = Primitive.take count $ Primitive.create $ do
  terms <- Mutable.replicate (max n count) zero
  forM_ (zip [0 ..] s0) (uncurry (Mutable.write terms))
  let fill i
        | i >= count = pure terms
        | otherwise = feedback 0 zero >>= Mutable.unsafeWrite terms i >> fill (i + 1)
       where
        feedback j acc
          | j == n = pure acc
          | otherwise = do
              s <- Mutable.unsafeRead terms (i - n + j)
              feedback (j + 1) (acc + Primitive.unsafeIndex taps j * s)
  fill n
 where
  n = primitiveDegree h
  -- -c0, ..., -c(n-1)
  taps = Primitive.fromListN n (map negate (take n (coefficients (primitivePolynomial h))))
{-# INLINABLE sequenceVector #-}

-- | The term s(t) for any t, without the terms before it: if x^t = r0 + ... + r(n-1) x^(n-1) modulo
-- h, then s(t) = r0 s(0) + ... + r(n-1) s(n-1), because both sides obey the recurrence.
termAt :: KnownField k => Primitive k -> State k -> Natural -> GF k
termAt h (State s) t = sum (zipWith (*) (residueCoefficients h (powerOfRoot h t)) s)
