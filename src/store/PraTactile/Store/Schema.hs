{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE GADTs #-}
{-# LANGUAGE GeneralizedNewtypeDeriving #-}
{-# LANGUAGE MultiParamTypeClasses #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE QuasiQuotes #-}
{-# LANGUAGE StandaloneDeriving #-}
{-# LANGUAGE TemplateHaskell #-}
{-# LANGUAGE TypeFamilies #-}
{-# LANGUAGE TypeOperators #-}
{-# LANGUAGE UndecidableInstances #-}
{-# OPTIONS_GHC -Wno-name-shadowing #-}

-- | The tables of the database. Whatever can be a key is one, and whatever refers to a row is a
-- foreign key. Lengths are whole micrometres, so that equal distances are equal in every back end.
-- "PraTactile.Store.Rows" fills the tables and reads them.
module PraTactile.Store.Schema
  ( schemaVersion,
    tableColumns,
    textColumns,
    migrateAll,

    -- * Tables
    Metadata (..),
    StoredObject (..),
    StoredVertex (..),
    StoredFace (..),
    StoredCorner (..),
    StoredEdge (..),
    StoredLaying (..),
    StoredCell (..),

    -- * Keys and columns
    MetadataId,
    StoredObjectId,
    StoredVertexId,
    StoredFaceId,
    StoredCornerId,
    StoredEdgeId,
    StoredLayingId,
    StoredCellId,
    Key (..),
    EntityField (..),
    Unique (..),
  )
where

import Data.Int (Int64)
import Data.Text (Text)
import Database.Persist.Sql (EntityField, Key, Unique)
import Database.Persist.TH (mkMigrate, mkPersist, persistLowerCase, share, sqlSettings)

-- | The version of these tables; it changes whenever they do.
schemaVersion :: Int
schemaVersion = 2

-- | The tables, which every version has, each with its columns in their order: what the
-- declarations below become in SQL.
tableColumns :: [(Text, [Text])]
tableColumns =
  [ ( "metadata",
      [ "id",
        "schema_version",
        "profile",
        "array_rows",
        "array_columns",
        "pitch_right_um",
        "pitch_down_um",
        "contents"
      ]
    ),
    ("object", ["id", "name"]),
    ("vertex", ["id", "object", "name", "x_um", "y_um", "z_um"]),
    ("face", ["id", "object", "name"]),
    ("corner", ["id", "face", "number", "vertex"]),
    ("edge", ["id", "object", "start_vertex", "end_vertex", "left_face", "right_face"]),
    ( "laying",
      ["id", "face", "at_row", "at_column", "grid_rows", "grid_columns", "width_um", "height_um"]
    ),
    ("cell", ["id", "array_row", "array_column", "laying", "local_row", "local_column"])
  ]

-- | The columns, of whatever table, whose values are text; those of all others are integers.
textColumns :: [Text]
textColumns = ["name", "profile", "contents"]

share
  [mkPersist sqlSettings, mkMigrate "migrateAll"]
  [persistLowerCase|
Metadata sql=metadata
  schemaVersion Int
  profile Text
  arrayRows Int64
  arrayColumns Int64
  pitchRightUm Int64
  pitchDownUm Int64
  contents Text
  UniqueSchema schemaVersion
StoredObject sql=object
  name Text
  UniqueObject name
StoredVertex sql=vertex
  object StoredObjectId
  name Text
  xUm Int64
  yUm Int64
  zUm Int64
  UniqueVertex object name
StoredFace sql=face
  object StoredObjectId
  name Text
  UniqueFace object name
StoredCorner sql=corner
  face StoredFaceId
  number Int64
  vertex StoredVertexId
  UniqueCorner face number
  UniqueCornerVertex face vertex
StoredEdge sql=edge
  object StoredObjectId
  startVertex StoredVertexId
  endVertex StoredVertexId
  leftFace StoredFaceId
  rightFace StoredFaceId
  UniqueEdge startVertex endVertex
StoredLaying sql=laying
  face StoredFaceId
  atRow Int64
  atColumn Int64
  gridRows Int64
  gridColumns Int64
  widthUm Int64
  heightUm Int64
  UniqueLaying face
StoredCell sql=cell
  arrayRow Int64
  arrayColumn Int64
  laying StoredLayingId
  localRow Int64
  localColumn Int64
  UniqueCell arrayRow arrayColumn
  UniqueLocalCell laying localRow localColumn
|]
