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
import Data.Maybe (fromMaybe)
import Data.Tuple (swap)
import Drawing (hundredths)
import ExitStatus
import Frames (listedFrameFiles)
import Message
import Options
import Output (orUnwritable, writeFolder, writeWhole)
import PraTactile.Explore
import PraTactile.Format (encodeTruth)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Recognise.Summary (orientationText)
import PraTactile.Relief
import PraTactile.Sensor
import PraTactile.Sensor.Frame (Frame (..), Pose (..), taxelPitch)
import PraTactile.Symmetry
import PraTactile.Truth (Truth (..))
import SensorChoice
import Setup
import System.Random (StdGen, mkStdGen, randomR, split)
import Text.Printf (printf)
import Visible

data Options = Options
  { work :: Work,
    face :: Maybe String,
    at :: Maybe (Double, Double),
    size :: (Int, Int),
    turns :: Turns,
    sensor :: SensorChoice,
    seed :: Int,
    -- | the seed of what differs from sensor to sensor
    specimen :: Maybe Int,
    origin :: (Double, Double),
    announced :: Announced,
    truthFile :: Maybe FilePath,
    output :: FilePath
  }

-- | What frames are made of.
data Work
  = -- | presses on the object of this name
    Pressing String
  | -- | so many frames of the sensor that touches nothing
    Dark Int
  | -- | so many frames of the sensor whose elements are all pressed alike
    Flat Int

-- | Whether the true place is printed.
data Announced = Announced | Unannounced
  deriving stock (Eq)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "probe"
    "Press the simulated sensor on an object's face and write the frames, as PGM files with a \
    \manifest, into a new folder."
    [ "pra-tactile probe --object cube --seed 7 --output frames",
      "pra-tactile probe --object cube --face 'C1 C2 C3 C4' --at 12.7,40 --upright --seed 1 \
      \--output frames",
      "pra-tactile probe --object cube --seed 7 --output frames --truth truth.json",
      "pra-tactile probe --object cube --seed 7 --sensor real --frame 32x32 --taxel 0.79375 \
      \--output frames",
      "pra-tactile probe --flat 16 --sensor real --seed 7 --output frames"
    ]
    (run <$> arrayChoice <*> optionsParser)

optionsParser :: Parser Options
optionsParser =
  Options
    <$> workOption
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
    <*> turnsOption
    <*> sensorOptions
    <*> seedOption mempty
    <*> optional
      ( valued
          intReader
          "specimen"
          "N"
          "Seed of what differs from one sensor to the next, gains and dead taxels (default: \
          \that of --seed)"
      )
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

-- | @--object@, @--dark@ or @--flat@.
workOption :: Parser Work
workOption =
  Pressing
    <$> strOption
      ( long "object"
          <> metavar "NAME"
          <> completeWith ["cube", "parallelepiped"]
          <> help "The object: cube or parallelepiped"
      )
    <|> Dark
      <$> frameCount
        "dark"
        "Write so many frames of the sensor that touches nothing instead"
    <|> Flat
      <$> frameCount
        "flat"
        "Write so many frames of the sensor with all taxels pressed alike, to half of full scale, \
        \instead"
  where
    frameCount name = valued intReader name "N"

-- | How the face lies turned.
turnsOption :: Parser Turns
turnsOption =
  flag'
    (AmongTurns [identity])
    ( long "upright"
        <> help
          "The face lies upright in the robot's frame (default: so or turned by 180 degrees, by \
          \chance)"
    )
    <|> flag' (AmongTurns [turned 2]) (long "turned" <> help "The face lies turned by 180 degrees")
    <|> (TurnedBy <$> angleOption "The face lies turned clockwise by so many degrees, any number")
    <|> pure (AmongTurns halfTurns)

run :: ArrayChoice -> Options -> IO ExitStatus
run choice options
  | any (not . (< 1e6) . abs) [fst (origin options), snd (origin options)] =
    unusable "--origin is a place in millimetres"
  | otherwise = do
    simulated <- chosenSensor (sensor options)
    let (one, _) = drawSpecimen simulated (mkStdGen (fromMaybe (seed options) (specimen options)))
    case work options of
      Pressing named -> pressing choice options simulated one named
      Dark count -> calibrating options simulated count (darkFrames simulated one)
      Flat count -> calibrating options simulated count (flatFrames simulated one)

-- | Write so many calibration frames.
calibrating :: Options -> Sensor -> Int -> (Int -> StdGen -> [Frame]) -> IO ExitStatus
calibrating options simulated count frames
  | count < 1 || count > 10000 = unusable "--dark and --flat are numbers of frames from 1 to 10000"
  | truthFile options /= Nothing || announced options == Announced =
    unusable "calibration frames have no true place; leave out --truth and --tell"
  | otherwise = do
    -- Not the draws that the specimen came from.
    writeFrames options simulated (frames count (snd (split (mkStdGen (seed options)))))
    pure Answered

-- | Press a face of the object and write the frames.
pressing :: ArrayChoice -> Options -> Sensor -> Specimen -> String -> IO ExitStatus
pressing choice options simulated one named = do
  for_ (truthFile options) orUnwritable
  profile <- chosenProfile choice
  layout <- placementFor profile
  alphabet <- shippedAlphabet
  faces <- objectsNamed layout named
  (pressed, generator) <- pressedFace options faces
  heights <-
    orUnusable reliefMessage
      =<< orUnusable
        profileMessage
        (withProfile profile (\array _ -> relief array layout alphabet pressed))
  (region, generator1) <- pressedRegion options pressed generator
  (frames, _) <-
    orUnusable
      probeMessage
      ( exploreWith
          simulated
          (chosenSpacing (sensor options) simulated)
          one
          heights
          region
          generator1
      )
  written options simulated frames (Truth (laidFace pressed) region (origin options))
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
  case drawnRegion (turns options) (size options) pressed generator of
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
      (if lying then swap else id) (size options)
    lying = case turns options of
      AmongTurns [symmetry] -> exchangesAxes symmetry
      TurnedBy degrees -> exchangesAxes (fst (nearestQuarter degrees))
      _ -> False
    millimetres taxels = taxelPitch * fromIntegral taxels
    sizeText (w, h) = hundredths w ++ " x " ++ hundredths h

-- | Write the frames, in the robot's coordinates, and the truth, as far as that is asked for.
written :: Options -> Sensor -> [Frame] -> Truth -> IO ()
written options simulated frames truth = do
  writeFrames options simulated (map moved frames)
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

-- | Write frames of the sensor, and say so.
writeFrames :: Options -> Sensor -> [Frame] -> IO ()
writeFrames options simulated frames = do
  writeFolder (output options)
    =<< orUnusable
      imageMessage
      (listedFrameFiles (sensorLayout simulated) (sensorBits simulated) frames)
  putStrLn
    ( "wrote "
        ++ show (length frames)
        ++ " frames and their manifest to "
        ++ visibleName (output options)
    )

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
      orientationText (regionSymmetry region) ++ further
    ]
  where
    region = truthRegion truth
    further
      | regionAngle region == 0 = ""
      | otherwise = printf " and further by %.2f degrees" (regionAngle region)
