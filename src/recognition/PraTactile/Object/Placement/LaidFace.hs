{-# OPTIONS_HADDOCK hide #-}

-- | A face of a solid and the cells that it takes, by itself: which block of cells, where the block
-- lies on the face, and where on the array.
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
  { spotRight :: !Radicals,
    spotDown :: !Radicals
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

-- | A face as it lies by a wish, in its frame; whether the cells are on it is not asked.
laidIn :: Frame -> Pitch -> Laying -> LaidFace
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

-- | The cells of the array that a face has.
arrayCells :: LaidFace -> [Position]
arrayCells laid = [Position (r + i) (c + j) | Position i j <- blockCells (laidBlock laid)]
  where
    Position r c = laidAt laid

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

-- | The same laid face with all lengths times a number.
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
