{-# LANGUAGE OverloadedStrings #-}
-- | @pra-tactile prove@: does every window occur once? By visiting them all, and by rank.
module Command.Prove
  ( command
  , surfaceOption
  ) where

import Data.Aeson ((.=))
import Data.Aeson.Encoding (Series)
import Data.Maybe (fromMaybe)
import Options.Applicative hiding (command)

import ArrayChoice
import Described
import Ending
import Json
import Json.Profile
import Message (profileMessage, proofMessage)
import PraTactile.Array (Position (..), Surface (..))
import PraTactile.Profile
import PraTactile.Window.Proof

command :: Mod CommandFields (IO Ending)
command = described "prove" "Prove or refute that the content of every window tells its position: by visiting every window, and by the rank of the window's cells."
  [ "pra-tactile prove --json"
  , "pra-tactile prove --q 4 --polynomial 3,2,1,0,1 --shape 15x17 --window 1x4 --surface sheet" ]
  (run <$> arrayChoice <*> surfaceOption <*> switch (long "json" <> help "Print the verdict as JSON"))

run :: ArrayChoice -> Maybe Surface -> Bool -> IO Ending
run choice chosen asJson = do
  profile <- chosenProfile choice
  let on = fromMaybe (profileSurface profile) chosen
  outcome <- orUnusable profileMessage (withProfile profile (\array mask -> fst <$> prove on array mask))
  verdict <- orUnusable proofMessage outcome
  if asJson then printJson (verdictJson profile verdict) else putStr (verdictText profile verdict)
  pure (if proved verdict then Answered else NotAnswered)

-- | @--surface torus|sheet@.
surfaceOption :: Parser (Maybe Surface)
surfaceOption = optional (option (eitherReader surfaceNamed)
  (long "surface" <> metavar "SURFACE" <> help "torus, twisted-torus or sheet (default: the folding's own)"))
  where
    surfaceNamed name = case [ s | s <- [minBound ..], surfaceName s == name ] of
      s : _ -> Right s
      [] -> Left (show name ++ " is not a surface; choose torus, twisted-torus or sheet")

verdictText :: Profile -> Verdict -> String
verdictText profile verdict = unlines $
  [ if proved verdict
      then "proved: every " ++ window ++ " window on the " ++ place ++ " has a content of its own"
      else "refuted: some " ++ window ++ " windows on the " ++ place ++ " have the same content"
  , "  by visiting every window: " ++ road (enumeration verdict)
  , "  by rank:                  " ++ road (rankRoad verdict) ++ maybe "" ofNeeded (rank verdict)
  ]
  ++ [ "  different windows:        " ++ show n | Just n <- [distinctWindows verdict] ]
  ++ [ "  the same window is at row " ++ at a ++ " and at row " ++ at b | Just (a, b) <- [collision verdict] ]
  where
    window = shapeText (profileWindow profile)
    place = surfaceName (surface verdict) ++ " of " ++ shapeText (profileShape profile)
    road = maybe "not decided" (\yes -> if yes then "yes" else "no")
    ofNeeded r = " (rank " ++ show r ++ maybe "" (\n -> ", needed " ++ show n) (needed verdict) ++ ")"
    at (Position r c) = show r ++ ", column " ++ show c

verdictJson :: Profile -> Verdict -> Series
verdictJson profile verdict =
  "schema" .= ("pra-tactile/prove/1" :: String)
    <> "profile" .= profileValue profile
    <> "proved" .= proved verdict
    <> "enumeration" .= enumeration verdict
    <> "rank_road" .= rankRoad verdict
    <> "rank" .= fmap naturalValue (rank verdict)
    <> "needed" .= fmap naturalValue (needed verdict)
    <> "windows" .= fmap naturalValue (distinctWindows verdict)
    <> "surface" .= surfaceName (surface verdict)
    <> "collision" .= fmap (\(a, b) -> [positionListValue a, positionListValue b]) (collision verdict)
