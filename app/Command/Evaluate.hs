{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile evaluate@: simulated presses by the thousand, counted right, wrong and refused.
module Command.Evaluate
  ( command,
  )
where

import ArrayChoice
import Command.Decode (toleranceComplaint, toleranceOptions)
import Command.Stitch (registrationFor)
import Control.Monad (foldM, unless)
import Control.Parallel.Strategies (parBuffer, rseq, withStrategy)
import Data.Aeson (Value, object, (.=))
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes)
import Data.String (fromString)
import Described
import Ending
import Json
import Message
import Options.Applicative hiding (command)
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Format.Profile
import PraTactile.Object.Placement
import PraTactile.Probe (planScan)
import PraTactile.Probe.Sensor (HeightMap, Sensor (..), standardSensor)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Relief
import PraTactile.Symmetry (Symmetry, rotations)
import Progress
import Setup
import Text.Printf (printf)

data Options = Options
  { presses :: Int,
    seed :: Int,
    size :: (Int, Int),
    positionError :: Double,
    noise :: Double,
    turns :: [Symmetry],
    tolerance :: Tolerance,
    network :: Maybe FilePath,
    asJson :: Bool
  }

command :: Mod CommandFields (IO Ending)
command =
  described
    "evaluate"
    "Simulate presses at random places on the faces in turn, and count how many are decoded \
    \right, wrong or refused, with stitching and without."
    [ "pra-tactile evaluate --presses 100 --seed 1",
      "pra-tactile evaluate --presses 100 --seed 1 --noise 0.3 --doubt 0.0001"
    ]
    (run <$> arrayChoice <*> options)
  where
    options =
      Options
        <$> option
          intReader
          ( long "presses"
              <> metavar "N"
              <> value 1000
              <> showDefault
              <> help "How many regions are explored"
          )
        <*> option
          intReader
          (long "seed" <> metavar "N" <> value 1 <> showDefault <> help "Seed of every random draw")
        <*> option
          (pairReader 'x' "40x52")
          ( long "size"
              <> metavar "WIDTHxHEIGHT"
              <> value standardRegionSize
              <> help "The region in taxels (default 40x52)"
          )
        <*> option
          decimalReader
          ( long "position-error"
              <> metavar "SIGMA"
              <> value (sensorPositionError standardSensor)
              <> showDefault
              <> help "Standard deviation of each frame's position, taxels, on both axes"
          )
        <*> option
          decimalReader
          ( long "noise"
              <> metavar "SD"
              <> value (sensorNoise standardSensor)
              <> showDefault
              <> help "Standard deviation of the noise, as a share of full scale"
          )
        <*> flag
          halfTurns
          rotations
          ( long "quarter-turns"
              <> help
                "The faces lie in any of four ways (default: upright or turned by 180 degrees)"
          )
        <*> toleranceOptions
        <*> networkOption
        <*> switch (long "json" <> help "Print the counts as JSON")

run :: ArrayChoice -> Options -> IO Ending
run choice options
  | presses options < 1 = unusable "--presses is a number from 1 up"
  | Just complaint <- toleranceComplaint (tolerance options) = unusable complaint
  | not (positionError options >= 0 && noise options >= 0) =
    unusable "--position-error and --noise are numbers from 0 up"
  | otherwise = do
    profile <- chosenProfile choice
    layout <- placementFor profile
    alphabet <- shippedAlphabet
    net <- chosenNetwork (network options)
    let prepared array mask = do
          reader <-
            either
              (Left . recogniserMessage)
              Right
              (recogniser (profileSurface profile) array mask layout alphabet net)
          faces <-
            either
              (Left . reliefMessage)
              Right
              ( traverse
                  (\face -> (,) face <$> relief array layout alphabet face)
                  (laidFaces layout)
              )
          pure (measure profile options reader faces)
    measured <- orUnusable profileMessage (withProfile profile prepared)
    either unusable id measured

-- | Run the trials on all cores, saying how far it is where a person looks on, and print the two
-- counts. Trials are made as they are needed and let go once counted, so that any number takes the
-- same memory.
measure ::
  KnownField k =>
  Profile ->
  Options ->
  Recogniser k ->
  [(LaidFace, HeightMap)] ->
  IO Ending
measure profile options reader faces = do
  _ <- orUnusable probeMessage (planScan frameSpacing (0, 0) (size options))
  unless
    (fitting (turns options) (size options) (map fst faces) (seed options) (presses options))
    (unusable tooLarge)
  (stitched, unstitched) <- withProgress (toInteger (presses options)) 0 $ \tell ->
    foldM
      (count tell)
      (noResults, noResults)
      (zip [1 ..] (withStrategy (parBuffer 32 rseq) (map run' (take (presses options) started))))
  let counts = [("stitching", stitched), ("no-stitching", unstitched)]
  if asJson options
    then
      printJson
        ( "schema" .= ("pra-tactile/evaluate/1" :: String) <> "profile" .= profileValue profile
            <> "presses" .= presses options
            <> "seed" .= seed options
            <> "position_error_taxels" .= positionError options
            <> "noise" .= noise options
            <> mconcat
              [fromString (map underscore name) .= tallyValue counted | (name, counted) <- counts]
        )
    else putStr (unlines (heading : [tallyText name counted | (name, counted) <- counts]))
  pure Answered
  where
    sensor =
      standardSensor {sensorPositionError = positionError options, sensorNoise = noise options}
    started = catMaybes (trials sensor (turns options) (size options) faces (seed options))
    run' =
      runTrial (tolerance options) reader (registrationFor (positionError options) (noise options))
    count :: (Integer -> IO ()) -> (Tally, Tally) -> (Integer, TrialResult) -> IO (Tally, Tally)
    count tell (stitched, unstitched) (i, outcome) =
      let stitched' = counting stitched (withStitching outcome)
          unstitched' = counting unstitched (withoutStitching outcome)
       in stitched' `seq` unstitched' `seq` tell i >> pure (stitched', unstitched')
    underscore c = if c == '-' then '_' else c
    tooLarge =
      printf
        "a region of %d x %d taxels does not lie on every face; choose a smaller --size"
        (fst (size options))
        (snd (size options))
    heading =
      printf
        "%d presses, seed %d, regions of %d x %d taxels, position error sigma %g taxels, noise sd \
        \%g of full scale"
        (presses options)
        (seed options)
        (fst (size options))
        (snd (size options))
        (positionError options)
        (noise options)

tallyText :: String -> Tally -> String
tallyText name counted =
  printf
    "%-13s right %d  wrong %d (expected: %.2g)  refused %d (%.1f %%)%s"
    name
    (tallyRight counted)
    (tallyWrong counted)
    (tallyExpected counted)
    refused
    share
    ( concat
        [ printf "%s %s %d" (if i == 0 then ":" else "," :: String) reason n
          | (i, (reason, n)) <- zip [0 :: Int ..] (Map.toAscList (tallyRefused counted))
        ] ::
        String
    )
  where
    refused = sum (tallyRefused counted)
    share =
      100
        * fromIntegral refused
        / fromIntegral (max 1 (refused + tallyRight counted + tallyWrong counted)) ::
        Double

tallyValue :: Tally -> Value
tallyValue counted =
  object
    [ "right" .= tallyRight counted,
      "wrong" .= tallyWrong counted,
      "wrong_expected" .= tallyExpected counted,
      "refused" .= sum (tallyRefused counted),
      "reasons"
        .= object [fromString reason .= n | (reason, n) <- Map.toAscList (tallyRefused counted)]
    ]
