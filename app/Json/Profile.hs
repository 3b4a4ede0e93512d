{-# LANGUAGE OverloadedStrings #-}
-- | The profile as JSON: every convention by name. What is written can be read again, and is the same profile.
module Json.Profile
  ( profileValue
  , profileText
  , readProfile
    -- * Decoders
  , decodeProfile
  , profileDecoder
  ) where

import Data.Aeson (Value, encode, (.=))
import qualified Data.Aeson as Aeson
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy8

import Ending
import Files (readBytesUpTo)
import Json
import Json.Decode
import Message (profileMessage)
import PraTactile.Array (Folding (..), Shape (..), Surface (..))
import PraTactile.Profile
import PraTactile.Window (Packing (..))

-- | The name of this form of the profile.
schema :: String
schema = "pra-tactile/profile/1"

-- | The profile as a JSON object.
profileValue :: Profile -> Value
profileValue given = Aeson.object
  [ "schema" .= schema
  , "q" .= naturalValue (profileOrder given)
  , "modulus" .= map naturalValue (profileModulus given)
  , "polynomial" .= map naturalValue (profilePolynomial given)
  , "reading" .= readingName (profileReading given)
  , "state" .= map naturalValue (profileState given)
  , "folding" .= foldingName (profileFolding given)
  , "shape" .= shapeValue (profileShape given)
  , "window" .= shapeValue (profileWindow given)
  , "surface" .= surfaceName (profileSurface given)
  , "packing" .= packingName (profilePacking given)
  ]
  where
    shapeValue (Shape high wide) = [naturalValue high, naturalValue wide]

-- | The profile as one line of text, equal for equal profiles.
profileText :: Profile -> String
profileText = Lazy8.unpack . encode . profileValue

readingName :: Reading -> String
readingName reading = case reading of
  Characteristic -> "characteristic"
  Reciprocal -> "reciprocal"

packingName :: Packing -> String
packingName packing = case packing of
  MostSignificantFirst -> "most-significant-first"
  LeastSignificantFirst -> "least-significant-first"

-- | The profile in a file; leaves with status 2 and the reason where there is none, or where it names no array.
readProfile :: FilePath -> IO Profile
readProfile file = do
  bytes <- readBytesUpTo (1 * 1024 * 1024) file
  found <- orUnusable inWords (decodeProfile bytes)
  found <$ orUnusable (\e -> file ++ ": " ++ profileMessage e) (withProfile found (\_ _ -> ()))
  where
    inWords why = file ++ " is not a profile as 'pra-tactile profile' prints it: " ++ why

-- | The profile that a text is; 'Left' says why it is none. That there is such an array is not checked.
decodeProfile :: ByteString -> Either String Profile
decodeProfile = decodeWith profileDecoder

-- | The profile that a value is.
profileDecoder :: Decoder Profile
profileDecoder value = do
  fields <- object value
  schemaIs schema fields
  Profile
    <$> field "q" number fields
    <*> field "modulus" (listOf number) fields
    <*> field "polynomial" (listOf number) fields
    <*> field "reading" (named readingName [Characteristic, Reciprocal]) fields
    <*> field "state" (listOf number) fields
    <*> field "folding" (named foldingName [Diagonal, RowMajor]) fields
    <*> field "shape" shape fields
    <*> field "window" shape fields
    <*> field "surface" (named surfaceName [Torus, TwistedTorus, Sheet]) fields
    <*> field "packing" (named packingName [MostSignificantFirst, LeastSignificantFirst]) fields
  where
    shape sides = listOf number sides >>= \given -> case given of
      [high, wide] -> Right (Shape high wide)
      _ -> refuse "a shape is a list of two numbers, rows and columns"
