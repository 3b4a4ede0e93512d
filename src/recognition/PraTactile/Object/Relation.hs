-- | A placement as pure rows: \"the mapping of the winged-edge object models to the encoding PRA is
-- implemented as a relational database\" (section II.B of the paper), and this is the specification
-- of that database. It has all of a placement and can be turned back, so whoever reads rows from
-- elsewhere learns whether they make sense.
module PraTactile.Object.Relation
  ( -- * Rows
    Relation (..),
    SheetRow (..),
    VertexRow (..),
    CornerRow (..),
    EdgeRow (..),
    LayingRow (..),
    CellRow (..),

    -- * From a placement and back
    relation,
    placementOf,
    RelationError (..),
    Table (..),
  )
where

import Control.Monad (unless)
import Data.Bifunctor (first)
import Data.List (sort, sortOn)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge

-- | The rows of every table. Lengths are in millimetres.
data Relation = Relation
  { sheetRow :: SheetRow,
    objectRows :: [ObjectName],
    vertexRows :: [VertexRow],
    faceRows :: [Face],
    cornerRows :: [CornerRow],
    edgeRows :: [EdgeRow],
    layingRows :: [LayingRow],
    cellRows :: [CellRow]
  }
  deriving stock (Eq, Show)

-- | The array and the distances between its symbols; there is one such row.
data SheetRow = SheetRow
  { sheetShape :: Shape,
    sheetPitch :: Pitch
  }
  deriving stock (Eq, Show)

-- | A vertex of an object; key: object and name.
data VertexRow = VertexRow
  { vertexObject :: ObjectName,
    vertexName :: VertexName,
    vertexPoint :: Point
  }
  deriving stock (Eq, Ord, Show)

-- | A vertex of a face, numbered from 0 at the face's upper left, counter-clockwise seen from
-- outside; key: face and number.
data CornerRow = CornerRow
  { cornerFace :: Face,
    cornerNumber :: Natural,
    cornerVertex :: VertexName
  }
  deriving stock (Eq, Ord, Show)

-- | An edge of an object, its two vertices and its two faces; key: object, start and end.
data EdgeRow = EdgeRow
  { edgeObject :: ObjectName,
    edgeVertices :: (VertexName, VertexName),
    -- | to the left and to the right of who walks from the first vertex to the second outside
    edgeFaces :: (FaceName, FaceName)
  }
  deriving stock (Eq, Ord, Show)

-- | A face on the array, from the vertex at which its frame begins: where its block's upper left
-- cell lies, the rows and columns of the block, where that begins on the face, and the width and
-- height of the box round the face; key: face.
data LayingRow = LayingRow
  { layingFace :: Face,
    layingAt :: (Natural, Natural),
    layingGrid :: (Natural, Natural),
    layingAnchor :: Anchor,
    layingExtent :: Spot
  }
  deriving stock (Eq, Ord, Show)

-- | A cell of the array that a face has, and its row and column within the face's block; keys: the
-- cell; the face and the row and column within its block.
data CellRow = CellRow
  { cellOnArray :: (Natural, Natural),
    cellFace :: Face,
    cellOnFace :: (Natural, Natural)
  }
  deriving stock (Eq, Ord, Show)

-- | The tables, by the names that the database gives them.
data Table
  = MetadataTable
  | ObjectTable
  | VertexTable
  | FaceTable
  | CornerTable
  | EdgeTable
  | LayingTable
  | CellTable
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | Why rows are no placement.
data RelationError
  = -- | the object's vertices and corners make no solid
    NotSolid ObjectName Defect
  | -- | the layings make no placement
    NotPlaced PlacementError
  | -- | the rows of this table are not those that the others imply
    RowsDisagree Table
  deriving stock (Eq, Show)

-- | All rows of a placement.
relation :: Placement -> Relation
relation place =
  Relation
    { sheetRow = SheetRow (placementShape place) (placementPitch place),
      objectRows = map solidName objects,
      vertexRows =
        [ VertexRow (solidName object) vertex point
          | object <- objects,
            (vertex, point) <- solidVertices object
        ],
      faceRows = faces,
      cornerRows =
        [ CornerRow face number vertex
          | face <- faces,
            (number, vertex) <- zip [0 ..] (faceVertices (faceName face))
        ],
      edgeRows =
        [ EdgeRow (solidName object) (edgeStart edge, edgeEnd edge) (edgeLeft edge, edgeRight edge)
          | object <- objects,
            edge <- solidEdges object
        ],
      layingRows =
        [ LayingRow
            (laidFace laid)
            (row at, column at)
            (rows grid, columns grid)
            (laidAnchor laid)
            (laidExtent laid)
          | laid <- laidFaces place,
            let at = laidAt laid; grid = laidGrid laid
        ],
      cellRows = concatMap cellsOf (laidFaces place)
    }
  where
    objects = placementSolids place
    faces = [Face (solidName object) face | object <- objects, face <- solidFaces object]

cellsOf :: LaidFace -> [CellRow]
cellsOf laid =
  [ CellRow (row (laidAt laid) + r, column (laidAt laid) + c) (laidFace laid) (r, c)
    | Position r c <- blockCells (laidBlock laid)
  ]

-- | The placement that the rows describe. Objects, vertices, faces and layings keep their order,
-- that of other rows says nothing. Refuses rows that make no solids, no placement, or that are not
-- exactly those of the placement that they make.
placementOf :: Relation -> Either RelationError Placement
placementOf given = do
  objects <- traverse object (objectRows given)
  built <-
    first
      NotPlaced
      (placement (sheetShape sheet) (sheetPitch sheet) objects (map laying (layingRows given)))
  let implied = relation built
      agree :: Ord row => Table -> (Relation -> [row]) -> Either RelationError ()
      agree table part =
        unless (sort (part given) == sort (part implied)) (Left (RowsDisagree table))
  agree ObjectTable objectRows
  agree VertexTable vertexRows
  agree FaceTable faceRows
  agree CornerTable cornerRows
  agree EdgeTable edgeRows
  agree LayingTable layingRows
  agree CellTable cellRows
  pure built
  where
    sheet = sheetRow given
    object named =
      first
        (NotSolid named)
        ( solid
            ( Description
                named
                [(vertexName r, vertexPoint r) | r <- vertexRows given, vertexObject r == named]
                [walk face | face <- faceRows given, faceObject face == named]
            )
        )
    walk face =
      FaceName
        ( map
            cornerVertex
            (sortOn cornerNumber (filter ((== face) . cornerFace) (cornerRows given)))
        )
    laying r =
      Laying
        { layFace = layingFace r,
          layAt = uncurry Position (layingAt r),
          layAnchor = layingAnchor r,
          layBlock =
            blockOf
              (uncurry Shape (layingGrid r))
              (Map.findWithDefault [] (layingFace r) taken)
        }
    taken =
      Map.fromListWith
        (++)
        [(cellFace r, [uncurry Position (cellOnFace r)]) | r <- cellRows given]
