-- | Changes of a database by @objects@: objects are added, replaced and removed, the placement is
-- exported, and the whole database is verified.
module DatabaseChange
  ( Task (..),
    taskOption,
    taskName,
    takesOperands,
    changed,
  )
where

import ArrayChoice
import Control.Monad (unless, when)
import Counted
import Data.Aeson (Series, (.=))
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Foldable (for_)
import Data.List (intercalate, sort)
import qualified Data.Map.Strict as Map
import Data.String (fromString)
import Data.Traversable (for)
import ExitStatus
import FormatFile (readPlacement, writePlacement)
import Json
import Message
import NamedSolid
import Options
import PlacementChoice (withDatabase)
import Polyhedra (SolidReading)
import PraTactile.Array (Position (..), area)
import PraTactile.Format.Place
import PraTactile.Object.Packing (Reason (TakenOverlaps))
import PraTactile.Object.Placement
import PraTactile.Object.Placement.Search
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Store
import Visible (objectCalled, visible, visibleName)

-- | A task on a database.
data Task
  = Add
  | Replace
  | Remove
  | Export FilePath
  | Check
  deriving stock (Eq)

-- | The option that names a task.
taskOption :: Parser Task
taskOption =
  flag'
    Add
    ( long "add"
        <> help
          "Add objects to the database; their faces are laid as --placement says, or on free cells"
    )
    <|> flag'
      Replace
      ( long "replace"
          <> help
            "Replace objects of the database by those of the same names"
      )
    <|> flag' Remove (long "remove" <> help "Remove the objects of these names from the database")
    <|> Export
    <$> fileOption
      "export"
      "FILE"
      "Write the placement that the database holds to this file, as 'place' writes it"
    <|> orAliasFlag
      "check"
      Check
      (flag' Check (long "verify" <> help "Read the whole database and prove its placement"))

-- | The option's name.
taskName :: Task -> String
taskName what = case what of
  Add -> "--add"
  Replace -> "--replace"
  Remove -> "--remove"
  Export _ -> "--export"
  Check -> "--verify"

-- | Whether a task takes objects as arguments.
takesOperands :: Task -> Bool
takesOperands what = what `elem` [Add, Replace, Remove]

-- | Do a task on the database of this name, with the objects that the command line names. Added
-- objects lie as the placement in a file says, if one is given. The status is 1 if objects cannot
-- be laid; the database is then unchanged.
changed ::
  ArrayChoice ->
  FilePath ->
  Task ->
  Maybe FilePath ->
  SolidReading ->
  [String] ->
  AnswerForm ->
  IO ExitStatus
changed choice file what placed reading named form = do
  unless (null placed || what `elem` [Add, Replace]) $
    misused $
      "--placement says where --add and --replace lay objects; " ++ taskName what ++ " lays none"
  when (takesOperands what && null named && null placed) $
    misused (taskName what ++ " names no object")
  case what of
    Add -> do
      (new, laidBy) <- objectsToLay
      made (map solidName new) [] laidBy
    Replace -> do
      (new, laidBy) <- objectsToLay
      let names = map solidName new
      made names names (\place -> removing names place >>= laidBy)
    Remove -> do
      let names = map objectCalled named
      made [] names (removing names)
    Export to -> do
      withDatabase choice file $ \profile store ->
        storedPlacement store >>= orUnusable storeMessage >>= writePlacement to profile
      Answered <$ sayWrittenAs form to "" "objects-written/1" mempty
    Check ->
      withDatabase choice file (\_ store -> storedPlacement store >>= orUnusable storeMessage)
        >>= \place -> told [] [] (place, mempty)
  where
    -- The objects, and what lays them in a placement.
    objectsToLay = do
      (profile, between) <-
        withDatabase choice file (\profile store -> pure (profile, storedPitch store))
      let solids = for named (namedSolid (Just (profileShape profile)) between reading)
      case placed of
        Nothing -> (\new -> (new, adding firstSeed new)) <$> solids
        Just from -> do
          (other, layout) <- readPlacement from
          unless (other == profile && placementPitch layout == between) . unusable $
            visibleName from ++ " is a placement on another array than that of "
              ++ visibleName (shownName file)
          new <-
            if null named
              then pure (placementSolids layout)
              else for named (placedIn from layout)
          pure (new, addingAs layout new)
    -- An object that the placement has, by its name or as a solid of that name.
    placedIn from layout text
      | Right it <- findObject layout (objectCalled text) = pure it
      | otherwise = do
        it <- namedSolid (Just (placementShape layout)) (placementPitch layout) reading text
        there <- orUnusable (const (lacks from it)) (findObject layout (solidName it))
        unless (there == it) . unusable $
          visible (objectText (solidName it)) ++ " is another object in " ++ visibleName from
        pure it
    lacks from it = visibleName from ++ " has no object " ++ visible (objectText (solidName it))
    firstSeed = 1
    made added removed function = do
      let purposely = if null placed then [] else added
      outcome <- changeRemembering file purposely function >>= orUnusable storeMessage
      case outcome of
        Right there -> told added removed there
        Left (NotChanged (RepeatedObject name))
          | what == Add,
            length (filter (== name) added) == 1 ->
            unusable $
              "the database has an object " ++ visible (objectText name)
                ++ " already; --replace puts another in its place"
        Left (NotChanged why@FacesOverlap {})
          | not (null placed) ->
            unlaid IsImpossible (Just (reasonName (TakenOverlaps 0))) (placementMessage why)
        Left (NotChanged why) -> unusable (placementMessage why)
        Left (NothingCarries between new) ->
          unlaid IsImpossible (Just nothingCarriedName) (nothingCarries between new)
        Left (NotLaid wishes (Just proof)) ->
          unlaid IsImpossible (Just (reasonName proof)) (whyNot wishes proof)
        Left (NotLaid _ Nothing) -> unlaid IsNotFound Nothing noneFound
    unlaid outcome reason sentence = do
      printAs
        form
        (outcomeName outcome ++ ": " ++ sentence ++ "\n")
        (encodeDatabase (outcomeName outcome) reason mempty)
      pure NotAnswered
    told added removed (place, former) = do
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
              <> fromString "elsewhere" .= map objectText (Map.keys former)
              <> fromString "objects" .= objects
              <> fromString "faces" .= faces
              <> fromString "cells" .= cells
              <> fromString "array_cells" .= naturalValue (area (placementShape place))
        )
      for_ (Map.toAscList former) $ \(name, there) ->
        warn ("warning: " ++ elsewhereText name there)
      pure Answered

