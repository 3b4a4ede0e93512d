-- | @pra-tactile train@: train the network from a seed, as the shipped one was, or as the paper's
-- was.
module Command.Train
  ( command,
  )
where

import Control.Monad (forM_, when)
import Counted (counted)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (for_)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (catMaybes, isJust)
import qualified Data.Text.Encoding as Text
import ExitStatus
import Memory
import Message
import Options
import Output
import PraTactile.Classification.Calibration (Calibration, renderCalibration)
import PraTactile.Classification.Experiment
import PraTactile.Classification.Network (Network, outputs)
import PraTactile.Classification.Network.File (renderNetwork)
import PraTactile.Classification.Regimen
import PraTactile.Classification.Templates (templates)
import PraTactile.Classification.Train (Demand (..))
import PraTactile.Classification.Traingdx (Epoch (..), Trace, lastEpoch)
import PraTactile.Experiment (materialSteps, trainedEach)
import PraTactile.Explore (Turns (..), halfTurns)
import PraTactile.Format.Experiment (traceCsv)
import PraTactile.Format.Network
import PraTactile.Sensor (Preset (..), presetName, presetSensor)
import PraTactile.Shape (Alphabet, alphabetSize)
import PraTactile.Steps (summed)
import PraTactile.SymbolCalibration
import PraTactile.SymbolImages (ImageSource (..), symbolsOf)
import Progress
import Setup
import System.FilePath (takeExtension)
import System.IO (hFlush, stdout)
import Text.Printf (printf)

-- | How a network is trained.
data How
  = AsShipped
  | ByPaper Training
  deriving stock (Eq)

data Options = Options
  { how :: How,
    noise :: Bool,
    seed :: Int,
    trace :: Maybe FilePath,
    calibrating :: Bool,
    sureness :: Maybe FilePath,
    output :: FilePath
  }

command :: Subcommand
command =
  subcommand
    "train"
    "Train a network on a set of shapes"
    "Train a network on images of symbols, from a seed, and write its weights. With the default \
    \seed and regimen, shipped shapes give the shipped weights."
    []
    [ "pra-tactile train --output network.txt",
      "pra-tactile train --regimen stopped --seed 1 --trace trace.csv --output network.json"
    ]
    (run <$> alphabetChoice <*> options)
  where
    options =
      Options
        <$> choosing
          "regimen"
          (("shipped", AsShipped) : [(trainingName t, ByPaper t) | t <- [Stated, Stopped, Manual]])
          "regimen"
          "REGIMEN"
          "shipped (default): on drawn symbols, new ones each round. The others are the paper's \
          \three stages on pressed symbols; they end at an error of 0 (stated), of 0.1 in the \
          \clean stages (stopped), or of 0.1, 0.6 and 0.1, as in the toolbox's manual (manual)"
          (value AsShipped)
        <*> flag
          True
          False
          ( long "without-noise"
              <> help "Train without noisy images; of the paper's stages, leave out the middle one"
          )
        <*> seedOption (value shippedSeed <> showDefault)
        <*> optionalFile
          "trace"
          "FILE.csv"
          "Write every epoch to this file: error, gradient, rate and step"
        <*> flag
          True
          False
          ( long "uncalibrated"
              <> help
                "Do not press symbols to calibrate the network's probabilities; take the \
                \calibration of the shipped one"
          )
        <*> optional
          ( orAlias "calibration" pathReader (action "file") $
              fileOption
                "network-calibration"
                "FILE"
                "Write the calibration of the network's probabilities to this file, for weights \
                \that are written as text"
          )
        <*> fileOption
          "output"
          "FILE"
          "Write the weights to this file, as JSON if its name ends in .json"

run :: AlphabetChoice -> Options -> IO ExitStatus
run symbols options = do
  alphabet <- chosenAlphabet symbols
  orUnwritableAmong (output options : catMaybes [trace options, sureness options])
  announced options (alphabetSize alphabet)
  (network, done) <- trainedAs (how options) alphabet options
  for_ (trace options) (`writeWhole` Lazy8.pack (traceCsv done))
  calibration <-
    if pressing options
      then calibratedWith alphabet network (seed options)
      else pure (calibrationFor alphabet)
  for_ (sureness options) $ \file ->
    writeWhole file (Lazy.fromStrict (Text.encodeUtf8 (renderCalibration calibration)))
  writeWhole (output options) $
    if asJson options
      then
        Lazy.fromStrict (encodeNetwork (described alphabet network calibration))
          <> Lazy.singleton 10
      else Lazy.fromStrict (Text.encodeUtf8 (renderNetwork network))
  forM_ done $ \(i, descent) ->
    sayBeside
      (output options)
      ( printf
          "stage %d: %d epochs, squared error %.4f -> %.4f\n"
          i
          (epochNumber (lastEpoch descent))
          (epochError (NonEmpty.head descent))
          (epochError (lastEpoch descent))
      )
  sayWritten (output options) ""
  pure Answered
  where
    described alphabet network calibration =
      NetworkFile
        { fileNetwork = network,
          fileAlphabet = alphabetDigest alphabet,
          fileCalibration = calibration,
          fileSeed = Just (seed options),
          fileRegimen = Just (regimenName options)
        }

