{-# LANGUAGE OverloadedStrings #-}
-- | Certificates as JSON. Every field is an integer, a name or a list of such, so that the text over which the seal is
-- taken is the same whoever writes it: keys sorted, no spaces.
module Json.Certificate
  ( certificateText
  , readCertificate
  , CertificateFile (..)
  ) where

import Control.Monad (unless)
import Data.Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (Parser, parseEither)
import Data.Bifunctor (first)
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (toList)
import Data.List (intercalate, sortOn)
import Data.Scientific (floatingOrInteger)
import Numeric.Natural (Natural)

import Ending
import Files (readBytes)
import Json
import JsonInput
import Json.Profile
import PraTactile.Array (Position (..))
import PraTactile.Certificate
import PraTactile.Certificate.Digest (sha256OfText)

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
          [ object ["prime" .= naturalValue l, "exponent" .= naturalValue e, "residue" .= map naturalValue r]
          | OrderFactor l e r <- certificateFactors certificate ]
      , "primes" .=
          [ object ["prime" .= naturalValue p, "factors" .= [ map naturalValue [l, e, a] | PrimeWitness l e a <- witnesses ]]
          | PrimeProof p witnesses <- certificatePrimes certificate ]
      , "evidence" .= evidenceValue (certificateEvidence certificate)
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
sealOf = sha256OfText . canonical . Object . KeyMap.delete "seal"

-- | The one text of a value: keys sorted, no spaces. Numbers that are no integers, which no certificate has, are
-- written as they are.
canonical :: Value -> String
canonical value = case value of
  Object fields -> "{" ++ commas [ text (Key.toText k) ++ ":" ++ canonical v | (k, v) <- sortOn fst (KeyMap.toList fields) ] ++ "}"
  Array values -> "[" ++ commas (map canonical (toList values)) ++ "]"
  Number n | Just i <- whole n -> show i
  other -> Lazy8.unpack (encode other)
  where
    commas = intercalate ","
    whole n = if abs n < 1e18 then either (const Nothing :: Double -> Maybe Integer) Just (floatingOrInteger n) else Nothing
    text = Lazy8.unpack . encode . String

-- | A certificate as it was read, and whether its seal is unbroken.
data CertificateFile = CertificateFile
  { fileCertificate :: Certificate
  , fileSealed :: Bool
  }

-- | The certificate in a file; leaves with status 2 and the reason where there is none.
readCertificate :: FilePath -> IO CertificateFile
readCertificate file = do
  bytes <- readBytes file
  orUnusable inWords (first jsonFaultMessage (readJson bytes) >>= parseEither parseFile)
  where
    inWords why = file ++ " is not a certificate as 'pra-tactile certificate' writes it: " ++ why

parseFile :: Value -> Parser CertificateFile
parseFile = withObject "certificate" $ \o -> do
  form <- o .: "schema"
  unless (form == schema) (fail ("its schema is " ++ show form ++ ", not " ++ show schema))
  seal <- o .: "seal"
  certificate <- Certificate
    <$> (o .: "profile" >>= parseProfile)
    <*> (o .: "mask" >>= traverse position)
    <*> (o .: "windows" >>= number)
    <*> (o .: "period" >>= number)
    <*> (o .: "factors" >>= traverse parseFactor)
    <*> (o .: "primes" >>= traverse parsePrime)
    <*> (o .: "evidence" >>= parseEvidence)
  pure (CertificateFile certificate (seal == sealOf o))
  where
    position cell = case cell of
      [r, c] -> Position <$> number r <*> number c
      _ -> fail "a cell of the mask is a list of two numbers, row and column"

parseFactor :: Value -> Parser OrderFactor
parseFactor = withObject "factor" $ \o ->
  OrderFactor <$> (o .: "prime" >>= number) <*> (o .: "exponent" >>= number) <*> (o .: "residue" >>= numbers)

parsePrime :: Value -> Parser PrimeProof
parsePrime = withObject "prime" $ \o -> PrimeProof <$> (o .: "prime" >>= number) <*> (o .: "factors" >>= traverse witness)
  where
    witness values = case values of
      [l, e, a] -> PrimeWitness <$> number l <*> number e <*> number a
      _ -> fail "a factor of a prime less 1 is a list of three numbers: prime, exponent, witness"

parseEvidence :: Value -> Parser Evidence
parseEvidence = withObject "evidence" $ \o -> do
  road <- o .: "road"
  case road :: String of
    "rank" -> fmap ByRank (RankEvidence <$> (o .: "vectors" >>= traverse numbers) <*> (o .: "cells" >>= numbers) <*> (o .: "inverse" >>= traverse numbers))
    "enumeration" -> ByEnumeration <$> o .: "sha256"
    _ -> fail ("the evidence's road is " ++ show road ++ ", not rank or enumeration")

numbers :: [Value] -> Parser [Natural]
numbers = traverse number
