{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE TypeFamilies #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The rows of the database, for all back ends of persistent. "PraTactile.Store.Rows.Write" makes
-- them from a placement, and "PraTactile.Store.Rows.Read" converts them back.
module PraTactile.Store.Rows
  ( Rows (..),
    insertRows,
    selectRows,
    changeRows,
    TableRows (..),
    parts,
    formerPart,
    partName,
    partColumns,
    partEntity,
    allTexts,
    disagreement,
  )
where

import Control.Monad.IO.Class (MonadIO)
import Control.Monad.Trans.Reader (ReaderT)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import Database.Persist.Sql
import PraTactile.Store.Error (Table (..), tableName)
import PraTactile.Store.Schema

-- | The rows of every table.
data Rows = Rows
  { metadataRows :: [Metadata],
    objects :: [StoredObject],
    vertices :: [StoredVertex],
    faces :: [StoredFace],
    corners :: [StoredCorner],
    edges :: [StoredEdge],
    layings :: [StoredLaying],
    runBands :: [StoredBand],
    runs :: [StoredRun],
    -- | The former places of objects ("PraTactile.Store.Former"). Only 'insertRows' regards them:
    -- 'selectRows' returns none; 'changeRows', 'allTexts' and 'disagreement' ignore them.
    formerRows :: [StoredFormer]
  }

instance Semigroup Rows where
  Rows a b c d e f g h i j <> Rows a' b' c' d' e' f' g' h' i' j' =
    Rows
      (a <> a')
      (b <> b')
      (c <> c')
      (d <> d')
      (e <> e')
      (f <> f')
      (g <> g')
      (h <> h')
      (i <> i')
      (j <> j')

instance Monoid Rows where
  mempty = Rows [] [] [] [] [] [] [] [] [] []

-- | The rows of one table.
data TableRows
  = forall row.
    (PersistEntity row, PersistEntityBackend row ~ SqlBackend, Eq row) =>
    TableRows Table (Rows -> [row])

-- | All tables of a placement, each before those that refer to it.
parts :: [TableRows]
parts =
  [ TableRows MetadataTable metadataRows,
    TableRows ObjectTable objects,
    TableRows VertexTable vertices,
    TableRows FaceTable faces,
    TableRows CornerTable corners,
    TableRows EdgeTable edges,
    TableRows LayingTable layings,
    TableRows BandTable runBands,
    TableRows RunTable runs
  ]

-- | The table of former places.
formerPart :: TableRows
formerPart = TableRows FormerTable formerRows

-- | A table's name in the database.
partName :: TableRows -> String
partName (TableRows table _) = tableName table

-- | The columns of a table in order, with the type of their values that are not null: integer or
-- text.
partColumns :: TableRows -> [(Text, SqlType)]
partColumns part =
  [ (unFieldNameDB (fieldDB column), fieldSqlType column)
    | column <- getEntityFieldsDatabase (partEntity part)
  ]

-- | The columns, keys and references of a table.
partEntity :: TableRows -> EntityDef
partEntity (TableRows _ part) = entityDef (listToMaybe (part mempty))

-- | Whether all texts in the rows satisfy the test.
allTexts :: (Text -> Bool) -> Rows -> Bool
allTexts held given = all inPart parts
  where
    inPart :: TableRows -> Bool
    inPart (TableRows _ part) =
      and [held text | row <- part given, PersistText text <- values row]
    values row = map toPersistValue (toPersistFields row)

-- | Inserts all rows into empty tables.
insertRows :: MonadIO m => Rows -> ReaderT SqlBackend m ()
insertRows given = mapM_ insertPart (parts ++ [formerPart])
  where
    insertPart :: MonadIO m => TableRows -> ReaderT SqlBackend m ()
    insertPart (TableRows _ part) = insertAll (keyed (part given))

-- | All rows of a placement, in the order of their keys.
selectRows :: MonadIO m => ReaderT SqlBackend m Rows
selectRows =
  Rows <$> whole <*> whole <*> whole <*> whole <*> whole <*> whole <*> whole <*> whole <*> whole
    <*> pure []
  where
    whole ::
      (PersistEntity row, PersistEntityBackend row ~ SqlBackend, MonadIO m) =>
      ReaderT SqlBackend m [row]
    whole = map entityVal . sortOn entityKey <$> selectList [] []

-- | Changes the tables from the first rows to the second. Changed rows that others refer to are
-- replaced. Other changed rows are deleted first and inserted last, because they may refer to
-- deleted and to new rows.
changeRows :: MonadIO m => Rows -> Rows -> ReaderT SqlBackend m ()
changeRows old new = mapM_ fst (reverse steps) >> mapM_ snd steps
  where
    steps = map step parts
    -- The deletions, then the insertions.
    step :: MonadIO m => TableRows -> (ReaderT SqlBackend m (), ReaderT SqlBackend m ())
    step (TableRows table part)
      | isReferredTo table =
        ( mapM_ delete (Map.keys gone),
          mapM_ (uncurry replace) (Map.toList changed) >> insertAll come
        )
      | otherwise =
        ( mapM_ delete (Map.keys (gone <> changed)),
          insertAll (come <> changed)
        )
      where
        (before, after) = (keyed (part old), keyed (part new))
        gone = Map.difference before after
        come = Map.difference after before
        changed = Map.mapMaybe id (Map.intersectionWith other before after)
        other was is = if was == is then Nothing else Just is
    isReferredTo = (`notElem` [MetadataTable, CornerTable, EdgeTable, RunTable])

-- | The first table whose rows differ.
disagreement :: Rows -> Rows -> Maybe Table
disagreement one other =
  listToMaybe
    [ table
      | TableRows table part <- parts,
        -- This comparison is quick because the order is mostly the same.
        part one /= part other,
        keyed (part one) /= keyed (part other)
    ]

-- Every table's key consists of its columns.
keyed :: PersistEntity row => [row] -> Map.Map (Key row) row
keyed given = Map.fromList [(key row, row) | row <- given]
  where
    key = fromMaybe (error "a table whose key is none of its columns") keyFromRecordM

-- Some hundreds of rows per statement; a single statement would grow to many megabytes.
insertAll ::
  (PersistEntity row, PersistEntityBackend row ~ SqlBackend, MonadIO m) =>
  Map.Map (Key row) row ->
  ReaderT SqlBackend m ()
insertAll given = mapM_ insertEntityMany (takeWhile (not . null) (blocksOf entities))
  where
    entities = [Entity key row | (key, row) <- Map.toList given]
    blocksOf some = let (block, others) = splitAt 500 some in block : blocksOf others
