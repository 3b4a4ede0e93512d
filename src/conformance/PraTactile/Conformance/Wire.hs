{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Questions and their answers as JSON values, in the forms of the protocol. A number that counts,
-- or is a code, is a whole number written as one, or a decimal string: @2@ or @"2"@, but neither
-- @2.0@ nor @true@. What is of the right form can still be refused under a profile: a code that is
-- too large, a patch whose rows differ in length, a mask with other characters.
module PraTactile.Conformance.Wire
  ( -- * Questions
    questionInput,
    someQuestion,

    -- * Answers
    answerValue,
    leastBytes,
    readAnswer,

    -- * Numbers
    readWhole,
    readNatural,
  )
where

import Control.Monad ((>=>))
import Data.Aeson (Object, Value (..), object, toJSON, (.=))
import Data.Aeson.Key (Key)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (toList)
import Data.List (intercalate)
import qualified Data.Text as Text
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..))
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire.Network
import PraTactile.Conformance.Wire.Objects
import PraTactile.Conformance.Wire.Read
import PraTactile.Conformance.Wire.Touch
import PraTactile.Format.Json (integerValue, naturalValue, positionValue)

-- | The input of a question, as a request states it.
questionInput :: Question a -> Value
questionInput question = case question of
  Add a b -> pair a b
  Multiply a b -> pair a b
  Negate a -> one a
  Inverse a -> one a
  Power a i -> object ["a" .= naturalValue a, "exponent" .= integerValue i]
  Logarithm a -> one a
  Trace a -> one a
  Primitive codes -> object ["polynomial" .= codesValue codes]
  FirstPrimitive n -> object ["degree" .= naturalValue n]
  Term i -> object ["index" .= naturalValue i]
  Terms from count -> object ["from" .= naturalValue from, "length" .= naturalValue count]
  Cell r c -> positionValue (Position r c)
  Pack codes -> object ["cells" .= codesValue codes]
  Unpack n -> object ["packed" .= naturalValue n]
  Locate cells -> object ["patch" .= patchValue cells]
  Nearest radius cells ->
    object ["patch" .= patchValue cells, "radius" .= fmap naturalValue radius]
  Posterior chances -> object ["patch" .= map (map chanceValue) chances]
  Prove mask -> maskValue mask
  Distance mask -> maskValue mask
  Register shapes pair' -> pairValue shapes pair'
  Stitch shapes search frames -> framesValue shapes search frames
  Segment rows -> compositeValue rows
  Outputs weights rows -> outputsValue weights rows
  SolidReport it -> polyhedronValue it
  FaceCells corners pitch -> faceValue corners pitch
  Whereabouts mapped window at -> windowValue mapped window at
  FacePose felt -> feltValue felt
  Raw _ input -> input
  where
    one a = object ["a" .= naturalValue a]
    pair a b = object ["a" .= naturalValue a, "b" .= naturalValue b]
    patchValue = map (map (fmap naturalValue)) :: Patch -> [[Maybe Value]]
    maskValue mask = object ["mask" .= intercalate "/" mask]

chanceValue :: Chance -> Value
chanceValue chance = case chance of
  Unfelt -> Null
  Certainly code -> naturalValue code
  Probably chances -> toJSON chances

codesValue :: [Code] -> Value
codesValue = toJSON . map naturalValue

