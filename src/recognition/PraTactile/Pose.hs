{-# OPTIONS_HADDOCK hide #-}

-- | The pose of an object: the rigid motion from the object's frame to the robot's, from the places
-- where symbols of one of its faces were seen.
--
-- = Frames
--
-- The robot's frame is right-handed: x and y point right and down in the frames, and z points away
-- from the sensor, into the face. The face's frame is right-handed too. With the walk v_0 .. v_m
-- around the face and the outward normal n, it is
--
-- > X = (v_m - v_0) / |v_m - v_0|       Z = -n / |n|       Y = Z x X
--
-- so X points right, Y down, and Z into the object, as seen from outside. The sensor touches the
-- face from outside, so both planes are seen from the same side. Hence a point q of the face,
-- measured from v_0, is at
--
-- > p = t + R(a) q,      R(a) = | cos a  -sin a |
-- >                             | sin a   cos a |
-- in the robot's plane, by a proper rotation. A point v of the object is at
--
-- > R v + T,      R = Rz(a) [X Y Z]^T,      T = (t, 0) - R v_0.
--
-- = The fit
--
-- Symbol i, at q_i on the face, was seen at p_i with covariance S_i. The most probable (t, a)
-- minimises the sum of e_i^T S_i^-1 e_i with e_i = p_i - t - R(a) q_i. For a pivot c in the robot's
-- plane, small changes of the motion are p -> p + d + b J (p - c), where J is the right-angle turn
-- from x to y. So
--
-- > A_i = [ 1 | J (t + R(a) q_i - c) ]        M = sum A_i^T S_i^-1 A_i
-- > (d, b) = M^-1 sum A_i^T S_i^-1 e_i        (Gauss and Newton)
--
-- and M^-1 is the covariance of (d, b). If c is the weighted centroid of the p_i and every S_i is a
-- multiple of the identity, M is diagonal.
--
-- = Errors in common
--
-- "PraTactile.Pose.Alignment" includes the frames' errors in its equations. If only symbols' places
-- are known, the symbols share the robot's errors. Let N frames, registered to each other, have
-- independent position errors of standard deviation s along each axis. Then their mean error, s /
-- sqrt N, remains. With rotation errors of standard deviation r, the mean rotation error r / sqrt N
-- about the centre of what was touched remains too. With c at that centre,
--
-- > C = M^-1 + diag (s^2 / N, s^2 / N, r^2 / N).
--
-- = In space
--
-- The truth is exp([w]) R and T + u for errors (u, w). Only the plane was touched, so w = (0, 0,
-- b). Since (d, b) takes p to p + d + b J (p - c),
--
-- > (u, w) = G (d, b),      G = | 1  0  -(T_y - c_y) |
-- >                             | 0  1    T_x - c_x  |
-- >                             | 0  0       0       |
-- >                             | 0  0       0       |
-- >                             | 0  0       0       |
-- >                             | 0  0       1       |
--
-- and the covariance is G C G^T, of rank 3. If the motion (P, s) takes the robot's frame to the
-- world, the pose in the world is (P R, P T + s), and P rotates both u and w of its covariance.
module PraTactile.Pose
  ( -- * In the plane of the face
    Seen (..),
    PlaneFit (..),
    rigidFit,
    nudged,
    moreError,
    onRobot,

    -- * In space
    RigidMotion (..),
    faceFrame,
    faceFrameOf,
    betweenFrames,
    objectMotion,
    thenMotion,
    movedBy,
    scaledMotion,
    Pose (..),
    poseOf,
    thenPose,

    -- * Differences
    poseDifference,
    poseApart,
    poseDistance,
  )
where

import Data.List (transpose)
import PraTactile.Geometry (rotated, toDegrees, toRadians)
import PraTactile.Object.WingedEdge
  ( FaceName,
    Point (..),
    Solid,
    cornerPoints,
    outwardNormal,
  )
import PraTactile.Pose.Matrix
import PraTactile.Sensor.Frame (Motion (..), movePoint)

-- | A point of the face, the place where it was seen, and the covariance of that place; in
-- millimetres.
data Seen = Seen
  { -- | the point in the face's frame
    seenOnFace :: !(Double, Double),
    -- | the place in the robot's plane
    seenByRobot :: !(Double, Double),
    -- | the covariance of the place, with two rows and two columns, in square millimetres
    seenCovariance :: !Matrix
  }
  deriving stock (Eq, Show)

-- | How a face lies in the robot's plane.
data PlaneFit = PlaneFit
  { -- | from the face's frame to the robot's plane
    fitMotion :: !Motion,
    -- | the point of the robot's plane about which the angle's error rotates
    fitPivot :: !(Double, Double),
    -- | the covariance of (x, y, angle) about the pivot, in mm and radians: three rows
    fitCovariance :: !Matrix
  }
  deriving stock (Eq, Show)

-- | The most probable motion from the face's frame to the robot's plane. 'Nothing' if no two points
-- differ, or a covariance has no inverse.
rigidFit :: [Seen] -> Maybe PlaneFit
rigidFit seen = do
  weights <- traverse (inverse . seenCovariance) seen
  (motion, pivot) <- start seen (map weight weights)
  go (20 :: Int) pivot weights motion
  where
    -- One weight for each point: the mean of its information along the axes.
    weight information = sum [line !! i | (i, line) <- zip [0 ..] information] / 2
    go n pivot weights motion = do
      covariance <- inverse (total [(transpose a `times` w) `times` a | (a, w, _) <- terms])
      let step = covariance `applied` foldr (zipWith (+)) [0, 0, 0] gradients
          gradients = [transpose a `applied` (w `applied` e) | (a, w, e) <- terms]
          next = nudged pivot step motion
      if n <= 1 || all ((< 1e-13) . abs) step
        then Just (PlaneFit next pivot covariance)
        else go (n - 1) pivot weights next
      where
        terms =
          [ (slopes pivot at, w, difference (seenByRobot s) at)
            | (s, w) <- zip seen weights,
              let at = movePoint motion (seenOnFace s)
          ]
    total = foldr plus (diagonal [0, 0, 0])
    difference (x, y) (x', y') = [x - x', y - y']

-- | The derivative of a point of the robot's plane by (x, y, angle) about a pivot.
slopes :: (Double, Double) -> (Double, Double) -> Matrix
slopes (cx, cy) (x, y) = [[1, 0, cy - y], [0, 1, x - cx]]

-- | A motion followed by a small step (x, y, angle in radians) about a pivot.
nudged :: (Double, Double) -> [Double] -> Motion -> Motion
nudged (cx, cy) step (Motion r x y) = case step of
  [dx, dy, b] ->
    let (u, v) = rotated (toDegrees b) (x - cx, y - cy)
     in Motion (r + toDegrees b) (cx + u + dx) (cy + v + dy)
  _ -> Motion r x y

-- | The least-squares motion if each point has a single weight, and the weighted centroid of the
-- places where the points were seen. 'Nothing' if no two points differ.
start :: [Seen] -> [Double] -> Maybe (Motion, (Double, Double))
start seen weights
  | length seen < 2 || spread <= 0 = Nothing
  | otherwise = Just (Motion angle (px - x) (py - y), (px, py))
  where
    (qx, qy) = centroid (map seenOnFace seen)
    (px, py) = centroid (map seenByRobot seen)
    centroid places = (mean (map fst places), mean (map snd places))
    mean values = sum (zipWith (*) weights values) / sum weights
    relative =
      [ (w, (x' - qx, y' - qy), (u - px, v - py))
        | (Seen (x', y') (u, v) _, w) <- zip seen weights
      ]
    spread = sum [w * (a * a + b * b) | (w, (a, b), _) <- relative]
    angle =
      toDegrees
        ( atan2
            (sum [w * (a * v - b * u) | (w, (a, b), (u, v)) <- relative])
            (sum [w * (a * u + b * v) | (w, (a, b), (u, v)) <- relative])
        )
    (x, y) = rotated angle (qx, qy)

-- | Adds to a fit an error that all symbols share. Arguments: its standard deviation along each
-- axis, in millimetres, and that of the angle about the pivot, in degrees.
moreError :: Double -> Double -> PlaneFit -> PlaneFit
moreError along degrees fit =
  fit
    { fitCovariance =
        fitCovariance fit `plus` diagonal [along * along, along * along, angle * angle]
    }
  where
    angle = toRadians degrees

-- | Converts a fit on a grid of taxels to the robot's plane. Arguments: millimetres per taxel; the
-- place of the grid's (0, 0) in the robot's plane; the fit.
onRobot :: Double -> (Double, Double) -> PlaneFit -> PlaneFit
onRobot k (left, top) (PlaneFit (Motion degrees x y) (cx, cy) covariance) =
  PlaneFit
    (Motion degrees (left + k * x) (top + k * y))
    (left + k * cx, top + k * cy)
    (propagated (diagonal [k, k, 1]) covariance)

-- | A rotation, by its rows, followed by a translation in millimetres.
data RigidMotion = RigidMotion
  { motionRows :: !Matrix,
    motionBy :: ![Double]
  }
  deriving stock (Eq, Show)

-- | The motion from the object's frame to a face's, given the face's vertices in the order of its
-- walk. 'Nothing' if the first vertex coincides with the last, or the face has no area.
faceFrame :: [Point] -> Maybe RigidMotion
faceFrame corners = case (corners, reverse corners) of
  (begin : _, end : _) -> do
    x <- unit (zipWith (-) (exact end) (exact begin))
    z <- unit (map negate (exact (outwardNormal corners)))
    y <- cross z x
    let rows = [x, y, z]
    Just (RigidMotion rows (map negate (rows `applied` map fromRational (exact begin))))
  _ -> Nothing
  where
    exact (Point a b c) = [a, b, c]
    -- Divided by the largest component before rounding, so that none exceeds a Double.
    unit v
      | all (== 0) v = Nothing
      | otherwise = Just (map (/ size) near)
      where
        near = map (fromRational . (/ maximum (map abs v))) v :: [Double]
        size = sqrt (sum (map (^ (2 :: Int)) near))
    cross [a, b, c] [d, e, f] = Just [b * f - c * e, c * d - a * f, a * e - b * d]
    cross _ _ = Nothing

-- | The motion from an object's frame to that of one of its faces, whose name may begin at any
-- vertex. 'Nothing' if the object has no such face.
faceFrameOf :: Solid -> FaceName -> Maybe RigidMotion
faceFrameOf whole = faceFrame . cornerPoints whole

-- | The motion between two frames of one face that begin at different vertices. Both are given by
-- their motions from the object's frame.
betweenFrames :: RigidMotion -> RigidMotion -> Motion
betweenFrames from to = case (rows, by) of
  ((c : _) : (s : _) : _, x : y : _) -> Motion (toDegrees (atan2 s c)) x y
  _ -> Motion 0 0 0
  where
    rows = motionRows to `times` transpose (motionRows from)
    by = zipWith (-) (motionBy to) (rows `applied` motionBy from)

-- | The motion from the object's frame to the robot's, given a face's 'faceFrame' and the motion
-- from that face to the robot's plane.
objectMotion :: RigidMotion -> Motion -> RigidMotion
objectMotion face (Motion degrees x y) = face `thenMotion` RigidMotion turn [x, y, 0]
  where
    turn =
      let (c, s) = rotated degrees (1, 0) in [[c, negate s, 0], [s, c, 0], [0, 0, 1]]

-- | The motion of an object whose lengths are multiplied by the number. The rotation stays.
scaledMotion :: Double -> RigidMotion -> RigidMotion
scaledMotion k (RigidMotion rows by) = RigidMotion rows (map (k *) by)

-- | How an object lies, and the errors of that.
data Pose = Pose
  { -- | from the object's frame to the robot's
    poseMotion :: !RigidMotion,
    -- | six rows: translation in mm, then rotation vector w in radians, along the robot's axes. The
    -- true rotation is exp([w]) times that of 'poseMotion'.
    poseCovariance :: !Matrix
  }
  deriving stock (Eq, Show)

-- | The pose of an object, given a face's 'faceFrame' and the fit of that face to the robot's
-- plane.
poseOf :: RigidMotion -> PlaneFit -> Pose
poseOf face (PlaneFit inPlane (cx, cy) covariance) = Pose motion (propagated moved covariance)
  where
    motion = objectMotion face inPlane
    moved = case motionBy motion of
      tx : ty : _ ->
        [[1, 0, cy - ty], [0, 1, tx - cx], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 1]]
      _ -> []

