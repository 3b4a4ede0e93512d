-- | Messages about images, frames, sensors, shapes and networks.
module Message.Touch
  ( imageMessage,
    manifestMessage,
    posesMessage,
    probeMessage,
    stitchMessage,
    contradictionMessage,
    remediesText,
    calibrationMessage,
    pairMessage,
    shapeMessage,
    shippedMessage,
    networkMessage,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.Char (isDigit)
import Data.List (find, intercalate)
import qualified Data.Text as Text
import Message.Format (encodingMessage, figures, rangeText)
import PraTactile.Classification.Network (NetworkError (..))
import PraTactile.Classification.Shipped (ShippedError (..), shippedSizes)
import PraTactile.Composite (asTaken)
import PraTactile.Image.Error
import PraTactile.Image.Pgm (formatName, maxPixels)
import PraTactile.Registration
  ( Contradiction (..),
    StitchError (..),
    TooMuch (..),
    maxComparisons,
    maxFramePixels,
    maxLatticePixels,
    maxPairPixels,
  )
import PraTactile.Registration.Pair (PairError (..))
import PraTactile.Sensor.Calibration (CalibrationError (..))
import PraTactile.Sensor.Frame (ProbeError (..), taxelPitches)
import PraTactile.Sensor.Manifest
  ( ManifestError (..),
    Remedy (..),
    axesName,
    manifestHeader,
    standardConventions,
  )
import PraTactile.Shape (ShapeError (..), maxShapes)
import Text.Printf (printf)

imageMessage :: ImageError -> String
imageMessage e = case e of
  RaggedRow i given first ->
    "row " ++ show i ++ " has " ++ show given ++ " values, the first has " ++ show first
  WrongValueCount wide high given ->
    by (wide, high) ++ " pixels do not have " ++ show given ++ " values"
  SizesDiffer a b -> "two images differ in size: " ++ by a ++ " and " ++ by b
  OutsideImage (x, y, w, h) size ->
    "the rectangle of " ++ by (w, h) ++ " at " ++ at (x, y)
      ++ " does not lie in an image of "
      ++ by size
  ZeroSize wide high -> "an image of " ++ by (wide, high) ++ " pixels has none"
  TooManyPixels wide high ->
    "the image has " ++ by (wide, high) ++ " pixels; at most " ++ show maxPixels ++ " are read"
  LargerThanTouched most wide high ->
    "the image has " ++ by (wide, high) ++ " pixels; an image of what was touched has at most "
      ++ show most
      ++ ", each a taxel of 1.5875 mm: cut out what was pressed, or scale it down"
  NotPgm start ->
    "not an image that is read" ++ formatText start
      ++ "; PGM, PNG, .npy, numbers as text and Tekscan's exports are"
  BadHeader field found -> headerMessage field found
  MaxvalOutOfRange n -> "the PGM header's maximum value is " ++ show n ++ ", not 1 to 65535"
  BadSample i found -> "sample " ++ show i ++ " is not a number: " ++ show found
  Truncated needs has ->
    "the file is cut off: " ++ show needs ++ " samples are announced, " ++ show has ++ " are there"
  SampleAboveMaxval place v top ->
    "the sample at " ++ at place ++ " is " ++ show v ++ ", above the maximum value " ++ show top
  TrailingData n -> show n ++ " bytes after the image belong to no image"
  IsMovie n ->
    "a movie of " ++ show n
      ++ " frames; --poses FILE tells where they were pressed, FILE#0 is the \
         \first of them"
  NoSuchImage i n ->
    "there is no frame #" ++ show i ++ "; the file has " ++ show n ++ ", from #0 on"
  NumpyHeader -> "the .npy header is not valid"
  NumpyType descr ->
    "the .npy type is " ++ Bytes8.unpack descr ++ "; u1, u2, i2, i4, f4 and f8 are read"
  NumpyShape shape ->
    "the .npy shape is " ++ show shape ++ "; an image has two dimensions, a movie three"
  PngRefused why -> case why of
    PngBroken -> "the PNG file is broken"
    PngDepth -> "the PNG file has neither 8 nor 16 bits a sample"
    PngPalette -> "the PNG file has a palette; save it as grey"
    PngTransparent -> "the PNG file has transparency; save it as grey"
    PngColour -> "the PNG file has colours; save it as grey"
  ImageInEncoding encoding -> "the text" ++ encodingMessage encoding
  NotNumber line field found ->
    "line " ++ show line ++ ", number " ++ show field ++ " is " ++ show found ++ ", not a number"
  DecimalComma line found ->
    "line " ++ show line ++ " has a decimal comma, " ++ show found ++ "; write a decimal point"
  TekscanHeader key -> "the header of the Tekscan export has no usable " ++ key
  TekscanFrame i -> "the Tekscan export lacks frame " ++ show i ++ ", or has only a part of it"
  UnequalSpacing across down ->
    printf "columns are %.4g mm apart and rows %.4g mm; both must be the same" across down
  where
    by (w, h) = show w ++ " x " ++ show h
    at (x, y) = show x ++ "," ++ show y

-- | The format of a file that begins with these bytes, in words, if it is known.
formatText :: ByteString -> String
formatText start
  | Just name <- formatName start = ": it is " ++ name
  | Bytes.null start = ": it is empty"
  | otherwise = ""

headerMessage :: HeaderField -> ByteString -> String
headerMessage field found =
  "the PGM header's " ++ name ++ " is not a number"
    ++ if Bytes.null found then ": the file ends there" else ": " ++ show found
  where
    name = case field of
      HeaderWidth -> "width"
      HeaderHeight -> "height"
      HeaderMaxval -> "maximum value"

manifestMessage :: ManifestError -> String
manifestMessage e = case e of
  EmptyManifest -> "the manifest is empty"
  ManifestInEncoding encoding -> "the manifest" ++ encodingMessage encoding
  WrongHeader found ->
    "the first line is " ++ listed found ++ "; it must be " ++ listed manifestHeader
      ++ " (force_n may be left out)"
  NotCsv line -> at line ++ "is not CSV"
  WrongFieldCount line n wanted ->
    at line ++ "has " ++ show n ++ " fields instead of " ++ show wanted
      ++ if n > wanted then "; numbers have a decimal point, not a decimal comma" else ""
  BadFileName line -> at line ++ "has no usable file name"
  BadNumber line field found ->
    at line ++ Text.unpack field ++ " is " ++ show (Text.unpack found)
      ++ if decimalComma (Text.unpack found)
        then ", with a decimal comma; write a decimal point"
        else ", not a finite number"
  NoEntries -> "the manifest names no frame"
  where
    at line = "line " ++ show line ++ " "
    listed = intercalate "," . map Text.unpack
    decimalComma found = case break (== ',') found of
      (whole, ',' : fraction) ->
        all isDigit (dropWhile (`elem` "+- ") whole) && all isDigit fraction
      _ -> False

-- | The message about a movie's poses.
posesMessage :: ManifestError -> String
posesMessage e = case e of
  EmptyManifest -> "there are no poses"
  WrongHeader found ->
    "the first line is " ++ intercalate "," (map Text.unpack found)
      ++ "; it must be x_mm,y_mm,rotation_deg, or such numbers"
  NoEntries -> "there are no poses"
  _ -> manifestMessage e

probeMessage :: ProbeError -> String
probeMessage e = case e of
  SpacingTooSmall n -> "presses " ++ show n ++ " taxels apart never cover a region"
  RegionTooSmall w h ->
    "a region of " ++ show w ++ " x " ++ show h ++ " taxels is smaller than the sensor, 16 x 16"
  RegionBelowSensor w h across down ->
    "a region of " ++ show w ++ " x " ++ show h ++ " taxels is smaller than the sensor, "
      ++ printf "%.4g x %.4g" across down
  RegionTooLarge w h ->
    "a region of " ++ show w ++ " x " ++ show h ++ " taxels takes too many presses"

stitchMessage :: StitchError -> String
stitchMessage e = case e of
  NoFrames -> "there are no frames"
  TooManyFrames n -> show n ++ " frames are too many to assemble at once"
  FrameSize i w h ->
    "frame "
      ++ show (i + 1)
      ++ " is "
      ++ show w
      ++ " x "
      ++ show h
      ++ " taxels; frames are of one size, from 4 x 4 to 256 x 256"
  FrameRotation i degrees ->
    "frame "
      ++ show (i + 1)
      ++ " is turned by "
      ++ show degrees
      ++ " degrees, and too small to be turned back"
  FrameNotFinite i ->
    "frame " ++ show (i + 1) ++ " has a value or a pose that is not a finite number"
  FramePitch i pitch ->
    rangeText ("the distance of frame " ++ show (i + 1) ++ "'s taxels in millimetres") taxelPitches
      ++ "; it is stated as "
      ++ show pitch
  TooManyFramePixels n ->
    "the frames have " ++ show n ++ " pixels together, of 1.5875 mm or as given; at most "
      ++ show maxFramePixels
      ++ " can be put together"
  TooMuchToRegister (ComparedPixels n) ->
    "too many frames lie near each other: comparing them would take " ++ show n
      ++ " pixels, above the limit of "
      ++ show maxComparisons
  TooMuchToRegister (PairPixels n) ->
    "too many frames overlap: comparing their pairs would take " ++ show n
      ++ " pixels, above the limit of "
      ++ show maxPairPixels
  TooMuchToRegister (LatticePixels n) ->
    "a frame has " ++ show n ++ " pixels of 1.5875 mm; at most "
      ++ show maxLatticePixels
      ++ " can be compared with the lattice"
  UnusableRegistration _ ->
    "the registration's settings are unusable: sigma must be positive, noise not negative, the \
    \search radius 0 to 64 taxels"
  AreaTooLarge w h ->
    "the frames lie so far apart that the composite would have "
      ++ taxels w
      ++ " x "
      ++ taxels h
      ++ " taxels; check the manifest's positions (millimetres)"
  where
    taxels side
      | side < 1e9 = show (ceiling side :: Integer)
      | otherwise = printf "%.1e" side

-- | The message that frames contradict each other, with the options that would mend it.
contradictionMessage :: Contradiction -> String
contradictionMessage contradiction = case contradiction of
  AgreeingAlong axes ->
    contradictionMessage (asTaken standardConventions Nothing (AgreeingAlong axes))
  AgreeingBy others -> overlapping ++ "they agree with " ++ remediesText others
  AgreeingAtScale across down ->
    overlapping ++ "they agree if the positions are multiplied by " ++ scaleText across down
      ++ ": give --position-scale "
      ++ scaleOption across down
  AgreeingAnywhere count across down
    | max across down < samePlace ->
      printf
        "%d frames within %.2f mm of each other show different relief: give each frame's own \
        \position, in millimetres"
        count
        (max across down)
    | across < samePlace -> oneCoordinate "to the right" across
    | down < samePlace -> oneCoordinate "down" down
    | otherwise ->
      "the frames show different relief from what their positions say; check that each position is \
      \that of its own frame's centre, in millimetres"
    where
      oneCoordinate :: String -> Double -> String
      oneCoordinate along extent =
        printf
          "%d frames lie within %.2f mm of each other %s and show different relief; check that \
          \coordinate"
          count
          extent
          along
  where
    overlapping = "the frames show different things where their positions make them overlap; "
    samePlace = 2 :: Double

-- | The options of remedies, any of which will do.
remediesText :: [Remedy] -> String
remediesText = intercalate " or " . map options
  where
    options (Remedy positions images) =
      unwords
        ( ["--axes " ++ axesName axes | Just axes <- [positions]]
            ++ ["--image-axes " ++ axesName axes | Just axes <- [images]]
        )

-- | A scale of positions in words, with the unit that has this scale, if there is one.
scaleText :: Double -> Double -> String
scaleText across down
  | across == down = figures 3 across ++ maybe "" of' (unitOf across)
  | otherwise = figures 3 across ++ " across and " ++ figures 3 down ++ " down"
  where
    of' (_, unit) = " (are they in " ++ unit ++ "?)"

-- | A scale of positions as @--position-scale@ takes it.
scaleOption :: Double -> Double -> String
scaleOption across down
  | across == down = factor across
  | otherwise = factor across ++ "," ++ factor down
  where
    factor s = figures 5 (maybe s fst (unitOf s))

-- | The unit of this length in millimetres, to within 3 %.
unitOf :: Double -> Maybe (Double, String)
unitOf scale = find (\(millimetres, _) -> abs (scale / millimetres - 1) < 0.03) units
  where
    units =
      [ (1000, "metres"),
        (25.4, "inches"),
        (10, "centimetres"),
        (1.5875, "taxels of 1.5875 mm"),
        (0.001, "micrometres")
      ]

calibrationMessage :: CalibrationError -> String
calibrationMessage e = case e of
  NoDarkFrame -> "there are no dark frames"
  NoFlatFrame -> "there are no flat frames"
  SensorsDiffer one other ->
    "the calibration is of a sensor of " ++ by one ++ " taxels, and a frame has " ++ by other
  ReadingNotFinite -> "a frame has a value that is not a finite number"
  AllDead -> "no taxel reads more in the flat frames than in the dark ones: all are dead"
  AllSaturated -> "all taxels read full scale in the flat frames, so that their gains are not known"
  where
    by (w, h) = show w ++ " x " ++ show h

pairMessage :: PairError -> String
pairMessage e = case e of
  PairSizes a b -> "the frames differ in size: " ++ by a ++ " and " ++ by b ++ " taxels"
  PairFrameSize size ->
    "the frames are " ++ by size ++ " taxels; from 4 x 4 to 256 x 256 are registered"
  PairNotFinite -> "a frame has a value that is not a finite number"
  UnusablePairing _ ->
    "the settings are unusable: the step may be up to 1000 taxels, the search 0 to 64 taxels, the \
    \confidence 0 to 1"
  where
    by (w, h) = show w ++ " x " ++ show h

shapeMessage :: ShapeError -> String
shapeMessage e = case e of
  WrongRowCount n -> "a shape has 12 rows, not " ++ show n
  WrongRowWidth i n -> "row " ++ show (i + 1) ++ " of a shape is 8 taxels wide, not " ++ show n
  EmptyAlphabet -> "there are no shapes"
  TooManyShapes -> "there are more than " ++ show maxShapes ++ " shapes"
  BlankShape named -> "the shape " ++ Text.unpack named ++ " is blank"
  RepeatedName named -> "two shapes are named " ++ Text.unpack named
  RepeatedShape a b -> "the shapes " ++ Text.unpack a ++ " and " ++ Text.unpack b ++ " are the same"
  BadName named -> show (Text.unpack named) ++ " is not a valid name of a shape"
  UnknownClass c n -> "there is no shape for code " ++ show c ++ ": the alphabet has " ++ show n
  UnreadableLine line text ->
    "line "
      ++ show line
      ++ " is neither a row of # and . nor 'symbol NAME': "
      ++ show (Text.unpack text)
  RowWithoutSymbol line -> "the row on line " ++ show line ++ " comes before any 'symbol NAME'"
  BadDrawing line why -> "the drawing that begins on line " ++ show line ++ ": " ++ shapeMessage why
  NotText -> "the drawings are not UTF-8 text"
  DrawingsInEncoding encoding -> "the file of drawings" ++ encodingMessage encoding
  NoAlphabet -> "no alphabet meets the constraints"

shippedMessage :: ShippedError -> String
shippedMessage e = case e of
  NotShipped q ->
    printf
      "no shapes are shipped for the symbols of GF(%d), only for q = %s; name others by --shapes \
      \FILE"
      q
      (intercalate ", " (map show shippedSizes))
  ShippedShapes why -> shapeMessage why
  ShippedWeights why -> networkMessage why

networkMessage :: NetworkError -> String
networkMessage e = case e of
  WrongImageSize w h -> "the network takes symbols of 8 x 12, not " ++ show w ++ " x " ++ show h
  LayersDoNotFit -> "the network's layers do not fit each other"
  NotFinite -> "a weight of the network is not a finite number"
  WrongOutputCount given needs ->
    "the network has " ++ show given ++ " classes, but the alphabet has " ++ show needs
  EmptyBatch -> "there are no images to train with"
  NoSuchClass given needs ->
    "there is no class " ++ show given ++ ": the alphabet has " ++ show needs
  NetworkNotText -> "the network file is not UTF-8 text"
  NetworkInEncoding encoding -> "the network file" ++ encodingMessage encoding
  UnexpectedNetworkLine line expected found ->
    "line "
      ++ show line
      ++ " of the network file should be "
      ++ Text.unpack expected
      ++ "; it is "
      ++ show (Text.unpack found)
  NetworkFileEnds expected -> "the network file ends where " ++ Text.unpack expected ++ " should be"
