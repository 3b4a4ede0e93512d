-- | Faces of solids laid on the cells of the array, checked (section II.B of the paper, figure 8):
-- each face takes a block of cells of its own, upright, and the block's grid of symbols is centred
-- on the face.
module PraTactile.Object.Placement.Laying
  ( -- * What is laid where
    Pitch (..),
    Face (..),
    Laying (..),

    -- * Placements
    Placement,
    PlacementError (..),
    placement,
    placementShape,
    placementPitch,
    placementSolids,
    LaidFace (..),
    laidFaces,

    -- * Spots on a face
    Spot (..),
    spotMillimetres,
    faceSpots,
  )
where

import Control.Monad (unless)
import Data.Foldable (find)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Vector (exactRoot)
import PraTactile.Object.WingedEdge

-- | The distances in millimetres from one symbol to the next, along a row and along a column.
data Pitch = Pitch
  { pitchRight :: !Rational,
    pitchDown :: !Rational
  }
  deriving stock (Eq, Show)

-- | A face of an object.
data Face = Face
  { faceObject :: ObjectName,
    faceName :: FaceName
  }
  deriving stock (Eq, Ord, Show)

-- | The wish to lay a face: its upper left cell goes to 'layAt' of the array, and it takes
-- 'layGrid' cells.
data Laying = Laying
  { layFace :: Face,
    layAt :: Position,
    layGrid :: Shape
  }
  deriving stock (Eq, Show)

-- | A spot on a face in millimetres from the face's upper left vertex, to the right and down, seen
-- from outside.
data Spot = Spot
  { spotRight :: !Rational,
    spotDown :: !Rational
  }
  deriving stock (Eq, Ord, Show)

-- | A spot as the nearest machine numbers, (right, down) in millimetres, for output.
--
-- >>> spotMillimetres (Spot (127 / 5) (127 / 4))
-- (25.4,31.75)
spotMillimetres :: Spot -> (Double, Double)
spotMillimetres (Spot right down) = (fromRational right, fromRational down)

-- | A face as it lies: its block of cells, its extent, and the margin from its upper left vertex to
-- the block's upper left corner, in millimetres.
data LaidFace = LaidFace
  { laidFace :: Face,
    laidAt :: Position,
    laidGrid :: Shape,
    laidExtent :: Spot,
    laidMargin :: Spot
  }
  deriving stock (Eq, Show)

-- | Faces on an array, no two on one cell; built by 'placement' only.
data Placement = Placement
  { -- | the rows and columns of the array
    placementShape :: Shape,
    -- | the distances between symbols
    placementPitch :: Pitch,
    -- | the objects, in the order given
    placementSolids :: [Solid],
    -- | the faces, in the order given
    laidFaces :: [LaidFace]
  }
  deriving stock (Eq, Show)

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
  | -- | a grid is laid on rectangles only, with sides that are rational numbers of millimetres
    NotRectangular Face
  | -- | the face is laid on two blocks of cells
    FaceLaidTwice Face
  | -- | the face has no cells on the array
    FaceNotLaid Face
  | -- | the face's block has no cells
    EmptyGrid Face Shape
  | -- | the block needs more millimetres than the face has: needed, then there
    GridLargerThanFace Face Spot Spot
  | -- | the block at this cell, of this shape, sticks out of the array's sheet
    OutsideArray Face Position Shape
  | -- | both faces claim these cells
    FacesOverlap Face Face [Position]
  | -- | the face's block has no such cell
    CellOffFace Face Position
  deriving stock (Eq, Show)

-- | Lay faces on an array of the given shape. Refuses with the first fault, in the order of the
-- constructors of 'PlacementError' for each face, and then of any two faces.
placement :: Shape -> Pitch -> [Solid] -> [Laying] -> Either PlacementError Placement
placement shape between objects layings = do
  unless (rows shape > 0 && columns shape > 0) (Left (EmptyArray shape))
  unless (pitchRight between > 0 && pitchDown between > 0) (Left (PitchNotPositive between))
  none [RepeatedObject a | (a, b) <- pairs (map solidName objects), a == b]
  laid <- traverse (lay shape between objects) layings
  none [FaceLaidTwice a | (a, b) <- pairs (map laidFace laid), a == b]
  none
    [ FacesOverlap (laidFace a) (laidFace b) cells
      | (a, b) <- pairs laid,
        let cells = shared a b,
        not (null cells)
    ]
  pure (Placement shape between objects laid)
  where
    none = mapM_ Left . take 1

lay :: Shape -> Pitch -> [Solid] -> Laying -> Either PlacementError LaidFace
lay shape between objects (Laying face at grid) = do
  object <-
    maybe
      (Left (UnknownObject (faceObject face)))
      Right
      (find ((== faceObject face) . solidName) objects)
  checkName object face
  extent <-
    maybe (Left (NotRectangular face)) Right (rectangle (cornerPoints object (faceName face)))
  unless (rows grid > 0 && columns grid > 0) (Left (EmptyGrid face grid))
  let needed =
        Spot
          (fromIntegral (columns grid) * pitchRight between)
          (fromIntegral (rows grid) * pitchDown between)
  unless
    (spotRight needed <= spotRight extent && spotDown needed <= spotDown extent)
    (Left (GridLargerThanFace face needed extent))
  unless
    (row at + rows grid <= rows shape && column at + columns grid <= columns shape)
    (Left (OutsideArray face at grid))
  let margin =
        Spot ((spotRight extent - spotRight needed) / 2) ((spotDown extent - spotDown needed) / 2)
  pure (LaidFace face at grid extent margin)

checkName :: Solid -> Face -> Either PlacementError ()
checkName object face
  | faceName face `elem` solidFaces object = Right ()
  | otherwise = Left (maybe (UnknownFace face) (WrongVertexOrder face) meant)
  where
    meant = find (sameVertices (faceName face)) (solidFaces object)

rectangle :: [Point] -> Maybe Spot
rectangle [upperLeft, lowerLeft, lowerRight, upperRight]
  | lowerRight `minus` lowerLeft == across,
    dot across down == 0 =
    Spot <$> size across <*> size down
  where
    across = upperRight `minus` upperLeft
    down = lowerLeft `minus` upperLeft
    size side = exactRoot (dot side side)
rectangle _ = Nothing

-- | The difference of two points, and the scalar product.
minus :: Point -> Point -> Point
minus (Point a b c) (Point d e f) = Point (a - d) (b - e) (c - f)

dot :: Point -> Point -> Rational
dot (Point a b c) (Point d e f) = a * d + b * e + c * f

pairs :: [a] -> [(a, a)]
pairs [] = []
pairs (first : others) = [(first, other) | other <- others] ++ pairs others

shared :: LaidFace -> LaidFace -> [Position]
shared a b =
  [ Position r c
    | r <- common row rows,
      c <- common column columns
  ]
  where
    common from size =
      let begin = max (from (laidAt a)) (from (laidAt b))
          end = min (from (laidAt a) + size (laidGrid a)) (from (laidAt b) + size (laidGrid b))
       in takeWhile (< end) [begin ..]

-- | The four vertices of a laid face with their spots on it, in the order of the face's name.
faceSpots :: LaidFace -> [(VertexName, Spot)]
faceSpots laid =
  zip
    (faceVertices (faceName (laidFace laid)))
    [Spot 0 0, Spot 0 down, Spot right down, Spot right 0]
  where
    Spot right down = laidExtent laid
