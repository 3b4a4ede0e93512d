{-# LANGUAGE BangPatterns #-}

-- | Many frames registered by all their pairs together, whatever they show: each pair that
-- overlaps, diagonal ones too, says by its images alone where the second may lie, and the
-- displacements are those that fit all pairs and the robot's error best. Pairs that are wrong come
-- to count for nothing.
module PraTactile.Registration.AllPairs
  ( registerPairwise,
    Link (..),
    solved,
  )
where

import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import qualified Data.Vector as Boxed
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster, rasterSize)
import PraTactile.Registration.Model (eighth)
import PraTactile.Registration.Neighbours (Neighbours (..), neighbours)
import PraTactile.Registration.Pair.Blind (blindPosterior)
import PraTactile.Registration.Pair.Straight (alongStraight)
import PraTactile.Registration.Posterior
import PraTactile.Registration.Search (Registration, supposedSigma)
import PraTactile.Registration.Spectrum

-- | What the pair of two frames, by their numbers, says: by how much the second's displacement
-- exceeds the first's, in a few hypotheses with their probabilities.
data Link = Link !Int !Int ![Hypothesis]
  deriving stock (Eq, Show)

-- | The displacement of each image, x and y in taxels, given the tables by the images' width and
-- height and the nominal places (taxels) of their upper left pixels; and the standard deviation of
-- each along either axis. The mean of the displacements is 0.
registerPairwise ::
  Registration -> ((Int, Int) -> Spectra) -> [(Taxels, Raster)] -> [(Taxels, Double)]
registerPairwise settings tables frames = map less placed
  where
    links = concatMap (linkOf settings tables (Boxed.fromList (map snd frames))) pairs
    pairs = [pair | pair <- neighbours frames, neighboursShare pair >= leastShare]
    placed = IntMap.elems (solved (supposedSigma settings) (length frames) links)
    n = fromIntegral (max 1 (length placed))
    mean part = sum (map (part . fst) placed) / n
    less ((x, y), sd) = ((eighth (x - mean fst), eighth (y - mean snd)), sd)

-- | The least share of a frame that an overlap must have: a quarter, as diagonal ones have whose
-- steps are half a frame.
leastShare :: Double
leastShare = 0.2

-- | What a pair says; nothing if its frames differ in size.
linkOf ::
  Registration -> ((Int, Int) -> Spectra) -> Boxed.Vector Raster -> Neighbours -> [Link]
linkOf settings tables images (Neighbours k l step@(x, y) _)
  | rasterSize a /= rasterSize b = []
  | otherwise = [Link k l (map relative (hypotheses 4 0.02 found))]
  where
    (a, b) = (images Boxed.! k, images Boxed.! l)
    known = tables (rasterSize a)
    process = processOf known 0 (map (coefficientsOf known) [a, b])
    -- The prior of a pair is normal, of half the search as standard deviation.
    search = min 12 (2 * sqrt 2 * supposedSigma settings)
    found = alongStraight step search (a, b) (blindPosterior known process step search (a, b))
    relative g = let (u, v) = hypothesisShift g in g {hypothesisShift = (u - x, v - y)}

-- | The displacements that fit best, with their standard deviations, of that many frames with
-- errors of that standard deviation: each in turn the mean of what its pairs and the prior say,
-- each hypothesis weighed by how well it fits, first generously, then ever more strictly.
solved :: Double -> Int -> [Link] -> IntMap (Taxels, Double)
solved sigma count links = foldl' sweep start (concatMap (replicate 6) [2, 1.4, 1, 0.7, 0.5])
  where
    start = IntMap.fromList [(k, ((0, 0), sigma)) | k <- [0 .. count - 1]]
    -- By frame: the other one of a pair, and what is to be added to its displacement.
    around =
      IntMap.fromListWith (++) $
        concat
          [ [ (l, [(k, [(p, e) | Hypothesis e p <- found])]),
              (k, [(l, [(p, (-x, -y)) | Hypothesis (x, y) p <- found])])
            ]
            | Link k l found <- links
          ]
    sweep now width = foldl' (update width) now [0 .. count - 1]
    update width now k = IntMap.insert k (meanOf width now k) now
    meanOf width now k =
      let (here, _) = at now k
          terms = concatMap (termsOf width now here) (IntMap.findWithDefault [] k around)
          (total, x, y) = foldl' added (1 / (sigma * sigma), 0, 0) terms
       in ((x / total, y / total), sqrt (1 / total))
    added (!t, !x, !y) (m, (u, v)) = (t + m, x + m * u, y + m * v)
    at now k = IntMap.findWithDefault ((0, 0), sigma) k now
    termsOf width now here (other, hypotheses') =
      [(share / total / (width * width), place) | (share, place) <- shares]
      where
        ((ox, oy), _) = at now other
        shares = [(p * exp (negate (apart here place)), place) | (p, place) <- places]
        places = [(p, (ox + ex, oy + ey)) | (p, (ex, ey)) <- hypotheses']
        apart (x, y) (u, v) = ((x - u) * (x - u) + (y - v) * (y - v)) / (2 * width * width)
        -- A pair may be wrong altogether.
        total = sum (map fst shares) + 0.02
