{-# LANGUAGE OverloadedStrings #-}
-- | Certificates as JSON. Every field is an integer, a name or a list of such, so that the text over which the seal is
-- taken is the same whoever writes it: keys sorted, no spaces.
module Json.Certificate
  ( certificateText
  , readCertificate
  , decodeCertificate
  , CertificateFile (..)
  ) where

import Data.Aeson (Value (..), encode, toJSON, (.=))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (toList)
import Data.List (intercalate, sortOn)
import Data.Scientific (floatingOrInteger)

import Ending
import Files (readBytesUpTo)
import Json
import Json.Decode
import Json.Profile
import PraTactile.Array (Position (..))
import PraTactile.Certificate
import PraTactile.Certificate.Digest (sha256OfText)
import Visible

-- | The name of this form of a certificate.
schema :: String
schema = "pra-tactile/certificate/1"

-- | A certificate with its seal, on one line.
certificateText :: Certificate -> String
certificateText certificate = canonical (Object (KeyMap.insert "seal" (toJSON (sealOf fields)) fields)) ++ "\n"
  where
    fields = KeyMap.fromList
      [ "schema" .= schema
      , "profile" .= profileValue (certificateProfile certificate)
      , "mask" .= map positionListValue (certificateMask certificate)
      , "windows" .= naturalValue (certificateWindows certificate)
      , "period" .= naturalValue (certificatePeriod certificate)
      , "factors" .=
          [ Aeson.object ["prime" .= naturalValue l, "exponent" .= naturalValue e, "residue" .= map naturalValue r]
          | OrderFactor l e r <- certificateFactors certificate ]
      , "primes" .=
          [ Aeson.object ["prime" .= naturalValue p, "factors" .= [ map naturalValue [l, e, a] | PrimeWitness l e a <- witnesses ]]
          | PrimeProof p witnesses <- certificatePrimes certificate ]
      , "evidence" .= evidenceValue (certificateEvidence certificate)
      ]

evidenceValue :: Evidence -> Value
evidenceValue given = case given of
  ByRank (RankEvidence vectors cells inverted) -> Aeson.object
    [ "road" .= ("rank" :: String)
    , "vectors" .= map (map naturalValue) vectors
    , "cells" .= map naturalValue cells
    , "inverse" .= map (map naturalValue) inverted
    ]
  ByEnumeration digest -> Aeson.object ["road" .= ("enumeration" :: String), "sha256" .= digest]

-- | The SHA-256 of all other fields.
sealOf :: Fields -> String
sealOf = sha256OfText . canonical . Object . KeyMap.delete "seal"

-- | The one text of a value: keys sorted, no spaces. Numbers that are no integers, which no certificate has, are
-- written as they are.
canonical :: Value -> String
canonical value = case value of
  Object fields -> "{" ++ commas [ quotedText (Key.toText k) ++ ":" ++ canonical v | (k, v) <- sortOn fst (KeyMap.toList fields) ] ++ "}"
  Array values -> "[" ++ commas (map canonical (toList values)) ++ "]"
  Number n | Just i <- whole n -> show i
  other -> Lazy8.unpack (encode other)
  where
    commas = intercalate ","
    whole n = if abs n < 1e18 then either (const Nothing :: Double -> Maybe Integer) Just (floatingOrInteger n) else Nothing
    quotedText = Lazy8.unpack . encode . String

-- | A certificate as it was read, and whether its seal is unbroken.
data CertificateFile = CertificateFile
  { fileCertificate :: Certificate
  , fileSealed :: Bool
  }

-- | The certificate in a file; leaves with status 2 and the reason where there is none.
readCertificate :: FilePath -> IO CertificateFile
readCertificate file = do
  -- A window has at most 4096 cells; JSON in memory takes up to seventy times its size on disk.
  bytes <- readBytesUpTo (4 * 1024 * 1024) file
  orUnusable inWords (decodeCertificate bytes)
  where
    inWords why = file ++ " is not a certificate as 'pra-tactile certificate' writes it: " ++ why

-- | The certificate that a text is; 'Left' says why it is none. Whether it is good is for
-- "PraTactile.Certificate.Check" to say.
decodeCertificate :: ByteString -> Either String CertificateFile
decodeCertificate = decodeWith certificateFile

certificateFile :: Decoder CertificateFile
certificateFile value = do
  fields <- object value
  schemaIs schema fields
  told <- field "seal" text fields
  certificate <- Certificate
    <$> field "profile" profileDecoder fields
    <*> field "mask" (listOf position) fields
    <*> field "windows" number fields
    <*> field "period" number fields
    <*> field "factors" (listOf factor) fields
    <*> field "primes" (listOf prime) fields
    <*> field "evidence" evidence fields
  pure (CertificateFile certificate (told == sealOf fields))
  where
    position cell = listOf number cell >>= \given -> case given of
      [r, c] -> Right (Position r c)
      _ -> refuse "a cell of the mask is a list of two numbers, row and column"

factor :: Decoder OrderFactor
factor value = object value >>= \fields ->
  OrderFactor
    <$> field "prime" number fields
    <*> field "exponent" number fields
    <*> field "residue" (listOf number) fields

prime :: Decoder PrimeProof
prime value = object value >>= \fields ->
  PrimeProof <$> field "prime" number fields <*> field "factors" (listOf witness) fields
  where
    witness values = listOf number values >>= \given -> case given of
      [l, e, a] -> Right (PrimeWitness l e a)
      _ -> refuse "a factor of a prime less 1 is a list of three numbers: prime, exponent, witness"

evidence :: Decoder Evidence
evidence value = do
  fields <- object value
  road <- field "road" text fields
  case road of
    "rank" -> fmap ByRank $ RankEvidence
      <$> field "vectors" (listOf (listOf number)) fields
      <*> field "cells" (listOf number) fields
      <*> field "inverse" (listOf (listOf number)) fields
    "enumeration" -> ByEnumeration <$> field "sha256" text fields
    _ -> refuse ("the evidence's road is " ++ quoted road ++ ", not rank or enumeration")
