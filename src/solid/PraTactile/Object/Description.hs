{-# LANGUAGE GeneralizedNewtypeDeriving #-}

-- | The description of a polyhedron as people write it: named vertices in millimetres, and faces
-- named by their vertices (section II.B of the paper, figure 6). Nothing is checked here;
-- "PraTactile.Object.Validity" finds defects.
module PraTactile.Object.Description
  ( -- * Names
    ObjectName (..),
    VertexName (..),
    FaceName (..),
    faceText,
    readFaceName,
    sameFace,
    sameVertices,

    -- * Points
    Point (..),

    -- * Descriptions
    Description (..),

    -- * Walking round a face
    rotations,
    cyclicPairs,
  )
where

import Data.List (inits, sort, tails)
import Data.String (IsString)

-- | The name of an object, such as @cube@.
newtype ObjectName = ObjectName {objectText :: String}
  deriving stock (Show)
  deriving newtype (Eq, Ord, IsString)

-- | The name of a vertex, such as @C1@; unique within its object.
newtype VertexName = VertexName {vertexText :: String}
  deriving stock (Show)
  deriving newtype (Eq, Ord, IsString)

-- | The name of a face: its vertices from the upper left one, counter-clockwise as seen from
-- outside. So the name of a quadrilateral reads upper left, lower left, lower right, upper right.
newtype FaceName = FaceName {faceVertices :: [VertexName]}
  deriving stock (Show)
  deriving newtype (Eq, Ord)

-- | A face's name as the paper writes it.
--
-- >>> faceText (readFaceName "C1 C2  C3 C4")
-- "C1 C2 C3 C4"
faceText :: FaceName -> String
faceText = unwords . map vertexText . faceVertices

-- | The inverse of 'faceText'. Any words are accepted, since a name means something only for a
-- solid.
readFaceName :: String -> FaceName
readFaceName = FaceName . map VertexName . words

-- | Whether two names walk the same cycle, wherever each starts.
--
-- >>> sameFace (readFaceName "C1 C2 C3 C4") (readFaceName "C3 C4 C1 C2")
-- True
sameFace :: FaceName -> FaceName -> Bool
sameFace (FaceName a) (FaceName b) = a `elem` rotations b

-- | Whether two names have the same vertices, in any order.
sameVertices :: FaceName -> FaceName -> Bool
sameVertices (FaceName a) (FaceName b) = sort a == sort b

-- | A point in millimetres, in a right-handed frame: x to the right, y away from the viewer, z up.
-- It is rational, so that planarity and ties between corners can be decided exactly.
data Point = Point
  { pointX :: !Rational,
    pointY :: !Rational,
    pointZ :: !Rational
  }
  deriving stock (Eq, Ord, Show)

-- | A polyhedron as written, not yet checked.
data Description = Description
  { describedName :: ObjectName,
    describedVertices :: [(VertexName, Point)],
    describedFaces :: [FaceName]
  }
  deriving stock (Eq, Show)

-- | All rotations of a cycle, itself first.
--
-- >>> rotations "abc"
-- ["abc","bca","cab"]
rotations :: [a] -> [[a]]
rotations [] = [[]]
rotations walk = take (length walk) (zipWith (++) (tails walk) (inits walk))

-- | Every element of a cycle with its successor.
--
-- >>> cyclicPairs "abc"
-- [('a','b'),('b','c'),('c','a')]
cyclicPairs :: [a] -> [(a, a)]
cyclicPairs walk = zip walk (drop 1 walk ++ take 1 walk)
