-- | @pra-tactile images@: images of symbols whose truth is known, as files for anyone's classifier.
module Command.Images
  ( command,
    ImageChoice (..),
    imageChoice,
    chosenImages,
  )
where

import qualified Data.ByteString.Char8 as Bytes
import Data.Maybe (fromMaybe)
import ExitStatus
import Memory (orTooMuch)
import Message
import Options
import Output (orTaken, writeFolder)
import PraTactile.Classification.Experiment (allWithNoise)
import PraTactile.Explore (Turns (..), halfTurns)
import PraTactile.Geometry (symbolHeight, symbolWidth)
import PraTactile.Image (Raster, mapRaster)
import PraTactile.Image.Error (ImageError)
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, pgmFromIntensity)
import PraTactile.Sensor (Preset (..), presetName)
import PraTactile.Shape (alphabetSize)
import PraTactile.Shape.Design (foreignShapes)
import PraTactile.SymbolImages
import Progress
import SensorChoice (readSensor, sensorOption)
import Setup
import Visible (visibleName)

-- | The options about the images.
data ImageChoice = ImageChoice
  { imagesPressed :: Bool,
    -- | a preset's name, or a file's
    imagesSensor :: Maybe String,
    imagesAnyAngle :: Bool
  }

-- | @--set@, @--sensor@ and @--any-angle@, given the default of @--set@ as a property.
imageChoice :: Mod OptionFields Bool -> Parser ImageChoice
imageChoice standard =
  ImageChoice
    <$> choosing
      "set of images"
      [("bitmap", False), ("press", True)]
      "set"
      "bitmap|press"
      "What the images are: the shapes themselves (bitmap), or crops of pressed and stitched \
      \frames, made as by 'decode' (press)"
      standard
    <*> optional
      ( sensorOption
          "The sensor that presses: ideal, paper, real, hard, or a file as 'sensor --json' prints \
          \it (default: real)"
      )
    <*> switch (long "any-angle" <> help "The pressed plates lie turned by any angle")

-- | The source of the images; leaves with status 2 if there is no such sensor.
chosenImages :: ImageChoice -> IO ImageSource
chosenImages choice
  | imagesPressed choice = do
    sensor <- readSensor name
    pure (Presses name sensor (if imagesAnyAngle choice then AnyAngle else AmongTurns halfTurns))
  | imagesSensor choice /= Nothing || imagesAnyAngle choice =
    misused "--sensor and --any-angle need --set press"
  | otherwise = pure Bitmaps
  where
    name = fromMaybe (presetName Real) (imagesSensor choice)

data Options = Options
  { images :: ImageChoice,
    count :: Int,
    noise :: Double,
    foreignTo :: Maybe Int,
    seed :: Int,
    output :: FilePath
  }

command :: Subcommand
command =
  subcommand
    "images"
    "Write images of symbols with their classes"
    "Write 8 x 12 images of symbols with their classes into a new folder, as 16-bit PGM files. A \
    \flat taxel is 0.25 of full scale, an embossed one 0.75."
    []
    [ "pra-tactile images --set bitmap --count 10 --image-noise 0.2 --seed 1 --output images",
      "pra-tactile images --set press --sensor hard --count 10 --seed 1 --output pressed"
    ]
    (run <$> alphabetChoice <*> options)
  where
    options =
      Options
        <$> imageChoice mempty
        <*> valued intReader "count" "N" "Number of images of each class"
        <*> orAlias
          "noise"
          decimalReader
          mempty
          ( defaulting
              0
              decimalReader
              "image-noise"
              "SD"
              "Standard deviation of the white noise that is added to the images"
          )
        <*> optional
          ( orAlias "foreign" intReader mempty $
              valued
                intReader
                "foreign-shapes"
                "D"
                "Draw other shapes in place of the symbols, at least D taxels from each of them, \
                \also turned or mirrored: N images in all, of class -1"
          )
        <*> seedOption mempty
        <*> folderOption "output" "A folder that is new or empty"

run :: AlphabetChoice -> Options -> IO ExitStatus
run choice options
  | count options < 1 || count options > 100000 =
    misused
      "--count must be a number from 1 to 100000"
  | not (noise options >= 0 && noise options <= 100) =
    misused "--image-noise must be a standard deviation from 0 to 100"
  | any (\d -> d < 0 || d > symbolWidth * symbolHeight) (foreignTo options) =
    misused "--foreign-shapes must be a number of taxels from 0 to 96"
  | otherwise = do
    orTaken (output options)
    source <- chosenImages (images options)
    alphabet <- chosenAlphabet choice
    drawn <- maybe (ours alphabet) (others alphabet) (foreignTo options) >>= found source
    files <- orUnusable imageMessage (traverse file (numbered (noisy (fst drawn))))
    writeFolder (output options) (("labels.csv", labels (map fst files)) : map snd files)
    putStrLn
      ( "wrote " ++ show (length files) ++ " images and labels.csv to "
          ++ visibleName (output options)
          ++ snd drawn
      )
    pure Answered
  where
    ours alphabet = pure (symbolsOf alphabet, id, count options)
    -- Frames are stitched by the lattice of the chosen symbols; this many foreign shapes take
    -- their places.
    others alphabet least = do
      foreign' <- orUnusable shapeMessage (foreignShapes (seed options) least kinds alphabet)
      pure
        ( (symbolsOf alphabet) {symbolShapes = foreign'},
          const (-1),
          (count options + kinds - 1) `div` kinds
        )
    kinds = 16
    -- The memory of an image, of its file with its name, and of its line of labels.
    bytesEach = 1500
    found source (symbols, label, each) = do
      let wantedCount = each * alphabetSize (symbolShapes symbols)
      orTooMuch
        (show wantedCount ++ " images")
        "take a smaller --count"
        (bytesEach * toInteger wantedCount)
      made <-
        orUnusable imagesMessage
          =<< withProgress
            (unevenly wantedCount "images")
            (`follow` labelledSteps symbols source each (seed options))
      let all' = [(image, label c) | (image, c) <- labelledAs made]
          wanted = if foreignTo options == Nothing then all' else take (count options) all'
      pure (wanted, lost source made)
    lost source made = case source of
      Bitmaps -> ""
      Presses {} ->
        "; of " ++ show (labelledPresses made) ++ " presses, "
          ++ show (labelledLost made)
          ++ " whole symbols not found"
    noisy list
      | noise options > 0 = allWithNoise (noise options) (seed options) list
      | otherwise = list

-- | Each image with its class and its number within that.
numbered :: [(Raster, Int)] -> [(Raster, Int, Int)]
numbered list =
  [(image, c, i) | c <- classes, (i, image) <- zip [0 ..] [image | (image, c') <- list, c' == c]]
  where
    classes = [minimum (0 : map snd list) .. maximum (-1 : map snd list)]

file :: (Raster, Int, Int) -> Either ImageError ((FilePath, Int), (FilePath, Bytes.ByteString))
file (image, c, i) = do
  pgm <- pgmFromIntensity 65535 (mapRaster (\v -> 0.25 + 0.5 * v) image)
  pure ((name, c), (name, encodePgm Binary pgm))
  where
    name = show c ++ "_" ++ show i ++ ".pgm"

labels :: [(FilePath, Int)] -> Bytes.ByteString
labels files = Bytes.pack (unlines ("file,class" : [name ++ "," ++ show c | (name, c) <- files]))
