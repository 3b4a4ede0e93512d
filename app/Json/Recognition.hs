{-# LANGUAGE OverloadedStrings #-}
-- | The JSON of @decode@ and of look-ups of a position.
module Json.Recognition
  ( recognitionJson
  , whereaboutsPairs
  ) where

import Data.Aeson
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)

import Json
import Json.Profile
import PraTactile.Array (Position)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Segment (SymbolImage (..))
import Recognised
import Visible

-- | One answer: all keys always, null where there is nothing to say. Takes the robot's coordinates of a place on the first composite's grid.
recognitionJson :: Profile -> [FilePath] -> (Int -> String) -> ((Double, Double) -> (Double, Double)) -> Recognition -> Series
recognitionJson profile paths nameOf robotAt recognition =
  "schema" .= ("pra-tactile/decode/1" :: String)
    <> "profile" .= profileValue profile
    <> "source" .= listToMaybe names
    <> "sources" .= names
    <> "outcome" .= outcome
    <> "reason" .= either (Just . refusalName) (const Nothing) answer
    <> "message" .= recognitionMessage recognition
    <> "position" .= fmap (positionValue . windowPosition) window
    <> "positions" .= map positionValue places
    <> mconcat [ key .= item | (key, item) <- whereaboutsPairs (windowWhereabouts <$> window) ]
    <> "robot_mm" .= fmap (robotAt . windowSeenAt) window
    <> "orientation_deg" .= fmap orientationDegrees orientation
    <> "doubt" .= fmap evidenceDoubt evidence
    <> chanceSeries (evidence >>= evidenceChance)
    <> "agreeing" .= fmap evidenceAgreeing evidence
    <> "wrong" .= fmap (length . evidenceWrong) evidence
    <> "inconsistent_sources" .= fmap evidenceInconsistent evidence
    <> "radius" .= fmap (naturalValue . evidenceRadius) evidence
    <> "minimum_distance" .= fmap (naturalValue . evidenceDistance) evidence
    <> "symbols" .= map symbolValue (recognisedSymbols recognition)
    <> "parts" .= map partValue (recognisedParts recognition)
    <> "windows" .= map windowValue windows
  where
    names = map nameInJson paths
    answer = recognisedAnswer recognition
    evidence = recognisedEvidence recognition
    (outcome, orientation, window, windows, places, cells) = case answer of
      Left _ -> ("refused" :: String, Nothing, Nothing, [], [] :: [Position], mempty)
      Right (Several o ps) -> ("ambiguous", Just o, Nothing, [], ps, mempty)
      Right (Found found) -> ("located", Just (foundOrientation found), Just (foundWindow found), foundWindows found, [], foundPlaces found)
    symbolValue symbol = object (placedPairs symbol ++
      [ "code" .= fmap snd (readClass symbol)
      , "element" .= fmap (nameOf . snd) (readClass symbol)
      , "orientation_deg" .= fmap (orientationDegrees . fst) (readClass symbol)
      ])
    partValue part = object (placedPairs part ++ [ "seen" .= readSeen part ])
    placedPairs symbol =
      [ "source" .= readSource symbol
      , "x" .= fst (symbolCentre (readImage symbol))
      , "y" .= snd (symbolCentre (readImage symbol))
      , "likeliest" .= object
          [ "code" .= snd (readLikeliest symbol), "orientation_deg" .= orientationDegrees (fst (readLikeliest symbol)), "doubt" .= readDoubt symbol ]
      , "position" .= fmap (positionValue . symbolCell) (Map.lookup (readNumber symbol) cells)
      , "expected" .= fmap symbolExpected (Map.lookup (readNumber symbol) cells)
      , "wrong" .= fmap ((readNumber symbol `elem`) . evidenceWrong) evidence
      ]
    windowValue w = object $
      [ "position" .= positionValue (windowPosition w)
      , "cells" .= windowClasses w
      , "elements" .= map (map (fmap nameOf)) (windowClasses w)
      , "x" .= fst (windowSeenAt w)
      , "y" .= snd (windowSeenAt w)
      ] ++ [ key .= item | (key, item) <- whereaboutsPairs (Just (windowWhereabouts w)) ]

-- | @on@, @object@, @face@, @faces@, @corner@, @corners@, @place_mm@; all null or empty where nothing was located.
whereaboutsPairs :: Maybe Whereabouts -> [(Key, Value)]
whereaboutsPairs place = case place of
  Nothing -> pairsOf Null Nothing []
  Just (OnFace on) -> pairsOf (String "face") (Just on) [placeFace on]
  Just (Straddles faces) -> pairsOf (String "straddles-faces") Nothing faces
  Just OnNoObject -> pairsOf (String "no-object") Nothing []
  where
    pairsOf on face touched =
      [ ("on", on)
      , ("object", maybe Null (toJSON . objectText . faceObject . placeFace) face)
      , ("face", maybe Null (toJSON . vertexNames . placeFace) face)
      , ("faces", toJSON [ object ["object" .= objectText (faceObject f), "face" .= vertexNames f] | f <- touched ])
      , ("corner", maybe Null (toJSON . fmap vertexText . corner) face)
      , ("corners", toJSON (maybe [] (map vertexText . placeCorners) face))
      , ("place_mm", maybe Null (pairValue . spotMillimetres . placeCentre) face)
      ]
    vertexNames = map vertexText . faceVertices . faceName
    pairValue (x, y) = toJSON [x, y]
