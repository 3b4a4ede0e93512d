{-# LANGUAGE OverloadedStrings #-}

-- | The JSON form of the manifest of a folder of frames. It can state what the CSV form cannot: the
-- frames' size, their taxels' pitch, the axes of the coordinates, and full scale.
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
    SensorPose (..),
    TaxelGrid (..),
    isTaxelPitch,
    standardTaxelGrid,
    taxelPitch,
    taxelPitches,
  )
import PraTactile.Sensor.Manifest
import PraTactile.Source (frameImages)

-- | A manifest as one line, without its line end. A pitch that is not stated is written as
-- 'taxelPitch'.
encodeManifest :: Manifest -> ByteString
encodeManifest = writeLine manifestKeys

-- | Reads the JSON of 'encodeManifest'. Required are @taxel_mm@ and @frames@; optional are @frame@,
-- @axes@, @full_scale@, and in an entry its pose (as a whole) and its force. Refuses another
-- schema, a pitch outside 'taxelPitches', a full scale outside 'fullScales', unknown axes, a
-- manifest without frames, and invalid file names.
decodeManifest :: ByteString -> Either FormatError Manifest
decodeManifest = decodeWith manifestKeys

-- | The files of a folder of frames, by name: its manifest and its images. Arguments: the image
-- format; the sensor's grid; the bits of its readings, 1 to 16 (not checked), or 0 for real
-- numbers; the frames. Images have 2^bits grey values, at least 256. The manifest is CSV for the
-- standard grid and at most 8 bits, otherwise JSON. Refuses what 'frameImages' refuses.
folderFiles ::
  ImageFormat -> TaxelGrid -> Int -> [Frame] -> Either ImageError [(FilePath, ByteString)]
folderFiles format grid bits frames = do
  (entries, images) <- frameImages format top frames
  pure (manifest entries : Map.toList images)
  where
    top = if bits <= 8 then 255 else 2 ^ bits - 1
    -- A PGM file states its full scale. Readers of the others take 255 or 65535 unless the manifest
    -- states one.
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
    fullScale = satisfying isFullScale (OutOfRange "the full scale" fullScales) real
    pitch = satisfying isTaxelPitch (OutOfRange "the pitch" taxelPitches) real
    some' = satisfying (not . null) NoFrame (listOf (object entryKeys))
    axes = flip (via axesName) text $ \given ->
      maybe (refuse (NotAmong (map fst axesNamed) given)) Right (lookup given axesNamed)

-- | The three keys of the pose are optional together; the force is optional alone.
entryKeys :: Keys Entry Entry
entryKeys =
  Entry
    <$> key "file" fileName entryFile
    <*> optionalKeys "x_mm" poseKeys entryPose
    <*> optionalKey "force_n" real entryForce
  where
    poseKeys =
      SensorPose
        <$> key "x_mm" real poseX
        <*> key "y_mm" real poseY
        <*> key "rotation_deg" real poseRotation
