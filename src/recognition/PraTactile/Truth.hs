-- | Compares an answer with the known truth: are they the same place? The truth is a region of a
-- face; the answer is the centre of a window. They are compared at the point of the composite where
-- that centre was seen.
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

-- | The place of an exploration.
data Truth = Truth
  { truthFace :: Face,
    truthRegion :: ProbedRegion,
    -- | the region's upper left corner in the robot's coordinates, in millimetres
    truthOrigin :: (Double, Double),
    -- | the cylinder that the face was wrapped on, if any; places are then in arc length
    truthBend :: Maybe Bend
  }
  deriving stock (Eq, Show)

-- | The true place of a point, in millimetres right of and below the face's upper left vertex. The
-- point is in the robot's coordinates.
truePlace :: Truth -> (Double, Double) -> (Double, Double)
truePlace truth (x, y) = movePoint (regionMotion (truthRegion truth)) (x - originX, y - originY)
  where
    (originX, originY) = truthOrigin truth

-- | The true motion from the object's frame to the robot's, for objects in this placement.
-- 'Nothing' if there is no such face, or the face was bent, which is not a rigid motion.
truePose :: Placement -> Truth -> Maybe RigidMotion
truePose layout truth = do
  guard (isNothing (truthBend truth))
  whole <- placementObject layout (faceObject (truthFace truth))
  frame <- faceFrameOf whole (faceName (truthFace truth))
  let back = inverse (regionMotion (truthRegion truth))
      (originX, originY) = truthOrigin truth
      moved = back {motionX = motionX back + originX, motionY = motionY back + originY}
  Just (objectMotion frame moved)

-- | The truth with the face begun at the vertex that this name of the face begins with. Places are
-- converted; a bend keeps its axis. If the name is of another face, the truth is unchanged.
truthFrom :: Placement -> Face -> Truth -> Truth
truthFrom layout named truth = case frameBetween layout (truthFace truth) named of
  Just motion | named /= truthFace truth -> truth {truthFace = named, truthRegion = moved motion}
  _ -> truth
  where
    moved motion = movedRegion motion (truthRegion truth)

-- | The motion between the frames of one face under two names. 'Nothing' if these are different
-- faces.
frameBetween :: Placement -> Face -> Face -> Maybe Motion
frameBetween layout from@(Face object name) to@(Face object' name')
  | from == to = Just (Motion 0 0 0)
  | otherwise = do
    guard (object == object' && sameFace name name')
    whole <- placementObject layout object
    betweenFrames <$> faceFrameOf whole name <*> faceFrameOf whole name'

-- | An answer's claim.
data Claim = Claim
  { claimFace :: Face,
    -- | the rotation of the face in the robot's frame
    claimSymmetry :: Symmetry,
    -- | a point in millimetres right of and below the face's upper left vertex
    claimPlace :: (Double, Double),
    -- | the same point in the robot's coordinates, millimetres
    claimSeenAt :: (Double, Double),
    -- | the angle of the face in degrees clockwise, if the answer states it; 'compared' ignores it
    claimAngle :: Maybe Double
  }
  deriving stock (Eq, Show)

-- | A truth with all lengths in millimetres multiplied by a number. The region keeps its size in
-- taxels.
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

-- | A claim with all lengths multiplied by a number.
scaledClaim :: Double -> Claim -> Claim
scaledClaim k claim =
  claim {claimPlace = times (claimPlace claim), claimSeenAt = times (claimSeenAt claim)}
  where
    times (x, y) = (k * x, k * y)

-- | How an answer is wrong.
data Difference
  = -- | on another face
    OtherFace
  | -- | on the right face, in another orientation
    OtherWayUp
  | -- | on the right face, but this many millimetres away, which is half a cell or more along one
    -- side
    Elsewhere Double
  deriving stock (Eq, Show)

-- | The distance in millimetres between the answer and the truth, or the kind of error. Either may
-- begin the face at any of its vertices. The answer must name the quarter turn nearest to the true
-- rotation; within 5 degrees of the middle between two, either will do. Windows are at least a
-- whole cell apart, so a distance below half a cell is an error of the measurement.
compared :: Placement -> Truth -> Claim -> Either Difference Double
compared layout truth claim = do
  motion <- maybe (Left OtherFace) Right (frameBetween layout (truthFace truth) (claimFace claim))
  let (x, y) = movePoint (inverse motion) (claimPlace claim)
      (trueX, trueY) = truePlace truth (claimSeenAt claim)
      (dx, dy) = (x - trueX, y - trueY)
      distance = sqrt (dx * dx + dy * dy)
      -- The difference between the claimed quarter turn and the true rotation, in degrees, 0 to
      -- 180.
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
