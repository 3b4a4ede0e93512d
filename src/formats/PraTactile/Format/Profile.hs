{-# LANGUAGE OverloadedStrings #-}

-- | The profile as JSON: every convention by name. What is written can be read again, and is the
-- same profile.
module PraTactile.Format.Profile
  ( encodeProfile,
    decodeProfile,

    -- * As part of other texts
    profileText,
    profileValue,
    profileOf,
  )
where

import Data.Aeson (Value, encode, (.=))
import qualified Data.Aeson as Aeson
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import PraTactile.Format.Error
import PraTactile.Format.Json
import PraTactile.Format.Json.Read
import PraTactile.Format.Name
import PraTactile.Profile

-- | The name of this form of the profile.
schema :: String
schema = "pra-tactile/profile/1"

-- | The profile as one line of ASCII, without its end; equal for equal profiles.
encodeProfile :: Profile -> ByteString
encodeProfile = Lazy.toStrict . encode . profileValue

-- | The profile in a JSON text. Refuses another schema, and every key that is missing or has
-- another value than 'encodeProfile' writes; whether the profile describes an array is for
-- 'withProfile' to say.
--
-- >>> decodeProfile (encodeProfile canonicalProfile) == Right canonicalProfile
-- True
decodeProfile :: ByteString -> Either FormatError Profile
decodeProfile = decodeWith profileOf

-- | The text of 'encodeProfile', as databases and tables state the profile that they are of.
profileText :: Profile -> String
profileText = Bytes.unpack . encodeProfile

-- | The profile as a JSON object.
profileValue :: Profile -> Value
profileValue profile =
  Aeson.object
    [ "schema" .= schema,
      "q" .= naturalValue (profileOrder profile),
      "modulus" .= map naturalValue (profileModulus profile),
      "polynomial" .= map naturalValue (profilePolynomial profile),
      "reading" .= readingName (profileReading profile),
      "state" .= map naturalValue (profileState profile),
      "folding" .= foldingName (profileFolding profile),
      "shape" .= shapeValue (profileShape profile),
      "window" .= shapeValue (profileWindow profile),
      "surface" .= surfaceName (profileSurface profile),
      "packing" .= packingName (profilePacking profile)
    ]

-- | The profile that a JSON object is; refuses as 'decodeProfile' does.
profileOf :: Value -> Either FormatError Profile
profileOf value = do
  fields <- object value
  schemaIs schema fields
  Profile
    <$> field "q" natural fields
    <*> field "modulus" (listOf natural) fields
    <*> field "polynomial" (listOf natural) fields
    <*> field "reading" (named readingName) fields
    <*> field "state" (listOf natural) fields
    <*> field "folding" (named foldingName) fields
    <*> field "shape" shape fields
    <*> field "window" shape fields
    <*> field "surface" (named surfaceName) fields
    <*> field "packing" (named packingName) fields
