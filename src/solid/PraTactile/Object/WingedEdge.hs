-- | Winged-edge models of polyhedra. Each edge has two vertices and two faces, and on each face the
-- edges before and after it (section II.B of the paper; Ballard and Brown, Computer Vision, ch. 9).
module PraTactile.Object.WingedEdge
  ( -- * Describing a polyhedron
    module PraTactile.Object.Description,
    module PraTactile.Object.Defect,
    examineDescription,

    -- * Solids
    Solid,
    solid,
    solidOf,
    solidMesh,
    scaledSolid,
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
    walkNamed,
    sameCorners,
    cornerPoints,
    outwardNormal,
  )
where

import Data.List (find, sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe, maybeToList)
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Defect
import PraTactile.Object.Description
  ( Description (..),
    FaceName (..),
    ObjectName (..),
    Point (..),
    VertexName (..),
    faceText,
    readFaceName,
    sameFace,
    sameVertices,
  )
import PraTactile.Object.Mesh
import PraTactile.Object.Surface
import PraTactile.Object.Validity
import PraTactile.Object.Vector

-- | A valid polyhedron with its edges. A side is an edge as the walk around one of its two faces
-- passes it; vertices, faces and sides are numbered from 0.
data Solid = Solid
  { -- | the polyhedron, with vertices and faces by their numbers
    solidMesh :: Mesh,
    solidSurface :: FaceSides,
    -- | the number of each vertex
    vertexIndices :: Map.Map VertexName Int,
    -- | for each vertex, the sides that begin there
    sidesFrom :: V.Vector [Int]
  }

instance Eq Solid where
  a == b = solidMesh a == solidMesh b

instance Show Solid where
  showsPrec depth whole =
    showParen (depth > 10) (showString "Solid " . showsPrec 11 (description whole))

-- | The name of an edge: its two vertices, from start to end.
data EdgeName = EdgeName VertexName VertexName
  deriving stock (Eq, Ord, Show)

-- | An edge: its two vertices, and the two faces that it separates. As seen from outside, for
-- someone who walks from 'edgeStart' to 'edgeEnd', 'edgeLeft' is on the left and 'edgeRight' on the
-- right.
data Edge = Edge
  { edgeStart :: VertexName,
    edgeEnd :: VertexName,
    edgeLeft :: FaceName,
    edgeRight :: FaceName,
    edgeWings :: Wings
  }
  deriving stock (Eq, Show)

-- | The edges before and after an edge in the counter-clockwise walks around its two faces.
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

-- | The report on a description.
examineDescription :: Description -> Report
examineDescription = examine . fromDescription

-- | The solid with this description. Refuses what 'solidOf' refuses.
solid :: Description -> Either Defect Solid
solid = solidOf . fromDescription

-- | The solid of a polyhedron. Refuses, with the first defect, a polyhedron in which 'examine'
-- finds defects; then one whose faces intersect ('intersecting').
solidOf :: Mesh -> Either Defect Solid
solidOf it = case reportDefects report ++ maybeToList (intersecting report) of
  defect : _ -> Left defect
  [] ->
    Right
      Solid
        { solidMesh = it,
          solidSurface = sides,
          vertexIndices = Map.fromList [(vertexAt it v, v) | v <- [0 .. vertices - 1]],
          sidesFrom =
            V.accum
              (flip (:))
              (V.replicate vertices [])
              [(sideStart sides s, s) | s <- [sideCount sides - 1, sideCount sides - 2 .. 0]]
        }
  where
    report = examine it
    walks = meshWalks it
    vertices = V.length (meshPoints it)
    sides = surface walks

-- | The description of the solid.
description :: Solid -> Description
description = toDescription . solidMesh

-- | The solid with all lengths multiplied by a number, which must be positive; this is not checked.
scaledSolid :: Rational -> Solid -> Solid
scaledSolid k whole = whole {solidMesh = scaledBy k (solidMesh whole)}

-- | The object's name.
solidName :: Solid -> ObjectName
solidName = meshName . solidMesh

-- | The vertices with their places in millimetres, in the order of the description.
solidVertices :: Solid -> [(VertexName, Point)]
solidVertices = describedVertices . description

-- | The faces, in the order of the description.
solidFaces :: Solid -> [FaceName]
solidFaces = describedFaces . description

-- | The edges, each once, in the order in which the walks around the faces meet them. Each has the
-- direction in which it is met first.
solidEdges :: Solid -> [Edge]
solidEdges whole =
  [ edgeAlong whole s t
    | s <- [0 .. sideCount (solidSurface whole) - 1],
      Just t <- [mateOf (solidSurface whole) s],
      s < t
  ]

