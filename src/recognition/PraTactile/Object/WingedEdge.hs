-- | Winged-edge models of polyhedra: each edge has two vertices, two faces, and on each face the
-- edge before and the edge after it (section II.B of the paper; Ballard and Brown, Computer Vision,
-- ch. 9).
module PraTactile.Object.WingedEdge
  ( -- * Describing a polyhedron
    module PraTactile.Object.Description,
    ObjectError (..),
    validate,

    -- * Solids
    Solid,
    solid,
    description,
    solidName,
    solidVertices,
    solidFaces,
    solidEdges,

    -- * Edges and wings
    Edge (..),
    EdgeName (..),
    edgeName,
    Wings (..),

    -- * Queries
    edgesOf,
    facesAt,
    neighbours,
    cornerPoints,
    outwardNormal,
  )
where

import qualified Data.Map.Strict as Map
import PraTactile.Object.Description
  ( Description (..),
    FaceName (..),
    ObjectName (..),
    Point (..),
    Side (..),
    VertexName (..),
    faceText,
    readFaceName,
    sameFace,
    sameVertices,
    sides,
  )
import PraTactile.Object.Validity (ObjectError (..), doubleArea, validate)

-- | A polyhedron that passed 'validate', with its edges derived.
data Solid = Solid
  { solidDescription :: Description,
    solidSides :: Map.Map (VertexName, VertexName) Side,
    derivedEdges :: [Edge]
  }
  deriving stock (Eq, Show)

-- | An edge is named by its two vertices, from its start to its end.
data EdgeName = EdgeName VertexName VertexName
  deriving stock (Eq, Ord, Show)

-- | An edge: its two vertices, and the two faces it separates. Seen from outside, 'edgeLeft' is on
-- the left of who walks from 'edgeStart' to 'edgeEnd', and 'edgeRight' on the right.
data Edge = Edge
  { edgeStart :: VertexName,
    edgeEnd :: VertexName,
    edgeLeft :: FaceName,
    edgeRight :: FaceName,
    edgeWings :: Wings
  }
  deriving stock (Eq, Show)

-- | The edges before and after an edge in the counter-clockwise walks round its two faces.
data Wings = Wings
  { leftPrevious :: EdgeName,
    leftNext :: EdgeName,
    rightPrevious :: EdgeName,
    rightNext :: EdgeName
  }
  deriving stock (Eq, Show)

-- | The name of an edge.
edgeName :: Edge -> EdgeName
edgeName edge = EdgeName (edgeStart edge) (edgeEnd edge)

-- | Check a description and derive its edges; refuses with the first fault that 'validate' finds.
solid :: Description -> Either ObjectError Solid
solid described = case validate described of
  fault : _ -> Left fault
  [] -> Right (Solid described bySide (deriveEdges bySide everySide))
  where
    everySide = concatMap sides (describedFaces described)
    bySide = Map.fromList [((sideStart side, sideEnd side), side) | side <- everySide]

-- An edge runs in the direction in which the walk over the faces, in their order, first meets it.
deriveEdges :: Map.Map (VertexName, VertexName) Side -> [Side] -> [Edge]
deriveEdges bySide everySide =
  [ Edge (sideStart left) (sideEnd left) (sideFace left) (sideFace right) (wings left right)
    | (left, right) <- met
  ]
  where
    order = Map.fromList (zip (map ends everySide) [0 :: Int ..])
    ends side = (sideStart side, sideEnd side)
    met =
      [ (left, right)
        | left <- everySide,
          Just right <- [Map.lookup (sideEnd left, sideStart left) bySide],
          Map.lookup (ends left) order < Map.lookup (ends right) order
      ]
    wings left right =
      Wings
        { leftPrevious = named (sideBefore left) (sideStart left),
          leftNext = named (sideEnd left) (sideAfter left),
          rightPrevious = named (sideBefore right) (sideStart right),
          rightNext = named (sideEnd right) (sideAfter right)
        }
    named a b
      | Map.lookup (a, b) order < Map.lookup (b, a) order = EdgeName a b
      | otherwise = EdgeName b a

-- | The description that the solid was built from.
description :: Solid -> Description
description = solidDescription

-- | The object's name.
solidName :: Solid -> ObjectName
solidName = describedName . solidDescription

-- | The vertices with their places in millimetres, in the order described.
solidVertices :: Solid -> [(VertexName, Point)]
solidVertices = describedVertices . solidDescription

-- | The faces, in the order described.
solidFaces :: Solid -> [FaceName]
solidFaces = describedFaces . solidDescription

-- | The edges, each once, in the order in which the walks round the faces meet them.
solidEdges :: Solid -> [Edge]
solidEdges = derivedEdges

-- | The edges of a face in the order of its walk; none if the solid has no such face.
edgesOf :: Solid -> FaceName -> [Edge]
edgesOf whole face =
  [ edge
    | face `elem` solidFaces whole,
      side <- sides face,
      edge <- derivedEdges whole,
      edgeName edge
        `elem` [EdgeName (sideStart side) (sideEnd side), EdgeName (sideEnd side) (sideStart side)]
  ]

-- | The faces at a vertex, counter-clockwise seen from outside; none if the solid has no such
-- vertex.
facesAt :: Solid -> VertexName -> [FaceName]
facesAt whole vertex = case filter ((== vertex) . sideStart) (Map.elems (solidSides whole)) of
  [] -> []
  first : _ -> sideFace first : turn first (next first)
  where
    next side = Map.lookup (sideStart side, sideBefore side) (solidSides whole)
    turn first (Just side) | side /= first = sideFace side : turn first (next side)
    turn _ _ = []

-- | The faces across the edges of a face, in the order of its walk; none if the solid has no such
-- face.
neighbours :: Solid -> FaceName -> [FaceName]
neighbours whole face =
  [if edgeLeft edge == face then edgeRight edge else edgeLeft edge | edge <- edgesOf whole face]

-- | The places of a face's vertices in the order of its name, in millimetres; none if the solid has
-- no such face.
cornerPoints :: Solid -> FaceName -> [Point]
cornerPoints whole face =
  [ point
    | face `elem` solidFaces whole,
      vertex <- faceVertices face,
      Just point <- [lookup vertex (solidVertices whole)]
  ]

-- | A vector at right angles to a face that points out of the solid, as long as twice the face's
-- area in square millimetres; zero if the solid has no such face.
outwardNormal :: Solid -> FaceName -> Point
outwardNormal whole = doubleArea . cornerPoints whole
