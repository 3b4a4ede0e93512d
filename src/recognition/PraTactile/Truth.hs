-- | An answer and the truth, where the truth is known: are they the same place? The truth is a
-- region of a face, the answer a window's centre; what compares them is the point of the composite
-- at which the window's centre was seen.
module PraTactile.Truth
  ( Truth (..),
    truePlace,
    truePose,
    truthFrom,
    Claim (..),
    scaledTruth,
    scaledClaim,
    Difference (..),
    compared,
  )
where

import Control.Monad (guard)
import Data.Maybe (isNothing)
import PraTactile.Explore
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge (sameFace)
import PraTactile.Pose (RigidMotion, betweenFrames, faceFrameOf, objectMotion)
import PraTactile.Sensor (Bend (..))
import PraTactile.Sensor.Frame (Motion (..), inverse, movePoint)
import PraTactile.Symmetry (Symmetry, degreesClockwise)

-- | Where an exploration was.
data Truth = Truth
  { truthFace :: Face,
    truthRegion :: Region,
    -- | the region's upper left corner in the robot's coordinates, millimetres
    truthOrigin :: (Double, Double),
    -- | the cylinder that the face was wrapped on; places are then in arc length
    truthBend :: Maybe Bend
  }
  deriving stock (Eq, Show)

-- | The place on the true face, in millimetres right of and below its upper left vertex, of a point
-- in the robot's coordinates.
truePlace :: Truth -> (Double, Double) -> (Double, Double)
truePlace truth (x, y) = movePoint (regionMotion (truthRegion truth)) (x - originX, y - originY)
  where
    (originX, originY) = truthOrigin truth

-- | The true motion from the object's frame to the robot's, by the objects as they are laid.
-- 'Nothing' where they have no such face, and of one that was bent: then it is no rigid motion.
truePose :: Placement -> Truth -> Maybe RigidMotion
truePose layout truth = do
  guard (isNothing (truthBend truth))
  whole <- placementObject layout (faceObject (truthFace truth))
  frame <- faceFrameOf whole (faceName (truthFace truth))
  let back = inverse (regionMotion (truthRegion truth))
      (originX, originY) = truthOrigin truth
      moved = back {motionX = motionX back + originX, motionY = motionY back + originY}
  Just (objectMotion frame moved)

-- | The truth with its face begun at the vertex at which this name of it begins, as far as places
-- go: a bend keeps the axis that it had. Unchanged where it is not the same face.
truthFrom :: Placement -> Face -> Truth -> Truth
truthFrom layout named truth = case frameBetween layout (truthFace truth) named of
  Just motion | named /= truthFace truth -> truth {truthFace = named, truthRegion = moved motion}
  _ -> truth
  where
    moved motion = movedRegion motion (truthRegion truth)

-- | From the frame of a face as one name begins it to that of the same face as another does.
-- 'Nothing' where these are two faces.
frameBetween :: Placement -> Face -> Face -> Maybe Motion
frameBetween layout from@(Face object name) to@(Face object' name')
  | from == to = Just (Motion 0 0 0)
  | otherwise = do
    guard (object == object' && sameFace name name')
    whole <- placementObject layout object
    betweenFrames <$> faceFrameOf whole name <*> faceFrameOf whole name'

-- | What an answer says.
data Claim = Claim
  { claimFace :: Face,
    -- | the rotation of the face in the robot's frame
    claimSymmetry :: Symmetry,
    -- | a point in millimetres right of and below the face's upper left vertex
    claimPlace :: (Double, Double),
    -- | the same point in the robot's coordinates, millimetres
    claimSeenAt :: (Double, Double),
    -- | by how many degrees the face is turned clockwise, if it says so to the degree
    claimAngle :: Maybe Double
  }
  deriving stock (Eq, Show)

-- | A truth with all its lengths in millimetres times a number; its region has as many taxels.
scaledTruth :: Double -> Truth -> Truth
scaledTruth k truth =
  truth
    { truthRegion =
        region {regionRight = k * regionRight region, regionDown = k * regionDown region},
      truthOrigin = (k * x, k * y),
      truthBend = (\bend -> bend {bendRadius = k * bendRadius bend}) <$> truthBend truth
    }
  where
    region = truthRegion truth
    (x, y) = truthOrigin truth

-- | A claim with all its lengths times a number.
scaledClaim :: Double -> Claim -> Claim
scaledClaim k claim =
  claim {claimPlace = times (claimPlace claim), claimSeenAt = times (claimSeenAt claim)}
  where
    times (x, y) = (k * x, k * y)

-- | How an answer is wrong.
data Difference
  = -- | on another face
    OtherFace
  | -- | on the face, but turned otherwise
    OtherWayUp
  | -- | this many millimetres away on the face, half a cell or more along one of its sides
    Elsewhere Double
  deriving stock (Eq, Show)

-- | How many millimetres the answer is from the truth, given the objects as they are laid; or in
-- what it is wrong. Either may begin the face at any of its vertices. The answer must name the
-- quarter turn nearest to the true rotation, or where two are nearly as near, to 5 degrees, either:
-- the one that was measured. Windows lie a whole cell apart at least, so that less than half a cell
-- is the error of the measurement.
compared :: Placement -> Truth -> Claim -> Either Difference Double
compared layout truth claim = do
  motion <- maybe (Left OtherFace) Right (frameBetween layout (truthFace truth) (claimFace claim))
  let (x, y) = movePoint (inverse motion) (claimPlace claim)
      (trueX, trueY) = truePlace truth (claimSeenAt claim)
      (dx, dy) = (x - trueX, y - trueY)
      distance = sqrt (dx * dx + dy * dy)
      -- By how many degrees the quarter turn claimed differs from the true rotation, 0 to 180.
      apart = abs (turn - 360 * fromInteger (round (turn / 360)))
      turn =
        degreesClockwise (claimSymmetry claim)
          + motionRotation motion
          - regionTurn (truthRegion truth)
  if apart > 45 + atTheBorder
    then Left OtherWayUp
    else
      if abs dx < half pitchRight && abs dy < half pitchDown
        then Right distance
        else Left (Elsewhere distance)
  where
    half side = fromRational (side (placementPitch layout)) / 2
    atTheBorder = 5
