-- | Where faces are laid, by search: a face takes all cells of its grid, and it may be begun at any
-- of its vertices, for another first vertex is another frame and so another grid.
--
-- The faces wanted are pieces whose alternatives are their grids' cells, and what lies already is
-- taken: "PraTactile.Object.Packing" has the mathematics.
module PraTactile.Object.Placement.Search
  ( Wanted (..),
    Begun (..),
    facesOf,
    Found (..),
    layingsOf,
    cellsNeeded,

    -- * Changing a placement
    NotChanged (..),
    adding,
    removing,
  )
where

import Data.Bifunctor (first)
import Data.Containers.ListUtils (nubOrdOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import qualified Data.Vector.Unboxed as U
import PraTactile.Array (Position (..), Shape (..), area)
import PraTactile.Object.Cells
import PraTactile.Object.Description (rotations)
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

-- | At which vertex its frame may begin.
data Begun
  = -- | at the first of its name
    AsNamed
  | -- | at any
    AnyVertex
  deriving stock (Eq, Show)

-- | What a search came to.
data Found
  = -- | all faces, in the order of the wishes
    LaidSo [Laying]
  | -- | there is no way; pieces are the wishes, what is taken are the layings that there are
    NoWay Reason
  | -- | none was found, and that there is none was not proved
    NoneFound
  deriving stock (Eq, Show)

-- | All faces of solids that have a cell, by a grid of this pitch, when begun so.
facesOf :: Pitch -> Begun -> [Solid] -> [Wanted]
facesOf between begun objects =
  [ wanted
    | object <- objects,
      face <- solidFaces object,
      let wanted = Wanted (Face (solidName object) face) begun,
      not (null (grids between object wanted))
  ]

-- | Why a placement cannot be changed so.
data NotChanged
  = -- | an object of this name is there already, or is not there
    NotChanged PlacementError
  | -- | these faces are not laid: there is no way, or none was found
    NotLaid [Wanted] (Maybe Reason)
  deriving stock (Eq, Show)

-- | The placement with these objects too, all faces of which that have a cell are laid beside what
-- lies already.
adding :: Int -> [Solid] -> Placement -> Either NotChanged Placement
adding seed new place = do
  _ <- laid lying
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

-- | The placement without the objects of these names.
removing :: [ObjectName] -> Placement -> Either NotChanged Placement
removing names place = do
  mapM_ (first NotChanged . findObject place) names
  first NotChanged $
    placement
      (placementShape place)
      (placementPitch place)
      (filter ((`notElem` names) . solidName) (placementSolids place))
      [layingOf laid | laid <- laidFaces place, faceObject (laidFace laid) `notElem` names]

-- | How many cells wishes take at least, whichever of their frames they have.
cellsNeeded :: Pitch -> [Solid] -> [Wanted] -> Integer
cellsNeeded between objects = sum . map leastCells . gridsOf between objects

-- | How many cells the smallest of some grids has at least.
leastCells :: [Grid] -> Integer
leastCells found = if null found then 0 else minimum (map gridAtLeast found)

-- | Lay all the faces wanted on an array of this shape, none on a cell of those that lie already,
-- by a search that this seed begins; if that can be found, each by a frame with as many cells as
-- any of its frames has. Each is a face of one of the solids.
layingsOf :: Int -> Shape -> Pitch -> [LaidFace] -> [Solid] -> [Wanted] -> Found
layingsOf seed shape@(Shape high wide) between lying objects wishes
  | i : _ <- [i | (i, least) <- zip [0 ..] leasts, least > toInteger (area shape)] =
    NoWay (PieceTooLarge i)
  | needed > free = NoWay (TooFewCells (fromInteger needed) (fromInteger free))
  | LaidSo layings <- layingsFrom (map mostCells pieces) = LaidSo layings
  | otherwise = layingsFrom pieces
  where
    -- So that millions of cells on few need not be listed.
    leasts = map leastCells possible
    possible = gridsOf between objects wishes
    needed = sum leasts
    free = toInteger (area shape) - sum (map (toInteger . length . blockCells . laidBlock) lying)
    layingsFrom alternatives = case packed seed sheet (map (map fst) alternatives) of
      Packed places -> LaidSo (concat (zipWith3 laying wishes alternatives places))
      Impossible why -> NoWay why
      NotFound -> NoneFound
    mostCells alternatives =
      let most = maximum (map (length . maskCells . fst) alternatives)
       in [one | one <- alternatives, length (maskCells (fst one)) == most]
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
    -- Of equal masks the first.
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

-- | The grids that wishes may have, those with cells.
gridsOf :: Pitch -> [Solid] -> [Wanted] -> [[Grid]]
gridsOf between objects =
  map (\wish -> maybe [] (\object -> grids between object wish) (objectOf wish))
  where
    objectOf wish = Map.lookup (faceObject (wantedFace wish)) byName
    byName = Map.fromList [(solidName object, object) | object <- objects]

grids :: Pitch -> Solid -> Wanted -> [Grid]
grids (Pitch right down) object (Wanted face begun) =
  [ grid
    | Just walk <- map (walkNamed object) names,
      let grid = gridOf (solidMesh object) (right, down) walk,
      not (null (take 1 (gridCells grid)))
  ]
  where
    names = case begun of
      AsNamed -> [faceName face]
      AnyVertex -> map FaceName (rotations (faceVertices (faceName face)))
