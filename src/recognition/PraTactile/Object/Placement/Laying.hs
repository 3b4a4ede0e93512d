-- | Faces of solids laid on the cells of the array, checked (section II.B of the paper, figure 8):
-- each face takes cells of its own of a block, upright, and unless a margin is stated the block's
-- grid of symbols is centred on the face.
module PraTactile.Object.Placement.Laying
  ( -- * What is laid where
    Pitch (..),
    Face (..),
    Block (..),
    wholeBlock,
    blockOf,
    blockCells,
    hasCell,
    Laying (..),
    laidWhole,
    Anchor (..),

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
    LaidFace (..),
    laidGrid,
    layingOf,
    laidFaces,
    arrayCells,

    -- * What a look-up needs
    Seat (..),
    seatOf,
    seatBy,

    -- * Runs of cells
    Run (..),
    runsBetween,
    runsByRow,

    -- * Spots on a face
    Spot (..),
    spotAt,
    spotMillimetres,
  )
where

import Control.Monad (unless, when)
import Data.Foldable (toList)
import Data.List (genericLength, sortOn)
import Data.List.NonEmpty (NonEmpty (..), groupWith)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), area, naturalsBelow, shapeCells)
import PraTactile.Object.Cells (Anchor (..), allOn, blockCorner, cellsAmong)
import PraTactile.Object.Description (rotations)
import PraTactile.Object.Frame
import PraTactile.Object.Surd
import PraTactile.Object.WingedEdge

-- | The distances in millimetres from one symbol to the next, along a row and along a column.
data Pitch = Pitch
  { pitchRight :: !Rational,
    pitchDown :: !Rational
  }
  deriving stock (Eq, Show)

-- | A face of an object, from the vertex at which its frame begins.
data Face = Face
  { faceObject :: ObjectName,
    faceName :: FaceName
  }
  deriving stock (Eq, Ord, Show)

-- | Cells of a block of so many rows and columns: those listed, by row and column within it, or
-- all.
data Block = Block
  { blockShape :: !Shape,
    blockListed :: !(Maybe (Set.Set Position))
  }
  deriving stock (Eq, Show)

-- | All cells of a block of this shape.
wholeBlock :: Shape -> Block
wholeBlock shape = Block shape Nothing

-- | These cells of a block of this shape.
blockOf :: Shape -> [Position] -> Block
blockOf shape cells
  | genericLength cells == area shape = wholeBlock shape
  | otherwise = Block shape (Just (Set.fromList cells))

-- | The cells, row by row.
blockCells :: Block -> [Position]
blockCells (Block shape listed) = maybe (shapeCells shape) Set.toAscList listed

-- | Whether the cell is one of them.
hasCell :: Block -> Position -> Bool
hasCell (Block (Shape high wide) listed) cell =
  row cell < high && column cell < wide && maybe True (Set.member cell) listed

-- | The wish to lay a face: its block's upper left cell goes to 'layAt' of the array, and it takes
-- the cells 'layBlock'.
data Laying = Laying
  { layFace :: Face,
    layAt :: Position,
    layAnchor :: Anchor,
    layBlock :: Block
  }
  deriving stock (Eq, Show)

-- | The wish to lay a face on all cells of a block of this shape, which is centred on it.
laidWhole :: Face -> Position -> Shape -> Laying
laidWhole face at grid = Laying face at Centred (wholeBlock grid)

-- | A spot on a face in millimetres from the face's first vertex, the upper left one, to the right
-- and down, seen from outside.
data Spot = Spot
  { spotRight :: !Surd,
    spotDown :: !Surd
  }
  deriving stock (Eq, Ord, Show)

-- | The spot at rational distances.
spotAt :: Rational -> Rational -> Spot
spotAt right down = Spot (fraction right) (fraction down)

-- | A spot as the nearest machine numbers, (right, down) in millimetres, for output.
--
-- >>> spotMillimetres (spotAt (127 / 5) (127 / 4))
-- (25.4,31.75)
spotMillimetres :: Spot -> (Double, Double)
spotMillimetres (Spot right down) = (nearestDouble right, nearestDouble down)

-- | A face as it lies.
data LaidFace = LaidFace
  { laidFace :: Face,
    -- | where the block's upper left cell lies
    laidAt :: Position,
    laidAnchor :: Anchor,
    laidBlock :: Block,
    -- | the vertices with their spots, in the order of the face's name
    laidCorners :: [(VertexName, Spot)],
    -- | the upper left corner of the box round all vertices
    laidBox :: Spot,
    -- | that box's width and height
    laidExtent :: Spot,
    -- | the block's upper left corner
    laidMargin :: Spot
  }
  deriving stock (Eq, Show)

