{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile probe@: press the simulated sensor on a face and write the frames.
module Command.Probe
  ( command,
  )
where

import ArrayChoice
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Tuple (swap)
import Described
import Drawing (hundredths)
import Ending
import Frames (frameFiles)
import Message
import Options.Applicative hiding (command)
import Output (orUnwritable, writeFolder, writeWhole)
import PraTactile.Explore
import PraTactile.Format (encodeTruth)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Probe (Frame (..), Pose (..), taxelPitch)
import PraTactile.Probe.Sensor (Sensor (..), standardSensor)
import PraTactile.Profile
import PraTactile.Recognise.Summary (orientationText)
import PraTactile.Relief
import PraTactile.Symmetry
import PraTactile.Truth (Truth (..))
import Setup
import System.Random (StdGen, mkStdGen, randomR)
import Text.Printf (printf)
import Visible

data Options = Options
  { object :: String,
    face :: Maybe String,
    at :: Maybe (Double, Double),
    size :: (Int, Int),
    orientation :: Maybe Symmetry,
    positionError :: Double,
    noise :: Double,
    seed :: Int,
    origin :: (Double, Double),
    tell :: Bool,
    truthFile :: Maybe FilePath,
    output :: FilePath
  }

command :: Mod CommandFields (IO Ending)
command =
  described
    "probe"
    "Press the simulated 16 x 16 sensor on an object's face and write the frames, as PGM files \
    \with a manifest, into a new folder."
    [ "pra-tactile probe --object cube --seed 7 --output frames",
      "pra-tactile probe --object cube --face 'C1 C2 C3 C4' --at 12.7,40 --upright --seed 1 \
      \--output frames",
      "pra-tactile probe --object cube --seed 7 --output frames --truth truth.json"
    ]
    (run <$> arrayChoice <*> options)
  where
    options =
      Options
        <$> strOption
          ( long "object"
              <> metavar "NAME"
              <> completeWith ["cube", "parallelepiped"]
              <> help "The object: cube or parallelepiped"
          )
        <*> optional
          ( strOption
              ( long "face"
                  <> metavar "VERTICES"
                  <> help "The face, as in 'C1 C2 C3 C4' (default: drawn by chance)"
              )
          )
        <*> optional
          ( option
              (pairReader ',' "12.7,40")
              ( long "at"
                  <> metavar "X,Y"
                  <> help
                    "The region's upper left corner on the face, mm to the right and down from \
                    \the face's upper left vertex (default: drawn by chance)"
              )
          )
        <*> option
          (pairReader 'x' "40x52")
          ( long "size"
              <> metavar "WIDTHxHEIGHT"
              <> value standardRegionSize
              <> help "The region in taxels (default 40x52)"
          )
        <*> optional
          ( flag'
              identity
              ( long "upright"
                  <> help
                    "The face lies upright in the robot's frame (default: so or turned by 180 \
                    \degrees, by chance)"
              )
              <|> flag' (turned 2) (long "turned" <> help "The face lies turned by 180 degrees")
              <|> option
                turnReader
                ( long "turn"
                    <> metavar "0|90|180|270"
                    <> completeWith (map fst turns)
                    <> help "The face lies turned clockwise by so many degrees"
                )
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
        <*> option intReader (long "seed" <> metavar "N" <> help "Seed of every random draw")
        <*> option
          (pairReader ',' "12.7,40")
          ( long "origin"
              <> metavar "X,Y"
              <> value (0, 0)
              <> help "The region's upper left corner in the robot's coordinates, mm (default 0,0)"
          )
        <*> switch (long "tell" <> help "Print the true place")
        <*> optional
          ( strOption
              ( long "truth"
                  <> metavar "FILE"
                  <> action "file"
                  <> help "Write the true place as JSON, for 'compare'"
              )
          )
        <*> strOption
          ( long "output"
              <> metavar "FOLDER"
              <> action "directory"
              <> help "A folder that is new or empty"
          )

turnReader :: ReadM Symmetry
turnReader = namedReader "quarter turn" turns

-- | The rotations by their degrees.
turns :: [(String, Symmetry)]
turns = [(show (degreesClockwise symmetry :: Int), symmetry) | symmetry <- rotations]

run :: ArrayChoice -> Options -> IO Ending
run choice options
  | not (positionError options >= 0 && positionError options < 1000) =
    unusable "--position-error is a number of taxels from 0 up"
  | not (noise options >= 0 && noise options < 1000) =
    unusable "--noise is a share of full scale from 0 up"
  | any (not . (< 1e6) . abs) [fst (origin options), snd (origin options)] =
    unusable "--origin is a place in millimetres"
  | otherwise = do
    for_ (truthFile options) orUnwritable
    profile <- chosenProfile choice
    layout <- placementFor profile
    alphabet <- shippedAlphabet
    faces <- objectsNamed layout (object options)
    (pressed, generator) <-
      maybe
        (drawnFace faces (mkStdGen (seed options)))
        (\named -> flip (,) (mkStdGen (seed options)) <$> chosenFace faces named)
        (face options)
    heights <-
      orUnusable reliefMessage
        =<< orUnusable
          profileMessage
          (withProfile profile (\array _ -> relief array layout alphabet pressed))
    (drawn, generator1) <-
      maybe
        (unusable (tooLarge pressed))
        pure
        (randomRegion (maybe halfTurns pure (orientation options)) (size options) pressed generator)
    let region = placed drawn
        sensor =
          standardSensor {sensorPositionError = positionError options, sensorNoise = noise options}
    if fits pressed region then pure () else unusable (tooLarge pressed)
    (frames, _) <- orUnusable probeMessage (explore sensor heights region generator1)
    writeFolder (output options) =<< orUnusable imageMessage (frameFiles (map moved frames))
    putStrLn
      ( "wrote "
          ++ show (length frames)
          ++ " frames and their manifest to "
          ++ visibleName (output options)
      )
    let known = Truth (laidFace pressed) region (origin options)
    for_
      (truthFile options)
      (\file -> writeWhole file (Lazy.fromStrict (encodeTruth known <> "\n")))
    if tell options then putStrLn (truth pressed region) else pure ()
    pure Answered
  where
    placed = maybe id atPlace (at options)
    moved frame =
      let pose =
            framePose frame
       in frame
            { framePose =
                pose
                  { poseX = poseX pose + fst (origin options),
                    poseY = poseY pose + snd (origin options)
                  }
            }
    atPlace (x, y) r = r {regionRight = x / taxelPitch, regionDown = y / taxelPitch}
    fits pressed region =
      regionRight region >= 0 && regionDown region >= 0
        && taxelPitch * (regionRight region + fromIntegral (fst (regionExtent region)))
          <= fromRational (spotRight (laidExtent pressed)) + 1e-9
        && taxelPitch * (regionDown region + fromIntegral (snd (regionExtent region)))
          <= fromRational (spotDown (laidExtent pressed)) + 1e-9
    tooLarge pressed =
      "the region, " ++ sizeText (both ((taxelPitch *) . fromIntegral) onTheFace)
        ++ maybe "" (\(x, y) -> " mm from " ++ hundredths x ++ "," ++ hundredths y) (at options)
        ++ " mm, does not lie on the face "
        ++ faceText (faceName (laidFace pressed))
        ++ ", which is "
        ++ sizeText (spotMillimetres (laidExtent pressed))
        ++ " mm; choose another --size or --at"
    onTheFace
      | maybe False exchangesAxes (orientation options) = swap (size options)
      | otherwise = size options
    sizeText (w, h) = hundredths w ++ " x " ++ hundredths h
    both f (a, b) = (f a, f b)

-- | One of the faces, with equal chances.
drawnFace :: [LaidFace] -> StdGen -> IO (LaidFace, StdGen)
drawnFace faces generator = case faces of
  [] -> unusable "the object has no face on the array"
  first : others ->
    let (i, generator1) = randomR (0, length others) generator
     in pure (pick i (first :| others), generator1)
  where
    pick i (a :| as) = case drop (i - 1) as of
      b : _ | i > 0 -> b
      _ -> a

truth :: LaidFace -> Region -> String
truth pressed region =
  unwords
    [ "truth: face",
      faceText (faceName (laidFace pressed)) ++ ", region from",
      uncurry (printf "%.2f,%.2f") (regionCorner region),
      "mm,",
      orientationText (regionSymmetry region)
    ]
