-- | The default modulus of every field up to 256 elements, its Conway polynomial, and names for
-- some fields that are known when a program is written. @GF GF4@ is the type of the elements of
-- GF(4). Beside each name is the relation that reduces A, the modulus's root. For a field without a
-- name, use 'PraTactile.Field.withField' with its modulus.
module PraTactile.Field.Named
  ( -- * Default moduli
    conwayModulus,
    modulusDegrees,
    conwayModuli,

    -- * Fields
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

import PraTactile.Field.Conway
