{-# OPTIONS_HADDOCK hide #-}

-- | JSON in a canonical form: keys in order, no white space, numbers without exponents; so that
-- equal inputs have equal digests whoever computes them.
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

-- | A value in its canonical form. Whole numbers are written as such, others in decimal; 1.0, which
-- is not 1 here, keeps its fraction.
canonical :: Value -> Builder
canonical = canonicalWith $ \n ->
  if base10Exponent n == 0
    then Builder.integerDec (coefficient n)
    else Builder.string7 (formatScientific Fixed Nothing n)

-- | 12 hexadecimal digits of the SHA-256 of an operation, a profile or null, and an input: of the
-- canonical form of an object with these three keys.
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
