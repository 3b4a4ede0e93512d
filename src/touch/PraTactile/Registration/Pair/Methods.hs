{-# OPTIONS_HADDOCK hide #-}

-- | The posterior of the place of the second frame's upper left pixel in the first, by each method.
-- Given are the nominal place and the search around it (taxels), which is two standard deviations
-- of the robot's error.
module PraTactile.Registration.Pair.Methods
  ( latticePosterior,
    blindPosterior,
    correlationPosterior,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster)
import PraTactile.Image.Correlate (Overlap (..), overlapAt, referenceOf)
import PraTactile.Probability (logSum)
import PraTactile.Registration.Correlation (logLikelihood)
import PraTactile.Registration.Field
import PraTactile.Registration.Joint.TwoFrames
import PraTactile.Registration.Lattice.Likelihood (Likelihood)
import PraTactile.Registration.Numbers (independent, placesPerTaxel)
import PraTactile.Registration.Overlap
import PraTactile.Registration.Posterior

-- | The posterior by the lattice under both frames.
latticePosterior :: Taxels -> Double -> Likelihood -> Likelihood -> GridPosterior
latticePosterior step search a b =
  posterior (from nx, from ny) (inTaxels grid 1) (side, side) $
    V.replicate (side * side) (-1 / 0)
      V.// [((dy + reach) * side + dx + reach, log p) | ((dx, dy), p) <- twoDisplacements found]
  where
    found = twoFrames grid ((0, 0), a) (step, b)
    grid = Grid placesPerTaxel reach [places * search / 2]
    places = fromIntegral placesPerTaxel
    reach = ceiling (places * search)
    side = 2 * reach + 1
    ((nx, ny), _) = onGrid grid step
    from n = inTaxels grid (fromIntegral (n - reach))

-- | The posterior by the overlap, whatever it shows: of one relief or of two.
blindPosterior :: ReliefModel -> Taxels -> Double -> GridPosterior
blindPosterior relief step search = overWhole step search $ \grid ->
  V.map (\l -> logSum [0, l]) (overlapLogs relief (0, 1) step grid)

-- | The posterior by the paper's zero-mean normalised cross-correlation ('logLikelihood'). Each
-- pixel counts for 'independent' pairs of values, because neighbouring pixels resemble each other.
-- An overlap counts no more than the nominal one.
correlationPosterior :: Taxels -> Double -> Raster -> Raster -> GridPosterior
correlationPosterior step search a b = overWhole step search $ \grid ->
  V.fromList
    [correlated (overlapAt there b (fromIntegral x) (fromIntegral y)) | (x, y) <- allOf grid]
  where
    there = referenceOf a
    most = overlapWeight (overlapAt there b (fst step) (snd step))
    correlated overlap =
      logLikelihood 0 overlap {overlapWeight = independent * min most (overlapWeight overlap)}

-- | The posterior over whole displacements, from their prior and the given log-likelihoods.
overWhole :: Taxels -> Double -> (Displacements -> V.Vector Double) -> GridPosterior
overWhole step search said =
  posterior (fromIntegral x0, fromIntegral y0) 1 size (V.zipWith (+) priors (said grid))
  where
    grid@(Displacements (x0, y0) size) = displacementsAround step search
    priors =
      V.fromList
        [ priorAround search (fromIntegral x - fst step, fromIntegral y - snd step)
          | (x, y) <- allOf grid
        ]
