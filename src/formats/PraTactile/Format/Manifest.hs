{-# LANGUAGE OverloadedStrings #-}

-- | The JSON form of the manifest of a folder of frames, which says what the CSV form does not: the
-- frames' size, their taxels' pitch, and which way the coordinates go.
module PraTactile.Format.Manifest
  ( encodeManifest,
    decodeManifest,
    folderFiles,
  )
where

import Data.ByteString (ByteString)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec
import PraTactile.Image.Error (ImageError)
import PraTactile.Image.File (ImageFormat (..), fullScales, isFullScale)
import PraTactile.Sensor.Frame
  ( Frame,
    Pose (..),
    TaxelGrid (..),
    isTaxelPitch,
    standardTaxelGrid,
    taxelPitch,
    taxelPitches,
  )
import PraTactile.Sensor.Manifest
import PraTactile.Source (frameImages)

-- | A manifest on one line, without its end.
encodeManifest :: Manifest -> ByteString
encodeManifest = writeLine manifestKeys

-- | The manifest in a JSON text as 'encodeManifest' makes it; @frame@ and @axes@, and what frames
-- may be without, may be left out.
-- Refuses another schema, a pitch that is none of 'taxelPitches', a manifest without frames, and
-- what is no file's name.
decodeManifest :: ByteString -> Either FormatError Manifest
decodeManifest = decodeWith manifestKeys

-- | The files of a folder of frames, by their names: its manifest, and images in this format, of
-- a sensor of this grid whose readings have so many bits, 0 for real numbers. Of the standard
-- sensor and at most 8 bits the manifest is in its CSV form, else in its JSON form, and images have
-- as many grey values as the readings. Refuses what 'frameImages' refuses.
folderFiles ::
  ImageFormat -> TaxelGrid -> Int -> [Frame] -> Either ImageError [(FilePath, ByteString)]
folderFiles format grid bits frames = do
  (entries, images) <- frameImages format top frames
  pure (manifest entries : Map.toList images)
  where
    top = if bits <= 8 then 255 else 2 ^ bits - 1
    -- PGM says its own.
    full = if format == Pgm || top `elem` [255, 65535] then Nothing else Just (fromIntegral top)
    manifest entries
      | grid == standardTaxelGrid && bits <= 8 = (manifestName, renderManifest entries)
      | otherwise = (jsonManifestName, encodeManifest (listed entries) <> "\n")
    listed entries =
      (listing entries)
        { manifestTaxel = Just (taxelGridPitch grid),
          manifestFullScale = full,
          manifestFrame = Just (taxelGridColumns grid, taxelGridRows grid),
          manifestAxes = Just straight
        }

manifestKeys :: Keys Manifest Manifest
manifestKeys =
  schemaKey "pra-tactile/manifest/1"
    *> ( Manifest
           <$> (Just <$> key "taxel_mm" pitch (fromMaybe taxelPitch . manifestTaxel))
           <*> optionalKey "frame" (pairOf int) manifestFrame
           <*> optionalKey "axes" axes manifestAxes
           <*> optionalKey "full_scale" fullScale manifestFullScale
           <*> key "frames" some' manifestEntries
       )
  where
    fullScale = such isFullScale (OutOfRange "the full scale" fullScales) real
    pitch = such isTaxelPitch (OutOfRange "the pitch" taxelPitches) real
    some' = such (not . null) NoFrame (listOf (object entryKeys))
    axes = flip (via axesName) text $ \given ->
      maybe (refuse (NotAmong (map fst axesNamed) given)) Right (lookup given axesNamed)

-- | The three keys of the pose may be left out together, that of the force by itself.
entryKeys :: Keys Entry Entry
entryKeys =
  Entry
    <$> key "file" fileName entryFile
    <*> optionalKeys "x_mm" poseKeys entryPose
    <*> optionalKey "force_n" real entryForce
  where
    poseKeys =
      Pose
        <$> key "x_mm" real poseX
        <*> key "y_mm" real poseY
        <*> key "rotation_deg" real poseRotation
