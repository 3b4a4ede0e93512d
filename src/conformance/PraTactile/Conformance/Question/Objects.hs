-- | What the questions about objects are about. No profile is known to them. Lengths are in
-- millimetres, and exact where they are fractions.
module PraTactile.Conformance.Question.Objects
  ( -- * Asked
    Mapped (..),
    Felt (..),
    Plate (..),

    -- * Answered
    Unfolded (..),
    Plated (..),
  )
where

import Numeric.Natural (Natural)
import PraTactile.Array (Shape)
import PraTactile.Format.Placement (Drawing)
import PraTactile.Object.Description (Description, Point)
import PraTactile.Pose (RigidMotion)

-- | Faces of objects on an array.
data Mapped = Mapped
  { -- | the array's rows and columns
    mappedShape :: Shape,
    -- | the distances from one symbol to the next, along a row and along a column
    mappedPitch :: (Rational, Rational),
    mappedObjects :: [Description],
    mappedLayings :: [Drawing]
  }
  deriving stock (Eq, Show)

-- | Points of a face as they were felt.
data Felt = Felt
  { -- | where the face's vertices are in the object's frame, in the order of its walk
    feltCorners :: [Point],
    -- | each point in the face's frame, and where the robot felt it
    feltSeen :: [((Double, Double), (Double, Double))],
    -- | the standard deviation of where a point was felt, along each axis
    feltError :: Double,
    -- | where the robot's frame lies in the world; in its own where nothing is said
    feltPlane :: Maybe RigidMotion
  }
  deriving stock (Eq, Show)

-- | A face to be embossed as a plate.
data Plate = Plate
  { -- | where the face's vertices are, in the order of its walk
    plateCorners :: [Point],
    -- | the side of a taxel of the symbols, and the height to which they are raised
    plateTaxel :: Rational,
    plateThickness :: Rational,
    -- | 12 rows of 8 taxels each, @#@ for one that is raised and @.@ for one that is not
    plateShapes :: [[String]],
    -- | rows of cells 16 taxels wide and 20 high, centred on the box round the corners: which shape
    -- stands in the middle of each, by its place among the shapes, if any does
    plateSymbols :: [[Maybe Natural]]
  }
  deriving stock (Eq, Show)

-- | In how many ways a solid can be unfolded.
data Unfolded = Unfolded
  { unfoldedTrees :: Natural,
    -- | how many of these overlap, and how many nets there are, where one may be turned over and
    -- where none may; 'Nothing' of more than 10^5 unfoldings
    unfoldedNets :: Maybe (Natural, Natural, Natural)
  }
  deriving stock (Eq, Show)

-- | A plate that was made.
data Plated = Plated
  { -- | r and s of r + sqrt s, cubic millimetres; s is 0 where the root is a fraction
    platedVolume :: (Rational, Rational),
    -- | the corners, sides and triangles of its surface
    platedVertices :: Natural,
    platedEdges :: Natural,
    platedFaces :: Natural
  }
  deriving stock (Eq, Show)
