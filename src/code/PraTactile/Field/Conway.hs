{-# LANGUAGE AllowAmbiguousTypes #-}
{-# LANGUAGE DefaultSignatures #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE TypeApplications #-}

-- | The named fields: all 70 prime powers up to 256 with their Conway polynomials as moduli (F.
-- Luebeck's tables; the test suite checks each against the definition of a Conway polynomial).
-- Internal, because of the class; "PraTactile.Field.Named" exports the rest.
module PraTactile.Field.Conway
  ( NamedField (..),
    conwayModulus,
    modulusDegrees,
    conwayModuli,
    GF2,
    GF3,
    GF4,
    GF5,
    GF7,
    GF8,
    GF9,
    GF11,
    GF13,
    GF16,
    GF17,
    GF19,
    GF23,
    GF25,
    GF27,
    GF29,
    GF31,
    GF32,
    GF37,
    GF41,
    GF43,
    GF47,
    GF49,
    GF53,
    GF59,
    GF61,
    GF64,
    GF67,
    GF71,
    GF73,
    GF79,
    GF81,
    GF83,
    GF89,
    GF97,
    GF101,
    GF103,
    GF107,
    GF109,
    GF113,
    GF121,
    GF125,
    GF127,
    GF128,
    GF131,
    GF137,
    GF139,
    GF149,
    GF151,
    GF157,
    GF163,
    GF167,
    GF169,
    GF173,
    GF179,
    GF181,
    GF191,
    GF193,
    GF197,
    GF199,
    GF211,
    GF223,
    GF227,
    GF229,
    GF233,
    GF239,
    GF241,
    GF243,
    GF251,
    GF256,
  )
where

import Numeric.Natural (Natural)
import PraTactile.Field.Kind (Field (..), KnownIndex, fieldIndex)
import PraTactile.Field.Tables (FieldError (..), Tables, largestOrder, trustedTables)

-- | A field whose tables are made once, when first used. The default method reads the modulus off
-- the type, so that it is written in one place.
class NamedField (k :: Field) where
  namedTables :: Tables
  default namedTables :: KnownIndex k => Tables
  namedTables = uncurry trustedTables (fieldIndex @k)

-- | p and the default modulus, constant term first, of GF(q): the Conway polynomial. Refuses orders
-- above 256 ('FieldTooLarge') and those that are no prime power.
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

-- | p of GF(q), the degree of a modulus given for it, and the degree that it needs, the default
-- modulus's. No coefficients count as a constant. Refuses q as 'conwayModulus' does.
--
-- >>> modulusDegrees 9 [2, 1]
-- Right (3,1,2)
modulusDegrees :: Natural -> [Natural] -> Either FieldError (Natural, Natural, Natural)
modulusDegrees q given = do
  (p, conway) <- conwayModulus q
  Right (p, degree given, degree conway)
  where
    degree coefficients = fromIntegral (max 1 (length coefficients) - 1)

-- | The order q of every named field with its p and modulus, by increasing q.
conwayModuli :: [(Natural, (Natural, [Natural]))]
conwayModuli =
  [ (p ^ (length modulus - 1), (p, modulus))
    | (p, modulus) <-
        [ fieldIndex @GF2,
          fieldIndex @GF3,
          fieldIndex @GF4,
          fieldIndex @GF5,
          fieldIndex @GF7,
          fieldIndex @GF8,
          fieldIndex @GF9,
          fieldIndex @GF11,
          fieldIndex @GF13,
          fieldIndex @GF16,
          fieldIndex @GF17,
          fieldIndex @GF19,
          fieldIndex @GF23,
          fieldIndex @GF25,
          fieldIndex @GF27,
          fieldIndex @GF29,
          fieldIndex @GF31,
          fieldIndex @GF32,
          fieldIndex @GF37,
          fieldIndex @GF41,
          fieldIndex @GF43,
          fieldIndex @GF47,
          fieldIndex @GF49,
          fieldIndex @GF53,
          fieldIndex @GF59,
          fieldIndex @GF61,
          fieldIndex @GF64,
          fieldIndex @GF67,
          fieldIndex @GF71,
          fieldIndex @GF73,
          fieldIndex @GF79,
          fieldIndex @GF81,
          fieldIndex @GF83,
          fieldIndex @GF89,
          fieldIndex @GF97,
          fieldIndex @GF101,
          fieldIndex @GF103,
          fieldIndex @GF107,
          fieldIndex @GF109,
          fieldIndex @GF113,
          fieldIndex @GF121,
          fieldIndex @GF125,
          fieldIndex @GF127,
          fieldIndex @GF128,
          fieldIndex @GF131,
          fieldIndex @GF137,
          fieldIndex @GF139,
          fieldIndex @GF149,
          fieldIndex @GF151,
          fieldIndex @GF157,
          fieldIndex @GF163,
          fieldIndex @GF167,
          fieldIndex @GF169,
          fieldIndex @GF173,
          fieldIndex @GF179,
          fieldIndex @GF181,
          fieldIndex @GF191,
          fieldIndex @GF193,
          fieldIndex @GF197,
          fieldIndex @GF199,
          fieldIndex @GF211,
          fieldIndex @GF223,
          fieldIndex @GF227,
          fieldIndex @GF229,
          fieldIndex @GF233,
          fieldIndex @GF239,
          fieldIndex @GF241,
          fieldIndex @GF243,
          fieldIndex @GF251,
          fieldIndex @GF256
        ]
  ]

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

-- | GF(11): A = 2.
type GF11 = 'Over 11 '[9, 1]

-- | GF(13): A = 2.
type GF13 = 'Over 13 '[11, 1]

-- | GF(16): A^4 = A + 1.
type GF16 = 'Over 2 '[1, 1, 0, 0, 1]

-- | GF(17): A = 3.
type GF17 = 'Over 17 '[14, 1]

-- | GF(19): A = 2.
type GF19 = 'Over 19 '[17, 1]

-- | GF(23): A = 5.
type GF23 = 'Over 23 '[18, 1]

-- | GF(25): A^2 = A + 3.
type GF25 = 'Over 5 '[2, 4, 1]

-- | GF(27): A^3 = A + 2.
type GF27 = 'Over 3 '[1, 2, 0, 1]

-- | GF(29): A = 2.
type GF29 = 'Over 29 '[27, 1]

-- | GF(31): A = 3.
type GF31 = 'Over 31 '[28, 1]

-- | GF(32): A^5 = A^2 + 1.
type GF32 = 'Over 2 '[1, 0, 1, 0, 0, 1]

-- | GF(37): A = 2.
type GF37 = 'Over 37 '[35, 1]

-- | GF(41): A = 6.
type GF41 = 'Over 41 '[35, 1]

-- | GF(43): A = 3.
type GF43 = 'Over 43 '[40, 1]

-- | GF(47): A = 5.
type GF47 = 'Over 47 '[42, 1]

-- | GF(49): A^2 = A + 4.
type GF49 = 'Over 7 '[3, 6, 1]

-- | GF(53): A = 2.
type GF53 = 'Over 53 '[51, 1]

-- | GF(59): A = 2.
type GF59 = 'Over 59 '[57, 1]

-- | GF(61): A = 2.
type GF61 = 'Over 61 '[59, 1]

-- | GF(64): A^6 = A^4 + A^3 + A + 1.
type GF64 = 'Over 2 '[1, 1, 0, 1, 1, 0, 1]

-- | GF(67): A = 2.
type GF67 = 'Over 67 '[65, 1]

-- | GF(71): A = 7.
type GF71 = 'Over 71 '[64, 1]

-- | GF(73): A = 5.
type GF73 = 'Over 73 '[68, 1]

-- | GF(79): A = 3.
type GF79 = 'Over 79 '[76, 1]

-- | GF(81): A^4 = A^3 + 1.
type GF81 = 'Over 3 '[2, 0, 0, 2, 1]

-- | GF(83): A = 2.
type GF83 = 'Over 83 '[81, 1]

-- | GF(89): A = 3.
type GF89 = 'Over 89 '[86, 1]

-- | GF(97): A = 5.
type GF97 = 'Over 97 '[92, 1]

-- | GF(101): A = 2.
type GF101 = 'Over 101 '[99, 1]

-- | GF(103): A = 5.
type GF103 = 'Over 103 '[98, 1]

-- | GF(107): A = 2.
type GF107 = 'Over 107 '[105, 1]

-- | GF(109): A = 6.
type GF109 = 'Over 109 '[103, 1]

-- | GF(113): A = 3.
type GF113 = 'Over 113 '[110, 1]

-- | GF(121): A^2 = 4A + 9.
type GF121 = 'Over 11 '[2, 7, 1]

-- | GF(125): A^3 = 2A + 2.
type GF125 = 'Over 5 '[3, 3, 0, 1]

-- | GF(127): A = 3.
type GF127 = 'Over 127 '[124, 1]

-- | GF(128): A^7 = A + 1.
type GF128 = 'Over 2 '[1, 1, 0, 0, 0, 0, 0, 1]

-- | GF(131): A = 2.
type GF131 = 'Over 131 '[129, 1]

-- | GF(137): A = 3.
type GF137 = 'Over 137 '[134, 1]

-- | GF(139): A = 2.
type GF139 = 'Over 139 '[137, 1]

-- | GF(149): A = 2.
type GF149 = 'Over 149 '[147, 1]

-- | GF(151): A = 6.
type GF151 = 'Over 151 '[145, 1]

-- | GF(157): A = 5.
type GF157 = 'Over 157 '[152, 1]

-- | GF(163): A = 2.
type GF163 = 'Over 163 '[161, 1]

-- | GF(167): A = 5.
type GF167 = 'Over 167 '[162, 1]

-- | GF(169): A^2 = A + 11.
type GF169 = 'Over 13 '[2, 12, 1]

-- | GF(173): A = 2.
type GF173 = 'Over 173 '[171, 1]

-- | GF(179): A = 2.
type GF179 = 'Over 179 '[177, 1]

-- | GF(181): A = 2.
type GF181 = 'Over 181 '[179, 1]

-- | GF(191): A = 19.
type GF191 = 'Over 191 '[172, 1]

-- | GF(193): A = 5.
type GF193 = 'Over 193 '[188, 1]

-- | GF(197): A = 2.
type GF197 = 'Over 197 '[195, 1]

-- | GF(199): A = 3.
type GF199 = 'Over 199 '[196, 1]

-- | GF(211): A = 2.
type GF211 = 'Over 211 '[209, 1]

-- | GF(223): A = 3.
type GF223 = 'Over 223 '[220, 1]

-- | GF(227): A = 2.
type GF227 = 'Over 227 '[225, 1]

-- | GF(229): A = 6.
type GF229 = 'Over 229 '[223, 1]

-- | GF(233): A = 3.
type GF233 = 'Over 233 '[230, 1]

-- | GF(239): A = 7.
type GF239 = 'Over 239 '[232, 1]

-- | GF(241): A = 7.
type GF241 = 'Over 241 '[234, 1]

-- | GF(243): A^5 = A + 2.
type GF243 = 'Over 3 '[1, 2, 0, 0, 0, 1]

-- | GF(251): A = 6.
type GF251 = 'Over 251 '[245, 1]

-- | GF(256): A^8 = A^4 + A^3 + A^2 + 1.
type GF256 = 'Over 2 '[1, 0, 1, 1, 1, 0, 0, 0, 1]

instance NamedField GF2

instance NamedField GF3

instance NamedField GF4

instance NamedField GF5

instance NamedField GF7

instance NamedField GF8

instance NamedField GF9

instance NamedField GF11

instance NamedField GF13

instance NamedField GF16

instance NamedField GF17

instance NamedField GF19

instance NamedField GF23

instance NamedField GF25

instance NamedField GF27

instance NamedField GF29

instance NamedField GF31

instance NamedField GF32

instance NamedField GF37

instance NamedField GF41

instance NamedField GF43

instance NamedField GF47

instance NamedField GF49

instance NamedField GF53

instance NamedField GF59

instance NamedField GF61

instance NamedField GF64

instance NamedField GF67

instance NamedField GF71

instance NamedField GF73

instance NamedField GF79

instance NamedField GF81

instance NamedField GF83

instance NamedField GF89

instance NamedField GF97

instance NamedField GF101

instance NamedField GF103

instance NamedField GF107

instance NamedField GF109

instance NamedField GF113

instance NamedField GF121

instance NamedField GF125

instance NamedField GF127

instance NamedField GF128

instance NamedField GF131

instance NamedField GF137

instance NamedField GF139

instance NamedField GF149

instance NamedField GF151

instance NamedField GF157

instance NamedField GF163

instance NamedField GF167

instance NamedField GF169

instance NamedField GF173

instance NamedField GF179

instance NamedField GF181

instance NamedField GF191

instance NamedField GF193

instance NamedField GF197

instance NamedField GF199

instance NamedField GF211

instance NamedField GF223

instance NamedField GF227

instance NamedField GF229

instance NamedField GF233

instance NamedField GF239

instance NamedField GF241

instance NamedField GF243

instance NamedField GF251

instance NamedField GF256
