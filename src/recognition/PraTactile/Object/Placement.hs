-- | The look-ups between the array and the objects: from a window's position to object, face and
-- place on the face, and back (the last step of the paper's method, sections II.B and IV). They use
-- only positions and shapes, not the array's symbols.
module PraTactile.Object.Placement
  ( -- * Laying faces on the array
    module PraTactile.Object.Placement.Laying,

    -- * From the array to the objects
    Whereabouts (..),
    Place (..),
    corner,
    whereabouts,
    placeFrom,
    Mapping (..),
    inCommon,
    more,
    whereaboutsIn,
    facesUnder,

    -- * From the objects to the array
    arrayPosition,
    findObject,
    findFace,

    -- * Spots
    windowCentre,
    cellCentre,
  )
where

import Data.Functor.Identity (Identity (..))
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), area)
import PraTactile.Object.Number
import PraTactile.Object.Placement.Laying
import PraTactile.Object.Radicals (fraction)
import PraTactile.Object.WingedEdge

-- | Where a window of the array is.
data Whereabouts
  = -- | all its cells lie on one face, side by side as in the window
    OnFace Place
  | -- | its cells lie on two or more faces, listed in the placement's order
    Straddles [Face]
  | -- | no cell lies on a face, or some cells lie on one face and the others on none
    OnNoObject
  deriving stock (Eq, Show)

-- | A place on a face.
data Place = Place
  { -- | the object and the face
    placeFace :: Face,
    -- | row and column, within the face's block of cells, of the window's upper left cell
    placeCell :: Position,
    -- | the window's centre
    placeCentre :: Spot,
    -- | the vertices of the face that are nearest to the centre, in the order of the face's name;
    -- never empty
    placeCorners :: [VertexName]
  }
  deriving stock (Eq, Show)

-- | The nearest vertex; 'Nothing' if several are equally near.
corner :: Place -> Maybe VertexName
corner place = case placeCorners place of
  [only] -> Just only
  _ -> Nothing

-- | Finds what a window of the given shape lies on, with its upper left cell at the given position.
-- The array is a torus: rows and columns of windows and positions wrap around. A window without
-- cells is on no object. The time is proportional to the window's cells at most, and to the
-- logarithm of the number of laid faces.
whereabouts :: Placement -> Shape -> Position -> Whereabouts
whereabouts place window = runIdentity . whereaboutsIn (mappingOf place) window

-- | The place of a window that begins on a laid face, given its shape and its position in the
-- array. The window may reach over the face's edge; its centre is in the face's plane. 'Nothing' if
-- its upper left cell is not within the face's block.
placeFrom :: Placement -> LaidFace -> Shape -> Position -> Maybe Place
placeFrom place laid window at
  | within row rows && within column columns = Just (placeOn pitch window at seat)
  | otherwise = Nothing
  where
    pitch = placementPitch place
    seat = seatOf laid
    within along size =
      along at >= along (laidAt laid) && along at < along (laidAt laid) + size (laidGrid laid)

-- | A mapping of faces to the array, in memory or in a database.
data Mapping m = Mapping
  { -- | the rows and columns of the array
    mappingShape :: Shape,
    -- | the distances between symbols, in millimetres
    mappingPitch :: Pitch,
    -- | the faces with cells in a rectangle of the array, keyed by their index in the order of
    -- layings: the number of cells, and the seat. Rows and columns are ranges whose end is
    -- exclusive.
    mappingCells :: (Natural, Natural) -> (Natural, Natural) -> m (Map.Map Int (Natural, m Seat))
  }

-- | A placement as a mapping in memory.
mappingOf :: Placement -> Mapping Identity
mappingOf place =
  Mapping
    { mappingShape = placementShape place,
      mappingPitch = placementPitch place,
      mappingCells = \(top, bottom) across ->
        Identity $
          Map.fromListWith
            more
            [ (runNumber run, (inCommon across (runFrom run, runTo run), seat))
              | r <- takeWhile (< bottom) [top ..],
                run <- runsBetween place r across,
                let seat = Identity (seatOf (runFace run))
            ]
    }

-- | Adds up the cells of one face.
more :: (Natural, seat) -> (Natural, seat) -> (Natural, seat)
more (cells, seat) (others, _) = (cells + others, seat)

-- | The length of the overlap of two overlapping ranges, whose ends are exclusive.
inCommon :: (Natural, Natural) -> (Natural, Natural) -> Natural
inCommon (from, to) (from', to') = min to to' - max from from'

