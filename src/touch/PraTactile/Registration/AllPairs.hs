{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Many frames registered by all their pairs together, whatever they show: each pair that
-- overlaps, diagonal ones too, says how likely every displacement of its frames against each other
-- is, and the robot's error how likely each of these is. A pair that is wrong is outvoted, for it
-- denies nothing to the others.
--
-- The cost is that of the pairs, of which each frame has at most @mostPairs@ of its own choice.
module PraTactile.Registration.AllPairs
  ( Pairwise (..),
    registerPairwise,
    comparedPixels,
  )
where

import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import qualified Data.Vector as Boxed
import PraTactile.Composite.Blend (Taxels, minus)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Image (Raster, rasterHeight, rasterWidth)
import PraTactile.Registration.AllPairs.Field
import PraTactile.Registration.AllPairs.Pair
import PraTactile.Registration.Joint.Estimate (Estimate (..))
import PraTactile.Registration.Joint.Grid
import PraTactile.Registration.Model (eighth)
import PraTactile.Registration.Neighbours (Neighbours (..), neighbours)
import PraTactile.Registration.Posterior
import PraTactile.Registration.Search (Registration)

-- | Frames put together by their pairs.
data Pairwise = Pairwise
  { -- | Where each frame is, in their order. The displacements have mean 0, since a shift common to
    -- all cannot be seen.
    pairwiseFrames :: [Estimate],
    -- | The standard deviation of the robot's position error, taxels, where pairs tell it.
    pairwiseSigma :: Maybe Double
  }

-- | Frames registered from the nominal places (taxels) of their upper left pixels.
registerPairwise :: Registration -> [(Taxels, Raster)] -> Pairwise
registerPairwise settings frames = Pairwise (zipWith estimated fields places) sigma
  where
    pairs = map (pairOf settings nodes) (compared frames)
    nodes = Boxed.fromList (map nodeOf frames)
    fields = pairwiseField settings [rest place | (place, _) <- frames] pairs
    told = foldMap momentsOf fields
    sigma
      | null pairs = Nothing
      | otherwise =
        let shares = sigmaShares grid (squaresAbout told)
         in Just (exp (sum (zipWith (*) shares (map log (gridSigmas grid)))) / gridSpacing)
    grid = gridOf settings
    places =
      between settings told nodes pairs $
        [(place, probabilityAround field place) | field <- fields, let place = likeliest field]
    n = fromIntegral (max 1 (length places))
    mean part = sum (map part places) / n
    less (x, y) = (eighth (x - mean fst), eighth (y - mean snd))
    estimated field place =
      Estimate
        { estimateShift = less place,
          estimateDeviation = deviations field,
          estimateProbability = probabilityAround field place,
          estimateOthers =
            take
              2
              [ h {hypothesisShift = less (hypothesisShift h)}
                | h <- hypotheses 5 0.001 field,
                  let (x, y) = hypothesisShift h,
                  max (abs (x - fst place)) (abs (y - snd place)) >= 2
              ],
          estimateElsewhere = []
        }

-- | The pairs that are compared: those that share at least a fifth of a frame, as diagonal ones
-- have whose steps are half a frame; of each frame's pairs at most 'mostPairs', evenly.
compared :: [(Taxels, Raster)] -> [Neighbours]
compared frames = [pair | (n, pair) <- numbered, n `IntSet.member` chosen]
  where
    numbered = zip [0 ..] [pair | pair <- neighbours frames, neighboursShare pair >= 0.2]
    chosen = IntSet.fromList (concatMap (spacedOut mostPairs) (IntMap.elems ofEach))
    ofEach =
      IntMap.fromListWith
        (flip (++))
        [ (k, [n])
          | (n, Neighbours first second _ _) <- numbered,
            k <- [first, second]
        ]

-- | The most pairs that a frame chooses: as many as it has where steps are half a frame.
mostPairs :: Int
mostPairs = 8

-- | In how many pixels 'registerPairwise' compares frames, at all displacements of its grid.
comparedPixels :: Registration -> [(Taxels, Raster)] -> Int
comparedPixels settings frames = sum (map pixels (compared frames))
  where
    pixels pair = displacements * ceiling (neighboursShare pair * fromIntegral area)
    area = maximum (1 : [rasterWidth image * rasterHeight image | (_, image) <- frames])
    displacements = length [() | y <- line, x <- line, within reach (x, y)]
    line = [negate reach .. reach]
    reach = pairReach settings

-- | Displacements between grid points, from the likeliest ones on these and how probable each is
-- there: those that fit the pairs best by least squares. What a pair says is the highest place of L
-- near where its frames lie, and how steeply L falls from there, as far as both frames are there.
between ::
  Registration -> Moments -> Boxed.Vector Node -> [Pair] -> [(Taxels, Double)] -> [Taxels]
between settings told nodes pairs start = zip (solved fst) (solved snd)
  where
    places = Boxed.fromList (map fst start)
    probable = Boxed.fromList (map snd start)
    count = length start
    around = byFrame count (concatMap springs pairs)
    springs (Pair k l _ _) =
      [ (l, (k, weight, e)),
        (k, (l, weight, (negate ex, negate ey)))
      ]
      where
        weight = (certain * wx, certain * wy)
        certain = probable Boxed.! k * probable Boxed.! l
        (e@(ex, ey), (wx, wy)) = peak settings nodes (k, l) apart
        apart = (places Boxed.! l) `minus` (places Boxed.! k)
    -- Each frame in turn is where its pairs and the robot have it in the mean.
    solved part =
      let from = IntMap.fromList (zip [0 ..] (map (part . fst) start))
       in IntMap.elems (iterate (sweep part) from !! mostSteps)
    sweep part now = foldl' (\at k -> IntMap.insert k (mean part at k) at) now [0 .. count - 1]
    mean part at k = along / weight
      where
        (weight, along) = foldl' add (robot, robot * part common) (around Boxed.! k)
        add (!w, !t) (l, ws, e) =
          let v = part ws in (w + v, t + v * (IntMap.findWithDefault 0 l at + part e))
    robot = robotPrecision (gridOf settings) told
    common = let Moments n x y _ = told in (x / (n * gridSpacing), y / (n * gridSpacing))

-- | How often least squares look at each frame.
mostSteps :: Int
mostSteps = 40
