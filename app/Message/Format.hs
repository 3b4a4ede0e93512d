-- | What is wrong with JSON and census files, in words.
module Message.Format
  ( formatMessage
  , repeatedKeyMessage
  ) where

import qualified Data.Aeson.Key as Key
import Data.Aeson.Types (JSONPath, JSONPathElement (..))
import Data.Text (Text)
import qualified Data.Text as Text

import Message.Census (censusFileMessage)
import PraTactile.Format.Error

-- | Of a file, and what it should be.
formatMessage :: FilePath -> String -> FormatError -> String
formatMessage file wanted e = case e of
  CensusFileRefused why -> censusFileMessage file why
  NotJson why -> notWanted why
  RepeatedKey name -> notWanted (repeatedKeyMessage name)
  Misfit _ (OtherType why) -> notWanted why
  Misfit place misfit -> notWanted ("Error in $: " ++ misfitMessage place misfit)
  where
    notWanted why = file ++ " is not " ++ wanted ++ ": " ++ unwords (lines why)

-- | Of a key that an object has twice.
repeatedKeyMessage :: Text -> String
repeatedKeyMessage name = "the key " ++ show (Text.unpack name) ++ " is given twice"

misfitMessage :: JSONPath -> Misfit -> String
misfitMessage place misfit = case misfit of
  OtherType why -> why
  OtherSchema form expected -> "its schema is " ++ show form ++ ", not " ++ show expected
  NotNatural -> "a number 0, 1, 2, ... is needed"
  NotShape -> "a shape is a list of two numbers, rows and columns"
  NotCell -> "a cell of the mask is a list of two numbers, row and column"
  NotPrimeWitness ->
    "a factor of a prime less 1 is a list of three numbers: prime, exponent, witness"
  NotAmong names text -> key ++ " is " ++ show text ++ ", not one of " ++ unwords names
  UnknownEvidence name -> "the evidence's road is " ++ show name ++ ", not rank or enumeration"
  NotQuarterTurn -> "orientation_deg is no quarter turn"
  where
    key = concat (take 1 [ Key.toString name | Key name <- reverse place ])
