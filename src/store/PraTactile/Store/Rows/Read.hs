{-# LANGUAGE FlexibleContexts #-}

-- | From the rows of the database back to the pure rows of a placement.
module PraTactile.Store.Rows.Read
  ( fromRows,
  )
where

import Control.Monad (unless)
import Data.Foldable (traverse_)
import Data.Int (Int64)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import qualified Data.Text as Text
import Database.Persist.Sql
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..))
import PraTactile.Object.Placement (Anchor (..), Face (..), Pitch (..), Spot (..))
import PraTactile.Object.Relation
import PraTactile.Object.Surd (fraction)
import PraTactile.Object.WingedEdge
import PraTactile.Store.Error
import PraTactile.Store.Rows
import PraTactile.Store.Schema

-- | The relation that rows hold, and its profile; refuses rows that cannot be read. Whether the
-- relation makes sense is for 'placementOf' to say.
fromRows :: Rows -> Either StoreError (String, Relation)
fromRows stored = do
  sheet <- case metadataRows stored of
    [Entity _ only] -> Right only
    _ -> Left (UnreadableRow MetadataTable)
  traverse_ (labelled named) (faces stored)
  given <-
    Relation
      <$> sheetOf sheet
      <*> pure (map (objectOf . entityVal) (objects stored))
      <*> rowsOf vertices vertexOf
      <*> traverse (faceNamed named FaceTable . entityKey) (faces stored)
      <*> rowsOf corners cornerOf
      <*> rowsOf edges edgeOf
      <*> rowsOf layings layingOf
      <*> rowsOf cells cellOf
  pure (Text.unpack (metadataProfile sheet), given)
  where
    named = namesOf stored
    rowsOf part convert = traverse (convert named . entityVal) (part stored)

-- | What keys stand for, each asked for a table, which is named where a row of it has a key that
-- stands for nothing.
data Names = Names
  { objectNamed :: Table -> StoredObjectId -> Either StoreError ObjectName,
    vertexNamed :: Table -> StoredVertexId -> Either StoreError VertexName,
    faceNamed :: Table -> StoredFaceId -> Either StoreError Face,
    layingNamed :: Table -> StoredLayingId -> Either StoreError StoredFaceId
  }

namesOf :: Rows -> Names
namesOf stored =
  Names
    { objectNamed = \table -> find table objectNames,
      vertexNamed = \table -> find table vertexNames,
      faceNamed = \table key ->
        Face
          <$> (find table owners key >>= find table objectNames)
          <*> (FaceName <$> (find table walks key >>= traverse (find table vertexNames))),
      layingNamed = \table -> find table layingFaces
    }
  where
    objectNames = byKey objectOf (objects stored)
    vertexNames = byKey (VertexName . Text.unpack . storedVertexName) (vertices stored)
    owners = byKey storedFaceObject (faces stored)
    layingFaces = byKey storedLayingFace (layings stored)
    -- The vertices of each face, by their numbers.
    walks =
      Map.elems
        <$> Map.fromListWith
          Map.union
          [ (storedCornerFace it, Map.singleton (storedCornerNumber it) (storedCornerVertex it))
            | Entity _ it <- corners stored
          ]
    byKey :: Ord (Key row) => (row -> a) -> [Entity row] -> Map (Key row) a
    byKey content entities = Map.fromList [(key, content it) | Entity key it <- entities]

find :: Ord key => Table -> Map key row -> key -> Either StoreError row
find table known key = maybe (Left (UnreadableRow table)) Right (Map.lookup key known)

-- | A face's row must have the name that its corners give it.
labelled :: Names -> Entity StoredFace -> Either StoreError ()
labelled named (Entity key it) = do
  face <- faceNamed named FaceTable key
  unless
    (faceLabel (faceName face) == storedFaceName it)
    (Left (InconsistentRows (RowsDisagree FaceTable)))

sheetOf :: Metadata -> Either StoreError SheetRow
sheetOf sheet = flip SheetRow pitch . uncurry Shape <$> shape
  where
    shape = pair MetadataTable (metadataArrayRows sheet) (metadataArrayColumns sheet)
    pitch =
      Pitch
        (fromMicrometres (metadataPitchRightUm sheet))
        (fromMicrometres (metadataPitchDownUm sheet))

objectOf :: StoredObject -> ObjectName
objectOf = ObjectName . Text.unpack . storedObjectName

vertexOf :: Names -> StoredVertex -> Either StoreError VertexRow
vertexOf named (StoredVertex object name x y z) =
  VertexRow
    <$> objectNamed named VertexTable object
    <*> pure (VertexName (Text.unpack name))
    <*> pure (Point (fromMicrometres x) (fromMicrometres y) (fromMicrometres z))

cornerOf :: Names -> StoredCorner -> Either StoreError CornerRow
cornerOf named (StoredCorner face number at) =
  CornerRow
    <$> faceNamed named CornerTable face
    <*> natural CornerTable number
    <*> vertexNamed named CornerTable at

edgeOf :: Names -> StoredEdge -> Either StoreError EdgeRow
edgeOf named (StoredEdge object start end left right) =
  EdgeRow
    <$> objectNamed named EdgeTable object
    <*> ((,) <$> vertex start <*> vertex end)
    <*> ((,) <$> face left <*> face right)
  where
    vertex = vertexNamed named EdgeTable
    face = fmap faceName . faceNamed named EdgeTable

layingOf :: Names -> StoredLaying -> Either StoreError LayingRow
layingOf named (StoredLaying face r c high wide width height) =
  LayingRow
    <$> faceNamed named LayingTable face
    <*> pair LayingTable r c
    <*> pair LayingTable high wide
    <*> pure Centred
    <*> pure (Spot (fraction (fromMicrometres width)) (fraction (fromMicrometres height)))

cellOf :: Names -> StoredCell -> Either StoreError CellRow
cellOf named (StoredCell r c on i j) =
  CellRow
    <$> pair CellTable r c
    <*> (layingNamed named CellTable on >>= faceNamed named CellTable)
    <*> pair CellTable i j

pair :: Table -> Int64 -> Int64 -> Either StoreError (Natural, Natural)
pair table a b = (,) <$> natural table a <*> natural table b

natural :: Table -> Int64 -> Either StoreError Natural
natural table n = if n < 0 then Left (UnreadableRow table) else Right (fromIntegral n)

fromMicrometres :: Int64 -> Rational
fromMicrometres length_ = toInteger length_ % 1000
