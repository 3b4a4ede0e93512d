-- | @pra-tactile solid@: is this a solid, what is wrong with it, and which cells do its faces
-- carry?
module Command.Solid
  ( command,
  )
where

import Control.Monad (when)
import Counted
import qualified Data.ByteString.Builder as Builder
import Data.List (intercalate, nub)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import ExitStatus
import Files (readBytes)
import Message.Objects (objectMessage)
import Message.Solid
import Numeric (showFFloat)
import Options
import Output
import PraTactile.Array (Shape (..))
import PraTactile.Format.Solid
import PraTactile.Format.Solid.Name
import PraTactile.Format.Solid.Report
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Cells
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Merge
import PraTactile.Object.Mesh
import PraTactile.Object.Named (namedDescription)
import PraTactile.Object.Placement (Pitch (..))
import PraTactile.Object.Tolerance
import PraTactile.Object.Validity
import PraTactile.Object.Vector (zero)
import PraTactile.Profile (canonicalProfile, profileShape)
import System.FilePath (dropExtension, takeFileName)
import Visible

data Options = Options
  { subjects :: [String],
    scale :: Rational,
    tolerance :: Maybe Rational,
    merging :: Bool,
    symbolScale :: Rational,
    output :: Maybe FilePath,
    format :: Maybe SolidFormat,
    form :: AnswerForm
  }

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "solid"
    "Examine polyhedra, of files or by name: whether each is a solid, all that is wrong with it, \
    \its pieces, and how many symbols its faces carry. Files: OFF, OBJ, STL and PLY of all kinds, \
    \and JSON of this program. Status 1 if something is wrong with one."
    [ "pra-tactile solid cube",
      "pra-tactile solid cube --output cube.stl && pra-tactile solid cube.stl --merge-coplanar",
      "pra-tactile solid l:200x100x200 --output l.json"
    ]
    ( run
        <$> ( Options
                <$> some
                  ( argument
                      pathReader
                      ( metavar "NAME|FILE..." <> action "file"
                          <> help ("Files, or names: " ++ intercalate ", " nameForms)
                      )
                  )
                <*> option
                  (positiveReader "a factor")
                  ( long "scale" <> metavar "S" <> value 1
                      <> help "Multiply all lengths, as by 25.4 where a file has inches"
                  )
                <*> optional
                  ( valued
                      (positiveReader "a length")
                      "tolerance"
                      "MM"
                      "Put vertices no further apart than this together, and move vertices no \
                      \further than this so that faces are flat"
                  )
                <*> switch
                  ( long "merge-coplanar"
                      <> help "Put faces together that share sides and lie in one plane"
                  )
                <*> option
                  (positiveReader "a factor")
                  ( long "symbols" <> metavar "S" <> value 1
                      <> help
                        "Size of the symbols: S times 25.4 x 31.75 mm from one to the next \
                        \(default 1)"
                  )
                <*> optionalFile
                  "output"
                  "FILE"
                  "Write the polyhedron to a file, in the format of its end or of --format"
                <*> optional
                  ( choosing
                      "format"
                      (allNamed formatName)
                      "format"
                      "FORMAT"
                      "Format of files whose ends do not tell it"
                      mempty
                  )
                <*> jsonSwitch "Print as JSON"
            )
    )

-- | An exact number above 0.
positiveReader :: String -> ReadM Rational
positiveReader what = eitherReader $ \text -> case exactNumber text of
  Just n | n > 0 -> Right n
  _ -> Left (quoted text ++ " is not " ++ what ++ " above 0, such as 25.4 or 127/5")

run :: Options -> IO ExitStatus
run options = do
  when (maybe False (const (length (subjects options) > 1)) (output options)) $
    misused "--output takes one solid; name one"
  target <- traverse (outputFormat options) (output options)
  mapM_ orUnwritable (output options)
  statuses <- mapM (examined options target) (subjects options)
  pure (maximum statuses)

outputFormat :: Options -> FilePath -> IO SolidFormat
outputFormat options file = case (formatOfFile file, format options) of
  (Just Stl, Just StlText) -> pure StlText
  (Just Ply, Just PlyText) -> pure PlyText
  (Just told, _) -> pure told
  (Nothing, Just given) -> pure given
  (Nothing, Nothing) -> misused (endless file)

endless :: FilePath -> String
endless file =
  "the end of " ++ visibleName file ++ " tells no format; give --format "
    ++ intercalate "|" (map formatName [minBound .. maxBound])

examined :: Options -> Maybe SolidFormat -> String -> IO ExitStatus
examined options target subject = do
  Contents read' passed <- polyhedron options subject
  let scaled = scaledBy (scale options) read'
      Settled flat count most =
        maybe (Settled scaled 0 0) (\mm -> settled mm (merging options) scaled) (tolerance options)
      moved = Moved count most
      it = if merging options then mergeCoplanar flat else flat
      report = examine it
      grids = [bestGrid it between walk | walk <- V.toList (meshWalks it), carries it walk]
  case (target, output options) of
    (Just to, Just file) -> do
      let Written bytes rounded = writeSolid to it
      writeWhole file (Builder.toLazyByteString bytes)
      when (rounded > 0) $
        warn
          ( show rounded ++ " coordinates were rounded: the format "
              ++ formatName to
              ++ " cannot have them exactly"
          )
    _ -> pure ()
  -- What stands on the standard output is the file alone.
  if output options == Just "-"
    then pure ()
    else
      printAs
        (form options)
        (unlines (reportText it passed moved grids report))
        (encodeReport it passed moved grids report)
  pure (if reportValid report then Answered else NotAnswered)
  where
    between = symbolPitch options
    carries it walk =
      U.length walk >= 3 && ofVertices it walk && doubleArea (cornersOf it walk) /= zero

