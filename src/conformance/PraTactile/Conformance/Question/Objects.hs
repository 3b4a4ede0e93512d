-- | What the questions about objects are about. No profile is known to them. Lengths are in
-- millimetres, and exact where they are fractions.
module PraTactile.Conformance.Question.Objects
  ( Mapped (..),
    Felt (..),
  )
where

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
