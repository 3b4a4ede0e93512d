{-# LANGUAGE OverloadedStrings #-}
-- | The JSON of the truth of an exploration, and of what is compared with it in an answer of @decode@.
module Json.Truth
  ( truthJson
  , readTruth
  , readClaim
  ) where

import Data.Aeson

import Ending
import Files (readBytes)
import Json.Decode hiding (object)
import qualified Json.Decode as Decode
import PraTactile.Explore
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.WingedEdge
import PraTactile.Probe (taxelPitch)
import PraTactile.Truth

-- | The truth, all keys always.
truthJson :: Truth -> Series
truthJson truth =
  "schema" .= schema
    <> "object" .= objectText (faceObject (truthFace truth))
    <> "face" .= map vertexText (faceVertices (faceName (truthFace truth)))
    <> "region_mm" .= regionCorner region
    <> "region_taxels" .= (regionWidth region, regionHeight region)
    <> "orientation_deg" .= (90 * regionTurns region)
    <> "origin_mm" .= truthOrigin truth
  where
    region = truthRegion truth

schema :: String
schema = "pra-tactile/truth/1"

-- | The truth in a file that 'truthJson' made; leaves with status 2 and the reason where it is none.
readTruth :: FilePath -> IO Truth
readTruth = readWith "is not the truth as 'pra-tactile probe --truth' writes it" $ \value -> do
  fields <- Decode.object value
  schemaIs schema fields
  (x, y) <- field "region_mm" (pairOf real) fields
  (wide, high) <- field "region_taxels" (pairOf size) fields
  turns <- field "orientation_deg" quarterTurn fields
  origin <- field "origin_mm" (pairOf real) fields
  face <- faceIn fields
  pure (Truth face (Region (x / taxelPitch) (y / taxelPitch) wide high turns) origin)
  where
    size value = number value >>= \n ->
      if n > 100000 then refuse "a region has at most 100000 taxels a side" else Right (fromIntegral n)

-- | The claim in a file with an answer of @decode --json@, or 'Nothing' where it names no place on a face; leaves
-- with status 2 and the reason where it is no answer.
readClaim :: FilePath -> IO (Maybe Claim)
readClaim = readWith "is not one answer as 'pra-tactile decode --json' prints it" $ \value -> do
  fields <- Decode.object value
  schemaIs "pra-tactile/decode/1" fields
  outcome <- field "outcome" text fields
  on <- field "on" Right fields
  if outcome == "located" && on == String "face"
    then do
      face <- faceIn fields
      turns <- field "orientation_deg" quarterTurn fields
      place <- field "place_mm" (pairOf real) fields
      Just . Claim face (90 * turns) place <$> field "robot_mm" (pairOf real) fields
    else pure Nothing

faceIn :: Fields -> Either Complaint Face
faceIn fields = Face . ObjectName <$> field "object" text fields
  <*> (FaceName . map VertexName <$> field "face" (listOf text) fields)

-- | Degrees as quarter turns.
quarterTurn :: Decoder Int
quarterTurn value = number value >>= \degrees -> case lookup degrees [ (fromIntegral (90 * turns), turns) | turns <- quarterTurns ] of
  Just turns -> Right turns
  Nothing -> refuse "one of 0, 90, 180 and 270 is needed"

readWith :: String -> Decoder a -> FilePath -> IO a
readWith complaint decoder file = readBytes file >>= orUnusable inWords . decodeWith decoder
  where
    inWords why = file ++ " " ++ complaint ++ ": " ++ why
