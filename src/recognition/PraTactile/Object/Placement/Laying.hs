{-# OPTIONS_HADDOCK hide #-}

-- | Lays faces of solids on the cells of the array, with checks (section II.B of the paper, figure
-- 8). Each face takes cells of one block, upright. Unless a margin is stated, the block's grid of
-- symbols is centred on the face. No cell belongs to two faces. Look-ups use an index of runs,
-- which are cells side by side.
module PraTactile.Object.Placement.Laying
  ( -- * What is laid where
    module PraTactile.Object.Placement.LaidFace,

    -- * Placements
    Placement,
    PlacementError (..),
    placement,
    scaledPlacement,
    placementShape,
    placementPitch,
    placementSolids,
    placementObject,
    placementLaid,
    laidFaces,
    laidOver,

    -- * Runs of cells
    Run (..),
    runsBetween,
    runsByRow,
  )
where

import Control.Monad (unless, when)
import Data.Foldable (toList)
import Data.List (sortOn)
import Data.List.NonEmpty (NonEmpty (..), groupWith)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing, listToMaybe)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), naturalsBelow)
import PraTactile.Object.Description (rotations)
import PraTactile.Object.Frame (frameOf)
import PraTactile.Object.Placement.LaidFace
import PraTactile.Object.WingedEdge

-- | Faces on an array with no cell in common. Only 'placement' makes one.
data Placement = Placement
  { -- | the rows and columns of the array
    placementShape :: Shape,
    -- | the distances between symbols, in millimetres
    placementPitch :: Pitch,
    -- | the objects, in the order given
    placementSolids :: [Solid],
    -- | the faces, in the order given
    laidFaces :: [LaidFace],
    placementByName :: Map.Map ObjectName Solid,
    placementByWalk :: Map.Map Face LaidFace,
    placementRuns :: Map.Map (Natural, Natural) Run
  }

instance Eq Placement where
  a == b =
    (placementShape a, placementPitch a) == (placementShape b, placementPitch b)
      && placementSolids a == placementSolids b
      && laidFaces a == laidFaces b

instance Show Placement where
  showsPrec depth whole =
    showParen (depth > 10) $
      showString "Placement "
        . showsPrec 11 (placementShape whole, placementPitch whole)
        . showString " "
        . showsPrec 11 (placementSolids whole, laidFaces whole)

-- | Cells of one face side by side in a row of the array.
data Run = Run
  { runRow :: !Natural,
    -- | the first column, and the column after the last
    runFrom :: !Natural,
    runTo :: !Natural,
    -- | the index of the face in the order of layings
    runNumber :: !Int,
    runFace :: LaidFace
  }

-- | Why faces cannot be laid, or cannot be looked up.
data PlacementError
  = -- | an object is not a valid solid
    BrokenObject Defect
  | -- | the array has no cells
    EmptyArray Shape
  | -- | a distance between symbols is zero or negative
    PitchNotPositive Pitch
  | -- | two objects have this name
    RepeatedObject ObjectName
  | -- | there is no object with this name
    UnknownObject ObjectName
  | -- | no face of the object has these vertices
    UnknownFace Face
  | -- | the face's vertices are given in another order than in its name, which comes second
    WrongVertexOrder Face FaceName
  | -- | the face is laid on two blocks of cells
    FaceLaidTwice Face
  | -- | the face has no cells on the array
    FaceNotLaid Face
  | -- | the face's block has no cells
    EmptyGrid Face Shape
  | -- | the block at this position, with this shape, has cells beyond the array's sheet
    OutsideArray Face Position Shape
  | -- | these cells of the block do not lie wholly on the face
    CellsOffFace Face [Position]
  | -- | both faces claim these cells
    FacesOverlap Face Face [Position]
  | -- | the face's block has no such cell
    CellOffFace Face Position
  deriving stock (Eq, Show)

-- | Lays faces on an array of the given shape. For each face it refuses with the first fault in the
-- order of 'PlacementError''s constructors. Then it refuses overlaps, naming the first two faces
-- that claim the first disputed cell, row by row. O(cells * corners) for a face that is not a
-- rectangle.
placement :: Shape -> Pitch -> [Solid] -> [Laying] -> Either PlacementError Placement
placement shape between objects layings = do
  unless (rows shape > 0 && columns shape > 0) (Left (EmptyArray shape))
  unless (pitchRight between > 0 && pitchDown between > 0) (Left (PitchNotPositive between))
  none (map RepeatedObject (repeated id (map solidName objects)))
  laid <- traverse (lay shape between byName) layings
  none (map FaceLaidTwice (repeated fromLeastVertex (map laidFace laid)))
  let runs = sortOn (\run -> (runRow run, runFrom run)) (runsOfAll laid)
      claiming r c = [run | run <- runs, runRow run == r, runFrom run <= c, c < runTo run]
  none
    [ FacesOverlap (laidFace a) (laidFace b) (sharedCells a b)
      | (one, other) <- zip runs (drop 1 runs),
        runRow one == runRow other,
        runFrom other < runTo one,
        a : b : _ <-
          [map runFace (sortOn runNumber (claiming (runRow other) (runFrom other)))]
    ]
  pure (assembled shape between objects laid)
  where
    none = mapM_ Left . take 1
    byName = Map.fromList [(solidName object, object) | object <- objects]

