-- | Messages about objects, placements, relief and databases.
module Message.Objects
  ( objectMessage,
    placementMessage,
    placementFileMessage,
    reliefMessage,
    imagesMessage,
    experimentMessage,
    pressMessage,
    storeMessage,
    recogniserMessage,
    refusalMessage,
    thresholdMessage,
  )
where

import Counted
import Data.List (intercalate, sortOn)
import Drawing (hundredths)
import Json (shapeText)
import Message.Format (figures, formatMessage)
import Message.Locate (locatorMessage, reasonMessage)
import Message.Touch (contradictionMessage, probeMessage, remediesText, shapeMessage)
import PraTactile.Array (Position (..))
import PraTactile.Evaluate (ExperimentError (..))
import PraTactile.Format.Placement (PlacementFileError (..))
import PraTactile.Format.Solid (exactText)
import PraTactile.Locate (Reason (..))
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Pressing (PressError (..))
import PraTactile.Recognise
  ( Diagnosis (..),
    Doubts (..),
    RecogniserError (..),
    Refusal (..),
    doubtOfForeign,
  )
import PraTactile.Relief (ReliefError (..))
import PraTactile.Relief.Mesh (MeshError (..))
import PraTactile.Store
  ( Damage (..),
    Failure (..),
    Occupant (..),
    StoreError (..),
    tableName,
  )
import PraTactile.SymbolImages (ImagesError (..))
import Text.Printf (printf)
import Visible (quoted, visible)

-- | The message about a defect of an object: what, where, and by how much.
objectMessage :: Defect -> String
objectMessage (Defect kind faces vertices measure) = case kind of
  NoFaces -> "the object has no faces"
  RepeatedName -> "several vertices are named " ++ names
  CoincidentVertices -> "the vertices " ++ names ++ " are the same point"
  UnusedVertex -> "the vertex " ++ names ++ " is on no face"
  UnknownVertex -> face ++ " names the unknown vertex " ++ names
  TooFewVertices -> face ++ " has fewer than three vertices"
  VertexTwiceOnFace -> face ++ " visits " ++ names ++ " twice"
  RepeatedFace -> theFaces ++ " have the same vertices"
  NoArea -> face ++ " has no area"
  NotPlanar -> face ++ " is not flat: a vertex is " ++ measured ++ " mm off its plane"
  FaceCrossesItself -> face ++ " crosses itself: its sides " ++ pairs ++ " meet"
  EdgeWithoutTwoFaces ->
    "at the edge " ++ names ++ " meet " ++ show (length faces) ++ " faces, not two"
  VertexOnEdge -> case map vertexText vertices of
    vertex : ends -> "the vertex " ++ vertex ++ " lies on the edge " ++ unwords ends
    [] -> "a vertex lies on an edge"
  FacesDisagree -> theFaces ++ " both walk from " ++ intercalate " to " (map vertexText vertices)
  PinchedVertex -> "the faces at " ++ names ++ " are more than one ring"
  InsideOut -> "the piece of " ++ face ++ " is inside out"
  FacesIntersect
    | null faces -> "so many faces lie close together that they were not all compared"
    | measure == Just 0 -> theFaces ++ " have a point in common that is no vertex of both"
    | otherwise -> theFaces ++ " cut each other, over " ++ measured ++ " mm"
  where
    names = list (map vertexText vertices)
    face = "the face " ++ list (map faceText faces)
    theFaces = "the faces " ++ list (map faceText faces)
    measured = maybe "0" show measure
    list = intercalate " and " . map (visible . shortened)
    shortened text = if null (drop 200 text) then text else take 200 text ++ " ..."
    pairs = case map vertexText vertices of
      [a, b, c, d] -> a ++ " " ++ b ++ " and " ++ c ++ " " ++ d
      others -> unwords others

