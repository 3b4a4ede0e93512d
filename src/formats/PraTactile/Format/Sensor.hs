{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of a simulated sensor, with the unit and the source of each constant; and of the
-- cylinder on which a face is wrapped.
module PraTactile.Format.Sensor
  ( encodeSensor,
    decodeSensor,
    bendCodec,
  )
where

import Control.Monad (foldM)
import Data.ByteString (ByteString)
import Data.Maybe (fromMaybe)
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec
import PraTactile.Sensor (Bend (..), bendAxisName, longestRadius)
import PraTactile.Sensor.Constants
import PraTactile.Sensor.Model (Sensor)
import PraTactile.Sensor.Preset (Preset (..), presetName, presetSensor)

-- | A sensor, with the name of its preset if it has one, as one line without its line end.
encodeSensor :: Maybe Preset -> Sensor -> ByteString
encodeSensor preset sensor =
  writeLine keys (preset, constantsOf sensor)
  where
    keys = whole <* sourced
    whole =
      schemaKey sensorSchema
        *> key "preset" (nullable presetCodec) fst
    sourced = key "constants" (listOf constantCodec) snd

sensorSchema :: String
sensorSchema = "pra-tactile/sensor/1"

presetCodec :: Codec Preset
presetCodec = named presetName

-- | A constant with its value, read by its name. The unit is optional but must be the constant's
-- own.
constantCodec :: Codec (Constant, Double)
constantCodec = case object keys of
  Codec schema write _ -> Codec schema write $ \value -> do
    fields <- objectOf value
    given@(constant, _) <- readKeys valued fields
    _ <- readKeys (optionalKey "unit" (unitOf constant) Just) fields
    pure given
  where
    valued = (,) <$> key "name" constantNamed fst <*> key "value" real snd
    keys =
      valued
        <* key "unit" text (constantUnit . fst)
        <* key "source" text (constantSource . fst)
    unitOf constant =
      let unit = constantUnit constant
       in satisfying (== unit) (OtherUnit (constantName constant) unit) text

constantNamed :: Codec Constant
constantNamed = flip (via constantName) text $ \given ->
  case [c | c <- constants, constantName c == given] of
    c : _ -> Right c
    [] -> refuse (NotAmong (map constantName constants) given)

-- | Reads the JSON of 'encodeSensor'. Constants that it does not name come from its preset, or
-- from 'Paper' if it has none. Sources are ignored. Refuses another schema, unknown names, repeated
-- constants, other units, and values out of range.
decodeSensor :: ByteString -> Either FormatError Sensor
decodeSensor bytes = do
  (preset, given) <- decodeWith keys bytes
  foldM put (presetSensor (fromMaybe Paper preset)) given
  where
    keys =
      schemaKey sensorSchema
        *> ( (,) . fromMaybe Nothing
               <$> optionalKey "preset" (nullable presetCodec) (Just . fst)
               <*> key "constants" (distinct (constantName . fst) id (listOf constantCodec)) snd
           )
    put sensor (constant, value) =
      either
        (const (refuse (OutOfRange (constantName constant) (constantRange constant))))
        Right
        (replaced (constantName constant) value sensor)

-- | A cylinder, with the radius in millimetres and the name of its axis. Refuses a radius that is
-- not positive or above 'longestRadius'.
bendCodec :: Codec Bend
bendCodec = object (Bend <$> key "radius_mm" radius bendRadius <*> key "axis" axis bendAxis)
  where
    radius =
      satisfying
        (\r -> r > 0 && r <= longestRadius)
        (OutOfRange "radius_mm" (0, longestRadius))
        real
    axis = named bendAxisName
