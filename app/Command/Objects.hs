{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile objects@: the objects and where their faces lie on the array; the database of that
-- mapping.
module Command.Objects
  ( command,
  )
where

import ArrayChoice
import Control.Monad (unless)
import Data.Aeson (Series, object, (.=))
import Data.List (intercalate)
import Data.String (fromString)
import Described
import Ending
import Json
import Message
import Options.Applicative hiding (command)
import Output
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Format.Profile
import PraTactile.Format.Recognition (whereaboutsPairs)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Store
import Recognised (whereText)
import Setup
import Visible

data Options = Options
  { at :: Maybe Position,
    database :: Maybe FilePath,
    write :: Maybe FilePath,
    asJson :: Bool
  }

command :: Mod CommandFields (IO Ending)
command =
  described
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
          ( option
              positionReader
              ( long "at"
                  <> metavar "ROW,COLUMN"
                  <> help
                    "Tell what lies at the window whose upper left cell is here, counted from 0"
              )
          )
        <*> optional
          ( strOption
              ( long "database"
                  <> metavar "FILE"
                  <> action "file"
                  <> help "Ask this database instead of the mapping in memory"
              )
          )
        <*> optional
          ( strOption
              ( long "write"
                  <> metavar "FILE"
                  <> action "file"
                  <> help
                    "Write the mapping to an SQLite file: a new one, or one that this command \
                    \made, which is replaced"
              )
          )
        <*> switch (long "json" <> help "Print as JSON")

run :: ArrayChoice -> Options -> IO Ending
run choice options = do
  profile <- chosenProfile choice
  layout <- placementFor profile
  case (at options, write options) of
    (Just _, Just _) -> unusable "--at asks and --write writes; give one of them"
    (Just position, Nothing) -> lookUp profile layout options position
    (Nothing, Just "-") ->
      unusable "a database cannot be written to the standard output; name a file"
    (Nothing, Just _)
      | Just _ <-
          database options ->
        unusable "--write makes a database and --database asks one; give one of them"
    (Nothing, Just file) -> do
      create file (profileText profile) layout >>= orUnusable storeMessage
      if asJson options
        then
          printJson
            ("schema" .= ("pra-tactile/objects-written/1" :: String) <> "file" .= nameInJson file)
        else sayWritten file ""
      pure Answered
    (Nothing, Nothing) -> do
      shown <- maybe (pure layout) (stored profile) (database options)
      if asJson options
        then printJson (listJson profile shown)
        else putStr (unlines (listText shown))
      pure Answered
  where
    stored profile file =
      withStore file (Just (profileText profile)) (pure . storedPlacement)
        >>= orUnusable storeMessage

-- | What lies at a position, from memory or from the database.
lookUp :: Profile -> Placement -> Options -> Position -> IO Ending
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
  place <- case database options of
    Nothing -> pure (whereabouts layout window position)
    Just file ->
      withStore
        file
        (Just (profileText profile))
        (\store -> storedWhereabouts store window position)
        >>= orUnusable storeMessage
        >>= orUnusable storeMessage
  if asJson options
    then
      printJson
        ( "schema" .= ("pra-tactile/objects/1" :: String) <> "profile" .= profileValue profile
            <> "position" .= positionValue position
            <> mconcat [key .= item | (key, item) <- whereaboutsPairs (Just place)]
        )
    else putStrLn (whereText place)
  pure Answered
  where
    window = profileWindow profile
    Shape high wide = profileShape profile

listText :: Placement -> [String]
listText layout = concatMap object' (placementSolids layout)
  where
    object' body =
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
      intercalate
        " x "
        [ show (fromRational side :: Double)
          | side <- [spotRight (laidExtent laid), spotDown (laidExtent laid)]
        ]

listJson :: Profile -> Placement -> Series
listJson profile layout =
  "schema" .= ("pra-tactile/objects/1" :: String)
    <> "profile" .= profileValue profile
    <> "objects" .= map objectValue (placementSolids layout)
  where
    objectValue body =
      object
        [ "object" .= objectText (solidName body),
          "vertices"
            .= object
              [ keyOf (vertexText v)
                  .= map (fromRational :: Rational -> Double) [pointX p, pointY p, pointZ p]
                | (v, p) <- solidVertices body
              ],
          "edges"
            .= [ object
                   [ "vertices" .= map vertexText [edgeStart e, edgeEnd e],
                     "faces" .= map (map vertexText . faceVertices) [edgeLeft e, edgeRight e]
                   ]
                 | e <- solidEdges body
               ],
          "faces"
            .= [ faceValue laid
                 | laid <- laidFaces layout,
                   faceObject (laidFace laid) == solidName body
               ]
        ]
    faceValue laid =
      object
        [ "face" .= map vertexText (faceVertices (faceName (laidFace laid))),
          "position" .= positionValue (laidAt laid),
          "shape" .= shapeText (laidGrid laid),
          "size_mm"
            .= map
              (fromRational :: Rational -> Double)
              [spotRight (laidExtent laid), spotDown (laidExtent laid)]
        ]
    keyOf = fromString