-- | The question that an operation and an input are; 'Nothing' if the input is not of the
-- operation's form: no object, a key missing, a value of the wrong type, a negative number where a
-- natural one stands. Further keys do not matter.
someQuestion :: Operation -> Value -> Maybe SomeQuestion
someQuestion operation input = case operation of
  OfAdd -> SomeQuestion <$> (Add <$> natural "a" <*> natural "b")
  OfMultiply -> SomeQuestion <$> (Multiply <$> natural "a" <*> natural "b")
  OfNegate -> SomeQuestion . Negate <$> natural "a"
  OfInverse -> SomeQuestion . Inverse <$> natural "a"
  OfPower -> SomeQuestion <$> (Power <$> natural "a" <*> at "exponent" readWhole)
  OfLogarithm -> SomeQuestion . Logarithm <$> natural "a"
  OfTrace -> SomeQuestion . Trace <$> natural "a"
  OfPrimitive -> SomeQuestion . Primitive <$> at "polynomial" (readItems readNatural)
  OfFirstPrimitive -> SomeQuestion . FirstPrimitive <$> natural "degree"
  OfTerm -> SomeQuestion . Term <$> natural "index"
  OfTerms -> SomeQuestion <$> (Terms <$> natural "from" <*> natural "length")
  OfCell -> SomeQuestion <$> (Cell <$> natural "row" <*> natural "column")
  OfPack -> SomeQuestion . Pack <$> at "cells" (readItems readNatural)
  OfUnpack -> SomeQuestion . Unpack <$> natural "packed"
  OfLocate -> SomeQuestion . Locate <$> patch (readNullable readNatural)
  OfNearest ->
    SomeQuestion
      <$> (Nearest <$> at "radius" (readNullable readNatural) <*> patch (readNullable readNatural))
  OfPosterior -> SomeQuestion . Posterior <$> patch readChance
  OfProve -> SomeQuestion . Prove <$> at "mask" readMask
  OfDistance -> SomeQuestion . Distance <$> at "mask" readMask
  OfRegister -> SomeQuestion . uncurry Register <$> (readObject input >>= readPair)
  OfStitch -> framesQuestion <$> (readObject input >>= readFrames)
  OfSegment -> SomeQuestion . Segment <$> (readObject input >>= readComposite)
  OfOutputs -> SomeQuestion . uncurry Outputs <$> (readObject input >>= readOutputs)
  OfSolid -> SomeQuestion . SolidReport <$> (readObject input >>= readPolyhedron)
  OfCells -> SomeQuestion . uncurry FaceCells <$> (readObject input >>= readFace)
  OfWhereabouts -> windowQuestion <$> (readObject input >>= readWindow)
  OfPose -> SomeQuestion . FacePose <$> (readObject input >>= readFelt)
  where
    framesQuestion (shapes, search, frames) = SomeQuestion (Stitch shapes search frames)
    windowQuestion (mapped, window, place) = SomeQuestion (Whereabouts mapped window place)
    at :: Key -> (Value -> Maybe a) -> Maybe a
    at name reader = readObject input >>= readKey name reader
    natural name = at name readNatural
    patch = at "patch" . readItems . readItems

readChance :: Value -> Maybe Chance
readChance value = case value of
  Null -> Just Unfelt
  Array _ -> Probably <$> readItems readReal value
  _ -> Certainly <$> readNatural value

readMask :: Value -> Maybe MaskRows
readMask value = case value of
  String drawing -> Just (map Text.unpack (Text.splitOn "/" drawing))
  _ -> Nothing

-- | The answer to a question as the protocol writes it.
answerValue :: Question a -> a -> Value
answerValue question answer = case question of
  Add _ _ -> naturalValue answer
  Multiply _ _ -> naturalValue answer
  Negate _ -> naturalValue answer
  Inverse _ -> naturalValue answer
  Power _ _ -> naturalValue answer
  Logarithm _ -> naturalValue answer
  Trace _ -> naturalValue answer
  Primitive _ -> toJSON answer
  FirstPrimitive _ -> codesValue answer
  Term _ -> naturalValue answer
  Terms _ _ -> codesValue answer
  Cell _ _ -> naturalValue answer
  Pack _ -> naturalValue answer
  Unpack _ -> codesValue answer
  Locate _ -> locationValue answer
  Nearest _ _ -> locationValue answer
  Posterior _ -> toJSON (map likely answer)
  Prove _ -> proofValue answer
  Distance _ -> naturalValue answer
  Register _ _ -> registeredValue answer
  Stitch {} -> correctionsValue answer
  Segment _ -> symbolsValue answer
  Outputs _ _ -> toJSON answer
  SolidReport _ -> reportValue answer
  FaceCells _ _ -> toJSON answer
  Whereabouts {} -> whereaboutsValue answer
  FacePose _ -> poseValue answer
  Raw _ _ -> answer
  where
    likely (Position r c, chance) = [naturalValue r, naturalValue c, toJSON chance]

