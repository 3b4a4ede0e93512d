-- | @pra-tactile classify@: which symbol an image shows.
module Command.Classify
  ( command,
  )
where

import Control.Monad (when)
import Data.Bifunctor (first)
import qualified Data.ByteString.Char8 as Bytes
import ExitStatus
import FramesChoice (fullScaleOption)
import Lines
import Message
import Options
import PraTactile.Classification.Classifier
import PraTactile.Files (largestInput, readUpTo)
import PraTactile.Format.Classification
import PraTactile.Image (Raster, mapRaster, maximumValue, minimumValue)
import PraTactile.Source (frameOf)
import PraTactile.Symmetry
import Setup
import System.IO (hFlush, stdout)
import Text.Printf (printf)
import Visible (nameInJson, visible, visibleName)

data Options = Options
  { weights :: Maybe FilePath,
    method :: Method,
    levels :: (Double, Double),
    fullScale :: Maybe Double,
    form :: AnswerForm,
    -- | 'Nothing': paths on the standard input, one a line
    given :: Maybe [FilePath]
  }

command :: Subcommand
command =
  subcommand
    "classify"
    "Tell which symbol an 8 x 12 image shows"
    "Tell which symbol an 8 x 12 image shows, upright or upside down, and the probability of each \
    \symbol."
    []
    [ "pra-tactile classify images/0_0.pgm --levels 0.25,0.75",
      "pra-tactile classify images/0_0.pgm images/1_0.pgm --levels 0.25,0.75 --json",
      "ls images/*.pgm | pra-tactile classify --batch --levels 0.25,0.75 --classifier means"
    ]
    (run <$> alphabetChoice <*> options)
  where
    options =
      Options
        <$> networkOption
        <*> choosing
          "classifier"
          (allNamed methodName)
          "classifier"
          "network|means|logistic"
          "The network (default), the class mean with the highest correlation (means), or logistic \
          \regression (logistic)"
          (value ByNetwork)
        <*> option
          (pairReader ',' "0.25,0.75")
          ( long "levels"
              <> metavar "LOW,HIGH"
              <> value (0, 1)
              <> help
                "Values of a flat and of an embossed taxel, as shares of full scale (default: 0,1)"
          )
        <*> fullScaleOption
        <*> jsonSwitch "Print a line of JSON for each image"
        <*> ( flag'
                Nothing
                ( long "batch"
                    <> help
                      "Read the paths of images from the standard input, one a line"
                )
                <|> ( Just
                        <$> some
                          ( pathArgument
                              (metavar "IMAGE" <> action "file" <> help "Images of 8 x 12 pixels")
                          )
                    )
            )

run :: AlphabetChoice -> Options -> IO ExitStatus
run choice options
  | not (fst (levels options) < snd (levels options)) =
    misused "--levels must be two numbers, the lower one first"
  | method options /= ByNetwork && weights options /= Nothing =
    misused "--network is only for --classifier network"
  | otherwise = do
    alphabet <- chosenAlphabet choice
    -- The other classifiers need no network, so a missing network is no error.
    classifier <- case method options of
      ByMeans -> pure (meansClassifier (calibrationFor alphabet) alphabet)
      ByLogistic -> pure (logisticClassifier (calibrationFor alphabet) alphabet)
      ByNetwork -> networkClassifier <$> readerWith alphabet (weights options)
    let ask path = (>>= answered path) <$> imageIn (fullScale options) (levels options) path
        answered path = first (ofImage path . networkMessage) . classified classifier
        how = form options
        one path = ask path >>= orUnusable sentence >>= told how path
        next worst line = do
          path <- linePath line
          answer <- case lineText line of
            Left why | null path -> pure (Left (NoImage why why))
            _ -> ask path
          status <- either (invalid how path) (told how path) answer
          hFlush stdout
          pure (max worst status)
    case given options of
      Just paths -> maximum . (Answered :) <$> traverse one paths
      Nothing -> forLines next Answered

-- | The reason why a path gives no image of a symbol.
data NoImage = NoImage
  { -- | for output that names the file itself
    reason :: String,
    -- | as a complete sentence, with the name of the file
    sentence :: String
  }

-- | What is wrong with the image in a file.
ofImage :: FilePath -> String -> NoImage
ofImage path why = NoImage why (visibleName path ++ ": " ++ why)

-- | The image in a file, flat taxels at 0 and embossed ones at 1; or what is wrong with it.
imageIn :: Maybe Double -> (Double, Double) -> FilePath -> IO (Either NoImage Raster)
imageIn full (low, high) path
  | null path = pure (Left (NoImage nameless nameless))
  | otherwise = do
    bytes <- readUpTo largestInput path
    pure (first (\e -> NoImage (filesMessage e) (filesMessage e)) bytes >>= image)
  where
    nameless = "an empty line names no file"
    image bytes = do
      seen <-
        first
          (ofImage path . imageMessage)
          (fst <$> frameOf full Nothing bytes)
      when (minimumValue seen == maximumValue seen) $
        Left (ofImage path "all of its values are the same")
      Right (mapRaster (\v -> (v - low) / (high - low)) seen)

-- | Print what an image shows.
told :: AnswerForm -> FilePath -> Classification -> IO ExitStatus
told form' path shown = do
  case form' of
    AsJson -> Bytes.putStrLn (encodeClassification (nameInJson path) shown)
    AsText -> putStrLn (visibleName path ++ ": " ++ text)
  pure (if classifiedVerdict shown == Recognised then Answered else NotAnswered)
  where
    text = case classifiedSymbol shown of
      Just (c, turn) ->
        printf
          "symbol %d, %s (probability %.4f)"
          c
          (if turn == identity then "upright" else "upside down" :: String)
          (sum (take 1 (drop c (classifiedChances shown))))
      Nothing -> verdictName (classifiedVerdict shown)

-- | Print that a line gives no image of a symbol, and why.
invalid :: AnswerForm -> FilePath -> NoImage -> IO ExitStatus
invalid form' path why = do
  case form' of
    AsJson -> Bytes.putStrLn (encodeNoImage (nameInJson path) (sentence why))
    AsText -> putStrLn (visibleName path ++ ": invalid: " ++ visible (reason why))
  pure Unusable