-- | The edge with these two sides, in the direction of the first one, whose face is on its left.
edgeAlong :: Solid -> Int -> Int -> Edge
edgeAlong whole left right =
  Edge
    { edgeStart = vertex (sideStart sides left),
      edgeEnd = vertex (sideEnd sides left),
      edgeLeft = face left,
      edgeRight = face right,
      edgeWings =
        Wings
          { leftPrevious = wing (previousSide sides left),
            leftNext = wing (nextSide sides left),
            rightPrevious = wing (previousSide sides right),
            rightNext = wing (nextSide sides right)
          }
    }
  where
    sides = solidSurface whole
    vertex = vertexAt (solidMesh whole)
    face = faceAt (solidMesh whole) . sideFace sides
    wing side = EdgeName (vertex (sideStart sides first)) (vertex (sideEnd sides first))
      where
        first = maybe side (min side) (mateOf sides side)

-- | The edges of a face in the order of its name, which may begin at any vertex. Empty if the solid
-- has no such face.
edgesOf :: Solid -> FaceName -> [Edge]
edgesOf whole face =
  [ edgeAlong whole (min s t) (max s t)
    | s <- sidesOf whole face,
      Just t <- [mateOf (solidSurface whole) s]
  ]

-- | The faces at a vertex, counter-clockwise as seen from outside. Empty if the solid has no such
-- vertex.
facesAt :: Solid -> VertexName -> [FaceName]
facesAt whole vertex =
  [ faceAt (solidMesh whole) (sideFace sides s)
    | leaving <- maybe [] (\v -> [sidesFrom whole V.! v]) (Map.lookup vertex (vertexIndices whole)),
      first <- take 1 (sortOn (vertexAt (solidMesh whole) . sideEnd sides) leaving),
      s <- take (length leaving) (turning first)
  ]
  where
    sides = solidSurface whole
    turning s = s : maybe [] turning (mateOf sides (previousSide sides s))

-- | The faces across the edges of a face, in the order of its name, which may begin at any vertex.
-- Empty if the solid has no such face.
neighbours :: Solid -> FaceName -> [FaceName]
neighbours whole face =
  [ faceAt (solidMesh whole) (sideFace (solidSurface whole) t)
    | s <- sidesOf whole face,
      Just t <- [mateOf (solidSurface whole) s]
  ]

-- | The walk for a face's name, which may begin at any of its vertices. 'Nothing' if the solid has
-- no such face.
walkNamed :: Solid -> FaceName -> Maybe Walk
walkNamed whole name = case sidesOf whole name of
  [] -> Nothing
  sides -> Just (U.fromList (map (sideStart (solidSurface whole)) sides))

-- | The name, as in the description, of the face with these vertices in any order; 'Nothing' if the
-- solid has no such face.
sameCorners :: Solid -> FaceName -> Maybe FaceName
sameCorners whole name =
  listToMaybe
    [ faceAt (solidMesh whole) (sideFace (solidSurface whole) s)
      | sides@(s : _) <- sidesFromFirst whole name,
        fmap sort (verticesNamed whole name)
          == Just (sort (map (sideStart (solidSurface whole)) sides))
    ]

-- | The sides of a face in the order of its name, which may begin at any vertex. Empty if the solid
-- has no such face.
sidesOf :: Solid -> FaceName -> [Int]
sidesOf whole name =
  concat (find ((== verticesNamed whole name) . Just . vertices) (sidesFromFirst whole name))
  where
    vertices = map (sideStart (solidSurface whole))

-- | The indices of a name's vertices; 'Nothing' unless all exist.
verticesNamed :: Solid -> FaceName -> Maybe [Int]
verticesNamed whole = traverse (`Map.lookup` vertexIndices whole) . faceVertices

-- | For each face at the name's first vertex, its sides in the order of its walk from there.
sidesFromFirst :: Solid -> FaceName -> [[Int]]
sidesFromFirst whole name =
  [ s : takeWhile (/= s) (drop 1 (iterate (nextSide (solidSurface whole)) s))
    | first : _ <- [faceVertices name],
      Just v <- [Map.lookup first (vertexIndices whole)],
      s <- sidesFrom whole V.! v
  ]

-- | The places of a face's vertices, in millimetres, in the order of its name, which may begin at
-- any of them. Empty if the solid has no such face.
cornerPoints :: Solid -> FaceName -> [Point]
cornerPoints whole =
  map (pointAt (solidMesh whole) . sideStart (solidSurface whole))
    . sidesOf whole

-- | A normal of a face with these corners, in the order of its walk. As seen from the side to which
-- it points, they are counter-clockwise. Its length is twice the face's area in square millimetres.
outwardNormal :: [Point] -> Point
outwardNormal corners = Point (part a) (part b) (part c)
  where
    (over, points) = overOne corners
    V3 a b c = doubleArea points
    part n = n % over ^ (2 :: Int)
