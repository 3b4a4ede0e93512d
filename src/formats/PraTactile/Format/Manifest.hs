{-# LANGUAGE OverloadedStrings #-}

-- | The JSON form of the manifest of a folder of frames, which says what the CSV form does not: the
-- frames' size, their taxels' pitch, and which way the coordinates go.
module PraTactile.Format.Manifest
  ( encodeManifest,
    decodeManifest,
  )
where

import Data.ByteString (ByteString)
import Data.Maybe (fromMaybe)
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec
import PraTactile.Sensor.Frame (Pose (..))
import PraTactile.Sensor.Manifest

-- | A manifest on one line, without its end.
encodeManifest :: Manifest -> ByteString
encodeManifest = writeLine manifestKeys

-- | The manifest in a JSON text as 'encodeManifest' makes it; @frame@ and @axes@ may be left out.
-- Refuses another schema, a pitch that is not positive, a manifest without frames, and file names
-- that are empty.
decodeManifest :: ByteString -> Either FormatError Manifest
decodeManifest = decodeWith manifestKeys

manifestKeys :: Keys Manifest Manifest
manifestKeys =
  schemaKey "pra-tactile/manifest/1"
    *> ( Manifest
           <$> key "taxel_mm" pitch manifestTaxel
           <*> optionalKey "frame" (pairOf int) manifestFrame
           <*> (fromMaybe straight <$> optionalKey "axes" axes (Just . manifestAxes))
           <*> key "frames" some' manifestEntries
       )
  where
    pitch = such (> 0) (NotPositive "the pitch") real
    some' = such (not . null) NoFrame (listOf (object entryKeys))
    axes = Codec axesName $ \value -> do
      given <- readValue text value
      maybe (refuse (NotAmong (map fst axesNamed) given)) Right (lookup given axesNamed)

entryKeys :: Keys Entry Entry
entryKeys =
  entry
    <$> key "file" (such (not . null) NotText text) entryFile
    <*> key "x_mm" real (poseX . entryPose)
    <*> key "y_mm" real (poseY . entryPose)
    <*> key "rotation_deg" real (poseRotation . entryPose)
    <*> key "force_n" real entryForce
  where
    entry file x y r = Entry file (Pose x y r)

-- | Values that are so; others are refused.
such :: (a -> Bool) -> Misfit -> Codec a -> Codec a
such holds misfit (Codec write decoder) = Codec write $ \value ->
  decoder value >>= \a -> if holds a then Right a else refuse misfit
