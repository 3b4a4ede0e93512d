{-# LANGUAGE FlexibleContexts #-}

-- | The rows of the database, written and read by every back end that persistent has.
-- "PraTactile.Store.Rows.Write" makes them of the pure rows of a placement
-- ("PraTactile.Object.Relation"), "PraTactile.Store.Rows.Read" turns them back.
module PraTactile.Store.Rows
  ( Rows (..),
    insertRows,
    selectRows,
    faceLabel,
  )
where

import Control.Monad.IO.Class (MonadIO)
import Control.Monad.Trans.Reader (ReaderT)
import qualified Data.Text as Text
import Database.Persist.Sql
import PraTactile.Object.WingedEdge (FaceName, faceText)
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

-- | The name of a face as its row has it.
faceLabel :: FaceName -> Text.Text
faceLabel = Text.pack . faceText
