-- | The inputs of questions about objects. They need no profile. Lengths are in millimetres;
-- fractions are exact.
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
  { -- | the shape of the array
    mappedShape :: Shape,
    -- | the distances of neighbouring symbols, along a row and along a column
    mappedPitch :: (Rational, Rational),
    mappedObjects :: [Description],
    mappedLayings :: [Drawing]
  }
  deriving stock (Eq, Show)

-- | Felt points of a face.
data Felt = Felt
  { -- | the places of the face's vertices in the object's frame, in the order of its walk
    feltCorners :: [Point],
    -- | each point in the face's frame, and the place where the robot felt it
    feltSeen :: [((Double, Double), (Double, Double))],
    -- | the standard deviation of a felt place along each axis
    feltError :: Double,
    -- | the robot's frame in the world; 'Nothing' for a pose in the robot's frame
    feltPlane :: Maybe RigidMotion
  }
  deriving stock (Eq, Show)
