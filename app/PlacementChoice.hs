-- | The options that choose the objects, the same in every command that presses objects or looks
-- them up: @--placement FILE@, @--database FILE@ or @--sheet@. Without them the objects are the
-- shipped placement or, for another array, the array itself.
module PlacementChoice
  ( PlacementChoice,
    placementChoice,
    placementBeside,
    placementGiven,
    plateOr,
    objectsGroup,
    holding,
    ofDatabase,
    chosenPlacement,
    chosenWith,
    chosenFirst,
    withDatabase,
    withNear,
    shownWith,
    feltPlacement,
  )
where

import ArrayChoice
import Control.Monad (unless)
import qualified Data.ByteString.Char8 as Bytes
import ExitStatus
import FormatFile (readPlacement)
import Message
import Options
import PraTactile.Array (Position, Shape)
import PraTactile.Format (decodeProfile)
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement
import PraTactile.Object.Plate (plateName, platePlacement)
import PraTactile.Object.WingedEdge (ObjectName (..))
import PraTactile.Profile
import PraTactile.Relief (ReliefError (..), symbolScale)
import PraTactile.Store
import Visible (objectCalled, visibleName)

-- | The source of the objects and of the places of their faces.
data PlacementChoice
  = -- | The shipped placement; for another array, the array itself.
    Shipped
  | -- | The whole array as a flat plate.
    Plate
  | InFile FilePath
  | InDatabase FilePath

-- | @--placement FILE@ or @--database FILE@, given the help of the latter.
placementChoice :: String -> Parser PlacementChoice
placementChoice ofDatabase' =
  InFile <$> placementOption <|> InDatabase <$> databaseOption ofDatabase' <|> pure Shipped

placementOption :: Parser FilePath
placementOption =
  fileOption
    "placement"
    "FILE"
    "The objects, the places of their faces and the array, as 'place' writes them (default: the \
    \cube and the parallelepiped on arrays of 15 x 17; for other arrays the whole array as a flat \
    \plate)"

