{-# OPTIONS_HADDOCK hide #-}

-- | A face of a solid and the cells that it takes: the block of cells, its place on the face, and
-- its place on the array.
module PraTactile.Object.Placement.LaidFace
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

    -- * A face as it lies
    LaidFace (..),
    laidIn,
    laidGrid,
    layingOf,
    arrayCells,
    cellsOff,
    scaledFace,

    -- * What a look-up needs
    Seat (..),
    seatOf,
    seatBy,

    -- * Spots on a face
    Spot (..),
    spotAt,
    spotMillimetres,
  )
where

import Data.List (genericLength)
import qualified Data.Set as Set
import PraTactile.Array (Position (..), Shape (..), area, shapeCells)
import PraTactile.Object.Cells (Anchor (..), allOn, blockCorner, cellsAmong)
import PraTactile.Object.Frame
import PraTactile.Object.Number (times)
import PraTactile.Object.Radicals
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

-- | A block of cells: the listed ones, by row and column within it, or all if there is no list.
data Block = Block
  { blockShape :: !Shape,
    blockListed :: !(Maybe (Set.Set Position))
  }
  deriving stock (Eq, Show)

-- | All cells of a block of this shape.
wholeBlock :: Shape -> Block
wholeBlock shape = Block shape Nothing

-- | A block of this shape with only these cells.
blockOf :: Shape -> [Position] -> Block
blockOf shape cells
  | genericLength cells == area shape = wholeBlock shape
  | otherwise = Block shape (Just (Set.fromList cells))

-- | The cells of a block, row by row.
blockCells :: Block -> [Position]
blockCells (Block shape listed) = maybe (shapeCells shape) Set.toAscList listed

-- | Whether a block has this cell.
hasCell :: Block -> Position -> Bool
hasCell (Block (Shape high wide) listed) cell =
  row cell < high && column cell < wide && maybe True (Set.member cell) listed

-- | A request to lay a face: its block's upper left cell goes to 'layAt' on the array, and it takes
-- the cells 'layBlock'.
data Laying = Laying
  { layFace :: Face,
    layAt :: Position,
    layAnchor :: Anchor,
    layBlock :: Block
  }
  deriving stock (Eq, Show)

-- | A request to lay a face on all cells of a block of this shape, centred on the face.
laidWhole :: Face -> Position -> Shape -> Laying
laidWhole face at grid = Laying face at Centred (wholeBlock grid)

-- | A spot on a face, in millimetres right of and below the face's first vertex, the upper left
-- one, as seen from outside.
data Spot = Spot
  { spotRight :: !Radicals,
    spotDown :: !Radicals
  }
  deriving stock (Eq, Ord, Show)

-- | The spot at these distances to the right and down.
spotAt :: Rational -> Rational -> Spot
spotAt right down = Spot (fraction right) (fraction down)

-- | A spot as machine numbers, (right, down) in millimetres, for output.
--
-- >>> spotMillimetres (spotAt (127 / 5) (127 / 4))
-- (25.4,31.75)
spotMillimetres :: Spot -> (Double, Double)
spotMillimetres (Spot right down) = (nearestDouble right, nearestDouble down)

-- | A face with its geometry and its place on the array.
data LaidFace = LaidFace
  { laidFace :: Face,
    -- | the position on the array of the block's upper left cell
    laidAt :: Position,
    laidAnchor :: Anchor,
    laidBlock :: Block,
    -- | the vertices with their spots, in the order of the face's name
    laidCorners :: [(VertexName, Spot)],
    -- | the upper left corner of the face's bounding box
    laidBox :: Spot,
    -- | the bounding box's width and height
    laidExtent :: Spot,
    -- | the block's upper left corner
    laidMargin :: Spot
  }
  deriving stock (Eq, Show)

-- | What a look-up needs of a laid face, whichever cells the face has.
data Seat = Seat
  { seatFace :: Face,
    -- | the position on the array of the block's upper left cell
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

-- | The seat of a face. Arguments: the pitch; the face; its corners in the order of its name; where
-- its block's upper left cell lies, how the block is anchored, and its shape. 'Nothing' if the
-- corners do not make a face.
seatBy :: Pitch -> Face -> [Point] -> Position -> Anchor -> Shape -> Maybe Seat
seatBy between face corners at anchor grid =
  (\frame -> seatIn frame between face at anchor grid) <$> frameOfPoints corners

seatIn :: FaceFrame -> Pitch -> Face -> Position -> Anchor -> Shape -> Seat
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

-- | The request that would lay a face as it lies.
layingOf :: LaidFace -> Laying
layingOf laid = Laying (laidFace laid) (laidAt laid) (laidAnchor laid) (laidBlock laid)

-- | Lays a face by a request, in its frame. It does not check whether the cells are on the face.
laidIn :: FaceFrame -> Pitch -> Laying -> LaidFace
laidIn frame between (Laying face at anchor block) =
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
    (box, extent) = frameExtent frame
    seat = seatIn frame between face at anchor (blockShape block)

-- | The positions on the array of a face's cells.
arrayCells :: LaidFace -> [Position]
arrayCells laid = [Position (r + i) (c + j) | Position i j <- blockCells (laidBlock laid)]
  where
    Position r c = laidAt laid

-- | The cells of a block that do not lie wholly on the face.
cellsOff :: FaceFrame -> Pitch -> Anchor -> Block -> [Position]
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

-- | A laid face with all lengths multiplied by a number. Its place on the array stays.
scaledFace :: Rational -> LaidFace -> LaidFace
scaledFace k laid =
  laid
    { laidAnchor = case laidAnchor laid of
        Margin x y -> Margin (k * x) (k * y)
        centred -> centred,
      laidCorners = map (fmap spot) (laidCorners laid),
      laidBox = spot (laidBox laid),
      laidExtent = spot (laidExtent laid),
      laidMargin = spot (laidMargin laid)
    }
  where
    spot (Spot x y) = Spot (times k x) (times k y)

cellOf :: Pitch -> (Rational, Rational)
cellOf (Pitch right down) = (right, down)

sizes :: Shape -> (Integer, Integer)
sizes (Shape high wide) = (toInteger high, toInteger wide)