-- | The first motion followed by the second.
thenMotion :: RigidMotion -> RigidMotion -> RigidMotion
thenMotion (RigidMotion r t) (RigidMotion r' t') =
  RigidMotion (r' `times` r) (zipWith (+) t' (r' `applied` t))

-- | Where a motion takes a point.
movedBy :: RigidMotion -> [Double] -> [Double]
movedBy (RigidMotion rows by) point = zipWith (+) by (rows `applied` point)

-- | A pose in another frame, given the motion from the robot's frame to it.
thenPose :: RigidMotion -> Pose -> Pose
thenPose world (Pose motion covariance) =
  Pose (motion `thenMotion` world) (propagated (blocks (motionRows world)) covariance)
  where
    blocks rows = map (++ none) rows ++ map (none ++) rows
    none = [0, 0, 0]

-- | The difference from a pose to the true motion, which is the first argument: translation in
-- millimetres, then rotation vector in radians, along the robot's axes, as in the pose's
-- covariance.
poseDifference :: RigidMotion -> Pose -> [Double]
poseDifference (RigidMotion true by) (Pose (RigidMotion rows told) _) =
  zipWith (-) by told ++ logarithm (true `times` transpose rows)

-- | The errors of a pose: the distance in millimetres between the two places of a point of the
-- object, and the angle in degrees between the two rotations. Arguments: the true motion; the pose;
-- the point, at the place where the pose has it.
poseApart :: RigidMotion -> Pose -> [Double] -> (Double, Double)
poseApart true pose@(Pose (RigidMotion told from) _) point =
  (norm (zipWith (-) there point), toDegrees (norm (drop 3 (poseDifference true pose))))
  where
    onObject = transpose told `applied` zipWith (-) point from
    there = true `movedBy` onObject
    norm v = sqrt (sum (map (^ (2 :: Int)) v))

-- | The rotation vector of a rotation by less than 180 degrees.
logarithm :: Matrix -> [Double]
logarithm m = map (factor *) twist
  where
    twist = [at 2 1 - at 1 2, at 0 2 - at 2 0, at 1 0 - at 0 1]
    at i j = m !! i !! j
    -- Twice the sine and twice the cosine of the angle.
    sine = sqrt (sum (map (^ (2 :: Int)) twist))
    cosine = at 0 0 + at 1 1 + at 2 2 - 1
    factor = if sine < 1e-12 then 1 / 2 else atan2 sine cosine / sine

-- | The squared Mahalanobis distance from a pose to the true motion, which is the first argument,
-- with three degrees of freedom. It uses an orthonormal basis of the covariance's range. 'Nothing'
-- if the covariance does not have rank 3.
poseDistance :: RigidMotion -> Pose -> Maybe Double
poseDistance true pose = do
  -- The columns span the range; three independent ones are found by projection.
  basis <- pick [] (transpose (poseCovariance pose))
  information <- inverse (propagated basis (poseCovariance pose))
  let e = basis `applied` poseDifference true pose
  Just (sum (zipWith (*) e (information `applied` e)))
  where
    pick found columns
      | length found == 3 = Just found
      | largest <= 0 = Nothing
      | otherwise = pick (found ++ [map (/ largest) best]) (map (without best) columns)
      where
        (largest, best) = maximum [(norm c, c) | c <- columns]
    norm v = sqrt (sum (map (^ (2 :: Int)) v))
    without best c =
      let k = sum (zipWith (*) best c) / sum (map (^ (2 :: Int)) best)
       in zipWith (\x b -> x - k * b) c best
