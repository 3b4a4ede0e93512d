{-# LANGUAGE OverloadedStrings #-}
-- | The profile as JSON: every convention by name. What is written can be read again, and is the same profile.
module Json.Profile
  ( profileValue
  , profileText
  , readProfile
    -- * Parsers
  , parseProfile
  , number
  ) where

import Control.Monad (unless)
import Data.Aeson
import Data.Aeson.Types (Parser, parseEither)
import Data.Bifunctor (first)
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Char (isDigit)
import Data.Scientific (Scientific, floatingOrInteger)
import qualified Data.Text as Text
import Numeric.Natural (Natural)

import Ending
import Files (readBytes)
import Json
import JsonInput
import Message (profileMessage)
import PraTactile.Array (Folding (..), Shape (..), Surface (..))
import PraTactile.Profile
import PraTactile.Window (Packing (..))

-- | The name of this form of the profile.
schema :: String
schema = "pra-tactile/profile/1"

-- | The profile as a JSON object.
profileValue :: Profile -> Value
profileValue profile = object
  [ "schema" .= schema
  , "q" .= naturalValue (profileOrder profile)
  , "modulus" .= map naturalValue (profileModulus profile)
  , "polynomial" .= map naturalValue (profilePolynomial profile)
  , "reading" .= readingName (profileReading profile)
  , "state" .= map naturalValue (profileState profile)
  , "folding" .= foldingName (profileFolding profile)
  , "shape" .= shapeValue (profileShape profile)
  , "window" .= shapeValue (profileWindow profile)
  , "surface" .= surfaceName (profileSurface profile)
  , "packing" .= packingName (profilePacking profile)
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
  bytes <- readBytes file
  profile <- orUnusable inWords (first jsonFaultMessage (readJson bytes) >>= parseEither parseProfile)
  orUnusable (\e -> file ++ ": " ++ profileMessage e) (withProfile profile (\_ _ -> ()))
  pure profile
  where
    inWords why = file ++ " is not a profile as 'pra-tactile profile' prints it: " ++ why

parseProfile :: Value -> Parser Profile
parseProfile = withObject "profile" $ \o -> do
  form <- o .: "schema"
  unless (form == schema) (fail ("its schema is " ++ show form ++ ", not " ++ show schema))
  Profile
    <$> (o .: "q" >>= number)
    <*> (o .: "modulus" >>= traverse number)
    <*> (o .: "polynomial" >>= traverse number)
    <*> (o .: "reading" >>= named "reading" readingName [Characteristic, Reciprocal])
    <*> (o .: "state" >>= traverse number)
    <*> (o .: "folding" >>= named "folding" foldingName [Diagonal, RowMajor])
    <*> (o .: "shape" >>= shape)
    <*> (o .: "window" >>= shape)
    <*> (o .: "surface" >>= named "surface" surfaceName [Torus, TwistedTorus, Sheet])
    <*> (o .: "packing" >>= named "packing" packingName [MostSignificantFirst, LeastSignificantFirst])
  where
    shape value = case value of
      [high, wide] -> Shape <$> number high <*> number wide
      _ -> fail "a shape is a list of two numbers, rows and columns"
    named what name choices text = case [ c | c <- choices, name c == text ] of
      c : _ -> pure c
      [] -> fail (what ++ " is " ++ show text ++ ", not one of " ++ unwords (map name choices))

-- | A natural number, as a JSON number or a decimal string.
number :: Value -> Parser Natural
number value = case value of
  Number n | Right i <- whole n, i >= 0 -> pure (fromInteger i)
  String digits | text <- Text.unpack digits, not (null text), all isDigit text -> pure (read text)
  _ -> fail "a number 0, 1, 2, ... is needed"
  where
    whole :: Scientific -> Either Double Integer
    whole n = if abs n < 1e18 then floatingOrInteger n else Left 0
