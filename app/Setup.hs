-- | The choice of shapes, those shipped for the elements of a field or those of a drawing file, and
-- of the network that reads them.
module Setup
  ( -- * Shapes alone
    AlphabetChoice,
    alphabetChoice,
    chosenAlphabet,
    alphabetGiven,
    readDrawings,
    orderOf,

    -- * Shapes for an array
    ReaderChoice,
    shapesOption,
    alphabetFor,
    readerChoice,
    readerFor,

    -- * Networks
    networkOption,
    readerWith,
    networkFor,
    calibrationFor,
    shippedAlphabets,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (isSpace)
import Data.Either (fromRight)
import ExitStatus
import Files (readBytes, readBytesUpTo)
import Message
import Numeric.Natural (Natural)
import Options
import PraTactile.Classification.Calibration (Calibration, standardCalibration)
import PraTactile.Classification.Network (NetworkError (WrongOutputCount), outputCount)
import PraTactile.Classification.Network.File (decodeNetwork)
import PraTactile.Classification.Reader
import PraTactile.Classification.Regimen (shippedSeed)
import PraTactile.Classification.Shipped
import PraTactile.Field.Named (conwayModulus)
import PraTactile.Format.Network
import PraTactile.PlainText (withoutMark)
import PraTactile.Profile (Profile (..))
import PraTactile.Shape hiding (alphabet)
import Visible (visibleName)

-- | The choice of shapes for commands that know no array.
data AlphabetChoice
  = -- | no option: those shipped for GF(4)
    Usual
  | -- | those shipped for the elements of the field of this order
    OfOrder Natural
  | DrawnIn FilePath

-- | @--q Q@, by default 4, or @--shapes FILE@.
alphabetChoice :: Parser AlphabetChoice
alphabetChoice =
  DrawnIn <$> shapesFile
    <|> OfOrder
      <$> valued
        naturalReader
        "q"
        "Q"
        ("Use the shapes shipped for the elements of GF(q) (default: " ++ show usualOrder ++ ")")
    <|> pure Usual

-- | The order of the field whose shapes are the default.
usualOrder :: Natural
usualOrder = 4

-- | The options that choose shapes, and whether they were given.
alphabetGiven :: AlphabetChoice -> [(String, Bool)]
alphabetGiven choice = case choice of
  Usual -> []
  OfOrder _ -> [("--q", True)]
  DrawnIn _ -> [("--shapes", True)]

-- | The chosen shapes; leaves with status 2 if there are none.
chosenAlphabet :: AlphabetChoice -> IO Alphabet
chosenAlphabet choice = case choice of
  Usual -> alphabetOfOrder usualOrder
  OfOrder q -> alphabetOfOrder q
  DrawnIn file -> readAlphabet file

-- | The order of the field whose elements the shapes are for, unless they come from a file.
orderOf :: AlphabetChoice -> Maybe Natural
orderOf choice = case choice of
  Usual -> Just usualOrder
  OfOrder q -> Just q
  DrawnIn _ -> Nothing

-- | The shapes of a drawing file.
readAlphabet :: FilePath -> IO Alphabet
readAlphabet = readShapes decodeAlphabet

-- | The drawings in a file, also of shapes that an alphabet cannot have.
readDrawings :: FilePath -> IO Drawings
readDrawings = readShapes decodeDrawings

readShapes :: (ByteString -> Either ShapeError a) -> FilePath -> IO a
readShapes decoded file =
  readBytes file
    >>= orUnusable (\e -> visibleName file ++ ": " ++ shapeMessage e) . decoded

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
    "Use the shapes drawn in this file, as 'shapes --design' writes it, in place of the shipped \
    \ones"

-- | The shapes of an array's symbols, one for each element: those in the file, or the shipped ones.
-- Leaves with status 2 if their number differs from q.
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
  ReaderChoice <$> shapesOption <*> networkOption

-- | The reader of an array's symbols.
readerFor :: ReaderChoice -> Profile -> IO Reader
readerFor (ReaderChoice drawn weights) profile =
  alphabetFor drawn profile >>= (`readerWith` weights)

-- | The reader of an alphabet: the weights in the file, or the shipped ones, with their
-- calibration.
readerWith :: Alphabet -> Maybe FilePath -> IO Reader
readerWith alphabet weights = do
  file <- networkFor alphabet weights
  pure (readerOf alphabet (fileNetwork file)) {readerCalibration = fileCalibration file}

-- | The calibration of an alphabet without a file: that of the shipped alphabet of the same size.
calibrationFor :: Alphabet -> Calibration
calibrationFor alphabet = fromRight (standardCalibration q) (shippedCalibration q)
  where
    q = alphabetSize alphabet

-- | All alphabets that are shipped.
shippedAlphabets :: [Alphabet]
shippedAlphabets = [a | Right a <- map shippedAlphabet shippedSizes]

-- | @--network FILE@.
networkOption :: Parser (Maybe FilePath)
networkOption =
  optionalFile
    "network"
    "FILE"
    "Use the weights in this file, as 'train' writes it (default: the shipped ones)"

-- | The network that reads an alphabet, from a file in either form, or the shipped one, which knows
-- only the shipped shapes. Leaves with status 2 if a file holds no network, or one for other
-- shapes; weights as text do not name their shapes.
networkFor :: Alphabet -> Maybe FilePath -> IO NetworkFile
networkFor alphabet weights = case weights of
  Just file -> do
    bytes <- readBytesUpTo (64 * 1024 * 1024) file
    if Bytes.take 1 (Bytes.dropWhile isSpace (withoutMark bytes)) == Bytes.singleton '{'
      then asJson file bytes
      else asText file bytes
  Nothing
    | (shapes <$> shippedAlphabet q) == Right (shapes alphabet) ->
      stated (Just shippedSeed) (Just "shipped") <$> orUnusable shippedMessage (shippedNetwork q)
    | otherwise ->
      unusable
        "no shipped network knows these shapes; train one by 'train --shapes FILE', and give its \
        \weights by --network"
  where
    q = alphabetSize alphabet
    own = alphabetDigest alphabet
    inFile file why = visibleName file ++ ": " ++ why
    stated seed regimen n = NetworkFile n own sure seed regimen
    sure = calibrationFor alphabet
    asText file bytes = do
      n <- orUnusable (inFile file . networkMessage) (decodeNetwork bytes)
      if outputCount n == q
        then pure (stated Nothing Nothing n)
        else unusable (inFile file (networkMessage (WrongOutputCount (outputCount n) q)))
    asJson file bytes = do
      given <-
        orUnusable
          (formatMessage file "weights as 'pra-tactile train' and 'network' write them")
          (decodeNetworkFile bytes)
      if fileAlphabet given == own
        then pure given
        else
          unusable
            (inFile file ("it was trained on other shapes than the " ++ show q ++ " in use"))
