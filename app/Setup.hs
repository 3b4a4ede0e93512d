-- | What the touching commands start from: the shipped shapes and network.
module Setup
  ( shippedAlphabet,
    alphabetFor,
    chosenNetwork,
    networkOption,
  )
where

import Data.Text.Encoding (decodeUtf8')
import ExitStatus
import Files (readBytes)
import Message
import Options
import PraTactile.Classification.Network (Network, NetworkError (..))
import PraTactile.Classification.Network.File (parseNetwork, shippedNetwork)
import PraTactile.Profile (Profile (..))
import PraTactile.Shape (Alphabet, alphabetSize, paperAlphabet)

-- | The four shapes of @data/shapes.txt@.
shippedAlphabet :: IO Alphabet
shippedAlphabet = orUnusable shapeMessage paperAlphabet

-- | The same for an array that has as many symbols; leaves with status 2 where it has not.
alphabetFor :: Profile -> IO Alphabet
alphabetFor profile = do
  alphabet <- shippedAlphabet
  let shaped = fromIntegral (alphabetSize alphabet)
  if q == shaped
    then pure alphabet
    else
      unusable
        ( "the symbols of an array over GF(" ++ show q
            ++ ") have no shapes to be felt by; those of \
               \GF("
            ++ show shaped
            ++ ") have"
        )
  where
    q = profileOrder profile

-- | @--network FILE@.
networkOption :: Parser (Maybe FilePath)
networkOption =
  optional . fileOption "network" "FILE" $
    "Use the weights in a file, as 'train' writes it (default: the shipped ones)"

-- | The network in the file, or the shipped one.
chosenNetwork :: Maybe FilePath -> IO Network
chosenNetwork Nothing = orUnusable networkMessage shippedNetwork
chosenNetwork (Just file) =
  readBytes file
    >>= orUnusable (\e -> file ++ ": " ++ networkMessage e)
      . (either (const (Left NetworkNotText)) parseNetwork . decodeUtf8')
