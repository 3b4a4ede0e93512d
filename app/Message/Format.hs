-- | Messages about JSON and census files.
module Message.Format
  ( formatMessage,
    jsonMessage,
    encodingMessage,
    notUtf8Message,
    rangeText,
    figures,
  )
where

import Counted (numberText)
import qualified Data.Aeson.Key as Key
import Data.Aeson.Types (JSONPath, JSONPathElement (..))
import Data.List (dropWhileEnd)
import qualified Data.Text as Text
import Message.Census (censusFileMessage)
import Numeric (showFFloat)
import PraTactile.Format.Error
import PraTactile.Format.Json.Strict (deepest, longestNumber)
import PraTactile.PlainText
import Visible

-- | The message about a file, given a description of the wanted file. A place in it is named as in
-- @profile.shape[1]@.
formatMessage :: FilePath -> String -> FormatError -> String
formatMessage file wanted e = case e of
  CensusFileRefused why -> censusFileMessage file why
  JsonRefused why -> notWanted (jsonMessage why)
  Misfit [] why -> notWanted (misfitMessage why)
  Misfit place why -> notWanted (placeText place ++ ": " ++ misfitMessage why)
  where
    notWanted why = file ++ " is not " ++ wanted ++ ": " ++ why

-- | The message about JSON, as a clause.
jsonMessage :: JsonError -> String
jsonMessage e = case e of
  NoText -> "it is empty"
  TooDeep -> "its brackets are nested more than " ++ show deepest ++ " deep"
  TooLong -> "it has a number of more than " ++ show longestNumber ++ " digits"
  NotUtf8 -> "it is not UTF-8 text"
  JsonInEncoding encoding -> "it" ++ encodingMessage encoding
  NotJson -> "it is not JSON"
  RepeatedKey name -> "the key " ++ quoted (Text.unpack name) ++ " is given twice"

-- | The predicate about a text in another encoding, which follows its subject.
encodingMessage :: OtherEncoding -> String
encodingMessage encoding = " is " ++ encodingName encoding ++ "; save it as UTF-8"

-- | The predicate about bytes that are no UTF-8 text, which follows their subject.
notUtf8Message :: NotUtf8Text -> String
notUtf8Message why = case why of
  InEncoding encoding -> encodingMessage encoding
  NotUtf8Text -> " is not UTF-8 text"

placeText :: JSONPath -> String
placeText place = case place of
  Key key : others -> visible (Key.toString key) ++ concatMap step others
  _ -> concatMap step place
  where
    step (Key key) = '.' : visible (Key.toString key)
    step (Index i) = "[" ++ show i ++ "]"

-- | The statement of the range of a number with this name.
rangeText :: String -> (Double, Double) -> String
rangeText name (least, most) = name ++ " is from " ++ numberText least ++ " to " ++ numberText most

-- | A positive number to this many significant figures, without trailing zeros.
--
-- >>> figures 4 0.79375
-- "0.7938"
figures :: Int -> Double -> String
figures count v = withoutZeros (showFFloat (Just places) v "")
  where
    places = max 0 (count - 1 - floor (logBase 10 v))
    withoutZeros text
      | '.' `elem` text = dropWhileEnd (== '.') (dropWhileEnd (== '0') text)
      | otherwise = text

misfitMessage :: Misfit -> String
misfitMessage misfit = case misfit of
  MissingKey key -> "the key " ++ quoted (Text.unpack key) ++ " is missing"
  NotObject -> "an object is needed"
  NotList -> "a list is needed"
  NotText -> "a text is needed"
  NotFileName -> "a file's name is needed"
  NotBool -> "true or false is needed"
  NotNatural -> "a number 0, 1, 2, ... is needed"
  NotInteger -> "a whole number is needed"
  NaturalTooLong limit -> "a number has at most " ++ show limit ++ " digits"
  NotReal -> "a number is needed"
  BeyondMillion -> "a number of at most a million is needed"
  NotPair -> "a list of two is needed"
  NotShard -> "a shard is a list of two numbers, the first of them from 1 to the second"
  NotListed -> "it does not list its presses, or its first line is cut off"
  NotOutcome -> "an outcome has one key: right or wrong, with a doubt, or refused, with a reason"
  NotShape -> "a shape is a list of two numbers, rows and columns"
  NotCell -> "a cell of the mask is a list of two numbers, row and column"
  NotPrimeWitness ->
    "a factor of a prime less 1 is a list of three numbers: prime, exponent, witness"
  NotAmong names text -> quoted text ++ " is not one of " ++ unwords names
  OtherSchema given wanted -> "its schema is " ++ quoted given ++ ", not " ++ quoted wanted
  UnknownEvidence name ->
    "the evidence's road is " ++ quoted name ++ ", not rank or enumeration"
  NotExact ->
    "an exact number is needed, such as \"127/4\" or \"31.75\", below 10^300 and of at most 400 \
    \decimal places"
  NotPoint -> "a point is a list of three exact numbers"
  NotDrawnCells -> "cells are drawn by texts of one length, of # and ."
  NotVertexName -> "a vertex is named by a text without spaces"
  NotQuarterTurn -> "one of 0, 90, 180 and 270 is needed"
  NotCalibration ->
    "offset and gain need rows of one length and number, gains above 0, and the dead elements must \
    \be among them"
  GivenTwice what -> what ++ " is given twice"
  NoFrame -> "it names no frame"
  OutOfRange what range -> rangeText what range
  OtherUnit name unit -> "the unit of " ++ name ++ " is " ++ quoted unit
  NotMatrix 1 n -> "a list of " ++ show n ++ " numbers is needed"
  NotMatrix m n -> "a list of " ++ show m ++ " lists of " ++ show n ++ " numbers is needed"
  OtherCount n -> show n ++ " is needed"
  OtherDigest -> "the digest is not that of the contents; they were changed or cut off"
  NotRotation -> "a rotation is needed: rows of length 1, at right angles, and no mirroring"
  NotAngle -> "a number from 0 up to 360 is needed, within 45 of orientation_deg"
  RegionTooLarge limit -> "a region has at most " ++ show limit ++ " taxels a side"
