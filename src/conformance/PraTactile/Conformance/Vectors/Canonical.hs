{-# OPTIONS_HADDOCK hide #-}

-- | JSON in a canonical form (sorted keys, no white space, no exponents), so that equal inputs
-- have equal digests.
module PraTactile.Conformance.Vectors.Canonical
  ( canonical,
    identifier,
  )
where

import Data.Aeson (Value (..), toJSON)
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Scientific (FPFormat (..), base10Exponent, coefficient, formatScientific)
import PraTactile.Conformance.Operations (nameOf)
import PraTactile.Conformance.Question
import PraTactile.Format.Digest (digestOf)
import PraTactile.Format.Json.Canonical
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile (Profile)

-- | A value in canonical form. Integers are written without a fraction, other numbers in decimal.
-- 1.0, which differs from 1 here, keeps its fraction.
canonical :: Value -> Builder
canonical = canonicalWith $ \n ->
  if base10Exponent n == 0
    then Builder.integerDec (coefficient n)
    else Builder.string7 (formatScientific Fixed Nothing n)

-- | 12 hexadecimal digits of the SHA-256 of the canonical object of an operation, a profile (or
-- null) and an input.
identifier :: SomeOp -> Maybe Profile -> Value -> String
identifier operation profile input =
  take 12 (digestOf (Lazy.toStrict (Builder.toLazyByteString text)))
  where
    text = canonical (Object (KeyMap.fromList parts))
    parts =
      [ (Key.fromString "operation", toJSON (nameOf operation)),
        (Key.fromString "profile", maybe Null profileValue profile),
        (Key.fromString "input", input)
      ]
