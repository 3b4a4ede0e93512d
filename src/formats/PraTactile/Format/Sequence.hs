{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of fields, polynomials, sequences and arrays: codes throughout.
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

-- | A field, on one line, without its end: lists are indexed by codes, lists of lists by two.
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

-- | Which polynomials.
data PolynomialKind = PrimitiveOnes | IrreducibleOnes
  deriving stock (Eq, Show)

-- | How many polynomials of a degree over a field there are, or these, on one line, without its
-- end; made as the list is.
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

-- | The rows of the array of a profile, on one line, without its end.
encodeArray :: Profile -> [[Int]] -> Lazy.ByteString
encodeArray profile codes =
  encodeLine $
    "schema" .= ("pra-tactile/array/1" :: String)
      <> "profile" .= profileValue profile
      <> "rows" .= codes

-- | Terms of the sequence of a profile, from this index on, this many, on one line, without its
-- end; made as the list is.
encodeTerms :: Profile -> Integer -> Natural -> [Int] -> Lazy.ByteString
encodeTerms profile from count codes =
  encodeLine $
    "schema" .= ("pra-tactile/sequence/1" :: String)
      <> "profile" .= profileValue profile
      <> "from" .= integerValue from
      <> "length" .= naturalValue count
      <> "terms" .= codes

-- | The shortest shift register that puts out some symbols.
data SynthesisReport = SynthesisReport
  { synthesisOrder :: Natural,
    synthesisModulus :: [Natural],
    synthesisSymbols :: Int,
    synthesisCodes :: [Natural],
    synthesisRegister :: Int,
    synthesisUnique :: Bool,
    -- | 'Nothing' where it was not decided
    synthesisPrimitive :: Maybe Bool,
    synthesisState :: [Natural]
  }

-- | The register on one line, without its end.
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
