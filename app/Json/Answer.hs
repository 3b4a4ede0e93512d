{-# LANGUAGE OverloadedStrings #-}

-- | What @locate@ answers, as JSON.
module Json.Answer
  ( answerJson,
    invalidJson,
  )
where

import AnswerText
import Data.Aeson
import Data.Aeson.Types (Pair)
import Data.List (nub, sort)
import Json
import Message
import Numeric.Natural (Natural)
import PraTactile.Format.Profile
import PraTactile.Locate
import PraTactile.Position
import PraTactile.Profile (Profile)
import PraTactile.Symmetry

-- | An answer, given the displacements of the patches and the sentences that explain it, if they
-- are wanted.
answerJson :: Profile -> Asked -> [(Integer, Integer)] -> Maybe [String] -> Answer -> Series
answerJson profile asked displacements explained answer =
  located <> "road" .= decoderText (answerDecoder answer) <> counted (answerOutcome answer)
    <> maybe mempty (distancesSeries (answerDecoder answer)) (answerDistances answer)
    <> maybe mempty (posteriorSeries asked) (answerPosterior answer)
    <> (if upright asked then mempty else orientationSeries asked answer)
    <> (if askedDisplaced asked then patchesSeries displacements answer else mempty)
    <> maybe mempty ("explanation" .=) explained
  where
    located = case answerOutcome answer of
      Unique candidate windows ->
        form "located" (Just (candidatePosition candidate)) [] Nothing ("located: " ++ told) windows
      Ambiguous candidates windows ->
        form
          "ambiguous"
          Nothing
          (nub (sort (map candidatePosition candidates)))
          Nothing
          told
          (if windowsTold then windows else [])
      AmbiguousMany _ _ -> form "ambiguous" Nothing [] Nothing told []
      Refused reason ->
        form "refused" Nothing [] (Just (reasonName reason)) (reasonMessage reason) []
    told = answerText asked answer
    form = outcomeSeries profile (answerChance answer)
    -- Which windows are complete says nothing where it is not known how the patch lies, or which
    -- cells are in dispute.
    windowsTold =
      upright asked && not (askedDisplaced asked && answerDecoder answer == NearestDecoder)

-- | The answer to what is no patch.
invalidJson :: Profile -> String -> Series
invalidJson profile complaint =
  outcomeSeries profile Nothing "invalid" Nothing [] (Just "bad-input") complaint []

outcomeSeries ::
  Profile ->
  Maybe Chance ->
  String ->
  Maybe Position ->
  [Position] ->
  Maybe String ->
  String ->
  [Position] ->
  Series
outcomeSeries profile worth outcome place places reason message windows =
  "schema" .= ("pra-tactile/locate/1" :: String)
    <> "profile" .= profileValue profile
    <> "outcome" .= outcome
    <> "position" .= fmap positionValue place
    <> "positions" .= map positionValue places
    <> "reason" .= reason
    <> "message" .= message
    <> "windows" .= map (toJSON . positionListValue) windows
    <> chanceSeries worth

-- | How many candidates; each position counts in each orientation.
counted :: Outcome Candidate -> Series
counted outcome = case outcome of
  Unique _ _ -> "count" .= (1 :: Int)
  Ambiguous candidates _ -> "count" .= length candidates
  AmbiguousMany count dimension ->
    "count" .= naturalValue count <> maybe mempty (("dimension" .=) . naturalValue) dimension
  Refused _ -> "count" .= (0 :: Int)

-- | In how many cells candidates differ; nothing of a decoder that corrects nothing.
distancesSeries :: DecoderName -> Distances -> Series
distancesSeries decoder distances = case decoder of
  NearestDecoder -> differing <> least <> "radius" .= radius
  InformationSetDecoder ->
    differing
      <> "runner_up_at_least" .= maybeNumber (atLeast <$> runnerUpDistance distances)
      <> least
      <> "minimum_distance_is"
        .= (case codeDistance distances of Exactly _ -> "exact"; AtLeast _ -> "at-least" :: String)
      <> "radius" .= radius
  _ -> mempty
  where
    differing =
      "corrected" .= map positionListValue (corrected distances)
        <> "nearest" .= maybeNumber (nearestDistance distances >>= exactly)
        <> "runner_up" .= maybeNumber (runnerUpDistance distances >>= exactly)
    least = "minimum_distance" .= naturalValue (atLeast (codeDistance distances))
    radius = naturalValue (correctionRadius distances)
    exactly known = case known of
      Exactly n -> Just n
      AtLeast _ -> Nothing

maybeNumber :: Maybe Natural -> Value
maybeNumber = maybe Null naturalValue

-- | How likely the first five candidates are.
posteriorSeries :: Asked -> Posterior Candidate -> Series
posteriorSeries asked found = case posteriorUnlisted found of
  Nothing -> doubt <> likeliestFive
  Just unlisted ->
    doubt <> "doubt_is" .= ("at-most" :: String) <> likeliestFive <> "unlisted" .= unlisted
  where
    doubt = "doubt" .= posteriorDoubt found
    likeliestFive =
      "likeliest"
        .= [ object (("probability" .= probability) : candidateFields asked candidate)
             | (candidate, probability) <- take 5 (posteriorRanking found)
           ]

orientationSeries :: Asked -> Answer -> Series
orientationSeries asked answer = case candidatesOf answer of
  [Candidate o _] ->
    "orientation_deg" .= degreesOf o <> "mirrored" .= mirrored o <> "candidates" .= ([] :: [Value])
  several ->
    "orientation_deg"
      .= Null
      <> "mirrored"
      .= Null
      <> "candidates"
      .= map (object . candidateFields asked) several

-- | The orientation only where it was asked for.
candidateFields :: Asked -> Candidate -> [Pair]
candidateFields asked (Candidate o place) =
  ("position" .= positionValue place) :
  (if upright asked then [] else ["orientation_deg" .= degreesOf o, "mirrored" .= mirrored o])

degreesOf :: Symmetry -> Int
degreesOf = degreesClockwise

-- | What is said of each patch, given their displacements.
patchesSeries :: [(Integer, Integer)] -> Answer -> Series
patchesSeries displacements answer =
  "patches"
    .= [ object
           [ "at" .= [r, c],
             "wrong" .= patchWrong verdict,
             "inconsistent" .= patchInconsistent verdict
           ]
         | ((r, c), verdict) <- zip displacements (answerPatches answer)
       ]
    <> "disputed"
    .= map positionListValue (answerDisputed answer)
