-- | What can be wrong with a polyhedron.
module PraTactile.Object.Defect
  ( Kind (..),
    kindName,
    Defect (..),
    Unexamined (..),
  )
where

import PraTactile.Object.Description

-- | What is wrong. A face is well formed if it has three vertices or more, each once, and each by a
-- name that one vertex has.
data Kind
  = -- | there is no face at all
    NoFaces
  | -- | several vertices have this name
    RepeatedName
  | -- | these vertices are the same point
    CoincidentVertices
  | -- | no face names this vertex
    UnusedVertex
  | -- | the face names a vertex that the object has not got
    UnknownVertex
  | -- | the face has fewer than three vertices
    TooFewVertices
  | -- | the face visits the vertex twice
    VertexTwiceOnFace
  | -- | these faces have the same vertices
    RepeatedFace
  | -- | the area vector of the face is zero, as where its vertices lie on a line
    NoArea
  | -- | the vertices of the face do not lie in a plane; measured is the furthest vertex from the
    -- plane of the face's area vector through its mean
    NotPlanar
  | -- | two sides of the face share more than a vertex at which one follows the other; located are
    -- the ends of the first side that does with one before it, and of the first of those
    FaceCrossesItself
  | -- | the faces that have a side between these vertices are not two
    EdgeWithoutTwoFaces
  | -- | the first vertex lies between the two others, which a side of a face joins
    VertexOnEdge
  | -- | both faces walk from the first vertex to the second, so one of them is clockwise seen from
    -- outside
    FacesDisagree
  | -- | the faces at this vertex are more than one ring
    PinchedVertex
  | -- | a piece inside an odd number of others must be inward, any other outward, and this one,
    -- located by its first face, is not
    InsideOut
  | -- | the faces share more than vertices and sides that both name; measured are the furthest two
    -- points that they share and may not, 0 for one point
    FacesIntersect
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | What the kind is called in JSON.
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

-- | One thing that is wrong: what, where, and by how many millimetres where that can be measured.
data Defect = Defect
  { defectKind :: Kind,
    defectFaces :: [FaceName],
    defectVertices :: [VertexName],
    defectMeasure :: Maybe Double
  }
  deriving stock (Eq, Show)

-- | A kind that was not looked for everywhere, since defects of these other kinds leave it without
-- meaning where they are, or so many of its own were found that no more are looked for.
data Unexamined = Unexamined
  { unexaminedKind :: Kind,
    unexaminedBecause :: [Kind]
  }
  deriving stock (Eq, Show)
