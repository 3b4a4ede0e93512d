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

-- | A field as one line without its line end. @add@ and @multiply@ are indexed by two codes;
-- @negate@, @inverse@ and @log@ by one (null where there is none); @powers@, those of the element
-- @primitive@, by the exponent, from 0 to q - 2. @modulus@ has the constant term first.
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

-- | The polynomials of a degree over a field, each by the codes of its coefficients, constant term
-- first; or only their number; as one line without its line end. The line is produced lazily.
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

-- | Terms of a profile's sequence as one line without its line end, given the index of the first
-- term, the number of terms, and their codes. The number is not compared with the list, which is
-- written lazily.
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
  { -- | q
    synthesisOrder :: Natural,
    -- | the modulus of GF(q), constant term first
    synthesisModulus :: [Natural],
    -- | the number of the given symbols
    synthesisSymbols :: Int,
    -- | the coefficients of the register's polynomial, constant term first
    synthesisCodes :: [Natural],
    -- | the number of stages L
    synthesisRegister :: Int,
    -- | whether the symbols determine the register: at least 2 L are given
    synthesisUnique :: Bool,
    -- | whether the polynomial is primitive; 'Nothing' if that was not decided
    synthesisPrimitive :: Maybe Bool,
    -- | the first L symbols
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
