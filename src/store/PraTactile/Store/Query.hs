{-# LANGUAGE TypeFamilies #-}

-- | Both look-ups by the database (\"searching the relational database that stores the object
-- geometry/PRA mapping\", section II.B of the paper). The database finds the few needed rows by its
-- indexes. Each row is checked against its seal, and 'PraTactile.Object.Placement.whereaboutsIn'
-- computes the answer.
module PraTactile.Store.Query
  ( Query,

    -- * From the array to the objects
    selectWhereabouts,

    -- * From the objects to the array
    selectPosition,

    -- * Some of the objects
    selectObjects,
    selectNear,
    selectFirstLaid,

    -- * The array
    selectSheet,
  )
where

import Control.Monad (unless)
import Control.Monad.IO.Class (MonadIO)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT, except, throwE)
import Control.Monad.Trans.Reader (ReaderT)
import Data.Foldable (for_)
import Data.Int (Int64)
import Data.List (sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import qualified Data.Set as Set
import qualified Data.Text as Text
import Data.Traversable (for)
import Database.Persist.Sql hiding (count)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), area)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Store.Error
import PraTactile.Store.Rows hiding (parts)
import PraTactile.Store.Rows.Read
import PraTactile.Store.Schema

-- | A database query that may fail.
type Query m = ExceptT StoreError (ReaderT SqlBackend m)

-- | The whereabouts of a window. The arguments are the array's shape and pitch, and the window's
-- shape and position.
selectWhereabouts :: MonadIO m => Shape -> Pitch -> Shape -> Position -> Query m Whereabouts
selectWhereabouts shape between = whereaboutsIn (Mapping shape between (selectCells between))

-- | The cells of laid faces in a rectangle of the array, by the numbers of their layings.
selectCells ::
  MonadIO m =>
  Pitch ->
  (Natural, Natural) ->
  (Natural, Natural) ->
  Query m (Map.Map Int (Natural, Query m Seat))
selectCells between down across = do
  found <- selectOver [(down, across)]
  counts <- for found $ \(band, crossed) -> do
    high <- inCommon down <$> bandRange band
    for [(run, n) | run <- crossed, Just n <- [storedRunLaying run]] $ \(run, laying) -> do
      from <- except (natural RunTable (storedRunFromColumn run))
      to <- except (natural RunTable (storedRunToColumn run))
      pure (fromIntegral laying, (high * inCommon across (from, to), selectSeat between laying))
  pure (Map.fromListWith more (concat counts))

-- | The bands that meet some rectangles (each a range of rows and one of columns), and for each
-- band the runs that meet them.
selectOver ::
  MonadIO m =>
  [((Natural, Natural), (Natural, Natural))] ->
  Query m [(StoredBand, [StoredRun])]
selectOver rectangles = do
  found <- concat <$> traverse bandsOver (united (map fst rectangles))
  for (distinct storedBandFromRow found) $ \band -> do
    range <- bandRange band
    let across = united [columns' | (down, columns') <- rectangles, down `meets` range]
    crossed <- concat <$> traverse (runsOver (storedBandFromRow band)) across
    pure (band, distinct storedRunFromColumn crossed)
  where
    (from, to) `meets` (from', to') = from < to' && from' < to
    distinct key found = Map.elems (Map.fromList [(key row', row') | row' <- found])

-- | The range of rows of a band.
bandRange :: Monad m => StoredBand -> Query m (Natural, Natural)
bandRange band =
  except $
    (,)
      <$> natural BandTable (storedBandFromRow band)
      <*> natural BandTable (storedBandToRow band)

-- | The union of ranges as ranges that do not touch each other.
united :: [(Natural, Natural)] -> [(Natural, Natural)]
united = joined . sort
  where
    joined ((from, to) : (from', to') : others)
      | from' <= to = joined ((from, max to to') : others)
      | otherwise = (from, to) : joined ((from', to') : others)
    joined ranges = ranges

-- | The bands that meet a range of rows.
bandsOver :: MonadIO m => (Natural, Natural) -> Query m [StoredBand]
bandsOver range@(from, to) = do
  below <-
    selected BandTable [StoredBandFromRow <. fromIntegral to] [Desc StoredBandFromRow, most from to]
  covering BandTable storedBandFromRow storedBandToRow range below

