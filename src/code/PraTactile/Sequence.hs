-- | Maximal-length sequences (m-sequences) from a feedback shift register (section II of the paper;
-- MacWilliams and Sloane 1976): forwards, backwards, and by jumps of any length. If the
-- characteristic polynomial is h(x) = x^n + c(n-1) x^(n-1) + ... + c0, then s(i+n) = - (c0 s(i) +
-- ... + c(n-1) s(i+n-1)).
--
-- Costs are numbers of operations in GF(q). n is the degree of h; a state has n elements, and
-- making or reading it takes O(n).
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
  = -- | The state has the first number of elements instead of n, the second.
    StateLength Int Int
  | -- | All elements are 0, so all terms would be 0.
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

-- | The elements s(0), ..., s(n-1) of a state.
stateElements :: State k -> [GF k]
stateElements (State s) = s

-- | The coefficients c0, ..., c(n-1).
feedback :: Primitive k -> [GF k]
feedback h = take (primitiveDegree h) (coefficients (primitivePolynomial h))

-- | One step of the register: s(i), ..., s(i+n-1) becomes s(i+1), ..., s(i+n). O(n).
next :: KnownField k => Primitive k -> State k -> State k
next h (State s) = State (drop 1 s ++ [negate (sum (zipWith (*) (feedback h) s))])

-- | One step back: the state s(i-1), ..., s(i+n-2) from which 'next' leads to this one. It uses c0
-- s(i-1) = - (c1 s(i) + ... + c(n-1) s(i+n-2) + s(i+n-1)). O(n).
previous :: KnownField k => Primitive k -> State k -> State k
previous h (State s) =
  State (negate (inverted * sum (zipWith (*) others s)) : take (primitiveDegree h - 1) s)
  where
    (constantTerm, others) = splitAt 1 (coefficients (primitivePolynomial h))
    -- c0 is not zero, and a^(q - 2) is the inverse of such an a.
    inverted = power (sum constantTerm) (fromIntegral (fieldOrder h - 2))

-- | The endless m-sequence, of period q^n - 1, by its recurrence. O(n) for each term.
--
-- >>> import PraTactile.Field.Named (GF4)
-- >>> let terms h = take 9 (mSequence h (canonicalState h))
-- >>> fmap terms (firstPrimitive 4 :: Either PolynomialError (Primitive GF4))
-- Right [0,0,0,1,0,1,A,A,0]
mSequence :: KnownField k => Primitive k -> State k -> [GF k]
mSequence h = concatMap (take 1 . stateElements) . iterate (next h)

-- | The first terms s(0), ..., s(count - 1), as bytes; none for a negative count. It takes a few
-- nanoseconds for eight terms in characteristic 2, otherwise for one term. O(w count) for w nonzero
-- terms of h.
sequenceVector :: KnownField k => Primitive k -> State k -> Int -> Vector (GF k)
sequenceVector h (State s0) count = Primitive.create $ do
  terms <- Mutable.new (max 0 count)
  forM_ (zip [0 .. count - 1] s0) (uncurry (Mutable.write terms))
  continue (recurrenceOf (feedback h)) (primitiveDegree h) count terms
  pure terms

-- | The term s(t) for any t, without computing the terms before it. Apply it once to a polynomial
-- and a state, and then to any number of t: @map (termAt h state) ts@. It makes a table once, of at
-- most a MiB or q n^2 bytes. Then a term takes O(n^2 log (min t N)), where N is the period q^n - 1.
termAt :: KnownField k => Primitive k -> State k -> Natural -> GF k
termAt h (State s) = jump h s

-- | The state s(t), ..., s(t+n-1) of the register after t steps, or before it if t is negative,
-- without computing the steps between. Each call makes the table of 'termAt' and takes n terms from
-- it.
stateAt :: KnownField k => Primitive k -> State k -> Integer -> State k
stateAt h s t = State (map (termAt h s . (start +)) (genericTake (primitiveDegree h) [0 ..]))
  where
    start = fromInteger (t `mod` toInteger (period h))