placementMessage :: PlacementError -> String
placementMessage e = case e of
  BrokenObject why -> objectMessage why
  EmptyArray shape -> "an array of " ++ shapeText shape ++ " has no cells"
  PitchNotPositive _ -> "the distances between symbols must be positive"
  RepeatedObject object -> "two objects are named " ++ objectText object
  UnknownObject object ->
    "there is no object " ++ quoted (objectText object) ++ "; 'pra-tactile objects' lists them"
  UnknownFace face -> "there is no face " ++ faceOf face ++ "; 'pra-tactile objects' lists them"
  WrongVertexOrder face named -> "the face " ++ faceOf face ++ " is named " ++ faceText named
  FaceLaidTwice face -> "the face " ++ faceOf face ++ " is laid twice"
  FaceNotLaid face -> "the face " ++ faceOf face ++ " has no place on the array"
  EmptyGrid face _ -> "the face " ++ faceOf face ++ " has no cells"
  CellsOffFace face cells ->
    counted (length cells) "cell" "cells" ++ " of the face " ++ faceOf face
      ++ " would not lie wholly on it, the first in row "
      ++ concat [show r ++ ", column " ++ show c | Position r c <- take 1 cells]
      ++ " of its block"
  OutsideArray face _ _ -> "the face " ++ faceOf face ++ " reaches beyond the array"
  FacesOverlap f g _ -> "the faces " ++ faceOf f ++ " and " ++ faceOf g ++ " claim the same cells"
  CellOffFace face (Position r c) ->
    "the face " ++ faceOf face ++ " has no cell at row " ++ show r ++ ", column " ++ show c
  where
    faceOf (Face object named) = faceText named ++ " of the " ++ objectText object

-- | Why a file of this name holds no placement.
placementFileMessage :: FilePath -> PlacementFileError -> String
placementFileMessage file e = case e of
  PlacementMisfit why -> formatMessage file "a placement as 'pra-tactile place' writes it" why
  ObjectTooFine object ->
    file ++ ": the coordinates of the " ++ objectText object
      ++ " have no common denominator of reasonable size"
  ObjectBroken object why -> file ++ ": the " ++ objectText object ++ ": " ++ objectMessage why
  PlacementRefused why -> file ++ ": " ++ placementMessage why

-- | The message for an experiment, given the size of the symbols relative to the paper's.
experimentMessage :: Double -> ExperimentError -> String
experimentMessage larger e = case e of
  ReliefRefused why -> reliefMessage why
  PressesRefused why -> probeMessage why
  BendRefused least -> bendMessage (larger * least)

-- | The message about a bend that is too sharp, given the least radius in millimetres.
bendMessage :: Double -> String
bendMessage least =
  "--bend is a radius of more than " ++ hundredths least
    ++ " mm, half the diagonal of what the sensor feels"

-- | The message for a press, given the size of the symbols relative to the paper's, and the upper
-- left corner of the region, in millimetres on the face, if it was chosen.
pressMessage :: Double -> Maybe (Double, Double) -> PressError -> String
pressMessage larger asked e = case e of
  ObjectRefused why -> placementMessage why
  NoFaceLaid -> "the object has no face on the array"
  NoSuchFace name others ->
    "there is no face "
      ++ show (faceText name)
      ++ "; choose one of "
      ++ intercalate ", " (map (show . faceText . faceName . laidFace) others)
  NoRelief why -> reliefMessage why
  NoMeshRelief (NotClosed count) ->
    "the mesh is no closed surface: " ++ counted count "side" "sides"
      ++ " of its triangles are not shared by two that walk them in opposite directions"
  NoMeshRelief (ElsewhereThan face vertex) ->
    "the mesh does not lie where the placement has the face " ++ visible (faceText face)
      ++ ": it has no vertex within a hundredth of a taxel of "
      ++ visible (vertexText vertex)
  RegionOffFace face size ->
    "the region, " ++ by size
      ++ maybe "" (\(x, y) -> " mm from " ++ hundredths x ++ "," ++ hundredths y) asked
      ++ " mm, does not lie on the face "
      ++ faceText (faceName (laidFace face))
      ++ ", which is "
      ++ by (spotMillimetres (laidExtent face))
      ++ " mm; choose another --size or --at"
  BentTooMuch least -> bendMessage (larger * least)
  NotCovered why -> probeMessage why
  where
    by (w, h) = hundredths (larger * w) ++ " x " ++ hundredths (larger * h)

reliefMessage :: ReliefError -> String
reliefMessage e = case e of
  NoShape why -> shapeMessage why
  PitchNotFelt (Pitch right down) ->
    "symbols " ++ exactText right ++ " x " ++ exactText down
      ++ " mm from one to the next cannot be felt: that is not 25.4 x 31.75 mm times one factor"

