{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Registers many frames by all their pairs together, whatever they show. Each overlapping pair,
-- diagonal ones too, gives a log-likelihood for every relative displacement. The robot's error is
-- the prior. A wrong pair is outvoted, since its factor is at least 1 everywhere.
--
-- The cost is proportional to the number of pairs. Each frame chooses at most @mostPairs@.
module PraTactile.Registration.AllPairs
  ( Pairwise (..),
    registerPairwise,
    pairsEvidence,
    comparedPixels,
  )
where

import Data.Foldable (fold)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import qualified Data.Vector as Boxed
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels, minus, plus)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Image (Raster, rasterHeight, rasterSize, rasterWidth, standardDeviation)
import PraTactile.Registration.AllPairs.Pair
import PraTactile.Registration.Estimate
import PraTactile.Registration.Field
import PraTactile.Registration.Field.Pairs
import PraTactile.Registration.Model (eighth)
import PraTactile.Registration.Neighbours (OverlappingPair (..), neighbours)
import PraTactile.Registration.Numbers
  ( leastOverlap,
    mostPairs,
    mostSteps,
    outlier,
    pairsOfLayout,
  )
import PraTactile.Registration.Overlap
import PraTactile.Registration.Posterior
import PraTactile.Registration.Settings (Registration (..), supposedSigma)
import PraTactile.Registration.Spectrum (spectra)

-- | The registration of frames by their pairs.
data Pairwise = Pairwise
  { -- | The estimate of each frame, in their order. The displacements have mean 0, since a shift
    -- common to all is unobservable.
    pairwiseFrames :: [Estimate],
    -- | The standard deviation of the robot's position error, taxels; 'Nothing' without pairs.
    pairwiseSigma :: Maybe Double,
    -- | The process of the frames' relief.
    pairwiseRelief :: ReliefModel
  }

-- | Registers frames, given the nominal places (taxels) of their upper left pixels.
registerPairwise :: Registration -> [(Taxels, Raster)] -> Pairwise
registerPairwise settings frames = Pairwise (fst (centred estimates)) sigma relief
  where
    relief = reliefBy settings (map snd frames)
    pairs = map (pairOf settings relief (Boxed.map fst nominal)) (compared frames)
    nominal = Boxed.fromList (map (onGrid grid . fst) frames)
    beyond = map snd (Boxed.toList nominal)
    fields = pairwiseField grid beyond (pairReach settings) pairs
    told = fold (zipWith (momentsOf grid) beyond fields)
    sigma
      | null pairs = Nothing
      | otherwise = Just (likelySigma grid (squaresAbout told))
    grid = pairsGrid settings
    byGrid = [estimateAt grid r (onPoints grid field) | (r, field) <- zip beyond fields]
    places =
      leastSquares grid settings relief told nominal pairs $
        [ (likeliest grid r field, estimateProbability l)
          | (r, field, l) <- zip3 beyond fields byGrid
        ]
    estimates = zipWith estimated byGrid places
    -- The offset between grid points also applies to a frame's alternative displacements.
    estimated l place = moveBy ((eighth (fst place), eighth (snd place)) `minus` estimateShift l) l

-- | The relief process of frames of one size, given their noise in the settings.
reliefBy :: Registration -> [Raster] -> ReliefModel
reliefBy settings images = reliefOf (uncurry spectra size) least images
  where
    size = maximum ((1, 1) : map rasterSize images)
    least = noise / max 1e-9 (variance - noise)
    noise = registrationNoise settings * registrationNoise settings
    variance = sum deviations' / fromIntegral (max 1 (length deviations'))
    deviations' = [sd * sd | Just sd <- map standardDeviation images]

-- | The pairs to compare: those that share at least 'leastOverlap' of a frame, as diagonal pairs do
-- at steps of half a frame. Each frame chooses at most 'mostPairs' of its pairs, evenly spread.
compared :: [(Taxels, Raster)] -> [OverlappingPair]
compared frames = [pair | (n, pair) <- numbered, n `IntSet.member` chosen]
  where
    numbered = zip [0 ..] [pair | pair <- neighbours frames, neighboursShare pair >= leastOverlap]
    chosen = IntSet.fromList (concatMap (spacedOut mostPairs) (IntMap.elems ofEach))
    ofEach =
      IntMap.fromListWith
        (flip (++))
        [ (k, [n])
          | (n, OverlappingPair first second _ _) <- numbered,
            k <- [first, second]
        ]

