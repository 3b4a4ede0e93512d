{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of @decode@.
module PraTactile.Format.Recognition
  ( -- * The JSON
    RecognitionReport (..),
    SymbolReport (..),
    Sighting (..),
    WindowReport (..),
    encodeRecognition,
    decodeRecognition,
    decodeSchema,

    -- * From a recognition
    RecognitionContext (..),
    recognitionReport,
  )
where

import Data.ByteString (ByteString)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array (Position)
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec
import PraTactile.Format.Object
import PraTactile.Format.Outcome
import PraTactile.Format.Pose
import PraTactile.Format.Profile
import PraTactile.Locate (Chance, Checks, Known (..), atLeast)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Symmetry

-- | The keys of @decode@'s JSON. docs/reference/json.md explains them.
data RecognitionReport = RecognitionReport
  { reportProfile :: Profile,
    reportSources :: [String],
    reportOutcome :: OutcomeName,
    reportReason :: Maybe String,
    reportMessage :: String,
    reportPosition :: Maybe Position,
    reportPositions :: [Position],
    reportWhereabouts :: WhereaboutsReport,
    reportRobot :: Maybe (Double, Double),
    -- | standard deviation, taxels
    reportPositionError :: Maybe Double,
    -- | quarter turns clockwise
    reportOrientation :: Maybe Int,
    -- | degrees clockwise, in [0, 360)
    reportAngle :: Maybe Double,
    reportDoubt :: Maybe Double,
    -- | the components of the doubt
    reportDoubts :: Maybe Doubts,
    reportChance :: Maybe Chance,
    reportChecks :: Maybe Checks,
    reportAgreeing :: Maybe Int,
    reportWrong :: Maybe Int,
    reportInconsistent :: Maybe [Int],
    reportRadius :: Maybe Natural,
    reportMinimumDistance :: Maybe Natural,
    -- | whether the minimum distance is exact, if known
    reportMinimumExact :: Maybe Bool,
    reportSymbols :: [SymbolReport (Maybe (Int, String, Int))],
    -- | with the share of the symbol that was touched
    reportParts :: [SymbolReport Double],
    reportWindows :: [WindowReport],
    -- | if one face was located
    reportPose :: Maybe ObjectPose
  }
  deriving stock (Eq, Show)

-- | A symbol with more keys. For a complete symbol these are its code, element and quarter turns,
-- if it was recognised.
data SymbolReport more = SymbolReport Sighting more
  deriving stock (Eq, Show)

-- | A symbol's place, its most likely class, and the comparison with the answer.
data Sighting = Sighting
  { -- | the composite, counted from 0, and the pixel
    sightedIn :: Int,
    sightedAt :: (Double, Double),
    -- | the direction of its x axis, in degrees clockwise from the composite's, up to half turns
    sightedAxis :: Double,
    -- | code, quarter turns and doubt
    sightedLikeliest :: (Int, Int, Double),
    -- | the probability that it is none of the shapes
    sightedNone :: Double,
    sightedPosition :: Maybe Position,
    sightedExpected :: Maybe Int,
    sightedWrong :: Maybe Bool
  }
  deriving stock (Eq, Show)

-- | A window. Its cells are given as codes and as elements, row by row.
data WindowReport = WindowReport
  { windowReportPosition :: Position,
    windowReportCells :: [[Maybe Int]],
    windowReportElements :: [[Maybe String]],
    windowReportAt :: (Double, Double),
    windowReportWhereabouts :: WhereaboutsReport
  }
  deriving stock (Eq, Show)

-- | The schema name of this format.
decodeSchema :: String
decodeSchema = "pra-tactile/decode/1"

-- | The answer as one line without its line end. All keys are always there; null means no value.
encodeRecognition :: RecognitionReport -> ByteString
encodeRecognition = writeLine reportKeys

-- | Reads the JSON of 'encodeRecognition'. Refuses another schema, missing keys and invalid
-- values.
decodeRecognition :: ByteString -> Either FormatError RecognitionReport
decodeRecognition = decodeWith reportKeys

reportKeys :: Keys RecognitionReport RecognitionReport
reportKeys =
  schemaKey decodeSchema
    *> ( RecognitionReport
           <$> key "profile" profileCodec reportProfile
           <* key "source" (nullable text) (listToMaybe . reportSources)
           <*> key "sources" (listOf text) reportSources
           <*> key "outcome" outcomeCodec reportOutcome
           <*> key "reason" (nullable text) reportReason
           <*> key "message" text reportMessage
           <*> key "position" (nullable position) reportPosition
           <*> key "positions" (listOf position) reportPositions
           <*> withKeys reportWhereabouts whereaboutsKeys
           <*> key "robot_mm" (nullable (pairOf real)) reportRobot
           <*> key "position_error_taxels" (nullable real) reportPositionError
           <*> key "orientation_deg" (nullable quarterTurn) reportOrientation
           <*> key "angle_deg" (nullable real) reportAngle
           <*> key "doubt" (nullable real) reportDoubt
           <*> key "doubts" (nullable (object doubtsKeys)) reportDoubts
           <*> withKeys reportChance chanceKeys
           <*> key "checks" checksCodec reportChecks
           <*> key "agreeing" (nullable int) reportAgreeing
           <*> key "wrong" (nullable int) reportWrong
           <*> key "inconsistent_sources" (nullable (listOf int)) reportInconsistent
           <*> key "radius" (nullable natural) reportRadius
           <*> key "minimum_distance" (nullable natural) reportMinimumDistance
           <*> optionalKey "minimum_distance_is" (exactOr "at-least") reportMinimumExact
           <*> key "symbols" (listOf (symbol classKeys)) reportSymbols
           <*> key "parts" (listOf (symbol (key "seen" real id))) reportParts
           <*> key "windows" (listOf (object windowKeys)) reportWindows
           <*> key "pose" (nullable namedPoseCodec) reportPose
       )

doubtsKeys :: Keys Doubts Doubts
doubtsKeys =
  Doubts
    <$> key "position" real doubtOfPosition
    <*> key "stitching" real doubtOfStitching
    <*> key "axes" real doubtOfAxes
    <*> key "slip" real doubtOfSlip
    <*> withKeys doubtsOfOrigin ofOrigin
  where
    ofOrigin =
      (\doubts shapes -> doubts {doubtOfOtherShapes = shapes})
        <$> foreignKeys
        <*> key "other_shapes" real doubtOfOtherShapes

symbol :: Keys more more -> Codec (SymbolReport more)
symbol keys =
  object
    ( SymbolReport
        <$> withKeys (\(SymbolReport seen _) -> seen) sightingKeys
        <*> withKeys (\(SymbolReport _ more) -> more) keys
    )

classKeys :: Keys (Maybe (Int, String, Int)) (Maybe (Int, String, Int))
classKeys =
  (\code element turns -> (,,) <$> code <*> element <*> turns)
    <$> key "code" (nullable int) (fmap (\(code, _, _) -> code))
    <*> key "element" (nullable text) (fmap (\(_, element, _) -> element))
    <*> key "orientation_deg" (nullable quarterTurn) (fmap (\(_, _, turns) -> turns))

sightingKeys :: Keys Sighting Sighting
sightingKeys =
  Sighting
    <$> key "source" int sightedIn
    <*> withKeys sightedAt pointKeys
    <*> key "axis_deg" real sightedAxis
    <*> key "likeliest" (object likeliestKeys) sightedLikeliest
    <*> key "none" real sightedNone
    <*> key "position" (nullable position) sightedPosition
    <*> key "expected" (nullable int) sightedExpected
    <*> key "wrong" (nullable bool) sightedWrong
  where
    likeliestKeys =
      (,,)
        <$> key "code" int (\(code, _, _) -> code)
        <*> key "orientation_deg" quarterTurn (\(_, turns, _) -> turns)
        <*> key "doubt" real (\(_, _, doubt) -> doubt)

windowKeys :: Keys WindowReport WindowReport
windowKeys =
  WindowReport
    <$> key "position" position windowReportPosition
    <*> key "cells" (listOf (listOf (nullable int))) windowReportCells
    <*> key "elements" (listOf (listOf (nullable text))) windowReportElements
    <*> withKeys windowReportAt pointKeys
    <*> withKeys windowReportWhereabouts whereaboutsKeys

pointKeys :: Keys (Double, Double) (Double, Double)
pointKeys = (,) <$> key "x" real fst <*> key "y" real snd

-- | The context of a recognition and the wording of its answer.
data RecognitionContext = RecognitionContext
  { -- | the profile of the array
    contextProfile :: Profile,
    -- | the names of the composites, in their order
    contextNames :: [String],
    -- | the answer in a sentence
    contextMessage :: String,
    -- | the printed name of the element that a class stands for
    contextElement :: Int -> String,
    -- | converts a place on the first composite's grid to the robot's coordinates, in millimetres
    contextRobot :: (Double, Double) -> (Double, Double),
    -- | the standard deviation of the robot's position error, in taxels, if it was estimated from
    -- the frames
    contextPositionError :: Maybe Double,
    -- | the object's pose, if one face was located
    contextPose :: Maybe ObjectPose
  }

-- | The report of a recognition.
recognitionReport :: RecognitionContext -> Recognition -> RecognitionReport
recognitionReport context recognition =
  RecognitionReport
    { reportProfile = contextProfile context,
      reportSources = contextNames context,
      reportOutcome = outcome,
      reportReason = either (Just . refusalName) (const Nothing) answer,
      reportMessage = contextMessage context,
      reportPosition = windowPosition <$> window,
      reportPositions = places,
      reportWhereabouts = whereaboutsReport (windowWhereabouts <$> window),
      reportRobot = contextRobot context . windowSeenAt <$> window,
      reportPositionError = contextPositionError context,
      reportOrientation = quarterTurns <$> orientation,
      reportAngle = recognisedAngle recognition <$> orientation,
      reportDoubt = supportDoubt <$> support,
      reportDoubts = supportDoubts <$> support,
      reportChance = support >>= supportChance,
      reportChecks = support >>= supportChecks,
      reportAgreeing = supportAgreeing <$> support,
      reportWrong = length . supportWrong <$> support,
      reportInconsistent = supportInconsistent <$> support,
      reportRadius = supportRadius <$> support,
      reportMinimumDistance = atLeast . supportDistance <$> support,
      reportMinimumExact = listToMaybe [False | Just (AtLeast _) <- [supportDistance <$> support]],
      reportSymbols = reported (fmap classOf . readClass) recognisedSymbols,
      reportParts = reported readSeen recognisedParts,
      reportWindows = map (windowReport (contextElement context)) windows,
      reportPose = contextPose context
    }
  where
    answer = recognisedAnswer recognition
    support = recognisedSupport recognition
    (outcome, orientation, window, windows, places) = case answer of
      Left _ -> (NoAnswer, Nothing, Nothing, [], [])
      Right (Several o several) -> (SeveralFit, Just o, Nothing, [], several)
      Right (Found found) ->
        (Located, Just (foundOrientation found), Just (foundWindow found), foundWindows found, [])
    reported more part = [SymbolReport (sighting recognition s) (more s) | s <- part recognition]
    classOf (o, c) = (c, contextElement context c, quarterTurns o)

sighting :: Recognition -> ReadSymbol -> Sighting
sighting recognition seen =
  Sighting
    { sightedIn = readSource seen,
      sightedAt = symbolCentre (readImage seen),
      sightedAxis = symbolAxis (readImage seen),
      sightedLikeliest = (likeliest, quarterTurns orientation, readDoubt seen),
      sightedNone = readForeignProbability seen,
      sightedPosition = symbolCell <$> place,
      sightedExpected = symbolExpected <$> place,
      sightedWrong = (readNumber seen `elem`) . supportWrong <$> recognisedSupport recognition
    }
  where
    (orientation, likeliest) = readLikeliest seen
    place = case recognisedAnswer recognition of
      Right (Found found) -> Map.lookup (readNumber seen) (foundPlaces found)
      _ -> Nothing

windowReport :: (Int -> String) -> ReadWindow -> WindowReport
windowReport nameOf window =
  WindowReport
    { windowReportPosition = windowPosition window,
      windowReportCells = windowClasses window,
      windowReportElements = map (map (fmap nameOf)) (windowClasses window),
      windowReportAt = windowSeenAt window,
      windowReportWhereabouts = whereaboutsReport (Just (windowWhereabouts window))
    }
