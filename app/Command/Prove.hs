-- | @pra-tactile prove@: does every window occur once? By visiting them all, and by rank.
module Command.Prove
  ( command,
  )
where

import ArrayChoice
import CsvGrid (readGrid)
import Data.Maybe (fromMaybe)
import ExitStatus
import MaskChoice
import Message (profileMessage, proofMessage, windowMessage)
import Numeric.Natural (Natural)
import Options
import PraTactile.Array (ArrayOn (..), Position (..), Surface (..), arrayFolding, naturalSurface)
import PraTactile.Format (ProvedArray (..), encodeProof)
import PraTactile.Format.Name (shapeText, surfaceName)
import PraTactile.Format.Proof (subjectShape)
import PraTactile.Profile
import PraTactile.Window
import PraTactile.Window.Distance
import PraTactile.Window.Proof
import Progress
import Visible

command :: Subcommand
command =
  subcommand
    "prove"
    "Prove or refute that all windows are distinct"
    "Decide whether every window has a content of its own, so that its content tells its position. \
    \Two methods are used: visiting every window, and the rank of the window's cells. FILE may \
    \hold any array, whoever made it."
    [arrayGroup]
    [ "pra-tactile prove --json",
      "pra-tactile prove --q 4 --polynomial 3,2,1,0,1 --shape 15x17 --window 1x4 --surface sheet",
      "pra-tactile prove --mask '##./.##'",
      "pra-tactile prove array.csv --window 2x2"
    ]
    ( run
        <$> maskOption
        <*> surfaceOption
        <*> jsonSwitch "Print the verdict as JSON"
        <*> optional
          ( pathArgument
              ( metavar "FILE"
                  <> action "file"
                  <> help
                    "A CSV file of codes, one row a line, in place of a pseudorandom array. It \
                    \needs --window or --mask; --q is one more than the largest code unless given"
              )
          )
        <*> arrayChoice
    )

run :: Maybe Mask -> Maybe Surface -> AnswerForm -> Maybe FilePath -> ArrayChoice -> IO ExitStatus
run drawn on form source choice = do
  result <- maybe ofProfile ofFile source choice drawn on
  _ <- whileWorking working (length (verdictText result))
  printAs
    form
    (verdictText result)
    (encodeProof (ofWhat result) (windowMask result) (verdict result) (apart result))
  pure (if proved (verdict result) then Answered else NotAnswered)

-- | The verdict on the windows of an array.
data Result = Result
  { ofWhat :: ProvedArray,
    windowMask :: Mask,
    verdict :: WindowVerdict,
    -- | how far windows lie apart, if that is known
    apart :: Maybe Distance
  }

ofProfile :: ArrayChoice -> Maybe Mask -> Maybe Surface -> IO Result
ofProfile choice drawn on = do
  (profile, mask) <- chosenMask choice drawn on
  let on' = profileSurface profile
      proven array _ = (fst <$> prove (ArrayOn on' array) mask, distanceOn on' array mask)
  (outcome, far) <- orUnusable profileMessage (withProfile profile proven)
  found <- whileWorking working outcome >>= orUnusable proofMessage
  pure (Result (OfProfile profile) mask found far)
  where
    -- The distance of the windows on the array's own surface, if no long search is needed.
    distanceOn on' array mask
      | on' == naturalSurface (arrayFolding array) =
        either (const Nothing) Just (minimumDistanceWithin (2 ^ (20 :: Int)) array mask)
      | otherwise = Nothing

ofFile :: FilePath -> ArrayChoice -> Maybe Mask -> Maybe Surface -> IO Result
ofFile file choice drawn on = do
  (q, window) <- orUnusable id (choiceBesideFile choice)
  mask <- case (drawn, window) of
    (Just mask, Nothing) -> pure mask
    (Nothing, Just shape) -> orUnusable windowMessage (rectangle shape)
    (Nothing, Nothing) ->
      misused "a window of the file is not known; give --window ROWSxCOLUMNS or --mask DRAWING"
    (Just _, Just _) -> misused "--mask already says what a window is; leave out --window"
  grid <- readGrid q file
  found <-
    whileWorking working (proveGrid (fromMaybe Torus on) grid mask)
      >>= orUnusable proofMessage
  pure (Result (OfFile (nameInJson file) grid) mask found Nothing)

-- | The text of the progress line.
working :: String
working = "visiting windows"

verdictText :: Result -> String
verdictText (Result subject mask found far) =
  unlines $
    [ if proved found
        then "proved: every " ++ window ++ " window on the " ++ place ++ " has a content of its own"
        else "refuted: some " ++ window ++ " windows on the " ++ place ++ " have the same content",
      "  by visiting every window: " ++ decided (enumeration found),
      "  by rank:                  "
        ++ decided (rankDecision found)
        ++ maybe "" ofNeeded (rank found)
    ]
      ++ ["  different windows:        " ++ show n | Just n <- [distinctWindows found]]
      ++ [ "  minimum distance:         " ++ show d ++ correctable d cells
           | Just (Distance d cells) <- [far],
             d > 0
         ]
      ++ [ "  the same window is at row " ++ at a ++ " and at row " ++ at b
           | Just (a, b) <- [collision found]
         ]
  where
    window = maskText mask
    place = surfaceName (surface found) ++ " of " ++ shapeText (subjectShape subject)
    decided = maybe "not decided" (\yes -> if yes then "yes" else "no")
    ofNeeded r =
      " (rank " ++ show r ++ maybe "" (\n -> ", needed " ++ show n) (needed found) ++ ")"
    at (Position r c) = show r ++ ", column " ++ show c

-- | How many missing or wrong cells a minimum distance tolerates; and cells whose loss it does not,
-- if these are few.
correctable :: Natural -> [Position] -> String
correctable d cells =
  ": forgives up to "
    ++ show (d - 1)
    ++ " missing cells, or up to "
    ++ show ((d - 1) `div` 2)
    ++ " wrong ones"
    ++ if length cells > 8
      then ""
      else ", but not the loss of " ++ unwords [show r ++ "," ++ show c | Position r c <- cells]
