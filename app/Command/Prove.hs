{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile prove@: does every window occur once? By visiting them all, and by rank.
module Command.Prove
  ( command,
    surfaceOption,
  )
where

import ArrayChoice
import CsvGrid (readGrid)
import Data.Aeson (Value (..), (.=))
import Data.Aeson.Encoding (Series)
import Data.Maybe (fromMaybe)
import Described
import Ending
import Json
import MaskChoice
import Message (profileMessage, proofMessage, windowMessage)
import Options.Applicative hiding (command)
import PraTactile.Array (Position (..), Shape (..), Surface (..), arrayFolding, naturalSurface)
import PraTactile.Format.Profile
import PraTactile.Grid (gridAlphabet, gridShape)
import PraTactile.Profile
import PraTactile.Window
import PraTactile.Window.Distance
import PraTactile.Window.Proof
import Visible

command :: Mod CommandFields (IO Ending)
command =
  described
    "prove"
    "Prove or refute that the content of every window tells its position: by visiting every \
    \window, and by the rank of the window's cells. FILE decides any array, whoever made it."
    [ "pra-tactile prove --json",
      "pra-tactile prove --q 4 --polynomial 3,2,1,0,1 --shape 15x17 --window 1x4 --surface sheet",
      "pra-tactile prove --mask '##./.##'",
      "pra-tactile prove array.csv --window 2x2"
    ]
    ( run
        <$> arrayChoice
        <*> maskOption
        <*> surfaceOption
        <*> switch (long "json" <> help "Print the verdict as JSON")
        <*> optional
          ( strArgument
              ( metavar "FILE"
                  <> action "file"
                  <> help
                    "A CSV file of codes, one row a line, instead of a pseudorandom array; needs \
                    \--window or --mask; --q is the largest code and one more unless given"
              )
          )
    )

run :: ArrayChoice -> Maybe Mask -> Maybe Surface -> Bool -> Maybe FilePath -> IO Ending
run choice drawn on asJson source = do
  (subject, mask, verdict) <- maybe (ofProfile choice drawn on) (ofFile choice drawn on) source
  if asJson
    then printJson (verdictJson subject mask verdict)
    else putStr (verdictText subject mask verdict)
  pure (if proved verdict then Answered else NotAnswered)

-- | Of what the windows are: its shape, how JSON tells it, and how far its windows lie apart, if
-- that is known.
data Subject = Subject Shape Series (Maybe Distance)

ofProfile :: ArrayChoice -> Maybe Mask -> Maybe Surface -> IO (Subject, Mask, Verdict)
ofProfile choice drawn on = do
  (profile, mask) <- chosenMask choice drawn on
  let on' = profileSurface profile
  (outcome, apart) <-
    orUnusable
      profileMessage
      (withProfile profile (\array _ -> (fst <$> prove on' array mask, apartOn on' array mask)))
  verdict <- orUnusable proofMessage outcome
  pure (Subject (profileShape profile) ("profile" .= profileValue profile) apart, mask, verdict)
  where
    -- The distance is that of the windows on the array's own surface, and is told if it takes no
    -- long search.
    apartOn surface' array mask
      | surface' == naturalSurface (arrayFolding array) =
        either (const Nothing) Just (minimumDistanceWithin (2 ^ (20 :: Int)) array mask)
      | otherwise = Nothing

ofFile :: ArrayChoice -> Maybe Mask -> Maybe Surface -> FilePath -> IO (Subject, Mask, Verdict)
ofFile choice drawn on file = do
  (q, window) <- orUnusable id (choiceBesideFile choice)
  mask <- case (drawn, window) of
    (Just mask, Nothing) -> pure mask
    (Nothing, Just shape) -> orUnusable windowMessage (rectangle shape)
    (Nothing, Nothing) ->
      unusable "say what a window of the file is: --window ROWSxCOLUMNS or --mask DRAWING"
    (Just _, Just _) -> unusable "--mask already says what a window is; leave out --window"
  grid <- readGrid q file
  verdict <- orUnusable proofMessage (proveGrid (fromMaybe Torus on) grid mask)
  let Shape high wide = gridShape grid
      told =
        "profile"
          .= Null
          <> "file"
          .= nameInJson file
          <> "q"
          .= gridAlphabet grid
          <> "shape"
          .= [naturalValue high, naturalValue wide]
  pure (Subject (gridShape grid) told Nothing, mask, verdict)

verdictText :: Subject -> Mask -> Verdict -> String
verdictText (Subject shape _ apart) mask verdict =
  unlines $
    [ if proved verdict
        then "proved: every " ++ window ++ " window on the " ++ place ++ " has a content of its own"
        else "refuted: some " ++ window ++ " windows on the " ++ place ++ " have the same content",
      "  by visiting every window: " ++ road (enumeration verdict),
      "  by rank:                  "
        ++ road (rankDecision verdict)
        ++ maybe "" ofNeeded (rank verdict)
    ]
      ++ ["  different windows:        " ++ show n | Just n <- [distinctWindows verdict]]
      ++ [ "  minimum distance:         " ++ show d ++ forgiven d cells
           | Just (Distance d cells) <- [apart],
             d > 0
         ]
      ++ [ "  the same window is at row " ++ at a ++ " and at row " ++ at b
           | Just (a, b) <- [collision verdict]
         ]
  where
    window = maskText mask
    place = surfaceName (surface verdict) ++ " of " ++ shapeText shape
    road = maybe "not decided" (\yes -> if yes then "yes" else "no")
    ofNeeded r =
      " (rank " ++ show r ++ maybe "" (\n -> ", needed " ++ show n) (needed verdict) ++ ")"
    at (Position r c) = show r ++ ", column " ++ show c
    forgiven d cells =
      ": forgives up to "
        ++ show (d - 1)
        ++ " missing cells, or up to "
        ++ show ((d - 1) `div` 2)
        ++ " wrong ones"
        ++ if length cells > 8
          then ""
          else ", but not the loss of " ++ unwords [show r ++ "," ++ show c | Position r c <- cells]

verdictJson :: Subject -> Mask -> Verdict -> Series
verdictJson (Subject _ subject apart) mask verdict =
  "schema" .= ("pra-tactile/prove/1" :: String)
    <> subject
    <> "mask" .= maskDrawing mask
    <> "proved" .= proved verdict
    <> "enumeration" .= enumeration verdict
    <> "rank_road" .= rankDecision verdict
    <> "rank" .= fmap naturalValue (rank verdict)
    <> "needed" .= fmap naturalValue (needed verdict)
    <> "windows" .= fmap naturalValue (distinctWindows verdict)
    <> "surface" .= surfaceName (surface verdict)
    <> "distance" .= fmap (naturalValue . distance) apart
    <> "failing_erasure" .= fmap (map positionListValue . failingErasure) apart
    <> "collision"
      .= fmap (\(a, b) -> [positionListValue a, positionListValue b]) (collision verdict)
