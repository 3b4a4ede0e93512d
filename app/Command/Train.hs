-- | @pra-tactile train@: train the network from a seed, as the shipped one was, or as the paper's
-- was.
module Command.Train
  ( command,
  )
where

import Control.Monad (forM_)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (for_)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (catMaybes)
import qualified Data.Text.Encoding as Text
import ExitStatus
import Message
import Options
import Output
import PraTactile.Classification.Calibration (renderCalibration)
import PraTactile.Classification.Experiment
import PraTactile.Classification.Network (Network, outputs)
import PraTactile.Classification.Network.File (renderNetwork)
import PraTactile.Classification.Regimen
import PraTactile.Classification.Templates (templates)
import PraTactile.Classification.Traingdx (Epoch (..), Trace, lastEpoch)
import PraTactile.Experiment (material)
import PraTactile.Explore (Turns (..), halfTurns)
import PraTactile.Format.Experiment (traceCsv)
import PraTactile.Format.Network
import PraTactile.Sensor (Preset (..), presetName, presetSensor)
import PraTactile.Shape (Alphabet, alphabetSize)
import PraTactile.Steps (counted, stepsDone)
import PraTactile.SymbolCalibration (calibrated)
import PraTactile.SymbolImages (ImageSource (..), symbolsOf)
import Progress
import Setup
import System.FilePath (takeExtension)
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

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "train"
    "Train a network on images of symbols from a seed and write its weights; the default seed and \
    \regimen give the shipped weights of shipped shapes."
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
          "shipped (on rendered symbols, anew each round; default), or the paper's three stages on \
          \pressed ones, each ending at an error of 0 (stated), the clean ones at 0.1 (stopped), \
          \or at 0.1, 0.6 and 0.1 as in the toolbox's manual (manual)"
          (value AsShipped)
        <*> flag
          True
          False
          ( long "without-noise"
              <> help "No noisy images: of the paper's stages the middle one is left out"
          )
        <*> seedOption (value shippedSeed <> showDefault)
        <*> optionalFile "trace" "FILE.csv" "Write every epoch: error, gradient, rate and step"
        <*> flag
          True
          False
          ( long "uncalibrated"
              <> help
                "Do not press symbols to find how sure the network is: it is as sure as the \
                \shipped one"
          )
        <*> optionalFile
          "calibration"
          "FILE"
          "Write how sure the network is, as JSON has it, for weights as text"
        <*> fileOption "output" "FILE" "The file of weights: JSON if its name ends in .json"

run :: AlphabetChoice -> Options -> IO ExitStatus
run symbols options = do
  alphabet <- chosenAlphabet symbols
  orUnwritableAmong (output options : catMaybes [trace options, sureness options])
  (network, done) <- trainedAs (how options) alphabet options
  for_ (trace options) (`writeWhole` Lazy8.pack (traceCsv done))
  -- It takes presses, and so is found only where it is written, and once.
  let found
        | calibrating options =
          calibrated alphabet (templates alphabet) (outputs network) (seed options)
        | otherwise = Right (Right (calibrationFor alphabet))
      sure = orUnusable imagesMessage found >>= orUnusable networkMessage
  for_ (sureness options) $ \file ->
    sure >>= writeWhole file . Lazy.fromStrict . Text.encodeUtf8 . renderCalibration
  written <-
    if takeExtension (output options) == ".json"
      then do
        calibration <- sure
        let file = described alphabet network calibration
        pure (Lazy.fromStrict (encodeNetwork file) <> Lazy.singleton 10)
      else pure (Lazy.fromStrict (Text.encodeUtf8 (renderNetwork network)))
  writeWhole (output options) written
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

-- | How the network was trained, as its file has it.
regimenName :: Options -> String
regimenName options = named ++ (if noise options then "" else "-without-noise")
  where
    named = case how options of
      AsShipped -> "shipped"
      ByPaper training -> trainingName training

-- | The network, and its stages, each with its number: rounds, where it is trained as shipped.
trainedAs :: How -> Alphabet -> Options -> IO (Network, [(Int, Trace)])
trainedAs AsShipped alphabet options = do
  network <-
    orUnusable networkMessage
      =<< withProgress (toInteger (regimenRounds regimen)) 0 (`follow` counted training)
  -- Each round is a stage of its own, for its batch is.
  pure (network, zip [1 ..] (map snd (stepsDone training)))
  where
    training = trainingRounds regimen alphabet (seed options)
    regimen
      | noise options = regimenFor alphabet
      | otherwise = withoutNoise (regimenFor alphabet)
    withoutNoise r = r {stages = [s {stageNoise = [0]} | s <- stages r]}
trainedAs (ByPaper training) alphabet options = do
  images <- orUnusable imagesMessage (material (symbolsOf alphabet) source (seed options))
  let go = trainedBy standardConditions training (alphabetSize alphabet) images (seed options)
  done <- orUnusable networkMessage (go (if noise options then Noisy else NoMiddle))
  pure (runNetwork done, runStages done)
  where
    source = Presses (presetName Real) (presetSensor Real) (AmongTurns halfTurns)