-- | What a name or a file says.
polyhedron :: Options -> String -> IO Contents
polyhedron options subject = case readName (sheetSize options) subject of
  Known named' -> pure (Contents (fromDescription (namedDescription named')) [])
  Malformed wanted -> unusable (solidNameMessage subject wanted)
  Irrational name ->
    unusable
      ( "a regular " ++ name
          ++ " has no rational vertices, since no rational rotation has order 5; the pyritohedron \
             \has, which is a dodecahedron: pyritohedron:A"
      )
  NoName -> do
    told <- case formatOfFile subject of
      Just told -> pure told
      Nothing -> maybe (misused (endless subject)) pure (format options)
    bytes <- readBytes subject
    orUnusable
      (solidFileMessage subject told)
      (readSolid told (ObjectName (objectNameOf subject)) bytes)
  where
    objectNameOf "-" = "standard-input"
    objectNameOf file = dropExtension (takeFileName file)

-- | From one symbol to the next, to the right and down, millimetres.
symbolPitch :: Options -> (Rational, Rational)
symbolPitch options = (symbolScale options * right, symbolScale options * down)
  where
    Pitch right down = canonicalPitch

-- | Room for all symbols of the paper's array.
sheetSize :: Options -> (Rational, Rational)
sheetSize options = (fromIntegral (columns shape) * right, fromIntegral (rows shape) * down)
  where
    (right, down) = symbolPitch options
    shape = profileShape canonicalProfile

reportText :: Mesh -> [Passed] -> Moved -> [Grid] -> Report -> [String]
reportText it passed moved grids report =
  [ visible (objectText (meshName it)) ++ ": " ++ verdict,
    "  " ++ counted (reportVertices report) "vertex" "vertices" ++ ", "
      ++ counted (reportEdges report) "edge" "edges"
      ++ ", "
      ++ counted (reportFaces report) "face" "faces"
  ]
    ++ [ "  passed over: "
           ++ intercalate ", " [visible what | Passed what <- passed]
         | not (null passed)
       ]
    ++ [ "  moved: " ++ counted (movedVertices moved) "vertex" "vertices" ++ ", by at most "
           ++ show (movedMost moved)
           ++ " mm"
         | movedVertices moved > 0
       ]
    ++ listed 10 "pieces" (map pieceText (reportComponents report))
    ++ listed
      20
      "faces that carry symbols"
      [gridText grid | grid <- grids, gridCount grid /= Just 0]
    ++ concat
      [ listed
          10
          (kindName kind)
          [objectMessage defect | defect <- reportDefects report, defectKind defect == kind]
        | kind <- nub (map defectKind (reportDefects report))
      ]
    ++ [ "  with --tolerance " ++ showFFloat Nothing mm "" ++ " these faces would be flat"
         | any ((== NotPlanar) . defectKind) (reportDefects report),
           Just mm <- [sufficient it]
       ]
    ++ [ "  not examined everywhere: " ++ kindName kind
           ++ ", because of "
           ++ intercalate ", " (map kindName causes)
         | Unexamined kind causes <- reportNotExamined report
       ]
  where
    verdict
      | reportValid report = "a solid"
      | otherwise = counted (length (reportDefects report)) "defect" "defects"
    listed most what given =
      map ("  " ++) (take most given)
        ++ [ "  ... of " ++ show (length given)
               ++ " in all: "
               ++ what
             | not (null (drop most given))
           ]
    gridText grid =
      faceText (FaceName (map (vertexAt it) (U.toList (gridWalk grid)))) ++ ": "
        ++ maybe "too many symbols to count" (\n -> counted n "symbol" "symbols") (gridCount grid)
        ++ ", "
        ++ show (fst (gridSize grid))
        ++ " x "
        ++ show (snd (gridSize grid))
        ++ " mm"

pieceText :: Component -> String
pieceText piece =
  "piece: V - E + F = " ++ show (componentVertices piece)
    ++ " - "
    ++ show (componentEdges piece)
    ++ " + "
    ++ show (componentFaces piece)
    ++ " = "
    ++ show (componentEuler piece)
    ++ maybe "" (\genus -> ", genus " ++ show genus) (componentGenus piece)
    ++ maybe "" (\volume -> ", " ++ volumeText volume ++ " mm^3") (componentVolume piece)
    ++ maybe "" (\convex -> if convex then ", convex" else ", not convex") (componentConvex piece)
    ++ maybe "" (\n -> if n == 0 then "" else ", inside " ++ show n) (componentInside piece)

-- | A fraction of few digits exactly, another as the nearest machine number.
volumeText :: Rational -> String
volumeText volume
  | null (drop 20 exact) = exact
  | otherwise = "about " ++ show (fromRational volume :: Double)
  where
    exact = exactText volume
