{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Random objects with felt points of a face, for the laws of poses.
module PraTactile.Conformance.Laws.Lying
  ( Lying (..),
    lyingForm,
    lying,
    smallerLying,
    noisy,
  )
where

import Data.List (nub)
import PraTactile.Conformance.Laws.Faces
import PraTactile.Conformance.Operations.Objects (feltForm)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (Codec)
import qualified PraTactile.Format.Json.Codec as Codec
import PraTactile.Format.Pose (motionCodec)
import PraTactile.Object.Description (Point (..))
import PraTactile.Pose (RigidMotion (..))
import Test.QuickCheck

-- | A felt face, and the motion by which it was made.
data Lying = Lying
  { lyingFelt :: Felt,
    lyingMotion :: RigidMotion
  }

lyingForm :: Codec Lying
lyingForm =
  Codec.object $
    Lying
      <$> Codec.key "felt" feltForm lyingFelt
      <*> Codec.key "motion" motionCodec lyingMotion

-- | A staircase-shaped face, moved in the robot's plane and in space by rational rotations.
lying :: Gen Lying
lying = do
  corners <- map (\(x, y) -> (10 * x, 10 * y)) <$> staircase (chooseInteger (1, 12))
  (c, s) <- elements [(1, 0), (3 / 5, 4 / 5), (-5 / 13, 12 / 13), (0, -1), (-8 / 17, -15 / 17)]
  (tx, ty) <- (,) <$> far <*> far
  count <- chooseInt (2, 8)
  points <- vectorOf count ((,) <$> (fromInteger <$> chooseInteger (0, 20)) <*> chooseFive)
  twice <- frequency [(3, pure []), (1, (: []) <$> elements points)]
  turned <- rotation
  shift <- (,,) <$> far <*> far <*> far
  sd <- elements [0.05, 0.4, 1.5]
  inWorld <-
    frequency
      [(1, pure Nothing), (1, Just <$> ((,) <$> rotation <*> ((,,) <$> far <*> far <*> far)))]
  let onPlane (x, y) = (tx + c * x - s * y, ty + s * x + c * y)
      inObject p = transposed turned `on` (p `less` shift)
      felt = (if length (nub points) < 2 then [(0, 0), (50, 5)] else points) ++ twice
      truth = case inWorld of
        Nothing -> (turned, shift)
        Just (p, d) -> (p `after` turned, (p `on` shift) `more` d)
  pure
    Lying
      { lyingFelt =
          Felt
            [point (inObject (x, y, 0)) | corner <- corners, let (x, y) = onPlane corner]
            [(double2 q, double2 (onPlane q)) | q <- felt]
            sd
            (motion <$> inWorld),
        lyingMotion = motion truth
      }
  where
    far = fromInteger <$> chooseInteger (-400, 400)
    chooseFive = (* 5) . fromInteger <$> chooseInteger (0, 20)
    point (x, y, z) = Point x y z
    double2 (x, y) = (fromRational x, fromRational y)
    motion (rows', (x, y, z)) =
      RigidMotion
        [map fromRational [a, b, c] | (a, b, c) <- listed rows']
        (map fromRational [x, y, z])
    listed (a, b, c) = [a, b, c]
    (a, b, c) `less` (d, e, f) = (a - d, b - e, c - f)
    (a, b, c) `more` (d, e, f) = (a + d, b + e, c + f)
    (a, b, c) `dot` (d, e, f) = a * d + b * e + c * f
    (a, b, c) `on` v = (a `dot` v, b `dot` v, c `dot` v)
    transposed ((a, b, c), (d, e, f), (g, h, i)) = ((a, d, g), (b, e, h), (c, f, i))
    p `after` m = let (a, b, c) = transposed m in transposed (p `on` a, p `on` b, p `on` c)

-- | The rotation of a quaternion of four small integers.
rotation :: Gen (Vector3, Vector3, Vector3)
rotation = do
  (a, b, c, d) <- ((,,,) <$> part <*> part <*> part <*> part) `suchThat` (/= (0, 0, 0, 0))
  let n = a * a + b * b + c * c + d * d
      over (x, y, z) = (x / n, y / n, z / n)
  pure
    ( over (a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
      over (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
      over (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d)
    )
  where
    part = fromInteger <$> chooseInteger (-4, 4)

-- | Adds errors of at most half a millimetre along each axis.
noisy :: Felt -> Gen Felt
noisy felt = do
  errors <- vectorOf (2 * length (feltSeen felt)) ((/ 16) . fromIntegral <$> chooseInt (-8, 8))
  pure felt {feltSeen = zipWith moved2 (feltSeen felt) (pairs errors)}
  where
    moved2 (q, (x, y)) (dx, dy) = (q, (x + dx, y + dy))
    pairs (x : y : others) = (x, y) : pairs others
    pairs _ = []

-- | The face with one felt point removed, in all ways that leave two points.
smallerLying :: Lying -> [Lying]
smallerLying it =
  [ it {lyingFelt = felt {feltSeen = before ++ drop 1 after}}
    | length seen > 2,
      (before, after) <- map (`splitAt` seen) [0 .. length seen - 1]
  ]
  where
    felt = lyingFelt it
    seen = feltSeen felt
