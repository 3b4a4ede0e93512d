{-# LANGUAGE OverloadedStrings #-}

-- | Certificates as JSON. Every field is an integer, a name or a list of these, with sorted keys
-- and without spaces. So the text that the seal covers does not depend on the writer.
module PraTactile.Format.Certificate
  ( encodeCertificate,
    decodeCertificate,
    CertificateFile (..),
  )
where

import Data.Aeson (Object, Value (..), encode, toJSON)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Scientific (floatingOrInteger)
import PraTactile.Certificate
import PraTactile.Format.Digest
import PraTactile.Format.Error
import PraTactile.Format.Json.Canonical
import PraTactile.Format.Json.Codec
import qualified PraTactile.Format.Json.Schema as Schema
import PraTactile.Format.Profile

-- | A certificate with its seal, as one line of ASCII without its line end.
encodeCertificate :: Certificate -> ByteString
encodeCertificate certificate = canonical (KeyMap.insert "seal" (toJSON (sealOf fields)) fields)
  where
    fields = writeObject (schema *> certificateKeys) certificate

schema :: Keys r ()
schema = schemaKey "pra-tactile/certificate/1"

certificateKeys :: Keys Certificate Certificate
certificateKeys =
  Certificate
    <$> key "profile" profileCodec certificateProfile
    <*> key "mask" (listOf positionPair) certificateMask
    <*> key "windows" natural certificateWindows
    <*> key "period" natural certificatePeriod
    <*> key "factors" (listOf factor) certificateFactors
    <*> key "primes" (listOf prime) certificatePrimes
    <*> key "evidence" evidence certificateEvidence

factor :: Codec OrderFactor
factor =
  object $
    OrderFactor
      <$> key "prime" natural orderPrime
      <*> key "exponent" natural orderExponent
      <*> key "residue" (listOf natural) orderResidue

prime :: Codec PrimeProof
prime =
  object (PrimeProof <$> key "prime" natural shownPrime <*> key "factors" (listOf witness) shownBy)
  where
    witness = via (\(PrimeWitness l e a) -> [l, e, a]) three (listOf natural)
    three given = case given of
      [l, e, a] -> Right (PrimeWitness l e a)
      _ -> refuse NotPrimeWitness

evidence :: Codec Evidence
evidence = Codec Schema.Anything written $ \value -> do
  fields <- objectOf value
  way <- field "road" text fields
  case way of
    "rank" -> ByRank <$> readKeys rankKeys fields
    "enumeration" -> ByEnumeration <$> readKeys digestKey fields
    _ -> refuse (UnknownEvidence way)
  where
    written shown = case shown of
      ByRank rank -> KeyMap.insert "road" "rank" (writeObject rankKeys rank)
      ByEnumeration digest -> KeyMap.insert "road" "enumeration" (writeObject digestKey digest)
    digestKey = key "sha256" text id
    rankKeys =
      RankEvidence
        <$> key "vectors" (listOf (listOf natural)) rankVectors
        <*> key "cells" (listOf natural) rankCells
        <*> key "inverse" (listOf (listOf natural)) rankInverse

-- | The SHA-256 of all other fields.
sealOf :: Object -> String
sealOf = digestOf . canonical . KeyMap.delete "seal"

-- | The canonical text of an object. Fractions, which no certificate has, are written as the JSON
-- library writes them.
canonical :: Object -> ByteString
canonical = Lazy.toStrict . Builder.toLazyByteString . canonicalWith number . Object
  where
    number n = maybe (Builder.lazyByteString (encode (Number n))) Builder.integerDec (whole n)
    whole n = if abs n < 1e18 then either fraction Just (floatingOrInteger n) else Nothing
    fraction = const Nothing :: Double -> Maybe Integer

-- | A certificate file.
data CertificateFile = CertificateFile
  { fileCertificate :: Certificate,
    -- | whether the seal matches the fields
    fileSealed :: Bool
  }
  deriving stock (Eq, Show)

-- | Reads a certificate. Refuses another schema, missing keys and values that 'encodeCertificate'
-- does not write. It does not check the certificate; "PraTactile.Certificate.Check" does.
decodeCertificate :: ByteString -> Either FormatError CertificateFile
decodeCertificate = decodeObject $ \fields -> do
  readKeys schema fields
  stated <- field "seal" text fields
  certificate <- readKeys certificateKeys fields
  pure (CertificateFile certificate (stated == sealOf fields))
