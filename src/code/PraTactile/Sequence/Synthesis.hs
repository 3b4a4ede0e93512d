-- | Finds the shortest shift register over GF(q) that produces given symbols, by the algorithm of
-- Berlekamp and Massey (Massey, Shift-register synthesis and BCH decoding, IEEE Transactions on
-- Information Theory 15(1), 1969).
module PraTactile.Sequence.Synthesis
  ( Synthesis,
    synthesise,
    synthesisTerms,
    synthesisLength,
    synthesisPolynomial,
    synthesisDetermined,
  )
where

import Data.List (foldl')
import PraTactile.Field
import PraTactile.Polynomial

-- | A shortest register for some first terms.
data Synthesis (k :: Field) = Synthesis
  { -- | The number N of terms it was made from.
    synthesisTerms :: !Int,
    -- | The number L of its stages; 0 if all terms are 0. No shorter register produces these terms.
    synthesisLength :: !Int,
    -- | 1, C1, ..., CL: s(i) + C1 s(i-1) + ... + CL s(i-L) = 0 for L <= i < N.
    connection :: [GF k]
  }
  deriving stock (Eq)

type role Synthesis nominal

-- | The shortest register that produces these terms. O(N L) operations in GF(q).
--
-- >>> import PraTactile.Field.Named (GF2)
-- >>> synthesisPolynomial (synthesise [0, 0, 1, 0, 1, 1] :: Synthesis GF2)
-- polynomial [1,1,0,1]
synthesise :: KnownField k => [GF k] -> Synthesis k
synthesise terms =
  Synthesis (seen end) (stages end) (take (stages end + 1) (current end ++ repeat zero))
  where
    end = foldl' observe (Progress 0 0 [one] [zero, one] one []) terms

-- | Massey's variables. After a change of length, x B divided by its discrepancy corrects the next
-- error.
data Progress (k :: Field) = Progress
  { seen :: !Int,
    stages :: !Int,
    -- | C, the register so far
    current :: [GF k],
    -- | x^m B, where B is the register before the last change of length, m terms ago
    shifted :: [GF k],
    -- | the discrepancy of B then
    discrepancyBefore :: !(GF k),
    -- | the terms seen, the last one first
    backwards :: [GF k]
  }

observe :: KnownField k => Progress k -> GF k -> Progress k
observe p s
  | discrepancy == zero = moved
  | 2 * stages p <= seen p =
    corrected
      { stages = seen p + 1 - stages p,
        shifted = zero : current p,
        discrepancyBefore = discrepancy
      }
  | otherwise = corrected
  where
    discrepancy = sum (zipWith (*) (take (stages p + 1) (current p)) (s : backwards p))
    moved = p {seen = seen p + 1, shifted = zero : shifted p, backwards = s : backwards p}
    corrected = foldr seq () repaired `seq` moved {current = repaired}
    repaired = subtractMultiple ratio (current p) (shifted p)
    -- The discrepancy before is not zero.
    ratio = either (const zero) id (divide discrepancy (discrepancyBefore p))

-- | @subtractMultiple r a b@ is a - r b, coefficient by coefficient.
subtractMultiple :: KnownField k => GF k -> [GF k] -> [GF k] -> [GF k]
subtractMultiple r (a : as) (b : bs) = a - r * b : subtractMultiple r as bs
subtractMultiple _ as [] = as
subtractMultiple r [] bs = map (negate . (r *)) bs

-- | The monic polynomial of degree L of the recurrence. Its constant term is 0 if the terms become
-- periodic only after a beginning. O(L).
synthesisPolynomial :: Synthesis k -> Polynomial k
synthesisPolynomial = polynomial . reverse . connection

-- | Whether no other register of this length produces the same terms: 2 L <= N.
synthesisDetermined :: Synthesis k -> Bool
synthesisDetermined found = 2 * synthesisLength found <= synthesisTerms found
