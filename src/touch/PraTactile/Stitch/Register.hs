{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 #-}
module PraTactile.Stitch.Register where

import Data.List (foldl', maximumBy, sortBy)
import qualified Data.IntMap.Strict as IntMap
import Data.IntMap.Strict (IntMap)
import Data.Ord (comparing)

import PraTactile.Image
import PraTactile.Image.Correlate
import PraTactile.Stitch.Blend

data Registration = Registration
  { registrationSigma :: !Double
  , registrationReach :: !Double
  , registrationNoise :: !Double
  , registrationSweeps :: !Int
  }

standardRegistration :: Registration
standardRegistration = Registration 1 4.5 0.1 4

type Place = (Double, Double)

-- score of evidence
evidence :: Registration -> Overlap -> Double
evidence settings (Overlap n vf vc cov)
  | n <= 0 || cov <= 0 = 0
  | otherwise = -0.5 * n * log (1 - min 0.9999 rho2)
 where
  l = registrationNoise settings * registrationNoise settings
  rho2 = cov * cov / ((vf + l) * (vc + l))

-- best displacement: prior centre, prior variance, integer radius
search :: Registration -> Patch' -> Raster -> Place -> Double -> Place -> Double
       -> (Double, Place)
search settings (Patch' ref margin) image (mx, my) var (cx, cy) radius = refine 0.5 best0
 where
  score (x, y) = evidence settings (overlapAt ref image (x + margin) (y + margin)) - ((x - mx) ^ (2::Int) + (y - my) ^ (2::Int)) / (2 * var)
  r = ceiling radius :: Int
  bx = fromIntegral (round cx :: Int)
  by = fromIntegral (round cy :: Int)
  grid = [ p | j <- [-r .. r], i <- [-r .. r], let p = (bx + fromIntegral i, by + fromIntegral j), fromIntegral (i*i+j*j) <= radius*radius + 0.5 ]
  best0 = foldl' better (-1/0, (mx, my)) grid
  better (!s, p) q = let s' = score q in if s' > s then (s', q) else (s, p)
  refine :: Double -> (Double, Place) -> (Double, Place)
  refine step b@(_, (x, y))
    | step < 0.1 = b
    | otherwise = refine (step / 2) (foldl' better b [ (x + i * step, y + j * step) | j <- [-1,0,1], i <- [-1,0,1], i /= 0 || j /= 0 ])

data Patch' = Patch' !Reference !Double

register :: Registration -> [(Place, Raster)] -> [Place]
register settings inputs = IntMap.elems (sweeps (registrationSweeps settings) initial)
 where
  frames = IntMap.fromList (zip [0 ..] inputs)
  reach = registrationReach settings
  s2 = registrationSigma settings * registrationSigma settings
  margin = fromIntegral (ceiling reach + 2 :: Int) :: Double
  size = 16 + 2 * round margin :: Int
  patchFor :: Int -> IntMap Place -> Patch'
  patchFor i ds = Patch' (either (const (referenceOf (constant 0 0 0))) id (reference sums weights)) margin
   where
    ((nx, ny), _) = frames IntMap.! i
    Patch sums weights = blend size size
      [ ((x + dx - nx + margin, y + dy - ny + margin), image)
      | (j, (dx, dy)) <- IntMap.toList ds, j /= i
      , let ((x, y), image) = frames IntMap.! j
      , abs (x + dx - nx) < 17 + margin, abs (y + dy - ny) < 17 + margin ]
  -- information
  link = IntMap.mapWithKey (\i _ -> IntMap.mapWithKey (\j _ -> if i == j then 0 else info i j) frames) frames
  info i j = let ((x,y), f) = frames IntMap.! i
                 ((x',y'), g) = frames IntMap.! j
                 o = overlapAt (referenceOf g) f (x - x') (y - y')
             in if abs (x-x') >= 16 || abs (y-y') >= 16 then 0 else overlapWeight o * sqrt (overlapImageVariance o * overlapReferenceVariance o)
  initial = case IntMap.keys frames of
    [] -> IntMap.empty
    ks -> let start = maximumBy (comparing (\i -> sum (IntMap.elems (link IntMap.! i)))) ks
          in grow (IntMap.singleton start (0,0)) (IntMap.delete start (link IntMap.! start))
  grow ds gains
    | IntMap.null gains = ds
    | otherwise =
        let (i, _) = maximumBy (comparing snd) (IntMap.toList gains)
            (mx, my, k) = meanPlace ds
            (_, d) = search settings (patchFor i ds) (snd (frames IntMap.! i)) (mx, my) (s2 * (1 + 1 / k)) (mx, my) reach
            ds' = IntMap.insert i d ds
        in grow ds' (IntMap.mapWithKey (\j g -> g + (link IntMap.! i) IntMap.! j) (IntMap.delete i gains))
  meanPlace ds = let k = fromIntegral (IntMap.size ds); (sx, sy) = foldl' (\(a,b) (x,y) -> (a+x,b+y)) (0,0) (IntMap.elems ds) in (sx / k, sy / k, k)
  sweeps :: Int -> IntMap Place -> IntMap Place
  sweeps 0 ds = centred ds
  sweeps n ds = sweeps (n - 1) (foldl' step (centred ds) (IntMap.keys frames))
   where
    radius = if n == registrationSweeps settings then reach else 1.5
    step acc i = let (_, d) = search settings (patchFor i acc) (snd (frames IntMap.! i)) (0,0) s2 (if radius > 2 then (0,0) else acc IntMap.! i) radius
                 in IntMap.insert i d acc
  centred ds = let (mx, my, _) = meanPlace ds in IntMap.map (\(x, y) -> (x - mx, y - my)) ds
