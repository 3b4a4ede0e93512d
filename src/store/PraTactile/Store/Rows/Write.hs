{-# OPTIONS_HADDOCK hide #-}

-- | Converts a placement to the rows of the database.
module PraTactile.Store.Rows.Write
  ( Numbers (..),
    firstNumbers,
    nextNumbers,
    toRows,
    whole,
  )
where

import Data.Int (Int64)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import qualified Data.Text as Text
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Description (rotations)
import PraTactile.Object.Placement
import PraTactile.Object.Placement.Bands
import PraTactile.Object.WingedEdge
import PraTactile.Store.Error
import PraTactile.Store.Exact
import PraTactile.Store.Rows
import PraTactile.Store.Schema
import PraTactile.Store.Seal

-- | The numbers of objects and laid faces in a store, ascending in the order of the placement.
data Numbers = Numbers
  { objectNumbers :: Map.Map ObjectName Int64,
    layingNumbers :: Map.Map Face Int64
  }

-- | The numbers of a newly stored placement, from 1.
firstNumbers :: Placement -> Numbers
firstNumbers place =
  Numbers
    (Map.fromList (zip (map solidName (placementSolids place)) [1 ..]))
    (Map.fromList (zip (map laidFace (laidFaces place)) [1 ..]))

-- | The numbers of a placement that replaces another. The arguments are the old placement, its
-- numbers, and the new one. What stays the same (a face: with its object) keeps its number if the
-- numbers still ascend in the new order; the rest gets the next numbers above all earlier ones.
nextNumbers :: Placement -> Numbers -> Placement -> Numbers
nextNumbers before (Numbers ofObjects ofLayings) place =
  Numbers
    (renumbered ofObjects [(name, stays it) | it <- placementSolids place, let name = solidName it])
    (renumbered ofLayings [(laidFace it, lies it) | it <- laidFaces place])
  where
    stays it = placementObject before (solidName it) == Just it
    lies it =
      placementLaid before (laidFace it) == Just it
        && (stays <$> placementObject place (faceObject (laidFace it))) == Just True

-- | Ascending numbers. An item with the flag keeps its known number if that is possible.
renumbered :: Ord k => Map.Map k Int64 -> [(k, Bool)] -> Map.Map k Int64
renumbered known = go 0 (maximum (0 : Map.elems known))
  where
    go _ _ [] = Map.empty
    go last' most ((one, keeps) : others) = case Map.lookup one known of
      Just n | keeps && n > last' -> Map.insert one n (go n most others)
      _ -> Map.insert one (most + 1) (go (most + 1) (most + 1) others)

-- | The rows of a placement with the given numbers and the text of its profile. Refuses numbers
-- that the columns cannot hold.
toRows :: String -> Numbers -> Placement -> Either StoreError Rows
toRows profile numbers place =
  mconcat
    <$> sequence
      ( arrayRow profile (Set.lookupMin known) place :
        zipWith (objectRows numbers laidOf) (placementSolids place) nextNames
          ++ map (bandRows numberAt) (bands place)
      )
  where
    names = map (objectText . solidName) (placementSolids place)
    known = Set.fromList names
    nextNames = map (`Set.lookupGT` known) names
    laidOf =
      Map.fromListWith (flip (++)) [(faceObject (laidFace laid), [laid]) | laid <- laidFaces place]
    numberAt =
      Map.fromList
        [ (at, n)
          | (at, laid) <- zip [0 ..] (laidFaces place),
            Just n <- [Map.lookup (laidFace laid) (layingNumbers numbers)]
        ]

-- | The row of the array, with the least of the objects' names.
arrayRow :: String -> Maybe String -> Placement -> Either StoreError Rows
arrayRow profile firstName place = do
  row' <-
    Metadata schemaVersion (Text.pack profile)
      <$> whole (rows (placementShape place))
      <*> whole (columns (placementShape place))
  pure mempty {metadataRows = [sealed (row' (Exact right) (Exact down) (Text.pack <$> firstName))]}
  where
    Pitch right down = placementPitch place

-- | All rows of an object. The arguments are the numbers, the laid faces of each object, the
-- object, and the next name in the order of names.
objectRows ::
  Numbers -> Map.Map ObjectName [LaidFace] -> Solid -> Maybe String -> Either StoreError Rows
objectRows numbers laidOf object nextName = do
  laid <- traverse layingRow (Map.findWithDefault [] (solidName object) laidOf)
  let laidFace' = Set.fromList (map storedLayingFace laid)
  pure
    mempty
      { objects =
          [ sealed $
              StoredObject
                own
                (Text.pack (objectText (solidName object)))
                (Text.pack <$> nextName)
                (count named)
                (count walks)
                (count sides)
          ],
        vertices =
          [ sealed (StoredVertex own i (Text.pack (vertexText name)) (Exact x) (Exact y) (Exact z))
            | (i, (name, Point x y z)) <- zip [0 ..] named
          ],
        faces =
          [ sealed $
              StoredFace
                own
                f
                (Text.pack (faceText walk))
                (count (faceVertices walk))
                (if f `Set.member` laidFace' then 1 else 0)
            | (f, walk) <- zip [0 ..] walks
          ],
        corners =
          [ sealed (StoredCorner own f i (vertexOf name))
            | (f, walk) <- zip [0 ..] walks,
              (i, name) <- zip [0 ..] (faceVertices walk)
          ],
        edges =
          [ sealed (StoredEdge own i (vertexOf from) (vertexOf to) (faceOf left) (faceOf right))
            | (i, Edge from to left right _) <- zip [0 ..] sides
          ],
        layings = laid
      }
  where
    own = objectNumbers numbers `numbering` solidName object
    named = solidVertices object
    walks = solidFaces object
    sides = solidEdges object
    vertexOf = numbering (Map.fromList (zip (map fst named) [0 ..]))
    faceOf = numbering (Map.fromList (zip walks [0 ..]))
    count :: [a] -> Int64
    count = fromIntegral . length
    layingRow laid = do
      unsealed <-
        StoredLaying (layingNumbers numbers `numbering` laidFace laid) own (faceOf walk) begins
          <$> whole (row (laidAt laid))
          <*> whole (column (laidAt laid))
          <*> whole (rows grid)
          <*> whole (columns grid)
          <*> whole drawnHigh
          <*> whole drawnWide
          <*> whole fromRow
          <*> whole fromColumn
      pure (sealed (unsealed (Exact . fst <$> margin) (Exact . snd <$> margin)))
      where
        -- The object's own name of the face, and the number of corners by which the laid face's
        -- name is rotated against it.
        begun = faceVertices (faceName (laidFace laid))
        walk = fromMaybe (FaceName []) (sameCorners object (FaceName begun))
        begins = count (takeWhile (/= begun) (rotations (faceVertices walk)))
        grid = laidGrid laid
        size = (toInteger (rows grid), toInteger (columns grid))
        ((drawnHigh, drawnWide), (fromRow, fromColumn), margin) = case laidAnchor laid of
          Centred -> (size, (0, 0), Nothing)
          CentredPart drawn from -> (drawn, from, Nothing)
          Margin x y -> (size, (0, 0), Just (x, y))

-- | The number of an item. Everything named has one; -1 would refer to no row, and the database
-- would refuse it.
numbering :: Ord k => Map.Map k Int64 -> k -> Int64
numbering = flip (Map.findWithDefault (-1))

-- | A band and its runs. The map gives the number of a laying by its index in the placement's
-- order.
bandRows :: Map.Map Int Int64 -> Band -> Either StoreError Rows
bandRows numberAt (Band from to stretches) = do
  from' <- whole from
  to' <- whole to
  runs' <- traverse (runOf from') stretches
  pure mempty {runBands = [sealed (StoredBand from' to')], runs = runs'}
  where
    runOf band (BandRun left right laying) = do
      left' <- whole left
      right' <- whole right
      pure (sealed (StoredRun band left' right' (laying >>= (`Map.lookup` numberAt))))

-- | A number that a column can hold. Refuses larger ones.
whole :: Integral n => n -> Either StoreError Int64
whole n
  | toInteger n <= toInteger (maxBound :: Int64) = Right (fromIntegral n)
  | otherwise = Left (TooLarge (toInteger n))
