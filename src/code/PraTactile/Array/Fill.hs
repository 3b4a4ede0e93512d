{-# OPTIONS_HADDOCK hide #-}

-- | Writes a folded sequence into memory in the order of its cells. Internal: arrays and array
-- codes are converted to grids by it.
module PraTactile.Array.Fill
  ( filled,
    minimalPolynomialOfPower,
    codes,
  )
where

import Control.Monad (forM_)
import Data.Vector.Primitive (Vector (..))
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word8)
import Numeric.Natural (Natural)
import PraTactile.Array.Remainder
import PraTactile.Field
import PraTactile.Grid
import PraTactile.Polynomial
import PraTactile.Sequence.Jump
import PraTactile.Sequence.Recurrence
import PraTactile.Sequence.Synthesis

{- Note [Rows and columns obey recurrences]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   Writing s(i) into cell (i mod n1, i mod n2) for i = 0, 1, 2, ... jumps from row to row and misses
   the cache at every step. But if the cell (r, c) holds s(r u + c v), each row runs through the
   sequence in steps of v. So it obeys the recurrence of the minimal polynomial of alpha^v, and each
   column obeys that of alpha^u. Therefore a few rows are continued from their first terms, and
   every further row is computed whole, as a linear combination of rows before it. -}

-- | @filled h s (u, v) shape@ lists the cells row by row, with s(r u + c v) in the cell (r, c). The
-- function s gives the sequence's terms below the period. See Note [Rows and columns obey
-- recurrences].
filled :: KnownField k => Primitive k -> (Natural -> GF k) -> Weights -> Shape -> Vector (GF k)
filled h s (u, v) (Shape n1 n2) = Primitive.create $ do
  cells <- Mutable.new (height * width)
  forM_ [0 .. seeds - 1] $ \r -> do
    -- The row has memory of its own, because within the cells it would not begin at a whole word.
    line <- Mutable.new width
    forM_ (take width (zip [0 ..] (firstTerms (fromIntegral r)))) (uncurry (Mutable.write line))
    continue along (longestLag along) width line
    Mutable.copy (Mutable.slice (r * width) width cells) line
  continue down (seeds * width) (height * width) cells
  pure cells
  where
    height = fromIntegral n1 :: Int
    width = fromIntegral n2 :: Int
    along = recurrenceOfPower v
    down = delayed width (recurrenceOfPower u)
    firstTerms r = [s (weightedIndex (period h) (u, v) r c) | c <- take (longestLag along) [0 ..]]
    -- In wide arrays as many rows as the faster recurrence looks back; in others as few as
    -- possible.
    seeds
      | width >= 1024 = min height ((longestLag (spread down) + width - 1) `div` width)
      | otherwise = min height (longestLag down `div` max 1 width)
    recurrenceOfPower e =
      let cs = coefficients (minimalPolynomialOfPower h e) in recurrenceOf (take (length cs - 1) cs)

-- | The minimal polynomial of alpha^e over GF(q), by synthesis from the coefficients of 1 in
-- alpha^0, alpha^e, alpha^(2 e), ... This sequence obeys the minimal polynomial, which is
-- irreducible, and is not zero, since its first term is 1. So it obeys no shorter recurrence. The
-- degree is at most n, so 2 n terms determine it.
minimalPolynomialOfPower :: KnownField k => Primitive k -> Natural -> Polynomial k
minimalPolynomialOfPower h e =
  synthesisPolynomial (synthesise (map (coefficient . (* e)) (take (2 * n) [0 ..])))
  where
    n = primitiveDegree h
    coefficient = jump h (one : replicate (n - 1) zero)

-- | The elements' codes, in the same memory.
codes :: Vector (GF k) -> Vector Word8
codes (Vector offset size bytes) = Vector offset size bytes
