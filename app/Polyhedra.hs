-- | Polyhedra as the command line names them: a file, or a name such as @box:100x60x40@.
module Polyhedra
  ( -- * Reading
    SolidReading (..),
    asUsual,
    readingOptions,
    readingWith,
    readingGroup,
    formatOption,
    Polyhedron (..),
    polyhedron,
    readBy,
    fileContents,

    -- * Formats and sizes
    formatHeeded,
    outputFormat,
    positiveReader,
    symbolsOption,
  )
where

import Control.Monad (unless)
import Data.List (intercalate)
import Data.Maybe (isJust, isNothing)
import ExitStatus
import Files (readBytes)
import Message.Solid
import Options
import PraTactile.Array (Shape (..))
import PraTactile.Decimal (readExact)
import PraTactile.Format.Solid
import PraTactile.Format.Solid.Name
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Mend
import PraTactile.Object.Mesh
import PraTactile.Object.Named (namedDescription)
import PraTactile.Object.Placement (Pitch)
import PraTactile.Object.Plate (plateSize)
import System.FilePath (dropExtension, takeFileName)
import Visible

-- | The options for reading polyhedra.
data SolidReading = SolidReading
  { -- | for files whose names do not end in one
    readingFormat :: Maybe SolidFormat,
    -- | the factor of all lengths
    readingScale :: Rational,
    readingMending :: Mending
  }
  deriving stock (Eq)

-- | The default: files in the format that their names end in, unscaled, with coplanar triangles
-- merged.
asUsual :: SolidReading
asUsual = SolidReading Nothing 1 asItIs {mendMerging = TrianglesMerged}

-- | The options of all commands that make something of polyhedra: @--scale@, @--tolerance@,
-- @--fix-orientation@, @--keep-triangles@ and @--format@.
readingOptions :: Parser SolidReading
readingOptions =
  readingWith
    ( flag
        TrianglesMerged
        AsWritten
        ( long "keep-triangles"
            <> help
              "Keep adjacent triangles of one plane apart (default: they are merged into one face)"
        )
    )
    formatOption

-- | The options of 'readingWith' and 'readingOptions', as a group of a command's help.
readingGroup :: Group
readingGroup =
  Group
    "How files of solids are read"
    (words "scale tolerance fix-orientation merge-coplanar keep-triangles format")

-- | How polyhedra are read, given the options that say which faces are merged, and the format.
readingWith :: Parser Merging -> Parser (Maybe SolidFormat) -> Parser SolidReading
readingWith merging format =
  made
    <$> option
      (positiveReader "a factor")
      ( long "scale" <> metavar "S" <> value 1
          <> help "Multiply all lengths by this factor; 25.4 for a file in inches (default: 1)"
      )
    <*> optional
      ( valued
          (positiveReader "a length")
          "tolerance"
          "MM"
          "Mend defects up to this size: merge vertices this near, leave out faces this near to a \
          \line, move vertices by this much to make faces flat"
      )
    <*> switch
      ( long "fix-orientation"
          <> help "Turn faces so that all are counter-clockwise, seen from outside"
      )
    <*> merging
    <*> format
  where
    made scale tolerance turning faces said =
      SolidReading said scale (Mending tolerance turning faces)

-- | A polyhedron that was read.
data Polyhedron = Polyhedron
  { -- | as its file has it, at its scale
    polyhedronGiven :: Mesh,
    -- | what else its file has
    polyhedronPassed :: [Passed],
    -- | mended
    polyhedronMesh :: Mesh,
    polyhedronChanges :: Changes
  }

-- | The polyhedron of a name or a file. The sheet has room for an array of this shape with this
-- pitch.
polyhedron :: Shape -> Pitch -> SolidReading -> String -> IO Polyhedron
polyhedron shape between reading subject =
  contentsOf (plateSize shape between) (readingFormat reading) subject >>= readBy reading subject

