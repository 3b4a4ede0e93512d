{-# LANGUAGE OverloadedStrings #-}

-- | The manifest of a folder of frames: what it says, and its CSV form, one line a frame, with the
-- header @file,x_mm,y_mm,rotation_deg,force_n@, of which what is not used may be left out.
-- "PraTactile.Format.Manifest" has its JSON form.
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

    -- * Other ways to take positions and images
    Taking (..),
    standardTaking,
    Remedy (..),
    remedies,

    -- * As CSV
    parseManifest,
    parsePoses,
    renderManifest,
    manifestHeader,

    -- * What can be wrong
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
import PraTactile.Sensor.Frame (Pose (..), taxelPitch)
import PraTactile.Symmetry

-- | One line: the frame's file, relative to the manifest's folder, or @FILE#3@ for the fourth frame
-- of a movie ('frameOfMovie'); the pose of the press, which
-- calibration frames need not have; and its force, which nothing needs.
data Entry = Entry
  { entryFile :: !FilePath,
    entryPose :: !(Maybe Pose),
    entryForce :: !(Maybe Double)
  }
  deriving stock (Eq, Show)

-- | A manifest: the distance of neighbouring taxels in millimetres, the frames' width and height,
-- what its two coordinates are and the reading of full contact, as far as it says these; and a line
-- a frame.
data Manifest = Manifest
  { manifestTaxel :: !(Maybe Double),
    manifestFrame :: !(Maybe (Int, Int)),
    manifestAxes :: !(Maybe Axes),
    manifestFullScale :: !(Maybe Double),
    manifestEntries :: ![Entry]
  }
  deriving stock (Eq, Show)

-- | What a manifest of these entries says that says nothing else.
listing :: [Entry] -> Manifest
listing = Manifest Nothing Nothing Nothing Nothing

-- | The file of a movie and the number of its frame, from 0, that a name means.
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

-- | What two coordinates of positions or of pixels are, seen from outside the face: each x to the
-- right or y down, or its negative. Rotations are clockwise, whatever the axes are.
newtype Axes = Axes
  { -- | Carries what the coordinates say to what lies to the right and down.
    axesSymmetry :: Symmetry
  }
  deriving stock (Eq, Ord, Show)

-- | First x, then y.
straight :: Axes
straight = Axes identity

-- | All axes by their names: @x,y@, @x,-y@, @y,x@ and so on.
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

-- | A pose whose two coordinates are along these axes, to the right and down.
--
-- >>> alongAxes <$> lookup "x,-y" axesNamed <*> pure (Pose 1 2 0)
-- Just (Pose {poseX = 1.0, poseY = -2.0, poseRotation = 0.0})
alongAxes :: Axes -> Pose -> Pose
alongAxes axes (Pose first second r) = Pose x y r
  where
    (x, y) = onOffset (axesSymmetry axes) (first, second)

-- | What the two coordinates of the positions and of the images are taken to be, and what the
-- positions are multiplied by, across and down; and the distance of taxels.
data Taking = Taking
  { takenPositions :: !Axes,
    takenImages :: !Axes,
    takenScale :: !(Double, Double),
    -- | the distance of neighbouring taxels, millimetres
    takenTaxel :: !Double
  }
  deriving stock (Eq, Show)

-- | Positions in millimetres and images seen from outside the face, x to the right and y down.
standardTaking :: Taking
standardTaking = Taking straight straight (1, 1) taxelPitch

-- | What to take otherwise; 'Nothing' where the taking stays.
data Remedy = Remedy
  { remedyPositions :: !(Maybe Axes),
    remedyImages :: !(Maybe Axes)
  }
  deriving stock (Eq, Show)

-- | All the remedies that differ by more than a turn of the whole, where frames agree if positions,
-- as they are taken now, are taken along axes A besides, and what the frames then show is mirrored
-- or not, or that is not known.
--
-- Frames agree if A is applied to the positions, or if the inverse of A is applied to the images;
-- and any symmetry applied to both keeps them agreeing. What is mirrored takes a symmetry of both
-- that mirrors.
remedies :: Taking -> Axes -> Maybe Bool -> [Remedy]
remedies (Taking (Axes positions) (Axes images) _ _) (Axes a) mirroredThen =
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

-- | Why a manifest is refused. Lines count from 1, the header's.
data ManifestError
  = -- | The file has no line at all.
    EmptyManifest
  | -- | The file is text in this encoding, and not in UTF-8.
    ManifestInEncoding !OtherEncoding
  | -- | The first line is not the header; what it is.
    WrongHeader ![Text]
  | -- | The line is not a CSV record.
    NotCsv !Int
  | -- | The line has this many fields instead of that many.
    WrongFieldCount !Int !Int !Int
  | -- | The line's file name is not UTF-8, or no file's name ('isFileName').
    BadFileName !Int
  | -- | The line's field of that name is no decimal number that 'readDouble' reads; what it is.
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

-- | The entries of a manifest, a 'plainText'. Its header names the columns, in any order and in
-- capitals or not, parted by commas, or all of the file by semicolons. The force may be left out,
-- as a column or in a line; so may the rotation, which is 0 then; and the whole position. Blank
-- lines are passed over; fields may be quoted but not hold a line break.
parseManifest :: ByteString -> Either ManifestError [Entry]
parseManifest = either (Left . ManifestInEncoding) parsePlain . plainText

parsePlain :: ByteString -> Either ManifestError [Entry]
parsePlain = entriesOf (elem File)

-- | The poses of a movie's frames, one line a frame: the columns of a manifest but for the file's.
-- Where the first line is numbers, these are x, y, perhaps the rotation, and perhaps the force.
parsePoses :: ByteString -> Either ManifestError [Entry]
parsePoses = either (Left . ManifestInEncoding) (entriesOf (elem X)) . plainText

-- | The entries under a header with such columns.
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

-- | What parts the fields of a file with this header.
separatorOf :: ByteString -> Char
separatorOf header = if C.elem ',' header || C.notElem ';' header then ',' else ';'

-- | The columns that these names name: each once, of the position both or none, and no rotation
-- without it.
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

-- | One line's fields. The lines are split before cassava sees them, because it drops blank ones
-- and so would lose count. Note [Open quotes]
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

{- Note [Open quotes] cassava 0.5.3 throws an exception, where it should refuse, for a quoted field
   that ends the line as soon as it begins. A record that holds no line break has an even number of
   quotes, so a line with an odd number is refused before. -}

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
  pure (Entry (T.unpack name) (Pose <$> x <*> y <*> Just (fromMaybe 0 rotation)) force)
  where
    number column text =
      either
        (const (Left (BadNumber i (columnName column) (shown text))))
        Right
        (readDouble (C.strip text))

-- | A field for a message.
shown :: ByteString -> Text
shown field = either (const (T.pack (show field))) id (decodeUtf8' field)

-- | The manifest of those entries: with poses if all have one, and with the forces that there are.
-- 'parseManifest' gives the entries back, to the bit, provided that there are some, that all have a
-- pose or none has, that no file name holds a line break or is none, and that the numbers are
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
      concat [[(X, toField x), (Y, toField y), (Rotation, toField r)] | Just (Pose x y r) <- [pose]]
        ++ [(Force, toField n) | Just n <- [force]]
