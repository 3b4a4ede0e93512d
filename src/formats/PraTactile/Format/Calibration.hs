{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of a sensor's calibration.
module PraTactile.Format.Calibration
  ( encodeCalibration,
    decodeCalibration,
  )
where

import Data.ByteString (ByteString)
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec
import PraTactile.Image (Raster, fromRows, rasterHeight, rasterSize, rasterWidth, toRows)
import PraTactile.Sensor.Calibration

-- | A calibration as one line, without its line end.
encodeCalibration :: Calibration -> ByteString
encodeCalibration = writeLine calibrationKeys

-- | Reads the JSON of 'encodeCalibration'. Refuses another schema, rows of different lengths,
-- gains that are not positive, rasters of different sizes, and dead elements that are outside or
-- repeated.
decodeCalibration :: ByteString -> Either FormatError Calibration
decodeCalibration bytes = do
  given@(Calibration offset gain dead) <- decodeWith calibrationKeys bytes
  let size = rasterSize
      inside (y, x) = y >= 0 && x >= 0 && y < rasterHeight offset && x < rasterWidth offset
  if size offset == size gain
    && all (all (> 0)) (toRows gain)
    && all inside dead
    then Right given
    else refuse NotCalibration

calibrationKeys :: Keys Calibration Calibration
calibrationKeys =
  schemaKey "pra-tactile/calibration/1"
    *> ( Calibration
           <$> key "offset" rows calibrationOffset
           <*> key "gain" rows calibrationGain
           <*> key "dead" (distinct id element (listOf (pairOf int))) calibrationDead
       )
  where
    element (y, x) = show y ++ "," ++ show x

-- | A raster as the list of its rows.
rows :: Codec Raster
rows = via toRows (either (const (refuse NotCalibration)) Right . fromRows) (listOf (listOf real))
