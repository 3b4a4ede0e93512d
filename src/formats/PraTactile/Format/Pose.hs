{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of poses, and of the position of the robot's frame in the world.
module PraTactile.Format.Pose
  ( ObjectPose (..),
    namedPoseCodec,
    poseCodec,
    motionCodec,
    decodePlane,
  )
where

import Data.ByteString (ByteString)
import Data.List (transpose)
import PraTactile.Format.Error (FormatError, Misfit (NotMatrix, NotRotation))
import PraTactile.Format.Json.Codec
import qualified PraTactile.Format.Json.Schema as Schema
import PraTactile.Object.WingedEdge (ObjectName (..))
import PraTactile.Pose
import PraTactile.Pose.Matrix (Matrix, diagonal, times)

-- | An object and its pose.
data ObjectPose = ObjectPose
  { posedObject :: ObjectName,
    posedSo :: Pose,
    -- | the robot's frame in the world, if the pose is given in the world
    posedOn :: Maybe RigidMotion
  }
  deriving stock (Eq, Show)

-- | An object with its pose.
namedPoseCodec :: Codec ObjectPose
namedPoseCodec =
  object
    ( ObjectPose
        <$> key "object" objectName posedObject
        <*> withKeys posedSo poseKeys
        <*> optionalKey "plane" motionCodec posedOn
    )
  where
    objectName = via (\(ObjectName name) -> name) (Right . ObjectName) text

-- | A pose.
poseCodec :: Codec Pose
poseCodec = object poseKeys

poseKeys :: Keys Pose Pose
poseKeys =
  Pose <$> withKeys poseMotion motionKeys <*> key "covariance" (matrix 6) poseCovariance

-- | Reads the robot's frame in the world from a JSON text. Refuses another schema, missing keys,
-- invalid values, and a matrix that is not a rotation within 1e-6.
decodePlane :: ByteString -> Either FormatError RigidMotion
decodePlane = decodeWith (schemaKey "pra-tactile/plane/1" *> motionKeys)

-- | A rigid motion. Refuses a matrix that is not a rotation within 1e-6.
motionCodec :: Codec RigidMotion
motionCodec = object motionKeys

motionKeys :: Keys RigidMotion RigidMotion
motionKeys =
  RigidMotion
    <$> key "rotation" rotation motionRows
    <*> key "translation_mm" translation motionBy
  where
    rotation =
      withSchema
        ( Schema.Named "rotation"
            . Schema.Described "The rows of a matrix that turns and does not mirror."
        )
        (satisfying isRotation NotRotation (matrix 3))
    translation =
      withSchema
        (Schema.Named "translation" . Schema.Described "Along x, y and z, millimetres.")
        (ofLength 3 (satisfying ((== 3) . length) (NotMatrix 1 3) (listOf real)))

-- | A square matrix with the given number of rows.
matrix :: Int -> Codec Matrix
matrix n = ofLength n (satisfying whole (NotMatrix n n) (listOf (ofLength n (listOf real))))
  where
    whole rows = length rows == n && all ((== n) . length) rows

-- | Adds a length to the schema of a list.
ofLength :: Int -> Codec [a] -> Codec [a]
ofLength n = withSchema $ \schema -> case schema of
  Schema.List _ item -> Schema.listOfLength n item
  other -> other

-- | Whether a 3 x 3 matrix is a rotation without mirroring.
isRotation :: Matrix -> Bool
isRotation rows =
  and (zipWith near (concat (rows `times` transpose rows)) (concat (diagonal [1, 1, 1])))
    && determinant > 0
  where
    near a b = abs (a - b) <= 1e-6
    determinant = case rows of
      [[a, b, c], [d, e, f], [g, h, i]] ->
        a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
      _ -> 0
