-- | @pra-tactile network@: what a network is, and its weights as JSON for other languages.
module Command.Network
  ( command,
  )
where

import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.Maybe (fromMaybe)
import ExitStatus
import Options
import Output
import PraTactile.Classification.Network
import PraTactile.Format.Network
import Setup

command :: Subcommand
command =
  subcommand
    "network"
    "Describe a network, or write its weights as JSON"
    "Describe the network of a set of shapes, the shipped one or that of a file, and write its \
    \weights as JSON."
    []
    [ "pra-tactile network",
      "pra-tactile network data/network.txt --output network.json",
      "pra-tactile network --q 9 --json"
    ]
    ( run
        <$> alphabetChoice
        <*> optional
          ( pathArgument
              ( metavar "FILE" <> action "file"
                  <> help
                    "A file of weights (default: the shipped ones)"
              )
          )
        <*> jsonSwitch "Print the weights as JSON"
        <*> outputFileOption' "Write the weights to this file, as JSON"
    )
  where
    outputFileOption' = optionalFile "output" "FILE"

run :: AlphabetChoice -> Maybe FilePath -> AnswerForm -> Maybe FilePath -> IO ExitStatus
run symbols weights form output = do
  alphabet <- chosenAlphabet symbols
  file <- networkFor alphabet weights
  for_ output $ \name -> do
    writeWhole name (Lazy.fromStrict (encodeNetwork file) <> Lazy.singleton 10)
    sayWritten name ""
  case form of
    AsJson -> Bytes.putStrLn (encodeNetwork file)
    AsText | output == Nothing -> putStr (told file)
    AsText -> pure ()
  pure Answered

told :: NetworkFile -> String
told file =
  unlines
    [ show inputCount ++ " inputs, " ++ show (hiddenCount n) ++ " hidden units, "
        ++ show (outputCount n)
        ++ " outputs, sigmoid",
      "regimen  " ++ fromMaybe "not stated" (fileRegimen file)
        ++ foldMap (\seed -> ", seed " ++ show seed) (fileSeed file),
      "shapes   " ++ fileAlphabet file
    ]
  where
    n = fileNetwork file
