-- | @pra-tactile decode@: tactile images in, object, face and place out.
module Command.Decode
  ( command,
    ToleranceChoice (..),
    toleranceOptions,
    toleranceGroup,
    toleranceComplaint,
  )
where

import ArrayChoice
import Control.Monad (unless, when)
import Data.Foldable (for_)
import Data.List.NonEmpty (nonEmpty)
import Data.Maybe (fromMaybe, isJust, listToMaybe, mapMaybe)
import Data.Traversable (for)
import ExitStatus
import FormatFile (readPlane)
import Frames
import FramesChoice
import Message
import Options
import Output (writeWhole)
import Picture (pageSvg, recognitionPage)
import PlacementChoice
import PraTactile.Array (ArrayOn (..), Position, PseudorandomArray, Surface)
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Decode (Stitching (..))
import PraTactile.Field (KnownField)
import PraTactile.Files (SourcePath (..), sourcePath)
import PraTactile.Format
  ( ObjectPose (..),
    RecognitionContext (..),
    encodeRecognition,
    recognitionReport,
  )
import PraTactile.Object.Placement (Placement)
import PraTactile.Pose (Pose (..), RigidMotion, thenPose)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Recognise.FoundPose (foundPose)
import PraTactile.Registration (Composite (..), compositePosition)
import PraTactile.Relief (classOn)
import Recognised
import Setup
import SvgFile
import Visible

data Options = Options
  { surface :: Maybe Surface,
    stitching :: StitchingChoice,
    frames :: FramesChoice,
    symbolReader :: ReaderChoice,
    objects :: PlacementChoice,
    picture :: Maybe FilePath,
    tolerance :: ToleranceChoice,
    sharing :: Sharing,
    places :: [(Double, Double)],
    plane :: Maybe FilePath,
    form :: AnswerForm,
    paths :: [FilePath]
  }

-- | How several sources belong together.
data Sharing
  = EachItsOwn
  | -- | one face, in the robot's coordinates
    OneFace
  deriving stock (Eq)

command :: Subcommand
command =
  subcommand
    "decode"
    "Recognise object, face and place from tactile images"
    "Find the object, the face and the place on it that tactile images show. A source is an image \
    \of a whole region, a folder of frames with their manifest, or frames of such a folder. \
    \Symbols that were not recognised are filled in, and wrong ones are corrected, as far as the \
    \array guarantees it."
    [framesGroup, objectsGroup, toleranceGroup, arrayGroup]
    [ "pra-tactile decode data/worked-example/composite.pgm",
      "pra-tactile decode --json frames",
      "pra-tactile decode frames --picture recognised.svg",
      "pra-tactile decode --sheet frames",
      "pra-tactile decode --together left.pgm right.pgm --origin 0,0 --origin 76.2,0"
    ]
    (run <$> optionsParser <*> arrayChoice)

optionsParser :: Parser Options
optionsParser =
  Options
    <$> surfaceOption
    <*> stitchingOptions
    <*> framesOptions
    <*> readerChoice
    <*> plateOr
      ( placementChoice
          "Look the position up in a database that 'objects --write' made"
      )
    <*> pictureOption
      []
      "Draw what was felt, with the symbols over it, and where it lies on the face; for one \
      \source. - is the standard output, in place of the answer"
    <*> toleranceOptions foreignOption
    <*> flag
      EachItsOwn
      OneFace
      ( long "together"
          <> help
            "All sources show one face, in the robot's coordinates; give one answer for them \
            \together"
      )
    <*> many placeOption
    <*> optionalFile
      "plane"
      "FILE"
      "Where the robot's coordinates lie in the world, a file of JSON; the pose is then that in \
      \the world"
    <*> jsonSwitch "Print each answer as a line of JSON"
    <*> framesArgument

-- | @--origin@.
placeOption :: Parser (Double, Double)
placeOption =
  orAlias "at" millimetres mempty $
    valued
      millimetres
      "origin"
      "X,Y"
      "With --together: where the upper left pixel of a whole image is in the robot's \
      \coordinates, in mm; once for each whole image, in order"
  where
    millimetres = do
      (x, y) <- pairReader ',' "76.2,0"
      if all finite [x, y]
        then pure (x, y)
        else readerError "a place is two finite numbers, as in 76.2,0"
    finite v = not (isNaN v || isInfinite (v :: Double))

-- | How much doubt and how many wrong symbols an answer may have.
data ToleranceChoice = ToleranceChoice
  { tolerated :: Tolerance,
    -- | whether @--slip@ was given
    slipGiven :: Bool
  }