-- | The polyhedron of a file or a name, scaled and mended as the options say.
readBy :: SolidReading -> String -> Contents -> IO Polyhedron
readBy reading subject (Contents whole passed) = do
  let given = scaledBy (readingScale reading) whole
  Mended it changes <-
    orUnusable
      (\why -> visibleName subject ++ ": " ++ tooFineMessage why)
      (mended (readingMending reading) given)
  pure (Polyhedron given passed it changes)

-- | The contents that a name stands for, or those of a file. The file's format is the one that its
-- name ends in, or else the given one. The sheet has this width and depth.
contentsOf :: (Rational, Rational) -> Maybe SolidFormat -> String -> IO Contents
contentsOf plate given subject = case readName plate subject of
  Known known -> pure (Contents (fromDescription (namedDescription known)) [])
  Malformed wanted -> unusable (solidNameMessage subject wanted)
  Irrational name ->
    unusable
      ( "a regular " ++ name
          ++ " has no rational vertices, since no rational rotation has order 5; the pyritohedron \
             \has, which is a dodecahedron: pyritohedron:A"
      )
  NoName -> fileContents given subject

-- | The contents of a file, in the format that its name ends in, or else in this one.
fileContents :: Maybe SolidFormat -> FilePath -> IO Contents
fileContents given subject = do
  told <- case formatOfFile subject of
    Just told -> pure told
    Nothing -> maybe (misused (endless subject)) pure given
  bytes <- readBytes subject
  orUnusable
    (solidFileMessage subject told)
    (readSolid told (objectCalled (objectNameOf subject)) bytes)
  where
    objectNameOf "-" = "standard-input"
    objectNameOf file = dropExtension (takeFileName file)

-- | @--format@.
formatOption :: Parser (Maybe SolidFormat)
formatOption =
  optional
    ( choosing
        "format"
        [(formatName one, one) | one <- [minBound .. maxBound]]
        "format"
        "FORMAT"
        "Format of files whose names do not end in one"
        mempty
    )

-- | Refuses @--format@ if it would change nothing: if all names of files, read and written, end in
-- a known format, and it does not choose the text form of STL or PLY for the written one.
formatHeeded :: Maybe SolidFormat -> [String] -> Maybe FilePath -> IO ()
formatHeeded said subjects output =
  unless (any untold subjects || any chosen output) $
    leaveOut "the format is known from the names" [("--format", isJust said)]
  where
    untold subject = case readName (plateSize (Shape 1 1) canonicalPitch) subject of
      NoName -> isNothing (formatOfFile subject)
      _ -> False
    -- Both forms of a format have one end.
    chosen file = case formatOfFile file of
      Nothing -> True
      Just told -> (told, said) `elem` [(Stl, Just StlText), (Ply, Just PlyText)]

-- | The format in which a file is written, given what @--format@ says.
outputFormat :: Maybe SolidFormat -> FilePath -> IO SolidFormat
outputFormat said file = case (formatOfFile file, said) of
  (Just Stl, Just StlText) -> pure StlText
  (Just Ply, Just PlyText) -> pure PlyText
  (Just told, _) -> pure told
  (Nothing, Just given) -> pure given
  (Nothing, Nothing) -> misused (endless file)

endless :: FilePath -> String
endless file =
  "the name " ++ visibleName file ++ " does not end in a known format; give --format "
    ++ intercalate "|" (map formatName [minBound .. maxBound])

-- | An exact number above 0.
positiveReader :: String -> ReadM Rational
positiveReader what = eitherReader $ \text -> case readExact text of
  Just n | n > 0 -> Right n
  _ -> Left (quoted text ++ " is not " ++ what ++ " above 0, such as 25.4 or 127/5")

-- | @--symbols@.
symbolsOption :: Parser Rational
symbolsOption =
  option
    (positiveReader "a factor")
    ( long "symbols" <> metavar "S" <> value 1
        <> help "Size of the symbols: S times 25.4 x 31.75 mm from one to the next (default: 1)"
    )