-- | The placement with these objects of another one, which lie as they do there.
addingAs :: Placement -> [Solid] -> Placement -> Either NotChanged Placement
addingAs layout new place =
  first NotChanged $
    placement
      (placementShape place)
      (placementPitch place)
      (placementSolids place ++ new)
      (map layingOf (laidFaces place ++ filter isNew (laidFaces layout)))
  where
    isNew laid = faceObject (laidFace laid) `elem` map solidName new

-- | The notice that an object lay elsewhere before, with the former place.
elsewhereText :: ObjectName -> [FormerFace] -> String
elsewhereText name there =
  visible (objectText name) ++ " lay elsewhere before: "
    ++ intercalate "; " (map place (take 6 there))
    ++ (if null (drop 6 there) then "" else "; and so on")
    ++ ". A part that was made for that place is read as another one; to lay it there, remove it \
       \and give --add a --placement that has it there"
  where
    place (FormerFace face (Position r c) _) =
      visible face ++ " from row " ++ show r ++ ", column " ++ show c

-- | The result of a change, as one line of JSON.
encodeDatabase :: String -> Maybe String -> Series -> ByteString
encodeDatabase outcome reason keys =
  encodeSchema "objects-database/1" $
    fromString "outcome" .= outcome <> fromString "reason" .= reason <> keys
