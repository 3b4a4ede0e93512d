-- | @pra-tactile objects@: the objects and where their faces lie on the array; the database of that
-- mapping is used, changed and verified.
module Command.Objects
  ( command,
  )
where

import ArrayChoice
import Control.Monad (unless, when)
import qualified Data.ByteString.Char8 as Bytes
import Data.Maybe (isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import DatabaseChange
import ExitStatus
import Json
import Lines
import Message
import NamedSolid (symbolsText)
import Options
import PlacementChoice
import Polyhedra (SolidReading, asUsual, readingGroup, readingOptions)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Format (encodeObjects, encodeWhereabouts)
import PraTactile.Format.Object (encodeNoWhereabouts)
import PraTactile.Format.Profile (profileText)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Store
import Recognised (whereText)
import System.IO (hFlush, stdout)

data Options = Options
  { at :: Maybe Position,
    batched :: Bool,
    -- | and a placement beside a database
    source :: (PlacementChoice, Maybe FilePath),
    write :: Maybe FilePath,
    task :: Maybe Task,
    operands :: [String],
    reading :: SolidReading,
    form :: AnswerForm
  }

command :: Subcommand
command =
  subcommand
    "objects"
    "List, look up or store where faces lie on the array"
    "List the objects and where their faces lie on the array, or look up what lies at a window's \
    \position. Or write this mapping to a database, add objects to it and remove them."
    [readingGroup, arrayGroup]
    [ "pra-tactile objects",
      "pra-tactile objects --cell 6,5",
      "pra-tactile objects --write mapping.sqlite && pra-tactile objects --database mapping.sqlite \
      \--cell 6,5",
      "pra-tactile objects --write more.sqlite && pra-tactile objects --database more.sqlite --add \
      \lid=box:30x30x40",
      "pra-tactile place lid=box:30x30x40 --output lid.json && pra-tactile objects --placement \
      \lid.json --write lid.sqlite && pra-tactile objects --database lid.sqlite --remove lid && \
      \pra-tactile objects --database lid.sqlite --add --placement lid.json lid"
    ]
    (run <$> options <*> arrayChoice)
  where
    options =
      Options
        <$> optional
          ( orAlias "at" positionReader mempty $
              valued
                positionReader
                "cell"
                "ROW,COLUMN"
                "Print what lies at the window whose upper left cell is this, counted from 0"
          )
        <*> switch
          ( long "batch"
              <> help
                "Read such cells from the standard input, one a line, and answer each by a line of \
                \JSON"
          )
        <*> placementBeside "Use this database in place of a mapping in memory, or change it"
        <*> optionalFile
          "write"
          "FILE"
          "Write the mapping to an SQLite file, or to a database on a server, postgresql://...; \
          \one that this command made before is replaced"
        <*> optional taskOption
        <*> many
          ( argument
              pathReader
              ( metavar "OBJECT..." <> action "file"
                  <> help
                    "For --add and --replace: files or names of polyhedra, as 'solid' takes them, \
                    \where NAME= in front names the object; with --placement, names of its objects \
                    \(default: all). For --remove: names of objects"
              )
          )
        <*> readingOptions
        <*> jsonSwitch "Print the answer as JSON"

run :: Options -> ArrayChoice -> IO ExitStatus
run options choice = do
  when (length asked > 1) $
    misused ("give one of " ++ enumerated asked)
  unless (null (operands options) || maybe False takesOperands (task options)) $
    misused "objects are only for --add, --replace and --remove; leave them out"
  unless (reading options == asUsual || task options `elem` [Just Add, Just Replace]) $
    misused
      "--scale, --tolerance, --fix-orientation, --keep-triangles and --format are only for --add \
      \and --replace"
  when (isJust beside && null (task options)) $
    misused "--placement and --database go together only with --add and --replace; give one of them"
  case (task options, ofDatabase from) of
    (Just what, Just file) ->
      changed choice file what beside (reading options) (operands options) (form options)
    (Just what, Nothing) -> misused (taskName what ++ " needs --database")
    (Nothing, database) -> case (at options, write options) of
      (_, Just "-") ->
        misused "a database cannot be written to the standard output; name a file"
      (_, Just _)
        | isJust database ->
          misused "--write makes a database and --database uses one; give one of them"
      (_, Just file) -> do
        (profile, layout) <- chosenPlacement choice from
        create file (profileText profile) layout >>= orUnusable storeMessage
        Answered <$ sayWrittenAs (form options) (shownName file) "" "objects-written/1" mempty
      (Just position, _) -> asking choice from (lookUp options position)
      _
        | batched options -> asking choice from batch
        | otherwise -> do
          (profile, layout) <- chosenPlacement choice from
          printAs (form options) (unlines (listText layout)) (encodeObjects profile layout)
          pure Answered
  where
    (from, beside) = source options
    asked =
      ["--cell" | isJust (at options)]
        ++ ["--batch" | batched options]
        ++ ["--write" | isJust (write options)]
        ++ [taskName what | Just what <- [task options]]
    enumerated names = unwords (map (++ ",") (init names)) ++ " " ++ last names

-- | Continue with the profile and the look-up of windows, in memory or in the database.
asking ::
  ArrayChoice -> PlacementChoice -> (Profile -> (Position -> IO Whereabouts) -> IO a) -> IO a
asking choice from ask = case ofDatabase from of
  Just file -> withDatabase choice file $ \profile store ->
    ask profile $ \position ->
      storedWhereabouts store (profileWindow profile) position >>= orUnusable storeMessage
  Nothing -> do
    (profile, layout) <- chosenPlacement choice from
    ask profile (pure . whereabouts layout (profileWindow profile))

-- | What lies at a position.
lookUp :: Options -> Position -> Profile -> (Position -> IO Whereabouts) -> IO ExitStatus
lookUp options position profile whereIs = do
  mapM_ unusable (offArray profile position)
  place <- whereIs position
  printAs (form options) (whereText place ++ "\n") (encodeWhereabouts profile position place)
  pure Answered

-- | Answer one line after another, each at once; the status is the worst of all.
batch :: Profile -> (Position -> IO Whereabouts) -> IO ExitStatus
batch profile whereIs = forLines answerLine Answered
  where
    answerLine worst given = case lineText given >>= positionIn of
      Left why -> Unusable <$ answered (encodeNoWhereabouts profile why)
      Right position -> do
        place <- whereIs position
        worst <$ answered (encodeWhereabouts profile position place)
    answered bytes = Bytes.putStrLn bytes >> hFlush stdout
    positionIn :: Text -> Either String Position
    positionIn text = do
      position <- readPosition (Text.unpack text)
      maybe (Right position) Left (offArray profile position)

-- | The complaint about a position outside the array.
offArray :: Profile -> Position -> Maybe String
offArray profile position
  | row position < high && column position < wide = Nothing
  | otherwise =
    Just
      ( "the array has no cell at row "
          ++ show (row position)
          ++ ", column "
          ++ show (column position)
          ++ ": its "
          ++ shapeText (profileShape profile)
          ++ " cells are counted from 0"
      )
  where
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
        ++ symbolsText (laidBlock laid)
        ++ " from row "
        ++ show (row (laidAt laid))
        ++ ", column "
        ++ show (column (laidAt laid))
    millimetres laid =
      let (wide, high) = spotMillimetres (laidExtent laid) in show wide ++ " x " ++ show high
