{-# OPTIONS_HADDOCK hide #-}

-- | Runs of polynomials at the beginning of the ascending order that contain no irreducible one. A
-- search can skip them; they may have millions of polynomials. Internal; "PraTactile.Polynomial"
-- exports it.
module PraTactile.Polynomial.Reducible
  ( reducibleRun,
  )
where

import Data.Proxy (Proxy)
import PraTactile.Field

-- | @reducibleRun k n@ is a number i: 0, 2 or 3. If n > i, no polynomial x^n + c(i-1) x^(i-1) + ...
-- + c1 x + c0 is irreducible over the field, whatever the i coefficients are; for i = 0 that says
-- that x^n is not. See Note [An even number of factors] and Note [Affine polynomials].
reducibleRun :: KnownField k => Proxy k -> Int -> Int
reducibleRun k n
  | n <= 4 = 0
  | p == 2 && even n && (n `mod` 8 `elem` [0, 2] || even (fieldDegree k)) =
    if n `mod` 4 == 0 then 3 else 2
  | p > 2 && n `mod` p == 0 && even n && (n `mod` 4 == 0 || q `mod` 4 == 1) = 2
  | p > 2 && n `mod` p == 1 && n `mod` 4 == 3 && q `mod` 4 == 3 = 2
  | p > 2 && n `elem` drop 2 (takeWhile (<= n) (iterate (* p) 1)) = 2
  | otherwise = 0
  where
    p = fieldCharacteristic k
    q = fieldOrder k

{- Note [An even number of factors]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   Let f over GF(q) be monic of degree n without multiple roots, with discriminant D and r
   irreducible factors. For odd q, n - r is even exactly if D is a square in GF(q) (L. Stickelberger
   1897). The reason: let d be the product of the differences of its roots, each pair taken once.
   Then D = d^2. The q-th power map permutes the roots in r cycles and takes d to (-1)^(n-r) d. So
   if n is odd and D is never a square, or n is even and D is always a square, r is even and f is
   reducible. With a multiple root f is reducible too.

   The discriminant of x^n + a x + b is (-1)^(n(n-1)/2) (n^n b^(n-1) + (-1)^(n-1) (n-1)^(n-1) a^n)
   (R. G. Swan 1962). If p divides n and n is even, it is (-1)^(n(n-1)/2) a^n. That is always a
   square or 0 if n is a multiple of 4, or if -1 is a square, which holds for q = 1 modulo 4. If p
   divides n - 1 and n is odd, it is (-1)^(n(n-1)/2) b^(n-1). That is never a nonzero square if n =
   3 and q = 3, both modulo 4.

   For q = 2^m, consider the unramified extension of the 2-adic numbers that has GF(q) as its
   residue field. Take any monic polynomial F over its integers that is f modulo 2. The Frobenius
   map permutes the roots of F as the q-th power map permutes those of f. So n - r is even exactly
   if the discriminant D of F is a square there. D is odd. And 1 + 4 b is the square of some 1 + 2 y
   exactly if y^2 + y = b modulo 2 has a solution y, which holds if b has trace 0 (Swan 1962). So 1
   modulo 8 is always a square, and 5 modulo 8 is a square if the trace of 1, which is m modulo 2,
   is 0.

   Let n be even, F = x^n + c2 x^2 + c1 x + c0, and let A run through its roots. D is
   (-1)^(n(n-1)/2) times the product of the derivatives F'(A) = c1 + 2 c2 A + n A^(n-1). If c1 is
   even, f is a square. Otherwise, first let n be a multiple of 4, n > 4. The product is c1^n times
   that of all 1 + u A + v A^(n-1) with u = 2 c2 / c1 and v = n / c1. Modulo 8, u^3, u v and v^2 are
   0. What remains is 1 + u s1 + u^2 s2 + v t. Here s1 is the sum of the roots and s2 the sum of
   their products in pairs; both are 0, because the coefficients of x^(n-1) and x^(n-2) are. And t
   is the sum of the powers A^(n-1), which is -(n-1) c1 by Newton's identities. So D = c1^n (1 - n
   (n-1)) = c1^n (1 + n): a square, or 5 times a square if n = 4 modulo 8. Next let n be even but
   not a multiple of 4, n > 2, and c2 = 0. Then modulo 8 the formula above leaves D = (n-1)^(n-1)
   c1^n = (n-1) c1^n: a square, or 5 times a square if n = 6 modulo 8. -}

{- Note [Affine polynomials]
   ~~~~~~~~~~~~~~~~~~~~~~~~~
   Let f = L + c be irreducible of degree p^k over GF(q), where L is a sum of terms a_i x^(p^i).
   Then f has p^k roots, because irreducible polynomials over a finite field have no multiple roots.
   The difference of two roots is a root of L. So the roots of L are a vector space V of dimension k
   over GF(p), and the roots of f are b + V for any one of them, b.

   Since f is irreducible, the q-th power map permutes its roots in a single cycle. It also maps V
   to V, linearly over GF(p), because L has its coefficients in GF(q). Let A be that linear map, and
   w = b^q - b. Then the q-th power map takes b + v to b + (A v + w). So v -> A v + w permutes V in
   a single cycle of length p^k. Write this map as the matrix M with k + 1 rows, (A w) and (0 1); M
   has order p^k.

   Then M - 1 is nilpotent, because (M - 1)^(p^k) = M^(p^k) - 1 = 0, and so (M - 1)^(k+1) = 0. For
   the least e with p^e >= k + 1 that gives M^(p^e) = 1, and so k <= e. If k > 0, p^(e-1) <= k by
   the choice of e. Together p^(k-1) <= k. That holds for k = 1 and for p = k = 2, but for no other
   k >= 2. So x^(p^k) + c1 x + c0 is reducible for odd p and k >= 2. -}
