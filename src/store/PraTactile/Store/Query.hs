{-# LANGUAGE OverloadedStrings #-}

-- | Both look-ups by the database alone (\"searching the relational database that stores the object
-- geometry/PRA mapping\", section II.B of the paper). The SQL is standard but for @%@, the
-- remainder, which SQLite and PostgreSQL both have. 'PraTactile.Object.Placement.whereabouts' and
-- 'PraTactile.Object.Placement.arrayPosition' say what the answers must be.
module PraTactile.Store.Query
  ( Query,

    -- * From the array to the objects
    selectWhereabouts,

    -- * From the objects to the array
    selectPosition,
  )
where

import Control.Monad.IO.Class (MonadIO)
import Control.Monad.Trans.Reader (ReaderT)
import Data.Foldable (find)
import Data.Int (Int64)
import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import Data.Text (Text)
import qualified Data.Text as Text
import Database.Persist.Sql (PersistValue (..), Single (..), SqlBackend, rawSql)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Placement
  ( Face (..),
    Place (..),
    PlacementError (..),
    Spot (..),
    Whereabouts (..),
  )
import PraTactile.Object.Relation (Table (..))
import PraTactile.Object.Surd (fraction)
import PraTactile.Object.WingedEdge
import PraTactile.Store.Error (StoreError (..))

-- | What asks a database.
type Query m = ReaderT SqlBackend m

-- | Where the window of the given shape at the given position is; the array's shape comes first.
selectWhereabouts ::
  MonadIO m =>
  Shape ->
  Shape ->
  Position ->
  Query m (Either StoreError Whereabouts)
selectWhereabouts array window at
  | rows window == 0 || columns window == 0 = pure (Right OnNoObject)
  | otherwise = do
    found <-
      rawSql
        piecesSql
        [ number (row at `mod` rows array),
          number (rows array),
          number (rows array),
          number (column at `mod` columns array),
          number (columns array),
          number (columns array),
          number (min (rows window) (rows array)),
          number (min (columns window) (columns array))
        ]
    let whole =
          [ (laying, r, c)
            | ( Single laying,
                Single r,
                Single c,
                Single cells
                ) <-
                found,
              isWhole cells
          ]
        touched = nub [laying | (Single laying, _, _, _) <- found]
    case (whole, touched) of
      ((laying, r, c) : _, _) -> fmap OnFace <$> selectPlace window laying r c
      ([], _ : _ : _) -> Right . Straddles <$> traverse selectFace touched
      _ -> pure (Right OnNoObject)
  where
    isWhole :: Int64 -> Bool
    isWhole cells = toInteger cells == toInteger (rows window) * toInteger (columns window)

-- The window's cells, each by how far down and across it is from the window's upper left cell,
-- round the torus. Cells of one face that are side by side there as they are in the window have
-- that upper left cell in common; a group of all the window's cells is the window whole.
-- Parameters: row, rows, rows; column, columns, columns; rows and columns of the window.
piecesSql :: Text
piecesSql =
  "SELECT laying, local_row - down AS base_row, local_column - across AS base_column, COUNT(*) \
  \FROM (SELECT laying, local_row, local_column, \
  \             (array_row - ? + ?) % ? AS down, (array_column - ? + ?) % ? AS across \
  \      FROM cell) AS ahead \
  \WHERE down < ? AND across < ? \
  \GROUP BY laying, local_row - down, local_column - across \
  \ORDER BY laying, base_row, base_column"

selectPlace :: MonadIO m => Shape -> Int64 -> Int64 -> Int64 -> Query m (Either StoreError Place)
selectPlace window laying r c = do
  face <- selectFace laying
  nearest <-
    rawSql
      nearestSql
      [ PersistInt64 c,
        number
          ( columns
              window
          ),
        PersistInt64 r,
        number (rows window),
        PersistInt64 laying
      ]
  pure $ case nearest of
    [] -> Left (UnreadableRow CornerTable)
    (_, Single right, Single down) : _ ->
      Right
        Place
          { placeFace = face,
            placeCell = Position (fromIntegral r) (fromIntegral c),
            placeCentre = Spot (fraction (doubled right)) (fraction (doubled down)),
            placeCorners = [VertexName (Text.unpack vertex) | (Single vertex, _, _) <- nearest]
          }
  where
    doubled :: Int64 -> Rational
    doubled micrometres = toInteger micrometres % 2000

-- The corners nearest to a window's centre, in the order of the face's name, with the centre; all
-- in doubled micrometres from the face's upper left corner, for the centre may lie between two
-- micrometres. Corner 0 is the face's upper left, 1 its lower left, 2 its lower right, 3 its upper
-- right. Parameters: the window's first column on the face, its columns; its first row, its rows;
-- the laying.
nearestSql :: Text
nearestSql =
  "WITH centre AS ( \
  \  SELECT laying.face AS face, 2 * laying.width_um AS wide, 2 * laying.height_um AS high, \
  \    laying.width_um + (2 * ? + ? - laying.grid_columns) * metadata.pitch_right_um AS x, \
  \    laying.height_um + (2 * ? + ? - laying.grid_rows) * metadata.pitch_down_um AS y \
  \  FROM laying CROSS JOIN metadata WHERE laying.id = ?), \
  \placed AS ( \
  \  SELECT corner.number AS number, corner.vertex AS vertex, centre.x AS x, centre.y AS y, \
  \    (CASE WHEN corner.number IN (2, 3) THEN centre.wide ELSE 0 END) - centre.x AS dx, \
  \    (CASE WHEN corner.number IN (1, 2) THEN centre.high ELSE 0 END) - centre.y AS dy \
  \  FROM corner JOIN centre ON corner.face = centre.face) \
  \SELECT vertex.name, placed.x, placed.y FROM placed JOIN vertex ON vertex.id = placed.vertex \
  \WHERE placed.dx * placed.dx + placed.dy * placed.dy = (SELECT MIN(dx * dx + dy * dy) FROM \
  \placed) \
  \ORDER BY placed.number"

selectFace :: MonadIO m => Int64 -> Query m Face
selectFace laying = do
  named <-
    rawSql
      "SELECT object.name, vertex.name FROM laying \
      \JOIN face ON face.id = laying.face JOIN object ON object.id = face.object \
      \JOIN corner ON corner.face = face.id JOIN vertex ON vertex.id = corner.vertex \
      \WHERE laying.id = ? ORDER BY corner.number"
      [PersistInt64 laying]
  pure
    ( Face
        ( ObjectName
            ( concat
                ( take
                    1
                    [Text.unpack object | (Single object, Single (_ :: Text)) <- named]
                )
            )
        )
        (FaceName [VertexName (Text.unpack vertex) | (_, Single vertex) <- named])
    )

-- | Where on the array a cell of a face's block lies, the cell given by its row and column within
-- the block; refuses as 'PraTactile.Object.Placement.arrayPosition' does.
selectPosition :: MonadIO m => Face -> Position -> Query m (Either StoreError Position)
selectPosition (Face object walk) local = do
  named <- rawSql "SELECT id FROM object WHERE name = ?" [text object]
  corners <-
    rawSql
      "SELECT face.id, vertex.name FROM object JOIN face ON face.object = object.id \
      \JOIN corner ON corner.face = face.id JOIN vertex ON vertex.id = corner.vertex \
      \WHERE object.name = ? ORDER BY face.id, corner.number"
      [text object]
  let walks =
        Map.toList
          ( Map.fromListWith
              (flip (++))
              [(face, [VertexName (Text.unpack vertex)]) | (Single face, Single vertex) <- corners]
          )
      known = [(face, FaceName vertices) | (face, vertices) <- walks]
  case ( named :: [Single Int64],
         find (sameFace walk . snd) known,
         find
           (sameVertices walk . snd)
           known
       ) of
    ([], _, _) -> pure (refuse (UnknownObject object))
    (_, Just (face, name), _) -> selectCell face (Face object name) local
    (_, Nothing, Just (_, name)) -> pure (refuse (WrongVertexOrder (Face object walk) name))
    (_, Nothing, Nothing) -> pure (refuse (UnknownFace (Face object walk)))
  where
    text = PersistText . Text.pack . objectText

selectCell :: MonadIO m => Int64 -> Face -> Position -> Query m (Either StoreError Position)
selectCell key face local = do
  laid <- rawSql "SELECT id FROM laying WHERE face = ?" [PersistInt64 key]
  cells <-
    if max (row local) (column local) > fromIntegral (maxBound :: Int64)
      then pure []
      else
        rawSql
          "SELECT cell.array_row, cell.array_column \
          \FROM cell JOIN laying ON laying.id = cell.laying \
          \WHERE laying.face = ? AND cell.local_row = ? AND cell.local_column = ?"
          [PersistInt64 key, number (row local), number (column local)]
  pure $ case (laid :: [Single Int64], cells) of
    ([], _) -> refuse (FaceNotLaid face)
    (_, (Single r, Single c) : _) ->
      Right (Position (fromIntegral (r :: Int64)) (fromIntegral (c :: Int64)))
    (_, []) -> refuse (CellOffFace face local)

refuse :: PlacementError -> Either StoreError a
refuse = Left . NotInStore

number :: Integral n => n -> PersistValue
number = PersistInt64 . fromIntegral
