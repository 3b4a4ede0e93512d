{-# LANGUAGE OverloadedStrings #-}
-- | The JSON of the truth of an exploration, and of what is compared with it in an answer of @decode@.
module Json.Truth
  ( truthJson
  , readTruth
  , readClaim
  ) where

import Control.Monad (unless)
import Data.Aeson
import Data.Aeson.Types (Parser, parseEither)
import qualified Data.ByteString.Lazy as Lazy

import Ending
import Files (readBytes)
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
readTruth file = readWith "is not the truth as 'pra-tactile probe --truth' writes it" parser file
  where
    parser = withObject "truth" $ \o -> do
      expectSchema schema o
      (x, y) <- o .: "region_mm"
      (wide, high) <- o .: "region_taxels"
      degrees <- o .: "orientation_deg"
      unless (degrees `elem` map (90 *) quarterTurns) (fail "orientation_deg is no quarter turn")
      let region = Region (x / taxelPitch) (y / taxelPitch) wide high (degrees `div` 90)
      Truth <$> faceIn o <*> pure region <*> o .: "origin_mm"

-- | The claim in a file with an answer of @decode --json@, or 'Nothing' where it names no place on a face; leaves
-- with status 2 and the reason where it is no answer.
readClaim :: FilePath -> IO (Maybe Claim)
readClaim = readWith "is not one answer as 'pra-tactile decode --json' prints it" parser
  where
    parser = withObject "answer" $ \o -> do
      expectSchema "pra-tactile/decode/1" o
      outcome <- o .: "outcome"
      on <- o .: "on"
      if outcome == ("located" :: String) && on == Just ("face" :: String)
        then Just <$> (Claim <$> faceIn o <*> o .: "orientation_deg" <*> o .: "place_mm" <*> o .: "robot_mm")
        else pure Nothing

faceIn :: Object -> Parser Face
faceIn o = Face <$> (ObjectName <$> o .: "object") <*> (FaceName . map VertexName <$> o .: "face")

expectSchema :: String -> Object -> Parser ()
expectSchema expected o = do
  form <- o .: "schema"
  unless (form == expected) (fail ("its schema is " ++ show form ++ ", not " ++ show expected))

readWith :: String -> (Value -> Parser a) -> FilePath -> IO a
readWith complaint parser file = do
  bytes <- readBytes file
  orUnusable inWords (eitherDecode (Lazy.fromStrict bytes) >>= parseEither parser)
  where
    inWords why = file ++ " " ++ complaint ++ ": " ++ unwords (lines why)
