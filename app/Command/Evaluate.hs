-- | @pra-tactile evaluate@: simulated presses by the thousand, counted right, wrong and refused.
module Command.Evaluate
  ( command,
  )
where

import ArrayChoice
import Command.Decode (toleranceComplaint, toleranceOptions)
import Command.Stitch (registrationFor)
import Control.Monad (foldM, unless)
import Control.Parallel.Strategies (parBuffer, rseq, withStrategy)
import Data.Bifunctor (first)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes)
import Data.Traversable (for)
import ExitStatus
import Message
import Options
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Format (EvaluationReport (..), encodeEvaluation)
import PraTactile.Object.Placement
import PraTactile.Probe (planScan)
import PraTactile.Probe.Sensor (HeightMap)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Relief
import PraTactile.Symmetry (Symmetry, rotations)
import Progress
import Setup
import Text.Printf (printf)

data Options = Options
  { presses :: Int,
    seed :: Int,
    size :: (Int, Int),
    sensor :: SensorChoice,
    turns :: [Symmetry],
    tolerance :: Tolerance,
    network :: Maybe FilePath,
    form :: AnswerForm
  }

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "evaluate"
    "Simulate presses at random places on the faces in turn, and count how many are decoded \
    \right, wrong or refused, with stitching and without."
    [ "pra-tactile evaluate --presses 100 --seed 1",
      "pra-tactile evaluate --presses 100 --seed 1 --noise 0.3 --doubt 0.0001"
    ]
    (run <$> arrayChoice <*> options)
  where
    options =
      Options
        <$> defaulting 1000 intReader "presses" "N" "How many regions are explored"
        <*> seedOption (value 1 <> showDefault)
        <*> sizeOption
        <*> sensorOptions
        <*> flag
          halfTurns
          rotations
          ( long "quarter-turns"
              <> help
                "The faces lie in any of four ways (default: upright or turned by 180 degrees)"
          )
        <*> toleranceOptions
        <*> networkOption
        <*> jsonSwitch "Print the counts as JSON"

run :: ArrayChoice -> Options -> IO ExitStatus
run choice options
  | presses options < 1 = unusable "--presses is a number from 1 up"
  | Just complaint <- toleranceComplaint (tolerance options) = unusable complaint
  | not (positionSigma (sensor options) >= 0 && noiseSd (sensor options) >= 0) =
    unusable "--position-error and --noise are numbers from 0 up"
  | otherwise = do
    profile <- chosenProfile choice
    layout <- placementFor profile
    alphabet <- shippedAlphabet
    net <- chosenNetwork (network options)
    let prepared array mask = do
          reader <-
            first
              recogniserMessage
              (recogniser (profileSurface profile) array mask layout alphabet net)
          faces <-
            first reliefMessage . for (laidFaces layout) $ \face ->
              (,) face <$> relief array layout alphabet face
          pure (measure profile options reader faces)
    measured <- orUnusable profileMessage (withProfile profile prepared)
    either unusable id measured

-- | Run the trials on all cores, saying how far it is where a person looks on, and print the two
-- counts. Trials are made as they are needed and let go once counted, so that any number takes the
-- same memory.
measure ::
  KnownField k =>
  Profile ->
  Options ->
  Recogniser k ->
  [(LaidFace, HeightMap)] ->
  IO ExitStatus
measure profile options reader faces = do
  _ <- orUnusable probeMessage (planScan frameSpacing (0, 0) (size options))
  unless
    (fitting (turns options) (size options) (map fst faces) (seed options) (presses options))
    (unusable tooLarge)
  (stitched, unstitched) <- withProgress (toInteger (presses options)) 0 $ \tell ->
    foldM (count tell) (noResults, noResults) (zip [1 ..] (results options reader faces))
  printAs
    (form options)
    ( unlines
        [headingText options, tallyText "stitching" stitched, tallyText "no-stitching" unstitched]
    )
    (encodeEvaluation (report profile options stitched unstitched))
  pure Answered
  where
    count :: (Integer -> IO ()) -> (Tally, Tally) -> (Integer, TrialResult) -> IO (Tally, Tally)
    count tell (stitched, unstitched) (i, outcome) =
      let stitched' = counting stitched (withStitching outcome)
          unstitched' = counting unstitched (withoutStitching outcome)
       in stitched' `seq` unstitched' `seq` tell i >> pure (stitched', unstitched')
    tooLarge =
      printf
        "a region of %d x %d taxels does not lie on every face; choose a smaller --size"
        (fst (size options))
        (snd (size options))

report :: Profile -> Options -> Tally -> Tally -> EvaluationReport
report profile options stitched unstitched =
  EvaluationReport
    { evaluationProfile = profile,
      evaluationPresses = presses options,
      evaluationSeed = seed options,
      evaluationPositionError = positionSigma (sensor options),
      evaluationNoise = noiseSd (sensor options),
      evaluationStitched = stitched,
      evaluationUnstitched = unstitched
    }

-- | What comes of each press, made on all cores as it is needed.
results :: KnownField k => Options -> Recogniser k -> [(LaidFace, HeightMap)] -> [TrialResult]
results options reader faces =
  withStrategy (parBuffer 32 rseq) (map decoded (take (presses options) (catMaybes started)))
  where
    decoded = runTrial (tolerance options) reader (registrationFor sigma sd)
    SensorChoice sigma sd = sensor options
    started =
      trials (chosenSensor (sensor options)) (turns options) (size options) faces (seed options)

headingText :: Options -> String
headingText options =
  printf
    "%d presses, seed %d, regions of %d x %d taxels, position error sigma %g taxels, noise sd %g \
    \of full scale"
    (presses options)
    (seed options)
    (fst (size options))
    (snd (size options))
    (positionSigma (sensor options))
    (noiseSd (sensor options))

tallyText :: String -> Tally -> String
tallyText name counted =
  printf
    "%-13s right %d  wrong %d (expected: %.2g)  refused %d (%.1f %%)%s"
    name
    (tallyRight counted)
    (tallyWrong counted)
    (tallyExpected counted)
    refused
    share
    ( concat
        [ printf "%s %s %d" (if i == 0 then ":" else "," :: String) reason n
          | (i, (reason, n)) <- zip [0 :: Int ..] (Map.toAscList (tallyRefused counted))
        ] ::
        String
    )
  where
    refused = sum (tallyRefused counted)
    share =
      100
        * fromIntegral refused
        / fromIntegral (max 1 (refused + tallyRight counted + tallyWrong counted)) ::
        Double
