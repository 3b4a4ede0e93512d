{-# LANGUAGE OverloadedStrings #-}

-- | Certificates as JSON. Every field is an integer, a name or a list of such, so that the text
-- over which the seal is taken is the same whoever writes it: keys sorted, no spaces.
module PraTactile.Format.Certificate
  ( encodeCertificate,
    decodeCertificate,
    CertificateFile (..),
  )
where

import Data.Aeson (Object, Value (..), encode, toJSON, (.=))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.List (intersperse, sortOn)
import Data.Scientific (floatingOrInteger)
import PraTactile.Array (Position (..))
import PraTactile.Certificate
import PraTactile.Format.Digest
import PraTactile.Format.Error
import PraTactile.Format.Json
import PraTactile.Format.Json.Read
import PraTactile.Format.Profile

-- | The name of this form of a certificate.
schema :: String
schema = "pra-tactile/certificate/1"

-- | A certificate with its seal, on one line of ASCII, without its end.
encodeCertificate :: Certificate -> ByteString
encodeCertificate certificate = canonical (KeyMap.insert "seal" (toJSON (sealOf fields)) fields)
  where
    fields =
      KeyMap.fromList
        [ "schema" .= schema,
          "profile" .= profileValue (certificateProfile certificate),
          "mask" .= map positionListValue (certificateMask certificate),
          "windows" .= naturalValue (certificateWindows certificate),
          "period" .= naturalValue (certificatePeriod certificate),
          "factors" .= map factorValue (certificateFactors certificate),
          "primes" .= map primeValue (certificatePrimes certificate),
          "evidence" .= evidenceValue (certificateEvidence certificate)
        ]

factorValue :: OrderFactor -> Value
factorValue (OrderFactor l e residue) =
  Aeson.object
    ["prime" .= naturalValue l, "exponent" .= naturalValue e, "residue" .= map naturalValue residue]

primeValue :: PrimeProof -> Value
primeValue (PrimeProof p witnesses) =
  Aeson.object
    [ "prime" .= naturalValue p,
      "factors" .= [map naturalValue [l, e, a] | PrimeWitness l e a <- witnesses]
    ]

evidenceValue :: Evidence -> Value
evidenceValue evidence = case evidence of
  ByRank (RankEvidence vectors cells inverted) ->
    Aeson.object
      [ "road" .= ("rank" :: String),
        "vectors" .= map (map naturalValue) vectors,
        "cells" .= map naturalValue cells,
        "inverse" .= map (map naturalValue) inverted
      ]
  ByEnumeration digest -> Aeson.object ["road" .= ("enumeration" :: String), "sha256" .= digest]

-- | The SHA-256 of all other fields.
sealOf :: Object -> String
sealOf = digestOf . canonical . KeyMap.delete "seal"

-- | The one text of an object: keys sorted, no spaces.
canonical :: Object -> ByteString
canonical = Lazy.toStrict . Builder.toLazyByteString . canonicalValue . Object

-- | Numbers that are no integers, which no certificate has, are written as the JSON library writes
-- them.
canonicalValue :: Value -> Builder
canonicalValue value = case value of
  Object fields -> "{" <> commas (map pair (sorted fields)) <> "}"
  Array values -> "[" <> commas (map canonicalValue (toList values)) <> "]"
  Number n | Just i <- whole n -> Builder.integerDec i
  other -> Builder.lazyByteString (encode other)
  where
    pair (key, v) = quoted key <> ":" <> canonicalValue v
    commas = mconcat . intersperse ","
    sorted fields = sortOn fst [(Key.toText k, v) | (k, v) <- KeyMap.toList fields]
    whole n = if abs n < 1e18 then either fraction Just (floatingOrInteger n) else Nothing
    fraction = const Nothing :: Double -> Maybe Integer
    quoted = Builder.lazyByteString . encode . String

-- | A certificate as it was read.
data CertificateFile = CertificateFile
  { fileCertificate :: Certificate,
    -- | whether its seal is that of its fields
    fileSealed :: Bool
  }
  deriving stock (Eq, Show)

-- | The certificate in a JSON text. Refuses another schema, and every key that is missing or has
-- another value than 'encodeCertificate' writes; whether the certificate is good is for
-- "PraTactile.Certificate.Check" to say.
decodeCertificate :: ByteString -> Either FormatError CertificateFile
decodeCertificate = decodeWith $ \value -> do
  fields <- object value
  schemaIs schema fields
  stated <- field "seal" text fields
  certificate <-
    Certificate
      <$> field "profile" profileOf fields
      <*> field "mask" (listOf cell) fields
      <*> field "windows" natural fields
      <*> field "period" natural fields
      <*> field "factors" (listOf factor) fields
      <*> field "primes" (listOf prime) fields
      <*> field "evidence" evidenceOf fields
  pure (CertificateFile certificate (stated == sealOf fields))

cell :: Decoder Position
cell value =
  listOf natural value >>= \given -> case given of
    [r, c] -> Right (Position r c)
    _ -> refuse NotCell

factor :: Decoder OrderFactor
factor value = do
  fields <- object value
  OrderFactor
    <$> field "prime" natural fields
    <*> field "exponent" natural fields
    <*> field "residue" (listOf natural) fields

prime :: Decoder PrimeProof
prime value = do
  fields <- object value
  PrimeProof <$> field "prime" natural fields <*> field "factors" (listOf witness) fields
  where
    witness values =
      listOf natural values >>= \given -> case given of
        [l, e, a] -> Right (PrimeWitness l e a)
        _ -> refuse NotPrimeWitness

evidenceOf :: Decoder Evidence
evidenceOf value = do
  fields <- object value
  road <- field "road" text fields
  case road of
    "rank" ->
      fmap ByRank $
        RankEvidence
          <$> field "vectors" (listOf (listOf natural)) fields
          <*> field "cells" (listOf natural) fields
          <*> field "inverse" (listOf (listOf natural)) fields
    "enumeration" -> ByEnumeration <$> field "sha256" text fields
    _ -> refuse (UnknownEvidence road)
