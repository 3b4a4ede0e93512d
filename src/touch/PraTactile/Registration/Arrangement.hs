{-# OPTIONS_HADDOCK hide #-}

-- | The methods of registration: choosing one, and the result for each frame.
module PraTactile.Registration.Arrangement
  ( StitchMethod (..),
    Registered (..),
    Arrangement (..),
    arrange,
    unarranged,
    TooMuch (..),
    maxComparisons,
    maxPairPixels,
    maxLatticePixels,
    withMisfit,
  )
where

import Control.Applicative ((<|>))
import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (AlternativeLayout, compositeOf)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Lattice (Lattice)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Composite.Skew (skews)
import PraTactile.Image (Raster, rasterSize, rasterValues, standardDeviation)
import PraTactile.Registration.AllPairs
import PraTactile.Registration.AlternativeLayouts
import PraTactile.Registration.Groups (groupsOf)
import PraTactile.Registration.Incremental (comparisons, register)
import PraTactile.Registration.Joint
import PraTactile.Registration.Lattice.Angle (latticeAngle)
import PraTactile.Registration.Lattice.Crop
import PraTactile.Registration.Lattice.Fit (Touched, fitsAt)
import PraTactile.Registration.Lattice.Template (LatticeTables)
import PraTactile.Registration.Levelling
import PraTactile.Registration.Numbers (interpolated)
import PraTactile.Registration.Posterior (Hypothesis)
import PraTactile.Registration.Residual (residual)
import PraTactile.Registration.Settings (Registration (..))
import PraTactile.Registration.Spectrum (spectra)

-- | How frames are registered.
data StitchMethod
  = -- | by the lattice if the frames show one, else by all overlapping pairs
    Automatic
  | -- | by the lattice of cells
    ByLattice
  | -- | by all overlapping pairs together, from what they show alone
    ByPairs
  | -- | frame by frame, by the paper's cross-correlation
    Incremental
  | -- | not at all
    Nominal
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The registration of one frame.
data Registered = Registered
  { -- | Its displacement from its nominal place, taxels right and down.
    registeredShift :: !Taxels,
    -- | Its standard deviations, taxels; 'Nothing' if the method has none.
    registeredDeviation :: !(Maybe Taxels),
    -- | The probability that it is within three quarters of a taxel of the truth; 'Nothing' if the
    -- method has none.
    registeredProbability :: !(Maybe Double),
    -- | Alternative displacements, at least two taxels away, the most probable first.
    registeredOthers :: [Hypothesis],
    -- | The group of frames that overlap one another, directly or through others, from 0 on.
    registeredGroup :: !Int
  }
  deriving stock (Eq, Show)

-- | The registration of all frames.
data Arrangement = Arrangement
  { arrangementMethod :: !StitchMethod,
    arrangementFrames :: ![Registered],
    -- | Each frame's rescaling to the common scale.
    arrangementLevels :: [Level],
    -- | The standard deviation of the robot's position error, taxels; 'Nothing' if the method has
    -- none.
    arrangementSigma :: Maybe Double,
    -- | The standard deviation of one frame from the others at the same place, grey values.
    arrangementResidual :: Maybe Double,
    -- | The lattice, in taxels from the origin of the places, if the method finds one.
    arrangementLattice :: Maybe Lattice,
    -- | Alternative layouts that the frames do not refute, with places as the frames have them. The
    -- list is empty without registration.
    arrangementAlternatives :: [AlternativeLayout]
  }

-- | The most pixels in which the incremental method may compare frames at first. The pixels of each
-- frame count once for every other that may overlap it. Thousands of frames at steps of half a
-- frame stay below.
maxComparisons :: Int
maxComparisons = 536870912

-- | The most pixels of a frame that is fitted to the lattice.
maxLatticePixels :: Int
maxLatticePixels = 65536

-- | The most pixels in which all pairs of frames may be compared, over all displacements: some
-- fifteen seconds of computing.
maxPairPixels :: Int
maxPairPixels = 4294967296

-- | Why frames are not registered: the cost.
data TooMuch
  = -- | The incremental method would compare this many pixels, more than 'maxComparisons'.
    ComparedPixels !Int
  | -- | All pairs would compare this many pixels, more than 'maxPairPixels'.
    PairPixels !Int
  | -- | A frame has this many pixels, more than 'maxLatticePixels'.
    LatticePixels !Int
  deriving stock (Eq, Show)

-- | Registers frames, given the nominal places (taxels) of their upper left pixels, and the origin
-- of these places in the robot's coordinates. A single frame stays where it is, and so do frames
-- that show nothing. The lattice is that of the symbols whose tables are given.
arrange ::
  LatticeTables ->
  StitchMethod ->
  Registration ->
  Taxels ->
  [(Taxels, Touched)] ->
  Either TooMuch Arrangement
arrange tables method settings robot touched
  | method == Nominal || length frames < 2 || all (flat . snd) frames =
    Right (unarranged method frames)
  | otherwise = case method of
    ByLattice | largest > maxLatticePixels -> Left (LatticePixels largest)
    ByLattice -> Right (byLattice (fromMaybe (fits 0) lattice))
    Automatic | largest <= maxLatticePixels, Just fits' <- lattice -> Right (byLattice fits')
    Incremental
      | compared > maxComparisons -> Left (ComparedPixels compared)
      | otherwise -> Right oneByOne
    _ | paired > maxPairPixels -> Left (PairPixels paired)
    _ -> Right byPairs
  where
    frames = map (fmap fst) touched
    compared = comparisons settings frames
    paired = comparedPixels settings frames
    largest = maximum (0 : map ((\(w, h) -> w * h) . rasterSize . snd) frames)
    flat image = V.all (== rasterValues image V.! 0) (rasterValues image)
    images = map snd frames
    sizes = map rasterSize images
    fits = fitsAt tables (map snd touched)
    -- The fits at the lattice's angle, if the frames show a lattice.
    lattice = do
      size <- listToMaybe sizes
      latticeAngle
        fits
        (uncurry spectra (cropSize size))
        (skews (map compositeOf (spacedOut skewFrames images)))
        (map variedCrop images)
    oneByOne =
      arranged frames Incremental (map (const unlevelled) frames) $
        [Registered d Nothing Nothing [] | d <- register settings frames]
    byPairs =
      ( arranged frames ByPairs (map (const unlevelled) frames) $
          map estimated (pairwiseFrames found)
      )
        { arrangementSigma = pairwiseSigma found,
          arrangementAlternatives =
            alternativesByPairs (knowing (pairwiseSigma found)) (pairwiseRelief found) robot frames
        }
      where
        found = registerPairwise settings frames
    byLattice fits' =
      (arranged frames ByLattice (jointLevels found) (map estimated (jointFrames found)))
        { arrangementSigma = jointSigma found,
          arrangementLattice = Just (jointLattice found),
          arrangementAlternatives = alternativesOnLattice settings fits' robot touched found
        }
      where
        found = registerJointly settings fits' touched
    knowing sigma = settings {registrationSigma = registrationSigma settings <|> sigma}
    estimated l =
      Registered
        (estimateShift l)
        (Just (estimateDeviation l))
        (Just (estimateProbability l))
        (estimateOthers l)

