-- | @pra-tactile segment@: the symbols of a composite, as @decode@ sees them before it uses the
-- array.
module Command.Segment
  ( command,
  )
where

import Control.Monad (when)
import qualified Data.ByteString.Char8 as Bytes
import Data.Maybe (catMaybes)
import Data.Traversable (for)
import ExitStatus
import Frames
import FramesChoice
import Message
import Options
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Files (sourcePath)
import PraTactile.Format.Segmentation
import PraTactile.Recognise.Features
import PraTactile.Segmentation.Symbol
import Setup
import Text.Printf (printf)
import Visible

command :: Subcommand
command =
  subcommand
    "segment"
    "Find the symbols in tactile images"
    "Find the symbols in tactile images: where each is, which way its axes point and how far its \
    \neighbours are. It takes the sources that 'decode' takes, with --shapes or --q in place of \
    \the array, and shows what 'decode' sees."
    [framesGroup]
    [ "pra-tactile segment data/worked-example/composite.pgm",
      "pra-tactile segment data/worked-example/frames --json"
    ]
    ( run
        <$> alphabetChoice
        <*> networkOption
        <*> stitchingOptions
        <*> framesOptions
        <*> jsonSwitch "Print each answer as a line of JSON"
        <*> framesArgument
    )

run ::
  AlphabetChoice ->
  Maybe FilePath ->
  StitchingChoice ->
  FramesChoice ->
  AnswerForm ->
  [FilePath] ->
  IO ExitStatus
run symbols weights stitching choice form paths = do
  found <- chosenSources choice paths
  when (onlyImages found) $
    leaveOut
      "whole images have no frames"
      (ofFrames stitching choice)
  when (asTheyAre stitching) $
    leaveOut
      "--no-stitching uses the nominal positions"
      (ofRegistration stitching)
  known <- preparation choice
  reader <- chosenAlphabet symbols >>= (`readerWith` weights)
  composites <- loadSources (readerTables reader) 1 known (stitchingOf stitching) found
  let several = not (null (drop 1 found))
  fmap (maximum . (Answered :)) . for (zip (map sourcePath found) composites) $
    \(path, composite) -> do
      segmented <- orUnusable networkMessage (features reader composite)
      case form of
        AsJson -> Bytes.putStrLn (encodeSegmentation (nameInJson path) segmented)
        AsText -> do
          when several (putStrLn (visibleName path ++ ":"))
          putStr (unlines (inWords segmented))
      pure (if null (featuresSymbols segmented) then NotAnswered else Answered)

-- | The symbols, parts and rejects, one on each line.
inWords :: Features -> [String]
inWords segmented
  | null everything = ["nothing is embossed"]
  | otherwise = everything
  where
    everything =
      map symbolText (featuresSymbols segmented)
        ++ map partText (featuresParts segmented)
        ++ map rejectText (featuresRejects segmented)

symbolText :: Featured -> String
symbolText symbol =
  placed "symbol" (featuredAt symbol)
    ++ printf ", axis at %.1f degrees" (featuredAxis symbol)
    ++ concat [", " ++ there | there <- neighbours]
  where
    beside = featuredNeighbours symbol
    neighbours =
      catMaybes
        [ towards "right" <$> neighbourRight beside,
          towards "left" <$> neighbourLeft beside,
          towards "up" <$> neighbourUp beside,
          towards "down" <$> neighbourDown beside
        ]
    towards :: String -> (Double, Double) -> String
    towards name (x, y) = printf "%s %.1f" name (sqrt (x * x + y * y))

partText :: Incomplete -> String
partText part =
  placed "part" (incompleteAt part)
    ++ printf ", %.0f %% of it seen" (100 * incompleteSeen part)

rejectText :: Reject -> String
rejectText (Reject (l, t, r, b) cause) =
  printf "no symbol (%s) from %.1f, %.1f to %.1f, %.1f" (causeName cause) l t r b

placed :: String -> (Double, Double) -> String
placed what (x, y) = printf "%-6s at %.1f, %.1f" what x y
