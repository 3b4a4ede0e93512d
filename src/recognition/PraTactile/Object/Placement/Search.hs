{-# OPTIONS_HADDOCK hide #-}

-- | Searches for a way to lay faces on the array. A face takes all cells of its grid. It may begin
-- at any of its vertices, since another first vertex means another frame and another grid.
--
-- To the packing search, the wanted faces are pieces, whose alternatives are the cells of their
-- grids. Cells of faces that are already laid are taken. "PraTactile.Object.Packing" has the
-- mathematics.
module PraTactile.Object.Placement.Search
  ( Wanted (..),
    Begun (..),
    facesOf,
    Found (..),
    layingsOf,
    cellsNeeded,
    mostSymbols,

    -- * Changing a placement
    NotChanged (..),
    adding,
    removing,
  )
where

import Control.Monad (when)
import Data.Bifunctor (first)
import Data.Containers.ListUtils (nubOrdOn)
import Data.Foldable (toList)
import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import qualified Data.Vector.Unboxed as U
import PraTactile.Array (Position (..), Shape (..), area)
import PraTactile.Object.Cells
import PraTactile.Object.Mesh (vertexAt)
import PraTactile.Object.Packing hiding (laidAt)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge

-- | A face that is to be laid.
data Wanted = Wanted
  { wantedFace :: Face,
    wantedBegun :: Begun
  }
  deriving stock (Eq, Show)

-- | The vertex at which a face's frame may begin.
data Begun
  = -- | the first vertex of its name
    AsNamed
  | -- | any vertex
    AnyVertex
  | -- | any vertex that gives the face the most symbols
    BestVertex
  deriving stock (Eq, Show)

-- | The result of a search.
data Found
  = -- | all faces are laid, in the order of the requests
    LaidSo [Laying]
  | -- | it is proved that there is no way. In the reason, pieces are requests, and what is taken
    -- are the faces laid before.
    NoWay Reason
  | -- | no way was found, but it is not proved that there is none
    NoneFound
  deriving stock (Eq, Show)

-- | All faces of solids that have at least one cell at this pitch, with this choice of vertex.
facesOf :: Pitch -> Begun -> [Solid] -> [Wanted]
facesOf between begun objects =
  [ wanted
    | object <- objects,
      face <- solidFaces object,
      let wanted = Wanted (Face (solidName object) face) begun,
      not (null (grids between object wanted))
  ]

-- | Why a placement cannot be changed.
data NotChanged
  = -- | an object with this name exists already, or does not exist
    NotChanged PlacementError
  | -- | no face of these objects has room for a symbol at this pitch
    NothingCarries Pitch [Solid]
  | -- | these faces were not laid, with the reason if it is proved that there is no way
    NotLaid [Wanted] (Maybe Reason)
  deriving stock (Eq, Show)

-- | Adds objects to a placement and lays all their faces that have a cell beside those already
-- laid. The number is the seed of the search.
adding :: Int -> [Solid] -> Placement -> Either NotChanged Placement
adding seed new place = do
  _ <- laid lying
  when (null wishes && not (null new)) (Left (NothingCarries between new))
  case layingsOf seed shape between (laidFaces place) known wishes of
    LaidSo layings -> laid (lying ++ layings)
    NoWay why -> Left (NotLaid wishes (Just why))
    NoneFound -> Left (NotLaid wishes Nothing)
  where
    shape = placementShape place
    between = placementPitch place
    known = placementSolids place ++ new
    lying = map layingOf (laidFaces place)
    wishes = facesOf between AnyVertex new
    laid = first NotChanged . placement shape between known

-- | Removes the objects with these names from a placement.
removing :: [ObjectName] -> Placement -> Either NotChanged Placement
removing names place = do
  mapM_ (first NotChanged . findObject place) names
  first NotChanged $
    placement
      (placementShape place)
      (placementPitch place)
      (filter ((`notElem` names) . solidName) (placementSolids place))
      [layingOf laid | laid <- laidFaces place, faceObject (laidFace laid) `notElem` names]

-- | A lower bound on the number of cells that requests take, whatever their frames.
cellsNeeded :: Pitch -> [Solid] -> [Wanted] -> Integer
cellsNeeded between objects = sum . map leastCells . gridsOf between objects

-- | The most symbols that a face can have, over all vertices at which it may begin, and its name
-- from that vertex. 'Nothing' if that would take long to compute.
mostSymbols :: Pitch -> Solid -> FaceName -> Maybe (Integer, FaceName)
mostSymbols (Pitch right down) object name = do
  best <- bestGrid (solidMesh object) (right, down) <$> walkNamed object name
  count <- gridCount best
  pure (count, FaceName (map (vertexAt (solidMesh object)) (U.toList (gridWalk best))))

-- | A lower bound on the cells of the smallest of these grids.
leastCells :: [Grid] -> Integer
leastCells found = if null found then 0 else minimum (map gridAtLeast found)

-- | Lays all wanted faces on an array of this shape, beside the faces that are laid already. Every
-- wanted face must be a face of one of the solids. The first number is the seed of the search.
--
-- A face begins where it has the most cells, if such a layout can be found. Otherwise at least
-- three quarters of the most will do, then half, then any number.
layingsOf :: Int -> Shape -> Pitch -> [LaidFace] -> [Solid] -> [Wanted] -> Found
layingsOf seed shape@(Shape high wide) between lying objects wishes
  | i : _ <- [i | (i, least) <- zip [0 ..] leasts, least > toInteger (area shape)] =
    NoWay (PieceTooLarge i)
  | needed > free = NoWay (TooFewCells (fromInteger needed) (fromInteger free))
  | otherwise = firstLaid (nub (map (\share -> map (having share) pieces) [1, 3 / 4, 1 / 2, 0]))
  where
    -- Checked first, so that millions of cells on a small array need not be listed.
    leasts = map leastCells possible
    possible = gridsOf between objects wishes
    needed = sum leasts
    free = toInteger (area shape) - sum (map (toInteger . length . blockCells . laidBlock) lying)
    layingsFrom alternatives = case packed seed sheet (map (map fst) alternatives) of
      Packed places -> LaidSo (concat (zipWith3 laying wishes alternatives places))
      Impossible why -> NoWay why
      NotFound -> NoneFound
    firstLaid attempts = case attempts of
      alternatives : others@(_ : _)
        | LaidSo layings <- layingsFrom alternatives -> LaidSo layings
        | otherwise -> firstLaid others
      _ -> layingsFrom pieces
    -- The alternatives with at least this share of the most cells.
    having :: Rational -> [(BlockMask, Grid)] -> [(BlockMask, Grid)]
    having share alternatives =
      [one | one <- alternatives, fromIntegral (count one) >= share * fromIntegral most]
      where
        count = length . maskCells . fst
        most = maximum (0 : map count alternatives)
    sheet =
      Sheet
        { sheetRows = fromIntegral high,
          sheetColumns = fromIntegral wide,
          sheetTaken = mapMaybe taken lying
        }
    taken laid = do
      mask <- maskOf (size (laidGrid laid)) [cell at | at <- blockCells (laidBlock laid)]
      pure (mask, cell (laidAt laid))
    size (Shape r c) = (fromIntegral r, fromIntegral c)
    cell (Position r c) = (fromIntegral r, fromIntegral c)
    -- The first of several equal masks.
    pieces = map (nubOrdOn fst . mapMaybe masked) possible
    masked grid = do
      mask <-
        maskOf
          (fromInteger (gridRows grid), fromInteger (gridColumns grid))
          [(fromInteger r, fromInteger c) | (r, c) <- gridCells grid]
      pure (mask, grid)
    laying wish alternatives (Laid which at) =
      [ layingAt (faceObject (wantedFace wish)) grid at
        | (_, grid) <- take 1 (drop which alternatives)
      ]
    layingAt named grid (r, c) =
      Laying
        { layFace = Face named (walkName named grid),
          layAt = Position (fromIntegral (max 0 r)) (fromIntegral (max 0 c)),
          layAnchor =
            if (above, before) == (0, 0)
              then Centred
              else CentredPart (gridRows grid, gridColumns grid) (above, before),
          layBlock =
            blockOf
              ( Shape
                  (fromInteger (gridRows grid - above))
                  (fromInteger (gridColumns grid - before))
              )
              cells
        }
      where
        (above, before) = (toInteger (max 0 (negate r)), toInteger (max 0 (negate c)))
        cells =
          [ Position (fromInteger (i - above)) (fromInteger (j - before))
            | (i, j) <- gridCells grid
          ]
    walkName named grid =
      maybe
        (FaceName [])
        (\object -> FaceName (map (vertexAt (solidMesh object)) (U.toList (gridWalk grid))))
        (Map.lookup named byName)
    byName = Map.fromList [(solidName object, object) | object <- objects]

-- | The grids with cells that each request may have.
gridsOf :: Pitch -> [Solid] -> [Wanted] -> [[Grid]]
gridsOf between objects =
  map (\wish -> maybe [] (\object -> grids between object wish) (objectOf wish))
  where
    objectOf wish = Map.lookup (faceObject (wantedFace wish)) byName
    byName = Map.fromList [(solidName object, object) | object <- objects]

grids :: Pitch -> Solid -> Wanted -> [Grid]
grids (Pitch right down) object (Wanted face begun) =
  case begun of
    AsNamed -> from (toList named)
    AnyVertex -> anywhere
    BestVertex ->
      let most = maximum (0 : map gridAtLeast anywhere)
       in [grid | grid <- anywhere, gridAtLeast grid == most]
  where
    anywhere = from (maybe [] (begunAnywhere (solidMesh object)) named)
    named = walkNamed object (faceName face)
    from walks =
      [ grid
        | walk <- walks,
          let grid = gridOf (solidMesh object) (right, down) walk,
          not (null (take 1 (gridCells grid)))
      ]
