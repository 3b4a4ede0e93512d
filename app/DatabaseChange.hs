-- | What @objects@ does to a database of the mapping: it adds objects, replaces and removes them,
-- exports the placement and checks all.
module DatabaseChange
  ( Task,
    taskOption,
    taskName,
    takesOperands,
    changed,
  )
where

import Control.Monad (when)
import Counted
import Data.Aeson (Series, (.=))
import Data.ByteString (ByteString)
import Data.List (sort)
import Data.String (fromString)
import Data.Traversable (for)
import ExitStatus
import FormatFile (writePlacement)
import Json
import Message
import NamedSolid
import Options
import PraTactile.Array (area)
import PraTactile.Format.Place (Outcome (..), outcomeName, reasonName)
import PraTactile.Object.Placement
import PraTactile.Object.Placement.Search
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Store
import Visible (objectCalled, visible)

-- | What is done to a database.
data Task
  = Add
  | Replace
  | Remove
  | Export FilePath
  | Check
  deriving stock (Eq)

-- | One of the options.
taskOption :: Parser Task
taskOption =
  flag' Add (long "add" <> help "Add objects to the database: their faces are laid on free cells")
    <|> flag' Replace (long "replace" <> help "Put objects in the place of those of their names")
    <|> flag' Remove (long "remove" <> help "Take the objects of these names from the database")
    <|> Export
    <$> fileOption "export" "FILE" "Write the database's placement to a file, as 'place' writes it"
    <|> flag' Check (long "check" <> help "Read all of the database and prove its placement")

-- | The option's name.
taskName :: Task -> String
taskName what = case what of
  Add -> "--add"
  Replace -> "--replace"
  Remove -> "--remove"
  Export _ -> "--export"
  Check -> "--check"

-- | Whether objects are named for it.
takesOperands :: Task -> Bool
takesOperands what = what `elem` [Add, Replace, Remove]

-- | Do it to the database in this file, which has this profile and symbols so far apart, with what
-- the command line names. Status 1 where objects cannot be laid; the database is then as it was.
changed :: FilePath -> Task -> [String] -> AnswerForm -> (Profile, Pitch) -> IO ExitStatus
changed file what named form (profile, between) = do
  when (takesOperands what && null named) (misused (taskName what ++ " names no object"))
  case what of
    Add -> do
      new <- solids
      made (map solidName new) [] (adding firstSeed new)
    Replace -> do
      new <- solids
      let names = map solidName new
      made names names (\place -> removing names place >>= adding firstSeed new)
    Remove -> do
      let names = map objectCalled named
      made [] names (removing names)
    Export to -> do
      whole >>= writePlacement to profile
      Answered <$ sayWrittenAs form to "" "objects-written/1" mempty
    Check -> whole >>= told [] []
  where
    solids = for named (namedSolid (Just (profileShape profile)) between Nothing)
    firstSeed = 1
    whole =
      withStore file Nothing (\store -> storedPlacement store >>= orUnusable storeMessage)
        >>= orUnusable storeMessage
    made added removed function = do
      outcome <- change file function >>= orUnusable storeMessage
      case outcome of
        Right place -> told added removed place
        Left (NotChanged why) -> unusable (placementMessage why)
        Left (NotLaid wishes why) -> do
          let (name, reason, sentence) = case why of
                Just proof -> (IsImpossible, Just (reasonName proof), whyNot wishes proof)
                Nothing -> (IsNotFound, Nothing, noneFound)
          printAs
            form
            (outcomeName name ++ ": " ++ sentence ++ "\n")
            (encodeDatabase (outcomeName name) reason mempty)
          pure NotAnswered
    told added removed place = do
      let cells = sum (map (length . blockCells . laidBlock) (laidFaces place))
          objects = length (placementSolids place)
          faces = length (laidFaces place)
          shown = map objectText . sort
      printAs
        form
        ( unlines
            ( ["added " ++ unwords (map visible (shown added)) | not (null added)]
                ++ ["removed " ++ unwords (map visible (shown removed)) | not (null removed)]
                ++ [ counted objects "object" "objects"
                       ++ ", "
                       ++ counted faces "face" "faces"
                       ++ " on "
                       ++ show cells
                       ++ " of "
                       ++ show (area (placementShape place))
                       ++ " cells"
                   ]
            )
        )
        ( encodeDatabase (outcomeName IsPlaced) Nothing $
            fromString "added" .= shown added
              <> fromString "removed" .= shown removed
              <> fromString "objects" .= objects
              <> fromString "faces" .= faces
              <> fromString "cells" .= cells
              <> fromString "array_cells" .= naturalValue (area (placementShape place))
        )
      pure Answered

-- | What became of a database, in one line.
encodeDatabase :: String -> Maybe String -> Series -> ByteString
encodeDatabase outcome reason keys =
  encodeSchema "objects-database/1" $
    fromString "outcome" .= outcome <> fromString "reason" .= reason <> keys
