{-# OPTIONS_HADDOCK hide #-}

-- | The pose of an object from felt points of a face, in closed form.
--
-- With e = v_m - v_0 of the walk and the outward normal n, the face's axes are
--
-- > X = e / |e|        Z = -n / |n|        Y = Z x X
--
-- Let N points q_i of the face be felt at p_i, with independent errors of standard deviation s
-- along each axis. The most probable motion p = t + R(a) q of the plane maps the mean of the q_i to
-- the mean of the p_i, and rotates by
--
-- > tan a = sum (q_i x p_i) / sum (q_i . p_i)        (both from their means)
--
-- Its error variances about the mean c of the p_i are s^2 / N along each axis and s^2 / sum |q_i|^2
-- in the angle, and the errors are independent. A point v of the object is at R v + T with
--
-- > R = Rz(a) [X Y Z]^T        T = (t, 0) - R v_0
--
-- An error (u, v, b) about c is an error of T by (u - b (T_y - c_y), v + b (T_x - c_x), 0) and a
-- rotation by (0, 0, b). If the robot's frame lies in the world by (P, d), P rotates all of these,
-- and d is added to T.
module PraTactile.Conformance.Definition.Pose
  ( poseOf,
  )
where

import Data.List (nub, transpose)
import PraTactile.Conformance.Definition.Solid (cyclicPairs, flatFace)
import PraTactile.Conformance.Question
import PraTactile.Object.Description (Point (..))
import PraTactile.Pose (Pose (..), RigidMotion (..))

-- | The most probable pose of an object, with its covariance, from felt points of a face.
poseOf :: Felt -> Either Refusal Pose
poseOf (Felt corners seen sd plane)
  | not (flatFace corners) = Left (Refusal "impossible-face")
  | length (nub (map fst seen)) < 2 = Left (Refusal "undetermined")
  | otherwise = Right (Pose (RigidMotion inWorld (zipWith (+) by (p `on` translation))) covariance)
  where
    (p, by) =
      maybe
        ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0])
        (\m -> (motionRows m, motionBy m))
        plane
    -- The face's axes, from exact vectors.
    points = [[along, into, up] | Point along into up <- corners]
    from = map (\v -> zipWith (-) v (head points)) points
    x = unit (last from)
    z = unit (map negate (foldr (zipWith (+) . uncurry cross) [0, 0, 0] (cyclicPairs from)))
    y = cross z x
    -- The motion in the plane.
    n = fromIntegral (length seen)
    mean f = (sum (map (fst . f) seen) / n, sum (map (snd . f) seen) / n)
    (q0, c) = (mean fst, mean snd)
    moved = [(less q q0, less r c) | (q, r) <- seen]
    a =
      atan2
        (sum [q1 * r2 - q2 * r1 | ((q1, q2), (r1, r2)) <- moved])
        (sum [q1 * r1 + q2 * r2 | ((q1, q2), (r1, r2)) <- moved])
    turn = [[cos a, negate (sin a), 0], [sin a, cos a, 0], [0, 0, 1]]
    -- The motion in space.
    rotation = turn `by3` [x, y, z]
    translation =
      zipWith
        (-)
        (zipWith (-) [fst c, snd c, 0] (turn `on` [fst q0, snd q0, 0]))
        (rotation `on` map fromRational (head points))
    inWorld = p `by3` rotation
    -- The error: each column is the effect of an error along x, along y, and in the angle.
    columns =
      [ [1, 0, 0, 0, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [negate (translation !! 1 - snd c), head translation - fst c, 0, 0, 0, 1]
      ]
    variances =
      [sd * sd / n, sd * sd / n, sd * sd / sum [q1 * q1 + q2 * q2 | ((q1, q2), _) <- moved]]
    worldly v = (p `on` take 3 v) ++ (p `on` drop 3 v)
    covariance =
      foldr
        (zipWith (zipWith (+)))
        (replicate 6 (replicate 6 0))
        [[[k * u * w | w <- worldly v] | u <- worldly v] | (k, v) <- zip variances columns]
    less (u, v) (u', v') = (u - u', v - v')

on :: [[Double]] -> [Double] -> [Double]
on m v = [sum (zipWith (*) line v) | line <- m]

by3 :: [[Double]] -> [[Double]] -> [[Double]]
by3 m k = [[sum (zipWith (*) line column) | column <- transpose k] | line <- m]

cross :: Num n => [n] -> [n] -> [n]
cross [x, y, z] [u, v, w] = [y * w - z * v, z * u - x * w, x * v - y * u]
cross _ _ = []

-- | The vector scaled to length 1. Its largest part is made 1 exactly, before rounding.
unit :: [Rational] -> [Double]
unit v = map (/ long) small
  where
    small = map (fromRational . (/ maximum (map abs v))) v
    long = sqrt (sum (map (^ (2 :: Int)) small))
