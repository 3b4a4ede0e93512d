{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of fields, polynomials, sequences and arrays. Elements are codes.
module PraTactile.Format.Sequence
  ( encodeField,
    PolynomialKind (..),
    encodePolynomials,
    encodeArray,
    encodeTerms,
    SynthesisReport (..),
    encodeSynthesis,
  )
where

import Data.Aeson ((.=))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Proxy (Proxy)
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Structure (exponential)
import PraTactile.Format.Json
import PraTactile.Format.Profile
import PraTactile.Profile (Profile)

-- | A field as one line without its line end. Lists are indexed by one code, lists of lists by
-- two.
encodeField :: forall k. KnownField k => Proxy k -> ByteString
encodeField k =
  encodeSchema "field/1" $
    "q" .= fieldOrder k
      <> "p" .= fieldCharacteristic k
      <> "degree" .= fieldDegree k
      <> "modulus" .= map naturalValue (fieldModulus k)
      <> "primitive" .= toCode (primitive :: GF k)
      <> "add" .= [[toCode (a + b) | b <- everything] | a <- everything]
      <> "multiply" .= [[toCode (a * b) | b <- everything] | a <- everything]
      <> "negate" .= map (toCode . negate) everything
      <> "inverse" .= map (either (const Nothing) (Just . toCode) . inverse) everything
      <> "powers" .= [toCode (exponential e :: GF k) | e <- [0 .. toInteger (fieldOrder k) - 2]]
      <> "log" .= map logarithm everything
  where
    everything = elements :: [GF k]

-- | Which polynomials are listed.
data PolynomialKind = PrimitiveOnes | IrreducibleOnes
  deriving stock (Eq, Show)

-- | The polynomials of a degree over a field, or only their number, as one line without its line
-- end. The line is produced lazily.
encodePolynomials ::
  KnownField k =>
  Proxy k ->
  Natural ->
  PolynomialKind ->
  Either Natural [[Int]] ->
  Lazy.ByteString
encodePolynomials k degree kind found =
  encodeLine $
    "schema" .= ("pra-tactile/polynomials/1" :: String)
      <> "q" .= fieldOrder k
      <> "modulus" .= map naturalValue (fieldModulus k)
      <> "degree" .= degree
      <> "kind" .= kindName
      <> either (\count -> "count" .= naturalValue count) ("polynomials" .=) found
  where
    kindName = case kind of
      PrimitiveOnes -> "primitive" :: String
      IrreducibleOnes -> "irreducible"

-- | The rows of a profile's array, as one line without its line end.
encodeArray :: Profile -> [[Int]] -> Lazy.ByteString
encodeArray profile codes =
  encodeLine $
    "schema" .= ("pra-tactile/array/1" :: String)
      <> "profile" .= profileValue profile
      <> "rows" .= codes

-- | The terms of a profile's sequence, from an index on and of a given number, as one line without
-- its line end. The line is produced lazily.
encodeTerms :: Profile -> Integer -> Natural -> [Int] -> Lazy.ByteString
encodeTerms profile from count codes =
  encodeLine $
    "schema" .= ("pra-tactile/sequence/1" :: String)
      <> "profile" .= profileValue profile
      <> "from" .= integerValue from
      <> "length" .= naturalValue count
      <> "terms" .= codes

-- | The shortest shift register that produces the given symbols.
data SynthesisReport = SynthesisReport
  { synthesisOrder :: Natural,
    synthesisModulus :: [Natural],
    synthesisSymbols :: Int,
    synthesisCodes :: [Natural],
    synthesisRegister :: Int,
    synthesisUnique :: Bool,
    -- | 'Nothing' if it was not decided
    synthesisPrimitive :: Maybe Bool,
    synthesisState :: [Natural]
  }

-- | The register as one line, without its line end.
encodeSynthesis :: SynthesisReport -> ByteString
encodeSynthesis found =
  encodeSchema "synthesise/1" $
    "q" .= naturalValue (synthesisOrder found)
      <> "modulus" .= map naturalValue (synthesisModulus found)
      <> "symbols" .= synthesisSymbols found
      <> "polynomial" .= map naturalValue (synthesisCodes found)
      <> "length" .= synthesisRegister found
      <> "determined" .= synthesisUnique found
      <> "primitive" .= synthesisPrimitive found
      <> "state" .= map naturalValue (synthesisState found)
