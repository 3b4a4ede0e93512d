{-# LANGUAGE FlexibleContexts #-}

-- | Between the pure rows of a placement ("PraTactile.Object.Relation") and the rows of the
-- database, for every back end that persistent has.
module PraTactile.Store.Rows
  ( Rows (..),
    toRows,
    fromRows,

    -- * In the database
    insertRows,
    selectRows,
  )
where

import Control.Monad (unless)
import Control.Monad.IO.Class (MonadIO)
import Control.Monad.Trans.Reader (ReaderT)
import Data.Foldable (traverse_)
import Data.Int (Int64)
import qualified Data.Map.Strict as Map
import Data.Ratio (denominator, numerator, (%))
import qualified Data.Text as Text
import Database.Persist.Sql
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..))
import PraTactile.Object.Placement (Face (..), Pitch (..), Spot (..))
import PraTactile.Object.Relation
import PraTactile.Object.WingedEdge
import PraTactile.Store.Error
import PraTactile.Store.Schema

-- | The rows of every table with their keys, as the database holds them.
data Rows = Rows
  { metadataRows :: [Entity Metadata],
    objects :: [Entity StoredObject],
    vertices :: [Entity StoredVertex],
    faces :: [Entity StoredFace],
    corners :: [Entity StoredCorner],
    edges :: [Entity StoredEdge],
    layings :: [Entity StoredLaying],
    cells :: [Entity StoredCell]
  }

-- | The rows that hold a relation, under this profile, as yet without a digest of their contents;
-- refuses lengths and numbers that the columns cannot hold.
toRows :: String -> Relation -> Either StoreError Rows
toRows profile given = do
  Rows
    <$> (numbered <$> traverse sheet [sheetRow given])
    <*> pure (numbered [StoredObject (Text.pack (objectText object)) | object <- objectRows given])
    <*> (numbered <$> traverse vertex (vertexRows given))
    <*> (numbered <$> traverse face (faceRows given))
    <*> (numbered <$> traverse cornerOf (cornerRows given))
    <*> (numbered <$> traverse edge (edgeRows given))
    <*> (numbered <$> traverse laying (layingRows given))
    <*> (numbered <$> traverse cell (cellRows given))
  where
    objectKey = keys ObjectTable (objectRows given)
    vertexKey = keys VertexTable [(vertexObject r, vertexName r) | r <- vertexRows given]
    faceKey = keys FaceTable (faceRows given)
    layingKey = keys LayingTable (map layingFace (layingRows given))
    sheet (SheetRow shape between) =
      Metadata schemaVersion (Text.pack profile)
        <$> whole (rows shape)
        <*> whole (columns shape)
        <*> micrometres (pitchRight between)
        <*> micrometres (pitchDown between)
        <*> pure Text.empty
    vertex (VertexRow object named (Point x y z)) =
      StoredVertex
        <$> objectKey object
        <*> pure (Text.pack (vertexText named))
        <*> micrometres x
        <*> micrometres y
        <*> micrometres z
    face it = StoredFace <$> objectKey (faceObject it) <*> pure (faceLabel (faceName it))
    cornerOf (CornerRow on number named) =
      StoredCorner <$> faceKey on <*> whole number <*> vertexKey (faceObject on, named)
    edge (EdgeRow object (start, end) (left, right)) =
      StoredEdge
        <$> objectKey object
        <*> vertexKey (object, start)
        <*> vertexKey (object, end)
        <*> faceKey (Face object left)
        <*> faceKey (Face object right)
    laying (LayingRow on (r, c) (high, wide) (Spot width height)) =
      StoredLaying
        <$> faceKey on
        <*> whole r
        <*> whole c
        <*> whole high
        <*> whole wide
        <*> micrometres width
        <*> micrometres height
    cell (CellRow (r, c) on (i, j)) =
      StoredCell
        <$> whole r <*> whole c <*> layingKey on <*> whole i <*> whole j

-- Rows are keyed by their numbers, from 1, in their order.
numbered :: ToBackendKey SqlBackend row => [row] -> [Entity row]
numbered = zipWith (Entity . toSqlKey) [1 ..]

keys ::
  (Ord name, ToBackendKey SqlBackend row) =>
  Table ->
  [name] ->
  name ->
  Either StoreError (Key row)
keys table names =
  \name -> maybe (Left (UnreadableRow table)) (Right . toSqlKey) (Map.lookup name byName)
  where
    byName = Map.fromList (zip names [1 ..])

whole :: Natural -> Either StoreError Int64
whole n
  | toInteger n <= toInteger (maxBound :: Int64) = Right (fromIntegral n)
  | otherwise = Left (TooLarge (toInteger n))

-- Note [Lengths in the database] The nearest corner is found in the database by comparing squares
-- of doubled micrometres. Up to a kilometre these stay below 2^63: (2 * 10^9)^2 * 2 = 8 * 10^18.
micrometres :: Rational -> Either StoreError Int64
micrometres millimetres
  | denominator scaled == 1 && abs scaled <= 10 ^ (9 :: Int) =
    Right (fromInteger (numerator scaled))
  | otherwise = Left (NotStorable millimetres)
  where
    scaled = millimetres * 1000

