-- | @pra-tactile experiment@: the paper's experiment, with its controls and one thing changed at a
-- time.
module Command.Experiment
  ( command,
  )
where

import Command.Images (ImageChoice, chosenImages, imageChoice)
import Control.Monad (foldM)
import Control.Parallel.Strategies (evalTraversable, parBuffer, rdeepseq, withStrategy)
import CurvesPlot
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_, toList)
import Data.List (nub)
import Data.Maybe (fromMaybe)
import Drawing (hundredths)
import ExitStatus
import Memory (orTooMuch)
import Message
import Options
import Output (orTaken, sayWritten, writeFolder)
import PraTactile.Classification.Experiment
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Classification.Traingdx (Epoch (..), Trace)
import PraTactile.Experiment
import PraTactile.Format.Experiment
import PraTactile.Shape (alphabetSize)
import PraTactile.SymbolImages
import Progress
import Setup
import Text.Printf (printf)

data Options = Options
  { trainings :: [Training],
    variations :: [Variation],
    images :: ImageChoice,
    seeds :: Int,
    output :: Maybe FilePath,
    form :: AnswerForm
  }

command :: Subcommand
command =
  subcommand
    "experiment"
    "Repeat the paper's training experiment, with controls"
    "Train networks as the paper does: with noisy images, with clean copies in their place, and \
    \without that stage. Count how many noisy images of other presses each network classifies \
    \wrongly."
    []
    [ "pra-tactile experiment --training stopped --set bitmap --seeds 1",
      "pra-tactile experiment --training manual --vary weights --set bitmap --seeds 1 --output \
      \experiment"
    ]
    (run <$> alphabetChoice <*> options)
  where
    options =
      Options
        <$> named
          "training"
          (allNamed trainingName)
          "training"
          "Trainings, separated by commas: stated, stopped, manual, many (default: all)"
          [minBound ..]
        <*> named
          "variation"
          (allNamed variationName)
          "vary"
          "What is changed, one thing at a time, separated by commas: weights, ranges, \
          \least-gradient, formula, stages, images, alphabet (default: nothing)"
          []
        <*> imageChoice (value True)
        <*> defaulting 16 intReader "seeds" "N" "Run every row with each of the seeds 1 to N"
        <*> optional
          (folderOption "output" "Write tables (CSV, JSON) and curves (SVG) into this new folder")
        <*> jsonSwitch "Print the table as JSON"
    named what choices name text standard =
      option
        (namesReader what choices)
        ( long name <> metavar "NAME,.." <> completeWith (map fst choices) <> value standard
            <> help text
        )

-- | The kept results of a row with one seed: the counts for each kind of middle stage, and for the
-- first seed the learning curves by stage.
type Kept = [([[(Int, Int)]], [(Int, [(Double, Double)])])]

run :: AlphabetChoice -> Options -> IO ExitStatus
run choice options
  | seeds options < 1 || seeds options > 10000 = misused "--seeds must be a number from 1 to 10000"
  | otherwise = do
    for_ (output options) orTaken
    source <- chosenImages (images options)
    symbols <- symbolsOf <$> chosenAlphabet choice
    let rows = plan (trainings options) (nub (variations options)) shippedAlphabets source symbols
    orTooMuch
      "the experiment"
      "take fewer shapes, or fewer --seeds"
      (experimentBytes trialsAtOnce (seeds options) rows)
    made <- traverse (imagesOf rows) (nub (map keyOf rows))
    table <- carriedOut rows made [1 .. seeds options]
    let results = [(row, o) | (row, kept) <- table, o <- outcomes (map (map fst) kept)]
    for_ (output options) $ \folder -> do
      writeFolder folder (files results table)
      case form options of
        AsText -> sayWritten folder ""
        AsJson -> pure ()
    printAs (form options) (unlines (heading : map line results)) (encodeExperiment results)
    pure Answered
  where
    imagesOf rows key =
      (,) key <$> case [row | row <- rows, keyOf row == key] of
        row : _ ->
          orUnusable imagesMessage
            =<< withProgress
              (unevenly (imagesCount (sizeOf row) (seeds options)) "images")
              (`follow` imagesSteps (rowSymbols row) (rowSource row) [1 .. seeds options])
        [] -> pure (Images [] (Labelled [] 0 0))
    sizeOf = alphabetSize . symbolShapes . rowSymbols

-- | How many trials are made at once.
trialsAtOnce :: Int
trialsAtOnce = 2

-- | Rows with the same key have the same images.
keyOf :: Row -> (String, Maybe String, Int)
keyOf row =
  ( sourceName (rowSource row),
    sourceSensor (rowSource row),
    alphabetSize (symbolShapes (rowSymbols row))
  )

-- | Each row with its results for each seed; shows progress on a terminal.
carriedOut ::
  [Row] -> [((String, Maybe String, Int), Images)] -> [Int] -> IO [(Row, [Kept])]
