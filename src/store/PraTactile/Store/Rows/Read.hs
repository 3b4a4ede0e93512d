{-# LANGUAGE TypeFamilies #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Converts the rows of the database to a placement, and single rows to values.
module PraTactile.Store.Rows.Read
  ( -- * All rows
    fromRows,
    placementIn,

    -- * Single rows
    intact,
    natural,
    shapeIn,
    pitchIn,
    pointIn,
    walkIn,
    begunIn,
    atIn,
    gridIn,
    anchorIn,
  )
where

import Data.Bifunctor (first)
import Data.Int (Int64)
import Data.List (genericDrop, genericTake, sortOn)
import qualified Data.Map.Strict as Map
import qualified Data.Text as Text
import Data.Traversable (for)
import Database.Persist.Sql (PersistEntity)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (Position), Shape (..))
import PraTactile.Object.Placement
import PraTactile.Object.Placement.Bands
import PraTactile.Object.WingedEdge
import PraTactile.Store.Error
import PraTactile.Store.Exact
import PraTactile.Store.Rows
import PraTactile.Store.Rows.Write
import PraTactile.Store.Schema
import PraTactile.Store.Seal

-- | The placement in the rows of all tables, with the text of its profile and the numbers of its
-- objects and laid faces. Refuses changed rows, rows that do not form solids or a placement, and
-- rows that this placement would not have.
fromRows :: Rows -> Either StoreError (String, Numbers, Placement)
fromRows given = do
  mapM_ sealsHold parts
  sheet <- case metadataRows given of
    [only] -> Right only
    _ -> Left (UnreadableRow MetadataTable)
  shape <- shapeIn sheet
  (numbers, place) <- placementIn shape (pitchIn sheet) given
  let profile = Text.unpack (metadataProfile sheet)
  implied <- toRows profile numbers place
  maybe (pure (profile, numbers, place)) (Left . RowsDisagree) (disagreement given implied)
  where
    sealsHold :: TableRows -> Either StoreError ()
    sealsHold (TableRows table part) = mapM_ (intact table) (part given)

-- | The placement of the objects in the given rows, and their numbers. The arguments are the
-- array's shape, its pitch, and the rows, which must be all of these objects.
placementIn :: Shape -> Pitch -> Rows -> Either StoreError (Numbers, Placement)
placementIn shape between given = do
  described <- descriptionsIn given stored
  solids <- for described $ \it -> first (NotSolid (describedName it)) (solid it)
  let owners = Map.fromList (zip (map storedObjectNumber stored) described)
  places <- for laid $ \it -> (,) <$> atIn it <*> gridIn it
  parted <- bandsIn (Map.fromList (zip (map storedLayingNumber laid) [0 ..])) given
  let blocks = blocksIn parted (Map.fromList (zip [0 ..] places))
  wishes <- for (zip3 [0 ..] laid places) $ \(i, it, (at, _)) -> do
    owner <- find LayingTable owners (storedLayingObject it)
    walk <- find LayingTable (numberedFrom0 (describedFaces owner)) (storedLayingFace it)
    block <- find LayingTable blocks i >>= maybe (Left (RowsDisagree RunTable)) Right
    let face = Face (describedName owner) (FaceName (begunIn it (faceVertices walk)))
    pure (Laying face at (anchorIn it) block)
  place <- first NotPlaced (placement shape between solids wishes)
  let numbers =
        Numbers
          { objectNumbers =
              Map.fromList (zip (map describedName described) (map storedObjectNumber stored)),
            layingNumbers = Map.fromList (zip (map layFace wishes) (map storedLayingNumber laid))
          }
  pure (numbers, place)
  where
    stored = sortOn storedObjectNumber (objects given)
    laid = sortOn storedLayingNumber (layings given)

