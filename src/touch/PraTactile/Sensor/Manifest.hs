{-# LANGUAGE OverloadedStrings #-}

-- | The manifest of a folder of frames, and its CSV form: one line per frame under the header
-- @file,x_mm,y_mm,rotation_deg,force_n@, of which unused columns may be missing.
-- "PraTactile.Format.Manifest" has the JSON form.
module PraTactile.Sensor.Manifest
  ( -- * Manifests
    Manifest (..),
    listing,
    Entry (..),
    frameOfMovie,
    manifestName,
    jsonManifestName,

    -- * Axes
    Axes (..),
    straight,
    axesNamed,
    axesName,
    alongAxes,

    -- * Interpretation of positions and images
    FrameConventions (..),
    standardConventions,
    Remedy (..),
    remedies,

    -- * As CSV
    parseManifest,
    parsePoses,
    renderManifest,
    manifestHeader,

    -- * Errors
    ManifestError (..),
  )
where

import Control.Monad (mfilter, unless)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.Char (isDigit, isSpace)
import Data.Csv
  ( DecodeOptions (decDelimiter),
    EncodeOptions (encUseCrLf),
    HasHeader (NoHeader),
    Record,
    decodeWith,
    defaultDecodeOptions,
    defaultEncodeOptions,
    encodeWith,
    toField,
  )
import Data.List (nub)
import Data.Maybe (fromMaybe, isJust)
import Data.Text (Text)
import qualified Data.Text as T
import Data.Text.Encoding (decodeUtf8')
import qualified Data.Vector as V
import PraTactile.Decimal (readDouble)
import PraTactile.FileName (isFileName)
import PraTactile.PlainText (OtherEncoding, plainText)
import PraTactile.Sensor.Frame (SensorPose (..), taxelPitch)
import PraTactile.Symmetry

-- | One line of a manifest: the frame's file, relative to the manifest's folder, or @FILE#3@ for
-- the fourth frame of a movie ('frameOfMovie'); the pose of the press, which calibration frames may
-- lack; and its force, which is optional and unused.
data Entry = Entry
  { entryFile :: !FilePath,
    entryPose :: !(Maybe SensorPose),
    entryForce :: !(Maybe Double)
  }
  deriving stock (Eq, Show)

-- | A manifest. Optional are the distance of neighbouring taxels in millimetres, the frames' width
-- and height, the axes of its two coordinates, and the full scale of the readings. Then one entry
-- per frame.
data Manifest = Manifest
  { manifestTaxel :: !(Maybe Double),
    manifestFrame :: !(Maybe (Int, Int)),
    manifestAxes :: !(Maybe Axes),
    manifestFullScale :: !(Maybe Double),
    manifestEntries :: ![Entry]
  }
  deriving stock (Eq, Show)

-- | The manifest with these entries and no other information.
listing :: [Entry] -> Manifest
listing = Manifest Nothing Nothing Nothing Nothing

-- | The file and the frame number (from 0) of a name that means a frame of a movie.
--
-- >>> frameOfMovie "press.npy#3"
-- Just ("press.npy",3)
frameOfMovie :: FilePath -> Maybe (FilePath, Int)
frameOfMovie name = case break (== '#') (reverse name) of
  (digits@(_ : _), _ : file@(_ : _))
    | all isDigit digits && length digits <= 9 -> Just (reverse file, read (reverse digits))
  _ -> Nothing

-- | The name of the manifest in a folder of frames.
manifestName :: FilePath
manifestName = "manifest.csv"

-- | The name of a manifest in its JSON form.
jsonManifestName :: FilePath
jsonManifestName = "manifest.json"

-- | The directions of the two coordinates of positions or of pixels, seen from outside the face:
-- each is x (right), y (down) or its negative. Rotations are clockwise, whatever the axes are.
newtype Axes = Axes
  { -- | Maps the two coordinates to (right, down).
    axesSymmetry :: Symmetry
  }
  deriving stock (Eq, Ord, Show)

-- | The axes x, y.
straight :: Axes
straight = Axes identity

-- | All eight axes by name: @x,y@, @x,-y@, @y,x@ and so on.
axesNamed :: [(String, Axes)]
axesNamed =
  [ (axesName axes, axes)
    | swapped <- [identity, turned 3 <> mirror],
      negated <- [identity, turned 2 <> mirror, mirror, turned 2],
      let axes = Axes (swapped <> negated)
  ]

-- | The name of axes.
axesName :: Axes -> String
axesName axes = coordinate (1, 0) ++ "," ++ coordinate (0, 1)
  where
    coordinate :: (Int, Int) -> String
    coordinate along = case onOffset (axesSymmetry axes) along of
      (x, 0) -> ['-' | x < 0] ++ "x"
      (_, y) -> ['-' | y < 0] ++ "y"

-- | Converts a pose whose coordinates are along the given axes to right and down.
--
-- >>> alongAxes <$> lookup "x,-y" axesNamed <*> pure (SensorPose 1 2 0)
-- Just (SensorPose {poseX = 1.0, poseY = -2.0, poseRotation = 0.0})
alongAxes :: Axes -> SensorPose -> SensorPose
alongAxes axes (SensorPose first second r) = SensorPose x y r
  where
    (x, y) = onOffset (axesSymmetry axes) (first, second)

-- | How positions and images are interpreted: the axes of the positions, the axes of the images,
-- and the factors of the positions across and down.
data FrameConventions = FrameConventions
  { positionAxes :: !Axes,
    imageAxes :: !Axes,
    positionScale :: !(Double, Double),
    -- | the distance of neighbouring taxels, millimetres
    conventionsTaxel :: !Double
  }
  deriving stock (Eq, Show)

-- | The standard interpretation: positions in millimetres and images seen from outside the face, x
-- to the right and y down.
standardConventions :: FrameConventions
standardConventions = FrameConventions straight straight (1, 1) taxelPitch

-- | A change of the interpretation; 'Nothing' where it stays as it is.
data Remedy = Remedy
  { remedyPositions :: !(Maybe Axes),
    remedyImages :: !(Maybe Axes)
  }
  deriving stock (Eq, Show)

-- | The remedies after which frames agree, up to a rotation of the whole. The arguments are the
-- present interpretation; the axes A, along which the positions (as interpreted now) must be taken
-- in addition; and whether the frames are then mirrored, if known.
--
-- Frames agree if A is applied to the positions, or the inverse of A to the images. Any symmetry
-- applied to both keeps them agreeing. A mirrored result needs a mirroring symmetry on both.
remedies :: FrameConventions -> Axes -> Maybe Bool -> [Remedy]
remedies (FrameConventions (Axes positions) (Axes images) _ _) (Axes a) mirroredThen =
  map remedy $ case mirroredThen of
    Just True
      | mirrored a -> [ofImages]
      | otherwise -> [both]
    Just False
      | mirrored a -> [ofPositions]
    _ -> [ofPositions, ofImages]
  where
    ofPositions = (a <> positions, images)
    ofImages = (positions, invert a <> images)
    both = (h <> a <> positions, h <> images)
    h = if mirrored (a <> positions) then invert (a <> positions) else mirror
    remedy (positions', images') = Remedy (changed positions positions') (changed images images')
    changed old new = if new == old then Nothing else Just (Axes new)

-- | Why a manifest is refused. Lines count from 1, which is the header.
data ManifestError
  = -- | The file has no lines.
    EmptyManifest
  | -- | The file is text in this encoding, not in UTF-8.
    ManifestInEncoding !OtherEncoding
  | -- | The first line, given here by its fields, is not the header.
    WrongHeader ![Text]
  | -- | The line is not a CSV record.
    NotCsv !Int
  | -- | This line has this many fields; expected were that many.
    WrongFieldCount !Int !Int !Int
  | -- | The file name in this line is not UTF-8 or not a valid file name ('isFileName').
    BadFileName !Int
  | -- | In this line the field with this column name is not a number of 'readDouble'; its text.
    BadNumber !Int !Text !Text
  | -- | The file names no frame.
    NoEntries
  deriving stock (Eq, Show)

-- | A column of a manifest.
data Column = File | X | Y | Rotation | Force
  deriving stock (Eq, Ord, Enum, Bounded)

-- | The name of a column.
columnName :: Column -> Text
columnName column = case column of
  File -> "file"
  X -> "x_mm"
  Y -> "y_mm"
  Rotation -> "rotation_deg"
  Force -> "force_n"

-- | The names of the columns, in their usual order.
manifestHeader :: [Text]
manifestHeader = map columnName [minBound ..]

-- | Reads the entries of a CSV manifest, a 'plainText'. The header names the columns, in any
-- order, capitals or not. The separator is a comma, or a semicolon throughout the file. Optional
-- are the force (as a column or in a line), the rotation (default 0), and the whole position. Blank
-- lines are skipped. Fields may be quoted but not hold a line break. Refusals are 'ManifestError's.
parseManifest :: ByteString -> Either ManifestError [Entry]
parseManifest = either (Left . ManifestInEncoding) parsePlain . plainText

parsePlain :: ByteString -> Either ManifestError [Entry]
parsePlain = entriesOf (elem File)

-- | Reads the poses of a movie's frames, one line per frame: a manifest without the file column.
-- Without a header, the columns are x, y, then optionally the rotation, then the force.
parsePoses :: ByteString -> Either ManifestError [Entry]
parsePoses = either (Left . ManifestInEncoding) (entriesOf (elem X)) . plainText

-- | The entries of a file. The function decides whether the columns suffice.
entriesOf :: ([Column] -> Bool) -> ByteString -> Either ManifestError [Entry]
entriesOf enough text = case filter (not . B.null . snd) (zip [1 ..] (C.lines text)) of
  [] -> Left EmptyManifest
  (i, header) : rest -> do
    let separator = separatorOf header
    names <- V.toList <$> record separator i header
    let withoutHeader = length names `elem` [2 .. 4] && all isNumber names
        found
          | withoutHeader = Just (take (length names) [X, Y, Rotation, Force])
          | otherwise = columnsOf names
    columns <-
      maybe (Left (WrongHeader (map shown names))) Right (mfilter enough found)
    entries <-
      traverse
        (uncurry (entry separator columns))
        ([(i, header) | withoutHeader] ++ rest)
    if null entries then Left NoEntries else Right entries
  where
    isNumber = either (const False) (const True) . readDouble . C.strip

-- | The separator of a file with this header.
separatorOf :: ByteString -> Char
separatorOf header = if C.elem ',' header || C.notElem ';' header then ',' else ';'

-- | The columns with these names. 'Nothing' for an unknown or repeated name, for only one of x and
-- y, and for a rotation without a position.
columnsOf :: [ByteString] -> Maybe [Column]
columnsOf names = do
  columns <- traverse ((`lookup` named) . normal) names
  let ofPosition = filter (`elem` columns) [X, Y]
      placed = null ofPosition || ofPosition == [X, Y]
      turnedAlone = Rotation `elem` columns && null ofPosition
  if nub columns == columns && placed && not turnedAlone
    then Just columns
    else Nothing
  where
    named = [(columnName column, column) | column <- [minBound ..]]
    normal = T.toLower . T.strip . shown

-- | The fields of one line. Lines are split before cassava sees them, because cassava drops blank
-- lines, and line numbers would be wrong. Note [Open quotes]
record :: Char -> Int -> ByteString -> Either ManifestError Record
record separator i line
  | odd (C.count '"' line) = Left (NotCsv i)
  | otherwise = case decodeWith parted NoHeader (L.fromStrict line) of
    Right records -> case V.toList records of
      [] -> Right (V.singleton B.empty) -- cassava drops a record of one empty field
      [fields] -> Right fields
      _ -> Left (NotCsv i)
    Left _ -> Left (NotCsv i)
  where
    parted = defaultDecodeOptions {decDelimiter = fromIntegral (fromEnum separator)}

{- Note [Open quotes] cassava 0.5.3 throws an exception, instead of refusing, for a quoted field
   that opens at the end of the line. A record without a line break has an even number of quotes, so
   a line with an odd number is refused first. -}

entry :: Char -> [Column] -> Int -> ByteString -> Either ManifestError Entry
entry separator columns i line = do
  fields <- V.toList <$> record separator i line
  unless (length fields == length columns) $
    Left (WrongFieldCount i (length fields) (length columns))
  let given = zip columns fields
      field column = lookup column given
  name <- either (const (Left (BadFileName i))) Right (decodeUtf8' (fromMaybe "" (field File)))
  unless (File `notElem` columns || isFileName (T.unpack name)) (Left (BadFileName i))
  x <- traverse (number X) (field X)
  y <- traverse (number Y) (field Y)
  rotation <- traverse (number Rotation) (field Rotation)
  force <- traverse (number Force) (mfilter (not . C.all isSpace) (field Force))
  pure (Entry (T.unpack name) (SensorPose <$> x <*> y <*> Just (fromMaybe 0 rotation)) force)
  where
    number column text =
      either
        (const (Left (BadNumber i (columnName column) (shown text))))
        Right
        (readDouble (C.strip text))

-- | A field as text for a message.
shown :: ByteString -> Text
shown field = either (const (T.pack (show field))) id (decodeUtf8' field)

-- | The CSV manifest of the given entries, with poses if all have one, and with the forces that
-- are there. 'parseManifest' restores the entries exactly under these conditions: there is at least
-- one entry; all or none have a pose; file names are valid and hold no line break; numbers are
-- finite.
renderManifest :: [Entry] -> ByteString
renderManifest entries =
  L.toStrict (encodeWith defaultEncodeOptions {encUseCrLf = False} (header : map fields entries))
  where
    columns =
      [File] ++ (if all (isJust . entryPose) entries then [X, Y, Rotation] else [])
        ++ [Force | any (isJust . entryForce) entries]
    header = V.fromList (map (toField . columnName) columns)
    fields one = V.fromList [fromMaybe "" (lookup column (filled one)) | column <- columns]
    filled (Entry file pose force) =
      (File, toField (T.pack file)) :
      concat
        [ [(X, toField x), (Y, toField y), (Rotation, toField r)]
          | Just (SensorPose x y r) <-
              [pose]
        ]
        ++ [(Force, toField n) | Just n <- [force]]
