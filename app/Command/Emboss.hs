-- | @pra-tactile emboss@: objects with their symbols raised, as files for those who make them.
module Command.Emboss
  ( command,
  )
where

import ArrayChoice (unsaid)
import Control.Monad (unless, when)
import Counted
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.List (intercalate)
import Data.Maybe (fromMaybe, isJust)
import EmbossedFiles
import ExitStatus
import Message
import Options
import Output
import PlacementChoice
import Polyhedra (positiveReader)
import PraTactile.Emboss
import PraTactile.Format.Emboss
import PraTactile.Format.Solid (SolidFormat (..), formatOfFile)
import PraTactile.Object.Placement hiding (Spot (..))
import PraTactile.Object.WingedEdge
import PraTactile.Profile
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

-- | What files are.
data Making
  = Surface SolidFormat
  | Drawn
  deriving stock (Eq)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "emboss"
    "Write the objects with their symbols raised, as closed surfaces of triangles for a printer; \
    \or one face as a plate; or faces at true scale, as drawings."
    [ "pra-tactile emboss --object cube --output cube.stl",
      "pra-tactile emboss --object cube --face 'C1 C2 C3 C4' --thickness 5 --output top.stl",
      "pra-tactile emboss --format svg --object cube --output cube-faces",
      "pra-tactile emboss --net --object cube --output cube-net.svg",
      "pra-tactile emboss --net --page 210x297 --object cube --output cube-pages",
      "pra-tactile emboss --placement placement.json --output made --json"
    ]
    ( run
        <$> ( Options
                <$> placementChoice "The same from a database that 'objects --write' made"
                <*> optional ((,) <$> objectOption <*> optional plateOptions)
                <*> optional netOptions
                <*> shapesOption
                <*> optional formatOption
                <*> outputOption
                <*> jsonSwitch "Print what was made as JSON"
            )
    )

objectOption :: Parser ObjectName
objectOption =
  ObjectName
    <$> valued
      str
      "object"
      "NAME"
      "The object (default: all of them, each a file of its own in a folder)"

-- | The net, and the pages' size if it is cut into pages.
netOptions :: Parser (Maybe (Double, Double))
netOptions =
  flag'
    ()
    ( long "net"
        <> help
          "Draw each object unfolded, without overlap and at true scale, each face with its \
          \symbols, with tabs to glue (SVG)"
    )
    *> optional
      ( option
          (pairReader 'x' "210x297")
          ( long "page"
              <> metavar "WIDTHxHEIGHT"
              <> help "Cut the net into pages of this size, millimetres, each a file in a folder"
          )
      )

plateOptions :: Parser (FaceName, Maybe Rational)
plateOptions = (,) <$> faceOption <*> optional thicknessOption

faceOption :: Parser FaceName
faceOption =
  readFaceName . map (\c -> if c == ',' then ' ' else c)
    <$> valued str "face" "VERTICES" "One face of it alone, as in 'C1 C2 C3 C4', as a plate"

thicknessOption :: Parser Rational
thicknessOption =
  valued
    (positiveReader "a thickness")
    "thickness"
    "MM"
    "How thick the plate is (default: twice as thick as its symbols are high)"

formatOption :: Parser Making
formatOption =
  choosing
    "format"
    [("stl", Surface Stl), ("ascii-stl", Surface StlText), ("json", Surface Json), ("svg", Drawn)]
    "format"
    "FORMAT"
    "Binary STL, ASCII STL, exact JSON, or SVG, a drawing of each face (default: what the end of \
    \the file's name says, or else stl)"
    mempty

outputOption :: Parser FilePath
outputOption =
  valued
    pathReader
    "output"
    "FILE|FOLDER"
    "The file of an object or of a face; where several files come, of all objects or of the \
    \drawings of an object's faces, a folder that is new or empty"

run :: Options -> IO ExitStatus
run options = do
  when (kind == Drawn && isJust (asked options >>= snd >>= snd)) $
    misused "a drawing has no thickness; leave out --thickness"
  when (isJust (asNet options) && (isJust (asked options >>= snd) || kind /= Drawn)) $
    misused "a net is a drawing of a whole object; leave out --face, and any --format but svg"
  when oneFile (orUnwritable (output options))
  (profile, layout) <- case asked options of
    Just (named, _) -> chosenWith unsaid (holding named (objects options)) named
    Nothing -> chosenPlacement unsaid (objects options)
  alphabet <- alphabetFor (shapesFile options) profile
  files <-
    orUnusable id
      =<< orUnusable
        profileMessage
        ( withProfile profile $ \array _ -> case kind of
            Surface format' ->
              traverse (surfaceFile format' alphabet array layout) (subjects layout)
            Drawn
              | Just page <- asNet options ->
                concat <$> traverse (netFiles page alphabet array layout) (solidsAsked layout)
              | otherwise -> drawnFiles alphabet array layout (facesAsked layout)
        )
  if oneFile
    then mapM_ (writeWhole (output options) . snd) files
    else
      writeFolder
        (output options)
        [(madeFile told, Lazy.toStrict bytes) | (told, bytes) <- files]
  -- What stands on the standard output is the file alone.
  unless (oneFile && output options == "-") $ do
    let told = [made {madeFile = placed (madeFile made)} | (made, _) <- files]
    printAs (form options) (unlines (map fileText told)) (encodeEmbossed told)
  pure Answered
  where
    kind = fromMaybe (toldBy (output options)) (format options)
    toldBy file
      | isJust (asNet options) = Drawn
      | map toLower (takeExtension file) == ".svg" = Drawn
      | formatOfFile file == Just Json = Surface Json
      | otherwise = Surface Stl
    oneFile = case asked options of
      Nothing -> False
      Just (_, Nothing) -> kind /= Drawn || asNet options == Just Nothing
      Just (_, Just _) -> True
    placed name = if oneFile then output options else output options </> name
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
