{-# OPTIONS_HADDOCK hide #-}

-- | The likeliest symbol of which only a part was touched.
--
-- What a part shows is N taxels. From a shape in a place they are d off, as squares added up, and
-- every k of them err alike, as one, by a normal law whose variance is not known. Any variance is
-- as likely as one of another size beforehand (H. Jeffreys 1961), so that the shape in that place
-- has the likelihood
--
-- > integral of v^(-n/2) exp (-d / (2 k v)) dv / v ~ d^(-n/2),    n = N / k
--
-- The nearer to each other shapes are, the sooner errors make another of one: with D taxels, the
-- alphabet's separation, k = 3500 / D^2, which is 1.5 for the least and 2.2 for the most of the
-- shipped alphabets.
--
-- A part may lie a little beside its place: a shape's likelihood is the mean over places, whose
-- distances are normal with the standard deviation m = 1/4 of a taxel. And what was touched may be
-- flat, or with the probability r nothing of the kind.
--
-- Where frames lie as the robot has them and nobody compared them, strokes in several of them do
-- not meet. With s taxels, the standard deviation of the robot's error along each axis,
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

-- | The estimate for a part of a symbol, by the shapes themselves, because the network knows whole
-- symbols only: of each shape, in either orientation, the posterior by the formulas above. Given
-- are the standard deviation of the robot's position error along each axis, in taxels, that is left
-- in the part because frames were not compared, or 0; and the part. Note [Parts]
estimatePart :: Templates -> Double -> Part -> Estimate
estimatePart shapesSeen sigma part = Estimate best [(what, chance l) | (what, l) <- likelihoods] 0
  where
    -- What is flat, or nothing of the kind, is any of the shapes alike.
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

-- | The sum of squared differences over the taxels seen: from each class upright, and from each
-- turned by 180 degrees, moved in each way by up to a taxel; and from a flat face.
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

-- What a taxel is off by in any case, squared: so no likelihood is infinite.
leastVariance :: Double
leastVariance = 0.003

-- The probability of an image that is nothing of the kind, where so many taxels were seen. Of less
-- than a third of a symbol, frames that were put together a taxel wrong may make another symbol;
-- those that nobody compared make anything, if they are several taxels wrong.
nothingOfTheKind :: Double -> Double -> Double
nothingOfTheKind sigma taxels =
  min 1 (max (0.001 * 50 ** (sigma - 1)) (if taxels < 32 then 0.006 else 0.001))

{- Note [Parts] The numbers k, m and the least variance, and what becomes of them with a robot's
   error, are nearly likeliest for the 4900 parts of 1600 presses by `paper`, `real` and `hard` over
   GF(2) to GF(9), compared and not, with position errors of one to two taxels; about as many of
   these parts are wrong as are told to be under each condition. Likeliest of all would be that next
   to nothing is nothing of the kind: of 1800 parts with no other doubt none was wrong (assumption:
   of another sensor some are). bench/calibration.py counts other presses; its tables stand in
   docs/results/evaluation.md. -}
