{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of the truth of a simulated exploration, of the claim in an answer of @decode@, and
-- of their comparison.
module PraTactile.Format.Truth
  ( encodeTruth,
    encodePosedTruth,
    decodeTruth,
    decodeClaim,
    decodeClaimedPose,
    encodeComparison,
  )
where

import Control.Monad (join)
import Data.Aeson ((.=))
import Data.Aeson.Types (JSONPathElement (Key))
import Data.ByteString (ByteString)
import Data.Either (isRight)
import PraTactile.Explore
import PraTactile.Format.Error
import PraTactile.Format.Json
import PraTactile.Format.Json.Codec
import PraTactile.Format.Name
import PraTactile.Format.Object
import PraTactile.Format.Pose
import PraTactile.Format.Recognition (decodeSchema)
import PraTactile.Format.Sensor (bendCodec)
import PraTactile.Pose (RigidMotion)
import PraTactile.Sensor.Frame (taxelPitch)
import PraTactile.Symmetry
import PraTactile.Truth

-- | The truth as one line, without its line end. @bend@ and @angle_deg@ are there only if they
-- apply.
encodeTruth :: Truth -> ByteString
encodeTruth = writeLine truthKeys

-- | The truth with the true pose, if there is one, as one line without its line end. The pose is a
-- motion from the object's frame to the robot's, in the truth's lengths.
encodePosedTruth :: Maybe RigidMotion -> Truth -> ByteString
encodePosedTruth pose truth =
  writeLine
    ((,) <$> withKeys fst truthKeys <*> key "pose" (nullable motionCodec) snd)
    (truth, pose)

-- | Reads the JSON of 'encodeTruth'. Lengths in millimetres become the nearest doubles. Refuses
-- another schema, missing keys, invalid values, regions of more than 100000 taxels a side, and an
-- angle whose nearest quarter turn is not the orientation.
decodeTruth :: ByteString -> Either FormatError Truth
decodeTruth bytes = do
  truth <- decodeWith truthKeys bytes
  if abs (regionAngle (truthRegion truth)) > 45 + 1e-6
    then Left (Misfit [Key "angle_deg"] NotAngle)
    else Right truth

truthKeys :: Keys Truth Truth
truthKeys =
  schemaKey "pra-tactile/truth/1"
    *> ( Truth
           <$> withKeys truthFace faceKeys
           <*> withKeys truthRegion regionKeys
           <*> key "origin_mm" (pairOf real) truthOrigin
           <*> optionalKey "bend" bendCodec truthBend
       )

regionKeys :: Keys ProbedRegion ProbedRegion
regionKeys =
  region
    <$> key "region_mm" (pairOf real) regionCorner
    <*> key "region_taxels" (pairOf side) regionSides
    <*> key "orientation_deg" quarterTurn (quarterTurns . regionSymmetry)
    <*> optionalKey "angle_deg" angle freeAngle
  where
    region (x, y) (wide, high) quarters degrees =
      ProbedRegion (x / taxelPitch) (y / taxelPitch) wide high (turned quarters) $
        maybe 0 (beyond (90 * fromIntegral quarters)) degrees
    -- The angle in the file is the whole rotation, from 0 to 360.
    freeAngle r = if regionAngle r == 0 then Nothing else Just (regionTurn r)
    beyond quarter degrees = degrees - quarter - (if degrees - quarter > 180 then 360 else 0)
    angle = satisfying (\degrees -> degrees >= 0 && degrees < 360) NotAngle real
    regionSides given = (regionWidth given, regionHeight given)
    side =
      via fromIntegral (Right . fromIntegral) $
        satisfying (<= longestSide) (RegionTooLarge longestSide) natural
    longestSide = 100000

-- | Reads the claim from an answer of @decode@; 'Nothing' if it names no place on a face. Refuses
-- any other JSON.
decodeClaim :: ByteString -> Either FormatError (Maybe Claim)
decodeClaim = decodeObject $ \fields -> do
  readKeys (schemaKey decodeSchema) fields
  outcome <- field "outcome" text fields
  on <- field "on" (nullable text) fields
  if outcome == "located" && on == Just "face"
    then Just <$> readKeys claimKeys fields
    else pure Nothing

-- | Reads the pose from an answer of @decode@, if it has one.
decodeClaimedPose :: ByteString -> Either FormatError (Maybe ObjectPose)
decodeClaimedPose =
  decodeObject (fmap join . readKeys (optionalKey "pose" (nullable namedPoseCodec) Just))

claimKeys :: Keys Claim Claim
claimKeys =
  claim
    <$> withKeys claimFace faceKeys
    <*> key "orientation_deg" quarterTurn (quarterTurns . claimSymmetry)
    <*> key "place_mm" (pairOf real) claimPlace
    <*> key "robot_mm" (pairOf real) claimSeenAt
    <*> optionalKey "angle_deg" real claimAngle
  where
    claim face = Claim face . turned

-- | A truth with a claim (if there is one), and their distance in millimetres or their difference,
-- as one line without its line end. All lengths are multiplied by the first argument. The last
-- argument is the error of the pose (millimetres and degrees), if known.
encodeComparison ::
  Double ->
  Truth ->
  Maybe Claim ->
  Either (Maybe Difference) Double ->
  Maybe (Double, Double) ->
  ByteString
encodeComparison scale truth claim verdict poses =
  encodeSchema "compare/1" $
    "agree" .= isRight verdict
      <> "difference" .= either (Just . maybe "no-place" differenceName) (const Nothing) verdict
      <> "answer_mm" .= fmap (told . claimPlace) claim
      <> "truth_mm" .= fmap (told . truePlace truth . claimSeenAt) claim
      <> "distance_mm" .= fmap (scale *) distance
      <> "pose_mm" .= fmap fst poses
      <> "pose_deg" .= fmap snd poses
  where
    told (x, y) = (scale * x, scale * y)
    distance = case verdict of
      Right far -> Just far
      Left (Just (Elsewhere far)) -> Just far
      Left _ -> Nothing