storeMessage :: StoreError -> String
storeMessage e = case e of
  NoSuchFile file ->
    "there is no database " ++ file ++ "; 'pra-tactile objects --write FILE' makes one"
  IsDirectory file -> file ++ " is a folder; a database file is needed here"
  CannotRead file why -> "cannot read " ++ file ++ ": " ++ failureMessage why
  CannotWrite file why -> "cannot write " ++ file ++ ": " ++ failureMessage why
  Occupied file DanglingLink -> file ++ " is a link to nothing; " ++ elsewhere
  Occupied file NoRegularFile ->
    file ++ " is not a regular file, which a database needs; " ++ elsewhere
  Occupied file NoStore ->
    file ++ " is not a database of this program and is left as it is; " ++ elsewhere
  Occupied name OtherTables ->
    name
      ++ " has tables of the same names that belong to something else, and is left as it is; name \
         \another database, or another schema in it"
  NotADatabase file -> file ++ " is not an SQLite database"
  DamagedFile file BrokenPages ->
    file ++ " is damaged: parts of it are overwritten or missing; write the database again"
  DamagedFile file ForeignValue ->
    file ++ " is damaged: a value is not of its column's type; write the database again"
  TablesDiffer file ->
    file ++ " is damaged: a table or a column is missing; write the database again"
  NotAStore file -> file ++ " is a database, but not one that 'pra-tactile objects --write' made"
  WrongSchemaVersion found expected ->
    "the database has version "
      ++ show found
      ++ " of its tables, this program has "
      ++ show expected
      ++ "; write it again"
  ForeignProfile _ _ ->
    "the database was made for another profile; choose the array it was made for, or write it again"
  UnreadableRow table -> "the database is damaged: the table " ++ tableName table ++ broken
  ChangedRow table ->
    "the database is damaged: a row of the table " ++ tableName table
      ++ " is not as it was written"
  RowsDisagree table ->
    "the database contradicts itself: the rows of the table " ++ tableName table
      ++ " are not those that the others imply"
  NotSolid object why ->
    "the database contradicts itself: " ++ objectText object ++ ": " ++ objectMessage why
  NotPlaced why -> "the database contradicts itself: " ++ placementMessage why
  TooLarge n -> show n ++ " is too large for the database"
  NotInStore why -> placementMessage why
  DatabaseFailed why -> "the database cannot be used: " ++ failureMessage why
  UnreadableAddress ->
    addressForm
      ++ "; in names and values other characters than letters and digits are written as %40 and so \
         \on; or by settings, host=HOST dbname=NAME"
  UnknownScheme scheme -> "a database cannot be named by " ++ scheme ++ "://; " ++ addressForm
  WithoutServers name ->
    name
      ++ " cannot be used: this program was built without PostgreSQL; build it (not as a static \
         \program) where the library persistent-postgresql is installed"
  Unreachable name why -> "cannot connect to " ++ name ++ ": " ++ failureMessage why
  WrongEncoding name encoding ->
    name ++ " has texts in the encoding " ++ encoding ++ "; a database with UTF8 is needed here"
  TextNotHeld name -> name ++ " cannot hold a name with a NUL in it"
  where
    broken = " lacks a row, or has one that refers to nothing"
    addressForm =
      "a database on a server is named postgresql://USER@HOST:PORT/NAME?PARAMETER=VALUE, whatever \
      \may be left out"
    elsewhere = "name a new file, or a database that 'pra-tactile objects --write' made"

failureMessage :: Failure -> String
failureMessage why = case why of
  InUse -> "another program is using it"
  NotPermitted -> "no permission"
  NoRoom -> "there is no room"
  NoFolder -> "its folder does not exist or cannot be used"
  NameNotText -> "its name is not valid text"
  NoServer -> "no server answers there"
  PasswordRefused ->
    "the server refuses the password, or wants one, which may be in PGPASSWORD or in ~/.pgpass"
  ServerRefuses ->
    "the server refuses: there is no such user or database, or they may not, or it is not ready"
  UnknownParameter -> "what follows the password in the address is not a parameter"
  Refused reason -> reason
  ConnectionLost -> "the connection to the server was lost"
  SystemRefuses -> "the system refuses"

