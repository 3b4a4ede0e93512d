{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE FlexibleContexts #-}
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
{-# OPTIONS_GHC -Wno-name-shadowing -Wno-unused-top-binds #-}

-- | The tables of the database. Whatever can be a key is one, and whatever refers to a row is a
-- foreign key. Lengths are exact ("PraTactile.Store.Exact"), in millimetres.
--
-- What could be missing without a trace is not stored as rows that are there or not, but as a
-- partition without a gap: bands part the array's rows, runs the columns of a band, and the objects
-- the names, each with the next name; of what belongs to an object or a face the number is told. So
-- a look-up knows whether it has read all that it rests on. Each row has a seal
-- ("PraTactile.Store.Seal") that tells whether it is as it was written.
module PraTactile.Store.Schema
  ( schemaVersion,
    migrateAll,
    migrateFormer,

    -- * Tables
    Metadata (..),
    StoredObject (..),
    StoredVertex (..),
    StoredFace (..),
    StoredCorner (..),
    StoredEdge (..),
    StoredLaying (..),
    StoredBand (..),
    StoredRun (..),
    StoredFormer (..),

    -- * Keys and columns
    Key (..),
    EntityField (..),
    Unique (..),
  )
where

import Data.Int (Int64)
import Data.Text (Text)
import Database.Persist.Sql (EntityField, Key, Unique)
import Database.Persist.TH (mkMigrate, mkPersist, persistLowerCase, share, sqlSettings)
import PraTactile.Store.Exact (Exact)

-- | The version of these tables; it changes whenever they do.
schemaVersion :: Int64
schemaVersion = 3

share
  [mkPersist sqlSettings, mkMigrate "migrateAll"]
  [persistLowerCase|
-- One row: the array, and the first of the objects' names.
Metadata sql=metadata
  schemaVersion Int64
  profile Text
  arrayRows Int64
  arrayColumns Int64
  pitchRight Exact
  pitchDown Exact
  firstName Text Maybe
  seal Int64
  Primary schemaVersion
  deriving Eq
-- The next name is that of the object whose name comes next, in the order of their characters.
StoredObject sql=object
  number Int64
  name Text
  nextName Text Maybe
  vertices Int64
  faces Int64
  edges Int64
  seal Int64
  Primary number
  UniqueObject name
  deriving Eq
StoredVertex sql=vertex
  object Int64
  number Int64
  name Text
  x Exact
  y Exact
  z Exact
  seal Int64
  Primary object number
  UniqueVertex object name
  Foreign StoredObject fk_vertex_object object
  deriving Eq
-- The name of a face is that of its corners in their order, for those who read tables; it is laid
-- (1) or not (0).
StoredFace sql=face
  object Int64
  number Int64
  name Text
  corners Int64
  laid Int64
  seal Int64
  Primary object number
  Foreign StoredObject fk_face_object object
  deriving Eq
StoredCorner sql=corner
  object Int64
  face Int64
  number Int64
  vertex Int64
  seal Int64
  Primary object face number
  Foreign StoredFace fk_corner_face object face
  Foreign StoredVertex fk_corner_vertex object vertex
  deriving Eq
StoredEdge sql=edge
  object Int64
  number Int64
  startVertex Int64
  endVertex Int64
  leftFace Int64
  rightFace Int64
  seal Int64
  Primary object number
  UniqueEdge object startVertex endVertex
  Foreign StoredVertex fk_edge_start object startVertex
  Foreign StoredVertex fk_edge_end object endVertex
  Foreign StoredFace fk_edge_left object leftFace
  Foreign StoredFace fk_edge_right object rightFace
  deriving Eq
-- The face's axes begin at its corner of the number beginsAt. The face carries gridRows x
-- gridColumns of the array, from atRow and atColumn on. They are the part, from drawnFromRow and
-- drawnFromColumn on, of a block of drawnRows x drawnColumns cells that is centred on the face. If
-- there is a margin, it is instead the distance of the grid's upper left corner, right of and below
-- that corner.
StoredLaying sql=laying
  number Int64
  object Int64
  face Int64
  beginsAt Int64
  atRow Int64
  atColumn Int64
  gridRows Int64
  gridColumns Int64
  drawnRows Int64
  drawnColumns Int64
  drawnFromRow Int64
  drawnFromColumn Int64
  marginRight Exact Maybe
  marginDown Exact Maybe
  seal Int64
  Primary number
  UniqueLaying object face
  Foreign StoredFace fk_laying_face object face
  deriving Eq
-- Rows fromRow to toRow - 1 of the array, all of which have the same runs.
StoredBand sql=band
  fromRow Int64
  toRow Int64
  seal Int64
  Primary fromRow
  deriving Eq
-- Columns fromColumn to toColumn - 1 of a band; laying is null where no laid face has them.
StoredRun sql=run
  band Int64
  fromColumn Int64
  toColumn Int64
  laying Int64 Maybe
  seal Int64
  Primary band fromColumn
  Foreign StoredBand fk_run_band band
  Foreign StoredLaying fk_run_laying laying
  deriving Eq
|]

-- Kept apart from the tables above: a store without this table is valid, too.
share
  [mkPersist sqlSettings, mkMigrate "migrateFormer"]
  [persistLowerCase|
-- A laid face of an object that lay elsewhere or is gone ("PraTactile.Store.Former"), by the names
-- of its corners from where its frame began.
StoredFormer sql=former_laying
  object Text
  number Int64
  face Text
  atRow Int64
  atColumn Int64
  gridRows Int64
  gridColumns Int64
  seal Int64
  Primary object number
  deriving Eq
|]
