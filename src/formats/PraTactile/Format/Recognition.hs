{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of what @decode@ answers, and of what lies at a position.
module PraTactile.Format.Recognition
  ( RecognitionReport (..),
    encodeRecognition,
    decodeSchema,

    -- * As part of other texts
    whereaboutsPairs,
  )
where

import Data.Aeson
import Data.Aeson.Types (Pair)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import PraTactile.Array (Position)
import PraTactile.Format.Json
import PraTactile.Format.Profile
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Segment (SymbolImage (..))
import PraTactile.Symmetry

-- | A recognition, and what its JSON says beside it.
data RecognitionReport = RecognitionReport
  { -- | of the array that was recognised
    reportProfile :: Profile,
    -- | the names of the composites, in their order
    reportSources :: [String],
    -- | the answer in a sentence
    reportMessage :: String,
    -- | the printed name of the element that a class stands for
    reportElement :: Int -> String,
    -- | the robot's coordinates, in millimetres, of a place on the first composite's grid
    reportRobot :: (Double, Double) -> (Double, Double),
    reportRecognition :: Recognition
  }

-- | The name of this form of an answer.
decodeSchema :: String
decodeSchema = "pra-tactile/decode/1"

-- | The answer on one line, without its end: all keys always, null where there is nothing to say.
encodeRecognition :: RecognitionReport -> ByteString
encodeRecognition report =
  Lazy.toStrict $
    encodeLine $
      "schema" .= decodeSchema
        <> "profile" .= profileValue (reportProfile report)
        <> "source" .= listToMaybe (reportSources report)
        <> "sources" .= reportSources report
        <> "outcome" .= outcome
        <> "reason" .= either (Just . refusalName) (const Nothing) answer
        <> "message" .= reportMessage report
        <> "position" .= fmap (positionValue . windowPosition) window
        <> "positions" .= map positionValue places
        <> mconcat [key .= item | (key, item) <- whereaboutsPairs (windowWhereabouts <$> window)]
        <> "robot_mm" .= fmap (reportRobot report . windowSeenAt) window
        <> "orientation_deg" .= fmap degreesOf orientation
        <> evidenceSeries evidence
        <> "symbols" .= map (symbolValue report) (recognisedSymbols recognition)
        <> "parts" .= map (partValue report) (recognisedParts recognition)
        <> "windows" .= map (windowValue report) windows
  where
    recognition = reportRecognition report
    answer = recognisedAnswer recognition
    evidence = recognisedEvidence recognition
    (outcome, orientation, window, windows, places) = case answer of
      Left _ -> ("refused" :: String, Nothing, Nothing, [], [] :: [Position])
      Right (Several o ps) -> ("ambiguous", Just o, Nothing, [], ps)
      Right (Found found) ->
        ("located", Just (foundOrientation found), Just (foundWindow found), foundWindows found, [])

-- | What the likeliest position rests on.
evidenceSeries :: Maybe Evidence -> Series
evidenceSeries evidence =
  "doubt" .= fmap evidenceDoubt evidence
    <> chanceSeries (evidence >>= evidenceChance)
    <> "agreeing" .= fmap evidenceAgreeing evidence
    <> "wrong" .= fmap (length . evidenceWrong) evidence
    <> "inconsistent_sources" .= fmap evidenceInconsistent evidence
    <> "radius" .= fmap (naturalValue . evidenceRadius) evidence
    <> "minimum_distance" .= fmap (naturalValue . evidenceDistance) evidence

symbolValue :: RecognitionReport -> ReadSymbol -> Value
symbolValue report symbol =
  object $
    placedPairs report symbol
      ++ [ "code" .= fmap snd (readClass symbol),
           "element" .= fmap (reportElement report . snd) (readClass symbol),
           "orientation_deg" .= fmap (degreesOf . fst) (readClass symbol)
         ]

partValue :: RecognitionReport -> ReadSymbol -> Value
partValue report symbol = object (placedPairs report symbol ++ ["seen" .= readSeen symbol])

-- | Where a symbol was seen, what it most likely is, and what the answer says of it.
placedPairs :: RecognitionReport -> ReadSymbol -> [Pair]
placedPairs report symbol =
  [ "source" .= readSource symbol,
    "x" .= fst (symbolCentre (readImage symbol)),
    "y" .= snd (symbolCentre (readImage symbol)),
    "likeliest"
      .= object
        [ "code" .= snd (readLikeliest symbol),
          "orientation_deg" .= degreesOf (fst (readLikeliest symbol)),
          "doubt" .= readDoubt symbol
        ],
    "position" .= fmap (positionValue . symbolCell) place,
    "expected" .= fmap symbolExpected place,
    "wrong" .= fmap ((readNumber symbol `elem`) . evidenceWrong) (recognisedEvidence recognition)
  ]
  where
    recognition = reportRecognition report
    place = case recognisedAnswer recognition of
      Right (Found found) -> Map.lookup (readNumber symbol) (foundPlaces found)
      _ -> Nothing

windowValue :: RecognitionReport -> ReadWindow -> Value
windowValue report window =
  object $
    [ "position" .= positionValue (windowPosition window),
      "cells" .= windowClasses window,
      "elements" .= map (map (fmap (reportElement report))) (windowClasses window),
      "x" .= fst (windowSeenAt window),
      "y" .= snd (windowSeenAt window)
    ]
      ++ whereaboutsPairs (Just (windowWhereabouts window))

-- | @on@, @object@, @face@, @faces@, @corner@, @corners@, @place_mm@; all null or empty where
-- nothing was located.
whereaboutsPairs :: Maybe Whereabouts -> [(Key, Value)]
whereaboutsPairs place = case place of
  Nothing -> pairsOf Null Nothing []
  Just (OnFace on) -> pairsOf (String "face") (Just on) [placeFace on]
  Just (Straddles faces) -> pairsOf (String "straddles-faces") Nothing faces
  Just OnNoObject -> pairsOf (String "no-object") Nothing []
  where
    pairsOf on face touched =
      [ ("on", on),
        ("object", maybe Null (toJSON . objectText . faceObject . placeFace) face),
        ("face", maybe Null (toJSON . vertexNames . placeFace) face),
        ("faces", toJSON (map faceValue touched)),
        ("corner", maybe Null (toJSON . fmap vertexText . corner) face),
        ("corners", toJSON (maybe [] (map vertexText . placeCorners) face)),
        ("place_mm", maybe Null (pairValue . spotMillimetres . placeCentre) face)
      ]
    faceValue face = object ["object" .= objectText (faceObject face), "face" .= vertexNames face]
    vertexNames = map vertexText . faceVertices . faceName
    pairValue (x, y) = toJSON [x, y]

degreesOf :: Symmetry -> Int
degreesOf = degreesClockwise
