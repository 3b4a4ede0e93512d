-- | The two look-ups between the array and the objects: from a window's position to the object, the
-- face and the place on the face, and back (the last step of the paper's method, sections II.B and
-- IV). Of the code they see positions and shapes only.
module PraTactile.Object.Placement
  ( -- * Laying faces on the array
    module PraTactile.Object.Placement.Laying,

    -- * From the array to the objects
    Whereabouts (..),
    Place (..),
    corner,
    whereabouts,

    -- * From the objects to the array
    arrayPosition,
    findObject,
    findFace,

    -- * Spots
    windowCentre,
    cellCentre,
  )
where

import Data.Foldable (find)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Placement.Laying
import PraTactile.Object.WingedEdge

-- | Where a window of the array is.
data Whereabouts
  = -- | all its cells lie on one face, side by side as in the window
    OnFace Place
  | -- | its cells lie on two or more faces, in the placement's order, so it is on no object
    Straddles [Face]
  | -- | it lies on no face, or on one face in part, the rest on none
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
    -- | all the face's vertices nearest to the centre, in the order of the face's name; never empty
    placeCorners :: [VertexName]
  }
  deriving stock (Eq, Show)

-- | The nearest vertex, if there is only one.
corner :: Place -> Maybe VertexName
corner place = case placeCorners place of
  [only] -> Just only
  _ -> Nothing

-- | Where the window of the given shape (rows and columns of cells) with its upper left cell at the
-- given position is. The array is a torus: the window goes on at the first row after the last, and
-- likewise with columns; so does the position. A window without cells is on no object. Takes time
-- in proportion to the number of laid faces, whatever the shapes.
whereabouts :: Placement -> Shape -> Position -> Whereabouts
whereabouts place window at
  | rows window == 0 || columns window == 0 = OnNoObject
  | otherwise = case (whole, touched) of
    ((laid, cell) : _, _) -> OnFace (placeOn place laid window cell)
    ([], _ : _ : _) -> Straddles (map laidFace touched)
    _ -> OnNoObject
  where
    shape = placementShape place
    whole = [(laid, cell) | laid <- laidFaces place, Just cell <- [cellIn laid]]
    touched = filter touches (laidFaces place)
    cellIn laid = Position <$> inside row rows laid <*> inside column columns laid
    inside from size laid =
      let offset = ahead (size shape) (from (laidAt laid)) (from at)
       in if offset + size window <= size (laidGrid laid) then Just offset else Nothing
    touches laid = meets row rows laid && meets column columns laid
    meets from size laid =
      let offset = ahead (size shape) (from at) (from (laidAt laid))
       in offset < size window || offset + size (laidGrid laid) > size shape

-- How far one comes to @to@ going on from @from@ round a circle of the given size.
ahead :: Natural -> Natural -> Natural -> Natural
ahead size from to = fromInteger ((toInteger to - toInteger from) `mod` toInteger size)

placeOn :: Placement -> LaidFace -> Shape -> Position -> Place
placeOn place laid window cell =
  Place
    { placeFace = laidFace laid,
      placeCell = cell,
      placeCentre = centre,
      placeCorners =
        [vertex | (vertex, spot) <- spots, distance spot == minimum (map (distance . snd) spots)]
    }
  where
    centre = windowCentre place laid window cell
    spots = faceSpots laid
    distance (Spot right down) =
      (right - spotRight centre) ^ (2 :: Int) + (down - spotDown centre) ^ (2 :: Int)

-- | Where on the array a cell of a face's block lies, the cell given by its row and column within
-- the block; the inverse of 'whereabouts' for windows of one cell. Refuses a face that is not laid
-- and a cell outside its block.
arrayPosition :: Placement -> Face -> Position -> Either PlacementError Position
arrayPosition place face cell = do
  laid <- findFace place (faceObject face) (faceName face)
  if row cell < rows (laidGrid laid) && column cell < columns (laidGrid laid)
    then Right (Position (row (laidAt laid) + row cell) (column (laidAt laid) + column cell))
    else Left (CellOffFace (laidFace laid) cell)

-- | The object of this name; refuses one that the placement has not got.
findObject :: Placement -> ObjectName -> Either PlacementError Solid
findObject place named =
  maybe (Left (UnknownObject named)) Right (find ((== named) . solidName) (placementSolids place))

-- | The laid face that a walk round its vertices names, wherever the walk starts; refuses objects
-- and faces that there are not, faces named in another order than counter-clockwise seen from
-- outside, and faces that are not laid.
findFace :: Placement -> ObjectName -> FaceName -> Either PlacementError LaidFace
findFace place named walk = do
  object <- findObject place named
  known <- case ( find (sameFace walk) (solidFaces object),
                  find (sameVertices walk) (solidFaces object)
                ) of
    (Just face, _) -> Right (Face named face)
    (Nothing, Just face) -> Left (WrongVertexOrder (Face named walk) face)
    (Nothing, Nothing) -> Left (UnknownFace (Face named walk))
  maybe (Left (FaceNotLaid known)) Right (find ((== known) . laidFace) (laidFaces place))

-- | The centre of a window on a laid face, the window given by its shape and by its upper left cell
-- within the face's block.
windowCentre :: Placement -> LaidFace -> Shape -> Position -> Spot
windowCentre place laid window cell =
  Spot
    (middle spotRight pitchRight column columns)
    (middle spotDown pitchDown row rows)
  where
    middle margin between from size =
      margin (laidMargin laid)
        + between (placementPitch place)
          * (fromIntegral (from cell) + fromIntegral (size window) / 2)

-- | The centre of a symbol on a laid face, the symbol given by its row and column within the face's
-- block.
cellCentre :: Placement -> LaidFace -> Position -> Spot
cellCentre place laid = windowCentre place laid (Shape 1 1)
