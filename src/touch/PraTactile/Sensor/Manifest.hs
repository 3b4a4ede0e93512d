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
    Axes,
    straight,
    axesNamed,
    axesName,
    alongAxes,

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

-- | What the two coordinates of a manifest are: each x to the right or y down, or its negative.
-- Rotations are clockwise as seen from outside the face, whatever the axes are.
data Axes = Axes
  { -- | whether the first is y and the second x
    axesSwapped :: !Bool,
    firstNegated :: !Bool,
    secondNegated :: !Bool
  }
  deriving stock (Eq, Ord, Show)

-- | First x, then y.
straight :: Axes
straight = Axes False False False

-- | All axes by their names: @x,y@, @x,-y@, @y,x@ and so on.
axesNamed :: [(String, Axes)]
axesNamed =
  [ (axesName axes, axes)
    | swapped <- [False, True],
      a <- [False, True],
      b <- [False, True],
      let axes = Axes swapped a b
  ]

-- | The name of axes.
axesName :: Axes -> String
axesName (Axes swapped a b) = sign a ++ one ++ "," ++ sign b ++ other
  where
    (one, other) = if swapped then ("y", "x") else ("x", "y")
    sign negated = if negated then "-" else ""

-- | A pose whose two coordinates are along these axes, to the right and down.
--
-- >>> alongAxes <$> lookup "x,-y" axesNamed <*> pure (Pose 1 2 0)
-- Just (Pose {poseX = 1.0, poseY = -2.0, poseRotation = 0.0})
alongAxes :: Axes -> Pose -> Pose
alongAxes (Axes swapped a b) (Pose first second r)
  | swapped = Pose v u r
  | otherwise = Pose u v r
  where
    u = if a then negate first else first
    v = if b then negate second else second

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
