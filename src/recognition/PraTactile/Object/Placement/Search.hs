{-# OPTIONS_HADDOCK hide #-}

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

-- | At which vertex its frame may begin.
data Begun
  = -- | at the first of its name
    AsNamed
  | -- | at any
    AnyVertex
  | -- | at any that gives it the most symbols
    BestVertex
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
  | -- | no face of these objects has room for a symbol of that pitch
    NothingCarries Pitch [Solid]
  | -- | these faces are not laid: there is no way, or none was found
    NotLaid [Wanted] (Maybe Reason)
  deriving stock (Eq, Show)

-- | The placement with these objects too, all faces of which that have a cell are laid beside what
-- lies already.
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

-- | How many symbols a face has at most, of all vertices at which it may be begun, and from which
-- one it has them; 'Nothing' where that would take long to say.
mostSymbols :: Pitch -> Solid -> FaceName -> Maybe (Integer, FaceName)
mostSymbols (Pitch right down) object name = do
  best <- bestGrid (solidMesh object) (right, down) <$> walkNamed object name
  count <- gridCount best
  pure (count, FaceName (map (vertexAt (solidMesh object)) (U.toList (gridWalk best))))

-- | How many cells the smallest of some grids has at least.
leastCells :: [Grid] -> Integer
leastCells found = if null found then 0 else minimum (map gridAtLeast found)

-- | Lay all the faces wanted on an array of this shape, none on a cell of those that lie already,
-- by a search that this seed begins. Each is begun where it has the most cells, if that can be
-- found; else at least three quarters of them, and so on. Each is a face of one of the solids.
layingsOf :: Int -> Shape -> Pitch -> [LaidFace] -> [Solid] -> [Wanted] -> Found
layingsOf seed shape@(Shape high wide) between lying objects wishes
  | i : _ <- [i | (i, least) <- zip [0 ..] leasts, least > toInteger (area shape)] =
    NoWay (PieceTooLarge i)
  | needed > free = NoWay (TooFewCells (fromInteger needed) (fromInteger free))
  | otherwise = firstLaid (nub (map (\share -> map (having share) pieces) [1, 3 / 4, 1 / 2, 0]))
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
    firstLaid attempts = case attempts of
      alternatives : others@(_ : _)
        | LaidSo layings <- layingsFrom alternatives -> LaidSo layings
        | otherwise -> firstLaid others
      _ -> layingsFrom pieces
    -- The alternatives with at least this share of the most cells.
    having :: Rational -> [(Mask, Grid)] -> [(Mask, Grid)]
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
