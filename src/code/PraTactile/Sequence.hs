-- | Maximal-length sequences (m-sequences) from a shift register with feedback (section II of the
-- paper; MacWilliams and Sloane 1976): forwards, backwards, and by jumps of any length. With h(x) =
-- x^n + c(n-1) x^(n-1) + ... + c0 the characteristic polynomial, s(i+n) = - (c0 s(i) + ... + c(n-1)
-- s(i+n-1)).
--
-- Costs are numbers of operations in GF(q). n is the degree of h; a state has n elements, and is
-- made and gone through in O(n).
module PraTactile.Sequence
  ( -- * States
    State,
    initialState,
    canonicalState,
    stateElements,
    SequenceError (..),

    -- * The register
    next,
    previous,
    stateAt,

    -- * Sequences
    mSequence,
    sequenceVector,
    termAt,
  )
where

import Control.Monad (forM_)
import Data.List (genericTake)
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Polynomial
import PraTactile.Sequence.Jump
import PraTactile.Sequence.Recurrence

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

-- | The state s(0), ..., s(n-1) for a polynomial of degree n. Refuses another number of elements,
-- and all zeros.
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

-- | c0, ..., c(n-1).
feedback :: Primitive k -> [GF k]
feedback h = take (primitiveDegree h) (coefficients (primitivePolynomial h))

-- | One step of the register: s(i), ..., s(i+n-1) becomes s(i+1), ..., s(i+n). O(n).
next :: KnownField k => Primitive k -> State k -> State k
next h (State s) = State (drop 1 s ++ [negate (sum (zipWith (*) (feedback h) s))])

-- | One step back: s(i-1), ..., s(i+n-2), the state of which 'next' makes this one; as c0 s(i-1) =
-- - (c1 s(i) + ... + c(n-1) s(i+n-2) + s(i+n-1)). O(n).
previous :: KnownField k => Primitive k -> State k -> State k
previous h (State s) =
  State (negate (inverted * sum (zipWith (*) others s)) : take (primitiveDegree h - 1) s)
  where
    (constantTerm, others) = splitAt 1 (coefficients (primitivePolynomial h))
    -- c0 is not zero, and a^(q - 2) is the inverse of such an a.
    inverted = power (sum constantTerm) (fromIntegral (fieldOrder h - 2))

-- | The endless m-sequence, of period q^n - 1, as the recurrence states it. O(n) a term.
--
-- >>> import PraTactile.Field.Named (GF4)
-- >>> let terms h = take 9 (mSequence h (canonicalState h))
-- >>> fmap terms (firstPrimitive 4 :: Either PolynomialError (Primitive GF4))
-- Right [0,0,0,1,0,1,A,A,0]
mSequence :: KnownField k => Primitive k -> State k -> [GF k]
mSequence h = concatMap (take 1 . stateElements) . iterate (next h)

-- | The first terms s(0), ..., s(count - 1), in one byte each; a negative count gives none. In
-- characteristic 2 a few nanoseconds for eight terms, otherwise a few nanoseconds a term.
-- O(w count) for w terms of h that are not 0.
sequenceVector :: KnownField k => Primitive k -> State k -> Int -> Vector (GF k)
sequenceVector h (State s0) count = Primitive.create $ do
  terms <- Mutable.new (max 0 count)
  forM_ (zip [0 .. count - 1] s0) (uncurry (Mutable.write terms))
  continue (recurrenceOf (feedback h)) (primitiveDegree h) count terms
  pure terms

-- | The term s(t) for any t, without the terms before it. Prepared once for a polynomial and a
-- state it takes any number of t: @map (termAt h state) ts@. A table of a MiB at most or q n^2
-- bytes is made once; then a term takes O(n^2 log (min t N)), N being the period q^n - 1.
termAt :: KnownField k => Primitive k -> State k -> Natural -> GF k
termAt h (State s) = jump h s

-- | The state s(t), ..., s(t+n-1) of the register after t steps, or before if t is negative,
-- without the steps between. It makes the table of 'termAt' at each call, and takes n terms from
-- it.
stateAt :: KnownField k => Primitive k -> State k -> Integer -> State k
stateAt h s t = State (map (termAt h s . (start +)) (genericTake (primitiveDegree h) [0 ..]))
  where
    start = fromInteger (t `mod` toInteger (period h))
