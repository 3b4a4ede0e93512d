{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile probe@: press the simulated sensor on a face and write the frames.
module Command.Probe
  ( command,
  )
where

import ArrayChoice
import Control.Monad (when)
import Data.Bifunctor (bimap)
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Tuple (swap)
import Drawing (hundredths)
import ExitStatus
import Frames (frameFiles)
import Message
import Options
import Output (orUnwritable, writeFolder, writeWhole)
import PraTactile.Explore
import PraTactile.Format (encodeTruth)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Probe (Frame (..), Pose (..), taxelPitch)
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
    -- | quarter turns
    orientation :: Maybe Symmetry,
    sensor :: SensorChoice,
    seed :: Int,
    origin :: (Double, Double),
    announced :: Announced,
    truthFile :: Maybe FilePath,
    output :: FilePath
  }

-- | Whether the true place is printed.
data Announced = Announced | Unannounced
  deriving stock (Eq)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "probe"
    "Press the simulated 16 x 16 sensor on an object's face and write the frames, as PGM files \
    \with a manifest, into a new folder."
    [ "pra-tactile probe --object cube --seed 7 --output frames",
      "pra-tactile probe --object cube --face 'C1 C2 C3 C4' --at 12.7,40 --upright --seed 1 \
      \--output frames",
      "pra-tactile probe --object cube --seed 7 --output frames --truth truth.json"
    ]
    (run <$> arrayChoice <*> optionsParser)

optionsParser :: Parser Options
optionsParser =
  Options
    <$> strOption
      ( long "object"
          <> metavar "NAME"
          <> completeWith ["cube", "parallelepiped"]
          <> help "The object: cube or parallelepiped"
      )
    <*> optional
      (valued str "face" "VERTICES" "The face, as in 'C1 C2 C3 C4' (default: drawn by chance)")
    <*> optional
      ( valued
          place
          "at"
          "X,Y"
          "The region's upper left corner on the face, mm to the right and down from the face's \
          \upper left vertex (default: drawn by chance)"
      )
    <*> sizeOption
    <*> optional turnOption
    <*> sensorOptions
    <*> seedOption mempty
    <*> option
      place
      ( long "origin"
          <> metavar "X,Y"
          <> value (0, 0)
          <> help "The region's upper left corner in the robot's coordinates, mm (default 0,0)"
      )
    <*> flag Unannounced Announced (long "tell" <> help "Print the true place")
    <*> optionalFile "truth" "FILE" "Write the true place as JSON, for 'compare'"
    <*> strOption
      ( long "output"
          <> metavar "FOLDER"
          <> action "directory"
          <> help "A folder that is new or empty"
      )
  where
    place = pairReader ',' "12.7,40"

-- | How the face lies turned.
turnOption :: Parser Symmetry
turnOption =
  flag'
    identity
    ( long "upright"
        <> help
          "The face lies upright in the robot's frame (default: so or turned by 180 degrees, by \
          \chance)"
    )
    <|> flag' (turned 2) (long "turned" <> help "The face lies turned by 180 degrees")
    <|> choosing
      "quarter turn"
      [(show (degreesClockwise symmetry :: Int), symmetry) | symmetry <- rotations]
      "turn"
      "0|90|180|270"
      "The face lies turned clockwise by so many degrees"
      mempty

run :: ArrayChoice -> Options -> IO ExitStatus
run choice options
  | not (positionSigma (sensor options) >= 0 && positionSigma (sensor options) < 1000) =
    unusable "--position-error is a number of taxels from 0 up"
  | not (noiseSd (sensor options) >= 0 && noiseSd (sensor options) < 1000) =
    unusable "--noise is a share of full scale from 0 up"
  | any (not . (< 1e6) . abs) [fst (origin options), snd (origin options)] =
    unusable "--origin is a place in millimetres"
  | otherwise = do
    for_ (truthFile options) orUnwritable
    profile <- chosenProfile choice
    layout <- placementFor profile
    alphabet <- shippedAlphabet
    faces <- objectsNamed layout (object options)
    (pressed, generator) <- pressedFace options faces
    heights <-
      orUnusable reliefMessage
        =<< orUnusable
          profileMessage
          (withProfile profile (\array _ -> relief array layout alphabet pressed))
    (region, generator1) <- pressedRegion options pressed generator
    (frames, _) <-
      orUnusable probeMessage (explore (chosenSensor (sensor options)) heights region generator1)
    written options frames (Truth (laidFace pressed) region (origin options))
    pure Answered

-- | The face asked for, or one drawn with equal chances.
pressedFace :: Options -> [LaidFace] -> IO (LaidFace, StdGen)
pressedFace options faces = case face options of
  Nothing -> drawnFace faces generator
  Just vertices -> flip (,) generator <$> chosenFace faces vertices
  where
    generator = mkStdGen (seed options)

-- | A region drawn by chance, but where and how it is asked for; leaves with status 2 where it does
-- not lie on the face.
pressedRegion :: Options -> LaidFace -> StdGen -> IO (Region, StdGen)
pressedRegion options pressed generator =
  case randomRegion (maybe halfTurns pure (orientation options)) (size options) pressed generator of
    Just (drawn, generator1)
      | fits (placed drawn) -> pure (placed drawn, generator1)
    _ -> unusable tooLarge
  where
    placed = maybe id atPlace (at options)
    atPlace (x, y) region = region {regionRight = x / taxelPitch, regionDown = y / taxelPitch}
    fits region =
      within regionRight fst spotRight region && within regionDown snd spotDown region
    within offset side extent region =
      offset region >= 0
        && taxelPitch * (offset region + fromIntegral (side (regionExtent region)))
          <= fromRational (extent (laidExtent pressed)) + 1e-9
    tooLarge =
      "the region, " ++ sizeText (bimap millimetres millimetres onTheFace)
        ++ maybe "" (\(x, y) -> " mm from " ++ hundredths x ++ "," ++ hundredths y) (at options)
        ++ " mm, does not lie on the face "
        ++ faceText (faceName (laidFace pressed))
        ++ ", which is "
        ++ sizeText (spotMillimetres (laidExtent pressed))
        ++ " mm; choose another --size or --at"
    onTheFace =
      (if maybe False exchangesAxes (orientation options) then swap else id) (size options)
    millimetres taxels = taxelPitch * fromIntegral taxels
    sizeText (w, h) = hundredths w ++ " x " ++ hundredths h

-- | Write the frames, in the robot's coordinates, and the truth, as far as that is asked for.
written :: Options -> [Frame] -> Truth -> IO ()
written options frames truth = do
  writeFolder (output options) =<< orUnusable imageMessage (frameFiles (map moved frames))
  putStrLn
    ( "wrote "
        ++ show (length frames)
        ++ " frames and their manifest to "
        ++ visibleName (output options)
    )
  for_ (truthFile options) $ \file ->
    writeWhole file (Lazy.fromStrict (encodeTruth truth <> "\n"))
  when (announced options == Announced) (putStrLn (truthText truth))
  where
    moved frame = frame {framePose = movedPose (framePose frame)}
    movedPose pose =
      pose
        { poseX = poseX pose + fst (origin options),
          poseY = poseY pose + snd (origin options)
        }

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

truthText :: Truth -> String
truthText truth =
  unwords
    [ "truth: face",
      faceText (faceName (truthFace truth)) ++ ", region from",
      uncurry (printf "%.2f,%.2f") (regionCorner region),
      "mm,",
      orientationText (regionSymmetry region)
    ]
  where
    region = truthRegion truth
