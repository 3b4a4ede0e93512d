-- |
-- Names for the fields of every order up to 256: @GF GF4@ is the type of the elements
-- of GF(4). The modulus is the Conway polynomial; what stands beside a name is the
-- relation by which A, the modulus's root, is reduced.
module PraTactile.Field.Named
  ( -- * Default moduli
    conwayModulus
  , modulusDegrees
  , conwayModuli

    -- * Fields
  , GF2
  , GF3
  , GF4
  , GF5
  , GF7
  , GF8
  , GF9
  , GF11
  , GF13
  , GF16
  , GF17
  , GF19
  , GF23
  , GF25
  , GF27
  , GF29
  , GF31
  , GF32
  , GF37
  , GF41
  , GF43
  , GF47
  , GF49
  , GF53
  , GF59
  , GF61
  , GF64
  , GF67
  , GF71
  , GF73
  , GF79
  , GF81
  , GF83
  , GF89
  , GF97
  , GF101
  , GF103
  , GF107
  , GF109
  , GF113
  , GF121
  , GF125
  , GF127
  , GF128
  , GF131
  , GF137
  , GF139
  , GF149
  , GF151
  , GF157
  , GF163
  , GF167
  , GF169
  , GF173
  , GF179
  , GF181
  , GF191
  , GF193
  , GF197
  , GF199
  , GF211
  , GF223
  , GF227
  , GF229
  , GF233
  , GF239
  , GF241
  , GF243
  , GF251
  , GF256
  ) where

import PraTactile.Field.Conway
