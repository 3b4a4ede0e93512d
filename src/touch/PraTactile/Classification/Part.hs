{-# OPTIONS_HADDOCK hide #-}

-- | The most likely symbol when only a part of it was touched.
--
-- A part shows N taxels. Let d be the sum of their squared differences from a shape at a place.
-- Errors of k neighbouring taxels are taken as one, normal with unknown variance v. With Jeffreys'
-- prior on v (H. Jeffreys 1961) the likelihood of the shape at that place is
--
-- > integral of v^(-n/2) exp (-d / (2 k v)) dv / v ~ d^(-n/2),    n = N / k
--
-- The closer the shapes of an alphabet are to each other, the fewer errors turn one into another.
-- With D taxels, the alphabet's separation, k = 3500 / D^2. For the shipped alphabets k is between
-- 1.5 and 2.2.
--
-- A part may be displaced a little. So a shape's likelihood is the mean over displacements, which
-- are normal with standard deviation m = 1/4 taxel. The surface may also be flat, and with
-- probability r it is neither a symbol nor flat.
--
-- Where frames were placed by the robot's positions alone, a stroke may break between frames. With
-- s taxels, the standard deviation of the robot's error along each axis,
--
-- > m^2 = 1/16 + s^2,    k = 3500 / D^2 + 3/4 s^2,    r >= 50^(s - 1) / 1000
module PraTactile.Classification.Part
  ( estimatePart,
    partDistances,
  )
where

import Data.List (sortOn)
import Data.Ord (Down (..))
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Estimate
import PraTactile.Classification.Templates
import PraTactile.Image
import PraTactile.Segmentation (Part (..))
import PraTactile.Symmetry

-- | The posterior of each shape, in either orientation, for a part of a symbol, by the formulas
-- above. It compares with the shapes, because the network knows whole symbols only. The number is
-- the standard deviation (taxels) of the robot's position error along each axis, if the frames were
-- not registered; otherwise 0. Note [Parts]
estimatePart :: Templates -> Double -> Part -> ClassEstimate
estimatePart shapesSeen sigma part =
  ClassEstimate best [(what, chance l) | (what, l) <- likelihoods] 0
  where
    -- A flat face and an unknown surface say nothing about the class, so their probability is
    -- shared equally.
    chance l = (1 - rubbish) * (l + flatLikelihood / n) / total + rubbish / n
    taxels = V.sum (rasterValues (partSeen part))
    rubbish = nothingOfTheKind sigma taxels
    (distances, flat) = partDistances shapesSeen part
    likelihoods = map (fmap moved) distances
    moved moves = sum [misplaced move * likelihood d | (move, d) <- moves] / allMoves moves
    allMoves = sum . map (misplaced . fst)
    misplaced (x, y) = exp (negate (x * x + y * y) / (2 * (0.25 * 0.25 + sigma * sigma)))
    likelihood d = ((least + leastOff) / (d + leastOff)) ** (taxels / (2 * alike))
    alike = 3500 / (apart * apart) + 0.75 * sigma * sigma
    apart = fromIntegral (templateSeparation shapesSeen)
    leastOff = leastVariance * taxels
    flatLikelihood = likelihood flat
    best = case sortOn (Down . snd) likelihoods of
      (what, _) : _ -> what
      [] -> (0, identity)
    n = fromIntegral (length distances)
    least = minimum (flat : concatMap (map snd . snd) distances)
    total = sum (map snd likelihoods) + flatLikelihood

-- | The sums of squared differences between a part and shapes, over the observed taxels. For each
-- class, upright and turned by 180 degrees: each displacement of up to a taxel, with its sum. Then
-- the sum for a flat face.
partDistances :: Templates -> Part -> ([((Int, Symmetry), [((Double, Double), Double)])], Double)
partDistances shapesSeen part =
  ( concatMap from [identity, turned 2],
    V.sum (V.map (^ (2 :: Int)) (rasterValues (partPixels part)))
  )
  where
    from symmetry =
      [((c, symmetry), apart symmetry c) | c <- [0 .. templateCount shapesSeen - 1]]
    apart symmetry c =
      squaredDistances
        shapesSeen
        c
        (onRaster symmetry (partPixels part))
        (onRaster symmetry (partSeen part))

-- | The variance of a taxel that is assumed in any case, so that no likelihood is infinite.
leastVariance :: Double
leastVariance = 0.003

-- | r, the probability that a part shows neither a symbol nor a flat face. Arguments: the standard
-- deviation of the robot's error in taxels; the number of observed taxels. It is higher for less
-- than a third of a symbol, because frames that are registered a taxel wrong can make a part look
-- like another symbol's. It is higher still for frames that were not registered.
nothingOfTheKind :: Double -> Double -> Double
nothingOfTheKind sigma taxels =
  min 1 (max (0.001 * 50 ** (sigma - 1)) (if taxels < 32 then 0.006 else 0.001))

{- Note [Parts] The numbers k, m and the least variance, and their dependence on the robot's error,
   are close to the most likely ones for 4900 parts of 1600 presses. These presses used the sensors
   `paper`, `real` and `hard` over GF(2) to GF(9), with and without registration, and position
   errors of one to two taxels. Under each condition about as many parts are wrong as predicted. The
   most likely r would be close to 0: of 1800 parts with no other doubt none was wrong. It is kept
   higher, because parts from another sensor may be wrong (assumption). bench/calibration.py counts
   other presses; docs/results/evaluation.md has its tables. -}