-- | The options that say how much doubt an answer may have, as a group of a command's help.
toleranceGroup :: Group
toleranceGroup =
  Group "How certain an answer must be" (words "doubt radius foreign axes-doubt slip")

-- | The tolerance as options, given the option for the prior of foreign things.
toleranceOptions :: Parser Double -> Parser ToleranceChoice
toleranceOptions foreignThings =
  choice
    <$> defaulting
      (toleratedDoubt standardTolerance)
      decimalReader
      "doubt"
      "P"
      "Largest tolerated probability that the answer is wrong"
    <*> radiusOption
      "Answer although up to N recognised symbols disagree (default: as many as the recognised \
      \symbols guarantee to correct)"
    <*> foreignThings
    <*> optional
      ( valued
          decimalReader
          "axes-doubt"
          "P"
          "Prior probability that the robot's axes are others (default: 0.01, or 0.0025 if the \
          \manifest or --axes states them)"
      )
    <*> usually
      usualSlip
      decimalReader
      "slip"
      "P"
      "Prior probability that the frames beyond a line slipped by a whole cell, and that another \
      \folder did"
  where
    usualSlip = slipPrior standardTolerance
    choice doubt wrong others axes slip =
      ToleranceChoice
        (Tolerance doubt wrong others axes (fromMaybe usualSlip slip))
        (isJust slip)

-- | @--foreign@: the prior of foreign things.
foreignOption :: Parser Double
foreignOption =
  defaulting
    (foreignPrior standardTolerance)
    decimalReader
    "foreign"
    "P"
    "Prior probability that what was touched is not of this array, though its symbols have the \
    \same shapes"

-- | The complaint about a tolerance with an impossible value.
toleranceComplaint :: ToleranceChoice -> Maybe String
toleranceComplaint choice
  | not (isShare (toleratedDoubt given)) = Just "--doubt must be a probability from 0 to below 1"
  | not (isShare (foreignPrior given)) = Just "--foreign must be a probability from 0 to below 1"
  | not (all isShare (axesPrior given)) =
    Just
      "--axes-doubt must be a probability from 0 to below 1"
  | not (isShare (slipPrior given)) = Just "--slip must be a probability from 0 to below 1"
  | otherwise = Nothing
  where
    given = tolerated choice
    isShare p = p >= 0 && p < 1

run :: Options -> ArrayChoice -> IO ExitStatus
run options choice
  | Just complaint <- toleranceComplaint (tolerance options) = misused complaint
  | Just complaint <- pictureComplaint (picture options) (form options) = misused complaint
  | form options == AsText && isJust (plane options) =
    misused "--plane changes the pose, which only --json prints; give --json as well"
  | otherwise = do
    for_ (picture options) orNotSvg
    found <- chosenSources (frames options) (paths options)
    heeded options found
    world <- traverse readPlane (plane options)
    withNear choice (objects options) (decodeAll world options found)

-- | Decode the sources by a profile, a placement, and an action that reads the objects near given
-- cells.
decodeAll ::
  Maybe RigidMotion ->
  Options ->
  [SourcePath] ->
  Profile ->
  Placement ->
  ([Position] -> IO (Maybe Placement)) ->
  IO ExitStatus
decodeAll world options found profile layout near = do
  (scale, _) <- feltPlacement layout
  let larger = fromRational scale
  symbols <- readerFor (symbolReader options) profile
  decoder <- decoderOn profile layout symbols near world options
  let several = not (null (drop 1 found))
  when
    (several && picture options /= Nothing)
    (misused "--picture draws one source only; give one source")
  known <- preparation (frames options)
  composites <-
    loadSources (readerTables symbols) larger known (stitchingOf (stitching options)) found
  case sharing options of
    OneFace ->
      placed [(x / larger, y / larger) | (x, y) <- places options] (zip found composites)
        >>= decoder (map sourcePath found)
    EachItsOwn ->
      fmap (maximum . (Answered :)) . for (zip (map sourcePath found) composites) $
        \(path, composite) -> do
          when (several && form options == AsText) (putStrLn (visibleName path ++ ":"))
          decoder [path] [composite]