-- | How many bytes any answer to a question takes as JSON, as far as the numbers in the question
-- tell.
leastBytes :: Question a -> Natural
leastBytes question = case question of
  Terms _ count -> ofDigits count
  FirstPrimitive n -> ofDigits (n + 1)
  _ -> 1
  where
    -- A digit each, with what stands before or behind it.
    ofDigits count = 2 * count + 1

locationValue :: Location -> Value
locationValue place = case place of
  At position -> object ["position" .= positionValue position]
  OneOf positions -> object ["positions" .= map positionValue positions]
  Coset count dimension ->
    object ["count" .= naturalValue count, "dimension" .= naturalValue dimension]

proofValue :: Proof -> Value
proofValue (Proof holds rank windows) =
  object
    [ "proved" .= holds,
      "rank" .= fmap naturalValue rank,
      "windows" .= naturalValue windows
    ]

-- | The answer that a value is; 'Nothing' if it is of the wrong type.
readAnswer :: Question a -> Value -> Maybe a
readAnswer question = case question of
  Add _ _ -> readNatural
  Multiply _ _ -> readNatural
  Negate _ -> readNatural
  Inverse _ -> readNatural
  Power _ _ -> readNatural
  Logarithm _ -> readNatural
  Trace _ -> readNatural
  Primitive _ -> readBool
  FirstPrimitive _ -> readItems readNatural
  Term _ -> readNatural
  Terms _ _ -> readItems readNatural
  Cell _ _ -> readNatural
  Pack _ -> readNatural
  Unpack _ -> readItems readNatural
  Locate _ -> readObject >=> readLocation
  Nearest _ _ -> readObject >=> readLocation
  Posterior _ -> readItems readLikely
  Prove _ -> readObject >=> readProof
  Distance _ -> readNatural
  Register _ _ -> readObject >=> readRegistered
  Stitch {} -> readObject >=> readCorrections
  Segment _ -> readObject >=> readSymbols
  Outputs _ _ -> readItems readReal
  SolidReport _ -> readObject >=> readReport
  FaceCells _ _ -> readCells
  Whereabouts {} -> readObject >=> readWhereabouts
  FacePose _ -> readPose
  Raw _ _ -> Just

-- | By the one key that says which of the three it is.
readLocation :: Object -> Maybe Location
readLocation fields = case filter (`KeyMap.member` fields) ["position", "positions", "count"] of
  ["position"] -> At <$> readKey "position" readPosition fields
  ["positions"] -> OneOf <$> readKey "positions" (readItems readPosition) fields
  ["count"] -> Coset <$> readKey "count" readNatural fields <*> dimension
  _ -> Nothing
  where
    dimension = readKey "dimension" readNatural fields

readPosition :: Value -> Maybe Position
readPosition value = do
  fields <- readObject value
  Position <$> readKey "row" readNatural fields <*> readKey "column" readNatural fields

readProof :: Object -> Maybe Proof
readProof fields =
  Proof
    <$> readKey "proved" readBool fields
    <*> readKey "rank" (readNullable readNatural) fields
    <*> readKey "windows" readNatural fields

readLikely :: Value -> Maybe (Position, Double)
readLikely value = case value of
  Array parts | [r, c, chance] <- toList parts -> do
    position <- Position <$> readNatural r <*> readNatural c
    (,) position <$> readReal chance
  _ -> Nothing
