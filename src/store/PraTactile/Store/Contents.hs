{-# LANGUAGE FlexibleContexts #-}

-- | A digest of all rows, which the store carries: a name can be changed without a contradiction,
-- for no other row depends on it, and the digest tells that too.
module PraTactile.Store.Contents
  ( sealed,
    isSealed,
  )
where

import Data.Int (Int64)
import qualified Data.Text as Text
import Database.Persist.Sql
import PraTactile.Certificate.Digest (sha256OfText)
import PraTactile.Store.Rows
import PraTactile.Store.Schema

-- | The rows, their metadata with the digest of them all.
sealed :: Rows -> Rows
sealed rows =
  rows
    { metadataRows =
        [Entity key sheet {metadataContents = digest rows} | Entity key sheet <- metadataRows rows]
    }

-- | Whether the metadata have the digest of the rows.
isSealed :: Rows -> Bool
isSealed rows = and [metadataContents sheet == digest rows | Entity _ sheet <- metadataRows rows]

-- | The SHA-256 of every cell of every table but the digest's own, keys included, in 64 hexadecimal
-- digits.
digest :: Rows -> Text.Text
digest rows =
  Text.pack
    ( sha256OfText
        ( unlines
            ( concat
                [ table (metadataRows rows) $ \it ->
                    ( (metadataSchemaVersion it, metadataProfile it),
                      (metadataArrayRows it, metadataArrayColumns it),
                      (metadataPitchRightUm it, metadataPitchDownUm it)
                    ),
                  table (objects rows) storedObjectName,
                  table (vertices rows) $ \(StoredVertex object name x y z) ->
                    (number object, name, [x, y, z]),
                  table (faces rows) $ \(StoredFace object name) -> (number object, name),
                  table (corners rows) $ \(StoredCorner face at vertex) ->
                    [number face, at, number vertex],
                  table (edges rows) $ \(StoredEdge object start end left right) ->
                    [number object, number start, number end, number left, number right],
                  table (layings rows) $ \(StoredLaying face r c high wide width height) ->
                    [number face, r, c, high, wide, width, height],
                  table (cells rows) $ \(StoredCell r c laying i j) -> [r, c, number laying, i, j]
                ]
            )
        )
    )

-- A line a row, and one that says how many there are, so that no row passes for one of another
-- table. What 'show' makes of text is ASCII, and different for different texts.
table :: (ToBackendKey SqlBackend row, Show content) => [Entity row] -> (row -> content) -> [String]
table rows content = show (length rows) : [show (number key, content row) | Entity key row <- rows]

number :: ToBackendKey SqlBackend row => Key row -> Int64
number = fromSqlKey
