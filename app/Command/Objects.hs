-- | @pra-tactile objects@: the objects and where their faces lie on the array; the database of that
-- mapping, which is asked, changed and checked.
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
import Polyhedra (SolidReading, asUsual, readingOptions)
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

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "objects"
    "List the objects and the place of their faces on the array, look a window's position up, or \
    \write the mapping to an SQLite file, add to it and take from it."
    [ "pra-tactile objects",
      "pra-tactile objects --at 6,5",
      "pra-tactile objects --write mapping.sqlite && pra-tactile objects --database \
      \mapping.sqlite --at 6,5",
      "pra-tactile objects --write more.sqlite && pra-tactile objects --database more.sqlite --add \
      \lid=box:30x30x40",
      "pra-tactile place lid=box:30x30x40 --output lid.json && pra-tactile objects --placement \
      \lid.json --write lid.sqlite && pra-tactile objects --database lid.sqlite --remove lid && \
      \pra-tactile objects --database lid.sqlite --add --placement lid.json lid"
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
        <*> switch
          ( long "batch"
              <> help
                "Read such positions from the standard input, one a line; answer each with \
                \a line of JSON"
          )
        <*> placementBeside "Ask this database instead of a mapping in memory, or change it"
        <*> optionalFile
          "write"
          "FILE"
          "Write the mapping to an SQLite file, or a database on a server, postgresql://...: a new \
          \one, or one that this command made, which is replaced"
        <*> optional taskOption
        <*> many
          ( argument
              pathReader
              ( metavar "OBJECT..." <> action "file"
                  <> help
                    "What --add and --replace take: files or names of polyhedra, as 'solid' takes \
                    \them, NAME= before one names the object; of a --placement, names of its \
                    \objects (default: all); what --remove takes: names of objects"
              )
          )
        <*> readingOptions
        <*> jsonSwitch "Print as JSON"

run :: ArrayChoice -> Options -> IO ExitStatus
run choice options = do
  when (length asked > 1) $
    misused ("give one of " ++ enumerated asked)
  unless (null (operands options) || maybe False takesOperands (task options)) $
    misused "objects are named for --add, --replace and --remove"
  unless (reading options == asUsual || task options `elem` [Just Add, Just Replace]) $
    misused
      "--scale, --tolerance, --fix-orientation, --keep-triangles and --format are for --add and \
      \--replace"
  when (isJust beside && null (task options)) $
    misused "--placement and --database are given together for --add and --replace"
  case (task options, ofDatabase from) of
    (Just what, Just file) ->
      changed choice file what beside (reading options) (operands options) (form options)
    (Just what, Nothing) -> misused (taskName what ++ " is for a --database")
    (Nothing, database) -> case (at options, write options) of
      (_, Just "-") ->
        misused "a database cannot be written to the standard output; name a file"
      (_, Just _)
        | isJust database ->
          misused "--write makes a database and --database asks one; give one of them"
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
      ["--at" | isJust (at options)]
        ++ ["--batch" | batched options]
        ++ ["--write" | isJust (write options)]
        ++ [taskName what | Just what <- [task options]]
    enumerated names = unwords (map (++ ",") (init names)) ++ " " ++ last names

-- | Go on with the profile and what tells where a window is, in memory or by the database alone.
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

-- | One line after another, each answered at once; the worst status of all.
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

-- | That the array has no such cell.
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
