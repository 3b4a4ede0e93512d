{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile decode@: tactile images in, object, face and place out.
module Command.Decode
  ( command,
    toleranceOptions,
    toleranceComplaint,
  )
where

import ArrayChoice
import Command.Prove (surfaceOption)
import Command.Stitch (Assembly, assemble, assemblyOptions)
import Control.Monad (forM, unless)
import qualified Data.ByteString.Char8 as Bytes
import Data.Foldable (for_)
import Data.Maybe (fromMaybe, listToMaybe)
import Described
import Ending
import Frames
import Message
import Options.Applicative hiding (command)
import Output (writeWhole)
import Picture (pageSvg, recognitionPage)
import PraTactile.Array (Surface)
import PraTactile.Field (KnownField)
import PraTactile.Format (RecognitionReport (..), encodeRecognition)
import PraTactile.Format.Profile (profileText)
import PraTactile.Object.Placement (LaidFace)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Relief (faceClasses)
import PraTactile.Shape (Alphabet)
import PraTactile.Stitch (Composite (..), compositePosition)
import Recognised
import Setup
import SvgFile
import Visible

data Options = Options
  { surface :: Maybe Surface,
    assembly :: Assembly,
    network :: Maybe FilePath,
    database :: Maybe FilePath,
    picture :: Maybe FilePath,
    tolerance :: Tolerance,
    together :: Bool,
    places :: [(Double, Double)],
    asJson :: Bool,
    paths :: [FilePath]
  }

command :: Mod CommandFields (IO Ending)
command =
  described
    "decode"
    "Recognise object, face and place from tactile images: PGM files that are whole composites, \
    \folders of frames with their manifest, or frames of such a folder. What was not recognised \
    \is made up for, and what was recognised wrongly is corrected, as far as the array vouches \
    \for it."
    [ "pra-tactile decode data/worked-example/composite.pgm",
      "pra-tactile decode --json frames",
      "pra-tactile decode frames --picture recognised.svg",
      "pra-tactile decode --together left.pgm right.pgm --at 0,0 --at 76.2,0"
    ]
    (run <$> arrayChoice <*> options)
  where
    options =
      Options
        <$> surfaceOption
        <*> assemblyOptions
        <*> networkOption
        <*> optional
          ( strOption
              ( long "database"
                  <> metavar "FILE"
                  <> action "file"
                  <> help
                    "Look the position up in a database that 'objects --write' made (default: the \
                    \mapping in memory)"
              )
          )
        <*> optional
          ( strOption
              ( long "picture"
                  <> metavar "FILE.svg"
                  <> action "file"
                  <> help
                    "Draw what was felt with the symbols over it, and where on the face that is \
                    \(one source only); - is the standard output, in place of the answer"
              )
          )
        <*> toleranceOptions
        <*> switch
          ( long "together"
              <> help
                "All sources show one face, in the robot's coordinates: give one answer from all \
                \of them"
          )
        <*> many
          ( option
              millimetres
              ( long "at"
                  <> metavar "X,Y"
                  <> help
                    "With --together: where the upper left pixel of a whole image is, in \
                    \millimetres; once for each whole image, in order"
              )
          )
        <*> switch (long "json" <> help "Print one JSON answer a line")
        <*> some
          ( strArgument
              ( metavar "PATH..."
                  <> action "file"
                  <> help
                    "Images, folders of frames, or frames; - is an image on the standard input"
              )
          )
    millimetres = do
      (x, y) <- pairReader ',' "76.2,0"
      if all finite [x, y]
        then pure (x, y)
        else readerError "a place is two finite numbers, as in 76.2,0"
    finite v = not (isNaN v || isInfinite (v :: Double))

-- | How much doubt and how many wrong symbols an answer may have.
toleranceOptions :: Parser Tolerance
toleranceOptions =
  Tolerance
    <$> option
      decimalReader
      ( long "doubt"
          <> metavar "P"
          <> value (toleratedDoubt standardTolerance)
          <> showDefault
          <> help "The probability of a wrong answer that is tolerated"
      )
    <*> radiusOption
      "Let up to N recognised symbols contradict the answer (default: as many as the recognised \
      \ones guarantee to be corrected)"

-- | What is wrong with a choice of these.
toleranceComplaint :: Tolerance -> Maybe String
toleranceComplaint chosen
  | toleratedDoubt chosen >= 0 && toleratedDoubt chosen < 1 = Nothing
  | otherwise = Just "--doubt is a probability below 1"

run :: ArrayChoice -> Options -> IO Ending
run choice options
  | Just complaint <- toleranceComplaint (tolerance options) = unusable complaint
  | picture options == Just standardOutput && asJson options =
    unusable "--picture - and --json both take the standard output; name a file for the picture"
  | otherwise = do
    for_ (picture options) orNotSvg
    profile <- chosenProfile choice
    layout <- placementFor profile
    alphabet <- shippedAlphabet
    net <- chosenNetwork (network options)
    let on = fromMaybe (profileSurface profile) (surface options)
    readAs <-
      orUnusable recogniserMessage
        =<< orUnusable
          profileMessage
          ( withProfile
              profile
              ( \array mask ->
                  decodeWith alphabet profile (faceClasses array) options
                    <$> recogniser on array mask layout alphabet net
              )
          )
    found <- sources (paths options)
    case (found, picture options) of
      (_ : _ : _, Just _) -> unusable "--picture draws one composite; give one source"
      _ -> pure ()
    composites <- loadSources (assemble (assembly options)) found
    if together options
      then placed (places options) (zip found composites) >>= readAs (map sourcePath found)
      else do
        unless
          (null (places options))
          (unusable "--at is for whole images that are decoded --together")
        maximum . (Answered :)
          <$> forM
            (zip (map sourcePath found) composites)
            ( \(path, composite) -> do
                case found of
                  _ : _ : _ | not (asJson options) -> putStrLn (visibleName path ++ ":")
                  _ -> pure ()
                readAs [path] [composite]
            )

-- | The composites, whole images at the places given for them; frames know their own.
placed :: [(Double, Double)] -> [(Source, Composite)] -> IO [Composite]
placed given found
  | wholeImages == length given = pure (go given found)
  | otherwise =
    unusable
      ( show wholeImages
          ++ " whole images are decoded together, and --at is given "
          ++ show (length given)
          ++ " times; give it once for each, in order"
      )
  where
    wholeImages = length [() | (CompositeFile _, _) <- found]
    go (at : others) ((CompositeFile _, composite) : rest) =
      composite {compositeOrigin = at} : go others rest
    go ats ((_, composite) : rest) = composite : go ats rest
    go _ [] = []

-- | Decode composites of one face: draw the picture, print the answer.
decodeWith ::
  KnownField k =>
  Alphabet ->
  Profile ->
  (LaidFace -> [[Int]]) ->
  Options ->
  Recogniser k ->
  [FilePath] ->
  [Composite] ->
  IO Ending
decodeWith alphabet profile classesOf options reader from composites = do
  recognition <-
    orUnusable networkMessage (recogniseWith (tolerance options) reader composites)
      >>= maybe pure lookedUp (database options)
  for_ ((,) <$> picture options <*> listToMaybe composites) $ \(file, composite) ->
    writeWhole
      file
      ( pageSvg
          ( recognitionPage
              alphabet
              nameOf
              (recogniserPlacement reader)
              classesOf
              composite
              recognition
          )
      )
  case () of
    _
      | picture options == Just standardOutput -> pure ()
      | asJson options ->
        Bytes.putStrLn (encodeRecognition (report (listToMaybe composites) recognition))
      | otherwise -> putStr (unlines (recognitionText nameOf from recognition))
  pure (recognitionEnding recognition)
  where
    nameOf = elementNames reader
    report composite recognition =
      RecognitionReport
        { reportProfile = profile,
          reportSources = map nameInJson from,
          reportMessage = recognitionMessage recognition,
          reportElement = nameOf,
          reportRobot = maybe id compositePosition composite,
          reportRecognition = recognition
        }
    lookedUp file = fromDatabase file (profileText profile) (profileWindow profile)