recogniserMessage :: RecogniserError -> String
recogniserMessage e = case e of
  RecogniserArray why -> locatorMessage why
  ClassesDiffer given shaped q ->
    "the network knows "
      ++ show given
      ++ " classes and the alphabet has "
      ++ show shaped
      ++ " shapes; the array has "
      ++ show q
      ++ " symbols"
  ArraysDiffer laid given ->
    "the objects are laid on an array of "
      ++ shapeText laid
      ++ "; the chosen one is "
      ++ shapeText given
  PitchesDiffer laid given ->
    "the objects' symbols are "
      ++ pitchText laid
      ++ " mm apart; symbols are read at "
      ++ pitchText given
      ++ " mm"
  where
    pitchText (Pitch right down) = millimetres right ++ " x " ++ millimetres down
    millimetres = show . (fromRational :: Rational -> Double)

refusalMessage :: Refusal -> String
refusalMessage refusal = case refusal of
  NoSymbols ->
    "no complete symbol was found in the composite; probe a larger region, at least 40 x 52 \
    \taxels to hold a window at every phase"
  SymbolsUnclear -> "the network recognised none of the symbols"
  ShownInstead seen why -> seenMessage why seen
  Mirrored others ->
    "the symbols are recognised in the mirror image only"
      ++ (if null others then "" else "; give " ++ remediesText others)
      ++ ", or press the face from outside"
  OrientationContradicts -> "the symbols disagree about which way up the grid is"
  GridContradicts -> "the symbols do not lie on one grid of the array's pitch"
  WindowsContradict ->
    "separate groups of symbols lead to different places: at least one symbol is wrong"
  FramesContradict contradiction -> contradictionMessage contradiction
  NotLocated NoCompleteWindow ->
    "the recognised symbols fit more than one position, and no window of them is complete; probe \
    \a larger region"
  NotLocated BelowThreshold ->
    reasonMessage BelowThreshold ++ "; probe a larger region, or tolerate more with --doubt"
  NotLocated reason -> reasonMessage reason
  NotDecoded why -> "what was recognised cannot be decoded: " ++ locatorMessage why

-- | Why the likeliest position is not likely enough, by the greatest of its doubts.
thresholdMessage :: Doubts -> String
thresholdMessage doubts = case sortOn (negate . fst) causes of
  (_, why) : _ -> why
  [] -> refusalMessage (NotLocated BelowThreshold)
  where
    causes =
      [ (doubtOfPosition doubts, refusalMessage (NotLocated BelowThreshold)),
        (doubtOfStitching doubts, likely ++ "one frame may lie elsewhere" ++ overlapping),
        ( doubtOfAxes doubts,
          likely ++ "the positions may be along other axes or at another scale"
            ++ "; state them with --axes, or let frames overlap more"
        ),
        (doubtOfSlip doubts, likely ++ "frames may have slipped by a cell" ++ overlapping),
        ( doubtOfForeign (doubtsOfOrigin doubts),
          likely
            ++ "the symbols may be of another array, or of none; check --profile and \
               \--placement, or probe a larger region"
        )
      ]
    likely = reasonMessage BelowThreshold ++ ": "
    overlapping = "; press so that frames overlap more"

-- | What was seen where no symbol was recognised, and what to do about it.
seenMessage :: Refusal -> Diagnosis -> String
seenMessage why seen = case seen of
  InsteadFlat -> "every taxel reads the same: nothing was touched, or the face is flat there"
  InsteadInverted ->
    "the symbols are recognised with light and dark exchanged; give --inverted, or leave it out"
  InsteadScaled factor taxel ->
    "the symbols are recognised at " ++ figures 3 factor
      ++ " times the size expected; give --taxel "
      ++ figures 6 taxel
      ++ " if that is the distance of the sensor's taxels, or the --placement of objects with such \
         \symbols"
  InsteadUnknown across down
    | min across down < 40 || max across down < 52 -> refusalMessage why
    | otherwise ->
      printf
        "no symbol of the alphabet is recognised in %d x %d taxels; check the images, the distance \
        \of taxels (--taxel), the size of the symbols (--placement) and their shapes (--shapes)"
        across
        down

imagesMessage :: ImagesError -> String
imagesMessage e = case e of
  NoPlate why -> placementMessage why
  NoReliefOfPlate why -> reliefMessage why
  TooFewFound presses ->
    "in " ++ show presses ++ " presses of this sensor too few symbols were found"
