{-# LANGUAGE AllowAmbiguousTypes #-}
{-# LANGUAGE DefaultSignatures #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE TypeApplications #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The Conway polynomials of the fields up to 256 elements (F. Luebeck's tables; the test suite
-- compares them with another program's), and the fields with a type of their own. Internal, because
-- of the class; "PraTactile.Field.Named" exports the rest.
module PraTactile.Field.Conway
  ( -- * Default moduli
    conwayModulus,
    modulusDegrees,
    conwayModuli,

    -- * Fields
    NamedField (..),
    GF2,
    GF3,
    GF4,
    GF5,
    GF7,
    GF8,
    GF9,
    GF16,
    GF256,
  )
where

import Numeric.Natural (Natural)
import PraTactile.Field.Kind (Field (..), KnownIndex, fieldIndex)
import PraTactile.Field.Tables (FieldError (..), Tables, largestOrder, trustedTables)

-- | The characteristic p and the default modulus of GF(q): its Conway polynomial, constant term
-- first. Refuses orders above 256 ('FieldTooLarge') and orders that are not prime powers.
--
-- >>> import PraTactile.Field.Conway (conwayModulus, modulusDegrees)
-- >>> conwayModulus 9
-- Right (3,[2,2,1])
-- >>> conwayModulus 6
-- Left (NotAPrimePower 6)
conwayModulus :: Natural -> Either FieldError (Natural, [Natural])
conwayModulus q
  | q > largestOrder = Left (FieldTooLarge q 1)
  | otherwise = maybe (Left (NotAPrimePower q)) Right (lookup q conwayModuli)

-- | The characteristic p of GF(q), the degree of a given modulus, and the degree that it should
-- have: that of the default modulus. An empty list counts as a constant. Refuses q as
-- 'conwayModulus' does.
--
-- >>> modulusDegrees 9 [2, 1]
-- Right (3,1,2)
modulusDegrees :: Natural -> [Natural] -> Either FieldError (Natural, Natural, Natural)
modulusDegrees q given = do
  (p, conway) <- conwayModulus q
  Right (p, degree given, degree conway)
  where
    degree coefficients = fromIntegral (max 1 (length coefficients) - 1)

-- | The order q of every field up to 256 elements, ascending, with its p and Conway polynomial.
conwayModuli :: [(Natural, (Natural, [Natural]))]
conwayModuli =
  [ (p ^ (length modulus - 1), (p, modulus))
    | (p, modulus) <-
        [ (2, [1, 1]),
          (3, [1, 1]),
          (2, [1, 1, 1]),
          (5, [3, 1]),
          (7, [4, 1]),
          (2, [1, 1, 0, 1]),
          (3, [2, 2, 1]),
          (11, [9, 1]),
          (13, [11, 1]),
          (2, [1, 1, 0, 0, 1]),
          (17, [14, 1]),
          (19, [17, 1]),
          (23, [18, 1]),
          (5, [2, 4, 1]),
          (3, [1, 2, 0, 1]),
          (29, [27, 1]),
          (31, [28, 1]),
          (2, [1, 0, 1, 0, 0, 1]),
          (37, [35, 1]),
          (41, [35, 1]),
          (43, [40, 1]),
          (47, [42, 1]),
          (7, [3, 6, 1]),
          (53, [51, 1]),
          (59, [57, 1]),
          (61, [59, 1]),
          (2, [1, 1, 0, 1, 1, 0, 1]),
          (67, [65, 1]),
          (71, [64, 1]),
          (73, [68, 1]),
          (79, [76, 1]),
          (3, [2, 0, 0, 2, 1]),
          (83, [81, 1]),
          (89, [86, 1]),
          (97, [92, 1]),
          (101, [99, 1]),
          (103, [98, 1]),
          (107, [105, 1]),
          (109, [103, 1]),
          (113, [110, 1]),
          (11, [2, 7, 1]),
          (5, [3, 3, 0, 1]),
          (127, [124, 1]),
          (2, [1, 1, 0, 0, 0, 0, 0, 1]),
          (131, [129, 1]),
          (137, [134, 1]),
          (139, [137, 1]),
          (149, [147, 1]),
          (151, [145, 1]),
          (157, [152, 1]),
          (163, [161, 1]),
          (167, [162, 1]),
          (13, [2, 12, 1]),
          (173, [171, 1]),
          (179, [177, 1]),
          (181, [179, 1]),
          (191, [172, 1]),
          (193, [188, 1]),
          (197, [195, 1]),
          (199, [196, 1]),
          (211, [209, 1]),
          (223, [220, 1]),
          (227, [225, 1]),
          (229, [223, 1]),
          (233, [230, 1]),
          (239, [232, 1]),
          (241, [234, 1]),
          (3, [1, 2, 0, 0, 0, 1]),
          (251, [245, 1]),
          (2, [1, 0, 1, 1, 1, 0, 0, 0, 1])
        ]
  ]

-- | Fields whose tables are made once, when first used. The default method reads the modulus from
-- the type, so that it is written in one place.
class NamedField (k :: Field) where
  namedTables :: Tables
  default namedTables :: KnownIndex k => Tables
  namedTables = uncurry trustedTables (fieldIndex @k)

-- | GF(2): A = 1.
type GF2 = 'Over 2 '[1, 1]

-- | GF(3): A = 2.
type GF3 = 'Over 3 '[1, 1]

-- | GF(4): A^2 = A + 1.
type GF4 = 'Over 2 '[1, 1, 1]

-- | GF(5): A = 2.
type GF5 = 'Over 5 '[3, 1]

-- | GF(7): A = 3.
type GF7 = 'Over 7 '[4, 1]

-- | GF(8): A^3 = A + 1.
type GF8 = 'Over 2 '[1, 1, 0, 1]

-- | GF(9): A^2 = A + 1.
type GF9 = 'Over 3 '[2, 2, 1]

-- | GF(16): A^4 = A + 1.
type GF16 = 'Over 2 '[1, 1, 0, 0, 1]

-- | GF(256): A^8 = A^4 + A^3 + A^2 + 1.
type GF256 = 'Over 2 '[1, 0, 1, 1, 1, 0, 0, 0, 1]

instance NamedField GF2

instance NamedField GF3

instance NamedField GF4

instance NamedField GF5

instance NamedField GF7

instance NamedField GF8

instance NamedField GF9

instance NamedField GF16

instance NamedField GF256