-- | Log evidence of frames at their nominal places (taxels), relative to unrelated relief in each.
-- Some of the pairs stand for all:
--
-- > E = sum over pairs of log (delta + (1 - delta) * sum over e of pi(e) exp L(e))
--
-- Pairs less than two taxels apart are left out, since they do not depend on the layout.
pairsEvidence :: Registration -> ReliefModel -> [(Taxels, Raster)] -> Double
pairsEvidence settings relief frames = ofEach * sum (map likelier some)
  where
    pairs = [pair | pair <- compared frames, moved (neighboursStep pair)]
    some = spacedOut pairsOfLayout pairs
    ofEach = fromIntegral (length pairs) / fromIntegral (max 1 (length some))
    moved (x, y) = max (abs x) (abs y) >= 2
    likelier (OverlappingPair k l step _) =
      log (outlier + (1 - outlier) * mean (V.toList (overlapLogs relief (k, l) step grid)))
      where
        grid = displacementsAround step (max 1 (min 9 (2 * sigma)))
        mean logs = sum (zipWith (\p t -> p * exp (min 600 t)) priors logs) / sum priors
        priors =
          [ exp (priorAround (2 * sigma) ((fromIntegral x, fromIntegral y) `minus` step))
            | (x, y) <- allOf grid
          ]
    sigma = sqrt 2 * supposedSigma settings

-- | The number of pixels in which 'registerPairwise' compares frames, over all displacements of its
-- grid.
comparedPixels :: Registration -> [(Taxels, Raster)] -> Int
comparedPixels settings frames = sum (map pixels (compared frames))
  where
    pixels pair = displacements * ceiling (neighboursShare pair * fromIntegral area)
    area = maximum (1 : [rasterWidth image * rasterHeight image | (_, image) <- frames])
    displacements = (2 * pairReach settings + 1) ^ (2 :: Int)

-- | Refines displacements between grid points by least squares, from the nominal places ('onGrid'),
-- the pairs, and the likeliest grid points with their probabilities. A pair acts as a spring: it
-- pulls its frames to its highest L nearby, plus their offset there. Its weight is that offset's
-- precision times the probability that both frames are there and show one relief.
leastSquares ::
  Grid ->
  Registration ->
  ReliefModel ->
  ShiftMoments ->
  Boxed.Vector ((Int, Int), Taxels) ->
  [Pair] ->
  [(Taxels, Double)] ->
  [Taxels]
leastSquares grid settings relief told nominal pairs start = zip (solved fst) (solved snd)
  where
    places = Boxed.fromList (map fst start)
    probable = Boxed.fromList (map snd start)
    count = length start
    around = byFrame count (concatMap springs pairs)
    springs pair@(Pair k l _ _) =
      [ (l, (k, weight, e)),
        (k, (l, weight, (negate ex, negate ey)))
      ]
      where
        weight = (certain * wx, certain * wy)
        certain = one * probable Boxed.! k * probable Boxed.! l
        e@(ex, ey) = ((fromIntegral i, fromIntegral j) `plus` offset) `minus` beyond
        ((i, j), one) = highestNear settings pair (round x, round y)
        (offset, (wx, wy)) = between relief (k, l) (i + stepX, j + stepY)
        (stepX, stepY) = gridStep pointK pointL
        (x, y) = ((places Boxed.! l) `minus` (places Boxed.! k)) `plus` beyond
        beyond = beyondL `minus` beyondK
        ((pointK, beyondK), (pointL, beyondL)) = (nominal Boxed.! k, nominal Boxed.! l)
    -- Each frame in turn moves to the weighted mean of its pairs and the robot's prior.
    solved part =
      let from = IntMap.fromList (zip [0 ..] (map (part . fst) start))
       in IntMap.elems (iterate (sweep part) from !! mostSteps)
    sweep part now = foldl' (\at k -> IntMap.insert k (mean part at k) at) now [0 .. count - 1]
    mean part at k = along / weight
      where
        (weight, along) = foldl' add (robot, robot * part common) (around Boxed.! k)
        add (!w, !t) (l, ws, e) =
          let v = part ws in (w + v, t + v * (IntMap.findWithDefault 0 l at + part e))
    -- The expectation of 1 / sigma^2, inverse square taxels.
    robot = sum (zipWith weigh (sigmaShares grid (squaresAbout told)) (gridSigmas grid))
    weigh share sigma = share / (sigma * sigma)
    common = let ShiftMoments n x y _ = told in (x / n, y / n)