-- | The placement of faces that do not overlap; this is not checked.
assembled :: Shape -> Pitch -> [Solid] -> [LaidFace] -> Placement
assembled shape between objects laid =
  Placement
    { placementShape = shape,
      placementPitch = between,
      placementSolids = objects,
      laidFaces = laid,
      placementByName = Map.fromList [(solidName object, object) | object <- objects],
      placementByWalk = Map.fromList [(fromLeastVertex (laidFace face), face) | face <- laid],
      placementRuns = Map.fromList [((runRow run, runFrom run), run) | run <- runsOfAll laid]
    }

-- | A placement with all lengths multiplied by a positive number.
scaledPlacement :: Rational -> Placement -> Placement
scaledPlacement k place =
  assembled
    (placementShape place)
    (Pitch (k * right) (k * down))
    (map (scaledSolid k) (placementSolids place))
    (map (scaledFace k) (laidFaces place))
  where
    Pitch right down = placementPitch place

-- | The elements whose key equals that of an earlier element.
repeated :: Ord k => (a -> k) -> [a] -> [a]
repeated part = go Set.empty
  where
    go _ [] = []
    go seen (one : others)
      | part one `Set.member` seen = one : go seen others
      | otherwise = go (Set.insert (part one) seen) others

-- | The face begun at its vertex with the least name. All names of one face give the same result.
fromLeastVertex :: Face -> Face
fromLeastVertex (Face object (FaceName walk)) = Face object (FaceName (minimum (rotations walk)))

-- | The object with this name.
placementObject :: Placement -> ObjectName -> Maybe Solid
placementObject place named = Map.lookup named (placementByName place)

-- | The laid face with this name, which may begin at any of its vertices.
placementLaid :: Placement -> Face -> Maybe LaidFace
placementLaid place face = Map.lookup (fromLeastVertex face) (placementByWalk place)

-- | The runs in a row of the array that overlap a range of columns, whose end is exclusive.
runsBetween :: Placement -> Natural -> (Natural, Natural) -> [Run]
runsBetween place r (from, to) =
  [ run
    | from < to,
      run <- map snd (toList (Map.lookupLE (r, from) runs)) ++ Map.elems within,
      runRow run == r,
      runTo run > from
  ]
  where
    runs = placementRuns place
    within = fst (Map.split (r, to) (snd (Map.split (r, from) runs)))

-- | The laid face that has this cell of the array's sheet, and the cell's position in its block.
laidOver :: Placement -> Position -> Maybe (LaidFace, Position)
laidOver place (Position r c) =
  listToMaybe
    [ (laid, Position (r - row (laidAt laid)) (c - column (laidAt laid)))
      | run <- runsBetween place r (c, c + 1),
        let laid = runFace run
    ]

-- | All rows of the array in which faces have cells, each with its runs from left to right.
runsByRow :: Placement -> [(Natural, [Run])]
runsByRow place =
  [ (runRow one, one : others)
    | one :| others <- groupWith runRow (Map.elems (placementRuns place))
  ]

-- | The runs of all laid faces.
runsOfAll :: [LaidFace] -> [Run]
runsOfAll = concat . zipWith runsOf [0 ..]

-- | The runs of the n-th laid face.
runsOf :: Int -> LaidFace -> [Run]
runsOf number laid = case blockListed (laidBlock laid) of
  Nothing -> [run i 0 (columns shape) | i <- naturalsBelow (rows shape)]
  Just listed -> joined (Set.toAscList listed)
  where
    shape = blockShape (laidBlock laid)
    Position r c = laidAt laid
    run i from to = Run (r + i) (c + from) (c + to) number laid
    joined cells = case cells of
      [] -> []
      Position i j : others ->
        let beside = length (takeWhile id (zipWith (==) others [Position i k | k <- [j + 1 ..]]))
         in run i j (j + 1 + fromIntegral beside) : joined (drop beside others)

sharedCells :: LaidFace -> LaidFace -> [Position]
sharedCells a b = Set.toAscList (Set.intersection (cellsOf a) (cellsOf b))
  where
    cellsOf = Set.fromList . arrayCells

lay :: Shape -> Pitch -> Map.Map ObjectName Solid -> Laying -> Either PlacementError LaidFace
lay shape between objects wish@(Laying face at anchor block) = do
  object <- maybe (Left (UnknownObject named)) Right (Map.lookup named objects)
  walk <- maybe (Left (unnamedFace object)) Right (walkNamed object (faceName face))
  frame <- maybe (Left (EmptyGrid face grid)) Right (frameOf (solidMesh object) walk)
  when (null (blockCells block)) (Left (EmptyGrid face grid))
  -- For a whole block beyond the array, cells are not counted one by one.
  when (isNothing (blockListed block) && not (all onSheet outermost)) $
    Left (OutsideArray face at grid)
  let off = cellsOff frame between anchor block
  unless (null off) (Left (CellsOffFace face off))
  unless (all onSheet outermost) (Left (OutsideArray face at grid))
  pure (laidIn frame between wish)
  where
    named = faceObject face
    grid = blockShape block
    unnamedFace object =
      maybe (UnknownFace face) (WrongVertexOrder face) (sameCorners object (faceName face))
    onSheet (Position i j) = row at + i < rows shape && column at + j < columns shape
    outermost =
      maybe [Position (rows grid - 1) (columns grid - 1)] Set.toList (blockListed block)