databaseOption :: String -> Parser FilePath
databaseOption ofDatabase' =
  fileOption "database" "FILE" (ofDatabase' ++ " (on a server: postgresql://...)")

-- | 'placementChoice' where a database may be given with a placement beside it, which says where
-- objects are laid in it.
placementBeside :: String -> Parser (PlacementChoice, Maybe FilePath)
placementBeside ofDatabase' =
  chosen <$> optional placementOption <*> optional (databaseOption ofDatabase')
  where
    chosen placed database = case (placed, database) of
      (_, Just file) -> (InDatabase file, placed)
      (Just file, Nothing) -> (InFile file, Nothing)
      (Nothing, Nothing) -> (Shipped, Nothing)

-- | The options that choose objects, and whether they were given.
placementGiven :: PlacementChoice -> [(String, Bool)]
placementGiven choice = case choice of
  Shipped -> []
  Plate -> [("--sheet", True)]
  InFile _ -> [("--placement", True)]
  InDatabase _ -> [("--database", True)]

-- | @--sheet@, or another choice.
plateOr :: Parser PlacementChoice -> Parser PlacementChoice
plateOr others =
  orAlias
    "object"
    (Plate <$ plate)
    mempty
    ( flag'
        Plate
        ( long "sheet"
            <> help
              "The object is the whole array as a flat plate (default for arrays that are not 15 x \
              \17)"
        )
    )
    <|> others
  where
    plate = do
      named <- str
      if objectCalled named == plateName
        then pure ()
        else readerError "only 'sheet' can be named here; --placement FILE has other objects"

-- | The options that say what objects and symbols there are, as a group of a command's help.
objectsGroup :: Group
objectsGroup =
  Group "The objects and their symbols" (words "sheet placement database shapes network")

-- | The choice for an object of this name: the plate's name chooses the plate, unless objects are
-- chosen by an option.
holding :: ObjectName -> PlacementChoice -> PlacementChoice
holding object choice = case choice of
  Shipped | object == plateName -> Plate
  _ -> choice

-- | The database, if one is chosen.
ofDatabase :: PlacementChoice -> Maybe FilePath
ofDatabase choice = case choice of
  InDatabase file -> Just file
  _ -> Nothing

-- | The placement chosen, and the profile of its array. Leaves with status 2 where there is none,
-- or where the array options describe another array.
chosenPlacement :: ArrayChoice -> PlacementChoice -> IO (Profile, Placement)
chosenPlacement array choice = case choice of
  Shipped -> do
    profile <- chosenProfile array
    layout <- orUnusable placementMessage canonicalPlacement
    if placementShape layout == profileShape profile
      then pure (profile, layout)
      else (,) profile <$> plated profile
  Plate -> do
    profile <- chosenProfile array
    (,) profile <$> plated profile
  InFile file -> do
    (profile, layout) <- readPlacement file
    agreeing array file profile
    pure (profile, layout)
  InDatabase file -> withDatabase array file $ \profile store ->
    (,) profile <$> (storedPlacement store >>= orUnusable storeMessage)
  where
    plated = orUnusable placementMessage . platePlacement . profileShape

-- | The placement chosen, where only one of its objects is needed: a database's other objects are
-- not read.
chosenWith :: ArrayChoice -> PlacementChoice -> ObjectName -> IO (Profile, Placement)
chosenWith array choice named = case choice of
  InDatabase file -> chosenStored array file (\_ store -> storedObjects store [named])
  _ -> chosenPlacement array choice

-- | Continue with the chosen profile and placement, for a command that looks positions up. For a
-- database the placement has no objects; the third argument reads those on and next to given cells.
-- The database stays open meanwhile.
withNear ::
  ArrayChoice ->
  PlacementChoice ->
  (Profile -> Placement -> ([Position] -> IO (Maybe Placement)) -> IO a) ->
  IO a
withNear array choice going = case choice of
  InDatabase file -> withDatabase array file $ \profile store -> do
    bare <- orUnusable placementMessage (placement (storedShape store) (storedPitch store) [] [])
    going profile bare $ \cells ->
      storedNear store (profileWindow profile) cells >>= orUnusable storeMessage . fmap Just
  _ -> do
    (profile, layout) <- chosenPlacement array choice
    going profile layout (const (pure Nothing))

-- | The placement chosen, for a command that presses the first @count@ faces. It needs only objects
-- within a reach of these faces, rows and columns that follow from the symbols' distances and the
-- array's window. No other objects of a database are read.
chosenFirst ::
  ArrayChoice -> PlacementChoice -> Int -> (Pitch -> Shape -> Shape) -> IO (Profile, Placement)
chosenFirst array choice count reach = case choice of
  InDatabase file ->
    chosenStored array file $ \profile store ->
      storedFirst store count (reach (storedPitch store) (profileWindow profile))
  _ -> chosenPlacement array choice

-- | A part of what a database holds, with the profile of its array.
chosenStored ::
  ArrayChoice ->
  FilePath ->
  (Profile -> Store -> IO (Either StoreError Placement)) ->
  IO (Profile, Placement)
chosenStored array file part = withDatabase array file $ \profile store ->
  (,) profile <$> (part profile store >>= orUnusable storeMessage)

-- | An open database and the profile of its array. Leaves with status 2 where it is none, or where
-- the array options describe another array.
withDatabase :: ArrayChoice -> FilePath -> (Profile -> Store -> IO a) -> IO a
withDatabase array file going =
  withStore file Nothing asked >>= orUnusable storeMessage
  where
    asked store = do
      profile <- profileIn file (storedProfile store)
      agreeing array file profile
      going profile store

-- | The profile that a database has as a text.
profileIn :: FilePath -> String -> IO Profile
profileIn file text =
  orUnusable
    (formatMessage (shownName file) "a database as 'pra-tactile objects --write' makes it")
    (decodeProfile (Bytes.pack text))

-- | Leaves with status 2 where the array options describe another array than the file's.
agreeing :: ArrayChoice -> FilePath -> Profile -> IO ()
agreeing array file profile = unless (nothingChosen array) $ do
  other <- chosenProfile array
  unless (other == profile) . unusable $
    "the array's options describe another array than that of " ++ visibleName (shownName file)
      ++ "; leave them out"

-- | 'chosenWith' without options about the array.
shownWith :: PlacementChoice -> ObjectName -> IO (Profile, Placement)
shownWith = chosenWith unsaid

-- | The size of a placement's symbols relative to the paper's, and the placement with all its
-- lengths divided by that. Leaves with status 2 if such symbols cannot be felt.
feltPlacement :: Placement -> IO (Rational, Placement)
feltPlacement layout = case symbolScale pitch of
  Nothing -> unusable (reliefMessage (PitchNotFelt pitch))
  Just 1 -> pure (1, layout)
  Just scale -> pure (scale, scaledPlacement (1 / scale) layout)
  where
    pitch = placementPitch layout
