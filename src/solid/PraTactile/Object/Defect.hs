-- | The kinds of defects of a polyhedron.
module PraTactile.Object.Defect
  ( Kind (..),
    kindName,
    Defect (..),
    Unexamined (..),
  )
where

import PraTactile.Object.Description

-- | The kinds of defects. A face is well formed if it has at least three vertices, each once, and
-- each by a name that exactly one vertex has.
data Kind
  = -- | there are no faces
    NoFaces
  | -- | several vertices have this name
    RepeatedName
  | -- | these vertices are at the same point
    CoincidentVertices
  | -- | no face names this vertex
    UnusedVertex
  | -- | the face names a vertex that does not exist
    UnknownVertex
  | -- | the face has fewer than three vertices
    TooFewVertices
  | -- | the face visits the vertex twice
    VertexTwiceOnFace
  | -- | these faces have the same vertices
    RepeatedFace
  | -- | the area vector of the face is zero, for example because its vertices lie on a line
    NoArea
  | -- | the vertices of the face do not lie in a plane. The measure is the largest distance of a
    -- vertex from the plane with the face's area vector through its mean.
    NotPlanar
  | -- | two sides of the face meet other than in a common vertex. The vertices are the ends of the
    -- first side that meets an earlier one, and of the first such earlier side.
    FaceCrossesItself
  | -- | the number of faces with a side between these vertices is not two
    EdgeWithoutTwoFaces
  | -- | the first vertex lies between the two others, which a side of a face joins
    VertexOnEdge
  | -- | both faces walk from the first vertex to the second, so one of them is clockwise as seen
    -- from outside
    FacesDisagree
  | -- | the faces at this vertex make more than one ring
    PinchedVertex
  | -- | the piece with this first face is oriented wrongly. A piece inside an odd number of others
    -- must be inward, any other outward.
    InsideOut
  | -- | the faces meet other than in vertices and sides that both name. The measure is the largest
    -- distance between two such common points, 0 for a single one.
    FacesIntersect
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The name of a kind in JSON.
--
-- >>> kindName FaceCrossesItself
-- "face-crosses-itself"
kindName :: Kind -> String
kindName kind = case kind of
  NoFaces -> "no-faces"
  RepeatedName -> "repeated-name"
  CoincidentVertices -> "coincident-vertices"
  UnusedVertex -> "unused-vertex"
  UnknownVertex -> "unknown-vertex"
  TooFewVertices -> "too-few-vertices"
  VertexTwiceOnFace -> "vertex-twice-on-face"
  RepeatedFace -> "repeated-face"
  NoArea -> "no-area"
  NotPlanar -> "not-planar"
  FaceCrossesItself -> "face-crosses-itself"
  EdgeWithoutTwoFaces -> "edge-without-two-faces"
  VertexOnEdge -> "vertex-on-edge"
  FacesDisagree -> "faces-disagree"
  PinchedVertex -> "pinched-vertex"
  InsideOut -> "inside-out"
  FacesIntersect -> "faces-intersect"

-- | A defect: its kind, its place, and its size in millimetres if it can be measured.
data Defect = Defect
  { defectKind :: Kind,
    defectFaces :: [FaceName],
    defectVertices :: [VertexName],
    defectMeasure :: Maybe Double
  }
  deriving stock (Eq, Show)

-- | A kind that was not checked everywhere. Either defects of the other kinds make it meaningless
-- in places, or so many of its own kind were found that the search stopped.
data Unexamined = Unexamined
  { unexaminedKind :: Kind,
    unexaminedBecause :: [Kind]
  }
  deriving stock (Eq, Show)