-- | Leaves frames at their nominal places.
unarranged :: StitchMethod -> [(Taxels, Raster)] -> Arrangement
unarranged method frames =
  arranged frames used (map (const unlevelled) frames) (map (const stays) frames)
  where
    used = if method == Automatic then ByPairs else method
    stays = Registered (0, 0) Nothing Nothing []

-- | An arrangement from the frames, the method used, their levels, and each frame's registration as
-- a function of its group.
arranged ::
  [(Taxels, Raster)] ->
  StitchMethod ->
  [Level] ->
  [Int -> Registered] ->
  Arrangement
arranged frames used levels frameOf =
  Arrangement
    { arrangementMethod = used,
      arrangementFrames = zipWith ($) frameOf (groupsOf places),
      arrangementLevels = levels,
      arrangementSigma = Nothing,
      arrangementResidual = residual places,
      arrangementLattice = Nothing,
      arrangementAlternatives = []
    }
  where
    places =
      moved
        [(place, levelled level image) | ((place, image), level) <- zip frames levels]
        [registeredShift (a 0) | a <- frameOf]

-- | At most this many frames give hints of the lattice's angle. More would only take memory.
skewFrames :: Int
skewFrames = 256

-- | Adds the error of interpolation to the noise, for frames brought to the canonical pitch from
-- another. Its variance is a share ('interpolated') of the variance of all the frames' relief.
-- Resampling averages the sensor's noise away. Without the addition, patches that hardly vary would
-- decide where a frame lies.
withMisfit :: [Raster] -> Registration -> Registration
withMisfit images settings =
  settings {registrationNoise = sqrt (noise * noise + interpolated * relief)}
  where
    noise = registrationNoise settings
    relief = max 0 (average [sd * sd | Just sd <- map standardDeviation images] - noise * noise)
    average values = sum values / fromIntegral (max 1 (length values))

moved :: [(Taxels, Raster)] -> [Taxels] -> [(Taxels, Raster)]
moved = zipWith (\((x, y), image) (dx, dy) -> ((x + dx, y + dy), image))