-- | Whether weights are written as JSON, which has their calibration.
asJson :: Options -> Bool
asJson options = takeExtension (output options) == ".json"

-- | Whether symbols are pressed to calibrate the network: only if the calibration is written.
pressing :: Options -> Bool
pressing options = calibrating options && (asJson options || isJust (sureness options))

-- | Say what a training for n classes takes, before it begins; leaves with status 2 if that is too
-- much.
announced :: Options -> Int -> IO ()
announced options classes = do
  orTooMuch
    ("training " ++ shapes')
    "train fewer shapes, or by another --regimen"
    (demandBytes demand)
  when (pressing options) $
    orTooMuch
      ("calibrating the network of " ++ shapes')
      "train fewer shapes, or leave its calibration out (--uncalibrated)"
      (calibrationBytes classes)
  sayBeside (output options) $
    "training " ++ shapes' ++ ": "
      ++ counted (demandImages demand) "image" "images"
      ++ " at once, "
      ++ counted (demandEpochs demand) "epoch" "epochs"
      ++ " at most, about "
      ++ bytesText (maximum (demandBytes demand : [calibrationBytes classes | pressing options]))
      ++ (", " ++ atOneRate (fromInteger (demandProducts demand) / 1e9))
      ++ concat
        [ "; then " ++ counted (calibrationImages classes) "pressed image" "pressed images"
            ++ " to calibrate it"
          | pressing options
        ]
      ++ "\n"
  hFlush stdout
  where
    shapes' = counted classes "shape" "shapes"
    demand = demandFor options classes
    atOneRate seconds = timeText seconds ++ " at 10^9 multiplications a second"

-- | A time in words, to two digits or so.
timeText :: Double -> String
timeText seconds
  | seconds < 100 = whole' seconds "second" "seconds"
  | seconds < 6000 = whole' (seconds / 60) "minute" "minutes"
  | seconds < 360000 = whole' (seconds / 3600) "hour" "hours"
  | otherwise = whole' (seconds / 86400) "day" "days"
  where
    whole' n = counted (max 1 (round n :: Int))

-- | What the training for n classes takes.
demandFor :: Options -> Int -> Demand
demandFor options classes = case how options of
  AsShipped -> regimenDemand (regimenOf options classes) classes
  ByPaper training ->
    trainingDemand standardConditions training (middleOf options) classes

-- | The calibration of a network, found on presses.
calibratedWith :: Alphabet -> Network -> Int -> IO Calibration
calibratedWith alphabet network seed' = do
  found <-
    withProgress (unevenly total "images to calibrate with") $ \bar ->
      follow bar (calibratedSteps alphabet (templates alphabet) (outputs network) seed')
  orUnusable imagesMessage found >>= orUnusable networkMessage
  where
    total = calibrationImages (alphabetSize alphabet)

-- | How the network was trained, as its file has it.
regimenName :: Options -> String
regimenName options = named ++ (if noise options then "" else "-without-noise")
  where
    named = case how options of
      AsShipped -> "shipped"
      ByPaper training -> trainingName training

-- | The trained network, and its stages with their numbers. The shipped regimen has a stage for
-- each round.
trainedAs :: How -> Alphabet -> Options -> IO (Network, [(Int, Trace)])
trainedAs AsShipped alphabet options = do
  network <-
    orUnusable networkMessage
      =<< withProgress
        (evenly (demandEpochs (demandFor options classes)) "epochs")
        (`follow` summed epochsIn training)
  -- Each round has its own batch, so it is a stage of its own.
  pure (network, zip [1 ..] (map snd (roundsOf training)))
  where
    epochsIn step = if step == EpochDone then 1 else 0
    classes = alphabetSize alphabet
    training = trainingSteps (regimenOf options classes) alphabet (seed options)
trainedAs (ByPaper training) alphabet options = do
  images <-
    orUnusable imagesMessage
      =<< withProgress
        (unevenly (trainedEach * classes) "images")
        (`follow` materialSteps (symbolsOf alphabet) source (seed options))
  let go = trainedBySteps standardConditions training classes images (seed options)
  -- A stage may reach its goal at any epoch.
  done <-
    orUnusable networkMessage
      =<< withProgress
        (openly (\n -> show n ++ " epochs of at most " ++ show most))
        (`follow` summed (const 1) (go (middleOf options)))
  pure (runNetwork done, runStages done)
  where
    classes = alphabetSize alphabet
    most = demandEpochs (demandFor options classes)
    source = Presses (presetName Real) (presetSensor Real) (AmongTurns halfTurns)

-- | The regimen of the shipped networks, for n classes.
regimenOf :: Options -> Int -> Regimen
regimenOf options classes
  | noise options = it
  | otherwise = it {stages = [s {stageNoise = [0]} | s <- stages it]}
  where
    it = regimenFor classes

middleOf :: Options -> Middle
middleOf options = if noise options then Noisy else NoMiddle