carriedOut rows made chosen =
  withProgress (unevenly (length cells) "trainings") $ \bar -> do
    (_, done) <- foldM (include bar) (0 :: Integer, []) (withStrategy strategy cells)
    pure (zip rows (chunks (length chosen) (reverse done)))
  where
    strategy = parBuffer trialsAtOnce (evalTraversable rdeepseq)
    cells = [kept row seed | row <- rows, seed <- chosen] :: [Either NetworkError Kept]
    kept row seed = case lookup (keyOf row) made of
      Just there -> map (part seed) <$> trial row there seed
      Nothing -> Right []
    part seed (how, counts) =
      (counts, if take 1 chosen == [seed] then map (fmap curve) (runStages how) else [])
    include ::
      Bar ->
      (Integer, [Kept]) ->
      Either NetworkError Kept ->
      IO (Integer, [Kept])
    include bar (i, done) cell = do
      one <- orUnusable networkMessage cell
      tell bar (i + 1)
      pure (i + 1, one : done)
    chunks n list = case splitAt n list of
      ([], _) -> []
      (here, others) -> here : chunks n others

-- | The decimal logarithm of the error after about three hundred epochs of a stage.
curve :: Trace -> [(Double, Double)]
curve trace =
  [ (fromIntegral (epochNumber e), logBase 10 (max 1e-40 (epochError e)))
    | e <- epochs,
      epochNumber e `mod` max 1 (length epochs `div` 300) == 0
  ]
  where
    epochs = toList trace

heading :: String
heading =
  printf
    "%-9s%-7s%-33s%8s  %-16s%-13s%-13s%s"
    "training"
    "middle"
    "varied"
    "worst %"
    "least..greatest"
    "below clean"
    "below none"
    "paper"

line :: (Row, RowResult) -> String
line (row, o) =
  reverse . dropWhile (== ' ') . reverse $
    printf
      "%-9s%-7s%-33s%8.2f  %-16s%-13s%-13s%s"
      (trainingName (rowTraining row))
      (middleName (outcomeMiddle o))
      (fromMaybe "-" (rowVaried row))
      (spreadMedian (outcomeWorst o))
      (printf "%.2f..%.2f" (spreadLeast worst) (spreadGreatest worst) :: String)
      (share (outcomeBetterThanClean o))
      (share (outcomeBetterThanNone o))
      (foldMap show (paperOf (row, o)))
  where
    worst = outcomeWorst o
    share = foldMap (\n -> show n ++ " of " ++ show (outcomeSeeds o))

-- | The tables and the curves.
files :: [(Row, RowResult)] -> [(Row, [Kept])] -> [(FilePath, Bytes.ByteString)]
files results table =
  [ ("rows.csv", Bytes.pack (rowsCsv results)),
    ("levels.csv", Bytes.pack (levelsCsv results)),
    ("experiment.json", encodeExperiment results <> Bytes.singleton '\n'),
    ("noise.svg", Lazy.toStrict (curvesSvg (noiseCurves results))),
    ("learning.svg", Lazy.toStrict (curvesSvg (learningCurves table)))
  ]

-- | The medians of the errors at each noise level, of the rows in which nothing is changed.
noiseCurves :: [(Row, RowResult)] -> Curves
noiseCurves results =
  Curves
    { curvesTitle = "Images told wrong, by the noise that they are tried with",
      curvesAcross =
        Scale
          "standard deviation of the noise"
          [(v, printf "%.1f" v) | v <- [0, 0.1, 0.2, 0.3, 0.4, 0.5 :: Double]],
      curvesUp = Scale "%" (quarters top),
      curvesPanels =
        [ (trainingName t, [(fromEnum m, points) | (t', m, points) <- plain, t' == t])
          | t <- nub [t | (t, _, _) <- plain]
        ],
      curvesLegend =
        [ (fromEnum Noisy, "with noisy images"),
          (fromEnum CleanCopies, "with clean copies in their place"),
          (fromEnum NoMiddle, "without that stage")
        ]
    }
  where
    plain =
      [ (rowTraining row, outcomeMiddle o, [(v, spreadMedian s) | (v, s) <- outcomeLevels o])
        | (row, o) <- results,
          rowVaried row == Nothing
      ]
    top = maximum (0.1 : [e | (_, _, points) <- plain, (_, e) <- points])

-- | The error of the first seed's network with noisy images, epoch by epoch, of the same rows.
learningCurves :: [(Row, [Kept])] -> Curves
learningCurves table =
  Curves
    { curvesTitle = "The squared error of training, with noisy images (seed 1)",
      curvesAcross = Scale "epoch of the stage" (quarters longest),
      curvesUp =
        Scale
          "squared error"
          [(fromIntegral k, "1e" ++ show k) | k <- [bottom, bottom + 2 .. 2 :: Int]],
      curvesPanels =
        [ (trainingName (rowTraining row), [(i - 1, points) | (i, points) <- stages])
          | (row, stages) <- plain
        ],
      curvesLegend = zip [0 ..] ["clean images", "noisy images", "clean images again"]
    }
  where
    plain =
      [ (row, stages)
        | (row, ((_, stages) : _) : _) <- table,
          rowVaried row == Nothing
      ]
    longest = maximum (4 : [n | (_, stages) <- plain, (_, points) <- stages, (n, _) <- points])
    least = minimum (0 : [e | (_, stages) <- plain, (_, points) <- stages, (_, e) <- points])
    bottom = max (-12) (2 * floor (least / 2))

-- | Five marks from 0 to a round number of at least this size.
quarters :: Double -> [(Double, String)]
quarters most = [(top * k / 4, hundredths (top * k / 4)) | k <- [0 .. 4]]
  where
    top = foldr const most (filter (>= most) rounded)
    rounded = [m * 10 ^^ k | k <- [-3 .. 9 :: Int], m <- [1, 2, 4, 6, 8]]
