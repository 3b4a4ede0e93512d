-- | Compares our traingdx with one in numpy (@bench/peers/traingdx.py@). From the same first
-- weights and images it checks that the errors and steps of 200 epochs are equal, and times 5000
-- epochs. It also times the outputs for 10^5 images on both sides (@bench/peers/outputs.py@).
--
-- usage: traingdx FOLDER [PYTHON]; the files that both read and write stay in the folder.
module Main (main) where

import Control.Monad (forM)
import qualified Data.ByteString.Char8 as Bytes
import Data.Foldable (toList)
import Data.List.NonEmpty (NonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import Numeric.LinearAlgebra (Matrix, sumElements, (><))
import PraTactile.Classification.Calibration (standardCalibration)
import PraTactile.Classification.Experiment
import PraTactile.Classification.Network
import PraTactile.Classification.NguyenWidrow
import PraTactile.Classification.Shipped (shippedAlphabet)
import PraTactile.Classification.Train
import PraTactile.Classification.Traingdx
import PraTactile.Experiment (material)
import PraTactile.Explore (Turns (..), halfTurns)
import PraTactile.Format.Network
import PraTactile.Image (Raster, mapRaster)
import PraTactile.Image.Pgm
import PraTactile.Sensor (Preset (..), presetSensor)
import PraTactile.SymbolImages
import System.CPUTime (getCPUTime)
import System.Directory (createDirectoryIfMissing)
import System.Environment (getArgs)
import System.FilePath ((</>))
import System.Process (readProcess)
import System.Random (mkStdGen)
import Text.Printf (printf)

main :: IO ()
main = do
  arguments <- getArgs
  case arguments of
    [folder] -> compared folder "python3"
    [folder, python] -> compared folder python
    _ -> putStrLn "usage: traingdx FOLDER [PYTHON], a Python that has numpy"

compared :: FilePath -> FilePath -> IO ()
compared folder python = do
  alphabet <- orFail (shippedAlphabet 4)
  clean <- orFail (material (symbolsOf alphabet) pressedByReal 1)
  (first, _) <- orFail (firstNetwork unitRanges 8 4 (mkStdGen 1))
  createDirectoryIfMissing True (folder </> "images")
  Bytes.writeFile
    (folder </> "first.json")
    ( encodeNetwork
        (NetworkFile first (alphabetDigest alphabet) (standardCalibration 4) (Just 1) Nothing)
    )
  let two = materialFirst clean
      images = middleImages Stated Noisy two (two ++ two) (mkStdGen 2)
  read' <- mapM (written (folder </> "images")) (zip [0 ..] images)
  writeFile
    (folder </> "images" </> "labels.csv")
    (unlines ("file,class" : [name ++ "," ++ show c | (name, _, c) <- read']))
  b <- orFail (batch 4 [(image, Just c) | (_, image, c) <- read'])
  printf "%d images\n" (batchSize b)
  same first b 0.01
  same first b 0.2
  timed first b
  answered first
  where
    pressedByReal = Presses "real" (presetSensor Real) (AmongTurns halfTurns)
    unitRanges = NguyenWidrow (replicate inputCount (0, 1)) 1
    peer more =
      readProcess
        python
        ( ["bench/peers/traingdx.py", folder </> "first.json", folder </> "images"]
            ++ [folder </> "trace.csv"]
            ++ more
        )
        ""
    run first b rule = orFail (fst' (trainingEpochs rule b first)) :: IO (NonEmpty (Epoch ()))
    fst' = fmap traced
    same first b rate = do
      ours <- run first b toolboxDescent {epochs = 200, initialRate = rate}
      _ <- peer ["--epochs", "200", "--rate", show rate]
      theirs <- map cells . drop 1 . lines . filter (/= '\r') <$> readFile (folder </> "trace.csv")
      let errors = map epochError (drop 1 (toList ours))
          steps = map (outcomeName . epochOutcome) (drop 1 (toList ours))
      printf
        "rate %g: %d and %d epochs, errors apart by at most %.1e, undone %d; the same steps: %s\n"
        rate
        (length errors)
        (length theirs)
        (maximum (zipWith (\e cell -> abs (e - read (cell !! 1))) errors theirs) :: Double)
        (length (filter (== "undone") steps))
        (show (steps == map (!! 4) theirs))
    timed first b = do
      rounds <- forM [5000 .. 5004] $ \count -> do
        start <- getCPUTime
        -- One more epoch each time, so that the result is not already evaluated.
        ours <- run first b toolboxDescent {leastGradient = 0, epochs = count}
        end <- epochNumber (NonEmpty.last ours) `seq` getCPUTime
        (,) (end - start) <$> peer ["--least", "0"]
      bestOf rounds "5000 epochs"
      readProcess python ["bench/peers/epochs.py", folder </> "first.json", folder </> "images"] ""
        >>= putStr
    answered n = do
      rounds <- forM [1 .. 5] $ \seed -> do
        let images = generated seed
        start <- sumElements images `seq` getCPUTime
        let total = sumElements (outputsOfAll n images)
        end <- total `seq` getCPUTime
        told <- readProcess python ("bench/peers/outputs.py" : asked seed) ""
        case words told of
          [took, theirs] | abs (read theirs / total - 1) < 1e-12 -> pure (end - start, took)
          _ -> fail ("outputs add up to " ++ show total ++ ", and by numpy: " ++ told)
      bestOf rounds ("outputs for " ++ show many ++ " images")
    asked seed = [folder </> "first.json", show many, show seed]
    generated :: Int -> Matrix Double
    generated seed = (inputCount >< many) (map value [seed .. seed + inputCount * many - 1])
    value k = fromIntegral (k * 2654435761 `mod` 4294967296) / 4294967296
    bestOf rounds what =
      printf
        "%s, the best of %d, seconds of the processor: ours %.3f, numpy %.3f\n"
        (what :: String)
        (length rounds)
        (fromIntegral (minimum (map fst rounds)) / 1e12 :: Double)
        (minimum (map (read . snd) rounds) :: Double)
    many = 100000 :: Int
    cells line = case break (== ',') line of
      (cell, _ : rest) -> cell : cells rest
      (cell, []) -> [cell]

-- | Writes an image to a file; returns it as it is read back.
written :: FilePath -> (Int, (Raster, Int)) -> IO (FilePath, Raster, Int)
written folder (i, (image, c)) = do
  pgm <- orFail (pgmFromIntensity 65535 (mapRaster (\v -> 0.25 + 0.5 * v) image))
  Bytes.writeFile (folder </> name) (encodePgm Binary pgm)
  pure (name, mapRaster (\v -> (v - 0.25) / 0.5) (pgmIntensity pgm), c)
  where
    name = show c ++ "_" ++ show i ++ ".pgm"

orFail :: Show e => Either e a -> IO a
orFail = either (fail . show) pure