-- | Of a laid face all that a look-up needs, whichever cells it has.
data Seat = Seat
  { seatFace :: Face,
    -- | where the block's upper left cell lies
    seatAt :: Position,
    -- | the vertices with their spots, in the order of the face's name
    seatCorners :: [(VertexName, Spot)],
    -- | the block's upper left corner
    seatMargin :: Spot
  }
  deriving stock (Eq, Show)

-- | A laid face's seat.
seatOf :: LaidFace -> Seat
seatOf laid = Seat (laidFace laid) (laidAt laid) (laidCorners laid) (laidMargin laid)

-- | The seat of a face by the places of its corners, in the order of its name, and by where its
-- block lies, how, and of which shape; none where the corners make no face.
seatBy :: Pitch -> Face -> [Point] -> Position -> Anchor -> Shape -> Maybe Seat
seatBy between face corners at anchor grid =
  (\frame -> seatIn frame between face at anchor grid) <$> frameOfPoints corners

seatIn :: Frame -> Pitch -> Face -> Position -> Anchor -> Shape -> Seat
seatIn frame between face at anchor grid =
  Seat
    { seatFace = face,
      seatAt = at,
      seatCorners = zip (faceVertices (faceName face)) (map (uncurry Spot) (frameCorners frame)),
      seatMargin = uncurry Spot (blockCorner frame (cellOf between) anchor (sizes grid))
    }

-- | The rows and columns of a laid face's block.
laidGrid :: LaidFace -> Shape
laidGrid = blockShape . laidBlock

-- | The wish that a face be laid as it is.
layingOf :: LaidFace -> Laying
layingOf laid = Laying (laidFace laid) (laidAt laid) (laidAnchor laid) (laidBlock laid)