fromMicrometres :: Int64 -> Rational
fromMicrometres length_ = toInteger length_ % 1000

faceLabel :: FaceName -> Text.Text
faceLabel = Text.pack . faceText

-- | The relation that rows hold, and its profile; refuses rows that cannot be read. Whether the
-- relation makes sense is for 'placementOf' to say.
fromRows :: Rows -> Either StoreError (String, Relation)
fromRows stored = do
  sheet <- case metadataRows stored of
    [Entity _ only] -> Right only
    _ -> Left (UnreadableRow MetadataTable)
  traverse_ labelled (faces stored)
  given <-
    Relation
      <$> ( SheetRow
              <$> ( uncurry Shape
                      <$> pair MetadataTable (metadataArrayRows sheet) (metadataArrayColumns sheet)
                  )
              <*> pure
                ( Pitch
                    (fromMicrometres (metadataPitchRightUm sheet))
                    (fromMicrometres (metadataPitchDownUm sheet))
                )
          )
      <*> pure
        [ObjectName (Text.unpack (storedObjectName object)) | Entity _ object <- objects stored]
      <*> rowsOf vertices vertex
      <*> traverse (faceBy FaceTable . entityKey) (faces stored)
      <*> rowsOf corners cornerOf
      <*> rowsOf edges edge
      <*> rowsOf layings laying
      <*> rowsOf cells cell
  pure (Text.unpack (metadataProfile sheet), given)
  where
    rowsOf part convert = traverse (convert . entityVal) (part stored)
    objectNames = byKey objects (ObjectName . Text.unpack . storedObjectName)
    vertexNames = byKey vertices (VertexName . Text.unpack . storedVertexName)
    objectBy table = find table objectNames
    vertexBy table = find table vertexNames
    walks =
      Map.fromListWith
        Map.union
        [ (storedCornerFace it, Map.singleton (storedCornerNumber it) (storedCornerVertex it))
          | Entity _ it <- corners stored
        ]
    owner = byKey faces storedFaceObject
    faceBy table key =
      Face
        <$> (find table owner key >>= objectBy table)
        <*> (FaceName <$> (find table walks key >>= traverse (vertexBy table) . Map.elems))
    layingBy table = find table (byKey layings storedLayingFace)
    byKey part content = Map.fromList [(key, content it) | Entity key it <- part stored]
    labelled (Entity key it) = do
      named <- faceBy FaceTable key
      unless
        (faceLabel (faceName named) == storedFaceName it)
        (Left (InconsistentRows (RowsDisagree FaceTable)))
    vertex (StoredVertex object named x y z) =
      VertexRow
        <$> objectBy VertexTable object
        <*> pure (VertexName (Text.unpack named))
        <*> pure (Point (fromMicrometres x) (fromMicrometres y) (fromMicrometres z))
    cornerOf (StoredCorner face number at) =
      CornerRow
        <$> faceBy CornerTable face
        <*> natural CornerTable number
        <*> vertexBy CornerTable at
    edge (StoredEdge object start end left right) =
      EdgeRow
        <$> objectBy EdgeTable object
        <*> ((,) <$> vertexBy EdgeTable start <*> vertexBy EdgeTable end)
        <*> ((,) <$> (faceName <$> faceBy EdgeTable left) <*> (faceName <$> faceBy EdgeTable right))
    laying (StoredLaying face r c high wide width height) =
      LayingRow
        <$> faceBy LayingTable face
        <*> pair LayingTable r c
        <*> pair LayingTable high wide
        <*> pure (Spot (fromMicrometres width) (fromMicrometres height))
    cell (StoredCell r c on i j) =
      CellRow
        <$> pair CellTable r c
          <*> (layingBy CellTable on >>= faceBy CellTable)
          <*> pair CellTable i j
    pair table a b = (,) <$> natural table a <*> natural table b
    natural :: Table -> Int64 -> Either StoreError Natural
    natural table n = if n < 0 then Left (UnreadableRow table) else Right (fromIntegral n)

find :: Ord key => Table -> Map.Map key row -> key -> Either StoreError row
find table rows_ key = maybe (Left (UnreadableRow table)) Right (Map.lookup key rows_)

-- | Put all rows into empty tables.
insertRows :: MonadIO m => Rows -> ReaderT SqlBackend m ()
insertRows given = do
  insertEntityMany (metadataRows given)
  insertEntityMany (objects given)
  insertEntityMany (vertices given)
  insertEntityMany (faces given)
  insertEntityMany (corners given)
  insertEntityMany (edges given)
  insertEntityMany (layings given)
  insertEntityMany (cells given)

-- | All rows, in the order of their keys.
selectRows :: MonadIO m => ReaderT SqlBackend m Rows
selectRows =
  Rows
    <$> selectList [] [Asc MetadataId]
    <*> selectList [] [Asc StoredObjectId]
    <*> selectList [] [Asc StoredVertexId]
    <*> selectList [] [Asc StoredFaceId]
    <*> selectList [] [Asc StoredCornerId]
    <*> selectList [] [Asc StoredEdgeId]
    <*> selectList [] [Asc StoredLayingId]
    <*> selectList [] [Asc StoredCellId]
