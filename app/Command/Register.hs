-- | @pra-tactile register@: where the second of two frames lies in the first.
module Command.Register
  ( command,
  )
where

import Data.Bifunctor (first)
import qualified Data.ByteString.Char8 as Bytes
import Data.Text.Encoding (encodeUtf8)
import ExitStatus
import FormatFile (readCalibration)
import FramesChoice (calibrationOption, fullScaleOption)
import Lines
import Message
import Options
import PraTactile.Files (readFrame)
import PraTactile.Format.Registration
import PraTactile.Image (Raster, rasterSize)
import PraTactile.Registration.Pair
import PraTactile.Sensor.Calibration (CalibrationError, correctedImage)
import PraTactile.Shape (Alphabet)
import PraTactile.Source (frameOf)
import Setup
import System.IO (hFlush, stdout)
import Text.Printf (printf)

command :: Subcommand
command =
  subcommand
    "register"
    "Find how two overlapping frames are displaced"
    "Find where the second of two overlapping frames lies in the first, from what they show, and \
    \how certain that is."
    []
    [ "pra-tactile register data/worked-example/frames/frame_000.pgm \
      \data/worked-example/frames/frame_001.pgm --step 8,0",
      "pra-tactile register --batch < pairs.jsonl"
    ]
    ( run
        <$> (Left <$> batchSwitch <|> Right <$> pairArguments)
        <*> pairingOptions
        <*> alphabetChoice
        <*> calibrationOption
        <*> fullScaleOption
        <*> jsonSwitch "Print the answer as JSON"
    )
  where
    batchSwitch =
      flag'
        ()
        ( long "batch"
            <> help
              "Read lines {\"a\": FILE, \"b\": FILE, \"step\": [DX, DY]} from the standard input, \
              \and answer each by a line of JSON"
        )
    pairArguments =
      PairRequest
        <$> pathArgument (metavar "A.pgm" <> action "file")
        <*> pathArgument (metavar "B.pgm" <> action "file")
        <*> option
          (pairReader ',' "8,0")
          ( long "step" <> metavar "DX,DY"
              <> help "Where the upper left pixel of B should lie in A, in taxels right and down"
          )

-- | The options of registration, without the step.
pairingOptions :: Parser ((Double, Double) -> Pairing)
pairingOptions =
  (\search method confidence step -> Pairing step search method confidence)
    <$> defaulting 3 decimalReader "search" "TAXELS" "How far around --step to search"
    <*> choosing
      "method"
      (allNamed pairMethodName)
      "method"
      "METHOD"
      "How frames are compared: correlation (as in the paper), blind (without knowing the \
      \symbols), lattice (by the lattice of symbols), or auto, the better of the last two (default)"
      (value Auto)
    <*> defaulting
      0.99
      decimalReader
      "confidence"
      "P"
      "Smallest probability that the answer is right; below it, refuse"

run ::
  Either () PairRequest ->
  ((Double, Double) -> Pairing) ->
  AlphabetChoice ->
  Maybe FilePath ->
  Maybe Double ->
  AnswerForm ->
  IO ExitStatus
run asked pairing symbols calibrationFile full form = do
  known <- chosenAlphabet symbols
  calibrated <- maybe Right correctedImage <$> traverse readCalibration calibrationFile
  let frame = frameIn calibrated full
  case asked of
    Right request -> do
      (match, _) <- answered known frame pairing Nothing request
      printAs form (matchText match) (encodeMatch match)
      pure (statusOf match)
    Left () ->
      (\(_, _, worst) -> worst)
        <$> forLines (answerLine known frame) (1, Nothing, Answered)
  where
    answerLine known frame (number, tables, worst) line = do
      request <- orUnusable id (requested number line)
      (match, tables') <- answered known frame pairing tables request
      Bytes.putStrLn (encodeMatch match)
      hFlush stdout
      pure (number + 1, Just tables', max worst (statusOf match))
    requested number line = case line of
      Line text -> first (formatMessage name "a request") (decodePairRequest (encodeUtf8 text))
      NotUtf8 _ -> Left (name ++ " is not UTF-8 text")
      TooLong size ->
        Left (name ++ " has " ++ show size ++ " bytes; at most " ++ show largestLine ++ " are read")
      where
        name = "line " ++ show (number :: Int)

-- | The answer to a request, and the tables for the next.
answered ::
  Alphabet ->
  (FilePath -> IO Raster) ->
  ((Double, Double) -> Pairing) ->
  Maybe ((Int, Int), Tables) ->
  PairRequest ->
  IO (Match, ((Int, Int), Tables))
answered known frame pairing made (PairRequest fileA fileB step) = do
  a <- frame fileA
  b <- frame fileB
  let size = rasterSize a
      tables = case made of
        Just (forSize, already) | forSize == size -> already
        _ -> uncurry (tablesFor known) size
  match <-
    orUnusable
      (\e -> fileA ++ ", " ++ fileB ++ ": " ++ pairMessage e)
      (registerPair tables (pairing step) a b)
  pure (match, (size, tables))

-- | The frame in a file or of a movie, corrected, given the correction and, perhaps, the reading of
-- full contact.
frameIn ::
  (Raster -> Either CalibrationError Raster) -> Maybe Double -> FilePath -> IO Raster
frameIn calibrated full path = do
  (bytes, number) <- readFrame path >>= orUnusable filesMessage
  (felt, _) <- orUnusable (fileMessage path) (frameOf full number bytes)
  orUnusable (\e -> path ++ ": " ++ calibrationMessage e) (calibrated felt)

statusOf :: Match -> ExitStatus
statusOf match = maybe Answered (const NotAnswered) (matchRefusal match)

-- | The answer in words.
matchText :: Match -> String
matchText match = case matchRefusal match of
  Nothing -> printf "B lies %s of A%s\n" (placeWords shift) certainty
  Just refusal ->
    printf
      "refused: %s; at best B lies %s of A%s\n"
      (refusalWords match refusal)
      (placeWords shift)
      certainty
  where
    Hypothesis shift probability = matchBest match
    certainty =
      printf " (probability %.3f; method %s)" probability (pairMethodName (matchMethod match)) ::
        String

placeWords :: (Double, Double) -> String
placeWords (x, y) = printf "%.2f taxels right and %.2f down" x y

refusalWords :: Match -> PairRefusal -> String
refusalWords match refusal = case refusal of
  Blank -> "a frame shows nothing but noise"
  OneAxis -> "only the displacement along " ++ axis ++ " is fixed"
  Ambiguous -> "several displacements fit alike"
  NoOverlap -> "the frames do not meet"
  where
    axis = if fst (matchFixed match) then "x" else "y"