-- | Faces on an array, no two on one cell; built by 'placement' only.
data Placement = Placement
  { -- | the rows and columns of the array
    placementShape :: Shape,
    -- | the distances between symbols
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

-- | Cells side by side in a row of the array that one face has.
data Run = Run
  { runRow :: !Natural,
    -- | the first column, and the one after the last
    runFrom :: !Natural,
    runTo :: !Natural,
    -- | the place of the face in the order of layings
    runNumber :: !Int,
    runFace :: LaidFace
  }

-- | Why faces cannot be laid so, or cannot be looked up.
data PlacementError
  = -- | an object is no solid
    BrokenObject Defect
  | -- | the array has no cells
    EmptyArray Shape
  | -- | a distance between symbols is zero or negative
    PitchNotPositive Pitch
  | -- | two objects have this name
    RepeatedObject ObjectName
  | -- | there is no such object
    UnknownObject ObjectName
  | -- | no face of the object has these vertices
    UnknownFace Face
  | -- | the face is given by its vertices in another order than its name, which comes second
    WrongVertexOrder Face FaceName
  | -- | the face is laid on two blocks of cells
    FaceLaidTwice Face
  | -- | the face has no cells on the array
    FaceNotLaid Face
  | -- | the face's block has no cells
    EmptyGrid Face Shape
  | -- | the block at this cell, of this shape, has cells that stick out of the array's sheet
    OutsideArray Face Position Shape
  | -- | these cells of the block do not lie wholly on the face
    CellsOffFace Face [Position]
  | -- | both faces claim these cells
    FacesOverlap Face Face [Position]
  | -- | the face's block has no such cell
    CellOffFace Face Position
  deriving stock (Eq, Show)

-- | Lay faces on an array of the given shape. Refuses with the first fault, in the order of the
-- constructors of 'PlacementError' for each face, and then with the first two of the faces that
-- claim the first cell, row by row, that several claim. O(cells * corners) for a face that is no
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

-- | The placement of faces that keep apart.
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

-- | The same placement with all lengths times a positive number.
scaledPlacement :: Rational -> Placement -> Placement
scaledPlacement k place =
  assembled
    (placementShape place)
    (Pitch (k * right) (k * down))
    (map (scaledSolid k) (placementSolids place))
    (map scaledFace (laidFaces place))
  where
    Pitch right down = placementPitch place
    spot (Spot x y) = Spot (times k x) (times k y)
    scaledFace laid =
      laid
        { laidAnchor = case laidAnchor laid of
            Margin x y -> Margin (k * x) (k * y)
            centred -> centred,
          laidCorners = map (fmap spot) (laidCorners laid),
          laidBox = spot (laidBox laid),
          laidExtent = spot (laidExtent laid),
          laidMargin = spot (laidMargin laid)
        }

-- | What equals something before it in what the function makes of it.
repeated :: Ord k => (a -> k) -> [a] -> [a]
repeated part = go Set.empty
  where
    go _ [] = []
    go seen (one : others)
      | part one `Set.member` seen = one : go seen others
      | otherwise = go (Set.insert (part one) seen) others

-- | The face begun at the vertex whose name is the least: the same of every name for it.
fromLeastVertex :: Face -> Face
fromLeastVertex (Face object (FaceName walk)) = Face object (FaceName (minimum (rotations walk)))

-- | The object of this name.
placementObject :: Placement -> ObjectName -> Maybe Solid
placementObject place named = Map.lookup named (placementByName place)

-- | The laid face of this name, whichever of its vertices that begins with.
placementLaid :: Placement -> Face -> Maybe LaidFace
placementLaid place face = Map.lookup (fromLeastVertex face) (placementByWalk place)

-- | The runs in a row of the array that have a cell from a column on to before another.
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

-- | All rows of the array in which a face has cells, each with its runs from left to right.
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

-- | The cells of the array that a face has.
arrayCells :: LaidFace -> [Position]
arrayCells laid = [Position (r + i) (c + j) | Position i j <- blockCells (laidBlock laid)]
  where
    Position r c = laidAt laid

lay :: Shape -> Pitch -> Map.Map ObjectName Solid -> Laying -> Either PlacementError LaidFace
lay shape between objects (Laying face at anchor block) = do
  object <- maybe (Left (UnknownObject named)) Right (Map.lookup named objects)
  walk <- maybe (Left (unnamedFace object)) Right (walkNamed object (faceName face))
  frame <- maybe (Left (EmptyGrid face grid)) Right (frameOf (solidMesh object) walk)
  when (null (blockCells block)) (Left (EmptyGrid face grid))
  -- Of a whole block beyond the array, cells are not counted one by one.
  when (isNothing (blockListed block) && not (all onSheet outermost)) $
    Left (OutsideArray face at grid)
  let off = cellsOff frame between anchor block
  unless (null off) (Left (CellsOffFace face off))
  unless (all onSheet outermost) (Left (OutsideArray face at grid))
  let (box, extent) = frameExtent frame
      seat = seatIn frame between face at anchor grid
  pure
    LaidFace
      { laidFace = face,
        laidAt = at,
        laidAnchor = anchor,
        laidBlock = block,
        laidCorners = seatCorners seat,
        laidBox = uncurry Spot box,
        laidExtent = uncurry Spot extent,
        laidMargin = seatMargin seat
      }
  where
    named = faceObject face
    grid = blockShape block
    unnamedFace object =
      maybe (UnknownFace face) (WrongVertexOrder face) (sameCorners object (faceName face))
    onSheet (Position i j) = row at + i < rows shape && column at + j < columns shape
    outermost =
      maybe [Position (rows grid - 1) (columns grid - 1)] Set.toList (blockListed block)

-- | The cells of a block that do not lie wholly on the face.
cellsOff :: Frame -> Pitch -> Anchor -> Block -> [Position]
cellsOff frame between anchor block
  | allOn frame cell anchor size =
    filter (not . hasCell (wholeBlock shape)) (maybe [] Set.toList (blockListed block))
  | otherwise = filter (`Set.notMember` on) (blockCells block)
  where
    shape = blockShape block
    cell = cellOf between
    size = sizes shape
    on =
      Set.fromDistinctAscList
        [ Position (fromInteger i) (fromInteger j)
          | (i, j) <- cellsAmong frame cell anchor size (byRow (blockCells block))
        ]
    byRow cells = case cells of
      [] -> []
      Position i _ : _ ->
        let (these, others) = span ((== i) . row) cells
         in (toInteger i, map (toInteger . column) these) : byRow others

cellOf :: Pitch -> (Rational, Rational)
cellOf (Pitch right down) = (right, down)

sizes :: Shape -> (Integer, Integer)
sizes (Shape high wide) = (toInteger high, toInteger wide)
