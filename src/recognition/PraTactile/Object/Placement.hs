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

import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), naturalsBelow)
import PraTactile.Object.Placement.Laying
import PraTactile.Object.Surd (ahead, beyond, squareOf)
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
-- in proportion to the window's cells at most, and to the logarithm of the number of laid faces.
whereabouts :: Placement -> Shape -> Position -> Whereabouts
whereabouts place window at
  | rows window == 0 || columns window == 0 = OnNoObject
  | otherwise = case Map.elems touched of
    [laid]
      | Just cell <- cellOf laid, wholly laid cell -> OnFace (placeOn place laid window cell)
      | otherwise -> OnNoObject
    [] -> OnNoObject
    several -> Straddles (map laidFace several)
  where
    Shape high wide = placementShape place
    touched =
      Map.fromList
        [ (runNumber run, runFace run)
          | r <- roundFrom high (row at) (rows window),
            part <- partsFrom wide (column at) (columns window),
            run <- runsBetween place r part
        ]
    -- Of the window's upper left cell, the cell of the block; faces lie on the sheet, and so does a
    -- window all of whose cells one has.
    cellOf laid
      | r < row corner' || c < column corner' = Nothing
      | otherwise = Just (Position (r - row corner') (c - column corner'))
      where
        corner' = laidAt laid
        (r, c) = (row at `mod` high, column at `mod` wide)
    wholly laid (Position i j) =
      and
        [ hasCell (laidBlock laid) (Position (i + di) (j + dj))
          | di <- naturalsBelow (rows window),
            dj <- naturalsBelow (columns window)
        ]

-- | So many numbers from one on, round a circle of this size, each once.
roundFrom :: Natural -> Natural -> Natural -> [Natural]
roundFrom size from count =
  concat [takeWhile (< end) [begin ..] | (begin, end) <- partsFrom size from count]

-- | The same as parts of the circle cut at 0: from the first number to before the second.
partsFrom :: Natural -> Natural -> Natural -> [(Natural, Natural)]
partsFrom size from count
  | count >= size = [(0, size)]
  | end <= size = [(begin, end)]
  | otherwise = [(begin, size), (0, end - size)]
  where
    begin = from `mod` size
    end = begin + count

placeOn :: Placement -> LaidFace -> Shape -> Position -> Place
placeOn place laid window cell =
  Place
    { placeFace = laidFace laid,
      placeCell = cell,
      placeCentre = centre,
      placeCorners = [vertex | (vertex, far) <- distances, far == minimum (map snd distances)]
    }
  where
    centre = windowCentre place laid window cell
    distances = [(vertex, distance spot) | (vertex, spot) <- laidCorners laid]
    distance (Spot right down) =
      squareOf (beyond right (spotRight centre)) (beyond down (spotDown centre))

-- | Where on the array a cell of a face's block lies, the cell given by its row and column within
-- the block; the inverse of 'whereabouts' for windows of one cell. Refuses a face that is not laid
-- and a cell that it does not have.
arrayPosition :: Placement -> Face -> Position -> Either PlacementError Position
arrayPosition place face cell = do
  laid <- findFace place (faceObject face) (faceName face)
  if hasCell (laidBlock laid) cell
    then Right (Position (row (laidAt laid) + row cell) (column (laidAt laid) + column cell))
    else Left (CellOffFace (laidFace laid) cell)

-- | The object of this name; refuses one that the placement has not got.
findObject :: Placement -> ObjectName -> Either PlacementError Solid
findObject place named = maybe (Left (UnknownObject named)) Right (placementObject place named)

-- | The laid face that a walk round its vertices names, wherever the walk starts; refuses objects
-- and faces that there are not, faces named in another order than counter-clockwise seen from
-- outside, and faces that are not laid.
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

-- | The centre of a window on a laid face, the window given by its shape and by its upper left cell
-- within the face's block.
windowCentre :: Placement -> LaidFace -> Shape -> Position -> Spot
windowCentre place laid window cell =
  Spot
    (middle spotRight pitchRight column columns)
    (middle spotDown pitchDown row rows)
  where
    middle margin along from size =
      ahead
        (along (placementPitch place) * (fromIntegral (from cell) + fromIntegral (size window) / 2))
        (margin (laidMargin laid))

-- | The centre of a symbol on a laid face, the symbol given by its row and column within the face's
-- block.
cellCentre :: Placement -> LaidFace -> Position -> Spot
cellCentre place laid = windowCentre place laid (Shape 1 1)
