-- | The methods to find where frames were: which, and what is told of each frame.
module PraTactile.Registration.Arrangement
  ( StitchMethod (..),
    Registered (..),
    Arrangement (..),
    arrange,
    TooMuch (..),
    maxComparisons,
    maxLatticePixels,
    withMisfit,
  )
where

import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (compositeOf)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Composite.Tilt (tilt)
import PraTactile.Image (Raster, rasterSize, rasterValues, standardDeviation)
import PraTactile.Registration.AllPairs (registerPairwise)
import PraTactile.Registration.Groups (groupsOf)
import PraTactile.Registration.Incremental (comparisons, register)
import PraTactile.Registration.Joint
import PraTactile.Registration.Lattice.Angle (latticeAngle)
import PraTactile.Registration.Lattice.Fit (Fits, bySize, fitsAt)
import PraTactile.Registration.Lattice.Glimpse
import PraTactile.Registration.Lattice.Template (PaperTables, paperTemplates)
import PraTactile.Registration.Posterior (Hypothesis)
import PraTactile.Registration.Residual (residual)
import PraTactile.Registration.Search (Registration (..))
import PraTactile.Registration.Spectrum (spectra)

-- | How frames are registered.
data StitchMethod
  = -- | incrementally; where the robot is known for an error above 1.25 taxels, or the sensor for
    -- noise above a quarter of full scale, by the lattice if the frames show it
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
    -- | The standard deviation of one frame from what others saw at the same place, grey values.
    arrangementResidual :: Maybe Double
  }

-- | The most pixels that frames are compared in for a first look at which of them tell most of
-- each other: those of each frame, once for each other that may come to overlap it. Thousands of
-- frames have fewer where they lie half a frame apart.
maxComparisons :: Int
maxComparisons = 536870912

-- | The most pixels of a frame that is held against the lattice.
maxLatticePixels :: Int
maxLatticePixels = 65536

-- | Why frames are not registered: it would take too much.
data TooMuch
  = -- | They would be compared in so many pixels, more than 'maxComparisons'.
    ComparedPixels !Int
  | -- | A frame has so many pixels, more than 'maxLatticePixels'.
    LatticePixels !Int
  deriving stock (Eq, Show)

-- | Find the displacements, given the nominal places (taxels) of the frames' upper left pixels.
arrange :: StitchMethod -> Registration -> [(Taxels, Raster)] -> Either TooMuch Arrangement
arrange method settings frames = case (method, paperTemplates) of
  (Nominal, _) -> Right (plain Nominal unmoved)
  _ | all (flat . snd) frames -> Right (plain Incremental unmoved)
  (Jointly, _) ->
    Right $
      arranged
        Jointly
        [ Registered d (Just (sd, sd)) Nothing []
          | (d, sd) <- registerPairwise settings (bySize sizes (uncurry spectra)) frames
        ]
  (ByLattice, Just tables)
    | largest > maxLatticePixels -> Left (LatticePixels largest)
    | otherwise -> Right (jointly (fromMaybe (at tables 0) (latticeOf tables)))
  (Automatic, Just tables)
    | length frames >= 2 && doubtful && largest <= maxLatticePixels,
      Just fits <- latticeOf tables ->
      Right (jointly fits)
  _
    | compared > maxComparisons -> Left (ComparedPixels compared)
    | otherwise -> Right (plain Incremental (register settings frames))
  where
    compared = comparisons settings frames
    largest = maximum (0 : map ((\(w, h) -> w * h) . rasterSize . snd) frames)
    unmoved = map (const ((0, 0), [])) frames
    flat image = V.all (== rasterValues image V.! 0) (rasterValues image)
    doubtful = registrationSigma settings > 1.25 || registrationNoise settings > 0.25
    sizes = map (rasterSize . snd) frames
    at tables = fitsAt tables (map snd frames)
    -- The frames held against the lattice, if they show it.
    latticeOf :: PaperTables -> Maybe Fits
    latticeOf tables = do
      size <- listToMaybe sizes
      latticeAngle
        (at tables)
        (uncurry spectra (glimpseSize size))
        (tilt (map compositeOf (spacedOut tiltFrames (map snd frames))))
        (map (glimpse . snd) frames)
    jointly :: Fits -> Arrangement
    jointly fits =
      arranged
        ByLattice
        [ Registered
            (estimateShift l)
            (Just (estimateDeviation l))
            (Just (estimateProbability l))
            (estimateOthers l)
          | l <- registerJointly settings fits frames
        ]
    plain used ds = arranged used [Registered d Nothing Nothing instead | (d, instead) <- ds]
    arranged used frameOf =
      Arrangement
        used
        (zipWith ($) frameOf (groupsOf places))
        (residual places)
      where
        places = moved frames [registeredShift (a 0) | a <- frameOf]

-- | The most frames that the angle at which symbols seem to lie is told from, before it is told by
-- the lattice: more would take memory for nothing.
tiltFrames :: Int
tiltFrames = 256

-- | Settings for frames of another pitch, brought to the canonical one: their noise has, beside the
-- sensor's, what two frames differ by because their pixels are interpolated: as variance, a share
-- of that of all the frames' relief (assumption). Noise that was averaged away would otherwise let
-- patches that hardly vary decide where a frame lies.
withMisfit :: [Raster] -> Registration -> Registration
withMisfit images settings = settings {registrationNoise = sqrt (noise * noise + misfit * relief)}
  where
    noise = registrationNoise settings
    relief = max 0 (average [sd * sd | Just sd <- map standardDeviation images] - noise * noise)
    misfit = 0.05
    average values = sum values / fromIntegral (max 1 (length values))

moved :: [(Taxels, Raster)] -> [Taxels] -> [(Taxels, Raster)]
moved = zipWith (\((x, y), image) (dx, dy) -> ((x + dx, y + dy), image))