-- | 'whereabouts' for any mapping. A face does not wrap around the torus. So a window is on a face
-- if it does not wrap around and all its cells are the face's.
whereaboutsIn :: Monad m => Mapping m -> Shape -> Position -> m Whereabouts
whereaboutsIn mapping window at
  | rows window == 0 || columns window == 0 = pure OnNoObject
  | otherwise = do
    touched <- facesUnder mapping window at
    case Map.toAscList touched of
      [] -> pure OnNoObject
      [(_, (cells, seat))]
        | cells == area window && r + rows window <= high && c + columns window <= wide ->
          OnFace . placeOn (mappingPitch mapping) window (Position r c) <$> seat
        | otherwise -> pure OnNoObject
      several -> Straddles <$> traverse (fmap seatFace . snd . snd) several
  where
    Shape high wide = mappingShape mapping
    (r, c) = (row at `mod` high, column at `mod` wide)

-- | The faces with cells in a window, keyed by their index in the order of layings: the number of
-- cells, and the seat.
facesUnder :: Monad m => Mapping m -> Shape -> Position -> m (Map.Map Int (Natural, m Seat))
facesUnder mapping window at =
  Map.unionsWith more
    <$> sequence
      [ mappingCells mapping down across
        | down <- partsFrom high (row at) (rows window),
          across <- partsFrom wide (column at) (columns window)
      ]
  where
    Shape high wide = mappingShape mapping

-- | The ranges, with exclusive ends, of count consecutive numbers on a circle of the given size,
-- cut at 0. Arguments: the size, the first number, the count.
partsFrom :: Natural -> Natural -> Natural -> [(Natural, Natural)]
partsFrom size from count
  | count >= size = [(0, size)]
  | end <= size = [(begin, end)]
  | otherwise = [(begin, size), (0, end - size)]
  where
    begin = from `mod` size
    end = begin + count

-- | The place of a window on a face, given its upper left cell in the array.
placeOn :: Pitch -> Shape -> Position -> Seat -> Place
placeOn between window (Position r c) seat =
  Place
    { placeFace = seatFace seat,
      placeCell = cell,
      placeCentre = centre,
      placeCorners = [vertex | (vertex, far) <- distances, far == minimum (map snd distances)]
    }
  where
    cell = Position (r - row (seatAt seat)) (c - column (seatAt seat))
    centre = centreBy between (seatMargin seat) window cell
    distances = [(vertex, distance spot) | (vertex, spot) <- seatCorners seat]
    distance (Spot right down) =
      squared (right `minus` spotRight centre) `plus` squared (down `minus` spotDown centre)
    squared way = way `product'` way

-- | The position in the array of a cell of a face's block. It is the inverse of 'whereabouts' for
-- windows of one cell. Refuses a face that is not laid and a cell that the face does not have.
arrayPosition :: Placement -> Face -> Position -> Either PlacementError Position
arrayPosition place face cell = do
  laid <- findFace place (faceObject face) (faceName face)
  if hasCell (laidBlock laid) cell
    then Right (Position (row (laidAt laid) + row cell) (column (laidAt laid) + column cell))
    else Left (CellOffFace (laidFace laid) cell)

-- | The object with this name. Refuses a name that the placement does not have.
findObject :: Placement -> ObjectName -> Either PlacementError Solid
findObject place named = maybe (Left (UnknownObject named)) Right (placementObject place named)

-- | The laid face whose vertices are these in cyclic order, beginning at any of them. Refuses
-- unknown objects and faces, vertices in another order than counter-clockwise as seen from outside,
-- and faces that are not laid.
findFace :: Placement -> ObjectName -> FaceName -> Either PlacementError LaidFace
findFace place named walk = do
  object <- findObject place named
  case (placementLaid place asked, walkNamed object walk, sameCorners object walk) of
    (Just laid, _, _) -> Right laid
    (Nothing, Just _, Just known) -> Left (FaceNotLaid (Face named known))
    (Nothing, Nothing, Just known) -> Left (WrongVertexOrder asked known)
    _ -> Left (UnknownFace asked)
  where
    asked = Face named walk

-- | The centre of a window on a laid face, given the window's shape and its upper left cell within
-- the face's block.
windowCentre :: Placement -> LaidFace -> Shape -> Position -> Spot
windowCentre place = centreBy (placementPitch place) . laidMargin

centreBy :: Pitch -> Spot -> Shape -> Position -> Spot
centreBy between margin window cell =
  Spot
    (middle spotRight pitchRight column columns)
    (middle spotDown pitchDown row rows)
  where
    middle side along from size =
      fraction (along between * (fromIntegral (from cell) + fromIntegral (size window) / 2))
        `plus` side margin

-- | The centre of the symbol in a cell of a laid face's block.
cellCentre :: Placement -> LaidFace -> Position -> Spot
cellCentre place laid = windowCentre place laid (Shape 1 1)
