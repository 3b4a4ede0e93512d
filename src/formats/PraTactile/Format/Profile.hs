{-# LANGUAGE OverloadedStrings #-}

-- | The profile as JSON: every convention by name. Reading restores the same profile.
module PraTactile.Format.Profile
  ( encodeProfile,
    decodeProfile,

    -- * Parts of other formats
    profileText,
    profileValue,
    profileCodec,
  )
where

import Data.Aeson (Value, encode)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec
import PraTactile.Format.Name
import PraTactile.Profile

-- | The profile as one line of ASCII without its line end; equal for equal profiles.
encodeProfile :: Profile -> ByteString
encodeProfile = Lazy.toStrict . encode . profileValue

-- | Reads a profile. Refuses another schema, missing keys and values that 'encodeProfile' does not
-- write. It does not check that the profile describes an array; 'withProfile' does.
--
-- >>> decodeProfile (encodeProfile canonicalProfile) == Right canonicalProfile
-- True
decodeProfile :: ByteString -> Either FormatError Profile
decodeProfile = decodeWith profileKeys

-- | The text of 'encodeProfile', by which databases and tables name their profile.
profileText :: Profile -> String
profileText = Bytes.unpack . encodeProfile

-- | The profile as a JSON object.
profileValue :: Profile -> Value
profileValue = writeValue profileCodec

-- | The profile as part of another format. Refuses what 'decodeProfile' refuses.
profileCodec :: Codec Profile
profileCodec = object profileKeys

profileKeys :: Keys Profile Profile
profileKeys =
  schemaKey "pra-tactile/profile/1"
    *> ( Profile
           <$> key "q" natural profileOrder
           <*> key "modulus" (listOf natural) profileModulus
           <*> key "polynomial" (listOf natural) profilePolynomial
           <*> key "reading" (named readingName) profileReading
           <*> key "state" (listOf natural) profileState
           <*> key "folding" (named foldingName) profileFolding
           <*> key "shape" shape profileShape
           <*> key "window" shape profileWindow
           <*> key "surface" (named surfaceName) profileSurface
           <*> key "packing" (named packingName) profilePacking
       )
