{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Registers many frames on one lattice of cells. All frames together determine where the lattice
-- lies. Each frame's displacement follows from the lattice, and from the symbols that other frames
-- show in its cells. The array is not known here.
--
-- The cost is linear in the frames. At most @phaseFrames@ of them determine the lattice's phase,
-- and each frame keeps only its likely displacements.
module PraTactile.Registration.Joint
  ( Estimate (..),
    Joint (..),
    registerJointly,
  )
where

import PraTactile.Composite.Blend (Taxels, minus, plus)
import PraTactile.Composite.Lattice (Lattice (..))
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Geometry (cosineSine, rotated)
import PraTactile.Image (rasterHeight, rasterSize, rasterWidth)
import PraTactile.Probability (logSum)
import PraTactile.Registration.Estimate
import PraTactile.Registration.Field
import PraTactile.Registration.Field.Cells
  ( MeanField (..),
    Told,
    cellsAlone,
    cellsTold,
    fieldBound,
    fieldSquares,
    fieldTold,
    meanField,
  )
import PraTactile.Registration.Joint.Displacement
  ( Displacement (..),
    cellsOfPhases,
    displacementsOf,
  )
import PraTactile.Registration.Joint.Phase (CommonPhase (..), commonPhase, quickPhaseLog)
import PraTactile.Registration.Joint.TwoFrames
import PraTactile.Registration.Lattice.Fit
import PraTactile.Registration.Lattice.Likelihood (likelihoodTheta)
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Levelling
import PraTactile.Registration.Numbers (keptPixels, outlier, phaseFrames, placesPerTaxel)
import PraTactile.Registration.Posterior (Hypothesis (..))
import PraTactile.Registration.Settings (Registration (..))

-- | Frames on one lattice. Fields are computed on first use.
data Joint = Joint
  { -- | The estimate of each frame, in their order. The displacements have mean 0, since a shift
    -- common to all is unobservable.
    jointFrames :: [Estimate],
    -- | The standard deviation of the robot's position error, taxels; 'Nothing' for a single frame.
    jointSigma :: Maybe Double,
    -- | A quick log P of the lattice, by phases alone, up to a constant that does not depend on the
    -- places.
    jointQuickLog :: Double,
    -- | F: a lower bound of log P of what all frames show, up to a constant that does not depend on
    -- the places.
    jointBound :: Double,
    -- | E, the log evidence of the nominal places.
    jointEvidence :: Double,
    -- | E_0, the log evidence that each frame lies anywhere.
    jointAnywhere :: Double,
    -- | Each frame's rescaling to the common scale.
    jointLevels :: [Level],
    -- | Each frame's displacements, with their probabilities.
    jointField :: MeanField,
    -- | Each frame's contribution to its cells.
    jointTold :: [Told],
    -- | The lattice where the frames are found, in taxels from the origin of their places.
    jointLattice :: Lattice
  }

-- | Registers frames, given the nominal places (taxels) of their upper left pixels, and their fits
-- at the lattice's angle.
registerJointly :: Registration -> Fits -> [(Taxels, Touched)] -> Joint
registerJointly settings fits frames =
  Joint
    { jointFrames = centredEstimates,
      jointSigma = sigma,
      jointQuickLog = quickPhaseLog grid phases,
      jointBound = bound,
      jointEvidence =
        bound - log (commonShare common) - log (2 * phasesOfOne)
          - fromIntegral (length onLattice) * log (2 * pi)
          - log (fromIntegral (length (gridSigmas grid))),
      jointAnywhere = logSum [sum (map fst alone), sum (map snd alone)] - log 2,
      jointLevels = levellingFrames levels,
      jointField = field,
      jointTold = told',
      jointLattice =
        Lattice
          { latticeAngle = angle,
            latticeHalfTurned = commonOrientation common == 1,
            latticeOrigin = rotated angle (taxelsOf (commonRowColumn common)) `minus` middleShift,
            latticeFlat = levellingFlat levels,
            latticeContrast = levellingContrast levels,
            latticeFrames =
              [ place `plus` middle image `plus` estimateShift l
                | ((place, (image, _)), l) <- zip frames centredEstimates
              ],
            latticeCells = cellsTold told'
          }
    }
  where
    bound = fieldBound grid field told'
    told' = fieldTold field
    levels = levelling (zip (map snd frames) thetas)
    middle image = (half (rasterWidth image), half (rasterHeight image))
    half side = fromIntegral (side - 1) / 2
    taxelsOf (row, column) =
      (inTaxels grid (fromIntegral column), inTaxels grid (fromIntegral row))
    alone = map anywhere onLattice
    (across, down) = phaseCount placesPerTaxel
    phasesOfOne = fromIntegral (across * down)
    -- The log-likelihood of a frame by orientation, if its phase is unknown.
    anywhere (_, _, fitted) = (max least upright, max least upsideDown)
      where
        (upright, upsideDown) = both share (cellsOfPhases (fitSome fitted))
        both f (a, b) = (f a, f b)
        share there
          | null there = -1e300
          | otherwise = logSum (map cellsAlone there) - log phasesOfOne
        least = max upright upsideDown + log outlier
    angle = fitsAngle fits
    onLattice =
      [ (firstPlace (tablesOf seen) (rotated (negate angle) place), seen, fitted)
        | ((place, seen), fitted) <- zip frames (fitsFrames fits)
      ]
    grid = latticeGrid settings
    -- Fits of a few small frames are kept; of many or large frames they would take too much memory.
    kept (place, _, fitted) = (place, fitted)
    again (place, seen, _) = (place, fitOf (tablesOf seen) seen)
    tablesOf = fitsTables fits . rasterSize . fst
    some = spacedOut phaseFrames onLattice
    small = sum (map pixelsOf some) <= phaseFrames * keptPixels
    pixelsOf (_, (image, _), _) = rasterWidth image * rasterHeight image
    phases = map (fmap fitSome . if small then kept else again) some
    common = commonPhase grid phases (twoPhase <$> two)
    -- For two frames all phases are summed.
    two = case map kept onLattice of
      [first, second] -> Just (twoFrames (apart grid) (fmap fitSome first) (fmap fitSome second))
      _ -> Nothing
    -- Sigma of the difference of two independent errors.
    apart known = known {gridSigmas = map (sqrt 2 *) (gridSigmas known)}
    (thetas, displacements) =
      unzip (map (told . (if few then kept else again)) onLattice)
    few = small && length onLattice <= phaseFrames
    told (place, fitted) =
      let !theta = likelihoodTheta (fitSome fitted)
          displacements' =
            displacementsOf grid (commonOrientation common) (commonRowColumn common) . (,) place
       in ( theta,
            -- The frame contradicts the others, so all its phases are evaluated.
            case displacements' (fitSome fitted) of
              [] -> displacements' (fitLikelihood fitted)
              some' -> some'
          )
    field = meanField grid displacements
    sigma
      | length onLattice < 2 = Nothing
      | otherwise = Just (likelySigma grid (fieldSquares field))
    (centredEstimates, middleShift) = centred . map (turnedTo angle) $ case (two, rests) of
      (Just found, [(x, y), (x', y')]) ->
        halvesOf (estimateAt grid (x' - x, y' - y) (twoDisplacements found))
      _ -> zipWith (estimateAt grid) rests (map shifts (fieldFrames field))
    rests = [snd (onGrid grid place) | (place, _, _) <- onLattice]
    shifts weights = [(displacementShift o, p) | (o, p) <- weights]

-- | Splits the second of two frames' displacement against the first: each takes half of it, from
-- their middle. The uncertainty stays that of the difference.
halvesOf :: Estimate -> [Estimate]
halvesOf found = [half (-1), half 1]
  where
    half sign =
      found
        { estimateShift = times sign (estimateShift found),
          estimateOthers =
            [ h {hypothesisShift = times sign (hypothesisShift h)} | h <- estimateOthers found
            ],
          estimateElsewhere = []
        }
    times sign (x, y) = (sign * x / 2, sign * y / 2) :: Taxels

-- | Turns an estimate from the lattice's axes to the frames', given the lattice's angle in degrees.
turnedTo :: Double -> Estimate -> Estimate
turnedTo 0 l = l
turnedTo angle l =
  l
    { estimateShift = rotated angle (estimateShift l),
      estimateDeviation = (along c s, along s c),
      estimateOthers =
        [h {hypothesisShift = rotated angle (hypothesisShift h)} | h <- estimateOthers l]
    }
  where
    (c, s) = cosineSine angle
    (sx, sy) = estimateDeviation l
    along i j = sqrt (i * i * sx * sx + j * j * sy * sy)

-- | The place of the first of a frame's places, from that of its upper left pixel.
firstPlace :: LatticeTemplates -> Taxels -> Taxels
firstPlace tables (x, y) = (x + fromIntegral i, y + fromIntegral j)
  where
    (i, j) = placesFirst (templatePlaces tables)
