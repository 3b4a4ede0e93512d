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
import Message.Objects (objectMessage)
import Options
import Output
import Polyhedra
import PraTactile.Format.Solid
import PraTactile.Format.Solid.Name
import PraTactile.Format.Solid.Report
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Cells
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Mend
import PraTactile.Object.Mesh
import PraTactile.Object.Placement (Pitch (..))
import PraTactile.Object.Tolerance (sufficient)
import PraTactile.Object.Validity
import PraTactile.Object.Vector (zero)
import PraTactile.Profile (canonicalProfile, profileShape)
import Visible

data Options = Options
  { subjects :: [String],
    reading :: SolidReading,
    symbolScale :: Rational,
    output :: Maybe FilePath,
    form :: AnswerForm
  }

command :: Subcommand
command =
  subcommand
    "solid"
    "Examine polyhedra: defects, pieces, room for symbols"
    "Examine polyhedra from files or by name: whether each is a solid, all that is wrong with it, \
    \its pieces, and how many symbols its faces carry. Files are OFF, OBJ, STL or PLY of all \
    \kinds, or JSON of this program. The status is 1 if something is wrong with one."
    [readingGroup]
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
                <*> readingWith
                  ( flag
                      AsWritten
                      CoplanarMerged
                      ( long "merge-coplanar"
                          <> help "Merge adjacent faces that lie in one plane"
                      )
                  )
                  formatOption
                <*> symbolsOption
                <*> optionalFile
                  "output"
                  "FILE"
                  "Write the polyhedron to this file, in the format that its name ends in, or that \
                  \of --format"
                <*> jsonSwitch "Print the report as JSON"
            )
    )

run :: Options -> IO ExitStatus
run options = do
  when (maybe False (const (length (subjects options) > 1)) (output options)) $
    misused "--output takes one solid; name only one"
  when (output options == Just "-" && form options == AsJson) $
    misused "--output - and --json both take the standard output; name a file for the polyhedron"
  formatHeeded (readingFormat (reading options)) (subjects options) (output options)
  target <- traverse (outputFormat (readingFormat (reading options))) (output options)
  mapM_ orUnwritable (output options)
  statuses <- mapM (examined options target) (subjects options)
  pure (maximum statuses)

examined :: Options -> Maybe SolidFormat -> String -> IO ExitStatus
examined options target subject = do
  Polyhedron given passed it changes <-
    polyhedron sheet (symbolPitch options) (reading options) subject
  let mending = readingMending (reading options)
      report = examine it
      advice = wouldMend mending given report
      grids = [bestGrid it (right, down) walk | walk <- V.toList (meshWalks it), carries it walk]
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
  -- If the file goes to the standard output, nothing else does.
  if output options == Just "-"
    then pure ()
    else
      printAs
        (form options)
        (unlines (reportText it passed changes mending advice grids report))
        (encodeReport it passed changes advice grids report)
  pure (if reportValid report then Answered else NotAnswered)
  where
    Pitch right down = symbolPitch options
    sheet = profileShape canonicalProfile
    carries it walk =
      U.length walk >= 3 && ofVertices it walk && doubleArea (cornersOf it walk) /= zero

-- | From one symbol to the next.
symbolPitch :: Options -> Pitch
symbolPitch options = Pitch (symbolScale options * right) (symbolScale options * down)
  where
    Pitch right down = canonicalPitch

reportText ::
  Mesh -> [Passed] -> Changes -> Mending -> Maybe Mending -> [Grid] -> Report -> [String]
reportText it passed changes done advice grids report =
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
    ++ [ "  moved: " ++ counted (movedVertices changes) "vertex" "vertices" ++ ", by at most "
           ++ show (movedMost changes)
           ++ " mm"
         | movedVertices changes > 0
       ]
    ++ [ "  left out: " ++ counted (leftOutFaces changes) "face" "faces" ++ " on a line"
         | leftOutFaces changes > 0
       ]
    ++ [ "  turned: " ++ counted (length turned) "face" "faces" ++ ", now "
           ++ intercalate "; " (map faceText (take 5 turned))
           ++ (if null (drop 5 turned) then "" else "; ...")
         | not (null turned)
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
    ++ ( case advice of
           Just mending -> ["  with " ++ unwords (added mending) ++ " it would be a solid"]
           Nothing ->
             [ "  with --tolerance " ++ exactText mm ++ " these faces would be flat"
               | any ((== NotPlanar) . defectKind) (reportDefects report),
                 Just mm <- [sufficient it]
             ]
       )
    ++ [ "  not examined everywhere: " ++ kindName kind
           ++ ", because of "
           ++ intercalate ", " (map (reason kind) causes)
         | Unexamined kind causes <- reportNotExamined report
       ]
  where
    verdict
      | reportValid report = "a solid"
      | null (reportDefects report) = "not examined everywhere"
      | otherwise = counted (length (reportDefects report)) "defect" "defects"
    turned = turnedFaces changes
    -- The options that were not given yet.
    added mending =
      concat
        [ ["--tolerance", exactText mm]
          | Just mm <- [mendTolerance mending],
            mendTolerance mending /= mendTolerance done
        ]
        ++ ["--fix-orientation" | mendOrientation mending, not (mendOrientation done)]
    reason kind cause = if cause == kind then "how many there are" else kindName cause
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

-- | A fraction of few digits exactly, a longer one as the nearest machine number.
volumeText :: Rational -> String
volumeText volume
  | null (drop 20 exact) = exact
  | otherwise = "about " ++ show (fromRational volume :: Double)
  where
    exact = exactText volume
