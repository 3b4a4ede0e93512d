{-# OPTIONS_HADDOCK hide #-}

-- | The ways to fold the q^n - 1 terms of a sequence into rectangles, and the windows that work in
-- them for every polynomial.
module PraTactile.Advise.Layout
  ( Layout (..),
    layoutSurface,
    layoutWeights,
    sureWindows,
    degreeOfOrder,

    -- * Divisors
    divisors,
  )
where

import Data.List (find, nub, sort)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Array.Remainder

-- | How a sequence is folded into one array or several.
data Layout
  = -- | Into one array: along the diagonal of the torus, or row by row on the twisted torus.
    Single Folding
  | -- | Into this many arrays that share the window property, each along the diagonal of its own
    -- torus: see "PraTactile.ArrayCode".
    Joint Natural
  deriving stock (Eq, Ord, Show)

-- | The surface on which the windows are distinct.
layoutSurface :: Layout -> Surface
layoutSurface layout = case layout of
  Single folding -> naturalSurface folding
  Joint _ -> Torus

-- | The weights of rows and columns in the indices of the terms, for this shape of each array.
layoutWeights :: Layout -> Shape -> Weights
layoutWeights layout (Shape n1 n2) = case layout of
  Single RowMajor -> (n2, 1)
  Single Diagonal -> diagonalWeights n1 n2
  Joint g -> let (u, v) = diagonalWeights n1 n2 in (g * u, g * v)

{- Note [Windows that are sure]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   Let the cell (r, c) hold s(r u + c v), and let d1 and d2 be the degrees over GF(q) of alpha^u and
   alpha^v. Assume that the two generate GF(q^n), which means lcm(d1, d2) = n. Then alpha^v has
   degree n/d1 over GF(q^d1), the field that alpha^u generates. So the alpha^(u i), i < d1, are a
   basis of GF(q^d1) over GF(q), and the alpha^(v j), j < n/d1, are a basis of GF(q^n) over
   GF(q^d1). Their products, the cells of a d1 x n/d1 window, are a basis of GF(q^n) over GF(q), so
   the rank is n. In the same way, n/d2 x d2 windows have rank n. The degrees depend only on the
   orders of alpha^u and alpha^v, not on the polynomial. If n1 = q^k1 - 1, then d1 = k1, and these
   are the windows of MacWilliams and Sloane. -}

-- | The windows of n cells that are distinct for every primitive polynomial of degree n: none, one
-- or two. Arguments: q, n, the layout, and the shape of each array, which the layout must fill. See
-- Note [Windows that are sure].
--
-- >>> sureWindows 4 6 (Joint 3) (Shape 15 91)
-- [Shape {rows = 2, columns = 3},Shape {rows = 1, columns = 6}]
sureWindows :: Natural -> Natural -> Layout -> Shape -> [Shape]
sureWindows q n layout shape
  | n == 0 || q < 2 || lcm d1 d2 /= n = []
  | otherwise = nub [Shape d1 (n `div` d1), Shape (n `div` d2) d2]
  where
    terms = q ^ n - 1
    (u, v) = layoutWeights layout shape
    d1 = degreeOfPower u
    d2 = degreeOfPower v
    degreeOfPower e = degreeOfOrder q n (terms `div` gcd terms e)

-- | @degreeOfOrder q n m@ is the degree over GF(q) of an element of GF(q^n) with multiplicative
-- order m, which must divide q^n - 1: the least d for which m divides q^d - 1.
degreeOfOrder :: Natural -> Natural -> Natural -> Natural
degreeOfOrder q n m =
  fromMaybe n (find (\d -> n `mod` d == 0 && (q ^ d - 1) `mod` max 1 m == 0) [1 .. n])

-- | The divisors of a number, ascending, given its prime factors with their exponents.
divisors :: [(Natural, Natural)] -> [Natural]
divisors factors = sort (map product (traverse (\(p, e) -> map (p ^) [0 .. e]) factors))
