-- | The default modulus of every field up to 256 elements, the Conway polynomial; and names for the
-- fields that are known when a program is written: @GF GF4@ is the type of the elements of GF(4).
-- What stands beside a name is the relation by which A, the modulus's root, is reduced. A field
-- without a name is 'PraTactile.Field.withField' of its modulus.
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
