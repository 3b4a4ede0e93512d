-- | @pra-tactile emboss@: objects with their symbols raised, as files for those who make them.
module Command.Emboss
  ( command,
  )
where

import ArrayChoice (unsaid)
import Control.Monad (unless, when)
import Counted
import Data.Bifunctor (first)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isControl, ord, toLower)
import Data.List (intercalate)
import Data.Maybe (fromMaybe, isJust)
import qualified Data.Vector as V
import ExitStatus
import Message
import Message.Emboss
import Numeric (showHex)
import Options
import Output
import Picture.Net
import Picture.Template
import PlacementChoice
import Polyhedra (positiveReader)
import PraTactile.Array (PseudorandomArray)
import PraTactile.Emboss
import PraTactile.Emboss.Face (Stamp (..), outlineSpot)
import PraTactile.Emboss.Rounding
import PraTactile.Field (KnownField)
import PraTactile.Format.Emboss
import PraTactile.Format.Solid (SolidFormat (..), Written (..), formatOfFile, writeSolid)
import PraTactile.Geometry (taxelPitch)
import PraTactile.Object.Chart (Spot (..))
import PraTactile.Object.Mesh (meshPoints, meshWalks)
import PraTactile.Object.Net
import PraTactile.Object.Placement hiding (Spot (..))
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Shape (Alphabet)
import Setup
import System.FilePath (takeExtension, (</>))
import Visible