-- | The runs of a band that meet a range of columns.
runsOver :: MonadIO m => Int64 -> (Natural, Natural) -> Query m [StoredRun]
runsOver band range@(from, to) = do
  before <-
    selected
      RunTable
      [StoredRunBand ==. band, StoredRunFromColumn <. fromIntegral to]
      [Desc StoredRunFromColumn, most from to]
  covering RunTable storedRunFromColumn storedRunToColumn range before

-- Of the parts of a partition that begin before the end of a range, at most the range's length meet
-- it.
most :: Natural -> Natural -> SelectOpt row
most from to = LimitTo (fromIntegral (min (to - from) (fromIntegral (maxBound :: Int))))

-- | The parts of a partition, given last one first, that meet a range. Refuses a gap between parts
-- or at an end of the range.
covering ::
  Monad m =>
  Table ->
  (row -> Int64) ->
  (row -> Int64) ->
  (Natural, Natural) ->
  [row] ->
  Query m [row]
covering table begin end (from, to) = go (fromIntegral to) (>=)
  where
    go at reaches parts = case parts of
      part : others
        | end part `reaches` at && begin part < at ->
          if begin part <= fromIntegral from
            then pure [part]
            else (part :) <$> go (begin part) (==) others
      _ -> throwE (UnreadableRow table)

-- | The place of a laid face's symbols on it.
selectSeat :: MonadIO m => Pitch -> Int64 -> Query m Seat
selectSeat between number = do
  laying <- one LayingTable =<< selected LayingTable [StoredLayingNumber ==. number] []
  let object = storedLayingObject laying
  face <-
    one FaceTable
      =<< selected
        FaceTable
        [StoredFaceObject ==. object, StoredFaceNumber ==. storedLayingFace laying]
        []
  owner <- one ObjectTable =<< selected ObjectTable [StoredObjectNumber ==. object] []
  around <-
    selected
      CornerTable
      [StoredCornerObject ==. object, StoredCornerFace ==. storedLayingFace laying]
      []
  complete CornerTable (storedFaceCorners face) around
  places <-
    selected
      VertexTable
      [StoredVertexObject ==. object, StoredVertexNumber <-. map storedCornerVertex around]
      []
  let byNumber = Map.fromList [(storedVertexNumber vertex, vertex) | vertex <- places]
  walk <- begunIn laying <$> except (walkIn VertexTable byNumber around)
  at <- except (atIn laying)
  grid <- except (gridIn laying)
  let named = Face (objectIn owner) (FaceName (map vertexIn walk))
  maybe
    (throwE (UnreadableRow VertexTable))
    pure
    (seatBy between named (map pointIn walk) at (anchorIn laying) grid)

-- | The position on the array of a cell of a face's block. The arguments are the array's shape,
-- the face, and the cell's row and column in the block. Refuses what
-- 'PraTactile.Object.Placement.arrayPosition' refuses.
selectPosition :: MonadIO m => Shape -> Face -> Position -> Query m Position
selectPosition shape (Face named walk) local = do
  owner <- selectObject named
  let object = storedObjectNumber owner
  own <- selectDescriptions [owner]
  let names = Map.fromList [(storedVertexNumber it, vertexIn it) | it <- vertices own]
      byFace = Map.fromListWith (++) [(storedCornerFace it, [it]) | it <- corners own]
  known <- for (sortOn storedFaceNumber (faces own)) $ \face -> do
    let around = Map.findWithDefault [] (storedFaceNumber face) byFace
    complete CornerTable (storedFaceCorners face) around
    (,) face . FaceName <$> except (walkIn CornerTable names around)
  case ( [it | it@(_, name) <- known, sameFace walk name],
         [name | (_, name) <- known, sameVertices walk name]
       ) of
    ((face, name) : _, _)
      | storedFaceLaid face == 1 -> do
        laying <-
          one LayingTable
            =<< selected
              LayingTable
              [StoredLayingObject ==. object, StoredLayingFace ==. storedFaceNumber face]
              []
        let begun = Face named (FaceName (begunIn laying (faceVertices name)))
        selectCell shape laying begun local
      | otherwise -> refuse (FaceNotLaid (Face named name))
    ([], name : _) -> refuse (WrongVertexOrder (Face named walk) name)
    ([], []) -> refuse (UnknownFace (Face named walk))

