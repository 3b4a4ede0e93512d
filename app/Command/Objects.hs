-- | @pra-tactile objects@: the objects and where their faces lie on the array; the database of that
-- mapping.
module Command.Objects
  ( command,
  )
where

import ArrayChoice
import Control.Monad (unless)
import ExitStatus
import Json
import Message
import Options
import PlacementChoice
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Format (encodeObjects, encodeWhereabouts)
import PraTactile.Format.Profile (profileText)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Store
import Recognised (whereText)

data Options = Options
  { at :: Maybe Position,
    source :: PlacementChoice,
    write :: Maybe FilePath,
    form :: AnswerForm
  }

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "objects"
    "List the objects and the place of their faces on the array, look a window's position up, or \
    \write the mapping to an SQLite file."
    [ "pra-tactile objects",
      "pra-tactile objects --at 6,5",
      "pra-tactile objects --write mapping.sqlite && pra-tactile objects --database \
      \mapping.sqlite --at 6,5"
    ]
    (run <$> arrayChoice <*> options)
  where
    options =
      Options
        <$> optional
          ( valued
              positionReader
              "at"
              "ROW,COLUMN"
              "Tell what lies at the window whose upper left cell is here, counted from 0"
          )
        <*> placementChoice "Ask this database instead of a mapping in memory"
        <*> optionalFile
          "write"
          "FILE"
          "Write the mapping to an SQLite file: a new one, or one that this command made, \
          \which is replaced"
        <*> jsonSwitch "Print as JSON"

run :: ArrayChoice -> Options -> IO ExitStatus
run choice options = do
  case (at options, write options, ofDatabase (source options)) of
    (Just _, Just _, _) -> misused "--at asks and --write writes; give one of them"
    (_, Just "-", _) -> misused "a database cannot be written to the standard output; name a file"
    (_, Just _, Just _) ->
      misused "--write makes a database and --database asks one; give one of them"
    _ -> pure ()
  (profile, layout) <- chosenPlacement choice (source options)
  case (at options, write options) of
    (Just position, _) -> lookUp profile layout options position
    (_, Just file) -> do
      create file (profileText profile) layout >>= orUnusable storeMessage
      sayWrittenAs (form options) file "" "objects-written/1" mempty
    _ -> printAs (form options) (unlines (listText layout)) (encodeObjects profile layout)
  pure Answered

-- | What a database that was made for the profile says.
inDatabase :: Profile -> (Store -> IO a) -> FilePath -> IO a
inDatabase profile ask file =
  withStore file (Just (profileText profile)) ask >>= orUnusable storeMessage

-- | What lies at a position, from memory or from the database.
lookUp :: Profile -> Placement -> Options -> Position -> IO ()
lookUp profile layout options position = do
  unless
    (row position < high && column position < wide)
    ( unusable
        ( "the array has no cell at row "
            ++ show (row position)
            ++ ", column "
            ++ show (column position)
            ++ ": its "
            ++ shapeText (profileShape profile)
            ++ " cells are counted from 0"
        )
    )
  place <- case ofDatabase (source options) of
    Nothing -> pure (whereabouts layout window position)
    Just file ->
      inDatabase profile (\store -> storedWhereabouts store window position) file
        >>= orUnusable storeMessage
  printAs (form options) (whereText place ++ "\n") (encodeWhereabouts profile position place)
  where
    window = profileWindow profile
    Shape high wide = profileShape profile

listText :: Placement -> [String]
listText layout = concatMap solidLines (placementSolids layout)
  where
    solidLines body =
      objectText (solidName body) :
        [ "  " ++ faceLine laid
          | laid <- laidFaces layout,
            faceObject (laidFace laid) == solidName body
        ]
    faceLine laid =
      faceText (faceName (laidFace laid)) ++ ": " ++ millimetres laid ++ " mm, "
        ++ shapeText (laidGrid laid)
        ++ " symbols from row "
        ++ show (row (laidAt laid))
        ++ ", column "
        ++ show (column (laidAt laid))
    millimetres laid =
      let (wide, high) = spotMillimetres (laidExtent laid) in show wide ++ " x " ++ show high
