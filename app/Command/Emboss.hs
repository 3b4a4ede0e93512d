-- | @pra-tactile emboss@: objects with their symbols raised, as files for a printer or a cutter.
module Command.Emboss
  ( command,
  )
where

import ArrayChoice (unsaid)
import Control.Monad (unless, when)
import Counted
import Data.Bifunctor (first)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.List (intercalate, nub)
import Data.Maybe (isJust, listToMaybe)
import EmbossedFiles
import ExitStatus
import Message
import Options
import Output
import PlacementChoice
import Polyhedra (positiveReader)
import PraTactile.Emboss
import PraTactile.Format.Emboss
import PraTactile.Object.Placement hiding (Spot (..))
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import Progress
import Setup
import System.FilePath (takeExtension, (</>))
import Visible

data Options = Options
  { objects :: PlacementChoice,
    asked :: Maybe (ObjectName, Maybe (FaceName, Maybe Rational)),
    asNet :: Maybe (Maybe (Double, Double)),
    shapesFile :: Maybe FilePath,
    format :: Maybe Making,
    output :: FilePath,
    form :: AnswerForm
  }

-- | The kind of the files.
data Making
  = Surface SurfaceFormat
  | Drawn

command :: Subcommand
command =
  subcommand
    "emboss"
    "Write objects with raised symbols, for a printer"
    "Write objects with their symbols raised, as closed surfaces of triangles for a printer. Or \
    \write one face as a plate, or faces at true scale as drawings."
    []
    [ "pra-tactile emboss --object cube --output cube.stl",
      "pra-tactile emboss --object cube --face 'C1 C2 C3 C4' --thickness 5 --output top.stl",
      "pra-tactile emboss --object cube --output cube.3mf",
      "pra-tactile emboss --format svg --object cube --output cube-faces",
      "pra-tactile emboss --net --object cube --output cube-net.svg",
      "pra-tactile emboss --net --page 210x297 --object cube --output cube-pages",
      "pra-tactile emboss --placement placement.json --output made --json"
    ]
    ( run
        <$> ( Options
                <$> placementChoice "Take them from a database that 'objects --write' made"
                <*> optional ((,) <$> objectOption <*> optional plateOptions)
                <*> optional netOptions
                <*> shapesOption
                <*> optional formatOption
                <*> outputOption
                <*> jsonSwitch "Print as JSON what was written"
            )
    )

objectOption :: Parser ObjectName
objectOption =
  objectCalled
    <$> valued
      str
      "object"
      "NAME"
      "The object (default: all objects, each in a file of its own in a folder)"

-- | The net, and the pages' size if it is cut into pages.
netOptions :: Parser (Maybe (Double, Double))
netOptions =
  flag'
    ()
    ( long "net"
        <> help
          "Draw each object unfolded, as SVG at true scale: faces with their symbols, without \
          \overlap, with tabs to glue"
    )
    *> optional
      ( option
          (pairReader 'x' "210x297")
          ( long "page"
              <> metavar "MMxMM"
              <> help "Cut the net into pages of this width and height, each a file in a folder"
          )
      )

plateOptions :: Parser (FaceName, Maybe Rational)
plateOptions = (,) <$> faceOption <*> optional thicknessOption

faceOption :: Parser FaceName
faceOption =
  readFaceName . map (\c -> if c == ',' then ' ' else c)
    <$> valued str "face" "VERTICES" "Write only this face, as a plate; as in 'C1 C2 C3 C4'"

thicknessOption :: Parser Rational
thicknessOption =
  valued
    (positiveReader "a thickness")
    "thickness"
    "MM"
    "Thickness of the plate (default: twice the height of its symbols)"

formatOption :: Parser Making
formatOption =
  choosing
    "format"
    (map (fmap fst) makings)
    "format"
    "FORMAT"
    ( intercalate ", " (map fst makings)
        ++ ": the form of the files; svg is a drawing of each face (default: the ending of the \
           \file's name, or stl)"
    )
    mempty

-- | The kinds of files by their names, with the endings of file names.
makings :: [(String, (Making, String))]
makings =
  [(surfaceName it, (Surface it, surfaceEnding it)) | it <- surfaceFormats]
    ++ [("svg", (Drawn, ".svg"))]

-- | All endings of file names, each once.
endings :: [String]
endings = nub (map (snd . snd) makings)

outputOption :: Parser FilePath
outputOption =
  valued
    pathReader
    "output"
    "FILE|FOLDER"
    "The file of an object or of a face. For several files, those of all objects or of an object's \
    \faces, a folder that is new or empty"

