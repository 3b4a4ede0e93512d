-- | The one place where the program chooses its shapes: those shipped for as many symbols as a
-- field has elements, or those of a drawing file; and the network that reads them.
module Setup
  ( -- * Shapes alone
    AlphabetChoice,
    alphabetChoice,
    chosenAlphabet,
    readAlphabet,
    orderOf,

    -- * Shapes for an array
    ReaderChoice,
    shapesOption,
    alphabetFor,
    readerChoice,
    readerFor,
  )
where

import ExitStatus
import Files (readBytes)
import Message
import Numeric.Natural (Natural)
import Options
import PraTactile.Classification.Estimate (standardRegression)
import PraTactile.Classification.Network (Network)
import PraTactile.Classification.Network.File (decodeNetwork)
import PraTactile.Classification.Reader
import PraTactile.Classification.Shipped
import PraTactile.Field.Named (conwayModulus)
import PraTactile.Profile (Profile (..))
import PraTactile.Shape (Alphabet, alphabetSize, decodeAlphabet, shapes)
import Visible (visibleName)

-- | Which shapes are meant where no array says it.
data AlphabetChoice
  = -- | those shipped for the elements of the field of this order
    OfOrder Natural
  | DrawnIn FilePath

-- | @--q Q@, 4 where nothing is said, or @--shapes FILE@.
alphabetChoice :: Parser AlphabetChoice
alphabetChoice =
  DrawnIn <$> shapesFile
    <|> OfOrder
      <$> defaulting
        4
        naturalReader
        "q"
        "Q"
        "The shapes shipped for the elements of GF(q)"

-- | The shapes; leaves with status 2 where there are none.
chosenAlphabet :: AlphabetChoice -> IO Alphabet
chosenAlphabet choice = case choice of
  OfOrder q -> alphabetOfOrder q
  DrawnIn file -> readAlphabet file

-- | The order of the field whose elements the shapes are for, where no file has them.
orderOf :: AlphabetChoice -> Maybe Natural
orderOf choice = case choice of
  OfOrder q -> Just q
  DrawnIn _ -> Nothing

-- | The shapes of a drawing file.
readAlphabet :: FilePath -> IO Alphabet
readAlphabet file =
  readBytes file
    >>= orUnusable (\e -> visibleName file ++ ": " ++ shapeMessage e) . decodeAlphabet

-- | The shapes shipped for a field's elements.
alphabetOfOrder :: Natural -> IO Alphabet
alphabetOfOrder q = do
  _ <- orUnusable fieldMessage (conwayModulus q)
  orUnusable shippedMessage (shippedAlphabet (fromIntegral q))

-- | @--shapes FILE@ for an array.
shapesOption :: Parser (Maybe FilePath)
shapesOption = optional shapesFile

shapesFile :: Parser FilePath
shapesFile =
  fileOption
    "shapes"
    "FILE"
    "The shapes drawn in a file, as 'shapes --design' writes it, in place of those shipped"

-- | The shapes of an array's symbols, one an element: those in the file, or those shipped. Leaves
-- with status 2 where they are not as many.
alphabetFor :: Maybe FilePath -> Profile -> IO Alphabet
alphabetFor Nothing profile = alphabetOfOrder (profileOrder profile)
alphabetFor (Just file) profile = do
  alphabet <- readAlphabet file
  if fromIntegral (alphabetSize alphabet) == profileOrder profile
    then pure alphabet
    else
      unusable
        ( visibleName file ++ " has "
            ++ show (alphabetSize alphabet)
            ++ " shapes; the array has symbols of GF("
            ++ show (profileOrder profile)
            ++ ")"
        )

-- | Files of shapes and of weights.
data ReaderChoice = ReaderChoice (Maybe FilePath) (Maybe FilePath)

-- | @--shapes FILE@ and @--network FILE@.
readerChoice :: Parser ReaderChoice
readerChoice =
  ReaderChoice
    <$> shapesOption
    <*> optionalFile
      "network"
      "FILE"
      "Use the weights in a file, as 'train' writes it (default: the shipped ones)"

-- | What an array's symbols are read with. The shipped networks know the shipped shapes only.
readerFor :: ReaderChoice -> Profile -> IO Reader
readerFor (ReaderChoice drawn weights) profile = do
  alphabet <- alphabetFor drawn profile
  network <- maybe (shippedFor alphabet) readNetwork weights
  pure (readerOf alphabet network) {readerRegression = sure (alphabetSize alphabet)}
  where
    sure = either (const standardRegression) id . shippedRegression
    shippedFor alphabet
      | (shapes <$> shippedAlphabet (alphabetSize alphabet)) == Right (shapes alphabet) =
        orUnusable shippedMessage (shippedNetwork (alphabetSize alphabet))
      | otherwise =
        unusable
          "no shipped network knows these shapes; let 'train --shapes FILE' learn them, and give \
          \its weights by --network"

-- | The network in a file.
readNetwork :: FilePath -> IO Network
readNetwork file =
  readBytes file
    >>= orUnusable (\e -> visibleName file ++ ": " ++ networkMessage e) . decodeNetwork
