-- | @pra-tactile train@: train the network from a seed, as the shipped one was.
module Command.Train
  ( command,
  )
where

import Control.Monad (forM_)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Text.Encoding as Text
import ExitStatus
import Message
import Options
import Output
import PraTactile.Classification.Network.File (renderNetwork)
import PraTactile.Classification.Regimen
  ( regimenFor,
    regimenRounds,
    shippedSeed,
    trainingRounds,
  )
import PraTactile.Classification.Train (Progress (..))
import PraTactile.Steps (counted, stepsDone)
import Progress
import Setup
import Text.Printf (printf)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "train"
    "Train a network on rendered symbols from a seed and write its weights; the default \
    \seed gives the shipped weights of shipped shapes."
    ["pra-tactile train --output network.txt"]
    ( run
        <$> alphabetChoice
        <*> seedOption (value shippedSeed <> showDefault)
        <*> fileOption "output" "FILE" "The file of weights"
    )

run :: AlphabetChoice -> Int -> FilePath -> IO ExitStatus
run symbols seed output = do
  alphabet <- chosenAlphabet symbols
  let regimen = regimenFor alphabet
      training = trainingRounds regimen alphabet seed
  network <-
    orUnusable networkMessage
      =<< withProgress (toInteger (regimenRounds regimen)) 0 (`follow` counted training)
  writeWhole output (Lazy.fromStrict (Text.encodeUtf8 (renderNetwork network)))
  forM_ (zip [1 :: Int ..] (stepsDone training)) $ \(i, stage) ->
    putStrLn
      ( printf
          "stage %d: %d epochs, squared error %.4f -> %.4f"
          i
          (progressEpochs stage)
          (errorBefore stage)
          (errorAfter stage)
      )
  sayWritten output ""
  pure Answered
