{-# OPTIONS_HADDOCK hide #-}

-- | Fits how a frame reads relief, and with it the likelihood of the lattice under it. It goes from
-- coarse to fine by the steps of "PraTactile.Registration.Lattice.Likelihood".
--
-- The steps begin with the v of white noise, and with a and b as they are usual of symbols: v,
-- within 0.001 to 0.95, is a quarter of the mean square of
-- z(x, y) - z(x + 1, y) - z(x, y + 1) + z(x + 1, y + 1), a = root (max 0.02 (1 - v)) / 0.36, and
-- b = - 0.15 a.
--
-- Four steps use whole taxels: the first all phases, the others those within e^30 of the best. One
-- more step uses half taxels, and the phases less than a taxel from one that is still likely. Other
-- phases are evaluated only if all of these put the frame beyond the robot's error.
module PraTactile.Registration.Lattice.Fit
  ( Fit (..),
    fitOf,
    likelihood,
    Touched,
    whole,
    standardOf,

    -- * Many frames at one angle
    Fits (..),
    fitsAt,
    bySize,
  )
where

import qualified Data.IntSet as IntSet
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Vector.Storable as V
import PraTactile.Image
  ( Raster,
    mapRaster,
    rasterHeight,
    rasterSize,
    rasterValues,
    rasterWidth,
    zipRaster,
  )
import PraTactile.Registration.Lattice.Blur (areaSumsGiven)
import PraTactile.Registration.Lattice.Crop
import PraTactile.Registration.Lattice.Likelihood
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Model
import PraTactile.Registration.Numbers (negligible)

-- | The fit of a frame. Fields are computed on first use.
data Fit = Fit
  { -- | log p(z) at whole taxels, over the phases that are likely after the first step.
    fitCoarse :: Double,
    -- | log p(z) at all places, over the phases that are likely at whole taxels.
    fitLikely :: Double,
    -- | The likelihood of these phases.
    fitSome :: Likelihood,
    -- | The likelihood of all phases.
    fitLikelihood :: Likelihood,
    -- | The frame's total weight as a share of its taxels.
    fitShare :: !Double
  }

-- | The likelihood of a frame of the tables' size, over all phases. A frame without variation is
-- next to uninformative.
likelihood :: LatticeTemplates -> Touched -> Likelihood
likelihood tables = fitLikelihood . fitOf tables

-- | A frame and the weights of its taxels, 0 to 1; 'Nothing' for weights of 1.
type Touched = (Raster, Maybe Raster)

-- | A frame whose taxels all have weight 1.
whole :: Raster -> Touched
whole image = (image, Nothing)

-- | Fits theta by four steps at whole taxels, all but the first for likely phases only. One step at
-- all places follows, for the phases around those that are likely by that theta.
fitOf :: LatticeTemplates -> Touched -> Fit
fitOf tables (image, shares) =
  Fit
    (logDensity coarse)
    (logDensity fine)
    fine
    (eStep (allPhases tables felt) (likelihoodTheta fine))
    (n / fromIntegral (V.length values))
  where
    values = rasterValues image
    (n, average, deviation) = standardOf (image, shares)
    feltAt given places =
      FrameSums
        ( areaSumsGiven
            (sumsReadings <$> given)
            places
            (maybe id (orElse . zipRaster (*)) shares standard)
        )
        (areaSumsGiven (given >>= sumsWeights) places <$> shares)
        n
    orElse f = either (const standard) id . f
    standard = mapRaster (\v -> if deviation > 1e-9 then (v - average) / deviation else 0) image
    step statistics = mStep statistics . eStep statistics
    -- At whole taxels.
    atWhole = feltAt Nothing (templatePlaces (coarser tables))
    coarseAll = allPhases (coarser tables) atWhole
    first = eStep coarseAll (firstTheta standard)
    coarseLikely = atPhases coarseAll (likelyPhases first)
    coarse =
      eStep coarseLikely (iterate (step coarseLikely) (mStep coarseAll first) !! 3)
    -- At all places.
    felt = feltAt (Just atWhole) (templatePlaces tables)
    fineLikely =
      somePhases tables felt (finePhases (coarser tables) tables (likelyPhases coarsely))
    coarsely = eStep coarseAll (likelihoodTheta coarse)
    fine = eStep fineLikely (step fineLikely (likelihoodTheta coarse))

-- | N, the total weight, and the mean and the standard deviation of the readings by weight.
standardOf :: Touched -> (Double, Double, Double)
standardOf (image, shares) = (n, average, deviation)
  where
    values = rasterValues image
    n = maybe (fromIntegral (V.length values)) (max 1e-6 . V.sum . rasterValues) shares
    average = V.sum (counted values) / n
    deviation = sqrt (V.sum (counted (V.map (\v -> (v - average) * (v - average)) values)) / n)
    counted = maybe id (V.zipWith (*) . rasterValues) shares

-- | The phases within 'negligible' of the best.
likelyPhases :: Likelihood -> [Int]
likelyPhases given = V.toList (V.findIndices (> V.maximum phases - negligible) phases)
  where
    phases = phaseLogs given

-- | The phases of finer tables that are less than a taxel from the given phases of coarser ones.
finePhases :: LatticeTemplates -> LatticeTemplates -> [Int] -> [Int]
finePhases coarse fine = IntSet.toList . IntSet.fromList . concatMap around
  where
    places = placesFineness . templatePlaces
    q = places fine `quot` places coarse
    (acrossCoarse, downCoarse) = phaseCount (places coarse)
    (across, down) = phaseCount (places fine)
    around phase =
      let (row, x) = phase `quotRem` acrossCoarse
          (o, y) = row `quotRem` downCoarse
       in [ (o * down + (q * y + j) `mod` down) * across + (q * x + i) `mod` across
            | j <- [1 - q .. q - 1],
              i <- [1 - q .. q - 1]
          ]

-- | Starting point of EM. The noise comes from the second differences, in which smooth relief has
-- next to no part. The gain and the offset are usual for symbols.
firstTheta :: Raster -> Theta
firstTheta image = Theta gain (-0.15 * gain) noise
  where
    w = rasterWidth image
    h = rasterHeight image
    v = rasterValues image
    at y x = V.unsafeIndex v (y * w + x)
    differences =
      [ let d = at y x - at y (x + 1) - at (y + 1) x + at (y + 1) (x + 1) in d * d
        | y <- [0 .. h - 2],
          x <- [0 .. w - 2]
      ]
    noise
      | null differences = 0.5
      | otherwise = max 1e-3 (min 0.95 (sum differences / (4 * fromIntegral (length differences))))
    gain = sqrt (max 0.02 (1 - noise)) / 0.36

-- | Fits of frames to the lattice at an angle. Each table and each fit is computed once, on first
-- use.
data Fits = Fits
  { -- | Degrees clockwise from the frames' axes.
    fitsAngle :: !Double,
    -- | The templates by the width and height of frames.
    fitsTables :: (Int, Int) -> LatticeTemplates,
    -- | In the order of the frames.
    fitsFrames :: [Fit]
  }

-- | Fits frames of any sizes at an angle, degrees clockwise. 'fitCoarse' and 'fitLikely', which
-- determine the angle, belong to the crop of each frame.
fitsAt :: LatticeTables -> [Touched] -> Double -> Fits
fitsAt tables images angle = Fits angle at (map fit images)
  where
    at = bySize (sizes ++ map cropSize sizes) (tablesAt tables angle)
    sizes = map (rasterSize . fst) images
    fit seen@(image, _)
      | cropSize (rasterSize image) == rasterSize image = all'
      | otherwise =
        (fitted (whole (variedCrop image)))
          { fitSome = fitSome all',
            fitLikelihood = fitLikelihood all'
          }
      where
        all' = fitted seen
    fitted seen = fitOf (at (rasterSize (fst seen))) seen

-- | Tables by size; those of the given sizes are computed once.
bySize :: [(Int, Int)] -> ((Int, Int) -> tables) -> (Int, Int) -> tables
bySize sizes make = \size -> Map.findWithDefault (make size) size made
  where
    made = Map.fromSet make (Set.fromList sizes)