selectCell :: MonadIO m => Shape -> StoredLaying -> Face -> Position -> Query m Position
selectCell (Shape high wide) laying face local = do
  at <- except (atIn laying)
  let there@(Position r c) = Position (row at + row local) (column at + column local)
      off = refuse (CellOffFace face local)
  if r >= high || c >= wide
    then off
    else do
      band <- one BandTable =<< bandsOver (r, r + 1)
      run <- one RunTable =<< runsOver (storedBandFromRow band) (c, c + 1)
      if storedRunLaying run == Just (storedLayingNumber laying) then pure there else off

-- | The placement of only the named objects, from the array's shape and pitch. Refuses unknown
-- names.
selectObjects :: MonadIO m => Shape -> Pitch -> [ObjectName] -> Query m Placement
selectObjects shape between names = traverse selectObject names >>= selectOwners shape between

-- | The placement of only the given objects, from the array's shape and pitch.
selectOwners :: MonadIO m => Shape -> Pitch -> [StoredObject] -> Query m Placement
selectOwners shape between owners = do
  described <- selectDescriptions owners
  layings' <- among (map storedObjectNumber owners) LayingTable StoredLayingObject
  complete LayingTable (sum (map storedFaceLaid (faces described))) layings'
  blocks <- for layings' $ \laying -> do
    Position top left <- except (atIn laying)
    Shape high wide <- except (gridIn laying)
    pure ((top, min (rows shape) (top + high)), (left, min (columns shape) (left + wide)))
  parted <- selectOver blocks
  let laid = Set.fromList (map storedLayingNumber layings')
      theirs = maybe False (`Set.member` laid) . storedRunLaying
  snd
    <$> except
      ( placementIn
          shape
          between
          described
            { objects = owners,
              layings = layings',
              runBands = map fst parted,
              runs = concatMap (filter theirs . snd) parted
            }
      )

-- | The placement of only those objects that have cells in a window that contains one of the given
-- cells. The arguments are the array's shape and pitch, the window's shape, and the cells.
selectNear :: MonadIO m => Shape -> Pitch -> Shape -> [Position] -> Query m Placement
selectNear shape between window@(Shape tall broad) cells =
  selectUnder
    shape
    between
    [ widened shape (Shape (tall - 1) (broad - 1)) (cell, Shape 1 1)
      | area window > 0,
        cell <- cells
    ]

-- | The placement of only those objects that have cells within a distance (rows, columns) of the
-- blocks of the first laid faces. The arguments are the array's shape and pitch, the number of laid
-- faces, and the distance. 'Nothing' if there are fewer laid faces or a number is missing; reading
-- the whole store then tells whether rows are missing.
selectFirstLaid :: MonadIO m => Shape -> Pitch -> Int -> Shape -> Query m (Maybe Placement)
selectFirstLaid shape between count reach = do
  found <-
    selected LayingTable [StoredLayingNumber >=. 0] [Asc StoredLayingNumber, LimitTo count]
  if map storedLayingNumber found == take count [1 ..]
    then do
      blocks <- for found $ \laying -> except ((,) <$> atIn laying <*> gridIn laying)
      Just <$> selectUnder shape between (map (widened shape reach) blocks)
    else pure Nothing

-- | A block of the array's cells with a margin of rows and columns added on each side, around the
-- torus.
widened :: Shape -> Shape -> (Position, Shape) -> (Position, Shape)
widened (Shape high wide) (Shape down across) (Position r c, Shape tall broad) =
  (Position (back high down r) (back wide across c), Shape (tall + 2 * down) (broad + 2 * across))
  where
    back size by at = (at + size - by `mod` size) `mod` size

-- | The placement of only those objects that have cells in some blocks of the array. The arguments
-- are the array's shape and pitch, and each block's upper left cell and shape.
selectUnder :: MonadIO m => Shape -> Pitch -> [(Position, Shape)] -> Query m Placement
selectUnder shape between blocks = do
  parted <- selectOver rectangles
  let numbers = distinct [n | (_, crossed) <- parted, Just n <- map storedRunLaying crossed]
  layings' <- among numbers LayingTable StoredLayingNumber
  complete LayingTable (fromIntegral (length numbers)) layings'
  let owners = distinct (map storedLayingObject layings')
  objects' <- among owners ObjectTable StoredObjectNumber
  complete ObjectTable (fromIntegral (length owners)) objects'
  selectOwners shape between objects'
  where
    distinct = Set.toList . Set.fromList
    -- The parts of each block, cut at the ends of the array.
    rectangles = fst (traverse (\(at, block) -> facesUnder visited block at) blocks)
    visited = Mapping shape between (\down across -> ([(down, across)], Map.empty))

-- | The object with a name. Each row holds the next name, so the preceding row proves that a name
-- is missing.
selectObject :: MonadIO m => ObjectName -> Query m StoredObject
selectObject named = do
  sheet <- selectSheet
  upTo <- selected ObjectTable [StoredObjectName <=. text] [Desc StoredObjectName, LimitTo 1]
  let found = listToMaybe upTo
      next = maybe (metadataFirstName sheet) storedObjectNextName found
  case found of
    Just object | storedObjectName object == text -> pure object
    _ | all (> text) next -> refuse (UnknownObject named)
    _ -> throwE (UnreadableRow ObjectTable)
  where
    text = Text.pack (objectText named)

-- | All vertices, faces and corners of the given objects.
selectDescriptions :: MonadIO m => [StoredObject] -> Query m Rows
selectDescriptions owners = do
  vertices' <- among numbers VertexTable StoredVertexObject
  faces' <- among numbers FaceTable StoredFaceObject
  corners' <- among numbers CornerTable StoredCornerObject
  let vertexCount = countedBy storedVertexObject vertices'
      faceCount = countedBy storedFaceObject faces'
      cornerCount = countedBy (\it -> (storedCornerObject it, storedCornerFace it)) corners'
  for_ owners $ \owner -> do
    let number = storedObjectNumber owner
    agree VertexTable (storedObjectVertices owner) (vertexCount number)
    agree FaceTable (storedObjectFaces owner) (faceCount number)
  for_ faces' $ \face ->
    agree
      CornerTable
      (storedFaceCorners face)
      (cornerCount (storedFaceObject face, storedFaceNumber face))
  agree CornerTable (sum (map storedFaceCorners faces')) (fromIntegral (length corners'))
  pure mempty {vertices = vertices', faces = faces', corners = corners'}
  where
    numbers = map storedObjectNumber owners
    countedBy key found =
      let counts = Map.fromListWith (+) [(key row', 1) | row' <- found]
       in \one' -> Map.findWithDefault 0 one' counts
    agree :: Monad m => Table -> Int64 -> Int64 -> Query m ()
    agree table wanted found = unless (wanted == found) (throwE (UnreadableRow table))

-- | The row of the array.
selectSheet :: MonadIO m => Query m Metadata
selectSheet =
  one MetadataTable =<< selected MetadataTable [MetadataSchemaVersion ==. schemaVersion] []

objectIn :: StoredObject -> ObjectName
objectIn = ObjectName . Text.unpack . storedObjectName

vertexIn :: StoredVertex -> VertexName
vertexIn = VertexName . Text.unpack . storedVertexName

-- | All rows of a table that satisfy the filters. Refuses changed rows.
selected ::
  (MonadIO m, PersistEntity row, PersistEntityBackend row ~ SqlBackend) =>
  Table ->
  [Filter row] ->
  [SelectOpt row] ->
  Query m [row]
selected table filters how = do
  found <- lift (selectList filters how)
  except (traverse (intact table . entityVal) found)

-- | All rows of a table with one of the given numbers in a column, by statements of 500 numbers.
among ::
  (MonadIO m, PersistEntity row, PersistEntityBackend row ~ SqlBackend) =>
  [Int64] ->
  Table ->
  EntityField row Int64 ->
  Query m [row]
among numbers table column' = case splitAt 500 numbers of
  ([], _) -> pure []
  (block, others) ->
    (++) <$> selected table [column' <-. block] [] <*> among others table column'

-- | The only row. Refuses any other number of rows.
one :: Monad m => Table -> [row] -> Query m row
one table found = case found of
  [only] -> pure only
  _ -> throwE (UnreadableRow table)

-- | Refuses if the rows are not as many as the given number.
complete :: Monad m => Table -> Int64 -> [row] -> Query m ()
complete table count found =
  unless (toInteger count == toInteger (length found)) (throwE (UnreadableRow table))

refuse :: Monad m => PlacementError -> Query m a
refuse = throwE . NotInStore