run :: Options -> IO ExitStatus
run options = do
  kind <- kindOf options
  when (drawn kind && isJust (asked options >>= snd >>= snd)) $
    misused "a drawing has no thickness; leave out --thickness"
  let oneFile = isOneFile options kind
  orMisnamed oneFile kind (output options)
  when (oneFile && output options == "-" && form options == AsJson) $
    misused "--output - and --json both take the standard output; name a file"
  when oneFile (orUnwritable (output options))
  (profile, layout) <- case asked options of
    Just (named, _) -> chosenWith unsaid (holding named (objects options)) named
    Nothing -> chosenPlacement unsaid (objects options)
  alphabet <- alphabetFor (shapesFile options) profile
  files <-
    either (\(status, why) -> warn why >> leave status) pure
      =<< whileWorking "raising symbols"
      =<< orUnusable
        profileMessage
        ( withProfile profile $ \array _ -> case kind of
            Surface format' ->
              first ((,) Unusable) $
                traverse (surfaceFile format' alphabet array layout) (subjects layout)
            Drawn
              | Just page <- asNet options ->
                concat <$> traverse (netFiles page alphabet array layout) (solidsAsked layout)
              | otherwise ->
                first ((,) Unusable) (drawnFiles alphabet array layout (facesAsked layout))
        )
  if oneFile
    then mapM_ (writeWhole (output options) . snd) files
    else
      writeFolder
        (output options)
        [(madeFile told, Lazy.toStrict bytes) | (told, bytes) <- files]
  -- If the file goes to the standard output, nothing else does.
  unless (oneFile && output options == "-") $ do
    let placed name = if oneFile then output options else output options </> name
        told = [made {madeFile = placed (madeFile made)} | (made, _) <- files]
    printAs (form options) (unlines (map fileText told)) (encodeEmbossed told)
  pure Answered
  where
    subjects layout = case asked options of
      Nothing -> map (WholeObject . solidName) (placementSolids layout)
      Just (named, Nothing) -> [WholeObject named]
      Just (named, Just (face, thickness)) -> [PlateOf named face thickness]
    solidsAsked layout = maybe (map solidName (placementSolids layout)) (pure . fst) (asked options)
    facesAsked layout = case asked options of
      Nothing -> Right (laidFaces layout)
      Just (named, Nothing) -> do
        _ <- findObject layout named
        Right [laid | laid <- laidFaces layout, faceObject (laidFace laid) == named]
      Just (named, Just (face, _)) -> (: []) <$> findFace layout named face

-- | The kind of the files: a drawing for a net; else that of @--format@, of the ending of the
-- file's name, or STL.
kindOf :: Options -> IO Making
kindOf options = case (asNet options, format options) of
  (Just _, given)
    | isJust (asked options >>= snd) || not (all drawn given) ->
      misused "a net is a drawing of a whole object; leave out --face, and any --format but svg"
    | otherwise -> pure Drawn
  (Nothing, Just given) -> pure given
  (Nothing, Nothing) ->
    maybe (misused none) pure . listToMaybe $
      [ kind
        | (kind, ending) <- map snd makings,
          ending == endingOf (output options) || null (endingOf (output options))
      ]
  where
    none =
      visibleName (output options) ++ " ends in none of "
        ++ intercalate ", " endings
        ++ ", the forms that emboss writes"

-- | Whether one file is written, and not a folder of files.
isOneFile :: Options -> Making -> Bool
isOneFile options kind = case asked options of
  Nothing -> False
  Just (_, Nothing) -> not (drawn kind) || asNet options == Just Nothing
  Just (_, Just _) -> True

-- | Leaves with status 2 if a file's name has the ending of another format, or a folder's name that
-- of a file.
orMisnamed :: Bool -> Making -> FilePath -> IO ()
orMisnamed oneFile kind name
  | oneFile =
    unless (null ending || ending == own) . misused $
      visibleName name ++ " does not end in " ++ own ++ ", the form that is written"
  | otherwise =
    when (ending `elem` endings) . misused $
      visibleName name
        ++ " is the name of a file, and several may be written: name a folder, or "
        ++ single
  where
    single
      | drawn kind = "one --face, or --net with one --object"
      | otherwise = "one --object or --face"
    ending = endingOf name
    own = case kind of
      Surface format' -> surfaceEnding format'
      Drawn -> ".svg"

-- | The ending of a name, from its last dot on, in lower case.
endingOf :: FilePath -> String
endingOf = map toLower . takeExtension

drawn :: Making -> Bool
drawn kind = case kind of
  Surface _ -> False
  Drawn -> True

-- | What was made, on one line.
fileText :: MadeFile -> String
fileText made =
  "wrote " ++ visibleName (madeFile made) ++ ": "
    ++ intercalate
      ", "
      ( [counted n "vertex" "vertices" | Just n <- [madeVertices made]]
          ++ [counted n "triangle" "triangles" | Just n <- [madeTriangles made]]
          ++ [sizeText size ++ " mm^3" | Just size <- [madeVolume made]]
          ++ [counted (madeTaxels made) "raised taxel" "raised taxels"]
          ++ ["strokes from " ++ decimal (madeStroke made) ++ " mm"]
          ++ [decimal height ++ " mm high" | Just height <- [madeHeight made]]
      )
  where
    sizeText size
      | null (drop 20 exact) = exact
      | otherwise = "about " ++ show (nearestVolume size)
      where
        exact = volumeText size
    decimal = show . (fromRational :: Rational -> Double)