-- | Refuses options that do not apply to these sources.
heeded :: Options -> [SourcePath] -> IO ()
heeded options found = do
  when (onlyImages found) $
    leaveOut
      "whole images have no frames"
      ( ofFrames (stitching options) (frames options)
          ++ [ ("--axes-doubt", isJust (axesPrior (tolerated (tolerance options)))),
               ("--slip", slipGiven (tolerance options) && not (among found))
             ]
      )
  when (asTheyAre (stitching options)) $
    leaveOut
      "--no-stitching uses the nominal positions"
      [given | given@("--frame-noise", _) <- ofRegistration (stitching options)]
  unless (null (places options) || sharing options == OneFace) $
    misused "--origin is for whole images that are decoded --together"
  where
    -- If there are several sources, a whole source may have slipped.
    among sources = sharing options == OneFace && not (null (drop 1 sources))

-- | The action that decodes composites of one face, given their names, and prints the answer.
decoderOn ::
  Profile ->
  Placement ->
  Reader ->
  ([Position] -> IO (Maybe Placement)) ->
  Maybe RigidMotion ->
  Options ->
  IO ([FilePath] -> [Composite] -> IO ExitStatus)
decoderOn profile layout symbols near world options = do
  let on = fromMaybe (profileSurface profile) (surface options)
      made array mask =
        decodeWith profile array near world options
          <$> recogniser (ArrayOn on array) mask layout symbols
  orUnusable recogniserMessage =<< orUnusable profileMessage (withProfile profile made)

-- | The composites, with whole images moved to the places given by @--origin@; frames know their
-- own places.
placed :: [(Double, Double)] -> [(SourcePath, Composite)] -> IO [Composite]
placed given found
  | wholeImages == length given = pure (go given found)
  | otherwise =
    misused
      ( show wholeImages
          ++ " whole images are decoded together, but --origin is given "
          ++ show (length given)
          ++ " times; give it once for each, in order"
      )
  where
    wholeImages = length [() | (ImagePath _, _) <- found]
    go (at : others) ((ImagePath _, composite) : rest) =
      composite {compositeOrigin = at `plus` compositeOrigin composite} : go others rest
    go ats ((_, composite) : rest) = composite : go ats rest
    go _ [] = []
    -- The origin of a resampled image is not the centre of its first pixel.
    plus (x, y) (dx, dy) = (x + dx, y + dy)

-- | Decode composites of one face: draw the picture, print the answer.
decodeWith ::
  KnownField k =>
  Profile ->
  PseudorandomArray k ->
  ([Position] -> IO (Maybe Placement)) ->
  Maybe RigidMotion ->
  Options ->
  Recogniser k ->
  [FilePath] ->
  [Composite] ->
  IO ExitStatus
decodeWith profile array near world options bare from composites = do
  seen <- orUnusable networkMessage (readFace (recogniserReader bare) composites)
  -- The position on the array is found without the objects. Then those that lie there are read from
  -- a database.
  objects' <- near (cellsShown tolerating bare seen)
  let reader = maybe bare (\there -> bare {recogniserPlacement = there}) objects'
  recognition <-
    orUnusable networkMessage (recogniseSeen tolerating reader composites seen)
  for_ ((,) <$> picture options <*> listToMaybe composites) $ \(file, composite) ->
    writeWhole file (pageSvg (page reader composite recognition))
  unless (picture options == Just standardOutput) $
    printAs
      (form options)
      (unlines (recognitionText nameOf from recognition))
      (encodeRecognition (recognitionReport (context reader recognition) recognition))
  pure (recognitionStatus recognition)
  where
    tolerating = tolerated (tolerance options)
    alphabet = readerAlphabet (recogniserReader bare)
    nameOf = elementNames bare
    page reader composite recognition =
      recognitionPage
        alphabet
        nameOf
        (recogniserPlacement reader)
        (classOn array)
        (fmap poseMotion <$> pose reader recognition)
        composite
        recognition
    context reader recognition =
      RecognitionContext
        { contextProfile = profile,
          contextNames = map nameInJson from,
          contextMessage = recognitionMessage recognition,
          contextElement = nameOf,
          contextRobot = both (larger *) . maybe id compositePosition (listToMaybe composites),
          contextPositionError =
            fmap maximum (nonEmpty (mapMaybe compositePositionError composites)),
          contextPose =
            ( \(object, found) ->
                ObjectPose
                  { posedObject = object,
                    posedSo = maybe id thenPose world found,
                    posedOn = world
                  }
            )
              <$> pose reader recognition
        }
    pose reader =
      foundPose
        (recogniserPlacement reader)
        alphabet
        array
        (stitchingPositionError (stitchingOf (stitching options)))
        composites
    larger = fromRational (recogniserScale bare)
    both f (x, y) = (f x, f y)
