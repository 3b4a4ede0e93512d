-- | @pra-tactile draw@: pictures of a solid, of the array in its symbols, of the faces on the
-- array, and of an encoded object.
module Command.Draw
  ( command,
  )
where

import ArrayChoice
import Control.Monad (unless, when)
import qualified Data.ByteString.Lazy as Lazy
import Data.Maybe (fromMaybe, isJust, isNothing)
import ExitStatus
import Json (shapeText)
import Message
import NamedSolid
import Options
import Output
import Picture.Layout
import Picture.Solid
import PlacementChoice
import Polyhedra
import PraTactile.Array
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Placement
import PraTactile.Object.View
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Relief (classOn)
import PraTactile.Symbol (classOfElement)
import Setup
import SvgFile
import Visible

-- | The kind of picture.
data Subject = OneSolid | WholeSheet | Layings | Encoded
  deriving stock (Eq, Show)

data Options = Options
  { subject :: Subject,
    object :: Maybe String,
    reading :: SolidReading,
    from :: Maybe (Double, Double),
    objects :: PlacementChoice,
    shapesFile :: Maybe FilePath,
    output :: FilePath
  }

command :: Subcommand
command =
  subcommand
    "draw"
    "Draw a solid, the array, a placement or an object"
    "Draw an SVG picture: 'solid', an object with its vertices' names; 'sheet', the array in its \
    \symbols; 'placement', the faces of objects on the array; or 'encoded', an object with its \
    \symbols, in perspective. Hidden parts of objects are hidden."
    [readingGroup, arrayGroup]
    [ "pra-tactile draw solid --output cube.svg",
      "pra-tactile draw solid --object l:200x100x200 --from=-40,30 --output l.svg",
      "pra-tactile draw placement --output placement.svg",
      "pra-tactile draw encoded --object parallelepiped --output encoded.svg"
    ]
    ( run
        <$> ( Options
                <$> argument
                  (namedReader "subject" subjects)
                  ( metavar "solid|sheet|placement|encoded" <> completeWith (map fst subjects)
                      <> help "What to draw"
                  )
                <*> optional
                  ( valued
                      str
                      "object"
                      "NAME"
                      "The object of the placement (default: the first one); for 'solid' also a \
                      \file or a name, as the command 'solid' takes it"
                  )
                <*> readingOptions
                <*> optional
                  ( valued
                      (pairReader ',' "30,25")
                      "from"
                      "AZIMUTH,ELEVATION"
                      "From where an object is seen, in degrees: 0,0 is from the front, 90,0 from \
                      \the right, 0,90 from above (default: 30,25)"
                  )
                <*> placementChoice "Take them from a database that 'objects --write' made"
                <*> shapesOption
                <*> fileOption "output" "FILE" "Write the picture to this file, as SVG"
            )
        <*> arrayChoice
    )
  where
    subjects =
      [("solid", OneSolid), ("sheet", WholeSheet), ("placement", Layings), ("encoded", Encoded)]

run :: Options -> ArrayChoice -> IO ExitStatus
run options choice = do
  when (subject options `elem` [WholeSheet, Layings] && isJust (object options)) $
    misused "--object is for 'solid' and 'encoded'"
  when (subject options `elem` [WholeSheet, Layings] && isJust (from options)) $
    misused "--from is for 'solid' and 'encoded'"
  when (subject options == OneSolid) $
    leaveOut "'solid' is drawn without symbols" [("--shapes", isJust (shapesFile options))]
  when (reading options /= asUsual && (subject options /= OneSolid || isNothing (object options))) $
    misused
      "--scale, --tolerance, --fix-orientation, --keep-triangles and --format are for \
      \'solid' with an --object"
  orNotSvg (output options)
  orUnwritable (output options)
  (profile, layout) <- chosenPlacement choice (objects options)
  drawn <- drawing options profile layout
  writeWhole (output options) drawn
  sayWritten (output options) ""
  pure Answered

drawing :: Options -> Profile -> Placement -> IO Lazy.ByteString
drawing options profile layout = case subject options of
  OneSolid -> do
    whole <- maybe firstObject nameOrFile (object options)
    pure (solidSvg (titleOf whole) (seen Nothing) whole)
  Encoded -> do
    whole <- maybe firstObject ofPlacement (object options)
    alphabet <- alphabetFor (shapesFile options) profile
    unless (fewSymbols (fromIntegral mostCells) layout whole) . unusable $
      "an object with more than " ++ show mostCells ++ " symbols is too large to be drawn with them"
    symbols <-
      orUnusable
        profileMessage
        (withProfile profile (\array _ -> embossedOn alphabet layout (classOn array) whole))
    pure (encodedSvg (titleOf whole ++ ", encoded") (seen (Just 3)) symbols whole)
  WholeSheet -> do
    (alphabet, classes) <- symbolsOf
    pure (sheetSvg alphabet ("The array of " ++ sizeText) classes)
  Layings -> do
    (alphabet, classes) <- symbolsOf
    pure (placementSvg alphabet ("Faces on the array of " ++ sizeText) classes layout)
  where
    seen = viewFrom azimuth elevation
    (azimuth, elevation) = fromMaybe (30, 25) (from options)
    titleOf whole = "The " ++ visible (objectText (solidName whole))
    sizeText = shapeText (profileShape profile)
    firstObject = case placementSolids layout of
      whole : _ -> pure whole
      [] -> unusable "the placement has no object"
    ofPlacement name =
      orUnusable placementMessage (findObject layout (objectCalled name))
    nameOrFile name = case placementObject layout (objectCalled name) of
      Just whole
        | reading options == asUsual -> pure whole
        | otherwise ->
          misused
            ( "the placement has an object " ++ quoted name
                ++ "; --scale, --tolerance, --fix-orientation, --keep-triangles and --format are \
                   \for files"
            )
      Nothing -> namedSolid (Just (profileShape profile)) canonicalPitch (reading options) name
    symbolsOf = do
      when (area (profileShape profile) > mostCells) . unusable $
        "an array of " ++ sizeText ++ " is too large to be drawn in its symbols; "
          ++ show mostCells
          ++ " cells can be"
      alphabet <- alphabetFor (shapesFile options) profile
      cells <-
        orUnusable
          profileMessage
          (withProfile profile (\array _ -> fmap (map (map classOfElement)) (toRows array)))
      classes <- orUnusable foldMessage cells
      pure (alphabet, classes)
    mostCells = 20000
