{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of the truth of an exploration, and of what is compared with it in an answer of
-- @decode@.
module PraTactile.Format.Truth
  ( encodeTruth,
    decodeTruth,
    decodeClaim,
  )
where

import Data.Aeson (Object, Value (..), (.=))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.List (find)
import PraTactile.Explore
import PraTactile.Format.Error
import PraTactile.Format.Json
import PraTactile.Format.Json.Read
import PraTactile.Format.Recognition (decodeSchema)
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.WingedEdge
import PraTactile.Probe (taxelPitch)
import PraTactile.Symmetry
import PraTactile.Truth

-- | The name of this form of a truth.
schema :: String
schema = "pra-tactile/truth/1"

-- | The truth on one line, without its end; all keys always.
encodeTruth :: Truth -> ByteString
encodeTruth truth =
  Lazy.toStrict $
    encodeLine $
      "schema" .= schema
        <> "object" .= objectText (faceObject (truthFace truth))
        <> "face" .= map vertexText (faceVertices (faceName (truthFace truth)))
        <> "region_mm" .= regionCorner region
        <> "region_taxels" .= (regionWidth region, regionHeight region)
        <> "orientation_deg" .= (degreesClockwise (regionSymmetry region) :: Int)
        <> "origin_mm" .= truthOrigin truth
  where
    region = truthRegion truth

-- | The truth in a JSON text that 'encodeTruth' made; lengths in millimetres are read to the
-- nearest double. Refuses another schema, keys that are missing or have other values, and regions
-- of more than 100000 taxels a side.
decodeTruth :: ByteString -> Either FormatError Truth
decodeTruth = decodeWith $ \value -> do
  fields <- object value
  schemaIs schema fields
  (x, y) <- field "region_mm" (pairOf real) fields
  (wide, high) <- field "region_taxels" (pairOf side) fields
  symmetry <- field "orientation_deg" rotation fields
  origin <- field "origin_mm" (pairOf real) fields
  face <- faceIn fields
  pure (Truth face (Region (x / taxelPitch) (y / taxelPitch) wide high symmetry) origin)
  where
    side value =
      natural value >>= \n ->
        if n > longestSide then refuse (RegionTooLarge longestSide) else Right (fromIntegral n)
    longestSide = 100000

-- | The claim in a JSON text with an answer of @decode@, or 'Nothing' where it names no place on a
-- face. Refuses what is no such answer.
decodeClaim :: ByteString -> Either FormatError (Maybe Claim)
decodeClaim = decodeWith $ \value -> do
  fields <- object value
  schemaIs decodeSchema fields
  outcome <- field "outcome" text fields
  on <- field "on" Right fields
  if outcome == "located" && on == String "face" then Just <$> claimIn fields else pure Nothing
  where
    claimIn fields = do
      face <- faceIn fields
      symmetry <- field "orientation_deg" rotation fields
      place <- field "place_mm" (pairOf real) fields
      Claim face symmetry place <$> field "robot_mm" (pairOf real) fields

faceIn :: Object -> Either FormatError Face
faceIn fields = do
  name <- field "object" text fields
  vertices <- field "face" (listOf text) fields
  pure (Face (ObjectName name) (FaceName (map VertexName vertices)))

-- | A rotation, by its degrees.
rotation :: Decoder Symmetry
rotation value =
  natural value >>= \degrees ->
    maybe (refuse NotQuarterTurn) Right (find ((== degrees) . degreesClockwise) rotations)
