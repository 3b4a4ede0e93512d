{-# OPTIONS_HADDOCK hide #-}

-- | The definition of GF(p^m): polynomials over the integers modulo p, modulo a monic polynomial f
-- of degree m. It works on lists, imports nothing but base, and is meant to be read, not used:
-- "PraTactile.Field" is the fast form, and the test suite compares every sum and every product of
-- the two.
module PraTactile.Field.Definition
  ( -- * The ring Z_p[x] / f
    Ring (..),
    ringOrder,

    -- * Elements
    Element,
    fromCode,
    toCode,
    add,
    multiply,
  )
where

import Numeric.Natural (Natural)

-- | Z_p[x] modulo f. It is the field GF(p^m) when p is prime and f irreducible modulo p; nothing
-- here depends on that.
data Ring = Ring
  { -- | p
    ringPrime :: Natural,
    -- | f, constant term first, monic: its last coefficient is 1
    ringModulus :: [Natural]
  }
  deriving stock (Eq, Show)

-- | m, the degree of f.
ringDegree :: Ring -> Int
ringDegree ring = length (ringModulus ring) - 1

-- | p^m, the number of elements.
--
-- >>> ringOrder (Ring 2 [1, 1, 1])
-- 4
ringOrder :: Ring -> Natural
ringOrder ring = ringPrime ring ^ ringDegree ring

-- | The m coefficients of a residue, constant term first, each below p.
type Element = [Natural]

-- | The element whose coefficients are the base-p digits of the code, lowest degree first; digits
-- beyond the m-th are dropped.
--
-- >>> fromCode (Ring 3 [2, 2, 1]) 5
-- [2,1]
fromCode :: Ring -> Natural -> Element
fromCode ring code = take (ringDegree ring) (digits code)
  where
    p = ringPrime ring
    digits c = c `mod` p : digits (c `div` p)

-- | The code of an element: its coefficients as base-p digits.
--
-- >>> toCode (Ring 3 [2, 2, 1]) [2, 1]
-- 5
toCode :: Ring -> Element -> Natural
toCode ring = foldr (\c rest -> c + ringPrime ring * rest) 0

-- | Addition: coefficient by coefficient, modulo p.
add :: Ring -> Element -> Element -> Element
add ring = zipWith (\a b -> (a + b) `mod` ringPrime ring)

-- | Multiplication: the product of the polynomials, then its remainder by f.
--
-- >>> multiply (Ring 2 [1, 1, 1]) [0, 1] [0, 1]
-- [1,1]
multiply :: Ring -> Element -> Element -> Element
multiply ring a b = remainder ring (convolve a b)

-- | The product of two polynomials; its coefficients are not yet reduced.
convolve :: [Natural] -> [Natural] -> [Natural]
convolve a b =
  [ sum [x * y | (i, x) <- zip [0 :: Int ..] a, (j, y) <- zip [0 ..] b, i + j == k]
    | k <- [0 .. length a + length b - 2]
  ]

-- | The remainder by f: while the degree is m or more, take away a multiple of f that cancels the
-- leading coefficient.
remainder :: Ring -> [Natural] -> Element
remainder ring = go . map (`mod` p)
  where
    p = ringPrime ring
    m = ringDegree ring
    go a
      | length a > m = go (cancel a)
      | otherwise = a ++ replicate (m - length a) 0
    cancel a =
      let leading = sum (drop (length a - 1) a)
          shifted = replicate (length a - 1 - m) 0 ++ ringModulus ring
          minus x y = (x + (p - leading) * y) `mod` p
       in take (length a - 1) (zipWith minus a shifted)
