{-# LANGUAGE OverloadedStrings #-}

-- | The manifest of a folder of frames: what it says, and its CSV form, one line a frame, with the
-- header @file,x_mm,y_mm,rotation_deg,force_n@. "PraTactile.Format.Manifest" has its JSON form.
module PraTactile.Sensor.Manifest
  ( -- * Manifests
    Manifest (..),
    listing,
    Entry (..),
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
    renderManifest,
    manifestHeader,

    -- * What can be wrong
    ManifestError (..),
  )
where

import Control.Monad (unless)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.Csv
  ( EncodeOptions (encUseCrLf),
    HasHeader (NoHeader),
    Parser,
    Record,
    decode,
    defaultEncodeOptions,
    encodeWith,
    parseField,
    runParser,
    toField,
    toRecord,
  )
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as T
import Data.Text.Encoding (decodeUtf8')
import qualified Data.Vector as V
import PraTactile.FileName (isFileName)
import PraTactile.Sensor.Frame (Pose (..), taxelPitch)
import PraTactile.Symmetry

-- | One line: the frame's PGM file, relative to the manifest's folder; the pose and the force of
-- the press.
data Entry = Entry
  { entryFile :: !FilePath,
    entryPose :: !Pose,
    entryForce :: !Double
  }
  deriving stock (Eq, Show)

-- | A manifest: the distance of neighbouring taxels in millimetres, the frames' width and height if
-- it says them, what its two coordinates are, if it says that, and a line a frame.
data Manifest = Manifest
  { manifestTaxel :: !Double,
    manifestFrame :: !(Maybe (Int, Int)),
    manifestAxes :: !(Maybe Axes),
    manifestEntries :: ![Entry]
  }
  deriving stock (Eq, Show)

-- | What a manifest of these entries says that says nothing else: taxels of 'taxelPitch', frames of
-- any size, which are 'straight' then.
listing :: [Entry] -> Manifest
listing = Manifest taxelPitch Nothing Nothing

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
  | -- | The first line is not the header; what it is.
    WrongHeader ![Text]
  | -- | The line is not a CSV record.
    NotCsv !Int
  | -- | The line has this many fields instead of five.
    WrongFieldCount !Int !Int
  | -- | The line's file name is not UTF-8, or no file's name ('isFileName').
    BadFileName !Int
  | -- | The line's field of that name is not a finite decimal number of at most 400 characters;
    -- what it is.
    BadNumber !Int !Text !Text
  | -- | The file names no frame.
    NoEntries
  deriving stock (Eq, Show)

-- | The names of the columns, in their order.
manifestHeader :: [Text]
manifestHeader = ["file", "x_mm", "y_mm", "rotation_deg", "force_n"]

-- | The entries of a manifest. Blank lines, a byte order mark and carriage returns at the ends of
-- lines are passed over; fields may be quoted but not hold a line break.
parseManifest :: ByteString -> Either ManifestError [Entry]
parseManifest file = case filter
  (not . B.null . snd)
  (zip [1 ..] (map trimmed (C.lines (unmarked file)))) of
  [] -> Left EmptyManifest
  (i, header) : rest -> do
    names <- record i header
    if V.toList names == map encoded manifestHeader
      then Right ()
      else Left (WrongHeader (map shown (V.toList names)))
    entries <- traverse (uncurry entry) rest
    if null entries then Left NoEntries else Right entries
  where
    unmarked f = fromMaybe f (B.stripPrefix "\xef\xbb\xbf" f)
    trimmed = C.dropWhileEnd (== '\r')
    encoded = toField

-- | One line's fields. The lines are split before cassava sees them, because it drops blank ones
-- and so would lose count. Note [Open quotes]
record :: Int -> ByteString -> Either ManifestError Record
record i line
  | odd (C.count '"' line) = Left (NotCsv i)
  | otherwise = case decode NoHeader (L.fromStrict line) of
    Right records -> case V.toList records of
      [] -> Right (V.singleton B.empty) -- cassava drops a record of one empty field
      [fields] -> Right fields
      _ -> Left (NotCsv i)
    Left _ -> Left (NotCsv i)

{- Note [Open quotes] cassava 0.5.3 throws an exception, where it should refuse, for a quoted field
   that ends the line as soon as it begins. A record that holds no line break has an even number of
   quotes, so a line with an odd number is refused before. -}

entry :: Int -> ByteString -> Either ManifestError Entry
entry i line = do
  fields <- record i line
  case V.toList fields of
    [file, x, y, rotation, force] -> do
      name <- either (const (Left (BadFileName i))) Right (decodeUtf8' file)
      unless (isFileName (T.unpack name)) (Left (BadFileName i))
      pose <- Pose <$> number "x_mm" x <*> number "y_mm" y <*> number "rotation_deg" rotation
      Entry (T.unpack name) pose <$> number "force_n" force
    other -> Left (WrongFieldCount i (length other))
  where
    -- The length is looked at first: the time that cassava takes for a number grows with the square
    -- of its digits.
    number name field
      | B.length field <= longestNumber,
        Right v <- runParser (parseField field :: Parser Double),
        not (isNaN v || isInfinite v) =
        Right v
      | otherwise = Left (BadNumber i name (shown field))

-- | How many characters a number may have: 400.
longestNumber :: Int
longestNumber = 400

-- | A field for a message.
shown :: ByteString -> Text
shown field = either (const (T.pack (show field))) id (decodeUtf8' field)

-- | The manifest of those entries. 'parseManifest' gives the entries back, to the bit, provided
-- that there are some, that no file name holds a line break or is none, and that the numbers are
-- finite.
renderManifest :: [Entry] -> ByteString
renderManifest entries =
  L.toStrict (encodeWith defaultEncodeOptions {encUseCrLf = False} (header : map fields entries))
  where
    header = V.fromList (map toField manifestHeader)
    fields (Entry file (Pose x y r) force) = toRecord (T.pack file, x, y, r, force)
