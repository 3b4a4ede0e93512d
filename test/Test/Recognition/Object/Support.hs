-- | The shared parts of the tests of objects: the canonical layout, written a second time from its
-- definition in whole micrometres and cells, using only names from the code under test.
module Test.Recognition.Object.Support
  ( -- * Expectations
    module Test.Support,
    theCube,
    theParallelepiped,
    thePlacement,

    -- * The layout
    Block (..),
    blocks,
    blockCells,
    everyPosition,
    owners,
    expectedWhereabouts,

    -- * Any solid
    layingFor,
  )
where

import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Data.Ratio ((%))
import qualified Data.Vector.Unboxed as U
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Cells (Grid (..))
import PraTactile.Object.Mesh (vertexAt)
import PraTactile.Object.PaperObjects (cube, parallelepiped)
import PraTactile.Object.Placement hiding (Block (..), blockCells)
import PraTactile.Object.WingedEdge
import Test.Hspec
import Test.Support

theCube, theParallelepiped :: (Solid -> Expectation) -> Expectation
theCube = (right cube >>=)
theParallelepiped = (right parallelepiped >>=)

thePlacement :: (Placement -> Expectation) -> Expectation
thePlacement = (right canonicalPlacement >>=)

-- | A face's block of cells: the face, its upper left cell, its rows and columns, and the face's
-- width and height in micrometres.
data Block = Block
  { blockFace :: Face,
    blockRow, blockColumn, blockRows, blockColumns :: Natural,
    blockWidth, blockHeight :: Integer
  }

blocks :: [Block]
blocks =
  [ Block (Face (ObjectName object) (readFaceName face)) r c high wide width height
    | (object, face, (r, c), (high, wide), (width, height)) <-
        [ ("cube", "C2 C6 C7 C3", (0, 0), (4, 5), (127000, 127000)),
          ("cube", "C3 C7 C8 C4", (0, 5), (4, 5), (127000, 127000)),
          ("cube", "C4 C8 C5 C1", (4, 0), (4, 5), (127000, 127000)),
          ("cube", "C1 C2 C3 C4", (4, 5), (4, 5), (127000, 127000)),
          ("cube", "C1 C5 C6 C2", (8, 0), (4, 5), (127000, 127000)),
          ("cube", "C6 C5 C8 C7", (8, 5), (4, 5), (127000, 127000)),
          ("parallelepiped", "P1 P2 P3 P4", (0, 10), (3, 7), (177800, 101600)),
          ("parallelepiped", "P6 P5 P8 P7", (3, 10), (3, 7), (177800, 101600)),
          ("parallelepiped", "P2 P6 P7 P3", (6, 10), (3, 7), (177800, 95250)),
          ("parallelepiped", "P4 P8 P5 P1", (9, 10), (3, 7), (177800, 95250)),
          ("parallelepiped", "P3 P7 P8 P4", (12, 0), (3, 4), (101600, 95250)),
          ("parallelepiped", "P1 P5 P6 P2", (12, 4), (3, 4), (101600, 95250))
        ]
  ]

-- | The cells of a block: on the array, and within the block.
blockCells :: Block -> [(Position, Position)]
blockCells block =
  [ (Position (blockRow block + r) (blockColumn block + c), Position r c)
    | r <- below (blockRows block),
      c <- below (blockColumns block)
  ]

everyPosition :: [Position]
everyPosition = [Position r c | r <- below 15, c <- below 17]

-- | The blocks, and their cells, that claim each cell of the array.
owners :: Map.Map Position [(Int, Position)]
owners =
  Map.fromListWith
    (++)
    [ (cell, [(index, local)])
      | (index, block) <- zip [0 ..] blocks,
        (cell, local) <- blockCells block
    ]

-- | The place of a window by definition: all its cells are looked up one by one.
expectedWhereabouts :: Shape -> Position -> Whereabouts
expectedWhereabouts (Shape high wide) (Position r c) = case traverse cellOwner offsets of
  Just ((index, local) : others)
    | and
        [ other == (index, local `plus` offset)
          | (other, offset) <- zip ((index, local) : others) offsets
        ] ->
      OnFace (placed (blocks !! index) local)
  _
    | length touched > 1 -> Straddles (map (blockFace . (blocks !!)) touched)
    | otherwise -> OnNoObject
  where
    offsets = [Position i j | i <- below high, j <- below wide]
    cellAt offset =
      let Position i j = Position r c `plus` offset in Position (i `mod` 15) (j `mod` 17)
    cellOwner offset = Map.lookup (cellAt offset) owners >>= onlyOne
    touched = Map.keys (Map.fromList [(index, ()) | (index, _) <- mapMaybe cellOwner offsets])
    plus (Position a b) (Position i j) = Position (a + i) (b + j)
    onlyOne claims = case claims of [one] -> Just one; _ -> Nothing
    placed block local@(Position i j) =
      let -- twice the centre, in micrometres
          x =
            blockWidth block
              - 25400 * toInteger (blockColumns block)
              + 25400 * (2 * toInteger j + toInteger wide)
          y =
            blockHeight block
              - 31750 * toInteger (blockRows block)
              + 31750 * (2 * toInteger i + toInteger high)
          vertices =
            zip
              (faceVertices (faceName (blockFace block)))
              [ (0, 0),
                (0, blockHeight block),
                (blockWidth block, blockHeight block),
                (blockWidth block, 0)
              ]
          away (a, b) = (2 * a - x) ^ (2 :: Int) + (2 * b - y) ^ (2 :: Int)
          nearest = minimum (map (away . snd) vertices)
       in Place
            (blockFace block)
            local
            (spotAt (x % 2000) (y % 2000))
            [vertex | (vertex, at) <- vertices, away at == nearest]

-- | A face laid on some of the cells of its grid, from the upper left cell of the array on.
layingFor :: Solid -> Grid -> [(Integer, Integer)] -> Laying
layingFor whole grid cells =
  Laying
    { layFace = Face (solidName whole) (FaceName (map name (U.toList (gridWalk grid)))),
      layAt = Position 0 0,
      layAnchor = Centred,
      layBlock =
        blockOf
          (Shape (fromInteger (gridRows grid)) (fromInteger (gridColumns grid)))
          [Position (fromInteger r) (fromInteger c) | (r, c) <- cells]
    }
  where
    name = vertexAt (solidMesh whole)