data Options = Options
  { objects :: PlacementChoice,
    asked :: Maybe (ObjectName, Maybe (FaceName, Maybe Rational)),
    asNet :: Bool,
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
      "pra-tactile emboss --placement placement.json --output made --json"
    ]
    ( run
        <$> ( Options
                <$> placementChoice "The same from a database that 'objects --write' made"
                <*> optional ((,) <$> objectOption <*> optional plateOptions)
                <*> switch
                  ( long "net"
                      <> help
                        "Draw each object unfolded, without overlap and at true scale, each face \
                        \with its symbols (SVG)"
                  )
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
  when (asNet options && (isJust (asked options >>= snd) || kind /= Drawn)) $
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
              | asNet options -> traverse (netFile alphabet array layout) (solidsAsked layout)
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
      | asNet options = Drawn
      | map toLower (takeExtension file) == ".svg" = Drawn
      | formatOfFile file == Just Json = Surface Json
      | otherwise = Surface Stl
    oneFile = case asked options of
      Nothing -> False
      Just (_, Nothing) -> kind /= Drawn || asNet options
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

-- | An object or a plate as a file, which is called after the object.
surfaceFile ::
  KnownField k =>
  SolidFormat ->
  Alphabet ->
  PseudorandomArray k ->
  Placement ->
  Subject ->
  Either String (MadeFile, Lazy.ByteString)
surfaceFile format' alphabet array layout subject = do
  made <- first embossMessage (embossed alphabet array layout subject)
  object <- first placementMessage (findObject layout named)
  maybe (Right ()) (const (Left (collisionMessage named))) (collision object made)
  Rounded it most <- first misshapenMessage (rounded precision made)
  Right
    ( MadeFile
        { madeFile = fileName (objectText named) ++ "." ++ ending,
          madeObject = named,
          madeFace = embossedFace made,
          madeVertices = Just (V.length (meshPoints it)),
          madeTriangles = Just (V.length (meshWalks it)),
          madeVolume = Just (embossedVolume made),
          madeTaxels = embossedTaxels made,
          madeStroke = embossedStroke made,
          madeHeight = Just (embossedHeight made),
          madeMostRounded = most
        },
      Builder.toLazyByteString (writtenBytes (writeSolid format' it))
    )
  where
    named = subjectName subject
    (precision, ending) = case format' of
      StlText -> (Binary64, "stl")
      Json -> (Fractions, "json")
      _ -> (Binary32, "stl")

-- | An object unfolded, as a drawing.
netFile ::
  KnownField k =>
  Alphabet ->
  PseudorandomArray k ->
  Placement ->
  ObjectName ->
  Either String (MadeFile, Lazy.ByteString)
netFile alphabet array layout named = do
  object <- first placementMessage (findObject layout named)
  (scale, symbolsOf') <- first embossMessage (symbolsOn alphabet array layout carrying)
  tree <- case pickNet 10000 object of
    Picked tree -> Right tree
    EveryOneOverlaps -> Left (said "every unfolding overlaps")
    NoneFound -> Left (said "no net was found, and there may be one")
    SeveralPieces -> Left (said "it is of several pieces, which cannot be unfolded together")
  let taxel = fromRational (scale * taxelPitch) :: Double
      raised face =
        [ [ onFace (begunAs (laidFace laid) face) (left + taxel * across, top + taxel * down)
            | Lattice i j <- map (outlineSpot cell) loop,
              let (across, down) = (fromInteger i, fromInteger j)
          ]
          | Just laid <- [placementLaid layout (Face named (netFaceName face))],
            let (left, top) = spotMillimetres (laidMargin laid),
            (cell, stamp) <- symbolsOf' laid,
            loop <- stampOutlines stamp
        ]
      stamps = concatMap (map snd . symbolsOf') carrying
  when (null stamps) (Left (embossMessage (NothingRaised named)))
  Right
    ( drawing (fileName (objectText named) ++ ".net.svg") named Nothing scale stamps,
      netSvg ("The " ++ visible (objectText named) ++ ", unfolded") raised (layOut object tree)
    )
  where
    carrying = [laid | laid <- laidFaces layout, faceObject (laidFace laid) == named]
    said why = "the " ++ visible (objectText named) ++ " is not drawn as a net: " ++ why
    -- The same face begun where its laying begins.
    begunAs laid face =
      let FaceName walk = faceName laid
          turned' = dropWhile ((/= take 1 walk) . pure . fst) (cycle (corners face))
       in face {netCorners = map snd (take (length (corners face)) turned')}
    corners face = zip (faceVertices (netFaceName face)) (netCorners face)

-- | Faces as drawings, each called after its object and its vertices.
drawnFiles ::
  KnownField k =>
  Alphabet ->
  PseudorandomArray k ->
  Placement ->
  Either PlacementError [LaidFace] ->
  Either String [(MadeFile, Lazy.ByteString)]
drawnFiles alphabet array layout asked' = do
  faces <- first placementMessage asked'
  (scale, symbols) <- first embossMessage (symbolsOn alphabet array layout faces)
  Right (zipWith (drawn scale symbols) [1 ..] faces)
  where
    drawn scale symbols number laid =
      ( drawing (named (number :: Int) face) object (Just face) scale (map snd (symbols laid)),
        templateFile (Template laid (scale * taxelPitch) (symbols laid))
      )
      where
        Face object face = laidFace laid
        named k (FaceName vertices)
          | length full > 200 = fileName (objectText object) ++ ".face-" ++ show k ++ ".svg"
          | otherwise = full
          where
            full =
              fileName (objectText object)
                ++ ('.' : intercalate "-" (map ofVertex vertices))
                ++ ".svg"
        ofVertex = concatMap (escapedIn ".-") . fileName . vertexText

-- | What is told of a drawing: its file, the object and perhaps the face, how much larger than the
-- paper's its symbols are, and the symbols.
drawing :: FilePath -> ObjectName -> Maybe FaceName -> Rational -> [Stamp] -> MadeFile
drawing file object face scale stamps =
  MadeFile
    { madeFile = file,
      madeObject = object,
      madeFace = face,
      madeVertices = Nothing,
      madeTriangles = Nothing,
      madeVolume = Nothing,
      madeTaxels = sum (map stampArea stamps),
      madeStroke = scale * taxelPitch * fromIntegral (minimum (map stampStroke stamps)),
      madeHeight = Nothing,
      madeMostRounded = templateRounding
    }

-- | A name as part of a file's, different for different names.
fileName :: String -> FilePath
fileName = concatMap (escapedIn "/%")

-- | The character, by its number where it is one of these or no printable one.
escapedIn :: String -> Char -> String
escapedIn these c
  | c `elem` these || isControl c = '%' : showHex (ord c) ";"
  | otherwise = [c]

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
