{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of the truth of an exploration, and of what is compared with it in an answer of
-- @decode@.
module PraTactile.Format.Truth
  ( encodeTruth
  , decodeTruth
  , decodeClaim
  ) where

import Control.Monad (unless)
import Data.Aeson
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy

import PraTactile.Explore
import PraTactile.Format.Error
import PraTactile.Format.Json
import PraTactile.Format.Json.Read
import PraTactile.Format.Recognition (decodeSchema)
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.WingedEdge
import PraTactile.Probe (taxelPitch)
import PraTactile.Truth

-- | The name of this form of a truth.
schema :: String
schema = "pra-tactile/truth/1"

-- | The truth on one line, without its end; all keys always.
encodeTruth :: Truth -> ByteString
encodeTruth truth = Lazy.toStrict $ encodeLine $
  "schema" .= schema
    <> "object" .= objectText (faceObject (truthFace truth))
    <> "face" .= map vertexText (faceVertices (faceName (truthFace truth)))
    <> "region_mm" .= regionCorner region
    <> "region_taxels" .= (regionWidth region, regionHeight region)
    <> "orientation_deg" .= (90 * regionTurns region)
    <> "origin_mm" .= truthOrigin truth
  where
    region = truthRegion truth

-- | The truth in a JSON text that 'encodeTruth' made; lengths in millimetres are read to the
-- nearest double. Refuses another schema, and keys that are missing or have other values.
decodeTruth :: ByteString -> Either FormatError Truth
decodeTruth = decodeAs $ \value -> do
  o <- objectAs "truth" value
  hasSchema schema o
  (x, y) <- field o "region_mm"
  (wide, high) <- field o "region_taxels"
  turns <- part o "orientation_deg" quarterTurnsOf
  let region = Region (x / taxelPitch) (y / taxelPitch) wide high turns
  Truth <$> faceIn o <*> pure region <*> field o "origin_mm"
  where
    quarterTurnsOf degrees = do
      unless (degrees `elem` map (90 *) quarterTurns) (Left (Misfit [] NotQuarterTurn))
      pure (degrees `div` 90)

-- | The claim in a JSON text with an answer of @decode@, or 'Nothing' where it names no place on a
-- face. Refuses what is no such answer.
decodeClaim :: ByteString -> Either FormatError (Maybe Claim)
decodeClaim = decodeAs $ \value -> do
  o <- objectAs "answer" value
  hasSchema decodeSchema o
  outcome <- field o "outcome"
  on <- field o "on"
  if outcome == ("located" :: String) && on == Just ("face" :: String)
    then Just <$> claimIn o
    else pure Nothing
  where
    claimIn o =
      Claim <$> faceIn o <*> field o "orientation_deg" <*> field o "place_mm" <*> field o "robot_mm"

faceIn :: Object -> Either FormatError Face
faceIn o =
  Face <$> (ObjectName <$> field o "object") <*> (FaceName . map VertexName <$> field o "face")
