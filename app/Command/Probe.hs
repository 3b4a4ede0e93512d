{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile probe@: press the simulated sensor on a face and write the frames.
module Command.Probe
  ( command,
  )
where

import ArrayChoice
import Control.Monad (when)
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (lefts, rights)
import Data.Foldable (for_)
import Data.Maybe (fromMaybe, isJust, isNothing, listToMaybe)
import ExitStatus
import Message
import Options
import Output (orUnwritable, writeFolder, writeWhole)
import PlacementChoice
import Polyhedra
import PraTactile.Explore
import PraTactile.Format (encodePosedTruth, folderFiles)
import PraTactile.Format.Solid (SolidFormat (Stl), formatName)
import PraTactile.Image.File (ImageFormat (Pgm), imageFormatName)
import PraTactile.Object.Mend (Merging (..), asItIs)
import PraTactile.Object.Mesh (Mesh, scaledBy)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Pose (scaledMotion)
import PraTactile.Pressing
import PraTactile.Profile
import PraTactile.Recognise.Summary (orientationText)
import PraTactile.Sensor
import PraTactile.Sensor.Frame (Frame, scaledFrame)
import PraTactile.Symmetry
import PraTactile.Truth (Truth (..), scaledTruth, truePose)
import SensorChoice
import Setup
import Text.Printf (printf)
import Visible

data Options = Options
  { work :: Work,
    face :: Maybe String,
    at :: Maybe (Double, Double),
    size :: Maybe (Int, Int),
    -- | 'Nothing': at random upright or turned by 180 degrees
    turns :: Maybe Turns,
    sensor :: SensorChoice,
    seed :: Int,
    -- | the seed of what differs from sensor to sensor
    specimen :: Maybe Int,
    origin :: Maybe (Double, Double),
    bend :: Maybe Bend,
    announced :: Announced,
    truthFile :: Maybe FilePath,
    objects :: PlacementChoice,
    shapesFile :: Maybe FilePath,
    -- | a mesh that is pressed in place of the object
    meshFile :: Maybe FilePath,
    meshReading :: SolidReading,
    -- | of the frames' files and of the mesh
    formats :: [Either ImageFormat SolidFormat],
    output :: FilePath
  }

-- | What frames are made of.
data Work
  = -- | presses on the object of this name
    Object String
  | -- | so many frames of the sensor that touches nothing
    Dark Int
  | -- | so many frames of the sensor whose elements are all pressed alike
    Flat Int

-- | Whether the true place is printed.
data Announced = Announced | Unannounced
  deriving stock (Eq)

command :: Subcommand
command =
  subcommand
    "probe"
    "Press the simulated sensor on a face; write frames"
    "Press the simulated sensor on a face of an object, and write the frames with their manifest \
    \into a new folder."
    [sensorGroup, objectsGroup, readingGroup, arrayGroup]
    [ "pra-tactile probe --object cube --seed 7 --output frames",
      "pra-tactile probe --object cube --face 'C1 C2 C3 C4' --at 12.7,40 --upright --seed 1 \
      \--output frames",
      "pra-tactile probe --object cube --seed 7 --output frames --truth truth.json",
      "pra-tactile probe --object cube --seed 7 --sensor real --frame 32x32 --taxel 0.79375 \
      \--output frames",
      "pra-tactile probe --object sheet --seed 7 --output frames",
      "pra-tactile probe --object cube --seed 7 --bend 100 --bend-axis x --output frames",
      "pra-tactile probe --object cube --mesh cube.stl --seed 7 --output frames",
      "pra-tactile probe --flat 16 --sensor real --seed 7 --output frames"
    ]
    (run <$> optionsParser <*> arrayChoice)

optionsParser :: Parser Options
optionsParser =
  Options
    <$> workOption
    <*> optional
      (valued str "face" "VERTICES" "The face, as in 'C1 C2 C3 C4' (default: a random one)")
    <*> optional
      ( valued
          place
          "at"
          "X,Y"
          "The region's upper left corner on the face, in mm right and down from the face's upper \
          \left vertex (default: a random place)"
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
          "Seed of what differs between sensors, gains and dead taxels (default: that of --seed)"
      )
    <*> optional
      ( valued
          place
          "origin"
          "X,Y"
          "The region's upper left corner in the robot's coordinates, in mm (default: 0,0)"
      )
    <*> bendOption
    <*> flag Unannounced Announced (long "tell" <> help "Print the true place")
    <*> optionalFile "truth" "FILE" "Write the true place to this file as JSON, for 'compare'"
    <*> placementChoice "Take them from a database that 'objects --write' made"
    <*> shapesOption
    <*> optionalFile
      "mesh"
      "FILE"
      "Press the polyhedron in this file, as 'emboss' writes it, in place of the object. Its \
      \surface is felt where the placement has the face; the array is not used"
    <*> readingWith (pure AsWritten) (pure Nothing)
    <*> many
      ( choosing
          "format"
          (map (fmap Left) (allNamed imageFormatName) ++ map (fmap Right) (allNamed formatName))
          "format"
          "FORMAT"
          "Format of the frames: pgm (default), png or npy; or format of the --mesh, if its name \
          \does not end in one"
          mempty
      )
    <*> folderOption "output" "A folder that is new or empty"
  where
    place = pairReader ',' "12.7,40"

-- | The format of the mesh, if it is given.
meshFormat :: Options -> Maybe SolidFormat
meshFormat = listToMaybe . reverse . rights . formats

-- | @--object@, @--dark@ or @--flat@.
workOption :: Parser Work
workOption =
  Object
    <$> strOption
      ( long "object"
          <> metavar "NAME"
          <> completeWith ["cube", "parallelepiped", "sheet"]
          <> help
            "The object: cube, parallelepiped, an object of the placement, or sheet, the whole \
            \array as a flat plate"
      )
    <|> Dark
      <$> frameCount
        "dark"
        "Write N frames of the sensor that touches nothing instead"
    <|> Flat
      <$> frameCount
        "flat"
        "Write N frames of the sensor with all taxels pressed alike, to half of full scale, instead"
  where
    frameCount name = valued intReader name "N"

-- | How the face lies turned.
turnsOption :: Parser (Maybe Turns)
turnsOption =
  optional $
    flag'
      (AmongTurns [identity])
      ( long "upright"
          <> help
            "The face lies upright in the robot's frame (default: at random upright or turned by \
            \180 degrees)"
      )
      <|> flag'
        (AmongTurns [turned 2])
        (long "turned" <> help "The face lies turned by 180 degrees")
      <|> (TurnedBy <$> angleOption "The face lies turned clockwise by this angle")

run :: Options -> ArrayChoice -> IO ExitStatus
run options choice
  | any (not . (< 1e6) . abs) [fst placed, snd placed] =
    misused "--origin must be a place in millimetres, each coordinate below 10^6"
  | isNothing (meshFile options)
      && (meshReading options /= asUsual {readingMending = asItIs} || isJust (meshFormat options)) =
    misused "--scale, --tolerance and --format are for a --mesh; leave them out"
  | otherwise = do
    simulated <- chosenSensor (sensor options)
    let how =
          Pressing
            { pressingSensor = simulated,
              pressingSpacing = chosenSpacing (sensor options) simulated,
              pressingSeed = seed options,
              pressingSpecimen = specimen options,
              pressingFace = readFaceName . map spaced <$> face options,
              pressingAt = at options,
              pressingSize = chosenSize (size options) simulated,
              pressingTurns = fromMaybe (AmongTurns halfTurns) (turns options),
              pressingOrigin = placed,
              pressingBend = bend options
            }
    case work options of
      Object named -> pressing choice options how (objectCalled named)
      Dark count -> calibrating choice options simulated count (darkPresses how)
      Flat count -> calibrating choice options simulated count (flatPresses how)
  where
    placed = fromMaybe (0, 0) (origin options)
    spaced c = if c == ',' then ' ' else c

-- | Write n calibration frames.
calibrating ::
  ArrayChoice -> Options -> Sensor -> Int -> (Int -> [Frame]) -> IO ExitStatus
calibrating choice options simulated count frames
  | count < 1 || count > 10000 =
    misused
      "--dark and --flat must be numbers of frames from 1 to 10000"
  | truthFile options /= Nothing || announced options == Announced =
    misused "calibration frames have no true place; leave out --truth and --tell"
  | otherwise = do
    leaveOut "calibration frames show no face" $
      [ ("--bend", isJust (bend options)),
        ("--mesh", isJust (meshFile options)),
        ("--face", isJust (face options)),
        ("--at", isJust (at options)),
        ("--size", isJust (size options)),
        ("--origin", isJust (origin options)),
        ("the turn", isJust (turns options)),
        ("--shapes", isJust (shapesFile options)),
        ("the array's options", not (nothingChosen choice))
      ]
        ++ placementGiven (objects options)
        ++ ofPresses (sensor options)
    Answered <$ writeFrames options simulated (frames count)

-- | Press a face of the object; write the frames, and the truth as far as that is asked for.
pressing :: ArrayChoice -> Options -> Pressing -> ObjectName -> IO ExitStatus
pressing choice options how object = do
  when (isJust (meshFile options)) $
    leaveOut "the --mesh has its symbols already" [("--shapes", isJust (shapesFile options))]
  for_ (truthFile options) orUnwritable
  (profile, laid) <- chosenWith choice (holding object (objects options)) object
  (scale, layout) <- feltPlacement laid
  alphabet <- alphabetFor (shapesFile options) profile
  let larger = fromRational scale
      smaller (x, y) = (x / larger, y / larger)
      feltBy = feltBySymbols scale (pressingSensor how)
      felt =
        how
          { pressingSensor = feltBy,
            pressingSize = chosenSize (size options) feltBy,
            pressingAt = smaller <$> pressingAt how,
            pressingOrigin = smaller (pressingOrigin how),
            pressingBend = bendBySymbols scale <$> pressingBend how
          }
  mesh <-
    traverse
      (meshIn (meshReading options) {readingFormat = meshFormat options})
      (meshFile options)
  (frames, found) <-
    orUnusable (pressMessage larger (at options))
      =<< case mesh of
        Just it -> pure (pressedMesh felt (scaledBy (1 / scale) it) layout object)
        Nothing ->
          orUnusable
            profileMessage
            (withProfile profile (\array _ -> pressed felt alphabet array layout object))
  writeFrames options (pressingSensor how) (map (scaledFrame larger) frames)
  let truth = scaledTruth larger found
  for_ (truthFile options) $ \file ->
    writeWhole file . Lazy.fromStrict . (<> "\n") $
      encodePosedTruth (scaledMotion larger <$> truePose layout found) truth
  when (announced options == Announced) (putStrLn (truthText truth))
  pure Answered

-- | The polyhedron in a file, read as the options say. The file has the format that its name ends
-- in, or else is STL.
meshIn :: SolidReading -> FilePath -> IO Mesh
meshIn reading file = do
  contents <- fileContents (readingFormat reading <|> Just Stl) file
  polyhedronMesh <$> readBy reading file contents

-- | Write frames of the sensor, and say so.
writeFrames :: Options -> Sensor -> [Frame] -> IO ()
writeFrames options simulated frames = do
  writeFolder (output options)
    =<< orUnusable
      imageMessage
      (folderFiles format (sensorTaxelGrid simulated) (sensorBits simulated) frames)
  putStrLn
    ( "wrote "
        ++ show (length frames)
        ++ " frames and their manifest to "
        ++ visibleName (output options)
    )
  where
    format = fromMaybe Pgm (listToMaybe (reverse (lefts (formats options))))

truthText :: Truth -> String
truthText truth =
  unwords
    [ "truth: face",
      faceText (faceName (truthFace truth)) ++ ", region from",
      uncurry (printf "%.2f,%.2f") (regionCorner region),
      "mm,",
      orientationText (regionSymmetry region) ++ further ++ bent
    ]
  where
    region = truthRegion truth
    further
      | regionAngle region == 0 = ""
      | otherwise = printf " and further by %.2f degrees" (regionAngle region)
    bent = maybe "" ((", " ++) . bendText) (truthBend truth)