-- | The descriptions of the given objects.
descriptionsIn :: Rows -> [StoredObject] -> Either StoreError [Description]
descriptionsIn given stored = for stored $ \it -> do
  let own = storedObjectNumber it
      named =
        [ (VertexName (Text.unpack (storedVertexName vertex)), pointIn vertex)
          | vertex <- sortOn storedVertexNumber (of' own vertexRows)
        ]
      names = numberedFrom0 (map fst named)
  walks <- for (sortOn storedFaceNumber (of' own faceRows)) $ \face ->
    walkIn CornerTable names (of' (own, storedFaceNumber face) cornerRows)
  pure (Description (ObjectName (Text.unpack (storedObjectName it))) named (map FaceName walks))
  where
    vertexRows = grouped storedVertexObject (vertices given)
    faceRows = grouped storedFaceObject (faces given)
    cornerRows = grouped (\row -> (storedCornerObject row, storedCornerFace row)) (corners given)
    of' :: Ord k => k -> Map.Map k [row] -> [row]
    of' = Map.findWithDefault []
    grouped :: Ord k => (row -> k) -> [row] -> Map.Map k [row]
    grouped key rows' = Map.fromListWith (++) [(key row, [row]) | row <- rows']

-- | The bands. The map gives the index of a laying, by its number, in the placement's order.
bandsIn :: Map.Map Int64 Int -> Rows -> Either StoreError [Band]
bandsIn places given = for (runBands given) $ \it ->
  Band
    <$> natural BandTable (storedBandFromRow it)
    <*> natural BandTable (storedBandToRow it)
    <*> traverse stretch (Map.findWithDefault [] (storedBandFromRow it) ofBand)
  where
    ofBand = Map.fromListWith (++) [(storedRunBand run, [run]) | run <- reverse (runs given)]
    stretch run =
      BandRun
        <$> natural RunTable (storedRunFromColumn run)
        <*> natural RunTable (storedRunToColumn run)
        <*> traverse (find RunTable places) (storedRunLaying run)

find :: Ord key => Table -> Map.Map key it -> key -> Either StoreError it
find table known key = maybe (Left (UnreadableRow table)) Right (Map.lookup key known)

numberedFrom0 :: [it] -> Map.Map Int64 it
numberedFrom0 = Map.fromDistinctAscList . zip [0 ..]

-- | A row whose seal is correct. Refuses any other row.
intact :: PersistEntity row => Table -> row -> Either StoreError row
intact table row = if isSealed row then Right row else Left (ChangedRow table)

-- | A natural number. Refuses negative numbers.
natural :: Table -> Int64 -> Either StoreError Natural
natural table n = if n < 0 then Left (UnreadableRow table) else Right (fromIntegral n)

-- | The shape of the array.
shapeIn :: Metadata -> Either StoreError Shape
shapeIn sheet =
  Shape
    <$> natural MetadataTable (metadataArrayRows sheet)
    <*> natural MetadataTable (metadataArrayColumns sheet)

-- | The distances between symbols.
pitchIn :: Metadata -> Pitch
pitchIn sheet = Pitch (exactly (metadataPitchRight sheet)) (exactly (metadataPitchDown sheet))

-- | The coordinates of a vertex.
pointIn :: StoredVertex -> Point
pointIn it =
  Point (exactly (storedVertexX it)) (exactly (storedVertexY it)) (exactly (storedVertexZ it))

-- | The values at the corners of a face, in the order of its walk, by the numbers of its vertices.
-- Refuses a corner without a value, with the given table.
walkIn :: Table -> Map.Map Int64 it -> [StoredCorner] -> Either StoreError [it]
walkIn table known = traverse (find table known . storedCornerVertex) . sortOn storedCornerNumber

-- | A list around a face, such as its walk, rotated to begin where the laid face's frame begins.
begunIn :: StoredLaying -> [corner] -> [corner]
begunIn it walk = genericDrop begun walk ++ genericTake begun walk
  where
    begun = storedLayingBeginsAt it

-- | The position of a laid face's block on the array.
atIn :: StoredLaying -> Either StoreError Position
atIn it =
  Position
    <$> natural LayingTable (storedLayingAtRow it)
    <*> natural LayingTable (storedLayingAtColumn it)

-- | The shape of a laid face's block.
gridIn :: StoredLaying -> Either StoreError Shape
gridIn it =
  Shape
    <$> natural LayingTable (storedLayingGridRows it)
    <*> natural LayingTable (storedLayingGridColumns it)

-- | The position of a laid face's block on the face.
anchorIn :: StoredLaying -> Anchor
anchorIn it = case (storedLayingMarginRight it, storedLayingMarginDown it) of
  (Just x, Just y) -> Margin (exactly x) (exactly y)
  _
    | drawn == grid && from == (0, 0) -> Centred
    | otherwise -> CentredPart drawn from
  where
    drawn = (big storedLayingDrawnRows, big storedLayingDrawnColumns)
    grid = (big storedLayingGridRows, big storedLayingGridColumns)
    from = (big storedLayingDrawnFromRow, big storedLayingDrawnFromColumn)
    big part = toInteger (part it)
