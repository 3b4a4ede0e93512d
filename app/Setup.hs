-- | What the touching commands start from: the shipped shapes, network and placement, and the array
-- of the profile.
module Setup
  ( shippedAlphabet,
    chosenNetwork,
    networkOption,
    placementFor,
  )
where

import Data.Text.Encoding (decodeUtf8')
import ExitStatus
import Files (readBytes)
import Json (shapeText)
import Message
import Options
import PraTactile.Classification.Network (Network, NetworkError (..))
import PraTactile.Classification.Network.File (parseNetwork, shippedNetwork)
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement
import PraTactile.Profile
import PraTactile.Shape (Alphabet, paperAlphabet)

-- | The four shapes of @data/shapes.txt@.
shippedAlphabet :: IO Alphabet
shippedAlphabet = orUnusable shapeMessage paperAlphabet

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

-- | The placement of the shipped objects, if the profile's array has the shape that they are laid
-- on.
placementFor :: Profile -> IO Placement
placementFor profile = do
  layout <- orUnusable placementMessage canonicalPlacement
  if placementShape layout == profileShape profile
    then pure layout
    else
      unusable
        ( "the objects are laid on an array of "
            ++ shapeText (placementShape layout)
            ++ "; the chosen one is "
            ++ shapeText (profileShape profile)
        )
