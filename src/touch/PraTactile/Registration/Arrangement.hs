{-# OPTIONS_HADDOCK hide #-}

-- | The methods to find where frames were: which, and what is told of each frame.
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
import PraTactile.Composite (Otherwise, compositeOf)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Lattice (Lattice)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Composite.Tilt (tilts)
import PraTactile.Image (Raster, rasterSize, rasterValues, standardDeviation)
import PraTactile.Registration.AllPairs
import PraTactile.Registration.Groups (groupsOf)
import PraTactile.Registration.Incremental (comparisons, register)
import PraTactile.Registration.Joint
import PraTactile.Registration.Lattice.Angle (latticeAngle)
import PraTactile.Registration.Lattice.Fit (Touched, fitsAt)
import PraTactile.Registration.Lattice.Glimpse
import PraTactile.Registration.Lattice.Template (LatticeTables)
import PraTactile.Registration.Levelling
import PraTactile.Registration.Numbers (interpolated)
import PraTactile.Registration.Others
import PraTactile.Registration.Posterior (Hypothesis)
import PraTactile.Registration.Residual (residual)
import PraTactile.Registration.Settings (Registration (..))
import PraTactile.Registration.Spectrum (spectra)

-- | How frames are registered.
data StitchMethod
  = -- | by the lattice if the frames show it, else by all pairs that overlap
    Automatic
  | -- | by the lattice of cells
    ByLattice
  | -- | by all pairs that overlap, together, by what they show alone
    Jointly
  | -- | frame by frame, by the paper's cross-correlation
    Incremental
  | -- | not at all
    Nominal
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | What is told of a frame.
data Registered = Registered
  { -- | Its displacement from its nominal place, taxels right and down.
    registeredShift :: !Taxels,
    -- | Its standard deviations, taxels, where the method tells them.
    registeredDeviation :: !(Maybe Taxels),
    -- | The probability that it is within three quarters of a taxel of the truth, likewise.
    registeredProbability :: !(Maybe Double),
    -- | Displacements that it may have instead, at least two taxels away, the most probable first.
    registeredOthers :: [Hypothesis],
    -- | The group of frames that overlap one another, directly or through others, from 0 on.
    registeredGroup :: !Int
  }
  deriving stock (Eq, Show)

-- | Frames with their displacements.
data Arrangement = Arrangement
  { arrangementMethod :: !StitchMethod,
    arrangementFrames :: ![Registered],
    -- | What brings each frame to the scale of all.
    arrangementLevels :: [Level],
    -- | The standard deviation of the robot's position error, taxels, where the method tells it.
    arrangementSigma :: Maybe Double,
    -- | The standard deviation of one frame from what others saw at the same place, grey values.
    arrangementResidual :: Maybe Double,
    -- | The lattice, in taxels from the origin of the places, where the method finds one.
    arrangementLattice :: Maybe Lattice,
    -- | Alternative layouts that the frames do not refute; places count as the frames' do. None
    -- where nothing is registered.
    arrangementOthers :: [Otherwise]
  }

-- | The most pixels that frames are compared in for a first look at which of them tell most of
-- each other: those of each frame, once for each other that may come to overlap it. Thousands of
-- frames have fewer where they lie half a frame apart.
maxComparisons :: Int
maxComparisons = 536870912

-- | The most pixels of a frame that is held against the lattice.
maxLatticePixels :: Int
maxLatticePixels = 65536

-- | The most pixels that all pairs of frames are compared in, at all displacements that they may
-- have: some fifteen seconds of computing.
maxPairPixels :: Int
maxPairPixels = 4294967296

-- | Why frames are not registered: it would take too much.
data TooMuch
  = -- | They would be compared in so many pixels, more than 'maxComparisons'.
    ComparedPixels !Int
  | -- | Their pairs would be compared in so many pixels, more than 'maxPairPixels'.
    PairPixels !Int
  | -- | A frame has so many pixels, more than 'maxLatticePixels'.
    LatticePixels !Int
  deriving stock (Eq, Show)

-- | Find the displacements, given the nominal places (taxels) of the frames' upper left pixels, and
-- where these count from in the robot's coordinates.
-- Frames that show nothing, or of which there is one, stay where they are. The lattice is that of
-- the symbols whose tables are given.
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
    -- What the frames tell of the lattice, if they show it.
    lattice = do
      size <- listToMaybe sizes
      latticeAngle
        fits
        (uncurry spectra (glimpseSize size))
        (tilts (map compositeOf (spacedOut tiltFrames images)))
        (map glimpse images)
    oneByOne =
      arranged frames Incremental (map (const unlevelled) frames) $
        [Registered d Nothing Nothing [] | d <- register settings frames]
    byPairs =
      ( arranged frames Jointly (map (const unlevelled) frames) $
          map estimated (pairwiseFrames found)
      )
        { arrangementSigma = pairwiseSigma found,
          arrangementOthers =
            othersByPairs (knowing (pairwiseSigma found)) (pairwiseRelief found) robot frames
        }
      where
        found = registerPairwise settings frames
    byLattice fits' =
      (arranged frames ByLattice (jointLevels found) (map estimated (jointFrames found)))
        { arrangementSigma = jointSigma found,
          arrangementLattice = Just (jointLattice found),
          arrangementOthers = othersOnLattice settings fits' robot touched found
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

-- | The frames where they nominally are.
unarranged :: StitchMethod -> [(Taxels, Raster)] -> Arrangement
unarranged method frames =
  arranged frames used (map (const unlevelled) frames) (map (const stays) frames)
  where
    used = if method == Automatic then Jointly else method
    stays = Registered (0, 0) Nothing Nothing []

-- | Frames by the method used, their levelling, and what is told of each but its group.
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
      arrangementOthers = []
    }
  where
    places =
      moved
        [(place, levelled level image) | ((place, image), level) <- zip frames levels]
        [registeredShift (a 0) | a <- frameOf]

-- | The most frames that the angle at which symbols seem to lie is told from, before it is told by
-- the lattice: more would take memory for nothing.
tiltFrames :: Int
tiltFrames = 256

-- | Settings for frames of another pitch, brought to the canonical one: their noise has, beside the
-- sensor's, what two frames differ by because their pixels are interpolated: as variance, a share
-- of that of all the frames' relief. Noise that was averaged away would otherwise let
-- patches that hardly vary decide where a frame lies.
withMisfit :: [Raster] -> Registration -> Registration
withMisfit images settings =
  settings {registrationNoise = sqrt (noise * noise + interpolated * relief)}
  where
    noise = registrationNoise settings
    relief = max 0 (average [sd * sd | Just sd <- map standardDeviation images] - noise * noise)
    average values = sum values / fromIntegral (max 1 (length values))

moved :: [(Taxels, Raster)] -> [Taxels] -> [(Taxels, Raster)]
moved = zipWith (\((x, y), image) (dx, dy) -> ((x + dx, y + dy), image))
