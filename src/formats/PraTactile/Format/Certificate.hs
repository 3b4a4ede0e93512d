{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Certificates as JSON. Every field is an integer, a name or a list of such, so that the text
-- over which the seal is taken is the same whoever writes it: keys sorted, no spaces.
module PraTactile.Format.Certificate
  ( encodeCertificate
  , decodeCertificate
  , CertificateFile (..)
  ) where

import Data.Aeson
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
    fields = KeyMap.fromList
      [ "schema" .= schema
      , "profile" .= profileValue (certificateProfile certificate)
      , "mask" .= map positionListValue (certificateMask certificate)
      , "windows" .= naturalValue (certificateWindows certificate)
      , "period" .= naturalValue (certificatePeriod certificate)
      , "factors" .= map factorValue (certificateFactors certificate)
      , "primes" .= map primeValue (certificatePrimes certificate)
      , "evidence" .= evidenceValue (certificateEvidence certificate)
      ]

factorValue :: OrderFactor -> Value
factorValue (OrderFactor l e residue) = object
  ["prime" .= naturalValue l, "exponent" .= naturalValue e, "residue" .= map naturalValue residue]

primeValue :: PrimeProof -> Value
primeValue (PrimeProof p witnesses) = object
  [ "prime" .= naturalValue p
  , "factors" .= [ map naturalValue [l, e, a] | PrimeWitness l e a <- witnesses ]
  ]

evidenceValue :: Evidence -> Value
evidenceValue evidence = case evidence of
  ByRank (RankEvidence vectors cells inverted) -> object
    [ "road" .= ("rank" :: String)
    , "vectors" .= map (map naturalValue) vectors
    , "cells" .= map naturalValue cells
    , "inverse" .= map (map naturalValue) inverted
    ]
  ByEnumeration digest -> object ["road" .= ("enumeration" :: String), "sha256" .= digest]

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
    pair (key, v) = text key <> ":" <> canonicalValue v
    commas = mconcat . intersperse ","
    sorted fields = sortOn fst [ (Key.toText k, v) | (k, v) <- KeyMap.toList fields ]
    whole n = if abs n < 1e18 then either fraction Just (floatingOrInteger n) else Nothing
    fraction = const Nothing :: Double -> Maybe Integer
    text = Builder.lazyByteString . encode . String

-- | A certificate as it was read.
data CertificateFile = CertificateFile
  { fileCertificate :: Certificate
  , fileSealed :: Bool
    -- ^ whether its seal is that of its fields
  }
  deriving stock (Eq, Show)

-- | The certificate in a JSON text. Refuses another schema, and every key that is missing or has
-- another value than 'encodeCertificate' writes; whether the certificate is good is for
-- "PraTactile.Certificate.Check" to say.
decodeCertificate :: ByteString -> Either FormatError CertificateFile
decodeCertificate = decodeAs $ \value -> do
  o <- objectAs "certificate" value
  hasSchema schema o
  stated <- field o "seal"
  certificate <- Certificate
    <$> part o "profile" profileOf
    <*> part o "mask" (each cell)
    <*> part o "windows" natural
    <*> part o "period" natural
    <*> part o "factors" (each factor)
    <*> part o "primes" (each prime)
    <*> part o "evidence" evidenceOf
  pure (CertificateFile certificate (stated == sealOf o))

cell :: [Value] -> Either FormatError Position
cell values = case values of
  [r, c] -> Position <$> natural r <*> natural c
  _ -> Left (Misfit [] NotCell)

factor :: Value -> Either FormatError OrderFactor
factor value = do
  o <- objectAs "factor" value
  OrderFactor <$> part o "prime" natural <*> part o "exponent" natural <*> part o "residue" naturals

prime :: Value -> Either FormatError PrimeProof
prime value = do
  o <- objectAs "prime" value
  PrimeProof <$> part o "prime" natural <*> part o "factors" (each witness)
  where
    witness values = case values of
      [l, e, a] -> PrimeWitness <$> natural l <*> natural e <*> natural a
      _ -> Left (Misfit [] NotPrimeWitness)

evidenceOf :: Value -> Either FormatError Evidence
evidenceOf value = do
  o <- objectAs "evidence" value
  reader <- part o "road" $ \name ->
    maybe (Left (Misfit [] (UnknownEvidence name))) Right (lookup name readers)
  reader o
  where
    readers = [("rank", fmap ByRank . byRank), ("enumeration", fmap ByEnumeration . byDigest)]
    byRank o = RankEvidence <$> part o "vectors" (each naturals) <*> part o "cells" naturals
      <*> part o "inverse" (each naturals)
    byDigest o = field o "sha256"
