{-# LANGUAGE FlexibleContexts #-}

-- | From the pure rows of a placement to the rows of the database.
module PraTactile.Store.Rows.Write
  ( toRows,
  )
where

import Data.Bifunctor (first)
import Data.Int (Int64)
import qualified Data.Map.Strict as Map
import Data.Ratio (denominator, numerator)
import qualified Data.Text as Text
import Database.Persist.Sql
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..))
import PraTactile.Object.Placement (Anchor (..), Face (..), Pitch (..), Spot (..))
import PraTactile.Object.Relation
import PraTactile.Object.Surd (asFraction)
import PraTactile.Object.WingedEdge
import PraTactile.Store.Error
import PraTactile.Store.Rows
import PraTactile.Store.Schema

-- | The rows that hold a relation, under this profile, as yet without a digest of their contents;
-- refuses lengths and numbers that the columns cannot hold.
toRows :: String -> Relation -> Either StoreError Rows
toRows profile given =
  Rows
    <$> (numbered <$> traverse (storedSheet profile) [sheetRow given])
    <*> pure (numbered [StoredObject (Text.pack (objectText object)) | object <- objectRows given])
    <*> (numbered <$> traverse (storedVertex keys) (vertexRows given))
    <*> (numbered <$> traverse (storedFace keys) (faceRows given))
    <*> (numbered <$> traverse (storedCorner keys) (cornerRows given))
    <*> (numbered <$> traverse (storedEdge keys) (edgeRows given))
    <*> (numbered <$> traverse (storedLaying keys) (layingRows given))
    <*> (numbered <$> traverse (storedCell keys) (cellRows given))
  where
    keys = keysOf given

-- | Rows are keyed by their numbers, from 1, in their order.
numbered :: ToBackendKey SqlBackend row => [row] -> [Entity row]
numbered = zipWith (Entity . toSqlKey) [1 ..]

-- | The keys of the rows that other rows refer to.
data Keys = Keys
  { objectKey :: ObjectName -> Either StoreError StoredObjectId,
    vertexKey :: (ObjectName, VertexName) -> Either StoreError StoredVertexId,
    faceKey :: Face -> Either StoreError StoredFaceId,
    layingKey :: Face -> Either StoreError StoredLayingId
  }

keysOf :: Relation -> Keys
keysOf given =
  Keys
    { objectKey = keyIn ObjectTable (objectRows given),
      vertexKey = keyIn VertexTable [(vertexObject r, vertexName r) | r <- vertexRows given],
      faceKey = keyIn FaceTable (faceRows given),
      layingKey = keyIn LayingTable (map layingFace (layingRows given))
    }

-- | The key of a name, given the names of a table in their order.
keyIn ::
  (Ord name, ToBackendKey SqlBackend row) => Table -> [name] -> name -> Either StoreError (Key row)
keyIn table names =
  \name -> maybe (Left (UnreadableRow table)) (Right . toSqlKey) (Map.lookup name byName)
  where
    byName = Map.fromList (zip names [1 ..])

storedSheet :: String -> SheetRow -> Either StoreError Metadata
storedSheet profile (SheetRow shape between) =
  Metadata schemaVersion (Text.pack profile)
    <$> whole (rows shape)
    <*> whole (columns shape)
    <*> micrometres (pitchRight between)
    <*> micrometres (pitchDown between)
    <*> pure Text.empty

storedVertex :: Keys -> VertexRow -> Either StoreError StoredVertex
storedVertex keys (VertexRow object named (Point x y z)) =
  StoredVertex
    <$> objectKey keys object
    <*> pure (Text.pack (vertexText named))
    <*> micrometres x
    <*> micrometres y
    <*> micrometres z

storedFace :: Keys -> Face -> Either StoreError StoredFace
storedFace keys face =
  StoredFace <$> objectKey keys (faceObject face) <*> pure (faceLabel (faceName face))

storedCorner :: Keys -> CornerRow -> Either StoreError StoredCorner
storedCorner keys (CornerRow on number named) =
  StoredCorner <$> faceKey keys on <*> whole number <*> vertexKey keys (faceObject on, named)

storedEdge :: Keys -> EdgeRow -> Either StoreError StoredEdge
storedEdge keys (EdgeRow object (start, end) (left, right)) =
  StoredEdge
    <$> objectKey keys object
    <*> vertexKey keys (object, start)
    <*> vertexKey keys (object, end)
    <*> faceKey keys (Face object left)
    <*> faceKey keys (Face object right)

storedLaying :: Keys -> LayingRow -> Either StoreError StoredLaying
storedLaying keys (LayingRow on (r, c) (high, wide) anchor (Spot width height)) =
  StoredLaying
    <$> (if anchor == Centred then notFrom on (faceKey keys on) else Left (LayingNotStorable on))
    <*> whole r
    <*> whole c
    <*> whole high
    <*> whole wide
    <*> side width
    <*> side height
  where
    side = maybe (Left (LayingNotStorable on)) micrometres . asFraction
    -- A face that is begun at another vertex than in its object is none of the object's rows.
    notFrom face = first (const (LayingNotStorable face))

storedCell :: Keys -> CellRow -> Either StoreError StoredCell
storedCell keys (CellRow (r, c) on (i, j)) =
  StoredCell <$> whole r <*> whole c <*> layingKey keys on <*> whole i <*> whole j

whole :: Natural -> Either StoreError Int64
whole n
  | toInteger n <= toInteger (maxBound :: Int64) = Right (fromIntegral n)
  | otherwise = Left (TooLarge (toInteger n))

-- | A length in whole micrometres, up to a kilometre. See Note [Lengths in the database].
micrometres :: Rational -> Either StoreError Int64
micrometres millimetres
  | denominator scaled == 1 && abs scaled <= 10 ^ (9 :: Int) =
    Right (fromInteger (numerator scaled))
  | otherwise = Left (NotStorable millimetres)
  where
    scaled = millimetres * 1000

{- Note [Lengths in the database] The nearest corner is found in the database by comparing squares
   of doubled micrometres. Up to a kilometre these stay below 2^63: (2 * 10^9)^2 * 2 = 8 * 10^18. -}
